"""Runs of units of FMI 2.0 call by call: Co-Simulation, and Model Exchange by any integrator."""

import functools
import itertools
from ctypes import POINTER, byref, c_double

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Model, FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.logging import addLoggerProxy
from scipy.integrate import DOP853

TYPES = {kind: kind for kind in ("Real", "Integer", "Boolean", "String")} | {"Enumeration": "Integer"}


@functools.cache
def unpacked(path):
    return extract(path), read_model_description(path)


def address(values):
    return values.ctypes.data_as(POINTER(c_double))


class UnitRun:
    """A run of a unit in an interface, "me" or "cs", that has begun unless `begins` is false."""

    def __init__(self, path, interface, begins=True, logs=False, time=0.0, **values):
        folder, description = unpacked(path)
        self.interface, self.time, self.messages = interface, time, []
        self.of = {v.name: v for v in description.modelVariables}
        self.count, self.guards = description.numberOfContinuousStates, description.numberOfEventIndicators
        kind = FMU2Slave if interface == "cs" else FMU2Model
        given = {"guid": description.guid, "modelIdentifier": description.modelName, "instanceName": "run"}
        self.fmu = kind(unzipDirectory=folder, **given)
        callbacks = fmi2CallbackFunctions()
        callbacks.logger = fmi2CallbackLoggerTYPE(self._log)
        addLoggerProxy(byref(callbacks))
        self.fmu.instantiate(callbacks=callbacks, loggingOn=logs)
        self.fmu.setupExperiment(startTime=time)
        for name, value in values.items():
            self.write(name.replace("__", "."), value)
        self.fmu.enterInitializationMode()
        if begins:
            self.begin()

    def _log(self, _environment, _name, _status, _category, text):
        self.messages.append(text.decode())

    def begin(self):
        self.fmu.exitInitializationMode()
        self.terminates = False
        if self.interface == "me":
            self.update()
            self.fmu.enterContinuousTimeMode()

    def write(self, name, value):
        getattr(self.fmu, f"set{TYPES[self.of[name].type]}")([self.of[name].valueReference], [value])

    def __getitem__(self, name):
        value = getattr(self.fmu, f"get{TYPES[self.of[name].type]}")([self.of[name].valueReference])[0]
        return value.decode() if isinstance(value, bytes) else value

    def slope(self, result, known):
        """A directional derivative."""
        references = [self.of[result].valueReference], [self.of[known].valueReference]
        return self.fmu.getDirectionalDerivative(*references, [1.0])[0]

    def differences(self, results, known, step=1e-6):
        """Derivatives of results by a variable, by central differences."""
        value, found = self[known], []
        for shift in (step, -step):
            self.write(known, value + shift)
            found.append([self[result] for result in results])
        self.write(known, value)
        return (np.array(found[0]) - found[1]) / (2 * step)

    # ---- Model Exchange

    def update(self):
        """Let the discrete states settle."""
        needed = True
        while needed:
            needed, self.terminates, *_ = self.fmu.newDiscreteStates()

    @property
    def states(self):
        x = np.zeros(self.count)
        self.fmu.getContinuousStates(address(x), self.count)
        return x

    def at(self, time, x, what, count):
        """Derivatives or event indicators at trial states."""
        x, found = np.ascontiguousarray(x), np.zeros(count)
        self.fmu.setTime(time)
        self.fmu.setContinuousStates(address(x), self.count)
        getattr(self.fmu, f"get{what}")(address(found), count)
        return found

    def rates(self, time, x):
        return self.at(time, x, "Derivatives", self.count)

    def indicators(self, time, x):
        return self.at(time, x, "EventIndicators", self.guards)

    def event(self, **values):
        """Enter event mode, set inputs, and leave it."""
        self.fmu.enterEventMode()
        for name, value in values.items():
            self.write(name.replace("__", "."), value)
        self.update()
        self.fmu.enterContinuousTimeMode()

    def complete(self):
        return self.fmu.completedIntegratorStep()[0]

    def euler_step(self, size):
        """A step of explicit Euler. An event in it is seen at its end, and taken there."""
        x, time = self.states, self.time
        before = self.indicators(time, x) > 0
        x = x + size * self.rates(time, x)
        self.time = time + size
        happened = (self.indicators(self.time, x) > 0) != before
        if self.complete() or happened.any():
            self.event()

    def integrate(self, until, rtol=1e-11):
        """Go on by DOP853, each step searched for the first change of sign of an indicator."""
        while self.time < until and not self.terminates:
            solver = DOP853(self.rates, self.time, self.states, until, rtol=rtol, atol=1e-13, max_step=0.05)
            happened = False
            while solver.status == "running" and not happened:
                solver.step()
                happened = self._follow(solver.dense_output())
            if happened:
                self.event()

    def _follow(self, motion):
        before = self.indicators(motion.t_old, motion(motion.t_old)) > 0

        def changes(time):
            return ((self.indicators(time, motion(time)) > 0) != before).any()

        points = np.linspace(motion.t_old, motion.t, 5)
        for low, high in itertools.pairwise(points):
            if changes(high):
                while low < (low + high) / 2 < high:
                    middle = (low + high) / 2
                    low, high = (low, middle) if changes(middle) else (middle, high)
                self.indicators(high, motion(high))
                self.time = high
                self.complete()
                return True
        self.time = motion.t
        return self.complete()

    # ---- both

    def to(self, until, **values):
        """Set inputs, and go on to a time."""
        if self.interface == "cs":
            for name, value in values.items():
                self.write(name.replace("__", "."), value)
            self.fmu.doStep(self.time, until - self.time)
            self.time = until
            return self
        if values:
            self.event(**values)
        self.integrate(until)
        return self
