"""What this project says of its own: each claim with its control, and how it is computed.

A claim that compares two runners has its control beside it: the same comparison with the runners made equal
in what else could do it. Numbers that are drawn depend on the seed; their intervals are wide enough for any.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..analysis.comparison import compare
from ..analysis.first_passage import strides_to_fall
from ..analysis.search import periodic_gait
from ..analysis.sweep import sweep
from ..analysis.targeted import find_gait
from ..library.gait import Gait
from ..library.rough_ground import RoughGround, correlated_weights
from ..unit.parameters import read_parameters
from ..unit.unit import FRICTION
from ..unit.variable import Given

TORQUE = "hip.stance_torque"
HOLD = ("speed", "apex_height", "apex_leg_angle")
VARY = (TORQUE, "hip.touchdown_angle", "hip.liftoff_angle_factor")
SLIPS, STICKS = 0.2, 10.0
"""Frictions of a runner that slips all the time, and of one that sticks."""
ROUGHNESS, RUNNERS, MOST_STRIDES = 0.5, 600, 20_000
"""Steps in l0; 600 falls tell a mean to 8 %, with a confidence of 95 %."""
CORRELATION = 0.7
"""Of each step with the one before: ground that goes on to rise or fall."""
MATCH = (
    "tdmf-slip compare --friction {} --friction {} --hold speed,apex_height,apex_leg_angle "
    "--vary hip.stance_torque,hip.touchdown_angle,hip.liftoff_angle_factor"
)
ROUGH = f"tdmf-slip rough --friction {SLIPS} --roughness {ROUGHNESS} --runners {RUNNERS} --seed {{seed}}"


@dataclass(frozen=True)
class OwnClaim:
    """Something that this project says, and how it is recomputed."""

    what: str
    """In words."""
    command: str
    """That recomputes it, or the first of what it is made of."""
    low: float
    """Least that is stated."""
    high: float
    """Most."""
    compute: Callable[[int], float]
    """By a seed, of which only what is drawn depends."""


@cache
def _gait(friction: float) -> Gait:
    return periodic_gait({FRICTION: friction})


@cache
def _matched(reference: float, other: float) -> Gait:
    """The runner on the other friction, as its control."""
    return compare([_gait(reference), _gait(other)], hold=HOLD, vary=VARY).gaits[1]


def _strides(gait: Gait, seed: int, correlation: float = 0.0) -> float:
    ground = RoughGround(ROUGHNESS, seed, correlated_weights(correlation))
    found = strides_to_fall(gait.runner, ground, RUNNERS, max_strides=MOST_STRIDES, gait=gait, workers=1)
    return found.mean_strides


def _strides_as_they_come(seed: int) -> float:
    return _strides(_gait(SLIPS), seed) / _strides(_gait(STICKS), seed + 1)


def _strides_at_slips_kinematics(seed: int) -> float:
    return _strides(_gait(SLIPS), seed) / _strides(_matched(SLIPS, STICKS), seed + 1)


def _strides_on_hills(seed: int) -> float:
    matched = _matched(SLIPS, STICKS)
    return _strides(_gait(SLIPS), seed, CORRELATION) / _strides(matched, seed + 1, CORRELATION)


def _strides_at_sticks_kinematics(seed: int) -> float:
    return _strides(_matched(STICKS, SLIPS), seed) / _strides(_gait(STICKS), seed + 1)


def _clearance(friction: float) -> Callable[[int], float]:
    return lambda seed: _gait(friction).stride["foot_clearance"]


@cache
def _least(quantity: str) -> float:
    """Of gaits over the friction, over that on friction 10."""
    gaits = sweep({}, np.geomspace(10.0, 0.1, 80)).to_xarray()[quantity].values
    return float(np.nanmin(gaits) / gaits[0])


def _human(friction: float, quantity: str) -> float:
    values: Mapping[str, Given] = read_parameters("human")
    return periodic_gait({**values, FRICTION: friction}).stride[quantity]


@cache
def _at_speed(thrust: bool) -> Gait:
    """At friction 0.2 and speed 1.1, by torque alone, or by thrust added to the default torque."""
    if thrust:
        return find_gait({FRICTION: SLIPS, "leg.thrust": 0.1}, target={"speed": 1.1}, vary=["leg.thrust"])
    return find_gait({FRICTION: SLIPS}, target={"speed": 1.1}, vary=[TORQUE])


def _thrust(quantity: str) -> Callable[[int], float]:
    return lambda seed: _at_speed(True).stride[quantity] / _at_speed(False).stride[quantity]


def _thrust_by_distance(seed: int) -> float:
    return _thrust("slip_distance")(seed) / _thrust("length")(seed)


BY_TORQUE = "tdmf-slip gait --friction 0.2 --speed 1.1 --free hip.stance_torque --json"
BY_THRUST = "tdmf-slip gait --friction 0.2 --set leg.thrust=0.1 --speed 1.1 --free leg.thrust --json"
SWEEP = "tdmf-slip sweep --friction 10:0.1:80 --spacing log"

CLAIMS = (
    OwnClaim(
        "strides on steps of 0.5 l0, friction 0.2 over friction 10, as they come",
        ROUGH,
        18.0,
        32.0,
        _strides_as_they_come,
    ),
    OwnClaim(
        "  the foot's clearance at the apex is not equal then: at friction 0.2, l0",
        "tdmf-slip gait --friction 0.2 --foot-clearance 1.8828 --free hip.stance_torque --json",
        1.88,
        1.89,
        _clearance(SLIPS),
    ),
    OwnClaim(
        "  and at friction 10, l0",
        "tdmf-slip gait --friction 10 --foot-clearance 0.7877 --free hip.stance_torque --json",
        0.78,
        0.79,
        _clearance(STICKS),
    ),
    OwnClaim(
        "  its control: friction 0.2 over friction 10 with speed, apex height and leg angle of the former",
        MATCH.format(SLIPS, STICKS),
        0.85,
        1.23,
        _strides_at_slips_kinematics,
    ),
    OwnClaim(
        "  the same on steps correlated by 0.7, where slip harms",
        f"{ROUGH} --correlation {CORRELATION}",
        0.66,
        0.98,
        _strides_on_hills,
    ),
    OwnClaim(
        "  and with those of the latter, on independent steps",
        MATCH.format(STICKS, SLIPS),
        0.85,
        1.28,
        _strides_at_sticks_kinematics,
    ),
    OwnClaim(
        "cost of transport of the paper's runner, net work: least over the friction, over friction 10",
        SWEEP,
        0.785,
        0.795,
        lambda seed: _least("cost_of_transport"),
    ),
    OwnClaim(
        "  its control: by positive work, which refunds no braking",
        SWEEP,
        0.86,
        0.87,
        lambda seed: _least("positive_cost_of_transport"),
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
)
"""All of them; what is indented is the control of what is above."""
