"""Series and DataFrames, which users have, where names or rows are asked for; and too large requests."""

import os
import subprocess
import sys
import zipfile

import numpy as np
import pandas
import pytest
import tdmf_slip
from conftest import HANGS
from tdmf_slip import InputError, RunError
from tdmf_slip.analysis import ball, branch_problem, stability
from tdmf_slip.fmu import batch
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.library.section import COORDINATES
from tdmf_slip.variables.parameters import read_parameters

FRICTION, DAMPING, TORQUE = "ground.friction", "leg.damping", "hip.stance_torque"
GIVEN = {FRICTION: 0.6, DAMPING: 0.19}
SERIES = pandas.Series(GIVEN)
BACKWARD = list(reversed(COORDINATES))


@pytest.fixture(scope="module")
def gait():
    return tdmf_slip.find_gait(GIVEN)


SAME = {
    "find_gait": (lambda given, gait: tdmf_slip.find_gait(given).apex, GIVEN, SERIES),
    "simulate": (lambda given, gait: run_unit(given, strides=1).table, GIVEN, SERIES),
    "inputs": (
        lambda given, gait: run_unit(GIVEN, strides=1, inputs=given).table,
        {FRICTION: ([0.0, 9.0], [0.6, 0.5])},
        pandas.DataFrame({"time": [0.0, 9.0], FRICTION: [0.6, 0.5]}),
    ),
    "inputs over an index": (
        lambda given, gait: run_unit(GIVEN, strides=1, inputs=given).table,
        {FRICTION: ([0.0, 9.0], [0.6, 0.5])},
        pandas.DataFrame({FRICTION: [0.6, 0.5]}, index=pandas.Index([0.0, 9.0], name="time")),
    ),
    "an input over its index": (
        lambda given, gait: run_unit(GIVEN, strides=1, inputs=given).table,
        {FRICTION: ([0.0, 9.0], [0.6, 0.5])},
        pandas.Series([0.6, 0.5], index=pandas.Index([0.0, 9.0], name="time"), name=FRICTION),
    ),
    "inputs by name, each over its index": (
        lambda given, gait: run_unit(GIVEN, strides=1, inputs=given).table,
        {FRICTION: ([0.0, 9.0], [0.6, 0.5])},
        {FRICTION: pandas.Series([0.6, 0.5], index=pandas.Index([0.0, 9.0], name="time"))},
    ),
    "variables": (
        lambda given, gait: run_unit(GIVEN, strides=1, variables=given).table,
        ["contact.fx", "foot.x"],
        pandas.Series(["contact.fx", "foot.x"]),
    ),
    "batch": (
        lambda given, gait: batch.simulate_many(given, strides=1)["period"].values,
        [GIVEN, {FRICTION: 0.5, DAMPING: 0.2}],
        pandas.DataFrame({FRICTION: [0.6, 0.5], DAMPING: [0.19, 0.2]}),
    ),
    "batch of Series": (
        lambda given, gait: batch.simulate_many(given, strides=1)["period"].values,
        [GIVEN],
        [SERIES],
    ),
    "sweep": (
        lambda given, gait: tdmf_slip.sweep({}, {"ground.friction": given}).gaits["apex_com_speed"].values,
        [0.5, 0.6],
        pandas.Series([0.5, 0.6]),
    ),
    "gaits_over": (
        lambda given, gait: [o.apex for o in branch_problem.gaits_over(gait.runner, FRICTION, given, gait)],
        [0.58],
        pandas.Series([0.58]),
    ),
    "stability": (
        lambda given, gait: stability.stability({}, given)["lambda_max"].values,
        {FRICTION: [0.5, 0.6], DAMPING: [0.2, 0.21]},
        pandas.DataFrame({FRICTION: [0.5, 0.6], DAMPING: [0.2, 0.21]}),
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
    "starts by their columns": (
        lambda given, gait: tdmf_slip.Batch(GIVEN, given(gait)).run(1).apex,
        lambda gait: [gait.apex, gait.apex],
        lambda gait: pandas.DataFrame([gait.apex, gait.apex], columns=COORDINATES)[BACKWARD],
    ),
    "runners": (
        lambda given, gait: tdmf_slip.Batch(given, gait.apex[None]).run(2).apex,
        [GIVEN],
        pandas.DataFrame([GIVEN]),
    ),
    "parameters of each runner": (
        lambda given, gait: tdmf_slip.stride_map(given, gait.apex)["next_apex"],
        {DAMPING: [0.19, 0.2]},
        pandas.DataFrame({DAMPING: [0.19, 0.2]}),
    ),
    "settings": (
        lambda given, gait: tdmf_slip.stride_map(GIVEN, gait.apex, strides=2, inputs=given)["apex"],
        {TORQUE: [0.2, 0.21]},
        pandas.DataFrame({TORQUE: [0.2, 0.21]}),
    ),
    "an order": (
        lambda given, gait: tdmf_slip.find_gait({}, target=given, vary=[TORQUE]).apex,
        {"speed": 1.1},
        pandas.Series({"speed": 1.1}),
    ),
    "free names": (
        lambda given, gait: tdmf_slip.find_gait({}, target={"speed": 1.1}, vary=given).apex,
        [TORQUE],
        pandas.Series([TORQUE]),
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


def test_measurements_of_a_table_have_gaps_as_a_file_has():
    table = pandas.DataFrame(
        {
            "speed [m/s]": [1.0, 1.1],
            "speed_error [m/s]": [0.01, 0.01],
            "frequency [Hz]": [np.nan, 0.05],
            "frequency_error [Hz]": [None, 0.01],
        }
    )
    found = tdmf_slip.fit(None, table, [TORQUE])
    assert [residual.name for residual in found.residuals] == ["speed", "speed", "frequency"]
    with pytest.raises(InputError, match=r"row 2: speed = -1\.1 is not allowed"):
        tdmf_slip.fit(None, table.assign(**{"speed [m/s]": [1.0, -1.1]}), [TORQUE])


def test_pandas_is_not_loaded_for_what_needs_it_not():
    program = "import sys, tdmf_slip; tdmf_slip.find_gait({'gravity': 0.01}); print('pandas' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=HANGS)
    assert done.stdout.strip() == "False", done.stderr


MANY = np.broadcast_to([1.3, 1.0, 1.0, 0.0, 0.0, 0.0], (10**9, 6))
HALF = np.broadcast_to(0.5, 10**9)
REFUSED = {
    "stride_map": (
        lambda gait: tdmf_slip.stride_map(GIVEN, MANY),
        r"runners: 1,000,000,000 runners; allowed: up to 10,000,000",
    ),
    "strides in all": (
        lambda gait: tdmf_slip.stride_map(GIVEN, [gait.apex] * 100, strides=10**6),
        r"100,000,000 strides in all; allowed: up to 10,000,000",
    ),
    "varied parameters": (
        lambda gait: tdmf_slip.stride_map({DAMPING: HALF}, gait.apex),
        r"1,000,000,000 numbers; allowed: up to",
    ),
    "settings": (
        lambda gait: tdmf_slip.stride_map({}, gait.apex, strides=10**6, inputs={TORQUE: HALF}),
        r"1,000,000,000 numbers; allowed: up to",
    ),
    "a batch": (
        lambda gait: tdmf_slip.Batch(GIVEN, MANY),
        r"runners: 1,000,000,000 runners; allowed: up to 10,000,000",
    ),
    "fates": (lambda gait: ball.fates(gait, MANY), r"runners: 1,000,000,000 .*up to"),
    "gaits to settle on": (
        lambda gait: tdmf_slip.Batch(GIVEN, gait.apex).run(1, MANY),
        r"until: 6,000,000,000 .*up to",
    ),
    "basin": (
        lambda gait: tdmf_slip.basin(GIVEN, n=100_000),
        r"10,000,000,000 starts \(100,000 by 100,000\); allowed: up to 268,435,456",
    ),
    "sweep": (
        lambda gait: tdmf_slip.sweep({}, {"ground.friction": HALF}),
        r"vary ground.friction: 1,000,000,000 values; allowed: up to",
    ),
    "stability": (
        lambda gait: stability.stability({}, {FRICTION: HALF, DAMPING: [0.2]}),
        r"1,000,000,000 values; allowed: up to",
    ),
    "an array for an interface": (
        lambda gait: run_unit(GIVEN, interface=np.array(["me", "cs"])),
        r"interface array.*allowed: me, cs",
    ),
    "an array for a model": (
        lambda gait: tdmf_slip.find_gait({}, model=np.zeros(2)),
        "model array.*allowed",
    ),
    "an array for instructions": (
        lambda gait: tdmf_slip.Batch({}, gait.apex, instructions=np.zeros(2)),
        "instructions array.*allowed",
    ),
    "a number for a name": (lambda gait: tdmf_slip.sweep({}, {3: [0.5]}), "vary 3 is not allowed"),
    "an array for an axis": (
        lambda gait: tdmf_slip.basin({}, np.zeros(2)),
        "axes: 0.0 is not allowed; allowed: com_height",
    ),
    "an array for a quantity": (
        lambda gait: tdmf_slip.optimize({}, {TORQUE: (0.1, 0.3)}, minimize=np.zeros(2)),
        "minimize array.*allowed",
    ),
    "an array for a number": (
        lambda gait: tdmf_slip.strides_to_fall({}, 0.1, runners=np.zeros(2)),
        "runners = array.*allowed",
    ),
    "an array for a gait": (
        lambda gait: tdmf_slip.strides_to_fall({}, 0.5, gait=gait.apex),
        r"gait = array.*allowed: a Gait",
    ),
    "a pair for a profile": (
        lambda gait: run_unit(profile=(1, 2), strides=1),
        r"profile = \(1, 2\) is not allowed; allowed: a Profile",
    ),
    "nothing for curves": (
        lambda gait: tdmf_slip.continue_curves({}, None),
        "vary: 0 names; .*two parameters",
    ),
    "a number for curves": (lambda gait: tdmf_slip.continue_curves({}, 0.3), r"vary = 0\.3 .*two parameters"),
    "numbers for curves": (
        lambda gait: tdmf_slip.continue_curves({}, {FRICTION: 0.3, DAMPING: 0.2}),
        r"vary ground\.friction = 0\.3 .*ends",
    ),
    "three ends for curves": (
        lambda gait: tdmf_slip.continue_curves({}, {FRICTION: (0.3, 0.4, 0.5), DAMPING: (0.2, 0.3)}),
        r"vary ground\.friction = \(0\.3, 0\.4, 0\.5\) .*ends",
    ),
    "no path": (lambda gait: tdmf_slip.load_fmu("\0"), "no unit there"),
    "no path to write to": (lambda gait: tdmf_slip.basin({}, path="\0.nc"), "null"),
    "no path to read": (lambda gait: read_parameters("\0.toml"), "null"),
    "other labels": (
        lambda gait: tdmf_slip.find_gait({}, guess=pandas.Series(dict.fromkeys("abcdef", 1.0))),
        "an apex with a, b, c, d, e, f; allowed: com_height",
    ),
    "a label twice": (
        lambda gait: tdmf_slip.find_gait(pandas.Series([0.5, 0.6], index=[FRICTION, FRICTION])),
        r"ground\.friction is given twice",
    ),
    "a table without a time": (
        lambda gait: run_unit({}, inputs=pandas.DataFrame({FRICTION: [0.5]})),
        "time",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_gets_one_sentence(name, gait):
    call, sentence = REFUSED[name]
    with pytest.raises(InputError, match=sentence) as caught:
        call(gait)
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 400


def test_a_variable_that_is_asked_for_twice_is_recorded_once():
    run = run_unit(GIVEN, strides=1, variables=["foot.x", "foot.y", "foot.x"])
    assert run.names == ("time", "foot.x", "foot.y")


def test_a_unit_without_its_library_is_told(tmp_path):
    path = tmp_path / "bare.fmu"
    with zipfile.ZipFile(tdmf_slip.fmu_path()) as whole, zipfile.ZipFile(path, "w") as bare:
        for name in whole.namelist():
            if not name.startswith("binaries/"):
                bare.writestr(name, whole.read(name))
    for interface in ("me", "cs"):
        with pytest.raises(RunError, match=r"bare\.fmu: its library for this platform .* cannot be used"):
            run_unit(GIVEN, strides=1, fmu=tdmf_slip.load_fmu(path), interface=interface)


def test_a_unit_whose_library_is_none_is_told(tmp_path):
    path = tmp_path / "broken.fmu"
    with zipfile.ZipFile(tdmf_slip.fmu_path()) as whole, zipfile.ZipFile(path, "w") as broken:
        for name in whole.namelist():
            broken.writestr(name, b"no library" if name.startswith("binaries/") else whole.read(name))
    with pytest.raises(RunError, match=r"broken\.fmu: its library for this platform"):
        run_unit(GIVEN, strides=1, fmu=tdmf_slip.load_fmu(path))


@pytest.mark.parametrize("content", [None, b"no library"])
def test_a_missing_or_broken_library_is_told_by_the_command(tmp_path, content):
    path = tmp_path / "library.so"
    if content is not None:
        path.write_bytes(content)
    done = subprocess.run(
        [sys.executable, "-m", "tdmf_slip", "gait", "--friction", "0.6"],
        capture_output=True,
        text=True,
        timeout=HANGS,
        env={**os.environ, "TDMF_SLIP_LIBRARY": str(path)},
    )
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
