"""Co-Simulation of FMI 2.0 through FMPy: states across processes, derivatives. Gaits are in test_fmi3."""

import multiprocessing
import pathlib

import fmpy
from conftest import HANGS
from fmpy.fmi2 import FMU2Slave


class Slave:
    """A Co-Simulation instance that can be made in any process."""

    def __init__(self, unpacked):
        description = fmpy.read_model_description(unpacked)
        self.references = {variable.name: variable.valueReference for variable in description.modelVariables}
        self.model = FMU2Slave(
            guid=description.guid,
            unzipDirectory=unpacked,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="runner",
        )
        self.model.instantiate()

    def start(self):
        self.model.setupExperiment()
        self.model.enterInitializationMode()
        self.model.exitInitializationMode()

    def step(self, start, length):
        self.model.doStep(currentCommunicationPoint=start, communicationStepSize=length)

    def read(self, *names):
        return self.model.getReal([self.references[name] for name in names])

    def saved(self):
        state = self.model.getFMUstate()
        serialized = self.model.serializeFMUstate(state)
        self.model.freeFMUstate(state)
        return serialized

    def restore(self, serialized):
        state = self.model.deSerializeFMUstate(serialized)
        self.model.setFMUstate(state)
        self.model.freeFMUstate(state)


OBSERVED = (
    "time",
    "foot.x",
    "leg.angle",
    "hip.work",
    "stride.period",
    "apex.com_height",
    "energy.impact_loss",
)


def go_on(unpacked, serialized, queue):
    slave = Slave(unpacked)
    slave.restore(serialized)
    slave.step(12.5, 40.0)
    queue.put(slave.read(*OBSERVED))


def test_a_serialized_state_goes_on_in_another_process(unpacked):
    """Saved in mid-stance, with a stride under way; equal to the last bit."""
    slave = Slave(unpacked)
    slave.start()
    slave.step(0.0, 12.5)
    serialized = slave.saved()
    context = multiprocessing.get_context("spawn")
    queue = context.Queue()
    other = context.Process(target=go_on, args=(str(pathlib.Path(unpacked)), serialized, queue))
    other.start()
    there = queue.get(timeout=HANGS)
    other.join()
    slave.step(12.5, 40.0)
    assert slave.read(*OBSERVED) == there
