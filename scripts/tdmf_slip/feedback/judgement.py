"""Value of a feedback: region of attraction, largest disturbances, and how long a runner stays up.

The largest eigenvalue says nothing of these: settings have limits, sensors are noisy, and disturbances large.
"""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace

from ..analysis.attraction import Robustness, Volume, robustness, volume
from ..analysis.first_passage import FirstPassage, strides_to_fall
from ..blocks import in_order, run_blocks
from ..checks import check_kind
from ..given import row_of
from ..library.gait import Gait, check_is_gait
from ..library.ground import RoughGround
from ..library.laws import AffineLaw, Law, check_law
from ..terminal.progress import progress_bar

SAMPLES = 4000
"""Starts drawn for the region of attraction."""
RUNNERS, MAX_STRIDES = 256, 400
"""On rough ground."""


@dataclass(frozen=True, eq=False)
class Trial:
    """A gait, with a feedback or without: a block of work."""

    gait: Gait
    """The gait."""
    law: Law | None
    """Law that holds the gait; None for the runner as it is."""
    roughness: tuple[float, ...]
    """Standard deviations of a step of the ground, m."""
    seed: int = 0
    """Seed of starts and ground."""

    def __post_init__(self) -> None:
        """Refuse a ground that cannot be, before a judgement has taken seconds."""
        for roughness in self.roughness:
            RoughGround(roughness, self.seed)


@dataclass(frozen=True, eq=False)
class Judgement:
    """How well a gait is held, by many runs."""

    trial: Trial
    """Which gait, by which feedback."""
    volume: Volume
    """How much of the box of `analysis.attraction` settles on the gait; without noise."""
    robustness: Robustness
    """The largest disturbances that the runner recovers from; without noise."""
    first_passages: tuple[FirstPassage, ...]
    """Strides until the fall on ground of each roughness, with the noise of the law's sensors."""


def judge(gait: Gait, law: Law | None = None, *, roughness: Sequence[float] = (), seed: int = 0) -> Judgement:
    """How well a feedback holds a gait, within its limits."""
    check_is_gait(gait, "gait")
    check_law(law, gait.runner)
    steps = row_of(roughness, "roughness", "numbers in a list, m")
    return _judged(Trial(gait, law, tuple(steps), seed))


def judge_all(
    trials: Sequence[Trial], *, executor: Executor | None = None, progress: bool = False
) -> list[Judgement]:
    """`judge` for many gaits and feedbacks, side by side."""
    check_kind(trials, Sequence, "trials", "Trials in a list")
    for trial in trials:
        check_kind(trial, Trial, "trials", "Trials in a list")
    with (
        progress_bar("feedback", len(trials), "laws", progress) as bar,
        run_blocks(_judged, trials, executor) as results,
    ):
        return in_order(results, lambda _: bar.update())


def _judged(trial: Trial) -> Judgement:
    quiet = replace(trial.law, noise=None) if isinstance(trial.law, AffineLaw) else trial.law
    return Judgement(
        trial,
        volume(trial.gait, SAMPLES, seed=trial.seed, law=quiet),
        robustness(trial.gait, law=quiet),
        tuple(
            strides_to_fall(
                trial.gait.runner,
                roughness,
                RUNNERS,
                trial.seed,
                MAX_STRIDES,
                gait=trial.gait,
                law=trial.law,
            )
            for roughness in trial.roughness
        ),
    )
