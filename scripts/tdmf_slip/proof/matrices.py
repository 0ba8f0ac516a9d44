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


def norm(matrix: arb_mat, weights: list[arb]) -> arb:
    """An upper bound of the largest weighted sum of absolute values in a row.

    Parameters
    ----------
    matrix : arb_mat, shape (n, n)
        Of which.
    weights : list of arb, shape (n,)
        The norm is that of D^-1 A D with these on the diagonal of D.

    Returns
    -------
    arb
        Without radius.
    """
    size = matrix.nrows()
    rows = (
        sum((abs(matrix[i, j]) * weights[j] for j in range(size)), arb(0)) / weights[i] for i in range(size)
    )
    return greatest([row.upper() for row in rows])
