"""Feedback from stride to stride, through the unit: its tunable settings are set at each apex, in event mode.

    python examples/stride_feedback.py

A dead-beat law from the gait's exact return map sets the touchdown angle and the stance torque at every apex:
in two strides it takes away what a push has left, to first order, and in two more most of the rest. The
script is the importer: the unit in Model Exchange, with CVODE as FMPy has it. examples/stride_feedback does
the same in C, and both make the strides of `tdmf_slip.stride_map`.
"""

import shutil

import fmpy
import numpy as np
import tdmf_slip
from fmpy.fmi2 import FMU2Model
from fmpy.simulation import Input
from fmpy.sundials import CVodeSolver

SETTINGS = ("hip.touchdown_angle", "hip.stance_torque")
PUSH = {"foot.y": 0.05, "foot.vx": 0.05}
"""The foot is raised and pushed, and with it the whole runner, so much at the first apex: m, m/s."""
STRIDES = 6
TOLERANCE = 1e-13
LONGEST = 100.0
"""A stride that takes longer is none, s."""
APEX = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")


class Importer:
    """The unit in Model Exchange, from apex to apex; a context manager, gone with its files at the end."""

    def __init__(self, start_values):
        """Unpack the unit, initialize it with these values and stop in event mode, at the first apex."""
        self._folder = fmpy.extract(str(tdmf_slip.fmu_path()))
        self._description = fmpy.read_model_description(self._folder)
        self._references = {v.name: v.valueReference for v in self._description.modelVariables}
        self._booleans = {v.name for v in self._description.modelVariables if v.type == "Boolean"}
        self._unit = FMU2Model(
            guid=self._description.guid,
            unzipDirectory=self._folder,
            modelIdentifier=self._description.modelExchange.modelIdentifier,
            instanceName="runner",
        )
        self._unit.instantiate()
        for name, value in start_values.items():
            self[name] = value
        self._unit.setupExperiment()
        self._unit.enterInitializationMode()
        self._unit.exitInitializationMode()
        self._solver, self._time = None, 0.0

    def __enter__(self):
        """Return the runner itself."""
        return self

    def __exit__(self, *_):
        """Free the instance and remove the unpacked unit."""
        self._unit.freeInstance()
        shutil.rmtree(self._folder)

    def __getitem__(self, name):
        """Present value of a Real variable."""
        return self._unit.getReal([self._references[name]])[0]

    def __setitem__(self, name, value):
        """Set a start value, or at an event a setting."""
        if name in self._booleans:
            self._unit.setBoolean([self._references[name]], [bool(value)])
        else:
            self._unit.setReal([self._references[name]], [value])

    @property
    def apex(self):
        """The section as latched at the last apex."""
        return np.array([self[f"apex.{name}"] for name in APEX])

    @property
    def strides(self):
        """Number of strides completed so far."""
        return self._unit.getInteger([self._references["stride.count"]])[0]

    def advance_to_apex(self):
        """Run from event mode to the event that closes a stride; return False after a fall."""
        before, until = self.strides, self._time + LONGEST
        ended = self._update()
        while not ended:
            self._run_to_event(until)
            ended = self._update()
            if self.strides > before:
                return True
        return False

    def _update(self):
        """Have the unit take what was set into account; True if it ends the run."""
        again, ends = True, False
        while again and not ends:
            again, ends, *_ = self._unit.newDiscreteStates()
        return ends

    def _run_to_event(self, until):
        self._unit.enterContinuousTimeMode()
        if self._solver is None:
            self._solver = self._new_solver()
        self._solver.reset(self._time)
        found = asked = False
        while not (found or asked):
            if self._time >= until:
                raise RuntimeError(f"no stride closes by t = {until:g} s")
            found, _, self._time = self._solver.step(self._time, until)
            asked, _ = self._unit.completedIntegratorStep()
        self._unit.enterEventMode()

    def _new_solver(self):
        fmu = self._unit
        return CVodeSolver(
            nx=self._description.numberOfContinuousStates,
            nz=self._description.numberOfEventIndicators,
            get_x=fmu.getContinuousStates,
            set_x=fmu.setContinuousStates,
            get_dx=fmu.getDerivatives,
            get_z=fmu.getEventIndicators,
            get_nominals=fmu.getNominalsOfContinuousStates,
            set_time=fmu.setTime,
            input=Input(fmu, self._description, None),
            startTime=self._time,
            relativeTolerance=TOLERANCE,
            maxNumSteps=100_000,
        )


def law_of(gait):
    """The feedback: any that `tdmf_slip` makes, or one of your own."""
    return tdmf_slip.dead_beat(gait, SETTINGS, limits={"hip.stance_torque": (0.0, 0.6)})


def pushed(gait, pushes=PUSH):
    """Start values at the gait's apex, but for the push."""
    return gait.start_values | {name: gait.start_values[name] + push for name, push in pushes.items()}


def run(law, start_values, strides=STRIDES):
    """The apices of a run, the first one too, and the settings of each stride; a fall ends it."""
    with Importer(start_values) as runner:
        apices, settings = [runner.apex], []
        for _ in range(strides):
            settings.append(law.inputs_at(apices[-1]))
            for name, value in settings[-1].items():
                runner[name] = value
            if not runner.advance_to_apex():
                break
            apices.append(runner.apex)
        return np.array(apices), settings


def main():
    """Run with the law, and print what is left of the push after each stride."""
    gait = tdmf_slip.find_gait()
    law = law_of(gait)
    apices, settings = run(law, pushed(gait))
    print("stride  height - gait's  speed - gait's  " + "  ".join(SETTINGS))
    for stride, apex in enumerate(apices):
        height, speed = (apex - gait.apex)[:2]
        chosen = settings[stride].values() if stride < len(settings) else ()
        reported = "  ".join(f"{value:19.6f}" for value in chosen)
        print(f"{stride:6}  {height:15.2e}  {speed:14.2e}  {reported}")


if __name__ == "__main__":
    main()
