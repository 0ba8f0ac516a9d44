"""Thrust of the leg beside torque of the hip, at equal speed."""

from collections.abc import Callable

from ...analysis.targeted import find_gait
from ...errors import GaitNotFoundError, RunError
from ...library.gait import Gait
from ...variables.table import FRICTION
from .claim import (
    ANGLE,
    SLIPS,
    TABLE_1,
    THRUST,
    TORQUE,
    Measure,
    OwnClaim,
    Regime,
    changed_to,
    gait,
    made_equal,
    over_length,
    remembered,
    solved,
    stride_quantity,
)

FASTER = 1.3
"""Speed over the speed of the gait on friction 0.2 as it comes."""
HELPED = 0.1
"""Thrust, over the leg's length."""
TARGET = "--target speed=1.085"
"""Target speed in Table 1: `FASTER` times the speed of its gait on friction 0.2."""
BY_TORQUE = f"tdmf-slip gait --friction {SLIPS} {TARGET} --vary {TORQUE} --json"
BY_THRUST = f"tdmf-slip gait --friction {SLIPS} --set {THRUST}={HELPED} {TARGET} --vary {THRUST} --json"


@remembered
def by_torque(regime: Regime) -> Gait:
    """The runner whose torque gives the speed."""
    return _at_speed(regime, TORQUE, 0.0)


@remembered
def by_thrust(regime: Regime) -> Gait:
    """The runner whose thrust, added to its torque, gives the speed."""
    return _at_speed(regime, THRUST, HELPED)


def _at_speed(regime: Regime, name: str, added: float) -> Gait:
    one = gait(regime, SLIPS)
    begin = one.runner[name] + added * one.runner["leg.free_length"]
    values = {**regime.values, FRICTION: SLIPS, name: begin}
    try:
        return find_gait(values, target={"speed": FASTER * one.stride["speed"]}, vary=[name])
    except RunError as error:
        raise GaitNotFoundError(str(error)) from error


@remembered
def as_high(regime: Regime) -> Gait:
    """The runner with thrust that has the speed and apex height of the runner driven by torque."""
    reference = by_torque(regime)
    helped = changed_to(reference, THRUST, HELPED * reference.runner["leg.free_length"], 2)
    return made_equal(reference, helped, ("speed", "apex_height"), (TORQUE, ANGLE))


def _by_way(of: Callable[[Regime], Gait]) -> Measure:
    return solved(lambda regime: of(regime).stride["slip_distance"] / of(regime).stride["length"])


CLAIMS = (
    OwnClaim(
        "thrust-slip",
        "On friction 0.2 a runner with more thrust slips less per distance than one with more hip torque. "
        "Slip distance per stride length, at 1.3 times the speed of the unchanged gait. Value: thrust "
        "added. Control: hip torque raised.",
        _by_way(by_thrust),
        _by_way(by_torque),
        BY_THRUST,
        lambda rows: all(rows[name].below for name in TABLE_1),
    ),
    OwnClaim(
        "thrust-slip-stride",
        "Per stride the runner with thrust slips more, l₀. Value and control as in row 1.",
        over_length(by_thrust, "slip_distance"),
        over_length(by_torque, "slip_distance"),
        BY_THRUST,
        lambda rows: all(rows[name].above for name in TABLE_1),
    ),
    OwnClaim(
        "thrust-height",
        "The reason: the runner with thrust hops higher. Height of the apex, l₀. Value and control as in "
        "row 1.",
        over_length(by_thrust, "apex_height"),
        over_length(by_torque, "apex_height"),
        BY_TORQUE,
        lambda rows: all(rows[name].above for name in TABLE_1),
    ),
    OwnClaim(
        "thrust-slip-matched",
        "At equal speed and apex height the runner with thrust slips more per distance, too. Slip distance "
        "per stride length. Value: thrust of 0.1 l₀. Control: hip torque alone.",
        _by_way(as_high),
        _by_way(by_torque),
        BY_TORQUE,
        lambda rows: all(rows[name].above for name in (*TABLE_1, "heavy")),
    ),
    OwnClaim(
        "thrust-cost-matched",
        "The net cost of transport of that runner is lower. Value and control as in row 4.",
        stride_quantity(as_high, "cost_of_transport"),
        stride_quantity(by_torque, "cost_of_transport"),
        BY_TORQUE,
        lambda rows: all(rows[name].below for name in (*TABLE_1, "heavy")),
    ),
    OwnClaim(
        "thrust-positive-cost-matched",
        "Its positive cost of transport is lower, too. Value and control as in row 4.",
        stride_quantity(as_high, "positive_cost_of_transport"),
        stride_quantity(by_torque, "positive_cost_of_transport"),
        BY_TORQUE,
        lambda rows: all(rows[name].below for name in (*TABLE_1, "heavy")),
    ),
)
