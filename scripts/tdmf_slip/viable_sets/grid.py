"""The grid of a viable set: cells of a plane of apices, and actions to choose from at each."""

import math
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..blocks import run_blocks
from ..checks import check_kind, check_size, checked_whole
from ..errors import InputError
from ..files.resume import Resumed
from ..given import counts_given, ends_given, mapping_of, row_of
from ..library.batch import TOLERANCE, Batch
from ..library.batch_tables import CLOSED, STRIDE_FATES
from ..library.runner import Runner
from ..library.section import REDUCED, check_axes
from ..library.settings import check_acts, checked_values, setting_number
from ..record import dataset
from ..terminal.progress import progress_bar
from ..variables.table import VARIABLES, by_full_name

MAX_CELLS = 2048
"""Largest number of cells along an axis."""
MAX_ACTIONS = 4096
"""Largest number of values of one setting."""
MAX_STRIDES = 50_000_000
"""In all: those of that many take 1.5 GB, and are made in two to four minutes by two processors."""
VALUES = 16
"""Number of values of a setting, by default."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Cells over the two coordinates of the reduced map, and what may be set at each apex."""

    edges: Mapping[str, NDArray[np.float64]]
    """By coordinate: borders of the cells, rising, shape (cells + 1,)."""
    actions: Mapping[str, NDArray[np.float64]]
    """By setting: values to choose from, shape (values,). An action has one of each."""

    @property
    def cells(self) -> tuple[int, int]:
        """How many along each coordinate."""
        rows, columns = (len(edges) - 1 for edges in self.edges.values())
        return rows, columns

    @property
    def nodes(self) -> tuple[int, int]:
        """How many corners of cells along each coordinate."""
        return self.cells[0] + 1, self.cells[1] + 1

    @property
    def action_shape(self) -> tuple[int, ...]:
        """How many values of each setting."""
        return tuple(len(values) for values in self.actions.values())

    @property
    def action_count(self) -> int:
        """Number of all combinations of settings."""
        return math.prod(self.action_shape)

    @property
    def sizes(self) -> NDArray[np.float64]:
        """Sizes of a cell along each coordinate, shape (2,)."""
        return np.array([edges[1] - edges[0] for edges in self.edges.values()])

    @property
    def origin(self) -> NDArray[np.float64]:
        """The lowest corner, shape (2,)."""
        return np.array([edges[0] for edges in self.edges.values()])

    def all_actions(self) -> dict[str, NDArray[np.float64]]:
        """Each action's value of each setting, shape (actions,), the last setting running fastest."""
        mesh = np.meshgrid(*self.actions.values(), indexing="ij")
        return {name: values.ravel() for name, values in zip(self.actions, mesh, strict=True)}

    def centers(self, axis: str) -> NDArray[np.float64]:
        """Middles of the cells along a coordinate, shape (cells,)."""
        edges = self.edges[axis]
        middles: NDArray[np.float64] = 0.5 * (edges[1:] + edges[:-1])
        return middles

    def cell_of(self, apices: NDArray[np.float64]) -> NDArray[np.intp]:
        """The cells that hold apices."""
        indices = np.floor((apices - self.origin) / self.sizes)
        inside: NDArray[np.bool_] = np.logical_and.reduce((indices >= 0) & (indices < self.cells), axis=1)
        rows, columns = np.where(inside[:, np.newaxis], indices, 0).astype(np.intp).T
        return np.where(inside, rows * self.cells[1] + columns, -1)


def grid_of(runner: Runner, axes: Any, vary: Any, n: Any) -> Grid:
    """The grid that is asked for."""
    ranges = mapping_of(axes, "axes", "a mapping of both coordinates to ranges (low, high)")
    check_axes(tuple(ranges), REDUCED)
    missing = next((axis for axis in REDUCED if axis not in ranges), None)
    if missing is not None:
        raise InputError(f"axes: without {missing}; allowed: ranges of {' and '.join(REDUCED)}")
    counts = counts_given(n, MAX_CELLS)
    edges = {
        axis: np.linspace(
            *ends_given(f"axes: {axis}", ranges[axis], read=VARIABLES[f"apex.{axis}"].without_units),
            count + 1,
        )
        for axis, count in zip(REDUCED, counts, strict=True)
    }
    for axis, along in edges.items():
        VARIABLES[f"apex.{axis}"].values_of(along, f"axes: {axis}")
    grid = Grid(edges, _actions(runner, vary))
    check_size("grid", math.prod(grid.nodes) * grid.action_count, "strides", MAX_STRIDES)
    return grid


def _actions(runner: Runner, vary: Any) -> dict[str, NDArray[np.float64]]:
    ranges = by_full_name(vary, "vary", "a mapping of settings to ranges (low, high) or (low, high, values)")
    if not ranges:
        raise InputError("vary: nothing; allowed: one or more settings with their ranges")
    actions: dict[str, NDArray[np.float64]] = {}
    for name, span in ranges.items():
        setting_number(name, "vary")
        check_acts(name, runner, tuple(ranges), "vary")
        what = f"vary: {name}"
        row = row_of(span, what, "(low, high) or (low, high, values)")
        count = checked_whole(f"{what}: values", row[2], 1, MAX_ACTIONS) if len(row) == 3 else VALUES
        ends = row[:2] if len(row) == 3 else row
        low, high = ends_given(what, ends, may_be_one=count == 1, read=VARIABLES[name].without_units)
        actions[name] = checked_values(name, np.linspace(low, high, count), "vary", {"value": 0})
    return actions


