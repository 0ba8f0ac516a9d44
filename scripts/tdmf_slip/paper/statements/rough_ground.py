"""Claims about rough ground and slippery patches, and about retraction of the leg there."""

import math
from collections.abc import Callable
from functools import cache
from typing import Any

from scipy.stats import binomtest

from ...analysis.first_passage import strides_to_fall
from ...analysis.rare_falls import rare_falls
from ...library.gait import Gait
from ...library.ground import RoughGround, correlated_weights
from ...library.laws import AffineLaw
from ...library.runner import Runner
from ..matched import falls_on_patch, gait_with, match_gait
from .claim import (
    ANGLE,
    SLIPS,
    STICKS,
    TORQUE,
    Estimate,
    Measure,
    Measures,
    Regime,
    cached_with_errors,
    equal_to,
    gait,
    over_length,
    runner_on,
    solved,
)

# Rough ground: strides until the fall, and how they depend on the height of the foot

RUNNERS, MAX_STRIDES = 256, 300
"""200 falls give a mean to 15 %, with a confidence of 95 %; a runner still up at the end is censored."""
LOW = 0.3
"""Standard deviation of the ground's steps, or of the segments' heights, l0 in Table 1."""
LOWER, WALKERS = 0.2, 16
"""Steps on which falls are too rare to be counted, and walkers at each level of the splitting."""
CORRELATION = 0.7
"""Correlation of each step with the step before: such ground goes on rising or falling."""
SEGMENT = 5.0
"""Length of a level segment, l0."""


@cache
def mean_strides(
    one: Gait,
    ground: RoughGround,
    runners: int = RUNNERS,
    max_strides: int = MAX_STRIDES,
    law: AffineLaw | None = None,
) -> Estimate:
    """Mean number of strides until the fall of runners that begin on a gait."""
    found = strides_to_fall(one.runner, ground, runners, max_strides=max_strides, gait=one, law=law)
    return Estimate.of_strides(found)


def strides(
    friction: float,
    roughness: float,
    reference: float | None = None,
    *,
    correlation: float = 0.0,
    segment: float = 0.0,
    trips: bool = False,
) -> Measure:
    """Mean number of strides until the fall of the runner of `runner_on`."""

    def measure(regime: Regime, seed: int) -> Estimate:
        ground = RoughGround(
            roughness * regime.step,
            2 * seed + (reference is not None),  # value and control have independent ground
            correlated_weights(correlation),
            segment_length=segment,
            trips=trips,
        )
        return mean_strides(runner_on(regime, friction, reference), ground)

    return measure


def rarely(regime: Regime, seed: int) -> Estimate:
    """Mean number of strides until the fall of the slipping runner on low steps, by multilevel splitting."""
    one = runner_on(regime, SLIPS)
    found = rare_falls(one.runner, LOWER * regime.step, walkers=WALKERS, seed=seed, gait=one)
    return Estimate.of_strides(found)


def foot(quantity: str, friction: float, reference: float | None = None) -> Measure:
    """A height of the foot above the ground, over the leg's length."""
    return over_length(lambda regime: runner_on(regime, friction, reference), quantity)


def _matched(friction: float, **ground: Any) -> tuple[Measure, Measure]:
    """Strides on a friction, and those of the sticking runner matched to it."""
    return strides(friction, LOW, **ground), strides(STICKS, LOW, friction, **ground)


ROUGH: Measures = {
    "steps-as-they-come": (strides(SLIPS, LOW), strides(STICKS, LOW)),
    "clearance": (foot("foot_clearance", SLIPS), foot("foot_clearance", STICKS)),
    "steps-matched": _matched(SLIPS),
    "steps-matched-0.6": _matched(0.6),
    "steps-matched-to-sticking": (strides(SLIPS, LOW, STICKS), strides(STICKS, LOW)),
    "steps-foot-height": (
        foot("greatest_foot_height", SLIPS),
        foot("greatest_foot_height", STICKS, SLIPS),
    ),
    "steps-that-trip": _matched(SLIPS, trips=True),
    "steps-rare": (rarely, strides(STICKS, LOWER, SLIPS)),
    "steps-correlated": _matched(SLIPS, correlation=CORRELATION),
    "segments": _matched(SLIPS, segment=SEGMENT),
}


# A slippery patch, on level ground and downhill: the share of runners that fall

SLOPE = -4.0
"""Slope, degrees."""
ON_PATCH, LENGTH = 0.02, 300.0
"""Friction of the patch, and its length, l0."""
GRIPPY_GROUND, SLIPPERY_GROUND = STICKS, 0.6
"""Frictions of the ground around it."""
PATCH_RUNNERS = 256


