"""Options of the command: none is discarded in silence, and ranges have units."""

import click
import numpy as np
import pytest
import xarray
from tdmf_slip.cli.main import commands


def single_options():
    """Of every command, the options that take one value."""
    context = click.Context(commands)
    for name in commands.list_commands(context):
        for option in commands.get_command(context, name).params:
            if isinstance(option, click.Option) and not option.multiple and not option.is_flag:
                yield name, option.opts[0], option.nargs


@pytest.mark.parametrize(("command_name", "option", "values"), list(single_options()))
def test_no_option_is_given_twice(command, tmp_path, command_name, option, values):
    status, out, said = command(command_name, *(2 * [option, *(values * ["1"])]))
    assert (status, out) == (2, "")
    assert f"{option} is given twice" in said and len(said.strip().splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ("gait --friction 0.3 --set ground.friction=0.6", ["--friction", "ground.friction", "one of"]),
        ("simulate --friction 0.3 --set ground.friction=0.6", ["--friction", "one of the two"]),
        ("basin --friction 0.3 --set ground.friction=0.3", ["--friction", "one of the two"]),
        ("gait --set body.mass=1 --set body.mass=2", ["--set body.mass=2", "body.mass is given twice"]),
        ("gait --set solver.method=cvode", ["solver.method", "no meaning"]),
        ("basin --set solver.relative_tolerance=1e-5", ["solver.relative_tolerance", "no meaning"]),
        ("sweep --friction 1:2:2 --set status.terminate_on_fall=false", ["terminate_on_fall", "no meaning"]),
        ("sweep --friction 1:2:2 --vary solver.relative_tolerance=1e-5:1e-4:2 --output x.nc", ["solver"]),
        ("simulate --set solver.method=cvode", ["solver.method", "--interface cs"]),
        ("simulate --interface cs --set status.terminate_on_fall=false", ["--interface me"]),
        ("simulate --interface cs --tolerance 1e-6", ["--tolerance", "solver.relative_tolerance = 1e-11"]),
        ("simulate --inputs ice.csv --friction 0.6", ["--friction", "--inputs", "one of the two"]),
        ("simulate --inputs ice.csv --set ground.friction=0.6", ["--set ground.friction", "--inputs"]),
        ("simulate --from-gait gait.json --parameters human", ["--parameters", "--from-gait"]),
        ("sweep --friction 0.6:1:1", ["0.6:1:1", "A and B"]),
        ("basin --axes com_height=1:1 --axes com_speed=0:2", ["com_height = 1:1", "differ"]),
        ("basin --n 1", ["--n", "1"]),
    ],
)
def test_no_option_is_without_meaning(command, tmp_path, arguments, words):
    (tmp_path / "ice.csv").write_text("time,ground.friction\n0,0.1\n")
    status, out, said = command(*arguments.split())
    assert (status, out) == (2, "")
    assert len(said.strip().splitlines()) == 1 and all(word in said for word in words), said


def test_a_tighter_tolerance_has_a_meaning_in_co_simulation(command):
    assert command("simulate", "--interface", "cs", "--tolerance", "1e-12", "--stop-time", 1)[0] == 0
    setting = ("--set", "solver.relative_tolerance=1e-6")
    assert command("simulate", "--interface", "cs", "--tolerance", "1e-6", *setting, "--stop-time", 1)[0] == 0


def test_options_take_ranges_in_degrees(command):
    over = ("--vary", "hip.touchdown_angle=39 deg:41 deg:2", "--output", "grid.nc")
    assert command("sweep", "--friction", "0.5:0.6:2", *over)[0] == 0
    angles = xarray.load_dataset("grid.nc")["hip.touchdown_angle"]
    assert angles.values == pytest.approx(np.radians([39.0, 41.0]))
    slice_ = ("--axes", "leg_angle=65 deg:75 deg", "--axes", "com_speed=1:1.1", "--n", 2)
    assert command("basin", *slice_, "--samples", 0, "--output", "map.nc")[0] == 0
    assert xarray.load_dataset("map.nc")["leg_angle"].values == pytest.approx(np.radians([65.0, 75.0]))