def starts_at(runner: Runner, apices: NDArray[np.float64]) -> NDArray[np.float64]:
    """Apices of the runner's own map at heights and speeds.

    Of the full model the leg is at rest where the runner's own settings have placed it, as long as it is
    unloaded: what the last placement leaves.
    """
    check_kind(runner, Runner, "runner", "a Runner")
    if runner.reduced:
        return apices
    state = Runner(runner, model="reduced").state_at([1.0, 0.0])
    leg = [state[f"leg.{name}"] for name in ("length", "angle", "length_rate", "angle_rate")]
    return np.column_stack([apices, np.tile(leg, (len(apices), 1))])


NOT_YET = -1
STRIDES_IN_A_CALL = 65_536
"""Each takes 400 bytes of memory."""
STRIDES_IN_A_BLOCK = 65_536


@dataclass(frozen=True, eq=False)
class Transitions:
    """The fate of each pair of a corner and an action, and where it leads."""

    grid: Grid
    """Grid of corners and actions."""
    fate: NDArray[np.int8]
    """Numbers into `library.batch_tables.STRIDE_FATES`, shape (nodes, nodes, actions)."""
    next_apex: NDArray[np.float32]
    """Height and speed, NaN where the stride did not close, shape (2, nodes, nodes, actions)."""

    @property
    def closed(self) -> int:
        """How many strides closed."""
        return int(np.count_nonzero(self.fate == CLOSED))


@dataclass(frozen=True, eq=False)
class Corners:
    """Some rows of corners: a block of work."""

    runner: Runner
    """Who makes the strides."""
    grid: Grid
    """Grid of all corners."""
    rows: tuple[int, ...]
    """Numbers of the rows."""


def strides_of(part: Corners) -> tuple[NDArray[np.int8], NDArray[np.float32]]:
    """All actions from all corners of a block."""
    grid, count = part.grid, part.grid.action_count
    heights, speeds = grid.edges.values()
    nodes = np.array([(height, speed) for height in heights[list(part.rows)] for speed in speeds])
    actions = grid.all_actions()
    fates = np.empty((len(nodes), count), np.int8)
    nexts = np.empty((len(REDUCED), len(nodes), count), np.float32)
    at_once = max(1, STRIDES_IN_A_CALL // count)
    for first in range(0, len(nodes), at_once):
        some = slice(first, first + at_once)
        starts = starts_at(part.runner, nodes[some])
        settings = {name: np.tile(values, len(starts))[:, None] for name, values in actions.items()}
        batch = Batch(part.runner, np.repeat(starts, count, axis=0), inputs=settings)
        run = batch.run(1)
        closed = run.strides == 1
        apices = np.where(closed[:, None], run.apex[:, : len(REDUCED)], np.nan)
        fates[some] = np.where(closed, CLOSED, run.fate).reshape(len(starts), count)
        nexts[:, some] = apices.T.reshape(len(REDUCED), len(starts), count)
    shape = (len(part.rows), len(speeds), count)
    return fates.reshape(shape), nexts.reshape(len(REDUCED), *shape)


def transitions_file(runner: Runner, grid: Grid, path: Path | None = None) -> Resumed:
    """Strides of a grid, of which some may be on file."""
    corners = [f"{axis}_edge" for axis in grid.edges]
    over, shape = (*corners, *grid.actions), (*grid.nodes, *grid.action_shape)
    flags = {
        "flag_values": np.arange(NOT_YET, len(STRIDE_FATES), dtype=np.int8),
        "flag_meanings": " ".join(("not_yet", *STRIDE_FATES)),
    }
    blank = dataset(
        "viability",
        runner.record(),
        {
            "fate": (over, np.full(shape, NOT_YET, np.int8), flags),
            **{f"next_{axis}": (over, np.full(shape, np.nan, np.float32)) for axis in REDUCED},
        },
        dict(zip(corners, grid.edges.values(), strict=True)) | dict(grid.actions),
        tolerance=TOLERANCE,
    )
    return Resumed(path, blank, "viable set")


def make_transitions(
    runner: Runner,
    grid: Grid,
    file: Resumed,
    *,
    executor: Executor | None = None,
    progress: bool = False,
    what: str = "strides",
) -> Transitions:
    """All strides of a grid, made anew but for those on file."""
    fate, corner = file.data["fate"], f"{next(iter(grid.edges))}_edge"
    missing = [row for row, of in enumerate(fate.values) if (of == NOT_YET).any()]
    at_once = max(1, STRIDES_IN_A_BLOCK // math.prod(fate.shape[1:]))
    blocks = [missing[first : first + at_once] for first in range(0, len(missing), at_once)]
    parts = [Corners(runner, grid, tuple(rows)) for rows in blocks]
    with (
        progress_bar(what, fate.size, "strides", progress) as bar,
        run_blocks(strides_of, parts, executor) as results,
    ):
        bar.update((len(fate) - len(missing)) * math.prod(fate.shape[1:]))
        for number, (fates, nexts) in results:
            arrays = dict(zip(("fate", *(f"next_{axis}" for axis in REDUCED)), (fates, *nexts), strict=True))
            shape = (len(blocks[number]), *fate.shape[1:])
            file.write({corner: blocks[number]}, {name: a.reshape(shape) for name, a in arrays.items()})
            bar.update(fates.size)
    flat = (*grid.nodes, grid.action_count)
    nexts = np.stack([file.data[f"next_{axis}"].values.reshape(flat) for axis in REDUCED])
    return Transitions(grid, file.data["fate"].values.reshape(flat), nexts)
