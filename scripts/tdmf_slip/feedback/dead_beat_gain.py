"""The gain by which modes reach 0 in the fewest steps.

The modes from which 0 is reached in j steps make a subspace: S_0 = {0}, and z is in S_j where F z + G u is in
S_(j-1) for some u. The gain takes each S_j into S_(j-1), with the least settings that do.
"""

import numpy as np
from numpy.typing import NDArray

TOLERANCE = 1e-9
"""Singular values below this share of the largest of F, or of G, count as 0."""


def dead_beat_gain(
    state_matrix: NDArray[np.float64], input_matrix: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The gain K with which F + G K is nilpotent, of the lowest index."""
    count = len(state_matrix)
    min_moved = TOLERANCE * float(np.linalg.norm(input_matrix, 2))
    min_kept = TOLERANCE * float(np.linalg.norm(state_matrix, 2))
    reached = np.zeros((count, 0))
    gain = np.zeros((input_matrix.shape[1], count))
    while reached.shape[1] < count:
        outside = _complement(reached)
        moved, values, by = _decomposed(outside.T @ input_matrix, min_moved)
        kept = state_matrix.T @ outside @ _complement(moved)
        directions, _, _ = _decomposed(kept, min_kept)
        added = _added(_complement(directions), reached)
        if not added.shape[1]:
            raise ArithmeticError("the modes are not controllable")
        settings = -by.T / values @ moved.T @ outside.T @ state_matrix @ added
        gain += settings @ added.T
        reached = np.hstack([reached, added])
    return gain


def _decomposed(
    matrix: NDArray[np.float64], minimum: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The singular values of a matrix above a bound, with their vectors."""
    left, values, right = np.linalg.svd(matrix, full_matrices=False)
    rank = int(np.count_nonzero(values > minimum))
    return left[:, :rank], values[:rank], right[:rank]


def _complement(basis: NDArray[np.float64]) -> NDArray[np.float64]:
    """An orthonormal basis of what is orthogonal to an orthonormal basis."""
    vectors = np.linalg.svd(basis, full_matrices=True)[0]
    return vectors[:, basis.shape[1] :]


def _added(basis: NDArray[np.float64], to: NDArray[np.float64]) -> NDArray[np.float64]:
    """Part of a basis beyond another one that lies in its range."""
    beside = basis - to @ (to.T @ basis)
    vectors = np.linalg.svd(beside, full_matrices=False)[0]
    return vectors[:, : basis.shape[1] - to.shape[1]]
