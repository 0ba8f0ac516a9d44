"""Series and DataFrames, which users have, where names or rows are asked for; and too large requests."""

import os
import zipfile

import numpy as np
import pandas
import pytest
import tdmf_slip
from conftest import run_python
from tdmf_slip import InputError, RunError
from tdmf_slip.fmu import batch
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.library.section import COORDINATES
from tdmf_slip.variables.parameters import read_parameters

FRICTION, DAMPING, TORQUE = "ground.friction", "leg.damping", "hip.stance_torque"
GIVEN = {FRICTION: 0.6, DAMPING: 0.19}
BACKWARD = list(reversed(COORDINATES))


@pytest.fixture(scope="module")
def gait():
    return tdmf_slip.find_gait(GIVEN)


SAME = {
    "inputs": (
        lambda given, gait: run_unit(GIVEN, strides=1, inputs=given).table,
        {FRICTION: ([0.0, 9.0], [0.6, 0.5])},
        pandas.DataFrame({"time": [0.0, 9.0], FRICTION: [0.6, 0.5]}),
    ),
    "inputs by name, each over its index": (
        lambda given, gait: run_unit(GIVEN, strides=1, inputs=given).table,
        {FRICTION: ([0.0, 9.0], [0.6, 0.5])},
        {FRICTION: pandas.Series([0.6, 0.5], index=pandas.Index([0.0, 9.0], name="time"))},
    ),
    "batch": (
        lambda given, gait: batch.simulate_many(given, strides=1)["period"].values,
        [GIVEN, {FRICTION: 0.5, DAMPING: 0.2}],
        pandas.DataFrame({FRICTION: [0.6, 0.5], DAMPING: [0.19, 0.2]}),
    ),
    "a guess by its labels": (
        lambda given, gait: tdmf_slip.find_gait(GIVEN, guess=given(gait)).apex,
        lambda gait: gait.apex,
        lambda gait: pandas.Series(dict(zip(COORDINATES, gait.apex, strict=True)))[BACKWARD],
    ),
    "apices by their columns": (
        lambda given, gait: tdmf_slip.stride_map(GIVEN, given(gait))["next_apex"],
        lambda gait: [gait.apex, gait.apex],
        lambda gait: pandas.DataFrame([gait.apex, gait.apex], columns=COORDINATES)[BACKWARD],
    ),
    "parameters of each runner": (
        lambda given, gait: tdmf_slip.stride_map(given, gait.apex)["next_apex"],
        {DAMPING: [0.19, 0.2]},
        pandas.DataFrame({DAMPING: [0.19, 0.2]}),
    ),
    "bounds": (
        lambda given, gait: tdmf_slip.optimize({}, given, minimize="slip_distance", starts=1).gait.apex,
        {TORQUE: (0.15, 0.3)},
        pandas.DataFrame({TORQUE: [0.15, 0.3]}),
    ),
    "measurements": (
        lambda given, gait: tdmf_slip.fit(None, given, [TORQUE]).estimates[0].value,
        pandas.DataFrame({"speed [m/s]": [1.1], "speed_error [m/s]": [0.01]}),
        pandas.DataFrame(
            {
                "speed_error [m/s]": [0.01],
                "speed [m/s]": [1.1],
                "length [m]": [1.0],
            }
        )[["speed [m/s]", "speed_error [m/s]"]],
    ),
}


@pytest.mark.parametrize("name", SAME)
def test_series_and_tables_stand_for_names_and_rows(name, gait):
    call, plain, from_pandas = SAME[name]
    np.testing.assert_array_equal(call(plain, gait), call(from_pandas, gait))


def test_pandas_is_not_loaded_for_what_needs_it_not():
    program = "import sys, tdmf_slip; tdmf_slip.find_gait({'gravity': 0.01}); print('pandas' in sys.modules)"
    done = run_python("-c", program)
    assert done.stdout.strip() == "False", done.stderr


def test_a_unit_without_its_library_is_told(tmp_path):
    path = tmp_path / "bare.fmu"
    with zipfile.ZipFile(tdmf_slip.fmu_path()) as whole, zipfile.ZipFile(path, "w") as bare:
        for name in whole.namelist():
            if not name.startswith("binaries/"):
                bare.writestr(name, whole.read(name))
    for interface in ("me", "cs"):
        with pytest.raises(RunError, match=r"bare\.fmu: its library for this platform .* cannot be used"):
            run_unit(GIVEN, strides=1, fmu=tdmf_slip.load_fmu(path), interface=interface)


@pytest.mark.parametrize("content", [None, b"no library"])
def test_a_missing_or_broken_library_is_told_by_the_command(tmp_path, content):
    path = tmp_path / "library.so"
    if content is not None:
        path.write_bytes(content)
    library = os.environ | {"TDMF_SLIP_LIBRARY": str(path)}
    done = run_python("-m", "tdmf_slip", "gait", "--friction", "0.6", env=library)
    assert done.returncode == 2 and done.stdout == ""
    (sentence,) = done.stderr.splitlines()
    assert str(path) in sentence and "install the package with pip" in sentence


def test_a_runner_is_given_in_any_of_the_ways(tmp_path):
    """A preset's name, a file, what is in it, a Runner of it, and its gait are one runner and one gait."""
    file = tmp_path / "runner.toml"
    file.write_text('"ground.friction" = 0.43\n"leg.damping" = 0.21\n')
    values = read_parameters(file)
    gait = tdmf_slip.find_gait(values)
    for given in (file, str(file), pandas.Series(values), tdmf_slip.Runner(values), gait):
        assert tdmf_slip.find_gait(given).apex == pytest.approx(gait.apex, abs=1e-10)
        assert tdmf_slip.Runner(given) == gait.runner
    assert tdmf_slip.Runner("human") == tdmf_slip.Runner(read_parameters("human"))
    assert run_unit("human", strides=1).final == (run_unit(read_parameters("human"), strides=1).final)
    run = run_unit(gait, strides=1)
    assert run.stride["period"] == pytest.approx(gait.period, rel=1e-6)
    with pytest.raises(InputError, match="neither a preset"):
        tdmf_slip.find_gait("nobody")
