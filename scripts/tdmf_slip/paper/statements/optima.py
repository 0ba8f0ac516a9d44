"""The cheapest runners at one speed: by net work, and by positive work, which refunds no braking."""

from collections.abc import Mapping

from ...optimization.optimize import optimize
from ...optimization.optimum import Optimum
from ...variables.table import FRICTION
from .claim import (
    ALL_BUT_HUMAN,
    ANGLE,
    HUMAN,
    STICKS,
    TABLE_1,
    THRUST,
    TORQUE,
    Check,
    Measure,
    Regime,
    remembered,
    solved,
)

SLIPPERY, BETWEEN = 0.3, 0.85
"""Frictions at which the runner of least net work slips for most of its stance, and for some of it."""
NET, POSITIVE = "cost_of_transport", "positive_cost_of_transport"
SPEED, RADIUS = 0.8, 0.95
BOUNDS: Mapping[str, tuple[float, float]] = {ANGLE: (0.3, 1.1), TORQUE: (0.0, 0.6), THRUST: (0.0, 0.4)}
HUMAN_SPEED, HUMAN_RADIUS = 2.5, 0.975
HUMAN_BOUNDS: Mapping[str, tuple[float, float]] = {
    ANGLE: (0.2, 0.8),
    TORQUE: (0.0, 1000.0),
    THRUST: (0.0, 0.02),
}
"""Speed in m/s, largest spectral radius, and what may vary, of the human preset."""


@remembered
def _best(regime: Regime, friction: float, quantity: str) -> Optimum:
    """The runner with the least value of a quantity; the search begins at the regime's own runner."""
    is_human = regime is HUMAN
    return optimize(
        {**regime.values, FRICTION: friction},
        HUMAN_BOUNDS if is_human else BOUNDS,
        minimize=quantity,
        target={"speed": HUMAN_SPEED if is_human else SPEED},
        stable=HUMAN_RADIUS if is_human else RADIUS,
        starts=1,
    )


def _cost(friction: float, least: str, counted: str) -> Measure:
    """The cost `counted` of the runner that has the least cost `least`."""
    return solved(lambda regime: _best(regime, friction, least).gait.stride[counted])


def _slip(regime: Regime) -> float:
    stride = _best(regime, SLIPPERY, NET).gait.stride
    return 100.0 * stride["slip_distance"] / stride["length"]


CHECKS = {
    "optimal-net": Check(
        _cost(SLIPPERY, NET, NET),
        _cost(STICKS, NET, NET),
        lambda rows: (
            all(0.78 < rows[name].ratio < 0.84 for name in ALL_BUT_HUMAN) and 0.95 < rows["human"].ratio < 1.0
        ),
    ),
    "optimal-slip": Check(
        solved(_slip), None, lambda rows: all(0.5 < row.number < 2.5 for row in rows.values())
    ),
    "optimal-net-positive": Check(
        _cost(SLIPPERY, NET, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        lambda rows: all(rows[name].ratio > 1.04 for name in TABLE_1),
    ),
    "optimal-positive": Check(
        _cost(BETWEEN, POSITIVE, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        lambda rows: (
            all(0.97 < rows[name].ratio < 0.985 for name in ALL_BUT_HUMAN)
            and 0.99 < rows["human"].ratio < 1.0
        ),
    ),
    "optimal-positive-slippery": Check(
        _cost(SLIPPERY, POSITIVE, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        lambda rows: rows["default"].ratio < 1.0 < rows["clamp"].ratio,
    ),
}
