"""The runner in a bigger system: an SSP description of it and a controller, run by two tools."""

import graphlib
import io
import pathlib
import re
import shutil
import sys
import zipfile

import fmpy.ssp
import numpy as np
import pytest
from conftest import succeed
from fmpy.fmi2 import FMU2Slave
from fmpy.ssp.simulation import simulate_ssp
from fmpy.validation import validate_fmu
from lxml import etree

STEP, STOP_TIME = 0.1, 150.0
pytestmark = pytest.mark.skipif(shutil.which("cmake") is None, reason="CMake is not installed")

CONTAINER = """
import sys
from fmu_manipulation_toolbox.cli.fmucontainer import fmucontainer
sys.exit(fmucontainer())
"""

# The container is another project's machine code: what it does in this process stays out of it.
RUN = """
import sys
import fmpy
import numpy
unit, rows, stop_time, step = sys.argv[1:]
numpy.save(rows, fmpy.simulate_fmu(unit, stop_time=float(stop_time), output_interval=float(step)))
"""


@pytest.fixture(scope="module")
def held(load_example):
    return load_example("held_runner")


@pytest.fixture(scope="module")
def system(held, tmp_path_factory):
    return held.build(tmp_path_factory.mktemp("system"))


@pytest.fixture(scope="module")
def expected(held):
    """The unit alone: time, position, leg angle, speed and touchdown angle after each step."""
    return np.array(held.by_communication(STEP, STOP_TIME))


def test_the_controller_is_a_sound_unit(system):
    assert not validate_fmu(str(system.with_name("STRIDE_CONTROLLER.fmu")))


def test_fmpy_runs_the_system_as_a_script_runs_the_unit_alone(system, expected):
    rows = simulate_ssp(str(system), stop_time=STOP_TIME, step_size=STEP)
    assert rows["runner.stride.count"][-1] == 5 and len(rows) == len(expected)
    assert len(np.unique(expected[:, 4])) == 6  # none at first, then one for each stride
    for name, column in (("position", 1), ("leg_angle", 2), ("speed", 3)):
        assert rows[name] == pytest.approx(expected[:, column], rel=1e-8, abs=1e-8), name


def test_a_container_runs_the_system_as_a_script_runs_the_unit_alone(system, expected, tmp_path):
    pytest.importorskip("fmu_manipulation_toolbox", exc_type=ImportError)
    shutil.copy(system, tmp_path)
    command = [sys.executable, "-c", CONTAINER, "-container", f"{system.name}:{STEP}", "-fmu-directory", "."]
    succeed(*command, cwd=tmp_path)
    unit = str(tmp_path / system.with_suffix(".fmu").name)
    table = tmp_path / "rows.npy"
    succeed(sys.executable, "-c", RUN, unit, table, STOP_TIME, STEP)
    rows = np.load(table)[1:]
    count = min(len(rows), len(expected))
    assert count > 1490
    for name, column in (("position", 1), ("leg_angle", 2), ("speed", 3)):
        assert rows[name][:count] == pytest.approx(expected[:count, column], rel=1e-8, abs=1e-8), name


# ---- what OMSimulator reads of it; the guide to other tools tells of its run ---------------------------


@pytest.fixture(scope="module")
def structure(system):
    """The system's description, checked against its schema, without namespaces as OMSimulator reads it."""
    with zipfile.ZipFile(system) as archive:
        content = archive.read("SystemStructure.ssd")
    schema = pathlib.Path(fmpy.ssp.__file__).parent / "schema" / "SystemStructureDescription.xsd"
    etree.XMLSchema(file=str(schema)).assertValid(etree.fromstring(content))
    return etree.fromstring(re.sub(rb' xmlns:\w+="[^"]*"', b"", content), etree.XMLParser(recover=True))


def test_omsimulator_finds_a_master_of_fixed_steps(structure):
    (master,) = structure.iter("oms:FixedStepMaster")
    assert master.get("description") == "oms-ma" and float(master.get("stepSize")) == STEP
    (annotation,) = structure.iter("ssc:Annotation")
    assert annotation.get("type") == "org.openmodelica"


def followers(system, structure, group):
    """(element, variable) -> what follows it at once, by connections and by what units declare of inputs."""
    edges = {}
    for connection in structure.iter("ssd:Connection"):
        start, end = (
            (connection.get(f"{side}Element"), connection.get(f"{side}Connector"))
            for side in ("start", "end")
        )
        edges.setdefault(start, []).append(end)
    for component in structure.iter("ssd:Component"):
        with zipfile.ZipFile(system) as archive, archive.open(component.get("source")) as unit:
            description = fmpy.read_model_description(io.BytesIO(unit.read()))
        inputs = {v.name: v for v in description.modelVariables if v.causality == "input"}
        for unknown in getattr(description, group):
            knowns = inputs.values() if unknown.dependencies is None else unknown.dependencies
            for known in (known for known in knowns if known.name in inputs):
                name = component.get("name")
                edges.setdefault((name, known.name), []).append((name, unknown.variable.name))
    return edges


@pytest.mark.parametrize("group", ["outputs", "initialUnknowns"])
def test_the_system_has_no_algebraic_loop(system, structure, group):
    edges = followers(system, structure, group)
    order = list(graphlib.TopologicalSorter(edges).static_order())
    assert {("runner", "stride.speed"), ("controller", "touchdown_angle")} <= set(order)


def test_the_controller_s_angle_follows_from_no_input_but_by_a_step(system, tmp_path):
    path = str(system.with_name("STRIDE_CONTROLLER.fmu"))
    description = fmpy.read_model_description(path)
    references = {v.name: v.valueReference for v in description.modelVariables}
    controller = FMU2Slave(
        guid=description.guid,
        unzipDirectory=fmpy.extract(path, str(tmp_path)),
        modelIdentifier="STRIDE_CONTROLLER",
        instanceName="controller",
    )
    controller.instantiate()
    controller.setupExperiment()
    controller.enterInitializationMode()
    angles = []
    for speed, strides in ((0.0, 0), (1.06, 0), (1.06, 1), (1.04, 1), (1.04, 2)):
        held = controller.getReal([references["touchdown_angle"]])
        controller.setReal([references["speed"]], [speed])
        controller.setInteger([references["strides"]], [strides])
        assert controller.getReal([references["touchdown_angle"]]) == held
        if not angles:
            controller.exitInitializationMode()
        controller.doStep(0.1 * len(angles), 0.1)
        angles += controller.getReal([references["touchdown_angle"]])
    controller.freeInstance()
    assert angles == pytest.approx([0.0, 0.0, 0.05, 0.05, -0.04], abs=1e-15)


def test_the_speed_is_held(held):
    """The speed without the controller is 1.0609."""
    assert held.by_communication(STEP, 400.0)[-1][3] == pytest.approx(held.WANTED_SPEED, abs=1e-4)


def test_waiting_for_a_communication_point_costs_in_proportion_to_the_step(held):
    coarse, fine = (held.cost_of_delay(step, 200.0) for step in (0.1, 0.01))
    assert 5 < coarse / fine < 20 and coarse < 1e-4
