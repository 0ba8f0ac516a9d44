"""Sizes of a gait's leading eigenvalues, with their derivatives: the spectral radius is the largest of them.

An eigenvalue of the Jacobian J with left and right vectors y, x changes by y^H dJ x / y^H x, its size by the
part of that along it. The spectral radius itself has no derivative where two eigenvalues are of one size. So
each of the leading ones is told, for itself: that the radius is at most R is that each of them is, and these
are smooth. Of a complex pair one is told. Where two meet in one point of the plane they have no derivative.

How near a gait is to a fold is told by det(I - J)^2, which goes to zero there, linearly with the parameters.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError

LEADING = 3
"""So many are told, a complex pair as one."""
MINIMUM = 1e-3
"""Smaller eigenvalues are of no interest, and count as zero."""
SIMPLE = 1e-7
"""Least product of unit left and right vectors: below, two eigenvalues meet."""


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Sizes of leading eigenvalues."""

    sizes: NDArray[np.float64]
    """The largest first, shape (m,)."""
    slopes: NDArray[np.float64]
    """Their changes, in rows, shape (m, d)."""
    positive: NDArray[np.bool_]
    """Which of them are of positive real eigenvalues, shape (m,)."""
    fold: float
    """det(I - J)^2."""
    fold_slopes: NDArray[np.float64]
    """Its changes, shape (d,)."""

    @classmethod
    def none(cls, count: int) -> "Spectrum":
        """Of nobody, over so many parameters."""
        return cls(np.zeros(0), np.zeros((0, count)), np.zeros(0, dtype=bool), np.inf, np.zeros(count))

    def along(self, directions: NDArray[np.float64]) -> "Spectrum":
        """The same, with the changes along directions, shape (d, e), in columns."""
        return Spectrum(
            self.sizes, self.slopes @ directions, self.positive, self.fold, self.fold_slopes @ directions
        )


def spectrum_of(
    jacobian: NDArray[np.float64], variations: Sequence[NDArray[np.float64]], simple: bool = True
) -> Spectrum:
    """The leading eigenvalues' sizes, and how they change."""
    values, right = np.linalg.eig(jacobian)
    leading = [k for k in np.argsort(-np.abs(values), kind="stable") if values[k].imag >= 0.0][:LEADING]
    sizes, slopes = np.zeros(LEADING), np.zeros((LEADING, len(variations)))
    positive = np.zeros(LEADING, dtype=bool)
    for row, k in enumerate(leading):
        sizes[row] = abs(values[k])
        positive[row] = values[k].imag == 0.0 and values[k].real > 0.0
        if simple and sizes[row] > MINIMUM:
            slopes[row] = _slopes(jacobian, values[k], right[:, k], variations)
    return Spectrum(sizes, slopes, positive, *_fold(jacobian, variations))


def _fold(
    jacobian: NDArray[np.float64], variations: Sequence[NDArray[np.float64]]
) -> tuple[float, NDArray[np.float64]]:
    """By Jacobi's formula for the derivative of a determinant."""
    matrix = np.eye(len(jacobian)) - jacobian
    fold = float(np.linalg.det(matrix)) ** 2
    traces = [np.trace(np.linalg.solve(matrix, variation)) for variation in variations]
    return fold, -2.0 * fold * np.array(traces)


def _slopes(
    jacobian: NDArray[np.float64],
    value: complex,
    right: NDArray[np.complex128],
    variations: Sequence[NDArray[np.float64]],
) -> list[float]:
    """Of an eigenvalue's size."""
    others, vectors = np.linalg.eig(jacobian.T)
    left = vectors[:, np.argmin(np.abs(others - value))]  # of J^T: y^H without the conjugation
    product = left @ right
    if abs(product) < SIMPLE:
        raise RunError("two leading eigenvalues of the gait meet, where they have no derivative")
    towards = np.conj(value) / abs(value)
    return [float((towards * (left @ variation @ right) / product).real) for variation in variations]
