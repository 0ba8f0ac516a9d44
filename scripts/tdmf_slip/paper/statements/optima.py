"""The cheapest runners at one speed: by net work, and by positive work, which refunds no braking."""

from collections.abc import Callable
from functools import cache

from ...fmu.fmu import FRICTION
from ...optimization.optimize import optimize
from ...optimization.optimum import Optimum
from .claim import ANGLE, THRUST, TORQUE, OwnClaim

SPEED, RADIUS = 0.8, 0.95
BOUNDS = {ANGLE: (0.3, 1.1), TORQUE: (0.0, 0.6), THRUST: (0.0, 0.4)}
STICKS, HELPS, SLIPS = 10.0, 0.84, 0.2924
"""Frictions: none slips, positive work is the least found (of seven between 10 and 0.29), and net work is."""
BEGIN = {
    STICKS: (0.9757, 0.21534, 0.04348),
    HELPS: (0.9873, 0.2321, 0.0),
    SLIPS: (0.6137, 0.12038, 0.06326),
}
"""Angle, torque and thrust where the search begins: of the stored figure's best, to four digits."""
MIN_SLIP = (0.3, 0.10672, 0.1789)
"""Likewise, of the least slip on that friction."""
NET, POSITIVE, SLIP = "cost_of_transport", "positive_cost_of_transport", "slip_distance"


@cache
def best(friction: float, quantity: str, begin: tuple[float, float, float] | None = None) -> Optimum:
    """The runner with the least of a quantity, near where the search begins."""
    values = dict(zip((ANGLE, TORQUE, THRUST), begin or BEGIN[friction], strict=True))
    return optimize(
        {FRICTION: friction, **values},
        BOUNDS,
        minimize=quantity,
        target={"speed": SPEED},
        stable=RADIUS,
        starts=1,
    )


def _over(friction: float, quantity: str, counted: str) -> Callable[[int], float]:
    """What the best by one quantity has of another, over the least of that on friction 10."""
    return lambda seed: (
        best(friction, quantity).gait.stride[counted] / best(STICKS, counted).gait.stride[counted]
    )


def _command(friction: float, quantity: str) -> str:
    angle, torque, thrust = BEGIN[friction]
    over = " ".join(f"--vary {name}={low}:{high}" for name, (low, high) in BOUNDS.items())
    return (
        f"tdmf-slip optimize --minimize {quantity} {over} --target speed={SPEED} --friction {friction:g} "
        f"--set {ANGLE}={angle} --set {TORQUE}={torque} --set {THRUST}={thrust} --starts 1"
    )


CLAIMS = (
    OwnClaim(
        f"least net cost at speed {SPEED}, on friction {SLIPS} over none that slips",
        _command(SLIPS, NET),
        0.805,
        0.815,
        _over(SLIPS, NET, NET),
    ),
    OwnClaim(
        "  its control: the same runner by positive work, over the least of none that slips",
        _command(STICKS, POSITIVE),
        1.045,
        1.055,
        _over(SLIPS, NET, POSITIVE),
    ),
    OwnClaim(
        f"  the least positive work, on friction {HELPS}, over that of none that slips",
        _command(HELPS, POSITIVE),
        0.978,
        0.983,
        _over(HELPS, POSITIVE, POSITIVE),
    ),
    OwnClaim(
        f"  slip in a stride of the cheapest on friction {SLIPS}, l0",
        _command(SLIPS, NET),
        0.305,
        0.311,
        lambda seed: best(SLIPS, NET).gait.stride[SLIP],
    ),
    OwnClaim(
        "  and the least to be had there, by one that is dearer",
        _command(SLIPS, SLIP),
        0.25,
        0.26,
        lambda seed: best(SLIPS, SLIP, MIN_SLIP).gait.stride[SLIP],
    ),
)
