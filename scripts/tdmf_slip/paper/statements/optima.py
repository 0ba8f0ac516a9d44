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
    Measure,
    OwnClaim,
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


def _command(friction: float, quantity: str) -> str:
    over = " ".join(f"--vary {name}={low}:{high}" for name, (low, high) in BOUNDS.items())
    return (
        f"tdmf-slip optimize --friction {friction:g} --minimize {quantity} {over} --target speed={SPEED} "
        "--stable --starts 1"
    )


CLAIMS = (
    OwnClaim(
        "optimal-net",
        "The runner with the least net cost slips. Least cost of transport at speed 0.8 l₀√(k/m), for the "
        "human preset at 2.5 m/s, over touchdown angle, hip torque and leg thrust. Value: friction 0.3. "
        "Control: friction 10, where no foot slips. Each search is local.",
        _cost(SLIPPERY, NET, NET),
        _cost(STICKS, NET, NET),
        _command(SLIPPERY, NET),
        lambda rows: (
            all(0.78 < rows[name].ratio < 0.84 for name in ALL_BUT_HUMAN) and 0.95 < rows["human"].ratio < 1.0
        ),
    ),
    OwnClaim(
        "optimal-slip",
        "Slip of the cheapest runner on friction 0.3, per cent of the distance.",
        solved(_slip),
        None,
        _command(SLIPPERY, NET),
        lambda rows: all(0.5 < row.number < 2.5 for row in rows.values()),
    ),
    OwnClaim(
        "optimal-net-positive",
        "For Table 1 the saving is negative work. Positive cost of transport. Value: the runner of row 1 on"
        " friction 0.3. Control: the least positive cost on friction 10.",
        _cost(SLIPPERY, NET, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        _command(STICKS, POSITIVE),
        lambda rows: all(rows[name].ratio > 1.04 for name in TABLE_1),
    ),
    OwnClaim(
        "optimal-positive",
        "Some slip also reduces the positive cost, by 2 to 3 per cent, but hardly for the human preset. "
        "Least positive cost of transport. Value: friction 0.85. Control: friction 10.",
        _cost(BETWEEN, POSITIVE, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        _command(BETWEEN, POSITIVE),
        lambda rows: (
            all(0.97 < rows[name].ratio < 0.985 for name in ALL_BUT_HUMAN)
            and 0.99 < rows["human"].ratio < 1.0
        ),
    ),
    OwnClaim(
        "optimal-positive-slippery",
        "Whether more slip reduces the positive cost depends on the reading. Least positive cost of "
        "transport. Value: friction 0.3. Control: friction 10. With the clamp it is higher on friction 0.3.",
        _cost(SLIPPERY, POSITIVE, POSITIVE),
        _cost(STICKS, POSITIVE, POSITIVE),
        _command(SLIPPERY, POSITIVE),
        lambda rows: rows["default"].ratio < 1.0 < rows["clamp"].ratio,
    ),
)
