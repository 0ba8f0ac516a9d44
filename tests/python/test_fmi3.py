"""The FMI 3.0 unit through FMPy: the strides of the FMI 2.0 unit, in every way of running it."""

import ctypes
import pathlib
import zipfile
from xml.etree import ElementTree

import fmpy
import numpy as np
import pytest
from conftest import QUANTITIES, apex_start, name_of_gait, reference_gaits, runner_of_gait
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu
from lxml import etree

OUTPUTS = [f"stride.{name}" for name in QUANTITIES]
CO_SIMULATION = {
    "plain": {},
    "event mode": {"use_event_mode": True},
    "early return": {"use_event_mode": True, "early_return_allowed": True},
}


def start_of(gait):
    return apex_start(gait["apex"]) | runner_of_gait(gait)


def strides(fmu, gait, **options):
    rows = fmpy.simulate_fmu(
        fmu,
        stop_time=3.3 * gait["period"],
        output_interval=0.7,
        start_values=start_of(gait),
        output=[*OUTPUTS, "stride.count", "event.count", "contact.mode", "foot.x", "foot.y"],
        **options,
    )
    assert rows["stride.count"][-1] == 3
    return rows


@pytest.mark.parametrize("how", CO_SIMULATION)
@pytest.mark.parametrize("gait", reference_gaits(), ids=name_of_gait)
def test_co_simulation_has_the_reference_strides(unpacked3, gait, how):
    rows = strides(unpacked3, gait, fmi_type="CoSimulation", **CO_SIMULATION[how])
    for name in QUANTITIES:
        assert rows[f"stride.{name}"][-1] == pytest.approx(gait[name], rel=1e-8), name


@pytest.mark.parametrize("gait", reference_gaits(), ids=name_of_gait)
def test_model_exchange_has_the_reference_strides(unpacked3, gait):
    rows = strides(unpacked3, gait, fmi_type="ModelExchange", relative_tolerance=1e-9)
    for name in QUANTITIES:
        assert rows[f"stride.{name}"][-1] == pytest.approx(gait[name], rel=1e-6), name


@pytest.mark.parametrize("interface", ["ModelExchange", "CoSimulation"])
@pytest.mark.parametrize("gait", reference_gaits(), ids=name_of_gait)
def test_both_versions_record_the_same(unpacked, unpacked3, interface, gait):
    two, three = (strides(fmu, gait, fmi_type=interface) for fmu in (unpacked, unpacked3))
    assert len(two) == len(three)
    for name in two.dtype.names:
        assert np.array_equal(two[name], three[name]), name


def test_early_return_records_both_sides_of_every_event(unpacked3):
    """An impact stops the foot's fall; the rows of one instant are its left and its right limit."""
    rows = fmpy.simulate_fmu(
        unpacked3,
        fmi_type="CoSimulation",
        stop_time=24.7,
        output_interval=1.0,
        output=["foot.vy", "body.vy", "contact.mode", "event.count"],
        use_event_mode=True,
        early_return_allowed=True,
    )
    before = np.flatnonzero(np.diff(rows["time"]) == 0.0)
    assert len(before) == 8
    assert np.array_equal(np.diff(rows["event.count"])[before], np.ones(8))
    assert rows["body.vy"][before] == pytest.approx(rows["body.vy"][before + 1], abs=1e-9)
    touchdown = before[0]
    assert rows["contact.mode"][touchdown] == 1 and rows["contact.mode"][touchdown + 1] == 3
    assert rows["foot.vy"][touchdown] < -0.1 and rows["foot.vy"][touchdown + 1] == 0.0


def test_an_input_jumps_in_event_mode(unpacked3):
    """Ice from 12.2 on, in mid-stance: the jump is met on time in each way of running."""
    ice = np.array(
        [(0.0, 0.6), (12.2, 0.6), (12.2, 0.1), (30.0, 0.1)], [("time", "f8"), ("ground.friction", "f8")]
    )
    ends = [
        fmpy.simulate_fmu(
            unpacked3,
            fmi_type="CoSimulation",
            stop_time=20.0,
            output_interval=1.0,
            input=ice,
            output=["foot.x", "energy.friction_loss", "ground.friction"],
            **options,
        )[-1]
        for options in CO_SIMULATION.values()
    ]
    assert ends[0]["ground.friction"] == 0.1
    for end in ends[1:]:
        assert list(end) == pytest.approx(list(ends[0]), rel=1e-9)


# ---- the description and what lies beside it ----------------------------------------------------------


def test_checker_finds_nothing(fmu3):
    assert validate_fmu(fmu3) == []


def test_types_say_no_more_than_older_readers_take(fmu3):
    """FMPy 0.3.19 to 0.3.23 stumble over the description of a type."""
    with zipfile.ZipFile(fmu3) as unit:
        types = ElementTree.fromstring(unit.read("modelDescription.xml")).find("TypeDefinitions")
    assert len(types) > 15
    assert {name for declared in types for name in declared.attrib} == {
        "name",
        "quantity",
        "unit",
        "displayUnit",
    }


