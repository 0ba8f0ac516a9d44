"""The grid of a viable set: cells of a plane of apices, and actions to choose from at each apex.

The image of a whole cell is enclosed in a box, from images of its corners. For any point x of a cell, P(x) is
within `f D |x - x_k|` of the image of corner k, if f D bounds the derivatives in the cell. The mean over
corners of `|x_j - x_kj|` is half a side for every x. Therefore

    P_i(x) = mean of P_i(x_k)  +-  f sum of D_ij h_j / 2.

This is the exact box of the image for a linear map and f = 1. D is the largest derivative at the corners, by
one-sided differences to the neighbours along each coordinate. It only estimates the derivatives in between;
the factor f is a margin of safety. If some corners have no image, the mean is over the others, and the larger
share of the corners on one side replaces the half.

The viable set is the largest set of states that some action maps back into the set. A state is in the set
while one of its pairs of state and action is. A pair is in the inner set while every state of its box is,
and in the outer set while some state is. A table of cumulated sums gives the number of such states in a box
of any size from four numbers, so that a pass takes all pairs at once.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..analysis.ball import starts_at
from ..checks import check_size, checked_whole
from ..errors import InputError
from ..files.resume import NOT_YET
from ..given import counts_given, ends_given, mapping_of, row_of
from ..library.batch import ACCURACY, TOLERANCE, Batch
from ..library.batch_tables import CLOSED, STRIDE_FATES
from ..library.runner import Runner
from ..library.section import REDUCED, check_axes
from ..library.settings import check_acts, checked_values, setting_number
from ..record import dataset
from ..variables.table import by_full_name

if TYPE_CHECKING:
    import xarray

MAX_CELLS = 2048
"""Largest number of cells along an axis."""
MAX_ACTIONS = 4096
"""Largest number of values of one setting."""
MAX_STRIDES = 50_000_000
"""Largest number of strides of a grid; they take 1.5 GB, and two to four minutes on two processors."""
VALUES = 16
"""Number of values of a setting, by default."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Cells over two coordinates of the section, and actions for each apex."""

    edges: Mapping[str, NDArray[np.float64]]
    """Edges of the cells by coordinate, in increasing order, shape (cells + 1,)."""
    actions: Mapping[str, NDArray[np.float64]]
    """Values by setting, shape (values,). An action has one value of each setting."""

    @property
    def cells(self) -> tuple[int, int]:
        """Number of cells along each coordinate."""
        rows, columns = (len(edges) - 1 for edges in self.edges.values())
        return rows, columns

    @property
    def nodes(self) -> tuple[int, int]:
        """Number of corners of cells along each coordinate."""
        return self.cells[0] + 1, self.cells[1] + 1

    def columns(self, runner: Runner) -> list[int]:
        """Indices of both coordinates in a point of the runner's section."""
        return [runner.coordinates.index(axis) for axis in self.edges]

    @property
    def action_shape(self) -> tuple[int, ...]:
        """Number of values of each setting."""
        return tuple(len(values) for values in self.actions.values())

    @property
    def action_count(self) -> int:
        """Number of actions, which are all combinations of settings."""
        return math.prod(self.action_shape)

    @property
    def sizes(self) -> NDArray[np.float64]:
        """Sizes of a cell along each coordinate, shape (2,)."""
        return np.array([edges[1] - edges[0] for edges in self.edges.values()])

    @property
    def origin(self) -> NDArray[np.float64]:
        """Corner of the grid with the least coordinates, shape (2,)."""
        return np.array([edges[0] for edges in self.edges.values()])

    def all_actions(self) -> dict[str, NDArray[np.float64]]:
        """Value of each setting in all actions, shape (actions,); the last setting varies fastest."""
        mesh = np.meshgrid(*self.actions.values(), indexing="ij")
        return {name: values.ravel() for name, values in zip(self.actions, mesh, strict=True)}

    def centers(self, axis: str) -> NDArray[np.float64]:
        """Middles of the cells along a coordinate, shape (cells,)."""
        edges = self.edges[axis]
        middles: NDArray[np.float64] = 0.5 * (edges[1:] + edges[:-1])
        return middles

    def cell_of(self, apices: NDArray[np.float64]) -> NDArray[np.intp]:
        """Numbers of the cells that hold apices, -1 for an apex outside of the grid."""
        indices = np.floor((apices - self.origin) / self.sizes)
        inside: NDArray[np.bool_] = np.logical_and.reduce((indices >= 0) & (indices < self.cells), axis=1)
        rows, columns = np.where(inside[:, np.newaxis], indices, 0).astype(np.intp).T
        return np.where(inside, rows * self.cells[1] + columns, -1)


