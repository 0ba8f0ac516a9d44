"""Runs of the library's native solver, with the names of the runner's page."""

from functools import reduce
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from tdmf_slip.library.binding import c, ffi

TABLE = ElementTree.parse(Path(__file__).resolve().parents[2] / "modelDescription.xml")
VARIABLES = {v.get("name"): v for v in TABLE.iter("ScalarVariable")}
"""The unit's variables, by name."""

STATES = (
    "seen_x", "seen_y", "length", "angle", "seen_vx", "seen_vy", "length_rate", "angle_rate", "work",
    "placing", "leg_work", "damper_loss", "friction_loss", "positive_work_so_far", "external_work",
)  # fmt: skip
"""The states of a motion in the library's order, by the names of the page."""
CONTACTS = ("", "flight", "stick", "slip+", "slip-", "graze")
PHASES = ("", "drive", "coast", "retract", "place")


def write(struct, values):
    """Write values to a struct by the unit's names, "ground.friction"."""
    for name, value in values.items():
        *path, last = name.split(".")
        setattr(reduce(getattr, path, struct), last, value)


class NativeRun:
    """A run from a state of the world; `refused` names what was refused."""

    def __init__(self, parameters, inputs, state, tolerance=1e-12, step_limit=None):
        self.parameters = ffi.new("tdmf_parameters *", c.tdmf_default_parameters())
        self.inputs, self.rates = ffi.new("tdmf_inputs *", c.tdmf_default_inputs()), ffi.new("tdmf_inputs *")
        write(self.parameters, parameters)
        write(self.inputs, inputs)
        self.model, self.motion = ffi.new("tdmf_model *"), ffi.new("tdmf_motion *")
        self.system = ffi.new("tdmf_system *", {"model": self.model, "inputs": self.inputs})
        self.solver, self.log = ffi.new("tdmf_solver *", c.tdmf_solver_default()), ffi.new("tdmf_event_log *")
        self.solver.relative_tolerance, self.solver.log = tolerance, self.log
        self.solver.step_limit = step_limit or self.solver.step_limit
        self.refused = self._create()
        if not self.refused:
            self.motion.state[0 : len(state)] = list(state)
            self.refused = self._text(c.tdmf_start(self.system[0], self.motion))
        self.modes, self.outcome = [self._mode(0.0, self.motion.mode)], 0
        self.noted_until = np.inf

    def _text(self, refusal):
        return ffi.string(refusal.variable).decode() if refusal.variable else ""

    def _create(self):
        return self._text(c.tdmf_model_create(self.model, self.parameters))

    def _mode(self, time, mode):
        return time, CONTACTS[mode.contact], PHASES[mode.phase]

    def to(self, until):
        """Go on to a time, in pieces because the log has room for few events; inputs are ramped."""
        for end in np.linspace(self.motion.time, until, 9)[1:] if until > self.motion.time else [until]:
            elapsed, self.log.count = end - self.motion.time, 0
            self.outcome = c.tdmf_native_advance(self.solver, self.system[0], self.rates, end, self.motion)
            self.inputs[0] = c.tdmf_inputs_after(self.inputs, self.rates, elapsed)
            taken = self.log.events[0 : min(self.log.count, 32)]
            self.modes += [self._mode(e.time, e.after) for e in taken]
            if self.log.count > len(taken):
                self.noted_until = min(self.noted_until, taken[len(taken) - 1].time)
        return self

    def set(self, parameters=(), inputs=(), rates=()):
        """Set parameters, inputs and the rates of inputs, by the unit's names."""
        write(self.parameters, dict(parameters))
        write(self.inputs, dict(inputs))
        write(self.rates, dict(rates))
        self.refused = self._create()
        self.to(self.motion.time)  # a jump changes the mode at once, which is not logged
        self.modes.append(self._mode(self.motion.time, self.motion.mode))

    @property
    def fell(self):
        return bool(self.motion.mode.fallen)

    @property
    def state(self):
        return dict(zip(STATES, np.array(list(self.motion.state)), strict=True))

    @property
    def word(self):
        return ffi.string(self.motion.record.stride.word).decode()


def clipped(name, value):
    """A value within the allowed range of a variable."""
    limits = VARIABLES[name][0]
    return float(np.clip(value, float(limits.get("min")), float(limits.get("max"))))


def lasting(modes, unit=1.0, until=np.inf):
    """Modes that last, each with the time at which it begins. Modes that follow one another differ."""
    found = []
    for time, *mode in modes:
        if time > until:
            break
        while found and time - found[-1][0] < max(1e-9 * unit, 1e-13 * time):
            found.pop()
        if not found or found[-1][1:] != (*mode,):
            found.append((time, *mode))
    return found
