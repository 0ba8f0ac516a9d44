"""The unit in Co-Simulation through FMPy's instance API, with variables by name: what the examples share."""

import shutil

import fmpy
import tdmf_slip
from fmpy.fmi2 import FMU2Slave


class Runner:
    """One running instance; a context manager, gone with its files at the end."""

    def __init__(self, step):
        """Unpack the unit, instantiate and initialize it; `step` is the communication step."""
        self.step = step
        self.steps_taken = 0
        self._folder = fmpy.extract(str(tdmf_slip.fmu_path()))
        description = fmpy.read_model_description(self._folder)
        self._variables = {variable.name: variable for variable in description.modelVariables}
        self._slave = FMU2Slave(
            guid=description.guid,
            unzipDirectory=self._folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="runner",
        )
        self._slave.instantiate()
        self._slave.setupExperiment()
        self._slave.enterInitializationMode()
        self._slave.exitInitializationMode()

    def __enter__(self):
        """Nothing more to do."""
        return self

    def __exit__(self, problem, *_):
        """Free the instance and remove the unpacked unit."""
        if problem is None:
            self._slave.terminate()
        self._slave.freeInstance()
        shutil.rmtree(self._folder)

    @property
    def time(self):
        """Where the last communication step ended."""
        return self.steps_taken * self.step

    def __getitem__(self, name):
        """Present value of a variable."""
        variable = self._variables[name]
        kind = "Integer" if variable.type == "Enumeration" else variable.type
        (value,) = getattr(self._slave, f"get{kind}")([variable.valueReference])
        return value.decode() if kind == "String" else value

    def __setitem__(self, name, value):
        """Set an input."""
        self._slave.setReal([self._variables[name].valueReference], [value])

    def advance(self):
        """Take one communication step; True if a stride closed in it."""
        strides = self["stride.count"]
        self._slave.doStep(currentCommunicationPoint=self.time, communicationStepSize=self.step)
        self.steps_taken += 1
        return self["stride.count"] > strides
