"""Where each action leads from each corner of the cells: strides made by the ensemble engine, in blocks."""

import math
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..blocks import run_blocks
from ..errors import InputError
from ..library.batch import TOLERANCE, Batch
from ..library.batch_tables import CLOSED, STRIDE_FATES
from ..library.runner import Runner
from ..library.section import REDUCED
from ..record import attributes_of
from ..terminal.progress import progress_bar
from .grid import Grid, starts_at

if TYPE_CHECKING:
    from ..files.datasets import xarray

NOT_YET = -1
STRIDES_IN_A_CALL = 65_536
"""Each takes 400 bytes of memory."""
STRIDES_IN_A_BLOCK = 65_536
SAVED = 16
"""Times that a file is written, at the most, before the strides are all made."""


@dataclass(frozen=True, eq=False)
class Transitions:
    """The fate of each pair of a corner and an action, and where it leads."""

    grid: Grid
    """Of corners and actions."""
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
    """Of all corners."""
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


def make_transitions(
    runner: Runner,
    grid: Grid,
    *,
    path: Path | None = None,
    executor: Executor | None = None,
    progress: bool = False,
    what: str = "strides",
) -> Transitions:
    """All strides of a grid, made anew but for those on file."""
    shape = (*grid.nodes, grid.action_count)
    made = Transitions(
        grid, np.full(shape, NOT_YET, np.int8), np.full((len(REDUCED), *shape), np.nan, np.float32)
    )
    if path is not None:
        _take_up(path, runner, made)
    missing = [row for row in range(shape[0]) if (made.fate[row] == NOT_YET).any()]
    at_once = max(1, STRIDES_IN_A_BLOCK // math.prod(shape[1:]))
    blocks = [missing[first : first + at_once] for first in range(0, len(missing), at_once)]
    parts = [Corners(runner, grid, tuple(rows)) for rows in blocks]
    saved_each, unsaved = math.ceil(len(blocks) / SAVED), 0
    with (
        progress_bar(what, made.fate.size, "strides", progress) as bar,
        run_blocks(strides_of, parts, executor) as results,
    ):
        bar.update((shape[0] - len(missing)) * math.prod(shape[1:]))
        for number, (fates, nexts) in results:
            made.fate[blocks[number]], made.next_apex[:, blocks[number]] = fates, nexts
            bar.update(fates.size)
            unsaved += 1
            if path is not None and unsaved >= saved_each:
                _save(path, runner, made)
                unsaved = 0
    return made


def dataset_of(runner: Runner, made: Transitions) -> "xarray.Dataset":
    """Transitions as a dataset."""
    from ..files.datasets import xarray  # slow to load

    grid = made.grid
    corners = [f"{axis}_edge" for axis in grid.edges]
    over, shape = (*corners, *grid.actions), (*grid.nodes, *grid.action_shape)
    data = xarray.Dataset(
        {"fate": (over, made.fate.reshape(shape))}
        | {f"next_{axis}": (over, made.next_apex[k].reshape(shape)) for k, axis in enumerate(REDUCED)},
        coords=dict(zip(corners, grid.edges.values(), strict=True)) | dict(grid.actions),
    )
    data["fate"].attrs = {
        "flag_values": np.arange(NOT_YET, len(STRIDE_FATES), dtype=np.int8),
        "flag_meanings": " ".join(("not_yet", *STRIDE_FATES)),
    }
    data.attrs = {**attributes_of(runner.record()), "tolerance": TOLERANCE}
    return data


def _take_up(path: Path, runner: Runner, made: Transitions) -> None:
    """Take what a file holds already."""
    from ..files.resume import resumed  # loads xarray

    data = resumed(path, dataset_of(runner, made), "viable set")
    made.fate[...] = data["fate"].values.reshape(made.fate.shape)
    for k, axis in enumerate(REDUCED):
        made.next_apex[k] = data[f"next_{axis}"].values.reshape(made.fate.shape)
    known = (made.fate >= NOT_YET) & (made.fate < len(STRIDE_FATES))
    fits = known & (np.isfinite(made.next_apex) == (made.fate == CLOSED)).all(axis=0)
    if not fits.all():
        row, column, action = np.argwhere(~fits)[0]
        where = ", ".join(
            f"{axis}_edge {at}" for axis, at in zip(made.grid.edges, (row, column), strict=True)
        )
        raise InputError(
            f"{path}: holds another viable set, at {where} with fate {made.fate[row, column, action]} and a "
            f"next apex of {made.next_apex[:, row, column, action].tolist()}; allowed: another file name"
        )


def _save(path: Path, runner: Runner, made: Transitions) -> None:
    from ..files.netcdf import write_dataset  # loads xarray

    write_dataset(path, dataset_of(runner, made))
