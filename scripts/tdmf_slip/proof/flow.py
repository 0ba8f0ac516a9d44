"""One step of the motion in a mode: tubes of all that moves.

A tube encloses a function of time by a polynomial and a remainder. Over 0 <= t <= h it is p(t) + t^(N+1) R,
with a polynomial p of degree N, whose coefficients are balls, and a ball R. It holds every function
p(t) + t^(N+1) rho(t) with coefficients in the balls and rho(t) in R. Because t^(N+1) multiplies the
remainder, R may be large where the step is short. A solution's tube starts at its initial set whatever R is.

Taylor coefficients of a solution come one order after the other. The laws are evaluated once over `Series`,
which makes a graph of sums, products and quotients. Each node then gives its next coefficient from those
before.

The remainder is enclosed by Picard inclusion in its relative form. Let x = p + t^(N+1) rho with rho in R, and
let the rates be f = f_0 + ... + f_N t^N + t^(N+1) S. Then the solution's rho is in
f_N/(N+1) + [0, h] S/(N+2), and R holds it as soon as that lies in R. No enclosure of the step is needed
beforehand.
"""

from collections.abc import Callable, Mapping
from operator import mul
from typing import Any

from flint import arb, arb_poly, ctx

from .dual import Arithmetic, UndecidedError
from .parameters import Mode, at, kept_names, moving_names, names_of

ZERO = arb(0)


class Span:
    """Degree N and reach in time that the tubes of one step have in common."""

    __slots__ = ("degree", "reach", "time", "time_power")

    def __init__(self, degree: int, reach: arb) -> None:
        """Tubes of this degree over [0, reach]."""
        self.degree, self.reach = degree, reach
        self.time = arb(0).union(reach)
        self.time_power = self.time ** (degree + 1)


class Tube(Arithmetic):
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

    def __add__(self, other: Any) -> Any:
        """The sum with a tube or a number."""
        if isinstance(other, Tube):
            return Tube(self.span, self.polynomial + other.polynomial, self.remainder + other.remainder)
        if isinstance(other, arb | int):
            return self if other == 0 else Tube(self.span, self.polynomial + other, self.remainder)
        return NotImplemented

    def __mul__(self, other: Any) -> Any:
        """The product: what exceeds the degree goes into the remainder."""
        if isinstance(other, arb | int):
            return ZERO if other == 0 else Tube(self.span, self.polynomial * other, self.remainder * other)
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

    def inverse(self) -> "Tube":
        """One over it: with v w = 1, w = q + t^(N+1) S where v S = -(what p q has beyond 1) - R q."""
        span, terms = self.span, self.span.degree + 1
        inverted = inverse_series(self.polynomial, terms)
        beyond = (self.polynomial * inverted).right_shift(terms)(span.time)
        values = self.range + span.time_power * self.remainder
        return Tube(span, inverted, -(beyond + self.remainder * inverted(span.time)) / values)


def inverse_series(polynomial: arb_poly, terms: int) -> arb_poly:
    """One over a polynomial, as a series that is cut off."""
    inverted, right = arb_poly([1 / polynomial[0]]), 1
    while right < terms:
        right = min(2 * right, terms)
        inverted = (inverted * (2 - (polynomial.truncate(right) * inverted).truncate(right))).truncate(right)
    return inverted


