"""The runner in a bigger system: an SSP description of it and a controller, run by two tools."""

import importlib
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pytest
from fmpy.ssp.simulation import simulate_ssp
from fmpy.validation import validate_fmu

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
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
def example():
    sys.path.insert(0, str(EXAMPLES))
    yield importlib.import_module("held_runner")
    sys.path.remove(str(EXAMPLES))


@pytest.fixture(scope="module")
def system(example, tmp_path_factory):
    return example.build(tmp_path_factory.mktemp("system"))


@pytest.fixture(scope="module")
def expected(example):
    """The library's run: time, place, leg angle, speed and touchdown angle after each step."""
    return np.array(example.by_communication(STEP, STOP_TIME))


def test_the_controller_is_a_sound_unit(system):
    assert not validate_fmu(str(system.with_name("STRIDE_CONTROLLER.fmu")))


def test_fmpy_runs_the_system_as_the_library(system, expected):
    rows = simulate_ssp(str(system), stop_time=STOP_TIME, step_size=STEP)
    assert rows["runner.stride.count"][-1] == 5 and len(rows) == len(expected)
    assert len(np.unique(expected[:, 4])) == 6  # none at first, then one for each stride
    for name, column in (("place", 1), ("leg_angle", 2), ("speed", 3)):
        assert rows[name] == pytest.approx(expected[:, column], rel=1e-8, abs=1e-8), name


def test_a_container_runs_the_system_as_the_library(system, expected, tmp_path):
    pytest.importorskip("fmu_manipulation_toolbox", exc_type=ImportError)
    shutil.copy(system, tmp_path)
    command = [sys.executable, "-c", CONTAINER, "-container", f"{system.name}:{STEP}", "-fmu-directory", "."]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    unit = str(tmp_path / system.with_suffix(".fmu").name)
    table = tmp_path / "rows.npy"
    arguments = map(str, (unit, table, STOP_TIME, STEP))
    subprocess.run([sys.executable, "-c", RUN, *arguments], check=True, capture_output=True)
    rows = np.load(table)[1:]
    count = min(len(rows), len(expected))
    assert count > 1490
    for name, column in (("place", 1), ("leg_angle", 2), ("speed", 3)):
        assert rows[name][:count] == pytest.approx(expected[:count, column], rel=1e-8, abs=1e-8), name


def test_the_speed_is_held(example):
    """Without the controller the speed stays 1.0629."""
    rows = example.by_communication(STEP, 400.0)
    assert rows[-1][3] == pytest.approx(example.WANTED_SPEED, abs=1e-4)


def test_waiting_for_a_communication_point_costs_in_proportion_to_the_step(example):
    coarse, fine = (example.cost_of_delay(step, 200.0) for step in (1.0, 0.1))
    assert 5 < coarse / fine < 20 and coarse < 1e-3
