"""Numbers with their gradients: forward differentiation over any kind of number, a ball or a tube."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from flint import acb_mat, arb, arb_mat
from numpy.typing import NDArray


def identity(size: int) -> arb_mat:
    """The unit matrix."""
    return arb_mat(size, size, 1)


def greatest(values: list[arb]) -> arb:
    """The greatest of upper bounds."""
    found = arb(0)
    for value in values:
        found = found.max(value)
    return found.upper()


def row_sums(sizes: list[list[arb]], weights: list[arb]) -> list[arb]:
    """Sums of the rows of D^-1 A D, with the weights on the diagonal of D and the absolute values of A."""
    rows = zip(sizes, weights, strict=True)
    return [sum((x * w for x, w in zip(row, weights, strict=True)), arb(0)) / own for row, own in rows]


def absolute(matrix: arb_mat | acb_mat) -> list[list[arb]]:
    """Absolute values of a matrix, by rows."""
    return [[abs(x) for x in row] for row in matrix.tolist()]


def floats_above(sizes: list[list[arb]]) -> NDArray[np.float64]:
    """Upper bounds of a matrix of absolute values, about; for choices, not for proofs."""
    return np.array([[float(x.upper()) for x in row] for row in sizes])


def norm(matrix: arb_mat, weights: list[arb]) -> arb:
    """An upper bound of the largest weighted sum of absolute values in a row."""
    return greatest([row.upper() for row in row_sums(absolute(matrix), weights)])


class UndecidedError(Exception):
    """A guard, a sign or an inclusion that the enclosures leave open; it says nothing about the gait."""

    def __init__(self, guard: str, time: float | None = None) -> None:
        """Open statement, and its time in the stride."""
        super().__init__(guard)
        self.guard, self.time = guard, time

    def as_json(self) -> dict[str, object]:
        """Place where a proof ended, as a plain object."""
        return {"guard": self.guard, "time": self.time}


Number = Any
"""A ball, a tube, a float or a dual of one."""


class Arithmetic:
    """Operators that follow from sum, product and inverse. The other operand may be of any kind."""

    __slots__ = ()

    def inverse(self) -> Any:
        """One over it."""
        raise NotImplementedError

    def __add__(self, other: Number) -> Any:
        """The sum."""
        raise NotImplementedError

    def __mul__(self, other: Number) -> Any:
        """The product."""
        raise NotImplementedError

    def __radd__(self, other: Number) -> Any:
        """The sum."""
        return self + other

    def __rmul__(self, other: Number) -> Any:
        """The product."""
        return self * other

    def __neg__(self) -> Any:
        """The negative."""
        return self * -1

    def __sub__(self, other: Number) -> Any:
        """The difference."""
        return self + -other

    def __rsub__(self, other: Number) -> Any:
        """The difference."""
        return -self + other

    def __truediv__(self, other: Number) -> Any:
        """The quotient."""
        return self * (other.inverse() if isinstance(other, Arithmetic) else 1 / arb(other))

    def __rtruediv__(self, other: Number) -> Any:
        """A number over it."""
        return self.inverse() * other


class Dual(Arithmetic):
    """A number and its partial derivatives by name; a name that is missing stands for zero."""

    __slots__ = ("gradient", "value")

    def __init__(self, value: Number, gradient: Mapping[str, Number]) -> None:
        """A value and its derivatives."""
        self.value, self.gradient = value, gradient

    def __add__(self, other: Number) -> "Dual":
        """The sum."""
        if not isinstance(other, Dual):
            return Dual(self.value + other, self.gradient)
        gradient = dict(self.gradient)
        for name, slope in other.gradient.items():
            gradient[name] = gradient[name] + slope if name in gradient else slope
        return Dual(self.value + other.value, gradient)

    def __mul__(self, other: Number) -> "Dual":
        """The product, by the rule of products."""
        if not isinstance(other, Dual):
            return self._by(self.value * other, other)
        gradient = {name: slope * other.value for name, slope in self.gradient.items()}
        for name, slope in other.gradient.items():
            part = self.value * slope
            gradient[name] = gradient[name] + part if name in gradient else part
        return Dual(self.value * other.value, gradient)

    def _by(self, value: Number, slope: Number) -> "Dual":
        """A value that changes by a slope with this number."""
        return Dual(value, {name: slope * own for name, own in self.gradient.items()})

    def inverse(self) -> "Dual":
        """One over it."""
        inverse = 1 / self.value
        return self._by(inverse, -(inverse * inverse))

    def __ge__(self, other: Number) -> bool:
        """True if the number is proved not to be less than another."""
        return bool(self.value >= value_of(other))

    def __gt__(self, other: Number) -> bool:
        """True if the number is proved to exceed another."""
        return bool(self.value > value_of(other))

    def sin(self) -> "Dual":
        """The sine."""
        return self._by(self.value.sin(), self.value.cos())

    def cos(self) -> "Dual":
        """The cosine."""
        return self._by(self.value.cos(), -self.value.sin())

    def exp(self) -> "Dual":
        """The exponential."""
        return self._by(self.value.exp(), self.value.exp())

    def expm1(self) -> "Dual":
        """The exponential less 1."""
        return self._by(self.value.expm1(), self.value.exp())

    def log1p(self) -> "Dual":
        """The logarithm of 1 more."""
        return self._by(self.value.log1p(), 1 / (1 + self.value))


def value_of(number: Number) -> Number:
    """The number without its gradient."""
    return number.value if isinstance(number, Dual) else number


def slope_of(number: Number, name: str) -> Number:
    """A partial derivative."""
    return number.gradient.get(name, 0) if isinstance(number, Dual) else 0
