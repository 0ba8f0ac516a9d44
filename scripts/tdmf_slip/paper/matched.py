"""Controls of the figures: runners with the speed, apex height and leg angle of another."""

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from ..analysis.comparison import compare
from ..analysis.first_passage import FirstPassage, strides_to_fall
from ..blocks import in_order, run_blocks
from ..errors import RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.laws import Law
from ..library.runner import Runner
from ..terminal.progress import progress_bar


@dataclass(frozen=True, eq=False)
class Trial:
    """Runners on one ground: a block of work."""

    runner: Runner
    """Parameters and inputs."""
    roughness: float
    """Standard deviation of a step, m."""
    runners: int
    """Number of runners."""
    seed: int
    """Seed of the ground."""
    max_strides: int
    """A runner that has made as many is still up."""
    law: Law | None = None
    """Law that the runners follow."""


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


HOLD = ("speed", "apex_height", "apex_leg_angle")
"""With these equal the foot is carried as high at the apex, too."""
VARY = ("hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor")


def like(reference: Gait, gait: Gait, hold: Sequence[str] = HOLD, vary: Sequence[str] = VARY) -> Gait | None:
    """A runner made equal to another in what could do what a figure shows."""
    found = compare.plain([reference, gait], hold=hold, vary=vary)
    return None if found.not_held else found.after[1]


def changed(gait: Gait, values: Mapping[str, float], steps: int = 1) -> Gait | None:
    """The gait near another, of other values."""
    begin = {name: gait.runner[name] for name in values}
    for step in range(1, steps + 1):
        runner = gait.runner.replace(
            {name: begin[name] + (value - begin[name]) * step / steps for name, value in values.items()}
        )
        try:
            gait = gait_near(runner, gait.apex)
        except RunError:
            return None
    return gait


def over_friction(gaits: Sequence[Gait], count: int) -> list[Gait]:
    """Some of the gaits, evenly, made equal to the first; those that cannot be are left out."""
    chosen = [gaits[i] for i in np.linspace(0, len(gaits) - 1, count).round().astype(int)]
    equal = [like(gaits[0], gait) for gait in chosen]
    return [gait for gait in equal if gait is not None]
