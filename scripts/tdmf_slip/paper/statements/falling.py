"""Friction that falls with the speed of the foot, beside the static friction at any speed."""

from ...library.gait import Gait
from .claim import Measure, OwnClaim, Regime, equal_to, gait, remembered, solved

SLIDING, RATIO, VELOCITY = 0.3, 2.0, 0.1
"""Sliding friction, static over sliding friction, and the velocity over which it falls, over l0 sqrt(k/m)."""
FALLING = (
    f"tdmf-slip gait --friction {SLIDING} --set ground.static_friction_ratio={RATIO} "
    f"--set ground.stribeck_velocity={VELOCITY} --json"
)


@remembered
def _falling(regime: Regime) -> Gait:
    scale = gait(regime, SLIDING).runner.scales[1]
    return gait(
        regime,
        SLIDING,
        ground__static_friction_ratio=RATIO,
        ground__stribeck_velocity=VELOCITY * float(scale),
    )


@remembered
def _equal(regime: Regime) -> Gait:
    return equal_to(_falling(regime), gait(regime, RATIO * SLIDING))


def _has(quantity: str) -> Measure:
    return solved(lambda regime: _falling(regime).stride[quantity])


def _with_static(quantity: str) -> Measure:
    return solved(lambda regime: gait(regime, RATIO * SLIDING).stride[quantity])


def _at_equal(quantity: str) -> Measure:
    return solved(lambda regime: _equal(regime).stride[quantity])


CLAIMS = (
    OwnClaim(
        "falling-speed",
        "Speed where friction falls from 0.6 at rest to 0.3 over 0.1 l₀√(k/m), and (control) "
        "where it is 0.6 at any speed. Falling friction makes the human preset slower, the others faster.",
        _has("speed"),
        _with_static("speed"),
        FALLING,
        lambda rows: all(rows[name].above for name in ("default", "clamp", "heavy")) and rows["human"].below,
    ),
    OwnClaim(
        "falling-cost",
        "Falling friction is cheaper: cost of transport, and (control) with a friction of 0.6 at equal "
        "speed, apex height and leg angle.",
        _has("cost_of_transport"),
        _at_equal("cost_of_transport"),
        FALLING,
        lambda rows: all(row.below for row in rows.values()),
    ),
    OwnClaim(
        "falling-positive-cost",
        "The same by positive work.",
        _has("positive_cost_of_transport"),
        _at_equal("positive_cost_of_transport"),
        FALLING,
        lambda rows: all(row.below for row in rows.values()),
    ),
)