def dependencies(description, group):
    """Unknown -> names of what it depends on, or None where that is not said."""
    return {
        unknown.variable.name: unknown.dependencies and [known.name for known in unknown.dependencies]
        for unknown in getattr(description, group)
    }


def test_the_variables_are_those_of_fmi2(description, description3):
    names = {"Real": "Float64", "Integer": "Int32"}

    def attributes_of(variables):
        return [
            (
                v.name,
                v.valueReference,
                names.get(v.type, v.type),
                v.causality,
                v.variability,
                v.min,
                v.max,
                v.start,
            )
            for v in variables
        ]

    assert attributes_of(description3.modelVariables) == attributes_of(description.modelVariables)
    assert description3.instantiationToken == description.guid
    assert [u.variable.name for u in description3.derivatives] == [
        u.variable.name for u in description.derivatives
    ]
    for group in ("outputs", "derivatives", "initialUnknowns"):
        assert dependencies(description, group) == dependencies(description3, group)
    known = dependencies(description3, "outputs")
    assert known["stride.speed"] == [] and known["ground.pending"] == ["ground.height", "ground.slope"]
    initially = dependencies(description3, "initialUnknowns")
    assert initially["stride.speed"] == [] and len(initially["contact.mode"]) > 30
    guards = [v.name for v in description.modelVariables if v.name.startswith("guard.")]
    assert description3.numberOfEventIndicators == description.numberOfEventIndicators == len(guards) > 10


def test_files_beside_the_description_follow_their_schemas(fmu3):
    schemas = pathlib.Path(fmpy.__file__).parent / "schema" / "fmi3"
    with zipfile.ZipFile(fmu3) as unit:
        for name, schema in (
            ("sources/buildDescription.xml", "fmi3BuildDescription.xsd"),
            ("terminalsAndIcons/terminalsAndIcons.xml", "fmi3TerminalsAndIcons.xsd"),
        ):
            document = etree.fromstring(unit.read(name))
            assert etree.XMLSchema(file=str(schemas / schema)).validate(document), name
        assert "terminalsAndIcons/icon.png" in unit.namelist()


def test_terminals_speak_of_variables(fmu3, description3):
    names = {variable.name for variable in description3.modelVariables}
    with zipfile.ZipFile(fmu3) as unit:
        root = ElementTree.fromstring(unit.read("terminalsAndIcons/terminalsAndIcons.xml"))
    members = {
        terminal.get("name"): {member.get("variableName") for member in terminal}
        for terminal in root.iter("Terminal")
    }
    assert members["hip"] == {"hip.external_torque", "leg.angle", "leg.angle_rate"}
    assert {"contact.fx", "contact.fy", "ground.friction"} <= members["ground"]
    assert set().union(*members.values()) <= names


# ---- call by call -------------------------------------------------------------------------------------


@pytest.fixture
def make(unpacked3, description3):
    """Makes instances; frees them at the end of the test."""
    made = []

    def new(kind, **options):
        instance = kind(
            guid=description3.guid,
            unzipDirectory=unpacked3,
            modelIdentifier="TDMF_SLIP",
            instanceName="runner",
        )
        instance.instantiate(**options)
        made.append(instance)
        return instance

    yield new
    for instance in made:
        instance.freeInstance()


def test_a_serialized_state_goes_on_in_another_instance(make, description3):
    references = [v.valueReference for v in description3.modelVariables if v.type == "Float64"]
    one, other = make(FMU3Slave), make(FMU3Slave)
    one.enterInitializationMode()
    one.exitInitializationMode()
    one.doStep(0.0, 12.5)
    state = other.deserializeFMUState(one.serializeFMUState(one.getFMUState()))
    other.setFMUState(state)
    for instance in (one, other):
        instance.doStep(12.5, 20.0)
    assert one.getFloat64(references) == other.getFloat64(references)


def test_adjoint_and_directional_derivatives_agree(make, description3):
    references = {v.name: v.valueReference for v in description3.modelVariables}
    unknowns = [references[name] for name in ("der(foot.vx)", "body.y", "hip.torque")]
    knowns = [references[name] for name in ("leg.angle", "leg.length", "hip.external_torque")]
    model = make(FMU3Model)
    model.enterInitializationMode()
    model.exitInitializationMode()
    model.enterContinuousTimeMode()
    forward = np.array([model.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns])
    reverse = np.array(
        [model.getAdjointDerivative(unknowns, knowns, list(seed)) for seed in np.eye(len(unknowns))]
    )
    assert reverse == pytest.approx(forward.T, abs=1e-14)
    assert np.count_nonzero(forward) >= 5


def test_counts_never_change(make, description):
    model = make(FMU3Model)
    count = description.numberOfEventIndicators
    assert (model.getNumberOfContinuousStates(), model.getNumberOfEventIndicators()) == (15, count)
    model.enterInitializationMode()
    model.exitInitializationMode()
    model.enterContinuousTimeMode()
    indicators = (ctypes.c_double * count)()
    model.getEventIndicators(indicators, count)
    assert all(value > 0.0 for value in indicators)