@pytest.mark.parametrize(
    ("arguments", "typed"),
    [
        (("basin", "--axes", "com_height=0:2.5", "--axes", "com_speed=3"), "com_speed = 3:"),
        (("basin", "--axes", "com_height=0:2.5", "--axes", "com_speed=3:x"), "com_speed = 3:x:"),
        (("basin", "--axes", "com_height=1:2", "--axes", "com_speed=nan:3"), "com_speed = nan:3:"),
        (("basin", "--axes", "com_height=1 kg:2 kg", "--axes", "com_speed=1:2"), "com_height = 1 kg:2 kg:"),
        (("basin", "--axes", "leg_angle=1:2 deg", "--axes", "com_speed=1:2"), "leg_angle = 1:2 deg: a unit"),
        (("sweep", "--friction", "0.6"), "--friction 0.6:"),
        (("sweep", "--friction", "0.6:1:2.5"), "--friction 0.6:1:2.5: N = 2.5"),
        (("sweep", "--friction", "1:2:2", "--vary", "leg.damping=1", "--output", "x.nc"), "leg.damping = 1:"),
        (("simulate", "--stop-time", "inf"), "--stop-time = inf"),
        (("simulate", "--output-interval", "0"), "--output-interval = 0"),
        (("validate", "--tolerance", "3"), "--tolerance = 3"),
        (("simulate", "--set", "body.mass="), "--set body.mass=:"),
    ],
)
def test_messages_show_what_was_typed(command, arguments, typed):
    status, out, said = command(*arguments)
    assert (status, out) == (2, "")
    assert typed in said and len(said.strip().splitlines()) == 1, said


@pytest.mark.parametrize(
    "arguments",
    [
        ("simulate", "--strides", 100000, "--output", "missing/run.csv"),
        ("simulate", "--strides", 100000, "--plot", "missing/run.png"),
        ("sweep", "--friction", "1:2:100000", "--output", "missing/sweep.nc"),
        ("sweep", "--friction", "1:2:99999", "--vary", "gravity=1:2:9", "--output", "missing/grid.nc"),
        ("basin", "--n", 9999, "--output", "missing/map.nc"),
        ("basin", "--n", 9999, "--plot", "missing/map.png"),
        ("figures", "--output", "missing/figures"),
        ("validate", "--pictures", "missing/pictures"),
        ("simulate", "--strides", 100000, "--output", "folder.csv"),
        ("basin", "--n", 9999, "--output", "folder.nc"),
    ],
)
def test_no_folder_is_made_in_silence(command, tmp_path, arguments):
    folders = {"folder.csv", "folder.nc"}
    for folder in folders:
        (tmp_path / folder).mkdir()
    status, out, said = command(*arguments)
    assert (status, out) == (2, "")
    assert str(arguments[-1]) in said.replace(str(tmp_path), "") or "missing" in said
    assert len(said.strip().splitlines()) == 1
    assert {path.name for path in tmp_path.iterdir()} == folders


@pytest.mark.parametrize("name", ["none.toml", "folder.toml", "folder", "empty.toml", "empty.json", "humn"])
@pytest.mark.parametrize("option", ["--parameters", "--from-gait", "--inputs"])
def test_a_file_that_is_none_is_told_without_a_number(command, tmp_path, option, name):
    for folder in ("folder.toml", "folder"):
        (tmp_path / folder).mkdir()
    for file in ("empty.toml", "empty.json"):
        (tmp_path / file).touch()
    status, out, said = command("simulate", option, name, "--stop-time", 1)
    assert (status, out) == (2, "")
    assert name in said and "Errno" not in said and len(said.strip().splitlines()) == 1, said


def test_quantities_are_printed_with_their_units(command):
    _, out, _ = command("gait", "--parameters", "human")
    lines = dict(line.split(maxsplit=1) for line in out.splitlines())
    for name, unit in (
        ("period", "s"),
        ("length", "m"),
        ("work", "J"),
        ("liftoff_angle", "rad"),
        ("apex.com_height", "m"),
        ("apex.leg_angle_rate", "rad/s"),
    ):
        assert lines[name].split()[1:] == [unit], lines[name]
    _, out, _ = command(
        "basin", "--n", 2, "--axes", "com_height=1.3:1.4", "--axes", "com_speed=1:1.1", "--samples", 0
    )
    lines = dict(line.split(maxsplit=1) for line in out.splitlines())
    assert lines["settled_area"].endswith(" l0·l0 sqrt(k/m)")
    assert lines["step_up"].endswith(" l0")
    assert "period (s)" in command("sweep", "--parameters", "human", "--friction", "0.6:0.6:1")[1]
