"""Taylor coefficients of a solution, one after the other.

The laws are evaluated once over `Unfolding` numbers, which makes a graph of sums, products and quotients;
each node then gives its k-th coefficient from those of lower order, as do the states from their rates,
x_(k+1) = f_k / (k + 1).
"""

from collections.abc import Callable, Mapping
from operator import mul
from typing import Any

from flint import arb

ZERO = arb(0)


class Unfolding:
    """A power series that is known as far as it has been asked for."""

    __slots__ = ("_next", "terms")

    def __init__(self, following: Callable[[int], arb] | None, terms: list[arb]) -> None:
        """The coefficients that are known, and how the k-th follows."""
        self._next, self.terms = following, terms

    def to(self, order: int) -> list[arb]:
        """All coefficients up to an order."""
        following = self._next
        while len(self.terms) <= order:
            self.terms.append(ZERO if following is None else following(len(self.terms)))
        return self.terms

    def __neg__(self) -> "Unfolding":
        """Its opposite."""
        return self * -1

    def __add__(self, other: Any) -> "Unfolding":
        """The sum with a series or a number."""
        if isinstance(other, Unfolding):
            return Unfolding(lambda k: self.to(k)[k] + other.to(k)[k], [])
        if isinstance(other, arb | int):
            return Unfolding(lambda k: self.to(k)[k] if k else self.to(0)[0] + other, [])
        return NotImplemented

    __radd__ = __add__

    def __sub__(self, other: Any) -> "Unfolding":
        """The difference."""
        if isinstance(other, Unfolding):
            return Unfolding(lambda k: self.to(k)[k] - other.to(k)[k], [])
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> "Unfolding":
        """The difference."""
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> "Unfolding":
        """The product."""
        if isinstance(other, arb | int):
            return Unfolding(lambda k: self.to(k)[k] * other, [])
        if not isinstance(other, Unfolding):
            return NotImplemented
        return Unfolding(lambda k: sum(map(mul, self.to(k), other.to(k)[k::-1]), ZERO), [])

    __rmul__ = __mul__

    def __rtruediv__(self, other: Any) -> "Unfolding":
        """A number over it: v w = 1 tells w_k."""
        inverse = Unfolding(None, [])

        def following(k: int) -> arb:
            first = 1 / self.to(0)[0]
            terms = inverse.terms
            return -first * sum(map(mul, self.to(k)[1:], terms[::-1]), ZERO) if k else first

        inverse._next = following
        return inverse.__mul__(other)

    def __truediv__(self, other: Any) -> "Unfolding":
        """The quotient."""
        return self * (1 / (other if isinstance(other, Unfolding) else arb(other)))


Rates = Callable[[Mapping[str, Any]], Mapping[str, Any]]
"""From states by name to their rates, over any kind of number."""


def coefficients(
    start: Mapping[str, arb], constant: Mapping[str, arb], rates: Rates, degree: int
) -> dict[str, list[arb]]:
    """Taylor coefficients of a solution in time."""
    states = {name: Unfolding(None, [value]) for name, value in start.items()}
    found = rates({**states, **constant})
    for name, state in states.items():
        rate = found[name]
        if not isinstance(rate, Unfolding):
            state._next = lambda k, rate=rate: arb(rate) if k == 1 else ZERO
        else:
            state._next = lambda k, rate=rate: rate.to(k - 1)[k - 1] / k
    return {name: state.to(degree)[: degree + 1] for name, state in states.items()}
