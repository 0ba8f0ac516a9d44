"""Co-Simulation through FMPy: reading before the start as PyFMI does, and states across processes."""

import multiprocessing

import fmpy
import pytest
from conftest import HANGS, unit_reference
from fmpy.fmi1 import FMICallException
from fmpy.simulation import instantiate_fmu

OBSERVED = "time", "foot.x", "leg.angle", "hip.work", "stride.period", "apex.com_height", "energy.impact_loss"


def new_unit(unpacked):
    """An instance, and the value references of the variables."""
    description = fmpy.read_model_description(unpacked)
    references = {variable.name: variable.valueReference for variable in description.modelVariables}
    return instantiate_fmu(unpacked, description, "CoSimulation"), references


def test_a_unit_that_was_read_before_its_start_runs_as_ever(unpacked, description):
    """PyFMI: load_fmu, get("gravity"), simulate."""
    unit, references = new_unit(unpacked)
    assert unit.getReal([references["gravity"]]) == [0.01]
    assert unit.getInteger([references["contact.mode_index"]]) == [1]
    assert unit.getString([references["stride.word"]]) == [b""]
    with pytest.raises(FMICallException):
        unit.getReal([100000])
    rows = fmpy.simulate_fmu(
        unpacked, model_description=description, fmu_instance=unit, fmi_type="CoSimulation", stop_time=25.1,
        output=["stride.period"],
    )  # fmt: skip
    assert rows["stride.period"][-1] == pytest.approx(unit_reference()["period"], rel=1e-9)


def observed_after_a_step(unit, references):
    unit.doStep(currentCommunicationPoint=12.5, communicationStepSize=40.0)
    return unit.getReal([references[name] for name in OBSERVED])


def go_on(unpacked, serialized, queue):
    unit, references = new_unit(unpacked)
    unit.setFMUstate(unit.deSerializeFMUstate(serialized))
    queue.put(observed_after_a_step(unit, references))


def test_a_serialized_state_goes_on_in_another_process(unpacked):
    """Saved in mid-stance, with a stride under way; equal to the last bit."""
    unit, references = new_unit(unpacked)
    unit.setupExperiment()
    unit.enterInitializationMode()
    unit.exitInitializationMode()
    unit.doStep(currentCommunicationPoint=0.0, communicationStepSize=12.5)
    serialized = unit.serializeFMUstate(unit.getFMUstate())
    context = multiprocessing.get_context("spawn")
    queue = context.Queue()
    other = context.Process(target=go_on, args=(str(unpacked), serialized, queue))
    other.start()
    there = queue.get(timeout=HANGS)
    other.join()
    assert observed_after_a_step(unit, references) == there
