"""Examples that set the unit by a feedback at each apex make the strides of the library."""

import shutil
import sys

import numpy as np
import pytest
import tdmf_slip
from conftest import ROOT, run, succeed
from tdmf_slip.library.batch_tables import STRIDE_FATES


@pytest.fixture(scope="module")
def feedback(load_example):
    return load_example("stride_feedback")


def strides_of_library(law, first, count):
    """Apices of the library's run, with the first one."""
    run = tdmf_slip.stride_map({}, first, strides=count, law=law, tolerance=1e-13)
    return np.vstack([first, run["next_apex"].values[0]])


def check_strides(gait, law, apices):
    expected = strides_of_library(law, apices[0], len(apices) - 1)
    assert np.abs((apices - expected) / gait.runner.scales).max() < 1e-8
    left = np.abs((apices - gait.apex) / gait.runner.scales).max(axis=1)
    assert left[0] > 0.04 and left[-1] < 1e-6 < left[2]


def test_the_unit_driven_by_fmpy_makes_the_strides_of_the_library(feedback, gait):
    law = feedback.law_of(gait)
    apices, settings = feedback.run(law, feedback.pushed(gait))
    assert len(apices) == feedback.STRIDES + 1 and len(settings) == feedback.STRIDES
    check_strides(gait, law, apices)


def test_a_fall_ends_the_run_of_the_unit(feedback, gait):
    """A large push, with the ranges of the settings as the only limits, ends as in the library."""
    law = tdmf_slip.dead_beat(gait, feedback.SETTINGS)
    apices, settings = feedback.run(law, gait.start_values | {"foot.vx": gait.start_values["foot.vx"] + 2.0})
    assert len(apices) == 1 and len(settings) == 1
    assert tdmf_slip.stride_map({}, apices, law=law)["fate"].item() == STRIDE_FATES.index("fell")


@pytest.fixture(scope="module")
def program(fmu_file, tmp_path_factory):
    """Path of the built C program."""
    if shutil.which("cmake") is None:
        pytest.skip("CMake is not installed")
    folder = tmp_path_factory.mktemp("program")
    configure = ["cmake", "-S", ROOT / "examples" / "stride_feedback", "-B", folder, f"-DRUNNER={fmu_file}"]
    succeed(*configure, f"-DPython3_EXECUTABLE={sys.executable}")
    succeed("cmake", "--build", folder)
    (built,) = (path for path in folder.iterdir() if path.stem == "stride_feedback" and path.is_file())
    return built


def test_the_unit_driven_by_a_program_in_c_makes_the_strides_of_the_library(feedback, gait, program):
    """The numbers of the law in the C program are those that the Python example computes."""
    header, *lines = succeed(program).splitlines()
    names = [name.partition(".")[2] for name in feedback.SETTINGS]
    assert header.split(",") == ["stride", *feedback.APEX, *names]
    rows = np.array([[float(value) for value in line.split(",")] for line in lines])
    law = feedback.law_of(gait)
    check_strides(gait, law, rows[:, 1:7])
    for row in rows:
        assert list(law.inputs_at(row[1:7]).values()) == pytest.approx(row[7:], rel=1e-9)


def test_the_program_in_c_names_what_is_not_there(program):
    description = program.with_name("unit") / "modelDescription.xml"
    for arguments, says in (
        (("nothing.xml", "nothing.so"), "cannot be read: nothing.xml"),
        ((description, "nothing.so"), "not a shared library: nothing.so"),
        ((program.with_name("CMakeCache.txt"), "nothing.so"), "not a shared library: nothing.so"),
    ):
        done = run(program, *arguments)
        assert done.returncode == 1 and done.stderr.strip() == says and done.stdout == ""


def test_a_viable_controller_keeps_the_unit_up_where_its_own_settings_do_not(load_example):
    """The viable set is that of the full model; the unit makes the run."""
    viable = load_example("viable_controller")
    found = tdmf_slip.viability(viable.RUNNER, axes=viable.RANGES, vary=viable.CHOICE, n=32, model="full")
    gait = tdmf_slip.find_gait(viable.RUNNER)
    law = tdmf_slip.ViableController(found)
    alone, _ = viable.run(viable.Unchanged(), viable.pushed(gait, viable.PUSH), strides=6)
    apices, settings = viable.run(law, viable.pushed(gait, viable.PUSH), strides=6)
    assert len(alone) < 6
    assert len(apices) == 7
    assert settings[0][viable.ANGLE] > gait.runner[viable.ANGLE]
    assert all(law.grade_at(apex) == "viable" for apex in apices)
    run = tdmf_slip.stride_map(viable.RUNNER, apices[0], strides=6, law=law, tolerance=1e-13)
    assert np.abs((np.array(apices[1:]) - run["next_apex"].values[0]) / gait.runner.scales).max() < 1e-8
