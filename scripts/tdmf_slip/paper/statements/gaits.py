"""Of single gaits at equal or at other parameters: cost over the friction, the human preset, and thrust."""

from collections.abc import Callable, Mapping
from functools import cache

import numpy as np

from ...analysis.comparison import compare
from ...analysis.search import periodic_gait
from ...analysis.sweep import sweep
from ...analysis.targeted import find_gait
from ...fmu.fmu import FRICTION
from ...fmu.parameters import read_parameters
from ...fmu.variable import Given
from ...library.gait import Gait
from ..matched import changed
from .claim import ANGLE, SLIPS, STICKS, THRUST, TORQUE, OwnClaim


@cache
def _smallest(quantity: str) -> float:
    """Of gaits over the friction, over that on friction 10."""
    gaits = sweep({}, {"ground.friction": np.geomspace(10.0, 0.1, 80)}).to_xarray()[quantity].values
    return float(np.nanmin(gaits) / gaits[0])


def _human(friction: float, quantity: str) -> float:
    values: Mapping[str, Given] = read_parameters("human")
    return periodic_gait({**values, FRICTION: friction}).stride[quantity]


@cache
def _at_speed(thrust: bool) -> Gait:
    """At friction 0.2 and speed 1.1, by torque alone, or by thrust added to the default torque."""
    if thrust:
        return find_gait({FRICTION: SLIPS, THRUST: 0.1}, target={"speed": 1.1}, vary=[THRUST])
    return find_gait({FRICTION: SLIPS}, target={"speed": 1.1}, vary=[TORQUE])


def _thrust(quantity: str) -> Callable[[int], float]:
    return lambda seed: _at_speed(True).stride[quantity] / _at_speed(False).stride[quantity]


def _thrust_by_distance(seed: int) -> float:
    return _thrust("slip_distance")(seed) / _thrust("length")(seed)


@cache
def _at_speed_and_height() -> Gait:
    """With a thrust of 0.1, as fast and as high as by torque alone."""
    near = changed(_at_speed(False), {THRUST: HELPED}, 2)
    assert near is not None
    return compare([_at_speed(False), near], hold=("speed", "apex_height"), vary=(TORQUE, ANGLE)).gaits[1]


def _at_height(quantity: str) -> Callable[[int], float]:
    return lambda seed: _at_speed_and_height().stride[quantity] / _at_speed(False).stride[quantity]


HELPED = 0.1
"""Thrust, in l0."""
BY_TORQUE = "tdmf-slip gait --friction 0.2 --target speed=1.1 --vary hip.stance_torque --json"
BY_THRUST = "tdmf-slip gait --friction 0.2 --set leg.thrust=0.1 --target speed=1.1 --vary leg.thrust --json"
SWEEP = "tdmf-slip sweep --friction 10:0.1:80 --spacing log"

CLAIMS = (
    OwnClaim(
        "cost of transport of the paper's runner, net work: least over the friction, over friction 10",
        SWEEP,
        0.785,
        0.795,
        lambda seed: _smallest("cost_of_transport"),
    ),
    OwnClaim(
        "  its control: by positive work, which refunds no braking",
        SWEEP,
        0.86,
        0.87,
        lambda seed: _smallest("positive_cost_of_transport"),
    ),
    OwnClaim(
        "speed of the human preset, friction 0.25 over friction 10",
        "tdmf-slip gait --parameters human --friction 0.25",
        0.832,
        0.842,
        lambda seed: _human(0.25, "speed") / _human(STICKS, "speed"),
    ),
    OwnClaim(
        "  its cost of transport, net work",
        "tdmf-slip gait --parameters human --friction 0.25",
        1.035,
        1.05,
        lambda seed: _human(0.25, "cost_of_transport") / _human(STICKS, "cost_of_transport"),
    ),
    OwnClaim(
        "slip for the distance at friction 0.2 and speed 1.1, with thrust over by torque alone",
        BY_THRUST,
        0.75,
        0.77,
        _thrust_by_distance,
    ),
    OwnClaim("  its control: slip in a stride", BY_TORQUE, 1.5, 1.53, _thrust("slip_distance")),
    OwnClaim("  for it hops higher: height of the apex", BY_THRUST, 2.35, 2.43, _thrust("apex_height")),
    OwnClaim(
        "  its control: slip for the distance with a thrust of 0.1 at equal apex height, too",
        BY_TORQUE,
        1.07,
        1.11,
        lambda seed: _at_height("slip_distance")(seed) / _at_height("length")(seed),
    ),
)
