"""Slopes: the speed uphill, the steepest slope with a gait, and the steepest on which it is stable."""

import math

import numpy as np

from ...errors import RunError
from ...library.fixed_point import gait_near
from ...library.gait import Gait
from .claim import (
    ALL_BUT_HUMAN,
    SLIPS,
    STICKS,
    Check,
    Estimate,
    Measure,
    Regime,
    changed_to,
    gait,
    matched,
    remembered,
    solved,
    stride_quantity,
)

SLOPE = "ground.slope"
FIRST, SHORTEST = 0.005, 1e-5
"""First step of the slope along a branch, and the step at which its fold counts as reached, rad."""
AWAY = 0.1
"""Distance from its prediction, over the scales, beyond which a gait belongs to another branch."""
FLAT = 0.85
"""Touchdown angle that lays the leg flatter than the paper's 40 degrees, rad."""
UPHILL = math.radians(1.5)
"""Slope on which the gaits of both frictions are stable in Table 1, rad."""


def _level(regime: Regime, friction: float, reference: float | None, angle: float | None = None) -> Gait:
    """The gait on level ground, or the runner made equal to the one on friction `reference`."""
    if reference is not None:
        return matched(regime, reference, friction)
    return gait(regime, friction, hip__touchdown_angle=angle)


@remembered
def climb(regime: Regime, friction: float, reference: float | None, angle: float | None) -> tuple[Gait, ...]:
    """Gaits up to the fold at which the branch from level ground turns back."""
    found, step = [_level(regime, friction, reference, angle)], FIRST
    while step > SHORTEST:
        last = found[-1]
        guess = last.apex
        if len(found) > 1:
            guess = guess + (last.apex - found[-2].apex) * step / (_slope(last) - _slope(found[-2]))
        try:
            next_one = gait_near(last.runner.replace({SLOPE: _slope(last) + step}), guess)
        except RunError:
            step *= 0.5
            continue
        if np.max(np.abs(next_one.apex - guess) / last.runner.scales) > AWAY:
            step *= 0.5
            continue
        found.append(next_one)
    return tuple(found)


def _slope(one: Gait) -> float:
    return one.runner[SLOPE]


def steepest(friction: float, angle: float | None = None) -> Measure:
    """Slope of the steepest gait, degrees."""
    return solved(lambda regime: math.degrees(_slope(climb(regime, friction, None, angle)[-1])))


def stable_to(friction: float, angle: float | None = None, reference: float | None = None) -> Measure:
    """Slope of the last stable gait, degrees; the interval ends at the first unstable gait."""

    def degrees(regime: Regime, seed: int) -> Estimate:
        gaits = climb(regime, friction, reference, angle)
        unstable = next((k for k, one in enumerate(gaits) if not one.stable), len(gaits))
        if not unstable:
            raise RunError("unstable")
        last = math.degrees(_slope(gaits[unstable - 1]))
        return Estimate(last, last, math.degrees(_slope(gaits[min(unstable, len(gaits) - 1)])))

    return degrees


def at_the_top(quantity: str, friction: float) -> Measure:
    """A quantity of the steepest gait."""
    return stride_quantity(lambda regime: climb(regime, friction, None, None)[-1], quantity)


def slowed(friction: float, reference: float | None = None) -> Measure:
    """Speed uphill over the speed on level ground."""

    def over(regime: Regime) -> float:
        one = _level(regime, friction, reference)
        uphill = changed_to(one, SLOPE, UPHILL, 6)
        return uphill.stride["speed"] / one.stride["speed"]

    return solved(over)


CHECKS = {
    "slope-speed": Check(
        slowed(SLIPS),
        slowed(STICKS, SLIPS),
        lambda rows: rows.below(*ALL_BUT_HUMAN) and rows["human"].number > 1.0,
    ),
    "slope-steepest": Check(steepest(SLIPS), steepest(STICKS), lambda rows: rows.above(*rows)),
    "slope-top-speed": Check(
        at_the_top("speed", SLIPS),
        stride_quantity(lambda regime: gait(regime, SLIPS), "speed"),
        lambda rows: rows["default"].ratio < 0.05 and rows["clamp"].ratio < 0.25,
    ),
    "slope-stable": Check(
        stable_to(SLIPS), stable_to(STICKS), lambda rows: rows.above("default") and rows.below("clamp")
    ),
    "slope-stable-matched": Check(
        stable_to(SLIPS), stable_to(STICKS, None, SLIPS), lambda rows: 1.0 < rows["default"].ratio < 1.4
    ),
    "slope-flat": Check(
        stable_to(SLIPS, FLAT),
        stable_to(STICKS, FLAT),
        lambda rows: all(rows.above(name) and rows[name].number > 11.2 for name in ALL_BUT_HUMAN),
    ),
    "slope-flat-0.6": Check(
        steepest(0.6, FLAT), steepest(SLIPS, FLAT), lambda rows: rows.below("default") and rows.above("clamp")
    ),
}