def on_slope(regime: Regime, friction: float, degrees: float) -> Gait:
    """The gait of the ground around the patch."""
    return gait(regime, friction, ground__slope=math.radians(degrees))


def as_fast(regime: Regime) -> Gait:
    """The runner downhill on grippy ground with speed and apex height of the one on slippery ground."""
    one, reference = (on_slope(regime, friction, SLOPE) for friction in (GRIPPY_GROUND, SLIPPERY_GROUND))
    return match_gait(reference, one, ("speed", "apex_height"), (TORQUE, ANGLE))


def share_that_falls(of: Callable[[Regime], Gait]) -> Measure:
    """Share of runners that fall on the patch or within so many strides beyond it."""

    @cache
    def measure(regime: Regime, seed: int) -> Estimate:
        falls = falls_on_patch(of(regime), ON_PATCH, LENGTH, PATCH_RUNNERS, seed)
        interval = binomtest(falls, PATCH_RUNNERS).proportion_ci()
        return Estimate(falls / PATCH_RUNNERS, interval.low, interval.high)

    return measure


grippy_downhill = share_that_falls(lambda regime: on_slope(regime, GRIPPY_GROUND, SLOPE))
slippery_downhill = share_that_falls(lambda regime: on_slope(regime, SLIPPERY_GROUND, SLOPE))

PATCHES: Measures = {
    "patch-level": (share_that_falls(lambda regime: on_slope(regime, GRIPPY_GROUND, 0.0)), grippy_downhill),
    "patch-downhill": (grippy_downhill, slippery_downhill),
    "patch-matched": (share_that_falls(as_fast), slippery_downhill),
}


# Retraction of the leg before touchdown: eigenvalue of height, and strides on rough ground

RATE = "hip.retraction_rate"
RETRACTS = 0.008
"""Rate of retraction over sqrt(k/m)."""
RETRACTING_RUNNERS, RETRACTING_STRIDES = 400, 400
FLAT = "45 deg"
"""Touchdown angle that lays the leg flatter than the 40 degrees of Table 1."""


def plain(regime: Regime, friction: float, angle: str | None) -> Gait:
    """The gait with the regime's own rate of retraction."""
    return gait(regime, friction, hip__touchdown_angle=angle)


def faster(runner: Runner) -> float:
    """The runner's own rate of retraction with `RETRACTS` added."""
    return runner[RATE] + RETRACTS * math.sqrt(runner["leg.stiffness"] / runner["body.mass"])


@cached_with_errors
def retracting(regime: Regime, friction: float, angle: str | None = None) -> Gait:
    """The gait with `RETRACTS` added to the regime's own rate of retraction."""
    one = plain(regime, friction, angle)
    return gait_with(one, RATE, faster(one.runner))


@cached_with_errors
def equal(regime: Regime, friction: float, angle: str | None = None) -> Gait:
    """The retracting gait with speed, apex height and leg angle of the plain gait."""
    return equal_to(plain(regime, friction, angle), retracting(regime, friction, angle))


Which = Callable[[Regime, float, str | None], Gait]


def height(which: Which, friction: float, angle: str | None = None) -> Measure:
    """Real part of the eigenvalue that belongs to height: the lesser of the two of largest size."""
    return solved(lambda regime: float(min(which(regime, friction, angle).eigenvalues[:2].real)))


def slip(which: Which) -> Measure:
    """Slip distance in a stride, over the leg's length."""
    return over_length(lambda regime: which(regime, SLIPS, None), "slip_distance")


def strides_of(which: Which) -> Measure:
    """Mean number of strides until the fall on steps."""

    def measure(regime: Regime, seed: int) -> Estimate:
        ground = RoughGround(LOW * regime.step, 2 * seed + (which is not plain))
        return mean_strides(which(regime, SLIPS, None), ground, RETRACTING_RUNNERS, RETRACTING_STRIDES)

    return measure


RETRACTION: Measures = {
    "retraction-height": (height(retracting, STICKS), height(plain, STICKS)),
    "retraction-height-slips": (height(retracting, SLIPS), height(plain, SLIPS)),
    "retraction-height-flat": (height(retracting, STICKS, FLAT), height(plain, STICKS, FLAT)),
    "retraction-height-matched": (height(equal, STICKS), height(plain, STICKS)),
    "retraction-height-matched-0.6": (height(equal, 0.6), height(plain, 0.6)),
    "retraction-height-matched-0.2": (height(equal, SLIPS), height(plain, SLIPS)),
    "retraction-steps": (strides_of(retracting), strides_of(plain)),
    "retraction-steps-matched": (strides_of(equal), strides_of(plain)),
    "retraction-slip-matched": (slip(equal), slip(plain)),
}

MEASURES = ROUGH | PATCHES | RETRACTION
