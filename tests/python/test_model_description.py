"""The description inside the FMU: what schema and checkers see, and the faults that none of them notices."""

import html
import pathlib
import re
import shutil
import subprocess
import zipfile
from xml.etree import ElementTree

import fmpy
import pytest
import tdmf_slip
from fmpy.validation import validate_fmu


def number(text):
    return None if text is None else float(text)


def test_checker_finds_nothing(fmu_file):
    assert validate_fmu(fmu_file) == []


def test_the_default_experiment_has_ten_strides_and_no_more(fmu_file, description):
    """The stop time is the end of the tenth stride of the default gait, rounded up."""
    ends = {}
    for stop_time in (None, float(description.defaultExperiment.stopTime) - 1.0):
        rows = fmpy.simulate_fmu(
            fmu_file, fmi_type="CoSimulation", stop_time=stop_time, output=["stride.count"]
        )
        ends[stop_time] = rows["stride.count"][-1]
    assert list(ends.values()) == [10, 9]


def test_variables_have_units_ranges_and_descriptions(description):
    """Ranges hold the start values, angles are shown in degrees, and references count the variables."""
    units = {unit.name for unit in description.unitDefinitions}
    for place, variable in enumerate(description.modelVariables):
        name, declared = variable.name, variable.declaredType
        low, high = number(variable.min), number(variable.max)
        assert low is None or high is None or low < high, name
        if variable.start is not None and variable.type in ("Real", "Integer"):
            start = float(variable.start)
            assert (low is None or low <= start) and (high is None or start <= high), name
        if variable.type == "Real":
            unit = variable.unit or (declared and declared.unit)
            assert unit in units, name
            assert unit != "rad" or (variable.displayUnit or declared.displayUnit) == "deg", name
        assert variable.valueReference == place and variable.description, name
    assert len({variable.name for variable in description.modelVariables}) == place + 1


TUNABLE = {
    *("hip.stance_torque", "hip.touchdown_angle", "hip.kp", "hip.kd", "hip.liftoff_angle_factor"),
    *("hip.retraction_rate", "leg.thrust"),
}
DISCRETE_INPUTS = {
    *("ground.height", "ground.slope"),
    *("control.touchdown_angle", "control.stance_torque", "control.thrust"),
}
CONTINUOUS_INPUTS = {
    *("ground.friction", "hip.external_torque", "leg.extension", "body.external_fx", "body.external_fy"),
}


PROMISED = """
    leg.work energy.external_work ground.pending contact.normal contact.tangential leg.force stride.rise
    stride.hip_work stride.leg_work body.mass foot.mass leg.stiffness leg.damping leg.free_length
    leg.min_length gravity ground.static_friction_ratio ground.stribeck_velocity ground.patch_begin
    ground.patch_end ground.patch_friction hip.swing_clamp status.terminate_on_fall foot.x foot.y
    leg.length leg.angle foot.vx foot.vy leg.length_rate leg.angle_rate hip.work hip.place_time
    energy.damper_loss energy.friction_loss body.x body.y body.vx body.vy com.x com.y com.vx com.vy
    contact.fx contact.fy hip.torque energy.kinetic energy.potential energy.elastic energy.total
    hip.liftoff_angle contact.mode hip.phase energy.impact_loss event.count event.last_time
    status.fallen contact.mode_index hip.phase_index stride.count stride.period stride.length
    stride.speed stride.work stride.cost_of_transport stride.touchdowns stride.word stride.word_code
    stride.stance_time stride.duty_factor stride.slip_distance stride.positive_work stride.peak_force
    stride.peak_vertical_force apex.time apex.com_height apex.com_speed apex.leg_length apex.leg_angle
    apex.leg_length_rate apex.leg_angle_rate
"""
"""Variables beside the inputs and settings above, by the names that users were promised."""


def test_promised_names_are_there(description):
    names = {variable.name for variable in description.modelVariables}
    assert TUNABLE | DISCRETE_INPUTS | CONTINUOUS_INPUTS | {*PROMISED.split()} <= names
    assert sum(f"der({name})" in names for name in names) == 15


def test_causality_variability_and_initial(description):
    variables = {variable.name: variable for variable in description.modelVariables}
    inputs = {"continuous": set(), "discrete": set()}
    for variable in description.modelVariables:
        if variable.causality == "parameter":
            variability = "tunable" if variable.name in TUNABLE else "fixed"
            assert (variable.variability, variable.initial) == (variability, "exact"), variable.name
        if variable.causality == "input":
            inputs[variable.variability].add(variable.name)
        if variable.type != "Real" and variable.causality == "output":
            assert variable.variability == "discrete", variable.name
    assert inputs == {"continuous": CONTINUOUS_INPUTS, "discrete": DISCRETE_INPUTS}
    states = [unknown.variable.derivative for unknown in description.derivatives]
    assert [state.causality for state in states] == ["output"] * 15
    assert [state.initial for state in states] == ["exact"] * 8 + ["calculated"] * 7
    assert variables["time"].causality == "independent"


