"""Retraction of the leg before touchdown: eigenvalue of height, and strides on rough ground."""

import math
from collections.abc import Callable
from functools import cache

from ...analysis.first_passage import strides_to_fall
from ...library.gait import Gait
from ...library.ground import RoughGround
from ...library.runner import Runner
from .claim import (
    ALL_BUT_HUMAN,
    SLIPS,
    STICKS,
    Check,
    Estimate,
    Measure,
    Regime,
    changed_to,
    equal_to,
    gait,
    over_length,
    remembered,
    solved,
)
from .rough import LOW

RATE = "hip.retraction_rate"
RETRACTS, STEPS = 0.008, 4
"""Rate of retraction over sqrt(k/m), and the number of steps along the branch to this rate."""
RUNNERS, MAX_STRIDES = 400, 400
FLAT = "45 deg"
"""Touchdown angle that lays the leg flatter than the 40 degrees of Table 1."""


def plain(regime: Regime, friction: float, angle: str | None) -> Gait:
    """The gait with the regime's own rate of retraction."""
    return gait(regime, friction, hip__touchdown_angle=angle)


def faster(runner: Runner) -> float:
    """The runner's own rate of retraction with `RETRACTS` added."""
    values = runner
    return values[RATE] + RETRACTS * math.sqrt(values["leg.stiffness"] / values["body.mass"])


@remembered
def retracting(regime: Regime, friction: float, angle: str | None = None) -> Gait:
    """The gait with `RETRACTS` added to the regime's own rate of retraction."""
    one = plain(regime, friction, angle)
    return changed_to(one, RATE, faster(one.runner), STEPS)


@remembered
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


def strides(which: Which) -> Measure:
    """Mean number of strides until the fall on steps."""

    @cache
    def measure(regime: Regime, seed: int) -> Estimate:
        one = which(regime, SLIPS, None)
        ground = RoughGround(LOW * regime.step, 2 * seed + (which is not plain))
        found = strides_to_fall(one.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=one)
        return Estimate.of_strides(found)

    return measure


CHECKS = {
    "retraction-height": Check(
        height(retracting, STICKS),
        height(plain, STICKS),
        lambda rows: rows.above("default") and rows.below("clamp"),
    ),
    "retraction-height-slips": Check(
        height(retracting, SLIPS), height(plain, SLIPS), lambda rows: rows.below("default", "clamp")
    ),
    "retraction-height-flat": Check(
        height(retracting, STICKS, FLAT),
        height(plain, STICKS, FLAT),
        lambda rows: rows.below("default", "clamp"),
    ),
    "retraction-height-matched": Check(
        height(equal, STICKS), height(plain, STICKS), lambda rows: rows.below("default", "clamp")
    ),
    "retraction-height-matched-0.6": Check(
        height(equal, 0.6), height(plain, 0.6), lambda rows: rows.below("default", "clamp")
    ),
    "retraction-height-matched-0.2": Check(
        height(equal, SLIPS), height(plain, SLIPS), lambda rows: rows.below("default", "clamp")
    ),
    "retraction-steps": Check(
        strides(retracting), strides(plain), lambda rows: rows.below("default", "clamp")
    ),
    "retraction-steps-matched": Check(
        strides(equal),
        strides(plain),
        lambda rows: rows.below("default", "clamp") and not rows.below("heavy"),
    ),
    "retraction-slip-matched": Check(
        slip(equal), slip(plain), lambda rows: all(rows[name].ratio < 1.0 for name in ALL_BUT_HUMAN)
    ),
}
