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
        "Table 1 is faster on friction that falls. Speed, l₀√(k/m) or m/s. Value: friction falls from 0.6 "
        "at rest to 0.3, with a Stribeck velocity of 0.1 l₀√(k/m). Control: friction 0.6 at all speeds. The"
        " human preset is slower.",
        stride_quantity(_falling, "speed"),
        stride_quantity(_static, "speed"),
        FALLING,
        lambda rows: all(rows[name].above for name in ALL_BUT_HUMAN) and rows["human"].below,
    ),
    OwnClaim(
        "falling-cost",
        "Friction that falls is cheaper. Cost of transport. Value: as in row 1. Control: the matched runner"
        " on friction 0.6.",
        stride_quantity(_falling, "cost_of_transport"),
        stride_quantity(_equal, "cost_of_transport"),
        FALLING,
        lambda rows: all(row.below for row in rows.values()),
    ),
    OwnClaim(
        "falling-positive-cost",
        "The positive cost of transport is lower, too. Value and control as in row 2.",
        stride_quantity(_falling, "positive_cost_of_transport"),
        stride_quantity(_equal, "positive_cost_of_transport"),
        FALLING,
        lambda rows: all(row.below for row in rows.values()),
    ),
)
