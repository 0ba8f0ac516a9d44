"""Rough ground: strides until the fall, and how they depend on the height of the foot."""

from functools import cache

from ...analysis.first_passage import FirstPassage, strides_to_fall
from ...analysis.rare_falls import rare_falls
from ...library.gait import Gait
from ...library.ground import RoughGround, correlated_weights
from .claim import SLIPS, STICKS, Check, Estimate, Measure, Regime, matched, over_length, stable_gait

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


def runner_on(regime: Regime, friction: float, reference: float | None) -> Gait:
    """The runner on a friction, as it comes or made equal to the runner on friction `reference`."""
    return stable_gait(regime, friction) if reference is None else matched(regime, reference, friction)


@cache
def falls(regime: Regime, friction: float, reference: float | None, ground: RoughGround) -> FirstPassage:
    """Run all runners until they fall or have made `MAX_STRIDES` strides."""
    one = runner_on(regime, friction, reference)
    return strides_to_fall(one.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=one)


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
        return Estimate.of_strides(falls(regime, friction, reference, ground))

    return measure


def rarely(regime: Regime, seed: int) -> Estimate:
    """Mean number of strides until the fall of the slipping runner on low steps, by multilevel splitting."""
    one = stable_gait(regime, SLIPS)
    found = rare_falls(one.runner, LOWER * regime.step, walkers=WALKERS, seed=seed, gait=one)
    return Estimate.of_strides(found)


def foot(quantity: str, friction: float, reference: float | None = None) -> Measure:
    """A height of the foot above the ground, over the leg's length."""
    return over_length(lambda regime: runner_on(regime, friction, reference), quantity)


CHECKS = {
    "steps-as-they-come": Check(strides(SLIPS, LOW), strides(STICKS, LOW), lambda rows: rows.above(*rows)),
    "clearance": Check(
        foot("foot_clearance", SLIPS), foot("foot_clearance", STICKS), lambda rows: rows.above(*rows)
    ),
    "steps-matched": Check(
        strides(SLIPS, LOW),
        strides(STICKS, LOW, SLIPS),
        lambda rows: (
            rows.above("default")
            and rows["default"].ratio > 5.0
            and rows.above("heavy")
            and not rows.above("clamp")
        ),
    ),
    "steps-matched-0.6": Check(
        strides(0.6, LOW), strides(STICKS, LOW, 0.6), lambda rows: rows.above("default", "heavy")
    ),
    "steps-matched-to-sticking": Check(
        strides(SLIPS, LOW, STICKS),
        strides(STICKS, LOW),
        lambda rows: rows.above("default", "heavy") and not rows.above("clamp"),
    ),
    "steps-foot-height": Check(
        foot("greatest_foot_height", SLIPS),
        foot("greatest_foot_height", STICKS, SLIPS),
        lambda rows: rows.below("default", "heavy"),
    ),
    "steps-that-trip": Check(
        strides(SLIPS, LOW, trips=True),
        strides(STICKS, LOW, SLIPS, trips=True),
        lambda rows: rows["default"].ratio < 2.0 and rows["heavy"].ratio < 2.0,
    ),
    "steps-rare": Check(
        rarely,
        strides(STICKS, LOWER, SLIPS),
        lambda rows: rows.above("default") and rows["default"].ratio > 10.0,
    ),
    "steps-correlated": Check(
        strides(SLIPS, LOW, correlation=CORRELATION),
        strides(STICKS, LOW, SLIPS, correlation=CORRELATION),
        lambda rows: rows.above("default", "heavy") and not rows.above("clamp"),
    ),
    "segments": Check(
        strides(SLIPS, LOW, segment=SEGMENT),
        strides(STICKS, LOW, SLIPS, segment=SEGMENT),
        lambda rows: rows.above("default", "heavy"),
    ),
}
