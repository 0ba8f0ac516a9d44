"""Functions of time, enclosed: a polynomial and a remainder in relative form.

A tube over 0 <= t <= h is  p(t) + t^(N+1) R  with a polynomial p of degree N, whose coefficients are balls,
and a ball R: it holds every function p(t) + t^(N+1) rho(t) with coefficients in the balls and rho(t) in R.
The remainder is multiplied by t^(N+1), so that it may be large where the step is short, and a solution's
tube starts at its initial set whatever R is.
"""

from typing import Any

from flint import arb, arb_poly


class Span:
    """Degree N and reach in time that the tubes of one step have in common."""

    __slots__ = ("degree", "reach", "time", "time_power")

    def __init__(self, degree: int, reach: arb) -> None:
        """Tubes of this degree over [0, reach]."""
        self.degree, self.reach = degree, reach
        self.time = arb(0).union(reach)
        self.time_power = self.time ** (degree + 1)


class Tube:
    """A function of time on a span."""

    __slots__ = ("_range", "polynomial", "remainder", "span")

    def __init__(self, span: Span, polynomial: arb_poly, remainder: arb) -> None:
        """The polynomial, and the remainder in units of t^(N+1)."""
        self.span, self.polynomial, self.remainder = span, polynomial, remainder
        self._range: arb | None = None

    @property
    def range(self) -> arb:
        """All values of the polynomial over the span."""
        if self._range is None:
            self._range = self.polynomial(self.span.time)
        return self._range

    def at(self, time: arb) -> arb:
        """The value at a time, or at any of a ball of times, within the span."""
        value: arb = self.polynomial(time) + time ** (self.span.degree + 1) * self.remainder
        return value

    def __neg__(self) -> "Tube":
        """Its opposite."""
        return Tube(self.span, -self.polynomial, -self.remainder)

    def __add__(self, other: Any) -> "Tube":
        """The sum with a tube or a number."""
        if isinstance(other, Tube):
            return Tube(self.span, self.polynomial + other.polynomial, self.remainder + other.remainder)
        if isinstance(other, arb | int):
            return Tube(self.span, self.polynomial + other, self.remainder)
        return NotImplemented

    __radd__ = __add__

    def __sub__(self, other: Any) -> "Tube":
        """The difference."""
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> "Tube":
        """The difference."""
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> "Tube":
        """The product: what exceeds the degree goes into the remainder."""
        if isinstance(other, arb | int):
            return Tube(self.span, self.polynomial * other, self.remainder * other)
        if not isinstance(other, Tube):
            return NotImplemented
        span = self.span
        whole = self.polynomial * other.polynomial
        terms = span.degree + 1
        remainder = whole.right_shift(terms)(span.time) if whole.length() > terms else arb(0)
        if not other.remainder.is_zero():
            remainder += self.range * other.remainder
        if not self.remainder.is_zero():
            remainder += self.remainder * other.range + span.time_power * self.remainder * other.remainder
        return Tube(span, whole.truncate(terms), remainder)

    __rmul__ = __mul__

    def inverse(self) -> "Tube":
        """One over it: with v w = 1, w = q + t^(N+1) S where v S = -(what p q has beyond 1) - R q."""
        span, terms = self.span, self.span.degree + 1
        inverted = inverse_series(self.polynomial, terms)
        beyond = (self.polynomial * inverted).right_shift(terms)(span.time)
        values = self.range + span.time_power * self.remainder
        return Tube(span, inverted, -(beyond + self.remainder * inverted(span.time)) / values)

    def __rtruediv__(self, other: Any) -> "Tube":
        """A number over it."""
        return self.inverse().__mul__(other)

    def __truediv__(self, other: Any) -> "Tube":
        """The quotient."""
        return self * (other.inverse() if isinstance(other, Tube) else 1 / arb(other))


def inverse_series(polynomial: arb_poly, terms: int) -> arb_poly:
    """One over a polynomial, as a series that is cut off."""
    inverted, right = arb_poly([1 / polynomial[0]]), 1
    while right < terms:
        right = min(2 * right, terms)
        inverted = (inverted * (2 - (polynomial.truncate(right) * inverted).truncate(right))).truncate(right)
    return inverted
