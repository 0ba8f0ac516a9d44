"""Rough ground: strides until the fall, and what the height of the foot has to do with them."""

from functools import cache

from ...analysis.first_passage import FirstPassage, strides_to_fall
from ...library.gait import Gait
from ...library.rough_ground import RoughGround, correlated_weights
from .claim import SLIPS, STICKS, Estimate, Measure, OwnClaim, Regime, matched, solved, stable_gait

RUNNERS, MAX_STRIDES = 400, 1000
"""400 falls give a mean to 10 %, with a confidence of 95 %; a runner still up at the end is censored."""
LOW, HIGH = 0.3, 0.5
"""Steps of the ground, l0 in Table 1."""
CORRELATION = 0.7
"""Of each step with the one before: ground that goes on to rise or fall."""
SEGMENT, HEIGHT = 5.0, 0.4
"""Of the terrain: length of a segment, and standard deviation of heights, l0."""
MATCH = (
    "tdmf-slip compare --friction {} --friction {} --hold speed,apex_height,apex_leg_angle "
    "--vary hip.stance_torque,hip.touchdown_angle,hip.liftoff_angle_factor"
)
"""A control; `strides` runs its second runner."""
ROUGH = (
    "tdmf-slip rough --friction {} --roughness {} --runners "
    f"{RUNNERS} --max-strides {MAX_STRIDES} --seed {{{{seed}}}}"
)


def runner_on(regime: Regime, friction: float, reference: float | None) -> Gait:
    """The runner on a friction, as it comes or made equal to the one on a reference."""
    return stable_gait(regime, friction) if reference is None else matched(regime, reference, friction)


@cache
def falls(regime: Regime, friction: float, reference: float | None, ground: RoughGround) -> FirstPassage:
    """Run until the fall, or so many strides."""
    one = runner_on(regime, friction, reference)
    return strides_to_fall(one.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=one)


def strides(
    friction: float,
    roughness: float,
    reference: float | None = None,
    *,
    correlation: float = 0.0,
    segment: float = 0.0,
) -> Measure:
    """Mean number of strides until the fall; with a reference, of the runner that is made equal to it."""

    def measure(regime: Regime, seed: int) -> Estimate:
        ground = RoughGround(
            roughness * regime.step,
            2 * seed + (reference is not None),  # two that are compared have independent ground
            correlated_weights(correlation),
            segment_length=segment,
        )
        return Estimate.of_strides(falls(regime, friction, reference, ground))

    return measure


def clearance(friction: float, reference: float | None = None) -> Measure:
    """Height of the foot above the ground at the apex, over the leg's length."""

    def over_length(regime: Regime) -> float:
        one = runner_on(regime, friction, reference)
        return one.stride["foot_clearance"] / one.runner.values["leg.free_length"]

    return solved(over_length)


CLAIMS = (
    OwnClaim(
        "steps-as-they-come",
        "On steps of 0.3 l0 the runner on friction 0.2 makes more strides until it falls than the one on "
        "friction 10 (control), which carries its foot lower.",
        strides(SLIPS, LOW),
        strides(STICKS, LOW),
        ROUGH.format(SLIPS, LOW),
        lambda rows: rows["default"].above and rows["clamp"].above,
    ),
    OwnClaim(
        "clearance",
        "Foot clearance at the apex of these two, l0.",
        clearance(SLIPS),
        clearance(STICKS),
        f"tdmf-slip gait --friction {SLIPS} --json",
        lambda rows: rows["default"].above,
    ),
    OwnClaim(
        "steps-matched",
        "On steps of 0.3 l0 the runner on friction 0.2 makes more strides than the one on friction 10 with "
        "equal speed, apex height and leg angle (control). With the clamp it does not.",
        strides(SLIPS, LOW),
        strides(STICKS, LOW, SLIPS),
        MATCH.format(SLIPS, STICKS),
        lambda rows: rows["default"].above and not rows["clamp"].above,
    ),
    OwnClaim(
        "steps-matched-to-sticking",
        "So does the runner on friction 0.2 with speed, apex height and leg angle of the one on friction 10 "
        "(control).",
        strides(SLIPS, LOW, STICKS),
        strides(STICKS, LOW),
        MATCH.format(STICKS, SLIPS),
        lambda rows: rows["default"].above,
    ),
)
