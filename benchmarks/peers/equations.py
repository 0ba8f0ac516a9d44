"""The stride of the published gait at friction 0.6, as a peer has to know it, by the model's own equations.

Table 1 in units m = k = l0 = 1, on level ground. The sequence of modes is given, which spares a peer all of
the mode logic.
"""

import math
from collections.abc import Callable, Sequence
from types import SimpleNamespace as Record
from typing import Any, TypeAlias

import numpy as np
from tdmf_slip.equations import coordinates, dynamics, free_fall, functions, ground_force, hip, leg, runner
from tdmf_slip.equations import impact as impact_law

STANCE_TORQUE, KP, KD, LIFTOFF_FACTOR = 0.2, 0.1, 0.1, 1.2
TOUCHDOWN_ANGLE = math.radians(40.0)
FRICTION = 0.6
STATES = ("x", "y", "r", "theta", "vx", "vy", "r_rate", "theta_rate")
Number: TypeAlias = Any
"""What a peer reckons with: a float, an array of them, or a symbol."""
State: TypeAlias = Sequence[Number]
"""The eight mechanical states, in the order of `STATES`."""
Function: TypeAlias = Callable[[Number], Number]
ARMED = 1e-13
"""Offset of a guard that starts at zero."""

_NAMES = (
    "foot_x",
    "foot_y",
    "leg_length",
    "leg_angle",
    "foot_vx",
    "foot_vy",
    "leg_length_rate",
    "leg_angle_rate",
)
_MODEL = Record(
    parameters=Record(
        body=Record(mass=1.0),
        foot=Record(mass=0.1),
        leg=Record(stiffness=1.0, damping=0.2),
        ground=Record(patch_friction=FRICTION),
        gravity=0.01,
    ),
    **vars(runner.derived(1.0, 0.1)),
)
_INPUTS = Record(ground=Record(friction=FRICTION))
_LEVEL = Record(height=0.0, slope=0.0, sine=0.0, cosine=1.0)
_NO_PUSH = Record(x=0.0, y=0.0)
functions.serve(np.ndarray, np)


def _state(state: State) -> Any:
    return Record(**dict(zip(_NAMES, state, strict=True)))


def _leg(state: Any) -> Any:
    direction = leg.direction(state.leg_angle)
    return leg.evaluate(_MODEL, _LEVEL, state, direction, 1.0, state.leg_length)


def accelerations(
    mode: str, state: State, torque: Number, friction: Number
) -> tuple[Number, Number, Number, Number]:
    """Of foot and leg in a mode: ax, ay, rddot, thetaddot. Works on numbers and on symbols."""
    of = _state(state)
    at = _leg(of)
    total = ground_force.graze_torque(_MODEL, _LEVEL, at, False, None) if mode == "graze" else torque
    force = ground_force.in_mode(_MODEL, friction, _LEVEL, of, at, total, mode, 1, False)
    foot = dynamics.foot_acceleration(_MODEL, _LEVEL, at, total, force, mode)
    fall = free_fall.of_body(_MODEL, _NO_PUSH)
    across = total * at.inverse_length
    of_leg = dynamics.leg_acceleration(_MODEL.inverse_body_mass, at, across, fall, foot)
    return foot.x, foot.y, of_leg.length, of_leg.angle


def sticking_force(state: State, torque: Number) -> tuple[Number, Number]:
    """Ground force (f_x, f_y) on a foot that stays in place."""
    force = ground_force.under(_MODEL, _LEVEL, _leg(_state(state)), torque)
    return force.tangential, force.normal


def servo(state: State, gain: Number, target: Number, rate_gain: Number) -> Number:
    """Torque of the flight law towards an angle."""
    law = Record(gain=gain, target=target, rate_gain=rate_gain, torque=0.0)
    return hip.torque(law, state[3], state[7])


def _center(state: State) -> Any:
    at = _state(state)
    return coordinates.center_of_mass(_MODEL, at, leg.direction(at.leg_angle))


def vertical_velocity(state: State) -> Number:
    """Vertical velocity of the centre of mass."""
    return _center(state).vy


def impact(state: State) -> list[Number]:
    """The state after an impact that slips forward."""
    at = _state(state)
    direction = leg.direction(at.leg_angle)
    after = impact_law.after(_MODEL, _INPUTS, "before", _LEVEL, at, direction, 1.0, False, False)
    return [
        after.foot_x,
        after.foot_y,
        at.leg_length,
        at.leg_angle,
        after.foot_vx,
        after.foot_vy,
        after.leg_length_rate,
        after.leg_angle_rate,
    ]


def apex(state: State) -> list[Number]:
    """Section of an apex: height and speed of the centre of mass, and the leg."""
    center = _center(state)
    return [center.y, center.vx, state[2], state[3], state[6], state[7]]


def start(section: State) -> list[Number]:
    """The state at an apex, whose foot is at x = 0."""
    height, speed, r, theta, r_rate, theta_rate = section
    hanging = _state([0.0, 0.0, r, theta, 0.0, 0.0, r_rate, theta_rate])
    center = Record(x=0.0, y=height, vx=speed, vy=0.0)
    foot = coordinates.foot_below(_MODEL, center, hanging, leg.direction(theta))
    return [0.0 * r, foot.y, r, theta, foot.vx, foot.vy, r_rate, theta_rate]
