"""Feedback from stride to stride, beside a runner that carries its foot higher without any."""

from dataclasses import replace
from functools import cache

from ...analysis.first_passage import strides_to_fall
from ...feedback.gains import Feedback, dead_beat, lqr
from ...library.gait import Gait
from ...library.ground import RoughGround
from .attraction import Design, largest, share
from .claim import ANGLE, SLIPS, STICKS, TABLE_1, TORQUE, Check, Estimate, Measure, Regime, stable_gait
from .rough import LOW, foot, runner_on

SETTINGS = (ANGLE, TORQUE)
FRICTION, SLIPPERY = 0.6, 0.1
NEGLIGIBLE = 0.05
"""Size of an eigenvalue that a dead-beat law leaves as it is."""
ANGLE_REACH, TORQUE_REACH = 0.1, 0.5
"""Largest change of a setting: rad, and as a share of the gait's own torque."""
NOISE = 0.01
"""Standard deviation of the sensors' noise, over the scales of the section; smaller where steps are."""
RUNNERS, MAX_STRIDES = 256, 400


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


CHECKS = {
    "feedback-strides": Check(
        _strides(FRICTION, regulator),
        _strides(FRICTION),
        lambda rows: (
            rows["clamp"].ratio > 10.0 and not any(rows.above(name) for name in ("default", "human"))
        ),
    ),
    "feedback-without": Check(
        largest("step_up", FRICTION),
        foot("foot_clearance", FRICTION),
        lambda rows: rows["default"].ratio > 0.95 and rows["clamp"].ratio < 0.8,
    ),
    "feedback-with": Check(
        largest("step_up", FRICTION, design=regulator),
        foot("foot_clearance", FRICTION),
        lambda rows: all(0.95 < rows[name].ratio < 1.01 for name in TABLE_1),
    ),
    "feedback-matched": Check(
        _strides(FRICTION, reference=SLIPS), _strides(FRICTION), lambda rows: rows.above(*rows)
    ),
    "feedback-dead-beat": Check(
        _strides(SLIPPERY, dead_beat_law),
        _strides(SLIPPERY),
        lambda rows: rows.above("default") and not rows.above("clamp"),
    ),
    "feedback-step-down": Check(
        largest("step_down", STICKS, design=regulator),
        largest("step_down", STICKS),
        lambda rows: rows.above(*TABLE_1) and rows.below("heavy"),
    ),
    "feedback-attraction": Check(
        share(STICKS, design=regulator),
        share(STICKS),
        lambda rows: rows.above(*TABLE_1) and rows.below("heavy"),
    ),
}
