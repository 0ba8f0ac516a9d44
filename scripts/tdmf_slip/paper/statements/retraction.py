"""Retraction of the leg before touchdown: eigenvalue of height, and strides on rough ground."""

import math
from collections.abc import Callable
from functools import cache

from ...analysis.first_passage import strides_to_fall
from ...library.gait import Gait
from ...library.rough_ground import RoughGround
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
    values = runner.values
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
        "Retraction at 0.008 √(k/m) brings the eigenvalue of height nearer to 0 at friction 10 (real part; "
        "control: without retraction). With the clamp it drives it towards −1.",
        height(retracting, STICKS),
        height(plain, STICKS),
        GAIT.format(STICKS),
        lambda rows: rows["default"].above and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-slips",
        "This does not hold at every friction: at friction 0.2 retraction drives the eigenvalue towards −1 "
        "by both readings.",
        height(retracting, SLIPS),
        height(plain, SLIPS),
        GAIT.format(SLIPS),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-flat",
        "This does not hold at every touchdown angle either: at 45° and friction 10 retraction drives the "
        "eigenvalue towards −1 by both readings.",
        height(retracting, STICKS, FLAT),
        height(plain, STICKS, FLAT),
        f"{GAIT.format(STICKS)} --set {ANGLE}=45deg",
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-matched",
        "At equal speed, apex height and leg angle retraction drives the eigenvalue of height towards −1 by "
        "both readings: friction 10.",
        height(equal, STICKS),
        height(plain, STICKS),
        GAIT.format(STICKS),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-matched-0.6",
        "The same at friction 0.6.",
        height(equal, 0.6),
        height(plain, 0.6),
        GAIT.format(0.6),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-height-matched-0.2",
        "The same at friction 0.2.",
        height(equal, SLIPS),
        height(plain, SLIPS),
        GAIT.format(SLIPS),
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-steps",
        "On steps of 0.3 l₀ retraction at 0.008 √(k/m) shortens runs on friction 0.2: strides until the "
        "fall (control: without retraction).",
        strides(retracting),
        strides(plain),
        ROUGH,
        lambda rows: rows["default"].below and rows["clamp"].below,
    ),
    OwnClaim(
        "retraction-steps-matched",
        "Retraction also shortens runs at equal speed, apex height and leg angle, where the foot is carried "
        "equally high. At weight 0.022 and 45° it does not.",
        strides(equal),
        strides(plain),
        ROUGH,
        lambda rows: rows["default"].below and rows["clamp"].below and not rows["heavy"].below,
    ),
    OwnClaim(
        "retraction-slip-matched",
        "At equal speed, apex height and leg angle a stride on friction 0.2 slips less with retraction: "
        "slip distance, l₀.",
        slip(equal),
        slip(plain),
        GAIT.format(SLIPS),
        lambda rows: all(rows[name].ratio < 1.0 for name in ALL_BUT_HUMAN),
    ),
)
