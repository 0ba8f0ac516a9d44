"""Friction that falls with the speed of the foot, beside the static friction at any speed."""

from ...library.gait import Gait
from .claim import ALL_BUT_HUMAN, OwnClaim, Regime, equal_to, gait, remembered, stride_quantity

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


def _static(regime: Regime) -> Gait:
    return gait(regime, RATIO * SLIDING)


@remembered
def _equal(regime: Regime) -> Gait:
    return equal_to(_falling(regime), _static(regime))


CLAIMS = (
    OwnClaim(
        "falling-speed",
        "Speed where friction falls from 0.6 at rest to 0.3 over 0.1 l₀√(k/m), and (control) "
        "where it is 0.6 at any speed. Falling friction makes the human preset slower, the others faster.",
        stride_quantity(_falling, "speed"),
        stride_quantity(_static, "speed"),
        FALLING,
        lambda rows: all(rows[name].above for name in ALL_BUT_HUMAN) and rows["human"].below,
    ),
    OwnClaim(
        "falling-cost",
        "Falling friction is cheaper: cost of transport, and (control) with a friction of 0.6 at equal "
        "speed, apex height and leg angle.",
        stride_quantity(_falling, "cost_of_transport"),
        stride_quantity(_equal, "cost_of_transport"),
        FALLING,
        lambda rows: all(row.below for row in rows.values()),
    ),
    OwnClaim(
        "falling-positive-cost",
        "The same by positive work.",
        stride_quantity(_falling, "positive_cost_of_transport"),
        stride_quantity(_equal, "positive_cost_of_transport"),
        FALLING,
        lambda rows: all(row.below for row in rows.values()),
    ),
)
