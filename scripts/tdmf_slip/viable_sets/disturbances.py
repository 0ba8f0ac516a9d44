"""Disturbances at the next stride that a viable state withstands: drops of the ground, losses of friction."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..checks import checked, shown
from ..errors import InputError
from ..given import row_of
from ..library.runner import Runner
from ..variables.table import FRICTION
from .boxes import boxes_of, lands
from .grid import Grid, Transitions, make_transitions, transitions_file


@dataclass(frozen=True, eq=False)
class FrictionLoss:
    """The least friction of one stride that each cell stands, of those that were tried in turn."""

    frictions: tuple[float, ...]
    """Tried, falling."""
    inner: NDArray[np.float64]
    """For sure, by the estimate of the inner set, shape (rows, columns); NaN of cells that are not in it."""
    outer: NDArray[np.float64]
    """Perhaps; NaN of cells that are not in the outer set."""


def largest_drop(states: NDArray[np.bool_], grid: Grid, *, inner: bool) -> NDArray[np.float64]:
    """How far cells of a set go on above each cell."""
    above = np.zeros(states.shape)
    for row in range(len(states) - 2, -1, -1):
        above[row] = np.where(states[row + 1], above[row + 1] + 1.0, 0.0)
    return np.where(states, (above if inner else above + 1.0) * grid.sizes[0], np.nan)


def friction_loss(
    runner: Runner,
    transitions: Transitions,
    factor: float,
    states: tuple[NDArray[np.bool_], NDArray[np.bool_]],
    frictions: Sequence[float],
    *,
    executor: Executor | None,
    progress: bool,
) -> FrictionLoss:
    """The least friction of the next stride that leaves something viable."""
    tried = _checked_frictions(runner, transitions.grid, frictions)
    stands = list(states)
    minimum = [np.where(of, runner[FRICTION], np.nan) for of in states]
    for friction in tried:
        made = make_transitions(
            runner.replace({FRICTION: friction}),
            transitions.grid,
            transitions_file(runner, transitions.grid),
            executor=executor,
            progress=progress,
            what=f"friction {friction:g}",
        )
        for number, inner in enumerate((True, False)):
            boxes = boxes_of(made, runner.scales[:2], factor, inner=inner)
            into = lands(boxes, states[number], inner=inner)
            lead = np.zeros(states[number].shape, bool)
            lead.flat[boxes.cells[into]] = True
            stands[number] = stands[number] & lead
            minimum[number][stands[number]] = friction
    return FrictionLoss(tried, minimum[0], minimum[1])


def _checked_frictions(runner: Runner, grid: Grid, frictions: Sequence[float]) -> tuple[float, ...]:
    allowed = "one or more numbers, falling, below the runner's own friction"
    if FRICTION in grid.actions:
        raise InputError(f"frictions: {FRICTION} is varied; allowed: where it is not")
    row = row_of(frictions, "frictions", allowed)
    own = runner[FRICTION]
    tried = tuple(checked("frictions", value, 0.0, own) for value in row)
    if not tried or any(b >= a for a, b in zip((own, *tried[:-1]), tried, strict=True)):
        raise InputError(f"frictions = {shown(frictions)} is not allowed; allowed: {allowed} ({own:g})")
    return tried
