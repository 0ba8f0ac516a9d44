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
    ANGLE,
    SLIPS,
    STICKS,
    Estimate,
    Measure,
    OwnClaim,
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
GAIT = f"tdmf-slip gait --friction {{}} --set {RATE}={RETRACTS} --json"
ROUGH = (
    f"tdmf-slip rough --friction {SLIPS} --set {RATE}={RETRACTS} --roughness {LOW} "
    f"--runners {RUNNERS} --max-strides {MAX_STRIDES} --seed {{seed}}"
)


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


CLAIMS = (
    OwnClaim(
        "retraction-height",
        "At friction 10, retraction at 0.008 √(k/m) brings the second eigenvalue nearer to 0, except with "
        "the clamp. Real part of the second eigenvalue. Value: with retraction. Control: without.",
        height(retracting, STICKS),
        height(plain, STICKS),
        GAIT.format(STICKS),
        lambda rows: rows["default"].above and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-slips",
        "At friction 0.2 retraction drives the second eigenvalue towards −1 in both readings. Value and "
        "control as in row 1.",
        height(retracting, SLIPS),
        height(plain, SLIPS),
        GAIT.format(SLIPS),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-flat",
        "At friction 10 and a touchdown angle of 45° retraction drives it towards −1 in both readings, too."
        " Value and control as in row 1.",
        height(retracting, STICKS, FLAT),
        height(plain, STICKS, FLAT),
        f"{GAIT.format(STICKS)} --set {ANGLE}=45deg",
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-matched",
        "In runners matched to the one without retraction, retraction drives the second eigenvalue towards "
        "−1 in both readings: friction 10. Value: with retraction, matched. Control: without.",
        height(equal, STICKS),
        height(plain, STICKS),
        GAIT.format(STICKS),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-matched-0.6",
        "As in row 4, at friction 0.6.",
        height(equal, 0.6),
        height(plain, 0.6),
        GAIT.format(0.6),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-matched-0.2",
        "As in row 4, at friction 0.2.",
        height(equal, SLIPS),
        height(plain, SLIPS),
        GAIT.format(SLIPS),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-steps",
        "Retraction shortens runs on steps of 0.3 l₀ on friction 0.2. Strides until the fall. Value: with "
        "retraction at 0.008 √(k/m). Control: without.",
        strides(retracting),
        strides(plain),
        ROUGH,
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-steps-matched",
        "Retraction also shortens the runs of matched runners, which carry the foot equally high, except at"
        " weight 0.022 and 45°. Value: with retraction, matched. Control: without.",
        strides(equal),
        strides(plain),
        ROUGH,
        lambda rows: rows["default"].below and rows["clamp"].below and not rows["heavy"].below,
    ),
    OwnClaim(
        "retraction-slip-matched",
        "On friction 0.2 matched runners with retraction slip less per stride, l₀. Value: with retraction, "
        "matched. Control: without.",
        slip(equal),
        slip(plain),
        GAIT.format(SLIPS),
        lambda rows: all(rows[name].ratio < 1.0 for name in ALL_BUT_HUMAN),
    ),
)
