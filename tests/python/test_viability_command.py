"""The command `viability`, its picture, and computation on a cluster."""

import csv
import json

import pytest
import tdmf_slip
from tdmf_slip.pictures import basin_map

ANGLE = "hip.touchdown_angle"
GRID = ("--axes", "com_height=1:2", "--axes", "com_speed=0.5:1.5", "--vary", "hip.touchdown_angle=0.3:1.1:6")
SETTINGS = {"axes": {"com_height": (1, 2), "com_speed": (0.5, 1.5)}, "vary": {ANGLE: (0.3, 1.1, 6)}, "n": 6}


def test_the_command_finds_what_the_function_finds_draws_writes_and_goes_on(command, tmp_path):
    files = "--output", tmp_path / "viable.nc", "--plot", tmp_path / "viable.png"
    options = ("viability", "--friction", 0.3, *GRID, *files)
    printed = command.json(*options, "--n", 6)
    found = tdmf_slip.viability({"ground.friction": 0.3}, **SETTINGS)
    assert printed["runner"] == json.loads(found.runner)
    assert (printed["cells"], printed["actions"], printed["strides"]) == ([6, 6], 6, 7 * 7 * 6)
    for name in ("inner", "outer"):
        assert printed[f"{name}_share"] == found.attrs[f"{name}_share"]
        assert printed[f"{name}_robustness"] == float(found[f"{name}_robustness"].mean())
    assert (tmp_path / "viable.png").stat().st_size > 10_000
    assert command.json(*options, "--n", 6) == printed
    assert "not this viable set" in command.refusal(*options, "--n", 7)


def test_the_command_tells_of_the_gait_and_writes_a_controller(command, tmp_path):
    file = tmp_path / "controller.csv"
    wide = ("--axes", "com_height=0.5:2", "--axes", "com_speed=0:2", *GRID[4:])
    printed = command.json("viability", *wide, "--n", 24, "--gait", "--controller", file)
    gait, axes = tdmf_slip.find_gait(model="reduced"), {"com_height": (0.5, 2), "com_speed": (0, 2)}
    found = tdmf_slip.viability(None, axes=axes, vary=SETTINGS["vary"], n=24, gait=gait)
    assert printed["reached"]["cells"] == int(found["at_gait"].sum())
    assert printed["reached"]["outer_share"] == (found["outer_strides"].values >= 0).mean() > 0
    assert printed["largest_drop"]["outer"] == found["outer_drop"].values[found["at_gait"].values == 1].min()
    law = tdmf_slip.ViableController(found)
    with file.open(encoding="utf-8") as opened:
        rows = list(csv.DictReader(opened))
    assert len(rows) == 24 * 24
    assert {row["grade"] for row in rows} >= {"viable", "open"}
    for row in rows[::17]:
        apex = [float(row["com_height"]), float(row["com_speed"])]
        assert float(row[ANGLE]) == law.inputs_at(apex)[ANGLE]
        assert row["grade"] == law.grade_at(apex)
    status, out, _ = command("viability", *wide, "--n", 12, "--gait")
    assert status == 0 and "leads to the gait" in out and "of the cells" in out


def test_the_picture_tells_the_three_kinds_of_cells_apart():
    ranges = {"com_height": (0.3, 3), "com_speed": (0, 3)}
    found = tdmf_slip.viability({"ground.friction": 10}, axes=ranges, vary={ANGLE: (0.1, 1.3, 12)}, n=20)
    axes, bar = tdmf_slip.plot(found).axes
    assert (axes.get_xlim(), axes.get_ylim()) == ((0, 3), (0.3, 3))
    none, opened, viable = axes.collections
    states = found["viable"].values
    for mesh, level in ((none, 0), (opened, 1), (viable, 2)):
        assert ((states == level) == ~mesh.get_array().mask).all()
        assert (states == level).any()
    assert viable.get_clim() == (0, found["inner_robustness"].max())
    assert "share" in bar.get_ylabel()
    assert basin_map.OPEN != basin_map.NOT_VIABLE


def test_units_are_read_and_sixteen_values_are_tried(command):
    grid = (*GRID[:4], "--vary", "hip.touchdown_angle=20 deg:60 deg")
    found = command.json("viability", *grid, "--n", 4, "--model", "full")
    assert found["actions"] == 16
    assert found["vary"][ANGLE][:2] == pytest.approx([0.349065850399, 1.047197551197])
