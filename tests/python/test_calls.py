"""Calls that importers make out of the usual order, through FMPy: as PyFMI and its users make them."""

import fmpy
import pytest
from conftest import unit_reference
from fmpy.fmi1 import FMICallException
from fmpy.simulation import instantiate_fmu

REFERENCE = unit_reference()


def test_a_unit_that_was_read_before_its_start_runs_as_ever(unpacked, description):
    """PyFMI: load_fmu, get("gravity"), simulate."""
    unit = instantiate_fmu(unpacked, description, "CoSimulation")
    references = {variable.name: variable.valueReference for variable in description.modelVariables}
    assert unit.getReal([references["gravity"]]) == [0.01]
    assert unit.getInteger([references["contact.mode_index"]]) == [1]
    assert unit.getString([references["stride.word"]]) == [b""]
    with pytest.raises(FMICallException):
        unit.getReal([100000])
    rows = fmpy.simulate_fmu(
        unpacked, model_description=description, fmu_instance=unit, fmi_type="CoSimulation", stop_time=25.1,
        output=["stride.period"],
    )  # fmt: skip
    assert rows["stride.period"][-1] == pytest.approx(REFERENCE["period"], rel=1e-9)
