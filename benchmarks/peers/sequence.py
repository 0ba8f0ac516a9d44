"""The modes of the stride `+0-0+` in their order, which every peer is told."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from . import equations as eq
from .equations import Number, State

Run: TypeAlias = Callable[[str, State, State], tuple[list[Number], Number]]
"""Takes a mode's name, a state and parameters to the first guard; returns the state and which."""
LONGEST = 100.0
"""Time within which every mode ends."""
STANCE = (
    ("slip", (0.0, 1.0, 1.0)),
    ("stick", (0.0, 1.0, 0.0)),
    ("slip", (0.0, 1.0, -1.0)),  # to mid-stance
    ("slip", (0.0, 0.0, -1.0)),
    ("stick", (0.0, 0.0, 0.0)),
    ("slip", (0.0, 0.0, 1.0)),
)
"""Modes and their parameters, in the order of `equations.PARAMETERS`."""


def modes_of(swing_clamp: bool) -> tuple[str, ...]:
    """Names of the modes of a stride, with the clamp or without it."""
    return tuple(
        name for name in eq.MODES if name not in (("retract",) if swing_clamp else ("released", "rest"))
    )


def stride(section: State, run: Run, swing_clamp: bool) -> NDArray[np.float64]:
    """The apex after one stride from an apex, with the clamp of the swing or without it."""
    state, _ = run("place", eq.start(section), (0.0, 0.0, 0.0))
    state = eq.impact(state)
    for name, parameters in STANCE:
        state, guard = run(name, state, parameters)
        if name == "slip":
            state[5] = state[5] * (guard != 0)  # it has come to rest
    parameters = (eq.leave(state)[-1], 0.0, 0.0)
    state, _ = run("graze", state, parameters)
    state = eq.leave(state)[:-1]
    for name in ("released", "rest", "released") if swing_clamp else ("retract",):
        state, guard = run(name, state, parameters)  # the clamp closes, and in other gaits opens again
        if np.all(guard == 0):
            break
    return np.array(eq.apex(state))
