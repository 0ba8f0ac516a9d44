"""A quick map of fates by a quadtree: a square whose corners have one fate is painted, others are split.

Near a border between fates every start is followed, elsewhere only corners of squares are. An island of
another fate that touches no corner is missed: the map is a preview, and says so.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..blocks import in_order
from ..library.laws import Law, is_noisy
from ..library.runner import Runner
from .ball import Ball, fates

PREVIEW = "preview"
REFINEMENTS = ("exact", PREVIEW)
"""Ways to make a map."""
LARGEST_SQUARE = 16
"""Starts along a side of the first squares, a power of two: an island as wide as this is never missed."""
MAX_POINTS_AT_ONCE = 1024
"""Largest number of points in a block."""

Follow = Callable[[NDArray[np.intp], NDArray[np.intp]], NDArray[np.int32]]
"""Rows and columns to fates of the starts there and strides until these were known, shape (2, starts)."""


@dataclass(frozen=True, eq=False)
class Slice:
    """Starts that differ from a gait's apex in two coordinates: a block of work."""

    runner: Runner
    """The runner."""
    apex: tuple[float, ...]
    """The gait's, shape (n,)."""
    axes: tuple[str, str]
    """Names of the two coordinates."""
    rows: tuple[float, ...]
    """Values of the first."""
    columns: tuple[float, ...]
    """Values of the second."""
    numbers: tuple[int, ...] = ()
    """Numbers of the rows in the whole slice."""
    law: Law | None = None
    """Law that changes settings at each apex."""
    ball: Ball | None = None
    """Ball around the gait in which a start counts as settled."""

    def starts(self) -> NDArray[np.float64]:
        """One to a row, the columns running fastest."""
        sections = np.tile(self.apex, (len(self.rows), len(self.columns), 1))
        sections[..., self.runner.coordinates.index(self.axes[0])] = np.asarray(self.rows)[:, None]
        sections[..., self.runner.coordinates.index(self.axes[1])] = np.asarray(self.columns)[None, :]
        return sections.reshape(-1, len(self.apex))


def fates_of_slice(part: Slice) -> NDArray[np.int32]:
    """Fate, and strides until it was known, of each start of a block: shape (2, rows, columns)."""
    starts, columns = part.starts(), len(part.columns)
    rows = (
        list(zip(part.numbers, np.split(starts, len(part.rows)), strict=True)) if is_noisy(part.law) else []
    )
    runs = [
        fates(part.runner, part.apex, row, law=part.law, first_number=number * columns)
        for number, row in rows
    ] or [fates(part.runner, part.apex, starts, law=part.law, ball=part.ball)]
    both = np.concatenate([(run.fate, run.strides) for run in runs], axis=1)
    return both.reshape(2, -1, columns)


def fates_of_points(plan: Slice, values: NDArray[np.float64]) -> NDArray[np.int32]:
    """Fate, and strides until it was known, of starts with these values of a slice's coordinates.

    The values have the shape (starts, 2), the result (2, starts).
    """
    starts = np.tile(plan.apex, (len(values), 1))
    starts[:, [plan.runner.coordinates.index(axis) for axis in plan.axes]] = values
    run = fates(plan.runner, plan.apex, starts, law=plan.law, ball=plan.ball)
    return np.stack([run.fate, run.strides])


def follow_points(
    plan: Slice,
    blocks: Callable[..., Any],
    report: Callable[[int], object],
    rows: NDArray[np.intp],
    columns: NDArray[np.intp],
) -> NDArray[np.int32]:
    """Fates of starts of a slice, by rows and columns, in blocks; how many are done is reported."""
    values = np.column_stack([np.asarray(plan.rows)[rows], np.asarray(plan.columns)[columns]])
    parts = np.array_split(values, -(-len(values) // MAX_POINTS_AT_ONCE))
    with blocks(partial(fates_of_points, replace(plan, rows=(), columns=())), parts) as results:
        ends = in_order(results, lambda number: report(len(parts[number])))
    return np.concatenate(ends, axis=1)


@dataclass(frozen=True, eq=False)
class Preview:
    """A map of which only some starts were followed."""

    fate: NDArray[np.int32]
    """Fate of each start, followed or painted."""
    strides: NDArray[np.int32]
    """Closed until the fate of a followed start was known; of a painted one, those of a corner."""
    is_followed: NDArray[np.bool_]
    """The rest is painted."""


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
    """Corners of open squares that have not been followed yet."""
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
    """Starts inside of open squares, as the first corner is; mixed squares are painted anew later."""
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
