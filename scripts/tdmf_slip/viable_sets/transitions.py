"""Where each action leads from each corner of the cells: strides made by the ensemble engine, in blocks."""

import math
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..blocks import run_blocks
from ..files.resume import Resumed
from ..library.batch import TOLERANCE, Batch
from ..library.batch_tables import CLOSED, STRIDE_FATES
from ..library.runner import Runner
from ..library.section import REDUCED
from ..record import dataset
from ..terminal.progress import progress_bar
from .grid import Grid, starts_at

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
