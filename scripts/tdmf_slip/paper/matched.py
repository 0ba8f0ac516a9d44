"""Controls of the figures: runners with the speed, apex height and leg angle of another."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..analysis.along import gaits_over
from ..analysis.comparison import compare
from ..analysis.first_passage import strides_to_fall
from ..analysis.sweeps import gaits_in
from ..errors import GaitNotFoundError, RunError
from ..library.gait import Gait
from ..library.runner import Runner

if TYPE_CHECKING:
    import xarray

HOLD = ("speed", "apex_height", "apex_leg_angle")
"""Quantities to match. They also make the foot equally high at the apex."""
VARY = ("hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor")
IN_TWO = HOLD[:2], VARY[:2]
"""Quantities to match and parameters to vary where the angle of the leg is left free."""


def match_gait(reference: Gait, gait: Gait, hold: Sequence[str] = HOLD, vary: Sequence[str] = VARY) -> Gait:
    """The gait of a runner matched to a reference in some quantities; RunError if they cannot be matched."""
    found = gaits_in(match_gaits([reference, gait], hold, vary))
    if not found:
        raise RunError("no matched runner")
    return found[0]


def match_gaits(
    runners: Sequence[Runner | Gait], hold: Sequence[str] = HOLD, vary: Sequence[str] = VARY
) -> "xarray.Dataset":
    """Gaits of all runners but the first, matched to its gait; those that cannot be are left out."""
    found = compare(runners, hold=hold, vary=vary).sel(step="after")
    return found.isel(runner=np.flatnonzero(found["held"].values.all(axis=1))[1:])


def gait_with(gait: Gait, name: str, value: float) -> Gait:
    """The gait with one value changed, to which the branch from another gait leads."""
    try:
        return next(gaits_over(gait.runner, name, [value], gait))
    except RunError:
        raise GaitNotFoundError(f"{name} = {value:g}") from None


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
