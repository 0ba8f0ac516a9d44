"""The FMI 3.0 unit through FMPy: the strides of the FMI 2.0 unit, in every way of running it."""

import pathlib
import zipfile
from xml.etree import ElementTree

import fmpy
import numpy as np
import pytest
from fmpy.validation import validate_fmu
from lxml import etree

PLAIN = {"fmi_type": "CoSimulation"}
EVENT_MODE = PLAIN | {"use_event_mode": True}
EARLY_RETURN = EVENT_MODE | {"early_return_allowed": True}


def test_early_return_records_both_sides_of_every_event(unpacked3):
    """An impact stops the foot's fall; the rows of one instant are its left and its right limit."""
    rows = fmpy.simulate_fmu(
        unpacked3,
        stop_time=24.7,
        output_interval=1.0,
        output=["foot.vy", "body.vy", "contact.mode", "event.count"],
        **EARLY_RETURN,
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
    given = {"stop_time": 20.0, "output_interval": 1.0, "input": ice}
    given["output"] = ["foot.x", "energy.friction_loss", "ground.friction"]
    ways = PLAIN, EVENT_MODE, EARLY_RETURN
    ends = [fmpy.simulate_fmu(unpacked3, **given, **options)[-1] for options in ways]
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


def test_the_structure_is_that_of_fmi2(description, description3):
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
