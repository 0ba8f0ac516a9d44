"""Boxes of cells that hold the image of a whole cell, by what is known at corners.

For any point x of a cell, P(x) is within `f D |x - x_k|` of the image of corner k, if f D bounds the
derivatives in the cell. The mean over corners of `|x_j - x_kj|` is half a side, wherever x is. So

    P_i(x) = mean of P_i(x_k)  +-  f sum of D_ij h_j / 2,

which for a linear map and f = 1 is the image's own box. D is the largest derivative found at the corners, of
one-sided differences to the neighbours along each coordinate. So that it bounds the derivatives in between is
an estimate; the factor f is what is given to be safe. Where some corners have no image, the mean is that over
the others, and half a side becomes the larger share of them that are on one side.

The largest set of states that some action keeps in it, and the least that leads to a set.

A state counts while it has a pair that counts, a pair while its box of states does: for an inner set every
state of the box has to count, for an outer one some state. How many of a box count is read off a table of
sums, four numbers for a box of any size, so that a pass takes all pairs at once.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..library.batch import ACCURACY
from .grid import Grid, Transitions

PAIRS_AT_ONCE = 1_000_000
ROUNDING = 2.0**-22
"""Rounding of images, which are kept in single precision, over the largest coordinate."""


@dataclass(frozen=True, eq=False)
class Boxes:
    """Pairs of a cell and an action that may count, each with a box of cells."""

    cells: NDArray[np.int32]
    """Number of each pair's cell, row by row, shape (pairs,)."""
    actions: NDArray[np.int32]
    """Number of each pair's action, shape (pairs,)."""
    low: NDArray[np.int16]
    """First row and column of the box, shape (2, pairs)."""
    high: NDArray[np.int16]
    """Last row and column, shape (2, pairs)."""

    def some(self, which: NDArray[np.bool_] | NDArray[np.intp]) -> "Boxes":
        """Some of the pairs."""
        return Boxes(self.cells[which], self.actions[which], self.low[:, which], self.high[:, which])


def boxes_of(transitions: Transitions, scales: NDArray[np.float64], factor: float, *, inner: bool) -> Boxes:
    """The pairs that may count, and the boxes of cells in which their images are."""
    parts = list(_parts(transitions, scales, factor, inner))
    return Boxes(
        np.concatenate([part.cells for part in parts]),
        np.concatenate([part.actions for part in parts]),
        np.concatenate([part.low for part in parts], axis=1),
        np.concatenate([part.high for part in parts], axis=1),
    )


