"""Friction that falls with the speed of the foot, beside the static friction at any speed."""

from ...library.gait import Gait
from .claim import ALL_BUT_HUMAN, Check, Regime, equal_to, gait, remembered, stride_quantity

SLIDING, RATIO, VELOCITY = 0.3, 2.0, 0.1
"""Sliding friction, static over sliding friction, and the velocity over which it falls, over l0 sqrt(k/m)."""


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


CHECKS = {
    "falling-speed": Check(
        stride_quantity(_falling, "speed"),
        stride_quantity(_static, "speed"),
        lambda rows: rows.above(*ALL_BUT_HUMAN) and rows.below("human"),
    ),
    "falling-cost": Check(
        stride_quantity(_falling, "cost_of_transport"),
        stride_quantity(_equal, "cost_of_transport"),
        lambda rows: rows.below(*rows),
    ),
    "falling-positive-cost": Check(
        stride_quantity(_falling, "positive_cost_of_transport"),
        stride_quantity(_equal, "positive_cost_of_transport"),
        lambda rows: rows.below(*rows),
    ),
}
