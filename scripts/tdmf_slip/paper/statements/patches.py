"""A slippery patch, on level ground and downhill: the share of runners that fall."""

import math
from collections.abc import Callable
from functools import cache

from scipy.stats import binomtest

from ...analysis.first_passage import strides_to_fall
from ...analysis.targeted import find_gait
from ...errors import RunError
from ...library.gait import Gait
from .claim import ANGLE, STICKS, TABLE_1, TORQUE, Check, Estimate, Measure, Regime, gait

SLOPE = -4.0
"""Degrees."""
ON_PATCH, LENGTH, BEGIN = 0.02, 300.0, 100.0
"""Friction of the patch, its length and where it begins, l0."""
GRIPPY, SLIPPERY = STICKS, 0.6
"""Frictions of the ground around it."""
RUNNERS, STRIDES_AFTER = 256, 60
"""Runners, each at a random phase of its stride, and the strides that they make beyond the patch."""


def on_slope(regime: Regime, friction: float, degrees: float) -> Gait:
    """The gait of the ground around the patch."""
    return gait(regime, friction, ground__slope=math.radians(degrees))


def as_fast(regime: Regime) -> Gait:
    """The runner downhill on grippy ground with speed and apex height of the one on slippery ground."""
    one, reference = (on_slope(regime, friction, SLOPE) for friction in (GRIPPY, SLIPPERY))
    target = {name: float(reference.stride[name]) for name in ("speed", "apex_height")}
    try:
        return find_gait(one.runner, target=target, vary=(TORQUE, ANGLE), guess=one.apex)
    except RunError as error:
        raise RunError("no matched runner") from error


def falls(of: Callable[[Regime], Gait]) -> Measure:
    """Share of runners that fall on the patch or within so many strides beyond it."""

    @cache
    def measure(regime: Regime, seed: int) -> Estimate:
        one = of(regime)
        length = one.runner["leg.free_length"]
        begin, end = BEGIN * length, (BEGIN + LENGTH) * length
        runner = one.runner.replace(patch_begin=begin, patch_end=end, patch_friction=ON_PATCH)
        strides = int(LENGTH * length / one.stride["length"]) + STRIDES_AFTER
        found = strides_to_fall(runner, 0.0, RUNNERS, seed, strides, gait=one, foot_x="random")
        interval = binomtest(found.falls, RUNNERS).proportion_ci()
        return Estimate(found.falls / RUNNERS, interval.low, interval.high)

    return measure


grippy_downhill = falls(lambda regime: on_slope(regime, GRIPPY, SLOPE))
slippery_downhill = falls(lambda regime: on_slope(regime, SLIPPERY, SLOPE))

CHECKS = {
    "patch-level": Check(
        falls(lambda regime: on_slope(regime, GRIPPY, 0.0)),
        grippy_downhill,
        lambda rows: rows.below(*TABLE_1) and all(rows[name].number == 1.0 for name in ("heavy", "human")),
    ),
    "patch-downhill": Check(grippy_downhill, slippery_downhill, lambda rows: rows.above(*TABLE_1)),
    "patch-matched": Check(falls(as_fast), slippery_downhill, lambda rows: rows.above(*TABLE_1)),
}
