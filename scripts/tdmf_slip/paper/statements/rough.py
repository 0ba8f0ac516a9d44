"""Rough ground: strides until the fall, and how they depend on the height of the foot."""

from functools import cache

from ...analysis.first_passage import FirstPassage, strides_to_fall
from ...analysis.rare_falls import rare_falls
from ...library.gait import Gait
from ...library.ground import RoughGround, correlated_weights
from .claim import SLIPS, STICKS, Estimate, Measure, OwnClaim, Regime, matched, over_length, stable_gait

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
MATCH = (
    "tdmf-slip compare --friction {} --friction {} --hold speed,apex_height,apex_leg_angle "
    "--vary hip.stance_torque,hip.touchdown_angle,hip.liftoff_angle_factor"
)
"""Command that finds the equal runner of a control, whose strides `strides` counts."""
ROUGH = (
    "tdmf-slip rough --friction {} --roughness {} --runners "
    f"{RUNNERS} --max-strides {MAX_STRIDES} --seed {{{{seed}}}}"
)
ROUGH_RARE = f"tdmf-slip rough --friction {SLIPS} --roughness {LOWER} --rare --seed {{seed}}"


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


CLAIMS = (
    OwnClaim(
        "steps-as-they-come",
        "On steps of 0.3 l₀ the runner on friction 0.2 makes more strides until it falls than the one on "
        "friction 10. Value: friction 0.2. Control: friction 10, unmatched.",
        strides(SLIPS, LOW),
        strides(STICKS, LOW),
        ROUGH.format(SLIPS, LOW),
        lambda rows: all(row.above for row in rows.values()),
    ),
    OwnClaim(
        "clearance",
        "The runner on friction 0.2 also carries its foot higher. Foot clearance at the apex, l₀. Value: "
        "friction 0.2. Control: friction 10, unmatched.",
        foot("foot_clearance", SLIPS),
        foot("foot_clearance", STICKS),
        f"tdmf-slip gait --friction {SLIPS} --json",
        lambda rows: all(row.above for row in rows.values()),
    ),
    OwnClaim(
        "steps-matched",
        "Matched runners differ, too, except with the clamp. Strides until the fall on steps of 0.3 l₀. "
        "Value: friction 0.2. Control: the runner on friction 10, matched to it.",
        strides(SLIPS, LOW),
        strides(STICKS, LOW, SLIPS),
        MATCH.format(SLIPS, STICKS),
        lambda rows: (
            rows["default"].above
            and rows["default"].ratio > 5.0
            and rows["heavy"].above
            and not rows["clamp"].above
        ),
    ),
    OwnClaim(
        "steps-matched-0.6",
        "As in row 3. Value: friction 0.6. Control: the runner on friction 10, matched to it.",
        strides(0.6, LOW),
        strides(STICKS, LOW, 0.6),
        MATCH.format(0.6, STICKS),
        lambda rows: rows["default"].above and rows["heavy"].above,
    ),
    OwnClaim(
        "steps-matched-to-sticking",
        "As in row 3, but matched to the runner that sticks. Value: the runner on friction 0.2, matched to "
        "the one on friction 10. Control: friction 10. With the clamp the difference is small.",
        strides(SLIPS, LOW, STICKS),
        strides(STICKS, LOW),
        MATCH.format(STICKS, SLIPS),
        lambda rows: rows["default"].above and rows["heavy"].above and not rows["clamp"].above,
    ),
    OwnClaim(
        "steps-foot-height",
        "The greatest height of the foot in a stride does not explain the longer runs: it is no greater on "
        "friction 0.2. Height, l₀. Value: friction 0.2. Control: the runner on friction 10, matched to it.",
        foot("greatest_foot_height", SLIPS),
        foot("greatest_foot_height", STICKS, SLIPS),
        MATCH.format(SLIPS, STICKS),
        lambda rows: rows["default"].below and rows["heavy"].below,
    ),
    OwnClaim(
        "steps-that-trip",
        "Most of the difference arises where a step rises above the swinging foot. If such a step already "
        "counts as a fall, the runner on friction 0.2 makes less than twice as many strides. Value and "
        "control as in row 3.",
        strides(SLIPS, LOW, trips=True),
        strides(STICKS, LOW, SLIPS, trips=True),
        ROUGH.format(SLIPS, LOW) + " --trips",
        lambda rows: rows["default"].ratio < 2.0 and rows["heavy"].ratio < 2.0,
    ),
    OwnClaim(
        "steps-rare",
        "On steps of 0.2 l₀ the difference exceeds a factor of ten. Value and control as in row 3. The "
        "value is computed by multilevel splitting, because falls on friction 0.2 are too rare to count.",
        rarely,
        strides(STICKS, LOWER, SLIPS),
        ROUGH_RARE,
        lambda rows: rows["default"].above and rows["default"].ratio > 10.0,
    ),
    OwnClaim(
        "steps-correlated",
        "With a correlation of 0.7 between successive steps, slipping lengthens runs, too, except with the "
        "clamp. Value and control as in row 3.",
        strides(SLIPS, LOW, correlation=CORRELATION),
        strides(STICKS, LOW, SLIPS, correlation=CORRELATION),
        ROUGH.format(SLIPS, LOW) + f" --correlation {CORRELATION}",
        lambda rows: rows["default"].above and rows["heavy"].above and not rows["clamp"].above,
    ),
    OwnClaim(
        "segments",
        "On level segments of length 5 l₀, whose heights have a standard deviation of 0.3 l₀, slipping "
        "lengthens runs, too. Value and control as in row 3. Where on a segment the foot lands is not "
        "matched.",
        strides(SLIPS, LOW, segment=SEGMENT),
        strides(STICKS, LOW, SLIPS, segment=SEGMENT),
        ROUGH.format(SLIPS, LOW) + f" --segment-length {SEGMENT:g}",
        lambda rows: rows["default"].above and rows["heavy"].above,
    ),
)
