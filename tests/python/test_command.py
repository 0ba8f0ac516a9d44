"""The command line as its users meet it: results on stdout, one message where something is wrong."""

import csv
import io
import json
import pathlib
import shlex
import signal
import subprocess
import sys
import time
from types import SimpleNamespace

import netCDF4
import pytest
import tdmf_slip
from conftest import HANGS, run_python, unit_reference
from tdmf_slip.fmu import simulation
from tdmf_slip.library import section
from tdmf_slip.paper import reference_gaits as reference
from tdmf_slip.paper import settling


def test_json_is_one_object_and_nothing_else(command):
    run = command.json("simulate", "--strides", 2, "--friction", 0.6)
    assert run["stride"]["word"] == "+0-0+"
    assert run["stride"]["period"] == pytest.approx(unit_reference()["period"], rel=1e-6)
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
    assert heights.max() == pytest.approx(unit_reference()["apex"][0], abs=1e-5)
    assert (tmp_path / "run.png").stat().st_size > 10_000


@pytest.mark.parametrize(("preset", "word", "speed"), [("paper", "+0-0+", 1.06086), ("human", "+0+", 2.699)])
def test_presets_start_on_their_gaits(command, preset, word, speed):
    stride = command.json("simulate", "--parameters", preset, "--strides", 2)["stride"]
    assert stride["word"] == word
    assert stride["speed"] == pytest.approx(speed, rel=1e-3)


@pytest.mark.parametrize(
    "text",
    [
        "time,ground.friction\n0,10\n12.3,10\n12.3,0.05\n300,0.05\n",
        "\ufefftime, ground.friction\n\n0, 10\n12.3,10\n12.3,0.05\n300,0.05\n\n",  # as editors leave it
    ],
)
def test_inputs_come_from_a_table(command, tmp_path, text):
    """Ice under the sticking foot at t = 12.3: the stance has slips that it had not before."""
    (tmp_path / "ice.csv").write_text(text, encoding="utf-8")
    word = command.json("simulate", "--inputs", "ice.csv", "--stop-time", 30)["stride"]["word"]
    assert word.startswith("0") and "-" in word


def test_a_fall_is_a_result(command):
    run = command.json("simulate", "--set", "hip.stance_torque=0", "--stop-time", 400)
    assert run["fallen"] and run["fall_time"] < 400


def test_a_runner_too_stiff_is_no_fall(command):
    stiff = ("--interface", "cs", "--set", "hip.kd=2.5e13", "--stop-time", 1)
    status, out, message = command("simulate", *stiff, "--json")
    assert status == 1 and out == ""
    assert "too stiff" in message and "solver.method = cvode" in message


def test_what_cvode_complains_of_is_one_line():
    """A torque beyond reason; SUNDIALS would write past Python, so this runs in a process of its own."""
    options = ["--set", "hip.stance_torque=1e18", "--stop-time", "60", "--json"]
    done = run_python("-m", "tdmf_slip", "simulate", *options)
    assert done.returncode == 1
    assert done.stdout == ""
    warning, complaint = done.stderr.splitlines()
    assert "may mix units" in warning and "CVode" in complaint


AXES = "--axes com_height=1:2 --axes com_speed=0.5:1.5"
GRID = f"{AXES} --vary hip.touchdown_angle=0.3:1.1:6"
CASES = pathlib.Path(__file__).with_name("refused_commands.txt").read_text(encoding="utf-8").splitlines()[1:]
LONG = "simulate --set 'body.mass=1\n2' | 1\\n2", f"simulate --output {'x' * 300}.csv | too long"


@pytest.mark.parametrize("case", [*CASES, *LONG], ids=lambda case: case[:40])
def test_bad_input_gets_one_clear_message(command, tmp_path, case):
    (tmp_path / "ice.csv").write_text("time,ground.friction\n0,0.1\n")
    for folder in ("folder.csv", "folder.nc"):
        (tmp_path / folder).mkdir()
    line, *words = case.split(" | ")
    arguments = shlex.split(line.format(axes=AXES, grid=GRID))
    message = command.refusal(*arguments)
    assert all(word in message for word in words), message
    assert {path.name for path in tmp_path.iterdir()} == {"ice.csv", "folder.csv", "folder.nc"}


