"""The stride of the published gait at friction 0.6, as a peer has to know it: equations, guards and resets.

Table 1 in units m = k = l0 = 1. The sequence of modes is given, which spares a peer all of the mode logic.
"""

import math
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any, TypeAlias

BODY, FOOT = 1.0, 0.1
STIFFNESS, DAMPING, GRAVITY = 1.0, 0.2, 0.01
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


def accelerations(
    mode: str, state: State, torque: Number, friction: Number, sin: Function, cos: Function
) -> tuple[Number, Number, Number, Number]:
    """Of foot and leg in a mode: ax, ay, rddot, thetaddot. Works on numbers and on symbols.

    Parameters
    ----------
    mode : str
        Flight, stick, slip or graze.
    state : State
        The eight mechanical states, in the order of `STATES`.
    torque : number
        Of the hip, but in graze.
    friction : number
        With the sign of the foot's velocity; in slip.
    sin : callable
        The sine to use.
    cos : callable
        The cosine to use.
    """
    _, _, r, theta, _, _, r_rate, theta_rate = state
    sine, cosine = sin(theta), cos(theta)
    axial = STIFFNESS * (1.0 - r) - DAMPING * r_rate
    across = (axial * cosine + FOOT * GRAVITY) / sine if mode == "graze" else torque / r
    normal = axial * cosine - across * sine + FOOT * GRAVITY
    tangential = axial * sine + across * cosine
    forces = {"flight": tangential, "stick": 0.0 * r, "slip": tangential - friction * normal}
    ax = forces.get(mode, tangential) / FOOT
    ay = (-axial * cosine + across * sine) / FOOT - GRAVITY if mode == "flight" else 0.0 * r
    body_along = axial / BODY - GRAVITY * cosine
    body_across = across / BODY + GRAVITY * sine
    r_acceleration = r * theta_rate * theta_rate + body_along + ax * sine - ay * cosine
    theta_acceleration = (body_across + ax * cosine + ay * sine - 2.0 * r_rate * theta_rate) / r
    return ax, ay, r_acceleration, theta_acceleration


def sticking_force(state: State, torque: Number, sin: Function, cos: Function) -> tuple[Number, Number]:
    """Ground force (f_x, f_y) on a foot that stays in place."""
    _, _, r, theta, _, _, r_rate, _ = state
    axial = STIFFNESS * (1.0 - r) - DAMPING * r_rate
    sine, cosine = sin(theta), cos(theta)
    return -axial * sine - torque / r * cosine, axial * cosine - torque / r * sine + FOOT * GRAVITY


def servo(state: State, target: Number) -> Number:
    """Torque of the flight law towards an angle."""
    return -KP * (state[3] - target) - KD * state[7]


def vertical_velocity(state: State, sin: Function, cos: Function) -> Number:
    """Vertical velocity of the centre of mass."""
    _, _, r, theta, _, vy, r_rate, theta_rate = state
    return vy + BODY / (BODY + FOOT) * (r_rate * cos(theta) - r * theta_rate * sin(theta))


def impact(state: State, maths: ModuleType = math) -> list[Number]:
    """The state after an impact that slips forward. `maths` has sin and cos for what the state is made of."""
    x, _, r, theta, vx, vy, r_rate, theta_rate = state
    sine, cosine = maths.sin(theta), maths.cos(theta)
    body_vx = vx - r_rate * sine - r * theta_rate * cosine
    body_vy = vy + r_rate * cosine - r * theta_rate * sine
    foot_vx = vx - FRICTION * abs(vy)
    relative = body_vx - foot_vx
    along, across = -relative * sine + body_vy * cosine, -relative * cosine - body_vy * sine
    return [x, 0.0 * r, r, theta, foot_vx, 0.0 * r, along, across / r]


def apex(state: State, maths: ModuleType = math) -> list[Number]:
    """Section of an apex: height and speed of the centre of mass, and the leg."""
    _, y, r, theta, vx, _, r_rate, theta_rate = state
    share = BODY / (BODY + FOOT)
    speed = vx - share * (r_rate * maths.sin(theta) + r * theta_rate * maths.cos(theta))
    return [y + share * r * maths.cos(theta), speed, r, theta, r_rate, theta_rate]


def start(section: State, maths: ModuleType = math) -> list[Number]:
    """The state at an apex."""
    height, speed, r, theta, r_rate, theta_rate = section
    share = BODY / (BODY + FOOT)
    sine, cosine = maths.sin(theta), maths.cos(theta)
    vx = speed + share * (r_rate * sine + r * theta_rate * cosine)
    vy = -share * (r_rate * cosine - r * theta_rate * sine)
    return [0.0 * r, height - share * r * cosine, r, theta, vx, vy, r_rate, theta_rate]
