"""The modes of the stride `+0-0+` in their order, which every peer is told."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from . import equations as eq
from .equations import Number, State

Run: TypeAlias = Callable[[str, State, State], tuple[list[Number], Number]]
"""Takes a mode's name, a state and parameters to the first guard; returns the state and which."""

MOVING = {
    "place": range(8),
    "retract": range(8),
    "clamped": range(8),
    "stick": (2, 3, 6, 7),
    "slip": (0, 2, 3, 4, 6, 7),
    "graze": (0, 2, 3, 4, 6, 7),
}
"""Indices of the states that change in a mode; `clamped` is retract with the clamp of (12)."""
FLIGHT = ("place", "retract", "clamped")
"""Modes of flight."""
LONGEST = 100.0
"""Time within which every mode ends."""
PARAMETERS = 4

PASSED = 10.0
"""Keeps the guard of mid-stance away once it has passed."""
DRIVE = -eq.STANCE_TORQUE
STANCE = (
    ("slip", (DRIVE, eq.FRICTION, 1.0, 0.0)),
    ("stick", (DRIVE, eq.FRICTION, 0.0, 0.0)),
    ("slip", (DRIVE, -eq.FRICTION, -1.0, 0.0)),  # to mid-stance
    ("slip", (0.0, -eq.FRICTION, -1.0, PASSED)),
    ("stick", (0.0, eq.FRICTION, 0.0, PASSED)),
    ("slip", (0.0, eq.FRICTION, 1.0, PASSED)),
)


def modes_of(swing_clamp: bool) -> tuple[str, ...]:
    """Names of the modes of a stride, with the clamp or without it."""
    return tuple(name for name in MOVING if name != ("retract" if swing_clamp else "clamped"))


def mode_of(name: str) -> str:
    """Name of the mode in `equations.accelerations`."""
    return "flight" if name in FLIGHT else name


def torque_of(name: str, state: State, parameters: State) -> Number:
    """Hip torque in a mode.

    In flight the parameters are gain, target and rate gain, and the sign of a clamp's argument; on the
    ground torque, friction, sign of the slip, and what keeps the guard of mid-stance away.
    """
    if name in FLIGHT:
        return eq.servo(state, parameters[0], parameters[1], parameters[2])
    return parameters[0]


def guards_of(name: str, state: State, parameters: State) -> list[Number]:
    """What falls to zero at the end of a mode."""
    if name == "place":
        return [state[1]]
    if name == "retract":
        return [eq.vertical_velocity(state)]
    if name == "clamped":
        clamp = parameters[3] * eq.servo(state, eq.KP, parameters[1], eq.KD) + eq.ARMED
        return [eq.vertical_velocity(state), clamp]
    if name == "graze":
        return [eq.sticking_force(state, eq.servo(state, eq.KP, parameters[1], eq.KD))[1]]
    tangential, normal = eq.sticking_force(state, parameters[0])
    upright = state[3] + parameters[3]
    if name == "slip":
        return [state[4] * parameters[2] + eq.ARMED, upright, normal]
    return [parameters[1] * normal - tangential, parameters[1] * normal + tangential, upright, normal]


def stride(section: State, run: Run, swing_clamp: bool) -> NDArray[np.float64]:
    """The apex after one stride from an apex, with the clamp of the swing or without it."""
    state, _ = run("place", eq.start(section), (eq.KP, eq.TOUCHDOWN_ANGLE, eq.KD, 1.0))
    state = eq.impact(state)
    for name, parameters in STANCE:
        state, guard = run(name, state, parameters)
        if name == "slip":
            state[4] = state[4] * (guard != 0)  # it has come to rest
    target = eq.LIFTOFF_FACTOR * state[3]
    state, _ = run("graze", state, (0.0, target, 0.0, 0.0))
    if not swing_clamp:
        state, _ = run("retract", state, (eq.KP, target, eq.KD, 0.0))
        return np.array(eq.apex(state))
    opened, closed = (eq.KP, target, eq.KD, 1.0), (0.0, target, 0.0, -1.0)
    for parameters in (opened, closed, opened):  # the clamp closes, and in other gaits opens again
        state, guard = run("clamped", state, parameters)
        if np.all(guard == 0):
            break
    return np.array(eq.apex(state))
