"""Claims about rough ground and slippery patches, and about retraction of the leg there."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial
from typing import Any

from scipy.stats import binomtest

from ...analysis.first_passage import strides_to_fall
from ...analysis.rare_falls import rare_falls
from ...library.gait import Gait
from ...library.ground import RoughGround, correlated_weights
from ...library.laws import AffineLaw
from ...library.runner import Runner
from ..matched import IN_TWO, falls_on_patch, gait_with, match_gait
from .claim import (
    RATE,
    SLIPS,
    STICKS,
    Estimate,
    Measure,
    Measures,
    Regime,
    Which,
    cached_with_errors,
    equal_to,
    gait,
    of,
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
NOISE = 0.01
"""Standard deviation of the sensors' noise, over the scales of the section; smaller where steps are."""
Design = Callable[[Gait], AffineLaw]
"""Designs a law for a gait."""


@cache
def _mean_strides(
    one: Gait, ground: RoughGround, runners: int, max_strides: int, law: AffineLaw | None
) -> Estimate:
    """Mean number of strides until the fall of runners that begin on a gait."""
    found = strides_to_fall(one.runner, ground, runners, max_strides=max_strides, gait=one, law=law)
    return Estimate.of_strides(found)


def strides(
    which: Which,
    roughness: float = LOW,
    draw: tuple[int, int] = (2, 0),
    *,
    runners: int = RUNNERS,
    max_strides: int = MAX_STRIDES,
    design: Design | None = None,
    **ground: Any,
) -> Measure:
    """Mean number of strides of a runner until its fall, under a law of `design` with noisy sensors.

    The ground is drawn by the seed times the first number of `draw` plus the second one; values and
    controls have independent ground.
    """

    def measure(regime: Regime, seed: int) -> Estimate:
        one, law = which(regime), None
        if design is not None:
            noise = (NOISE * regime.step * one.runner.scales).tolist()
            law = replace(design(one), noise=noise, seed=seed)
        steps = RoughGround(roughness * regime.step, draw[0] * seed + draw[1], **ground)
        return _mean_strides(one, steps, runners, max_strides, law)

    return measure


def rarely(regime: Regime, seed: int) -> Estimate:
    """Mean number of strides until the fall of the slipping runner on low steps, by multilevel splitting."""
    one = runner_on(regime, SLIPS)
    found = rare_falls(one.runner, LOWER * regime.step, walkers=WALKERS, seed=seed, gait=one)
    return Estimate.of_strides(found)


def _matched(friction: float, **ground: Any) -> tuple[Measure, Measure]:
    """Strides on a friction, and those of the sticking runner matched to it."""
    control = strides(of(runner_on, STICKS, friction), draw=(2, 1), **ground)
    return strides(of(runner_on, friction), **ground), control


SLIPPING, STICKING, AS_SLIPPING = of(runner_on, SLIPS), of(runner_on, STICKS), of(runner_on, STICKS, SLIPS)
"""The runners that slip and stick, and the sticking one matched to the slipping one."""
ROUGH: Measures = {
    "steps-as-they-come": (strides(SLIPPING), strides(STICKING)),
    "clearance": (over_length(SLIPPING, "foot_clearance"), over_length(STICKING, "foot_clearance")),
    "steps-matched": _matched(SLIPS),
    "steps-matched-0.6": _matched(0.6),
    "steps-matched-to-sticking": (strides(of(runner_on, SLIPS, STICKS), draw=(2, 1)), strides(STICKING)),
    "steps-foot-height": (
        over_length(SLIPPING, "greatest_foot_height"),
        over_length(AS_SLIPPING, "greatest_foot_height"),
    ),
    "steps-that-trip": _matched(SLIPS, trips=True),
    "steps-rare": (rarely, strides(AS_SLIPPING, LOWER, (2, 1))),
    "steps-correlated": _matched(SLIPS, step_weights=correlated_weights(CORRELATION)),
    "segments": _matched(SLIPS, segment_length=SEGMENT),
}


# A slippery patch, on level ground and downhill: the share of runners that fall

DOWNHILL = -4.0
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
    one, reference = (on_slope(regime, friction, DOWNHILL) for friction in (GRIPPY_GROUND, SLIPPERY_GROUND))
    return match_gait(reference, one, *IN_TWO)


def share_that_falls(which: Which) -> Measure:
    """Share of runners that fall on the patch or within so many strides beyond it."""

    @cache
    def measure(regime: Regime, seed: int) -> Estimate:
        falls = falls_on_patch(which(regime), ON_PATCH, LENGTH, PATCH_RUNNERS, seed)
        interval = binomtest(falls, PATCH_RUNNERS).proportion_ci()
        return Estimate(falls / PATCH_RUNNERS, interval.low, interval.high)

    return measure


grippy_downhill = share_that_falls(of(on_slope, GRIPPY_GROUND, DOWNHILL))
slippery_downhill = share_that_falls(of(on_slope, SLIPPERY_GROUND, DOWNHILL))

PATCHES: Measures = {
    "patch-level": (share_that_falls(of(on_slope, GRIPPY_GROUND, 0.0)), grippy_downhill),
    "patch-downhill": (grippy_downhill, slippery_downhill),
    "patch-matched": (share_that_falls(as_fast), slippery_downhill),
}


# Retraction of the leg before touchdown: eigenvalue of height, and strides on rough ground

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


def height(which: Which) -> Measure:
    """Real part of the eigenvalue that belongs to height: the lesser of the two of largest size."""
    return solved(lambda regime: float(min(which(regime).eigenvalues[:2].real)))


def _heights(made: Callable[..., Gait], friction: float, angle: str | None = None) -> tuple[Measure, Measure]:
    """The eigenvalue of height of a runner that retracts its leg, and of the plain one."""
    return height(of(made, friction, angle)), height(of(plain, friction, angle))


PLAIN, RETRACTING, EQUAL = (of(made, SLIPS, None) for made in (plain, retracting, equal))
"""Runners that slip: plain, retracting, and retracting with speed, height and leg angle of the plain one."""
_of_many = partial(strides, runners=RETRACTING_RUNNERS, max_strides=RETRACTING_STRIDES)

RETRACTION: Measures = {
    "retraction-height": _heights(retracting, STICKS),
    "retraction-height-slips": _heights(retracting, SLIPS),
    "retraction-height-flat": _heights(retracting, STICKS, FLAT),
    "retraction-height-matched": _heights(equal, STICKS),
    "retraction-height-matched-0.6": _heights(equal, 0.6),
    "retraction-height-matched-0.2": _heights(equal, SLIPS),
    "retraction-steps": (_of_many(RETRACTING, draw=(2, 1)), _of_many(PLAIN)),
    "retraction-steps-matched": (_of_many(EQUAL, draw=(2, 1)), _of_many(PLAIN)),
    "retraction-slip-matched": (over_length(EQUAL, "slip_distance"), over_length(PLAIN, "slip_distance")),
}

MEASURES = ROUGH | PATCHES | RETRACTION
