"""A quick map of fates by a quadtree: a square whose corners have one fate is painted, others are split.

Near a border between fates every start is followed, elsewhere only corners of squares are. An island of
another fate that touches no corner is missed: the map is a preview, and says so.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

PREVIEW = "preview"
REFINEMENTS = ("exact", PREVIEW)
"""Ways to make a map."""
LARGEST_SQUARE = 16
"""Starts along a side of the first squares, a power of two: an island as wide as this is never missed."""

Follow = Callable[[NDArray[np.intp], NDArray[np.intp]], NDArray[np.int32]]
"""Function of rows and columns: fates of the starts there and strides until known, shape (2, starts)."""


@dataclass(frozen=True, eq=False)
class Preview:
    """A map of which only some starts were followed."""

    fate: NDArray[np.int32]
    """Fate of each start, followed or painted."""
    strides: NDArray[np.int32]
    """Strides closed until the fate of a followed start was known; for a painted start, those of a corner."""
    is_followed: NDArray[np.bool_]
    """True for starts that were followed; the others are painted."""


def preview_of(shape: Sequence[int], follow: Follow) -> Preview:
    """Fates on a grid, of which starts near a border are followed, and corners of squares elsewhere."""
    found = Preview(np.zeros(shape, "i4"), np.zeros(shape, "i4"), np.zeros(shape, dtype=bool))
    size, edges, is_split = LARGEST_SQUARE, [np.array([0, 0])] * 2, np.ones((1, 1), dtype=bool)
    while size:
        parents, edges = edges, [_edges(count, size) for count in shape]
        is_open = is_split[np.ix_(*(_squares_at(e[:-1], p) for e, p in zip(edges, parents, strict=True)))]
        _follow_corners(found, edges, is_open, follow)
        _paint(found, edges, is_open)
        is_split = _with_neighbours(is_open & _is_mixed(found.fate[np.ix_(*edges)]))
        size //= 2
    return found


def _edges(count: int, size: int) -> NDArray[np.intp]:
    """Edges of squares of a size, from the first start to the last."""
    return np.append(np.arange(0, max(count - 1, 1), size), count - 1)


def _squares_at(starts: NDArray[np.intp], edges: NDArray[np.intp]) -> NDArray[np.intp]:
    """Numbers of the squares that begin at or before starts."""
    return np.clip(np.searchsorted(edges, starts, side="right") - 1, 0, len(edges) - 2)


def _follow_corners(
    found: Preview, edges: Sequence[NDArray[np.intp]], is_open: NDArray[np.bool_], follow: Follow
) -> None:
    """Follow corners of open squares that have not been followed yet."""
    is_wanted = np.zeros((len(edges[0]), len(edges[1])), dtype=bool)
    for row in (slice(None, -1), slice(1, None)):
        for column in (slice(None, -1), slice(1, None)):
            is_wanted[row, column] |= is_open
    wanted = np.zeros_like(found.is_followed)
    wanted[np.ix_(*edges)] = is_wanted
    rows, columns = np.nonzero(wanted & ~found.is_followed)
    if not len(rows):
        return
    found.fate[rows, columns], found.strides[rows, columns] = follow(rows, columns)
    found.is_followed[rows, columns] = True


def _paint(found: Preview, edges: Sequence[NDArray[np.intp]], is_open: NDArray[np.bool_]) -> None:
    """Paint the inside of open squares like their first corner; mixed squares are painted anew later."""
    squares = [_squares_at(np.arange(count), e) for count, e in zip(found.fate.shape, edges, strict=True)]
    is_inside = is_open[np.ix_(*squares)] & ~found.is_followed
    corners = np.ix_(*(e[s] for e, s in zip(edges, squares, strict=True)))
    for values in (found.fate, found.strides):
        values[is_inside] = values[corners][is_inside]


def _is_mixed(corners: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Squares whose corners have more than one fate."""
    first = corners[:-1, :-1]
    is_mixed: NDArray[np.bool_] = (
        (corners[1:, :-1] != first) | (corners[:-1, 1:] != first) | (corners[1:, 1:] != first)
    )
    return is_mixed


def _with_neighbours(squares: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Squares and the eight around each: a border leaves a square without passing its corners."""
    wide = np.pad(squares, 1)
    rows = wide[:-2] | wide[1:-1] | wide[2:]
    return rows[:, :-2] | rows[:, 1:-1] | rows[:, 2:]
