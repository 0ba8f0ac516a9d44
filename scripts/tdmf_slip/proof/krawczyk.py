"""Fixed points of the stride: found, and proved by Krawczyk's operator.

With G(x) = x - P(x) and a point matrix Y near the inverse of its derivative,

    K(X) = m - Y G(m) + (I - Y DG(X)) (X - m)

holds every zero of G in the box X around m; where K(X) lies in the interior of X, there is exactly one.
What is proved rests on balls alone; how m and Y were found does not matter.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from flint import arb, arb_mat, ctx
from numpy.typing import NDArray

from .matrices import identity
from .parameters import Parameters
from .stride import Fineness, Starts, Stride, Traveller
from .travelling_set import SetTraveller
from .undecided import UndecidedError

MOST_STEPS = 12
SHARPENINGS = 12


def refined(
    parameters: Parameters,
    apex: Sequence[arb],
    jacobian: NDArray[np.float64],
    fineness: Fineness,
    nearness: float,
) -> list[arb]:
    """A point near the fixed point, by Newton's method with one Jacobian; nothing is proved.

    Parameters
    ----------
    parameters : Parameters
        Whose stride.
    apex : sequence of arb, shape (6,) or (7,)
        Near it, with the value of what is varied, which stays.
    jacobian : ndarray of float, shape (6, 6)
        Of the stride, about.
    fineness : Fineness
        Of the motion.
    nearness : float
        How near is near enough.

    Returns
    -------
    list of arb
        Points.
    """
    inverse = np.linalg.inv(np.eye(6) - jacobian)
    found = list(apex)
    with ctx.workprec(fineness.bits):
        points = point_matrix(inverse)
        last = float("inf")
        for _ in range(MOST_STEPS):
            stride = Traveller(parameters, found, fineness).stride()
            step = points * arb_mat(6, 1, [after - x for after, x in zip(stride.centre, found, strict=False)])
            found[:6] = [(x + dx).mid() for x, dx in zip(found, step.entries(), strict=False)]
            size = float(max(abs(dx).upper() for dx in step.entries()))
            if not size < 0.5 * last or size < nearness:
                break
            last = size
    return found


def point_matrix(matrix: NDArray[Any]) -> arb_mat:
    """Doubles as they are."""
    rows, columns = matrix.shape
    return arb_mat(rows, columns, [arb(float(x)) for x in matrix.ravel()])


def proved_stride(parameters: Parameters, starts: Starts, fineness: Fineness, coarseness: Fineness) -> Stride:
    """The stride of all starts of a box, with its derivative."""
    return SetTraveller(parameters, starts, fineness, coarseness).stride()


class Inclusion:
    """Krawczyk's operator on a box, and what it proves."""

    def __init__(self, starts: Starts, stride: Stride, fineness: Fineness) -> None:
        """Of a box and its stride.

        Parameters
        ----------
        starts : Starts
            The box, without what is varied or with it as a seventh coordinate.
        stride : Stride
            Of it, with derivative.
        fineness : Fineness
            Of the operator's arithmetic.

        Raises
        ------
        UndecidedError
            The operator does not map the box into itself.
        """
        assert stride.derivative is not None
        with ctx.workprec(fineness.bits):
            self._solve(starts, stride.centre, stride.derivative)

    def _solve(self, starts: Starts, after: list[arb], derivative: arb_mat) -> None:
        square = arb_mat(6, 6, [derivative[i, j] for i in range(6) for j in range(6)])
        middle = np.array([[float(x.mid()) for x in row] for row in square.tolist()])
        if not np.all(np.isfinite(middle)):
            raise UndecidedError("the derivative of the stride")
        inverse = point_matrix(np.linalg.inv(np.eye(6) - middle))
        left = arb_mat(6, 1, [y - x for y, x in zip(after, starts.centre, strict=False)])
        shift = inverse * left
        if derivative.ncols() > 6:  # P(m, q) lies in P(m, middle of q) + DP (q - middle)
            by = arb_mat(6, 1, [derivative[i, 6] for i in range(6)])
            shift = shift + inverse * by * arb_mat(1, 1, [arb(0, starts.radii[6])])
        rest = identity(6) - inverse * (identity(6) - square)
        radii = arb_mat(6, 1, [arb(0, r) for r in starts.radii[:6]])
        image = shift + rest * radii
        for of_image, radius in zip(image.entries(), starts.radii, strict=False):
            if not (of_image.is_finite() and abs(of_image) < radius):
                raise UndecidedError("the inclusion of the fixed point in the box")
        for _ in range(SHARPENINGS):
            image = shift + rest * image
        self.apex = [x + dx for x, dx in zip(starts.centre, image.entries(), strict=False)]
