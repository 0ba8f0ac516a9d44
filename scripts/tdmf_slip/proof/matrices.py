"""Matrices of balls."""

import numpy as np
from flint import acb_mat, arb, arb_mat
from numpy.typing import NDArray


def identity(size: int) -> arb_mat:
    """The unit matrix."""
    return arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])


def middle(matrix: arb_mat) -> arb_mat:
    """Its midpoints."""
    return arb_mat(matrix.nrows(), matrix.ncols(), [x.mid() for x in matrix.entries()])


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