def test_the_unit_settles_on_its_reference_and_a_drift_is_seen():
    """A reference that is off by 1e-5 is as a mistake in the physics would make it."""
    gait = settling.settle_fmu()
    (known,) = (of for of in reference.gaits() if of.friction == 0.6 and not of.swing_clamp)
    assert gait.word == known.word and all(drift.passed for drift in reference.drifts(gait, known))
    for name in ("period", "speed", "cost_of_transport"):
        drifted = SimpleNamespace(**{**vars(known), name: getattr(known, name) * (1 + 1e-5)})
        assert not all(drift.passed for drift in reference.drifts(gait, drifted))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ["header", "nothing"]),
        ("time,ground.friction\n", ["header", "rows"]),
        ("time,ground.friction,ground.friction\n0,1,2\n", ["each once"]),
        ("time,ground.friction\n0,1\n5\n", ["line 3", "1 of the 2 columns"]),
        ("time,ground.friction\n0,high\n", ["line 2", "high"]),
        ("time,ground.friction\nearly,1\n", ["line 2", "early"]),
        ("time,hip.external_torque\n0,1 kg\n", ["line 2", "kg", "N.m"]),
        ("time,ground.frictoin\n0,1\n", ["in.csv", "ground.friction"]),
        ("time,ground.friction\n0,1\n3,-1\n", ["in.csv", "time 3", "ground.friction = -1"]),
        ('time,ground.friction\n0,"1', ["in.csv", "unexpected end"]),
        ("time,ground.friction\n5,1\n0,1\n", ["ascending"]),
        ("time,ground.friction\n0," + "1" * 200_000, ["line 2, column 2", "allowed: 100"]),
    ],
)
def test_a_table_that_is_none_is_told(command, tmp_path, text, words):
    (tmp_path / "in.csv").write_text(text)
    message = command.refusal("simulate", "--inputs", "in.csv", "--stop-time", 1)
    assert all(word in message for word in words), message


def test_a_table_of_inputs_may_have_units(command, tmp_path):
    answers = []
    for torque in ("0.001", "0.001 N.m"):
        (tmp_path / "in.csv").write_text(f"time,hip.external_torque\n0,{torque}\n")
        answers.append(command("simulate", "--inputs", "in.csv", "--stop-time", 13, "--json"))
    assert answers[0] == answers[1] and answers[0][0] == 0


@pytest.mark.parametrize("option", ["--parameters", "--inputs", "--from-gait"])
def test_a_file_that_is_no_text_is_told(command, tmp_path, option):
    (tmp_path / "in.json").write_bytes(b"\xff\xfe\x00")
    said = command.refusal("simulate", option, "in.json", "--stop-time", 1)
    assert "no text in UTF-8" in said and "in.json" in said


def test_the_help_that_is_named_is_that_of_the_command(command):
    for wrong in (("basin", "--n"), ("gait", "--friction"), ("gait", "--nosuch")):
        assert f"(see tdmf-slip {wrong[0]} --help)" in command.refusal(*wrong)


@pytest.mark.parametrize(
    "content",
    [
        '{"ground.friction": 1' + "0" * 400 + "}",
        '{"body.mass": 1, "body.mass": 2}',
        '{"body.mass": 1, "body": {"mass": 1}}',
    ],
)
def test_a_file_of_parameters_that_is_none_is_told(command, tmp_path, content):
    (tmp_path / "in.json").write_text(content)
    assert "in.json" in command.refusal("simulate", "--parameters", "in.json", "--stop-time", 1)


def test_inputs_are_not_written_over(command, tmp_path):
    table = "time,ground.friction\n0,1\n"
    (tmp_path / "in.csv").write_text(table)
    message = command.refusal("simulate", "--inputs", "in.csv", "--output", "in.csv", "--strides", 1)
    assert "holds the inputs" in message
    assert (tmp_path / "in.csv").read_text() == table


@pytest.mark.skipif(sys.platform != "linux", reason="a folder that even root cannot write to is /proc")
def test_a_path_where_nothing_can_be_written_is_known_before_the_work(command):
    assert "/proc" in command.refusal("simulate", "--strides", 10**6, "--output", "/proc/run.csv")


@pytest.mark.skipif(sys.platform == "win32", reason="file descriptors are closed by a POSIX shell")
def test_without_stderr_results_are_as_with_it():
    command = f'"{sys.executable}" -m tdmf_slip simulate --stop-time 1'
    done = subprocess.run([f"{command} --json 2>&-"], shell=True, capture_output=True, text=True)
    assert done.returncode == 0 and json.loads(done.stdout)["end_time"] == 1.0
    done = subprocess.run([f"{command} --strides x 2>&-"], shell=True, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, "")