def grid_of(runner: Runner, axes: Any, vary: Any, n: Any) -> Grid:
    """Grid from arguments, which are checked here."""
    ranges = mapping_of(axes, "axes", "a mapping of both coordinates to ranges (low, high)")
    known = runner.coordinates if runner.model.is_page else REDUCED
    check_axes(tuple(ranges), known)
    names = tuple(axis for axis in known if axis in ranges)
    if len(names) != 2:
        missing = ", ".join(axis for axis in known if axis not in ranges)
        raise InputError(f"axes: without {missing or 'two'}; allowed: ranges of two of {', '.join(known)}")
    of = {axis: runner.model.coordinate(axis) for axis in names}
    edges = {
        axis: np.linspace(*ends_given(f"axes: {axis}", ranges[axis], read=of[axis].without_units), count + 1)
        for axis, count in zip(names, counts_given(n, MAX_CELLS), strict=True)
    }
    for axis, along in edges.items():
        of[axis].values_of(along, f"axes: {axis}")
    grid = Grid(edges, _actions(runner, vary))
    check_size("grid", math.prod(grid.nodes) * grid.action_count, "strides", MAX_STRIDES)
    return grid


def _actions(runner: Runner, vary: Any) -> dict[str, NDArray[np.float64]]:
    model, allowed = runner.model, "a mapping of settings to ranges (low, high) or (low, high, values)"
    ranges = by_full_name(vary, "vary", allowed, model.aliases)
    if not ranges:
        raise InputError("vary: nothing; allowed: one or more settings with their ranges")
    actions: dict[str, NDArray[np.float64]] = {}
    for name, span in ranges.items():
        setting_number(name, "vary", model)
        check_acts(name, runner, tuple(ranges), "vary")
        what = f"vary: {name}"
        row = row_of(span, what, "(low, high) or (low, high, values)")
        count = checked_whole(f"{what}: values", row[2], 1, MAX_ACTIONS) if len(row) == 3 else VALUES
        ends = row[:2] if len(row) == 3 else row
        low, high = ends_given(what, ends, may_be_one=count == 1, read=model.variables[name].without_units)
        actions[name] = checked_values(name, np.linspace(low, high, count), "vary", {"value": 0}, model)
    return actions


STRIDES_IN_A_CALL = 65_536
"""Number of strides in a call of the engine; each takes 400 bytes of memory."""
STRIDES_IN_A_BLOCK = 65_536
"""Largest number of strides in a block of work, but for those of one row of corners."""


