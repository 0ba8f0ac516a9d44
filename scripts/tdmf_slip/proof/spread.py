"""Derivatives of the motion by the start of a stride: products of those of steps and events, enclosed.

A product of enclosures, one after the other, widens at each turn of the motion, far more than the true
derivative varies over the set. For any matrices L_0, ..., L_n with L_n = 1 the product of A_1, ..., A_n is

    A_n ... A_1 V = L_0 V + sum of (L_k A_k - L_(k-1)) A_(k-1) ... A_1 V.

With L_(k-1) near the middle of L_k A_k, taken from the end to the beginning, each bracket is a small ball
around zero, which is as wide as one factor and no more; what was enclosed before serves as A_(k-1) ... A_1 V.
"""

import numpy as np
from flint import arb, arb_mat

from .matrices import identity, middle

OFTEN = 8
"""After so many factors the sum is taken, and at each event."""


class Spread:
    """The derivative of the motion by its start, of shape (numbers of the mode, numbers of the start)."""

    def __init__(self, first: arb_mat) -> None:
        """The derivative at the start."""
        self.product = self._first = first
        self._factors: list[tuple[arb_mat, arb_mat]] = []
        """Each A_k, and what was enclosed before it."""

    def follow(self, derivative: arb_mat, *, is_event: bool = False) -> None:
        """Go on by the derivative of a step or of an event."""
        self._factors.append((derivative, self.product))
        self.product = derivative * self.product
        if is_event or len(self._factors) % OFTEN == 0:
            self.product = intersected(self.product, self._telescoped())

    def _telescoped(self) -> arb_mat:
        """The product by the sum above."""
        later = identity(self.product.nrows())
        found = arb_mat(self.product.nrows(), self.product.ncols())
        for factor, before in reversed(self._factors):
            whole = later * factor
            later = middle(whole)
            found = found + (whole - later) * before
        return found + later * self._first


class Drift:
    """How far the true motion may be from the point that stands for it: Q e, with balls e."""

    def __init__(self, size: int) -> None:
        """None yet, of a motion of so many numbers."""
        self._frame, self._inside = identity(size), arb_mat(size, 1)

    def follow(self, derivative: arb_mat, fresh: list[arb]) -> None:
        """Go on by the derivative of a step, which adds errors of its own."""
        turned = derivative * self._frame
        self._frame, inside = _frame_of(turned, self._inside), self._inside
        back = self._frame.inv()
        self._inside = (back * turned) * inside + back * arb_mat(len(fresh), 1, fresh)

    def balls(self) -> list[arb]:
        """By number."""
        return list((self._frame * self._inside).entries())


def _frame_of(matrix: arb_mat, inside: arb_mat) -> arb_mat:
    """An orthogonal basis, to rounding, whose first directions are those in which the set is widest."""
    middle = np.array([[float(x.mid()) for x in row] for row in matrix.tolist()])
    widths = np.array([float(sum((x.rad() for x in row), arb(0)).upper()) for row in inside.tolist()])
    sizes = np.array([float(sum((abs(x) for x in row), arb(0)).upper()) for row in inside.tolist()])
    weight = widths if np.all(np.isfinite(widths)) and widths.any() else sizes
    columns = middle * weight
    order = np.argsort(-np.linalg.norm(columns, axis=0), kind="stable")
    if not np.all(np.isfinite(columns)):
        return identity(matrix.nrows())
    basis, _ = np.linalg.qr(middle[:, order], mode="complete")
    size = matrix.nrows()
    return arb_mat(size, size, [arb(float(x)) for x in basis.ravel()])


def intersected(one: arb_mat, other: arb_mat) -> arb_mat:
    """Intersection of two enclosures of a matrix."""
    pairs = zip(one.entries(), other.entries(), strict=True)
    return arb_mat(one.nrows(), one.ncols(), [narrower(a, b) for a, b in pairs])


def narrower(one: arb, other: arb) -> arb:
    """Enclosure of the intersection of two enclosures of a number; a ball, so not always less than either."""
    if not one.is_finite():
        return other
    if not other.is_finite():
        return one
    both = one.intersection(other)
    return min(one, other, both, key=lambda ball: float(ball.rad()))