def _parts(
    transitions: Transitions, scales: NDArray[np.float64], factor: float, inner: bool
) -> Iterator[Boxes]:
    grid = transitions.grid
    rows, columns = grid.cells
    at_once = max(1, PAIRS_AT_ONCE // (columns * grid.action_count))
    for first in range(0, rows, at_once):
        last = min(rows, first + at_once)
        yield _block(transitions, scales, factor, inner, first, last)


def _block(
    transitions: Transitions, scales: NDArray[np.float64], factor: float, inner: bool, first: int, last: int
) -> Boxes:
    """Boxes of the cells of some rows."""
    grid = transitions.grid
    around = slice(max(0, first - 1), last + 2)
    images = transitions.next_apex[:, around]
    here = slice(first - around.start, last - around.start)
    there = np.isfinite(images[0, here.start : here.stop + 1])
    middle, corners, shares = _means(images[:, here.start : here.stop + 1], there)
    half = _reach(images, here, shares, grid, factor) + _accuracy(grid, scales)[:, None, None, None]
    with np.errstate(invalid="ignore"):
        low, high = (
            np.floor((end - grid.origin[:, None, None, None]) / grid.sizes[:, None, None, None])
            for end in (middle - half, middle + half)
        )
    maximum = np.array(grid.cells)[:, None, None, None] - 1
    if inner:
        chosen = (corners == 4) & ((low >= 0) & (high <= maximum)).all(axis=0)
    else:
        low, high = (np.where(np.isfinite(half), end, beyond) for end, beyond in ((low, 0), (high, maximum)))
        chosen = (corners > 0) & ((low <= maximum) & (high >= 0)).all(axis=0)
        low, high = np.maximum(low, 0), np.minimum(high, maximum)
    row, column, action = np.nonzero(chosen)
    return Boxes(
        ((row + first) * grid.cells[1] + column).astype(np.int32),
        action.astype(np.int32),
        low[:, chosen].astype(np.int16),
        high[:, chosen].astype(np.int16),
    )


def _four(of_nodes: NDArray[Any]) -> tuple[NDArray[Any], ...]:
    """Values at each cell's corners: low and low, low and high, high and low, high and high."""
    return tuple(
        of_nodes[..., rows, columns, :]
        for rows in (slice(None, -1), slice(1, None))
        for columns in (slice(None, -1), slice(1, None))
    )


def _means(
    images: NDArray[np.float32], there: NDArray[np.bool_]
) -> tuple[NDArray[np.float64], NDArray[np.int8], NDArray[np.float64]]:
    """Mean image of the corners that have one, their number, and the larger share on a side of each axis."""
    at = _four(there.astype(np.int8))
    corners = np.asarray(sum(at), np.int8)
    known = np.maximum(corners, 1)
    images_there = _four(np.where(there, images, 0.0))
    middle = np.asarray(sum(images_there), float) / known
    upper = np.stack([at[2] + at[3], at[1] + at[3]]) / known
    return middle, corners, np.maximum(upper, 1.0 - upper)


def _reach(
    images: NDArray[np.float32],
    here: slice,
    shares: NDArray[np.float64],
    grid: Grid,
    factor: float,
) -> NDArray[np.float64]:
    """How far the image of a cell may be from the mean, NaN where no derivative is known."""
    down = np.abs(np.diff(images, axis=1))
    along_rows = np.fmax(down[:, :, :-1], down[:, :, 1:])
    by_row = _largest_of_three(along_rows, 1)[:, here]
    rows = slice(here.start, here.stop + 1)
    across = np.abs(np.diff(images[:, rows], axis=2))
    by_column = _largest_of_three(np.fmax(across[:, :-1], across[:, 1:]), 2)
    # These are derivatives times sides already.
    reach: NDArray[np.float64] = factor * (by_row * shares[0] + by_column * shares[1])
    return reach


def _largest_of_three(values: NDArray[np.float32], axis: int) -> NDArray[np.float32]:
    """Largest of each value and its two neighbours along an axis; NaN counts only if all three are NaN."""
    largest = values.copy()
    low = [slice(None)] * values.ndim
    high = low.copy()
    low[axis], high[axis] = slice(None, -1), slice(1, None)
    np.fmax(largest[tuple(high)], values[tuple(low)], out=largest[tuple(high)])
    np.fmax(largest[tuple(low)], values[tuple(high)], out=largest[tuple(low)])
    return largest


def _accuracy(grid: Grid, scales: NDArray[np.float64]) -> NDArray[np.float64]:
    """By how much an image may be off as it is kept, shape (2,)."""
    largest = np.array([np.abs(edges).max() for edges in grid.edges.values()])
    off: NDArray[np.float64] = ACCURACY * scales + ROUNDING * largest
    return off


@dataclass(frozen=True, eq=False)
class Kept:
    """A set of states, and the pairs that keep runners in it."""

    states: NDArray[np.bool_]
    """Which states, shape (rows, columns)."""
    pairs: NDArray[np.intp]
    """Numbers of the pairs among those that were given."""
    passes: int
    """In which it was found; the last took no state away."""


def sums_of(states: NDArray[np.bool_]) -> NDArray[np.int32]:
    """How many states count above and left of each corner, shape (rows + 1, columns + 1)."""
    sums = np.zeros((states.shape[0] + 1, states.shape[1] + 1), np.int32)
    np.cumsum(np.cumsum(states, axis=0, dtype=np.int32), axis=1, out=sums[1:, 1:])
    return sums


def lands(boxes: Boxes, states: NDArray[np.bool_], *, inner: bool) -> NDArray[np.bool_]:
    """Which pairs lead into a set."""
    sums, width = sums_of(states).ravel(), states.shape[1] + 1
    top, left = boxes.low.astype(np.int32)
    bottom, right = boxes.high.astype(np.int32) + 1
    counted = (
        sums[bottom * width + right]
        - sums[top * width + right]
        - sums[bottom * width + left]
        + sums[top * width + left]
    )
    into: NDArray[np.bool_] = counted == (bottom - top) * (right - left) if inner else counted > 0
    return into


def largest_kept(boxes: Boxes, shape: tuple[int, int], *, inner: bool) -> Kept:
    """The largest set in which every state has a pair that leads back into it."""
    alive = np.arange(len(boxes.cells))
    before, states = None, _with_pairs(boxes.cells, shape)
    passes = 0
    while before is None or not np.array_equal(before, states):
        stay = lands(boxes, states, inner=inner)
        boxes, alive = boxes.some(stay), alive[stay]
        before, states = states, _with_pairs(boxes.cells, shape)
        passes += 1
    return Kept(states, alive, passes)


def strides_to(boxes: Boxes, target: NDArray[np.bool_], *, inner: bool) -> NDArray[np.int32]:
    """The fewest strides in which some choice of actions leads from each state into a set."""
    strides = np.where(target, 0, -1).astype(np.int32)
    count = 0
    while True:
        count += 1
        arrive = lands(boxes, strides >= 0, inner=inner)
        new = _with_pairs(boxes.cells[arrive], target.shape) & (strides < 0)
        if not new.any():
            return strides
        strides[new] = count
        boxes = boxes.some(~arrive)


def _with_pairs(cells: NDArray[np.int32], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    states = np.zeros(shape, bool)
    states.flat[cells] = True
    return states
