"""The unit in Co-Simulation through FMPy's instance API, with variables by name: what the examples share."""

import shutil

import fmpy
import tdmf_slip
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave


class Runner:
    """One running instance of either FMI version; a context manager that removes its files at the end."""

    def __init__(self, step, start_values=None, fmi=2):
        """Unpack the unit and initialize it; `step` is the communication step, `fmi` the version, 2 or 3."""
        self.step = step
        self.steps_taken = 0
        self._folder = fmpy.extract(str(tdmf_slip.fmu_path(fmi=fmi)))
        description = fmpy.read_model_description(self._folder)
        self._variables = {variable.name: variable for variable in description.modelVariables}
        self._slave = (FMU3Slave if fmi == 3 else FMU2Slave)(
            guid=description.guid,
            unzipDirectory=self._folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="runner",
        )
        self._slave.instantiate()
        for name, value in (start_values or {}).items():
            self[name] = value
        if fmi == 2:
            self._slave.setupExperiment()
        self._slave.enterInitializationMode()
        self._slave.exitInitializationMode()

    def __enter__(self):
        """Return the runner itself."""
        return self

    def __exit__(self, problem, *_):
        """Free the instance and remove the unpacked unit."""
        if problem is None:
            self._slave.terminate()
        self._slave.freeInstance()
        shutil.rmtree(self._folder)

    @property
    def time(self):
        """Time at which the last communication step ended."""
        return self.steps_taken * self.step

    def _call(self, verb, name, *values):
        """Call the get or set function of the variable's type."""
        variable = self._variables[name]
        kind = variable.type
        if kind == "Enumeration":
            kind = "Int64" if isinstance(self._slave, FMU3Slave) else "Integer"
        return getattr(self._slave, f"{verb}{kind}")([variable.valueReference], *values)

    def __getitem__(self, name):
        """Present value of a variable."""
        (value,) = self._call("get", name)
        return value.decode() if isinstance(value, bytes) else value

    def __setitem__(self, name, value):
        """Set a start value, before the run, or an input."""
        self._call("set", name, [value])

    def advance(self):
        """Take one communication step; True if a stride closed in it."""
        strides = self["stride.count"]
        self._slave.doStep(currentCommunicationPoint=self.time, communicationStepSize=self.step)
        self.steps_taken += 1
        return self["stride.count"] > strides
