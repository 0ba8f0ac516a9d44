"""Options of the command: none is discarded in silence, and ranges have units."""

import click
import numpy as np
import pytest
import xarray
from tdmf_slip.cli.main import commands


def single_options():
    """Options of all commands that take one value."""
    context = click.Context(commands)
    for name in commands.list_commands(context):
        for option in commands.get_command(context, name).params:
            if isinstance(option, click.Option) and not option.multiple and not option.is_flag:
                yield name, option.opts[0], option.nargs


@pytest.mark.parametrize(("command_name", "option", "values"), list(single_options()))
def test_no_option_is_given_twice(command, tmp_path, command_name, option, values):
    assert f"{option} is given twice" in command.refusal(command_name, *(2 * [option, *(values * ["1"])]))
    assert list(tmp_path.iterdir()) == []


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


@pytest.mark.parametrize("name", ["none.toml", "folder.toml", "folder", "empty.toml", "empty.json", "humn"])
@pytest.mark.parametrize("option", ["--parameters", "--from-gait", "--inputs"])
def test_a_file_that_is_none_is_told_without_a_number(command, tmp_path, option, name):
    for folder in ("folder.toml", "folder"):
        (tmp_path / folder).mkdir()
    for file in ("empty.toml", "empty.json"):
        (tmp_path / file).touch()
    said = command.refusal("simulate", option, name, "--stop-time", 1)
    assert name in said and "Errno" not in said, said


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
