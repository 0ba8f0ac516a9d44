"""Strides until the fall of many runners, or on ground of many kinds, side by side."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

from ..analysis.first_passage import FirstPassage, strides_to_fall
from ..blocks import in_order, run_blocks
from ..library.laws import Law
from ..library.runner import Runner
from ..terminal.progress import progress_bar


@dataclass(frozen=True, eq=False)
class Trial:
    """Who runs on what: a block of work."""

    runner: Runner
    """Parameters and inputs."""
    roughness: float
    """Standard deviation of a step, m."""
    runners: int
    """How many run."""
    seed: int
    """Seed of the ground."""
    max_strides: int
    """A runner that has made as many is still up."""
    law: Law | None = None
    """By which the runners are set."""


def first_passage(trial: Trial) -> FirstPassage:
    """Strides until the fall of one trial."""
    return strides_to_fall(
        trial.runner,
        trial.roughness,
        trial.runners,
        trial.seed,
        trial.max_strides,
        law=trial.law,
    )


def first_passages(
    trials: Sequence[Trial], *, executor: Executor | None = None, progress: bool = False
) -> list[FirstPassage]:
    """`first_passage` of many trials, side by side."""
    with (
        progress_bar("rough", len(trials), "means", progress) as bar,
        run_blocks(first_passage, trials, executor) as results,
    ):
        return in_order(results, lambda _: bar.update())
