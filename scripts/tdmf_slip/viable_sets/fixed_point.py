"""The largest set of states that some action keeps in it, and the least that leads to a set.

A state counts while it has a pair that counts, a pair while its box of states does: for an inner set every
state of the box has to count, for an outer one some state. How many of a box count is read off a table of
sums, four numbers for a box of any size, so that a pass takes all pairs at once.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .boxes import Boxes


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
