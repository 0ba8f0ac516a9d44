"""Feedback from stride to stride, beside a runner that carries its foot higher without any."""

from dataclasses import replace
from functools import cache

from ...analysis.first_passage import strides_to_fall
from ...feedback.gains import Feedback, dead_beat, lqr
from ...library.gait import Gait
from ...library.ground import RoughGround
from .attraction import SAMPLES, Design, largest, share
from .claim import ANGLE, SLIPS, STICKS, TABLE_1, TORQUE, Estimate, Measure, OwnClaim, Regime, stable_gait
from .rough import LOW, MATCH, foot, runner_on

SETTINGS = (ANGLE, TORQUE)
FRICTION, SLIPPERY = 0.6, 0.1
NEGLIGIBLE = 0.05
"""Size of an eigenvalue that a dead-beat law leaves as it is."""
ANGLE_REACH, TORQUE_REACH = 0.1, 0.5
"""Largest change of a setting: rad, and as a share of the gait's own torque."""
NOISE = 0.01
"""Standard deviation of the sensors' noise, over the scales of the section; smaller where steps are."""
RUNNERS, MAX_STRIDES = 256, 400
ROUGH = (
    f"tdmf-slip rough --friction {FRICTION} --roughness {LOW} --runners {RUNNERS} "
    f"--max-strides {MAX_STRIDES} --seed {{seed}}"
)
BASIN = "tdmf-slip basin --friction 10 --n 8 --ball none --samples {}"


@cache
def regulator(regime: Regime, friction: float) -> Feedback:
    """A quadratic regulator of touchdown angle and stance torque, within limits."""
    one = stable_gait(regime, friction)
    return lqr(one, SETTINGS, limits=_limits(one))


@cache
def dead_beat_law(regime: Regime, friction: float) -> Feedback:
    """A law of the same settings and limits that removes a small disturbance in two strides."""
    one = stable_gait(regime, friction)
    return dead_beat(one, SETTINGS, limits=_limits(one), negligible=NEGLIGIBLE)


def _limits(one: Gait) -> dict[str, tuple[float, float]]:
    angle, torque = (one.runner[name] for name in SETTINGS)
    reach = TORQUE_REACH * torque
    return {ANGLE: (angle - ANGLE_REACH, angle + ANGLE_REACH), TORQUE: (torque - reach, torque + reach)}


@cache
def _passage(
    regime: Regime, friction: float, design: Design | None, reference: float | None, seed: int
) -> Estimate:
    one = runner_on(regime, friction, reference)
    law = None
    if design is not None:
        noise = (NOISE * regime.step * one.runner.scales).tolist()
        law = replace(design(regime, friction), noise=noise, seed=seed)
    ground = RoughGround(LOW * regime.step, 3 * seed + (design is not None) + 2 * (reference is not None))
    found = strides_to_fall(one.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=one, law=law)
    return Estimate.of_strides(found)


def _strides(friction: float, design: Design | None = None, reference: float | None = None) -> Measure:
    """Mean number of strides until the fall on steps."""
    return lambda regime, seed: _passage(regime, friction, design, reference, seed)


CLAIMS = (
    OwnClaim(
        "feedback-strides",
        "At friction 0.6 a regulator does not lengthen runs on steps of 0.3 l₀, except with the clamp. "
        "Strides until the fall. Value: with a quadratic regulator of touchdown angle and torque. Control: "
        "without feedback. With the clamp the regulator lengthens runs more than ten times.",
        _strides(FRICTION, regulator),
        _strides(FRICTION),
        ROUGH,
        lambda rows: (
            rows["clamp"].ratio > 10.0 and not any(rows[name].above for name in ("default", "human"))
        ),
    ),
    OwnClaim(
        "feedback-without",
        "The reason: without feedback the runner already survives steps up to nearly its foot clearance, "
        "except with the clamp. Value: height up to which it survives every step up, l₀. Control: foot "
        "clearance at the apex, l₀.",
        largest("step_up", FRICTION),
        foot("foot_clearance", FRICTION),
        ROUGH,
        lambda rows: rows["default"].ratio > 0.95 and rows["clamp"].ratio < 0.8,
    ),
    OwnClaim(
        "feedback-with",
        "With the regulator this height does not exceed the foot clearance either. Value and control as in "
        "row 2, with the regulator.",
        largest("step_up", FRICTION, design=regulator),
        foot("foot_clearance", FRICTION),
        ROUGH,
        lambda rows: all(0.95 < rows[name].ratio < 1.01 for name in TABLE_1),
    ),
    OwnClaim(
        "feedback-matched",
        "Carrying the foot higher lengthens runs more than the regulator does. Strides until the fall "
        "without feedback at friction 0.6. Value: the runner matched to the one on friction 0.2, which "
        "carries its foot higher. Control: the unmatched runner.",
        _strides(FRICTION, reference=SLIPS),
        _strides(FRICTION),
        MATCH.format(SLIPS, FRICTION),
        lambda rows: all(row.above for row in rows.values()),
    ),
    OwnClaim(
        "feedback-dead-beat",
        "On friction 0.1 a dead-beat law of touchdown angle and torque lengthens runs, except with the "
        "clamp. Strides until the fall. Value: with the law. Control: without feedback.",
        _strides(SLIPPERY, dead_beat_law),
        _strides(SLIPPERY),
        f"tdmf-slip rough --friction {SLIPPERY} --roughness {LOW} --runners {RUNNERS} --seed {{seed}}",
        lambda rows: rows["default"].above and not rows["clamp"].above,
    ),
    OwnClaim(
        "feedback-step-down",
        "On friction 10 the regulator helps on steps down, except for the heavy runner. Largest step down "
        "that the runner survives, l₀. Value: with the regulator. Control: without feedback. The largest "
        "step tried is 5.",
        largest("step_down", STICKS, design=regulator),
        largest("step_down", STICKS),
        BASIN.format(0),
        lambda rows: all(rows[name].above for name in TABLE_1) and rows["heavy"].below,
    ),
    OwnClaim(
        "feedback-attraction",
        "On friction 10 the regulator enlarges the region of attraction, except for the heavy runner. Share"
        " of the box that settles. Value: with the regulator. Control: without feedback.",
        share(STICKS, design=regulator),
        share(STICKS),
        BASIN.format(SAMPLES),
        lambda rows: all(rows[name].above for name in TABLE_1) and rows["heavy"].below,
    ),
)
