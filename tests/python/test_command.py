"""The command line as its users meet it: results on stdout, one message where something is wrong."""

import csv
import json
import subprocess
import sys

import netCDF4
import pytest
import tdmf_slip
from tdmf_slip import reference


def test_json_is_one_object_and_nothing_else(command):
    status, out, _ = command("simulate", "--strides", 2, "--friction", 0.6, "--json")
    run = json.loads(out)
    assert status == 0
    assert run["stride"]["word"] == "+0-0+"
    assert run["stride"]["period"] == pytest.approx(24.764449, rel=1e-6)
    assert not run["fallen"]


@pytest.mark.parametrize("interface", ["me", "cs"])
def test_rows_are_written_with_units(command, tmp_path, interface):
    options = ("--interface", interface, "--stop-time", 30)
    assert command("simulate", *options, "--output", "run.csv")[0] == 0
    assert command("simulate", *options, "--output", "run.nc", "--plot", "run.png")[0] == 0
    with open(tmp_path / "run.csv", newline="") as file:
        rows = list(csv.reader(file))
    with netCDF4.Dataset(tmp_path / "run.nc") as data:
        heights = data["com.y"][:]
        assert data["com.y"].units == "m"
    assert any("com.y" in name for name in rows[0])
    assert heights.max() == pytest.approx(1.406107, abs=1e-5)
    assert (tmp_path / "run.png").stat().st_size > 10_000


@pytest.mark.parametrize(("preset", "word", "speed"), [("paper", "+0-0+", 1.06174), ("human", "+0+", 6.83)])
def test_presets_start_on_their_gaits(command, preset, word, speed):
    _, out, _ = command("simulate", "--parameters", preset, "--strides", 2, "--json")
    stride = json.loads(out)["stride"]
    assert stride["word"] == word
    assert stride["speed"] == pytest.approx(speed, rel=1e-3)


def test_angles_may_be_given_in_degrees(command):
    answers = []
    for angle in ("0.7330382858376184", "42 deg"):
        options = ("--set", f"hip.touchdown_angle={angle}", "--stop-time", 40, "--json")
        answers.append(json.loads(command("simulate", *options)[1])["stride"])
    assert answers[0]["period"] == pytest.approx(answers[1]["period"], rel=1e-9)


def test_inputs_come_from_a_table(command, tmp_path):
    """Ice under the sticking foot at t = 12.1: the stance has slips that it had not before."""
    (tmp_path / "ice.csv").write_text("time,ground.friction\n0,10\n12.1,10\n12.1,0.05\n300,0.05\n")
    _, out, _ = command("simulate", "--inputs", "ice.csv", "--stop-time", 30, "--json")
    word = json.loads(out)["stride"]["word"]
    assert word.startswith("0") and "-" in word


def test_a_fall_is_a_result(command):
    status, out, _ = command("simulate", "--set", "hip.stance_torque=0", "--stop-time", 400, "--json")
    run = json.loads(out)
    assert status == 0
    assert run["fallen"] and run["fall_time"] < 400


def test_what_cvode_complains_of_goes_to_stderr():
    """A torque beyond reason; SUNDIALS writes past Python, so this runs in a process of its own."""
    options = ["--set", "hip.stance_torque=1e18", "--stop-time", "60", "--json"]
    command = [sys.executable, "-m", "tdmf_slip", "simulate", *options]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 1
    assert done.stdout == ""
    assert "CVode" in done.stderr.splitlines()[-1]


BAD = [
    (["--set", "grund.friction=1"], ["grund.friction", "ground.friction"]),
    (["--set", "body.mass=-1"], ["body.mass", "-1", "1e-09", "kg"]),
    (["--set", "ground.friction=nan"], ["ground.friction", "nan"]),
    (["--set", "body.mass"], ["body.mass"]),
    (["--set", "body.x=1"], ["body.x"]),
    (["--set", "body.mass=3 deg"], ["body.mass", "deg"]),
    (["--set", "leg.length=0.01"], ["leg.length", "0.01", "0.05", "leg.min_length"]),
    (["--stop-time", "-3"], ["stop_time", "-3"]),
    (["--strides", "0"], ["strides", "0"]),
    (["--tolerance", "0"], ["tolerance", "0"]),
    (["--output", "run.xyz"], [".xyz", ".csv", ".nc"]),
    (["--plot", "run.txt"], [".txt", ".png"]),
    (["--inputs", "none.csv"], ["none.csv"]),
    (["--parameters", "nobody"], ["nobody", "human", "paper"]),
    (["--interface", "fmi4"], ["fmi4", "me", "cs"]),
    (["--nonsense"], ["--nonsense"]),
]


@pytest.mark.parametrize(("options", "words"), BAD, ids=lambda value: " ".join(value)[:30])
def test_bad_input_gets_one_clear_message(command, tmp_path, options, words):
    status, out, message = command(
        "simulate", *options, *(() if "--output" in options else ["--output", "run.csv"])
    )
    assert status == 2
    assert out == ""
    assert len(message.strip().splitlines()) == 1
    assert all(word in message for word in words), message
    assert list(tmp_path.iterdir()) == []


@pytest.fixture(scope="module")
def gait():
    return tdmf_slip.periodic_gait(0.6)


def test_the_gait_of_the_defaults_settles_on_the_reference(gait):
    (expected,) = (known for known in reference.gaits() if known["friction"] == 0.6)
    assert gait.word == expected["word"]
    assert all(drift.passed for drift in reference.drifts(gait, expected, tdmf_slip.load()))


@pytest.mark.parametrize("name", ["period", "speed", "cost_of_transport"])
def test_validation_sees_a_drift(gait, name):
    """A reference that is off by 1e-5, as a mistake in the physics would make it."""
    (expected,) = (known for known in reference.gaits() if known["friction"] == 0.6)
    drifted = dict(expected) | {name: expected[name] * (1 + 1e-5)}
    assert not all(drift.passed for drift in reference.drifts(gait, drifted, tdmf_slip.load()))


def test_no_gait_is_an_error_with_a_reason(command):
    with pytest.raises(tdmf_slip.RunError, match="fell after"):
        tdmf_slip.periodic_gait(0.6, {"hip.stance_torque": 0.0})
