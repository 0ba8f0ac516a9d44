"""Controls of the figures: runners with the speed, apex height and leg angle of another."""

from collections.abc import Mapping, Sequence

import numpy as np

from ..analysis.comparison import compare
from ..analysis.first_passage import strides_to_fall
from ..analysis.sweeps import gaits_in
from ..errors import RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..variables.table import FRICTION

HOLD = ("speed", "apex_height", "apex_leg_angle")
"""Quantities to match. They also make the foot equally high at the apex."""
VARY = ("hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor")


def match_gait(
    reference: Gait, gait: Gait, hold: Sequence[str] = HOLD, vary: Sequence[str] = VARY
) -> Gait | None:
    """The gait of a runner matched to a reference in some quantities; None if they cannot be matched."""
    return _matched([reference, gait], hold, vary)[0]


def gait_with(gait: Gait, values: Mapping[str, float], steps: int = 1) -> Gait | None:
    """The gait near another, with other values of the runner, approached in steps; None if there is none."""
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


AFTER = 60
"""Strides beyond a patch after which a runner has survived it."""
PATCH_BEGIN = 100.0
"""Beginning of a patch, over the leg's length."""


def falls_on_patch(gait: Gait, friction: float, length: float, runners: int, seed: int = 0) -> int:
    """Number of runners that fall on a patch or soon after it, each arriving at its own phase of the gait.

    The length of the patch is over that of the leg.
    """
    leg = gait.runner["leg.free_length"]
    begin, end = PATCH_BEGIN * leg, (PATCH_BEGIN + length) * leg
    runner = gait.runner.replace(patch_begin=begin, patch_end=end, patch_friction=friction)
    strides = int(length * leg / gait.stride["length"]) + AFTER
    return strides_to_fall(runner, 0.0, runners, seed, strides, gait=gait, foot_x="random").falls


def over_friction(gaits: Sequence[Gait], count: int) -> list[Gait]:
    """Some of the gaits, evenly, made equal to the first; those that cannot be matched are left out."""
    chosen = [gaits[i] for i in np.linspace(0, len(gaits) - 1, count).round().astype(int)]
    equal = [match_gait(gaits[0], gait) for gait in chosen]
    return [gait for gait in equal if gait is not None]


def at_frictions(
    runner: Runner,
    reference: float,
    frictions: Sequence[float],
    hold: Sequence[str] = HOLD,
    vary: Sequence[str] = VARY,
) -> list[Gait]:
    """Gaits at some frictions, made equal to the one at a reference; those that cannot be are left out."""
    runners = [runner.replace({FRICTION: friction}) for friction in (reference, *frictions)]
    return [gait for gait in _matched(runners, hold, vary) if gait is not None]


def _matched(runners: Sequence[Runner | Gait], hold: Sequence[str], vary: Sequence[str]) -> list[Gait | None]:
    """Gaits of all runners but the first, made equal to its gait; None for one that cannot be."""
    found = compare(runners, hold=hold, vary=vary)
    gaits, held = gaits_in(found.sel(step="after")), found["held"].values
    return [gait if of.all() else None for gait, of in zip(gaits[1:], held[1:], strict=True)]
