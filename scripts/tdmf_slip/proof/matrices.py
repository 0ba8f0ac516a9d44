"""Matrices of balls."""

from flint import arb, arb_mat


def identity(size: int) -> arb_mat:
    """The unit matrix."""
    return arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])


def greatest(values: list[arb]) -> arb:
    """The greatest of upper bounds."""
    found = arb(0)
    for value in values:
        found = found.max(value)
    return found.upper()


def norm(matrix: arb_mat) -> arb:
    """An upper bound of the largest sum of absolute values in a row."""
    rows, columns = matrix.nrows(), matrix.ncols()
    return greatest([sum((abs(matrix[i, j]) for j in range(columns)), arb(0)).upper() for i in range(rows)])
