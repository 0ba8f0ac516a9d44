"""The stride by heyoka: a Taylor integrator for each mode, with its events, compiled, not in compact mode."""

import time
from collections.abc import Sequence

import heyoka as hy
import numpy as np

from . import equations as eq

LONGEST = 100.0
"""Time within which every mode ends."""
MOVING = {"flight": range(8), "stick": (2, 3, 6, 7), "slip": (0, 2, 3, 4, 6, 7), "graze": (0, 2, 3, 4, 6, 7)}
"""Indices of the states that change in a mode."""


class Peer:
    """Integrators of all modes at one tolerance."""

    name = f"heyoka {hy.__version__}"

    def __init__(self, tolerance: float) -> None:
        """Compile them."""
        state = hy.make_vars(*eq.STATES)
        falls = hy.event_direction.negative
        first, second, third, fourth = (hy.par[i] for i in range(4))
        stays = eq.sticking_force(state, first, hy.sin, hy.cos)
        self.seconds = 0.0
        """Spent in integrators so far."""
        # Parameters of flight: gain, target, rate gain, sign of the clamp's argument; on the ground: torque,
        # friction, sign of the slip, and what keeps the guard of mid-stance away once it has passed.
        torque = -first * (state[3] - second) - third * state[7]
        lands, peaks = state[1], eq.rise(state, hy.sin, hy.cos)
        clamp = fourth * eq.servo(state, second) + eq.ARMED
        upright = state[3] + fourth
        lifts = eq.sticking_force(state, eq.servo(state, second), hy.sin, hy.cos)[1]
        cone = [second * stays[1] - stays[0], second * stays[1] + stays[0]]
        slips = [state[4] * third + eq.ARMED, upright, stays[1]]
        guards = {
            "place": ("flight", [hy.t_event(lands, direction=falls)]),
            "retract": ("flight", [hy.t_event(peaks, direction=falls), hy.t_event(clamp, direction=falls)]),
            "slip": ("slip", [hy.t_event(guard, direction=falls) for guard in slips]),
            "stick": ("stick", [hy.t_event(guard, direction=falls) for guard in (*cone, upright, stays[1])]),
            "graze": ("graze", [hy.t_event(lifts, direction=falls)]),
        }
        self._integrators = {}
        for name, (mode, events) in guards.items():
            applied = torque if mode == "flight" else first
            integrator = self._integrator(mode, state, applied, events, tolerance)
            self._integrators[name] = integrator, MOVING[mode]

    @staticmethod
    def _integrator(mode: str, state: Sequence, torque: object, events: list, tolerance: float) -> object:
        ax, ay, r_acceleration, theta_acceleration = eq.accelerations(
            mode, state, torque, hy.par[1], hy.sin, hy.cos
        )
        rates = [*state[4:], ax, ay, r_acceleration, theta_acceleration]
        system = [(state[i], rates[i]) for i in MOVING[mode]]
        start = [0.1] * len(system)
        return hy.taylor_adaptive(system, start, t_events=events, tol=tolerance, compact_mode=False)

    def _run(self, name: str, state: Sequence[float], parameters: Sequence[float]) -> tuple[list[float], int]:
        """The state at the first event of a mode, and which it was."""
        integrator, moving = self._integrators[name]
        integrator.time = 0.0
        integrator.state[:] = [state[i] for i in moving]
        integrator.pars[:] = parameters[: len(integrator.pars)]
        integrator.reset_cooldowns()
        begin = time.perf_counter()
        outcome = int(integrator.propagate_until(LONGEST)[0])
        self.seconds += time.perf_counter() - begin
        reached = list(state)
        for i, value in zip(moving, integrator.state, strict=True):
            reached[i] = value
        return reached, -outcome - 1

    def stride(self, section: Sequence[float]) -> np.ndarray:
        """The apex after one stride of the gait `+0-0+` from an apex."""
        mu, drive = eq.FRICTION, -eq.STANCE_TORQUE
        state, _ = self._run("place", eq.start(section), (eq.KP, eq.TOUCHDOWN_ANGLE, eq.KD, 1.0))
        state = eq.impact(state)
        for name, torque, friction, sign, passed in (
            ("slip", drive, mu, 1.0, 0.0),
            ("stick", drive, mu, 0.0, 0.0),
            ("slip", drive, -mu, -1.0, 0.0),  # to mid-stance
            ("slip", 0.0, -mu, -1.0, 10.0),
            ("stick", 0.0, mu, 0.0, 10.0),
            ("slip", 0.0, mu, 1.0, 10.0),
        ):
            state, guard = self._run(name, state, (torque, friction, sign, passed))
            if name == "slip" and guard == 0:
                state[4] = 0.0
        target = eq.LIFTOFF_FACTOR * state[3]
        state, _ = self._run("graze", state, (0.0, target, 0.0, 0.0))
        opened, closed = (eq.KP, target, eq.KD, 1.0), (0.0, target, 0.0, -1.0)
        for parameters in (opened, closed, opened):  # the clamp closes, and in other gaits opens again
            state, guard = self._run("retract", state, parameters)
            if guard == 0:
                break
        return np.array(eq.apex(state))