class Series(Arithmetic):
    """A power series of a graph, whose coefficients are computed order by order."""

    __slots__ = ("graph", "next", "terms")

    def __init__(self, graph: list["Series"], following: Callable[[int], arb]) -> None:
        """The graph, in the order of computation, and how the k-th coefficient follows."""
        self.graph, self.next, self.terms = graph, following, list[arb]()
        graph.append(self)

    def __add__(self, other: Any) -> Any:
        """The sum with a series or a number."""
        a = self.terms
        if isinstance(other, Series):
            b = other.terms
            return Series(self.graph, lambda k: a[k] + b[k])
        if isinstance(other, arb | int):
            return self if other == 0 else Series(self.graph, lambda k: a[k] if k else a[0] + other)
        return NotImplemented

    def __mul__(self, other: Any) -> Any:
        """The product."""
        a = self.terms
        if isinstance(other, Series):
            b = other.terms
            return Series(self.graph, lambda k: sum(map(mul, a, b[k::-1]), ZERO))
        if isinstance(other, arb | int):
            return ZERO if other == 0 else Series(self.graph, lambda k: a[k] * other)
        return NotImplemented

    def inverse(self) -> Any:
        """One over it; w_k follows from v w = 1."""
        a = self.terms

        def following(k: int) -> arb:
            w = inverse.terms
            return -w[0] * sum(map(mul, a[1:], w[::-1]), ZERO) if k else 1 / a[0]

        inverse = Series(self.graph, following)
        return inverse


Rates = Callable[[Mapping[str, Any]], Mapping[str, Any]]
"""Function from states by name to their rates, over any kind of number."""


def coefficients(
    start: Mapping[str, arb], constant: Mapping[str, arb], rates: Rates, degree: int
) -> dict[str, list[arb]]:
    """Taylor coefficients of a solution in time: x_(k+1) = f_k / (k + 1)."""
    graph: list[Series] = []
    states = {name: Series(graph, lambda k: ZERO) for name in start}
    graph.clear()
    found = rates({**states, **constant})
    for name, state in states.items():
        state.terms.append(start[name])
    for k in range(degree):
        for node in graph:
            node.terms.append(node.next(k))
        for name, state in states.items():
            rate = found[name]
            own = rate.terms[k] if isinstance(rate, Series) else ZERO if k else arb(rate)
            state.terms.append(own / (k + 1))
    return {name: state.terms for name, state in states.items()}


INCLUSIONS = 8
"""Number of attempts to enclose a remainder, each with a wider ball."""
WIDENED = 2
HELPERS = ("sine", "cosine", "decay")
"""Functions of the motion's numbers that are carried along with them."""
Values = dict[str, arb]


def with_direction(runner: Any, values: Mapping[str, Any]) -> dict[str, Any]:
    """The numbers of a motion with the leg's sine and cosine over the ground."""
    angle = values["angle"] - runner.slope
    return {**values, "sine": angle.sin(), "cosine": angle.cos()}


def fades(runner: Any, mode: Mode) -> bool:
    """True if friction changes with the foot's speed in a mode."""
    return bool(mode.contact == "slip" and runner.falls_with_speed)


def with_helpers(runner: Any, mode: Mode, values: Mapping[str, Any]) -> dict[str, Any]:
    """All that the rates ask for beside the numbers of a motion: see `laws`."""
    whole = with_direction(runner, values)
    if fades(runner, mode):
        whole["decay"] = (at(runner, mode, {}).fading_rate() * values["foot_vx"]).exp()
    return whole


def rates(runner: Any, mode: Mode, values: Mapping[str, Any]) -> dict[str, Any]:
    """Time derivatives of what moves in a mode, with those of its helpers."""
    motion = at(runner, mode, values)
    found: dict[str, Any] = getattr(motion, mode.contact)()
    return found


def speeds(runner: Any, mode: Mode, values: Values) -> Values:
    """Time derivatives of all numbers that describe the motion in a mode, at an instant."""
    found = rates(runner, mode, with_helpers(runner, mode, values))
    if mode.contact == "flight":
        fall = runner.fall()
        found |= {"clearance": values["off"], "along": fall.along, "off": fall.off}
    return {name: arb(found.get(name, 0)) for name in names_of(runner, mode)}


