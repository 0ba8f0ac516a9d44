"""Feedback from stride to stride, beside a runner that carries its foot higher without any."""

from dataclasses import replace
from functools import cache

from ...analysis.first_passage import strides_to_fall
from ...feedback.feedback import Feedback
from ...feedback.gains import dead_beat, lqr
from ...library.gait import Gait
from ...library.rough_ground import RoughGround
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
    angle, torque = (one.runner.values[name] for name in SETTINGS)
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
        "Strides until the fall on steps of 0.3 l₀ at friction 0.6, with a quadratic regulator of touchdown "
        "angle and torque, and (control) without. With the clamp the regulator keeps the runner up more "
        "than 10 times longer. In the default it does not lengthen runs.",
        _strides(FRICTION, regulator),
        _strides(FRICTION),
        ROUGH,
        lambda rows: (
            rows["clamp"].ratio > 10.0 and not any(rows[name].above for name in ("default", "human"))
        ),
    ),
    OwnClaim(
        "feedback-without",
        "The reason: height up to which the runner without the regulator recovers from every step up, and "
        "(control) the foot clearance at the apex, l₀. In the default that height is nearly the whole "
        "clearance already; with the clamp it is not.",
        largest("step_up", FRICTION),
        foot("foot_clearance", FRICTION),
        ROUGH,
        lambda rows: rows["default"].ratio > 0.95 and rows["clamp"].ratio < 0.8,
    ),
    OwnClaim(
        "feedback-with",
        "The same with the regulator, which goes no further than the clearance by either reading.",
        largest("step_up", FRICTION, design=regulator),
        foot("foot_clearance", FRICTION),
        ROUGH,
        lambda rows: all(0.95 < rows[name].ratio < 1.01 for name in TABLE_1),
    ),
    OwnClaim(
        "feedback-matched",
        "A foot that is carried higher does more: strides without feedback at speed, apex height and leg "
        "angle of the runner on friction 0.2, and (control) as it comes.",
        _strides(FRICTION, reference=SLIPS),
        _strides(FRICTION),
        MATCH.format(SLIPS, FRICTION),
        lambda rows: all(row.above for row in rows.values()),
    ),
    OwnClaim(
        "feedback-dead-beat",
        "On friction 0.1 a dead-beat law of touchdown angle and torque helps, but not with the clamp: "
        "strides with the law, and (control) without.",
        _strides(SLIPPERY, dead_beat_law),
        _strides(SLIPPERY),
        f"tdmf-slip rough --friction {SLIPPERY} --roughness {LOW} --runners {RUNNERS} --seed {{seed}}",
        lambda rows: rows["default"].above and not rows["clamp"].above,
    ),
    OwnClaim(
        "feedback-step-down",
        "Largest step down that is recovered from on friction 10 with the regulator, and (control) without, "
        "l₀; the largest tried is 5. For the heavy runner the regulator harms.",
        largest("step_down", STICKS, design=regulator),
        largest("step_down", STICKS),
        BASIN.format(0),
        lambda rows: all(rows[name].above for name in TABLE_1) and rows["heavy"].below,
    ),
    OwnClaim(
        "feedback-attraction",
        "Share of the box of apices that settles on the gait on friction 10 with the regulator, and "
        "(control) without. For the heavy runner it harms here, too.",
        share(STICKS, design=regulator),
        share(STICKS),
        BASIN.format(SAMPLES),
        lambda rows: all(rows[name].above for name in TABLE_1) and rows["heavy"].below,
    ),
)
