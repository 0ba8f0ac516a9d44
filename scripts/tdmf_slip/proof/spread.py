"""Derivatives of the motion by the start of a stride: products of those of steps and events, enclosed.

A plain product of enclosures widens at each turn of the motion. Beside it the product is kept as Q W with a
point matrix Q that is made orthogonal at each step (Lohner), and both are intersected.
"""

import numpy as np
from flint import arb, arb_mat

from .matrices import identity


class Spread:
    """The derivative of the motion by its start, of shape (numbers of the mode, numbers of the start)."""

    def __init__(self, first: arb_mat) -> None:
        """The derivative at the start."""
        self.product = first
        self._frame, self._inside = identity(first.nrows()), first

    def follow(self, derivative: arb_mat) -> None:
        """Go on by the derivative of a step or of an event.

        Parameters
        ----------
        derivative : arb_mat
            Of shape (numbers after it, numbers before it).
        """
        plain = derivative * self.product
        turned = derivative * self._frame
        frame = _frame_of(turned, self._inside)
        self._inside = (frame.inv() * turned) * self._inside
        self._frame = frame
        self.product = intersected(plain, frame * self._inside)


class Drift:
    """How far the true motion may be from the point that stands for it: Q e, with balls e."""

    def __init__(self, size: int) -> None:
        """None yet, of a motion of so many numbers."""
        self._frame, self._inside = identity(size), arb_mat(size, 1)

    def follow(self, derivative: arb_mat, fresh: list[arb]) -> None:
        """Go on by the derivative of a step, which adds errors of its own.

        Parameters
        ----------
        derivative : arb_mat
            Of shape (numbers after it, numbers before it).
        fresh : list of arb
            By number, around zero.
        """
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
    """What lies in both of two enclosures of the same matrix."""
    pairs = zip(one.entries(), other.entries(), strict=True)
    return arb_mat(one.nrows(), one.ncols(), [narrower(a, b) for a, b in pairs])


def narrower(one: arb, other: arb) -> arb:
    """What lies in both of two enclosures of the same number; a ball, so not always less than either."""
    if not one.is_finite():
        return other
    if not other.is_finite():
        return one
    both = one.intersection(other)
    return min(one, other, both, key=lambda ball: float(ball.rad()))