def strides_of(
    runner: Runner, grid: Grid, point: NDArray[np.float64], rows: Sequence[int]
) -> dict[str, NDArray[Any]]:
    """Fates and next coordinates of strides by all actions from all corners in some rows: a block of work.

    Coordinates that are no axes of the grid are those of `point` at all corners.
    """
    count, columns = grid.action_count, grid.columns(runner)
    along, across = grid.edges.values()
    nodes = np.array([(first, second) for first in along[list(rows)] for second in across])
    fates, nexts = np.empty((len(nodes), count), np.int8), np.empty((2, len(nodes), count), np.float32)
    for some in np.array_split(np.arange(len(nodes)), -(-len(nodes) * count // STRIDES_IN_A_CALL)):
        starts = np.repeat(starts_at(point, columns, nodes[some]), count, axis=0)
        settings = {name: np.tile(of, len(some))[:, None] for name, of in grid.all_actions().items()}
        run = Batch(runner, starts, inputs=settings).run(1)
        closed = run.strides == 1
        fates[some] = np.where(closed, CLOSED, run.fate).reshape(len(some), count)
        nexts[:, some] = np.where(closed, run.apex[:, columns].T, np.nan).reshape(2, len(some), count)
    shape = (len(rows), len(across), *grid.action_shape)
    images = {f"next_{axis}": image.reshape(shape) for axis, image in zip(grid.edges, nexts, strict=True)}
    return {"fate": fates.reshape(shape), **images}


def no_transitions(runner: Runner, grid: Grid, point: NDArray[np.float64]) -> xarray.Dataset:
    """Dataset of a grid before any stride."""
    shared = dict(zip(runner.coordinates, point.tolist(), strict=True)) if runner.model.is_page else {}
    corners = [f"{axis}_edge" for axis in grid.edges]
    over, shape = (*corners, *grid.actions), (*grid.nodes, *grid.action_shape)
    flags = {
        "flag_values": np.arange(NOT_YET, len(STRIDE_FATES), dtype=np.int8),
        "flag_meanings": " ".join(("not_yet", *STRIDE_FATES)),
    }
    return dataset(
        "viability",
        runner.record(),
        {
            "fate": (over, np.full(shape, NOT_YET, np.int8), flags),
            **{f"next_{axis}": (over, np.full(shape, np.nan, np.float32)) for axis in grid.edges},
        },
        dict(zip(corners, grid.edges.values(), strict=True)) | dict(grid.actions),
        tolerance=TOLERANCE,
        **{f"at_{name}": value for name, value in shared.items() if name not in grid.edges},
    )


PAIRS_AT_ONCE = 1_000_000
ROUNDING = 2.0**-22
"""Rounding of images in single precision, over the largest coordinate."""


@dataclass(frozen=True, eq=False)
class Boxes:
    """Pairs of a cell and an action, each with the box of cells that encloses its image."""

    cells: NDArray[np.int32]
    """Number of each pair's cell, row by row, shape (pairs,)."""
    actions: NDArray[np.int32]
    """Number of each pair's action, shape (pairs,)."""
    low: NDArray[np.int16]
    """First row and column of the box, shape (2, pairs)."""
    high: NDArray[np.int16]
    """Last row and column, shape (2, pairs)."""

    def some(self, which: NDArray[np.bool_] | NDArray[np.intp]) -> Boxes:
        """Boxes of some of the pairs."""
        return Boxes(self.cells[which], self.actions[which], self.low[:, which], self.high[:, which])


def boxes_of(
    grid: Grid,
    images: Sequence[NDArray[np.float32]],
    scales: NDArray[np.float64],
    factor: float,
    *,
    inner: bool,
) -> Boxes:
    """Enclose the images of pairs in boxes of cells; pairs whose image leaves the grid are left out.

    Images are both next coordinates of strides from corners, each of shape (nodes, nodes, actions), NaN where
    a stride did not close.
    """
    rows, columns = grid.cells
    at_once = max(1, PAIRS_AT_ONCE // (columns * grid.action_count))
    off = _accuracy(grid, scales)[:, None, None, None]
    parts = [
        _block(grid, images, range(first, min(rows, first + at_once)), factor, off, inner)
        for first in range(0, rows, at_once)
    ]
    return Boxes(
        np.concatenate([part.cells for part in parts]),
        np.concatenate([part.actions for part in parts]),
        np.concatenate([part.low for part in parts], axis=1),
        np.concatenate([part.high for part in parts], axis=1),
    )


def _block(
    grid: Grid,
    images: Sequence[NDArray[np.float32]],
    rows: range,
    factor: float,
    off: NDArray[np.float64],
    inner: bool,
) -> Boxes:
    """Boxes of the cells of some rows; `off` is the largest error of an image."""
    around = _around(images, rows)
    corners = _corners(around[:, 1:-1, 1:-1])
    there = [np.isfinite(image[0]).astype(np.int8) for image in corners]
    found = np.asarray(sum(there), np.int8)
    known = np.maximum(found, 1)
    total = sum(np.where(of, image, 0.0) for of, image in zip(there, corners, strict=True))
    middle = np.asarray(total, float) / known
    upper = np.stack([there[2] + there[3], there[1] + there[3]]) / known
    shares = np.maximum(upper, 1.0 - upper)  # the larger share of the corners on a side of each axis
    by_row, by_column = _largest_differences(around)  # derivatives times sides
    half = factor * (by_row * shares[0] + by_column * shares[1]) + off
    with np.errstate(invalid="ignore"):
        low, high = (
            np.floor((end - grid.origin[:, None, None, None]) / grid.sizes[:, None, None, None])
            for end in (middle - half, middle + half)
        )
    maximum = np.array(grid.cells)[:, None, None, None] - 1
    if inner:
        chosen = (found == 4) & ((low >= 0) & (high <= maximum)).all(axis=0)
    else:
        low, high = (np.where(np.isfinite(half), end, beyond) for end, beyond in ((low, 0), (high, maximum)))
        chosen = (found > 0) & ((low <= maximum) & (high >= 0)).all(axis=0)
        low, high = np.maximum(low, 0), np.minimum(high, maximum)
    row, column, action = np.nonzero(chosen)
    return Boxes(
        ((row + rows.start) * grid.cells[1] + column).astype(np.int32),
        action.astype(np.int32),
        low[:, chosen].astype(np.int16),
        high[:, chosen].astype(np.int16),
    )


def _corners(of_nodes: NDArray[np.float32]) -> list[NDArray[np.float32]]:
    """Values at the corners of each cell: low and low, low and high, high and low, high and high."""
    sides = slice(None, -1), slice(1, None)
    return [of_nodes[:, rows, columns] for rows in sides for columns in sides]


def _around(images: Sequence[NDArray[np.float32]], rows: range) -> NDArray[np.float32]:
    """Images from the corners of some rows of cells and from the nodes around these, NaN beyond the grid."""
    first, last = max(0, rows.start - 1), min(len(images[0]), rows.stop + 2)
    beside = (first - rows.start + 1, rows.stop + 2 - last), (1, 1), (0, 0)
    return np.stack([np.pad(image[first:last], beside, constant_values=np.nan) for image in images])


def _largest_differences(around: NDArray[np.float32]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Largest differences of images along both axes, at and next to each cell's sides; NaN for none."""
    count, across = around.shape[1] - 3, around.shape[2] - 3
    down, right = (np.abs(np.diff(around, axis=axis)) for axis in (1, 2))
    near = [(three, side) for three in range(3) for side in (1, 2)]
    by_row = (down[:, three : three + count, side : side + across] for three, side in near)
    by_column = (right[:, side : side + count, three : three + across] for three, side in near)
    return reduce(np.fmax, by_row), reduce(np.fmax, by_column)


def _accuracy(grid: Grid, scales: NDArray[np.float64]) -> NDArray[np.float64]:
    """Largest error of a stored image, shape (2,)."""
    largest = np.array([np.abs(edges).max() for edges in grid.edges.values()])
    off: NDArray[np.float64] = ACCURACY * scales + ROUNDING * largest
    return off


@dataclass(frozen=True, eq=False)
class Kept:
    """Set of states, and the pairs that keep runners in the set."""

    states: NDArray[np.bool_]
    """True for the states of the set, shape (rows, columns)."""
    pairs: NDArray[np.intp]
    """Numbers of the pairs among the given ones."""
    passes: int
    """Number of passes; the last one removed no state."""


def sums_of(states: NDArray[np.bool_]) -> NDArray[np.int32]:
    """Number of states in the set above and left of each corner, shape (rows + 1, columns + 1)."""
    sums = np.zeros((states.shape[0] + 1, states.shape[1] + 1), np.int32)
    np.cumsum(np.cumsum(states, axis=0, dtype=np.int32), axis=1, out=sums[1:, 1:])
    return sums


def lands(boxes: Boxes, states: NDArray[np.bool_], *, inner: bool) -> NDArray[np.bool_]:
    """True for pairs that lead into a set."""
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
    """Largest set in which every state has a pair that leads back into the set."""
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
    """Fewest strides in which some choice of actions leads from each state into a set; -1 for none."""
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