def test_inputs_carry_no_initial(unpacked):
    """Read from the file itself, because FMPy fills in a default."""
    root = ElementTree.parse(f"{unpacked}/modelDescription.xml").getroot()
    inputs = [element for element in root.find("ModelVariables") if element.get("causality") == "input"]
    assert len(inputs) == 10
    assert not any("initial" in element.attrib for element in inputs)


def test_the_page_lists_every_variable(unpacked, fmu):
    """Each row repeats the variable's description."""
    page = pathlib.Path(unpacked, "documentation", "index.html").read_text(encoding="utf-8")
    rows = re.findall(r"<tr><td><code>([^<]*)</code></td>((?:<td>[^<]*</td>){5})</tr>", page)
    assert [name for name, _ in rows] == list(fmu.variables)
    for name, row in rows:
        variable = fmu.variables[name]
        measure, allowed, start, kind, meaning = map(html.unescape, re.findall("<td>(.*?)</td>", row))
        assert (measure, kind) == (variable.unit.removesuffix("1"), variable.kind), name
        assert meaning == variable.description, name
        if variable.type == "Real" and variable.start is not None:
            given = [float(number) for number in (start, *allowed.split(" to "))]
            assert given == [variable.start, variable.minimum, variable.maximum], name


@pytest.mark.skipif(shutil.which("nm") is None, reason="nm is not installed")
def test_library_exports_fmi_functions_only(unpacked):
    library = next(pathlib.Path(unpacked, "binaries").rglob("TDMF_SLIP.so"))
    symbols = subprocess.run(
        ["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True
    )
    names = [line.split()[-1] for line in symbols.stdout.splitlines()]
    assert len(names) > 25 and all(name.startswith("fmi2") for name in names)


# ---- what importers take for granted -------------------------------------------------------------------


class Raw:
    """A unit's description as its file has it, a variable's own attributes and those of its type together."""

    def __init__(self, fmi):
        with zipfile.ZipFile(tdmf_slip.fmu_path(fmi=fmi)) as unit:
            root = ElementTree.fromstring(unit.read("modelDescription.xml"))

        def attributes_of(element):
            return element.attrib | (element[0].attrib if fmi == 2 else {})

        self.units = {
            unit.get("name"): {name: int(power) for name, power in unit.find("BaseUnit").attrib.items()}
            for unit in root.find("UnitDefinitions")
        }
        self.display_units = {
            (unit.get("name"), shown.get("name"))
            for unit in root.find("UnitDefinitions")
            for shown in unit.iter("DisplayUnit")
        }
        self.types = {element.get("name"): attributes_of(element) for element in root.find("TypeDefinitions")}
        variables = [attributes_of(element) for element in root.find("ModelVariables")]
        self.variables = [self.types.get(v.get("declaredType"), {}) | v for v in variables]
        self.first = 1 if fmi == 2 else 0
        structure = root.find("ModelStructure")
        self.unknowns = list(structure.iter("Unknown")) if fmi == 2 else list(structure)


@pytest.fixture(scope="module", params=[2, 3], ids=["FMI 2.0", "FMI 3.0"])
def raw(request):
    return Raw(request.param)


def test_types_and_units_are_defined_and_used(raw):
    assert {v["declaredType"] for v in raw.variables if "declaredType" in v} == set(raw.types)
    assert {v["unit"] for v in raw.variables if "unit" in v} == set(raw.units)
    shown = {(v["unit"], v["displayUnit"]) for v in raw.variables if "displayUnit" in v}
    assert shown == raw.display_units and len(shown) == 3


def test_a_derivative_has_its_state_s_unit_per_second(raw):
    derivatives = [v for v in raw.variables if "derivative" in v]
    assert len(derivatives) == 15
    for derivative in derivatives:
        state = raw.variables[int(derivative["derivative"]) - raw.first]
        expected = dict(raw.units[state["unit"]])
        expected["s"] = expected.get("s", 0) - 1
        found = raw.units[derivative["unit"]]
        assert found == {name: power for name, power in expected.items() if power}, derivative["name"]


def test_every_unknown_says_what_it_depends_on(raw):
    """CasADi reads no unit that leaves the list out, though the standards let it mean all."""
    assert all("dependencies" in unknown.attrib for unknown in raw.unknowns)
    guards = sum(v["name"].startswith("guard.") for v in raw.variables) if raw.first == 0 else 0
    outputs = sum(v.get("causality") == "output" for v in raw.variables)
    at_start = sum(
        v.get("initial") == "calculated" and not v["name"].startswith("guard.") for v in raw.variables
    )
    assert len(raw.unknowns) == outputs + 15 + at_start + guards
