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
    Check,
    Measure,
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


CHECKS = {
    "thrust-slip": Check(_by_way(by_thrust), _by_way(by_torque), lambda rows: rows.below(*TABLE_1)),
    "thrust-slip-stride": Check(
        over_length(by_thrust, "slip_distance"),
        over_length(by_torque, "slip_distance"),
        lambda rows: rows.above(*TABLE_1),
    ),
    "thrust-height": Check(
        over_length(by_thrust, "apex_height"),
        over_length(by_torque, "apex_height"),
        lambda rows: rows.above(*TABLE_1),
    ),
    "thrust-slip-matched": Check(
        _by_way(as_high), _by_way(by_torque), lambda rows: rows.above(*TABLE_1, "heavy")
    ),
    "thrust-cost-matched": Check(
        stride_quantity(as_high, "cost_of_transport"),
        stride_quantity(by_torque, "cost_of_transport"),
        lambda rows: rows.below(*TABLE_1, "heavy"),
    ),
    "thrust-positive-cost-matched": Check(
        stride_quantity(as_high, "positive_cost_of_transport"),
        stride_quantity(by_torque, "positive_cost_of_transport"),
        lambda rows: rows.below(*TABLE_1, "heavy"),
    ),
}
