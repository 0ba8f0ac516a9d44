"""Eigenvalues of an enclosed matrix: Gershgorin's discs in a basis in which it is nearly diagonal.

Of the map's Jacobian some eigenvalues vanish, so that its eigenvectors alone are no basis: the directions
that the others leave over complete it.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import acb, acb_mat, arb, arb_mat
from numpy.typing import NDArray

from .matrices import absolute, floats_above, greatest, row_sums

SMALL = 1e6
"""An eigenvalue so many times the enclosure's width, or less, is taken with those that vanish,"""
LARGE = 0.05
"""but not where it is more than this much of the largest. A norm is rounder without them."""


@dataclass(frozen=True)
class Eigenvalues:
    """Discs that hold all eigenvalues: one each, and those that overlap as many together as they are."""

    discs: list[acb]
    """The largest first."""

    @property
    def largest(self) -> arb:
        """Size of the largest eigenvalue, enclosed from above."""
        found = arb(0)
        for disc in self.discs:
            found = found.max(abs(disc))
        return found

    @property
    def stable(self) -> bool | None:
        """All inside the unit circle, or one outside; None where neither is proved."""
        sizes = [abs(disc) for disc in self.discs]
        if all(size < 1 for size in sizes):
            return True
        outside = [disc for disc, size in zip(self.discs, sizes, strict=True) if size > 1]
        rest = [disc for disc, size in zip(self.discs, sizes, strict=True) if not size > 1]
        apart = any(not any(disc.overlaps(other) for other in rest) for disc in outside)
        return False if apart else None


def eigenvalues(matrix: arb_mat, rank: int) -> Eigenvalues:
    """Enclosures of all eigenvalues of every matrix in an enclosure that has a rank at the most."""
    whole = acb_mat(matrix)
    basis = _basis(matrix, LARGE)
    discs = _discs(basis.solve(whole * basis))
    around_zero = [k for k, disc in enumerate(discs) if disc.contains(0)]
    if len(around_zero) == matrix.nrows() - rank:  # so many vanish, and they are in discs that hold zero
        discs = [acb(0) if k in around_zero else disc for k, disc in enumerate(discs)]
    real = [_real_if_alone(disc, k, discs) for k, disc in enumerate(discs)]
    return Eigenvalues(sorted(real, key=lambda disc: -float(abs(disc).mid())))


def is_contracting(matrix: arb_mat) -> bool:
    """Whether it is proved that all eigenvalues of every matrix in an enclosure are inside the unit circle.

    In a basis in which the matrix is nearly diagonal, the largest weighted sum of a row bounds them all.
    """
    return contraction(matrix)[0] < 1


def contraction(matrix: arb_mat) -> tuple[arb, acb_mat, list[float]]:
    """A norm in which every matrix of an enclosure is small, and how small."""
    basis = _basis(matrix, np.inf)
    turned = basis.solve(acb_mat(matrix) * basis)
    sizes = absolute(turned)
    weights = [float(w) for w in _weights(floats_above(sizes), basis)]
    rows = row_sums(sizes, [arb(w) for w in weights])
    bound = greatest(rows) if all(row.is_finite() for row in rows) else arb("inf")
    return bound, basis, weights


def _weights(sizes: NDArray[np.float64], basis: acb_mat) -> NDArray[np.float64]:
    """Over which sums of rows are below 1, if any are: w = v + B w/kappa, where v is the unit cube's extent.

    So the ball of the norm is as round as it may be.
    """
    largest = float(np.max(np.abs(np.linalg.eigvals(sizes)))) if np.all(np.isfinite(sizes)) else np.inf
    inverse = np.array([[complex(x) for x in row] for row in basis.inv().tolist()])
    extent: NDArray[Any] = np.sum(np.abs(inverse), axis=1)
    if not largest < 1.0:
        return extent
    rate = 0.5 * (1.0 + largest)
    found: NDArray[np.float64] = np.linalg.solve(np.eye(len(sizes)) - sizes / rate, extent)
    return found


def _basis(matrix: arb_mat, large: float) -> acb_mat:
    """Nearly eigenvectors, and a complement of those that are left out; points, and nothing rests on them."""
    size = matrix.nrows()
    width = max(float(x.rad()) for x in matrix.entries()) + 1e-300
    points = acb_mat(matrix.mid())
    values, left, right = points.eig(left=True, right=True, algorithm="approx")
    sizes = [float(abs(value).mid()) for value in values]
    kept = [k for k in range(size) if sizes[k] > min(SMALL * width, large * max(sizes))]
    scale = [left_times_right(left, right, k) for k in range(size)]
    columns = [[right[i, k].mid() for i in range(size)] for k in kept]
    if len(kept) < size:
        rows = np.array([[complex(left[k, i]) for i in range(size)] for k in kept]).reshape(len(kept), size)
        spare = np.linalg.svd(rows, full_matrices=True)[2][len(kept) :].conj()
        for direction in spare:
            vector = [acb(complex(x)) for x in direction]
            for k in kept:
                part = sum((left[k, i] * vector[i] for i in range(size)), acb(0)) / scale[k]
                vector = [x - part * right[i, k] for i, x in enumerate(vector)]
            columns.append([x.mid() for x in vector])
    return acb_mat(size, size, [columns[j][i] for i in range(size) for j in range(size)])


def left_times_right(left: acb_mat, right: acb_mat, k: int) -> acb:
    """Product of a left and a right eigenvector."""
    return sum((left[k, i] * right[i, k] for i in range(left.nrows())), acb(0))


def _discs(matrix: acb_mat) -> list[acb]:
    """By rows: around the diagonal, with the sum of the others as radius."""
    sizes = absolute(matrix)
    for k, row in enumerate(sizes):
        row[k] = arb(0)
    radii = [arb(0, row.upper()) for row in row_sums(sizes, [arb(1)] * len(sizes))]
    return [matrix[k, k] + acb(radius, radius) for k, radius in enumerate(radii)]


def _real_if_alone(disc: acb, k: int, discs: list[acb]) -> acb:
    """One eigenvalue alone in a disc that meets the real axis is real: its conjugate would lie there, too."""
    mirrored = acb(disc.real, -disc.imag)
    if disc.imag.is_zero():
        return disc
    alone = not any(
        disc.overlaps(other) or mirrored.overlaps(other) for i, other in enumerate(discs) if i != k
    )
    return acb(disc.real) if alone and disc.imag.contains(0) else disc
