"""Calls that importers make out of the usual order, through FMPy: as PyFMI and its users make them."""

import fmpy
import numpy as np
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


def test_a_state_space_is_found_by_setting_states_one_by_one(new_instance):
    """PyFMI's get_state_space_representation, which took the refusals for zeros."""
    step = 1e-6
    instance = new_instance()
    instance.start()
    instance.model.enterContinuousTimeMode()
    slopes = [f"der({name})" for name in instance.states]
    columns = []
    exact = []
    for name in instance.states:
        (value,) = instance.real(name)
        sides = []
        for shift in (-step, step):
            instance.set_values({name: value + shift})
            sides.append(instance.real(*slopes))
        instance.set_values({name: value})
        columns.append((sides[1] - sides[0]) / (2 * step))
        unknowns = [instance.references[slope] for slope in slopes]
        exact.append(instance.model.getDirectionalDerivative(unknowns, [instance.references[name]], [1.0]))
    assert np.count_nonzero(columns) > 20
    assert np.allclose(columns, exact, atol=1e-8)
