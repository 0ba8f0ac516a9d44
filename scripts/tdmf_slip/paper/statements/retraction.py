"""Retraction of the leg on rough ground, as it comes and with the foot carried as high at the apex."""

from collections.abc import Callable
from functools import cache

from ...analysis.comparison import compare
from ...library.gait import Gait, gait_near
from .claim import HOLD, SLIPS, VARY, OwnClaim, gait
from .rough import ROUGHNESS, RUNNERS, strides

RATE = "hip.retraction_rate"
RETRACTS = 0.008
"""A rate over the root of k/m at which the gait on friction 0.2 still is stable."""
ROUGH = (
    f"tdmf-slip rough --friction {SLIPS} --set {RATE}={RETRACTS} --roughness {ROUGHNESS} --runners {RUNNERS} "
    "--seed {seed}"
)
GAIT = (
    f"tdmf-slip gait --friction {SLIPS} --set {RATE}={RETRACTS} "
    "--target speed=0.8 --vary hip.stance_torque --json"
)


@cache
def retracting(is_matched: bool) -> Gait:
    """The runner that retracts."""
    one = gait(SLIPS)
    for rate in (0.5 * RETRACTS, RETRACTS):
        one = gait_near(one.runner.but(RATE, rate), one.apex)
    return compare([gait(SLIPS), one], hold=HOLD, vary=VARY).gaits[1] if is_matched else one


def _stays_up(is_matched: bool) -> Callable[[int], float]:
    return lambda seed: strides(retracting(is_matched), seed + 1) / strides(gait(SLIPS), seed)


def _over(quantity: str, is_matched: bool) -> Callable[[int], float]:
    return lambda seed: retracting(is_matched).stride[quantity] / gait(SLIPS).stride[quantity]


CLAIMS = (
    OwnClaim(
        f"strides on steps of 0.5 l0, friction 0.2, with retraction at {RETRACTS} over without, as it comes",
        ROUGH,
        0.012,
        0.02,
        _stays_up(False),
    ),
    OwnClaim(
        "  the foot is carried lower then: clearance at the apex",
        GAIT,
        0.47,
        0.49,
        _over("foot_clearance", False),
    ),
    OwnClaim(
        "  its control: with speed, apex height and leg angle of the one that does not retract",
        ROUGH,
        0.045,
        0.075,
        _stays_up(True),
    ),
    OwnClaim("  slip in a stride, as it comes", GAIT, 0.9, 0.93, _over("slip_distance", False)),
    OwnClaim("  its control: and with these equal", GAIT, 0.985, 0.998, _over("slip_distance", True)),
)
