"""The equations, compiled by Numba in a loop written by hand: DOP853's pair, events by the secant method.

The tableau is SciPy's. A step over which a guard falls to zero is repeated, shorter, until it ends at the
event: simple, and what most people do.
"""

import math
from collections.abc import Sequence
from typing import Any, TypeAlias

import numba
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853
from tdmf_slip.library.section import Apex

from . import equations as eq
from . import sequence

A, B, C, E3, E5 = (np.ascontiguousarray(x) for x in (DOP853.A, DOP853.B, DOP853.C, DOP853.E3, DOP853.E5))
STAGES = DOP853.n_stages
NAMES = tuple(eq.MODES)
MOST_GUARDS, STATES = eq.MOST_GUARDS, max(eq.MOVING.values())
EVENT_LIMIT = 60
STEP_LIMIT = 100000
SAFETY, SHRINK, GROW = 0.9, 0.2, 10.0
CLOSE = 1e-14
"""Fraction of a step to which the secant method locates an event."""

Vector: TypeAlias = NDArray[np.float64]

_jit = numba.njit(cache=False, error_model="numpy", fastmath=False)


def _compiled_modes(of_mode: Any) -> Any:
    """The function of all modes, by the number of the mode in `NAMES`."""
    place, retract, released, rest, stick, slip, graze = (
        _jit(eq.written(of_mode, name, math)) for name in NAMES
    )

    @_jit
    def of_number(mode: int, s: Vector, p: Vector, out: Vector) -> int:
        if mode == 0:
            return int(place(s, p, out))
        if mode == 1:
            return int(retract(s, p, out))
        if mode == 2:
            return int(released(s, p, out))
        if mode == 3:
            return int(rest(s, p, out))
        if mode == 4:
            return int(stick(s, p, out))
        return int(slip(s, p, out)) if mode == 5 else int(graze(s, p, out))

    return of_number


_rates, _guards = _compiled_modes(eq.rates), _compiled_modes(eq.guards)


@_jit
def _step(
    mode: int,
    s: Vector,
    p: Vector,
    h: float,
    k: Vector,
    reached: Vector,
) -> None:
    """One step of length h; k[0] holds the rates at its start."""
    for stage in range(1, STAGES):
        for i in range(STATES):
            reached[i] = s[i]
            for j in range(stage):
                reached[i] += h * A[stage, j] * k[j, i]
        _rates(mode, reached, p, k[stage])
    for i in range(STATES):
        reached[i] = s[i]
        for j in range(STAGES):
            reached[i] += h * B[j] * k[j, i]
    _rates(mode, reached, p, k[STAGES])


@_jit
def _error(s: Vector, reached: Vector, k: Vector, h: float, tolerance: float) -> float:
    """Error estimate of SciPy's DOP853."""
    fifth, third = 0.0, 0.0
    for i in range(STATES):
        scale = tolerance + tolerance * max(abs(s[i]), abs(reached[i]))
        e5, e3 = 0.0, 0.0
        for j in range(STAGES + 1):
            e5 += E5[j] * k[j, i]
            e3 += E3[j] * k[j, i]
        fifth += (e5 / scale) ** 2
        third += (e3 / scale) ** 2
    if fifth == 0.0 and third == 0.0:
        return 0.0
    return float(abs(h) * fifth / np.sqrt((fifth + 0.01 * third) * STATES))


@_jit
def _first_fallen(before: Vector, after: Vector, count: int) -> int:
    for i in range(count):
        if before[i] > 0.0 and after[i] <= 0.0:
            return i
    return -1


@_jit
def _run_mode(mode: int, s: Vector, p: Vector, tolerance: float, longest: float) -> tuple[int, int]:
    """Takes s to the first guard that falls to zero; which, and how many steps that took."""
    k = np.zeros((STAGES + 1, STATES))
    reached, before, after = np.empty(STATES), np.empty(MOST_GUARDS), np.empty(MOST_GUARDS)
    t, h = 0.0, 0.1
    _rates(mode, s, p, k[0])
    count = _guards(mode, s, p, before)
    for steps in range(1, STEP_LIMIT):
        if t >= longest:
            return -1, steps
        _step(mode, s, p, h, k, reached)
        error = _error(s, reached, k, h, tolerance)
        if error >= 1.0:
            h *= max(SHRINK, SAFETY * error ** (-1.0 / 8.0))
            continue
        _guards(mode, reached, p, after)
        fired = _first_fallen(before, after, count)
        if fired >= 0:
            fired = _end_at_event(mode, s, p, h, k, reached, before, after, count)
            s[:] = reached
            return fired, steps
        s[:] = reached
        t += h
        k[0, :] = k[STAGES, :]
        before[:] = after
        h *= GROW if error == 0.0 else min(GROW, SAFETY * error ** (-1.0 / 8.0))
    return -1, STEP_LIMIT


@_jit
def _end_at_event(
    mode: int,
    s: Vector,
    p: Vector,
    h: float,
    k: Vector,
    reached: Vector,
    before: Vector,
    after: Vector,
    count: int,
) -> int:
    """Repeats the step until it ends just past its first event, by the Illinois method."""
    low, high = 0.0, h
    fired = _first_fallen(before, after, count)
    g_low, g_high = before[fired], after[fired]
    trial = np.empty(MOST_GUARDS)
    for _ in range(EVENT_LIMIT):
        if high - low <= CLOSE * h or g_high == 0.0:
            break
        middle = high - g_high * (high - low) / (g_high - g_low)
        middle = min(max(middle, low + 0.1 * CLOSE * h), high - 0.1 * CLOSE * h)
        _step(mode, s, p, middle, k, reached)
        _guards(mode, reached, p, trial)
        other = _first_fallen(before, trial, count)
        if other >= 0:
            if other != fired:
                fired, g_low = other, before[other]
                low = 0.0
            else:
                g_low *= 0.5
            high, g_high = middle, trial[fired]
        else:
            low, g_low = middle, trial[fired]
            g_high *= 0.5
    _step(mode, s, p, high, k, reached)
    return fired


class Peer:
    """The compiled loop at a tolerance."""

    name = f"numba {numba.__version__}"

    def __init__(self, tolerance: float, swing_clamp: bool) -> None:
        """Compiled at the first stride."""
        self._tolerance, self._swing_clamp = tolerance, swing_clamp
        self.seconds = 0.0
        self.evaluations: int | None = 0
        """Evaluations of the right-hand side so far, without event location."""

    def _run(self, name: str, state: Sequence[float], parameters: Sequence[float]) -> tuple[list[float], int]:
        now = np.zeros(STATES)
        now[: len(state)] = state
        guard, steps = _run_mode(
            NAMES.index(name), now, np.array(parameters, dtype=float), self._tolerance, sequence.LONGEST
        )
        self.evaluations = (self.evaluations or 0) + STAGES * steps
        return now[: len(state)].tolist(), guard

    def stride(self, section: Apex) -> Vector:
        """The apex after one stride from an apex."""
        return sequence.stride(list(section), self._run, self._swing_clamp)
