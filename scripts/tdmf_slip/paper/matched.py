"""Controls of the figures: runners with the speed, apex height and leg angle of another."""

from collections.abc import Sequence

from ..analysis.comparison import compare
from ..analysis.first_passage import strides_to_fall
from ..analysis.sweeps import gaits_in
from ..errors import GaitNotFoundError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner

HOLD = ("speed", "apex_height", "apex_leg_angle")
"""Quantities to match. They also make the foot equally high at the apex."""
VARY = ("hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor")


def match_gait(reference: Gait, gait: Gait, hold: Sequence[str] = HOLD, vary: Sequence[str] = VARY) -> Gait:
    """The gait of a runner matched to a reference in some quantities; RunError if they cannot be matched."""
    found = match_gaits([reference, gait], hold, vary)
    if not found:
        raise RunError("no matched runner")
    return found[0]


def match_gaits(
    runners: Sequence[Runner | Gait], hold: Sequence[str] = HOLD, vary: Sequence[str] = VARY
) -> list[Gait]:
    """Gaits of all runners but the first, matched to its gait; those that cannot be are left out."""
    found = compare(runners, hold=hold, vary=vary)
    gaits, held = gaits_in(found.sel(step="after")), found["held"].values
    return [gait for gait, of in zip(gaits[1:], held[1:], strict=True) if of.all()]


def gait_with(gait: Gait, name: str, value: float, steps: int = 1) -> Gait:
    """The gait near another with one value changed, approached in steps."""
    begin = gait.runner[name]
    for step in range(1, steps + 1):
        runner = gait.runner.replace({name: begin + (value - begin) * step / steps})
        try:
            gait = gait_near(runner, gait.apex)
        except RunError:
            raise GaitNotFoundError(f"{name} = {value:g}") from None
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