@pytest.mark.skipif(sys.platform == "win32", reason="the interrupt is a POSIX signal")
@pytest.mark.parametrize("pause", [0.0, 0.4])
def test_an_interrupt_ends_a_run(pause):
    """The interrupt comes while modules load, or in FMPy, whose solver loses exceptions of its callbacks."""
    program = """
import sys
from tdmf_slip.__main__ import main

class Watch:
    def find_spec(name, *_):
        if name == "tdmf_slip.cli.main":
            print("begins", file=sys.stderr, flush=True)

sys.meta_path.insert(0, Watch)
sys.argv[1:] = ["simulate", "--strides", "50000"]
sys.exit(main())
"""
    with subprocess.Popen(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as running:
        assert running.stderr.readline() == "begins\n"
        time.sleep(pause)
        running.send_signal(signal.SIGINT)
        out, said = running.communicate(timeout=HANGS)
    assert (running.returncode, out, said.strip()) == (130, "", "tdmf-slip: interrupted")


def test_values_of_an_enumeration_have_names(command):
    options = ("--interface", "cs", "--stop-time", 1, "--json")
    by_name = command("simulate", "--set", "solver.method=cvode", *options)
    assert by_name[0] == 0
    assert by_name[1] == command("simulate", "--set", "solver.method=2", *options)[1]


def test_a_run_of_many_strides_is_not_refused(command):
    """The fall ends the run long before the time that so many strides might take."""
    assert command.json("simulate", "--strides", 3000, "--set", "hip.stance_torque=0")["fallen"]


def test_what_is_asked_of_a_run_has_to_be_numbers():
    for wrong in ({"strides": float("nan")}, {"stop_time": "5"}, {"tolerance": None}):
        with pytest.raises(tdmf_slip.InputError, match="allowed"):
            tdmf_slip.simulate(**wrong)
    with pytest.raises(tdmf_slip.InputError, match="a pair of times and values"):
        tdmf_slip.simulate(inputs={"ground.friction": 0.3}, stop_time=1)
    with pytest.raises(tdmf_slip.InputError, match="tolerance"):
        settling.settle_fmu(tolerance=float("nan"))


def test_a_run_begins_on_the_gait_that_was_printed(command, monkeypatch):
    """The printed gait carries its parameters and its apex: human scale, another friction."""
    gait = command("gait", "--parameters", "human", "--friction", 0.5, "--json")[1]
    found = json.loads(gait)
    pathlib.Path("gait.json").write_text(gait)
    monkeypatch.setattr(sys, "stdin", io.StringIO(gait))
    for name in ("gait.json", "-"):
        run = command.json("simulate", "--from-gait", name, "--strides", 1)
        assert run["stride"]["word"] == found["word"]
        for quantity in ("period", "length", "work"):
            assert run["stride"][quantity] == pytest.approx(found[quantity], rel=1e-5), quantity
        apex = [run["apex"][name] for name in section.COORDINATES]
        assert apex == pytest.approx(found["apex"], abs=1e-4)
    pushed = command.json("simulate", "--from-gait", "gait.json", "--friction", 0.6, "--strides", 1)
    assert pushed["stride"]["period"] != pytest.approx(found["period"], rel=1e-3)


@pytest.mark.parametrize(
    "text", ["", "{", "[1]", '{"gaits": []}', '{"start_values": {"mass": 1}}', "[" * 9999]
)
def test_what_is_no_gait_is_told(command, monkeypatch, text):
    monkeypatch.setattr(sys, "stdin", io.StringIO(text))
    refused = command.refusal("simulate", "--from-gait", "-", "--strides", 1)
    assert "standard input" in refused or "--from-gait -:" in refused


@pytest.mark.skipif(sys.platform != "linux", reason="a full device is one of Linux")
def test_results_that_cannot_be_printed_are_told():
    command = [sys.executable, "-m", "tdmf_slip", "gait", "--friction", "0.6"]
    full = subprocess.run(f"{' '.join(command)} > /dev/full", shell=True, capture_output=True, text=True)
    closed = subprocess.run(f"{' '.join(command)} >&-", shell=True, capture_output=True, text=True)
    for done in (full, closed):
        assert done.returncode == 1 and len(done.stderr.strip().splitlines()) == 1
        assert "cannot be printed" in done.stderr


def test_no_gait_is_an_error_with_a_reason(command):
    with pytest.raises(tdmf_slip.RunError, match="fell after"):
        settling.settle_fmu({"hip.stance_torque": 0.0})


def test_every_variable_is_told(command, fmu):
    """Each line has the entries of the unit's description. A missing bound is null in JSON."""
    printed = {row["name"]: row for row in command.json("variables")["variables"]}
    assert list(printed) == list(fmu.variables)
    assert printed["leg.min_length"]["default"] == 0.05 and printed["leg.min_length"]["unit"] == "m"
    assert (
        printed["contact.mode"]["items"]["slip_negative"] == 4 and printed["contact.mode"]["default"] is None
    )
    assert printed["energy.total"]["minimum"] is None and not printed["energy.total"]["settable"]
    status, out, _ = command("variables")
    lines = out.splitlines()
    assert status == 0 and len(lines) == len(fmu.variables) + 2
    row = next(line for line in lines if line.startswith("status.terminate_on_fall"))
    assert row.split()[1:3] == ["true", "parameter"]
    kinds = {name: row["variability"] for name, row in printed.items()}
    assert kinds["hip.kp"] == "tunable" and kinds["ground.slope"] == "discrete"
    assert "tunable parameter" in next(line for line in lines if line.startswith("hip.kp"))
    assert "discrete input" in next(line for line in lines if line.startswith("ground.slope"))


def test_settings_of_one_interface_are_those_that_the_unit_describes_so(fmu):
    words = {"me": "Model Exchange", "cs": "Co-Simulation"}
    described = {
        name: interface
        for name, variable in fmu.variables.items()
        for interface, word in words.items()
        if variable.settable and word in variable.description
    }
    assert len(described) >= 3 and described == simulation.ONLY_IN