class Flow:
    """A step: what moves in it as tubes, over times from 0 to its reach."""

    def __init__(
        self, runner: Any, mode: Mode, start: Values, degree: int, maximum: arb | None = None
    ) -> None:
        """Solve from a set of starts."""
        self.runner, self.mode, self.names = runner, mode, names_of(runner, mode)
        self.start, self.degree = start, degree
        whole = with_helpers(runner, mode, start)
        self.kept = {name: start[name] for name in kept_names(runner, mode)}
        moving = (*moving_names(runner, mode), *(name for name in HELPERS if name in whole))
        begin = {name: whole[name] for name in moving}
        terms = coefficients(begin, self.kept, lambda z: rates(runner, mode, z), degree)
        if not all(term.is_finite() for row in terms.values() for term in row):
            raise UndecidedError(f"the motion in {mode.contact}")
        reach = longest(runner, terms)
        reach = reach if maximum is None or reach < maximum else maximum
        polynomials = {name: arb_poly(row) for name, row in terms.items()}
        for _ in range(INCLUSIONS):
            self.span = Span(degree, reach)
            remainders = self._enclosed(polynomials)
            if remainders is not None:
                break
            reach = (reach * arb("0.6")).mid()
        else:
            raise UndecidedError(f"the motion in {mode.contact}")
        self.tubes = {name: Tube(self.span, p, remainders[name]) for name, p in polynomials.items()}
        if mode.contact == "flight":
            self._add_ballistic()

    @property
    def reach(self) -> arb:
        """Length of the step."""
        return self.span.reach

    def _enclosed(self, polynomials: dict[str, arb_poly]) -> dict[str, arb] | None:
        """Remainders that hold those of every solution; None where none were found."""
        step, degree = self.span.time, self.degree

        def inclusion(remainders: dict[str, arb]) -> dict[str, arb]:
            tubes = {name: Tube(self.span, p, remainders[name]) for name, p in polynomials.items()}
            found = rates(self.runner, self.mode, tubes | self.kept)
            return {
                name: rate.polynomial[degree] / (degree + 1) + step * rate.remainder / (degree + 2)
                if isinstance(rate := found[name], Tube)
                else arb(0)
                for name in polynomials
            }

        tried = {n: widened(r) for n, r in inclusion(dict.fromkeys(polynomials, arb(0))).items()}
        for _ in range(INCLUSIONS):
            remainders = inclusion(tried)
            if not all(remainder.is_finite() for remainder in remainders.values()):
                return None
            open_ones = [name for name in polynomials if not tried[name].contains(remainders[name])]
            if not open_ones:
                return remainders
            tried |= {name: widened(remainders[name].union(tried[name])) for name in open_ones}
        return None

    def _add_ballistic(self) -> None:
        fall, start, zero = self.runner.fall(), self.start, arb(0)
        rows = {
            "clearance": [start["clearance"], start["off"], fall.off / 2],
            "along": [start["along"], fall.along],
            "off": [start["off"], fall.off],
        }
        self.tubes |= {name: Tube(self.span, arb_poly(row), zero) for name, row in rows.items()}

    def body_ahead_of_foot(self, time: arb) -> arb:
        """Position of the body along the ground line, relative to the foot, at a time."""
        return -self.tubes["length"].at(time) * self.tubes["sine"].at(time)

    def motion(self, runner: Any) -> Any:
        """The runner with all tubes, and what is kept."""
        return at(runner, self.mode, self.tubes | self.kept)

    def at(self, time: arb) -> Values:
        """The numbers of the motion at a time, or at any of a ball of times."""
        found = {name: tube.at(time) for name, tube in self.tubes.items() if name in self.names}
        return {**found, **self.kept}


def widened(remainder: arb) -> arb:
    """A wider ball around a remainder."""
    return remainder + arb(0, (abs(remainder).upper() * (WIDENED - 1) + arb(2) ** (-ctx.prec)).upper())


def longest(runner: Any, terms: Mapping[str, list[arb]]) -> arb:
    """Step over which the last terms of the series fall below the working precision. Nothing rests on it."""
    reach = float(runner.longest_step)
    for name, row in terms.items():
        scale = runner.sizes.get(name, 1.0)
        for k in (len(row) - 1, len(row) - 2):
            size = float(abs(row[k]).upper() / scale) if row[k].is_finite() else float("inf")
            if size > 0.0:
                reach = min(reach, 2.0 ** (-ctx.prec / k) * size ** (-1.0 / k))
    return arb(reach)
