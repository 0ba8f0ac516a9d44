"""Units as their user gave them: read in any spelling, and told again in tables and pictures."""

import json
import math
import re

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray
from tdmf_slip import (
    basin,
    continue_branch,
    find_gait,
    load_fmu,
    lqr,
    sweep,
    viability,
)
from tdmf_slip.pictures import branch_diagram, sweep_diagram
from tdmf_slip.variables.display_units import DisplayUnits

ANGLE, FRICTION, DAMPING = "hip.touchdown_angle", "ground.friction", "leg.damping"
OVER = f"{ANGLE}=40 deg:42 deg"


@pytest.mark.parametrize(
    ("name", "text", "value"),
    [
        ("leg.free_length", "100 cm", 1.0),
        ("leg.free_length", "950 mm", 0.95),
        ("foot.mass", "50 g", 0.05),
        (ANGLE, "40 degrees", math.radians(40.0)),
        (ANGLE, "1 degree", math.radians(1.0)),
        (ANGLE, "40 deg", math.radians(40.0)),
        ("leg.stiffness", "20 kN/m", 20e3),
        ("foot.vx", "3.6 km/h", 1.0),
        ("ground.friction", "0.5 1", 0.5),
        ("leg.stiffness", "20 N/mm", 20e3),
        ("leg.damping", "360 N·s/m", 360.0),
        ("hip.stance_torque", "336 N m", 336.0),
        ("gravity", "9.81m/s^2", 9.81),
        (ANGLE, "-1e1deg", -np.pi / 18),
    ],
)
def test_units_are_read_as_people_write_them(name, text, value):
    assert load_fmu().variables[name].value_of(text, "here") == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    "call",
    [
        lambda unit: basin({}, {"leg_angle": (unit(0.6), unit(0.7)), "com_speed": (1.0, 1.1)}, 2).leg_angle,
        lambda unit: viability(
            axes={"com_height": (1.0, 2.0), "com_speed": (0.5, 1.5)},
            vary={ANGLE: (unit(0.4), unit(0.6), 3)},
            n=2,
        )[ANGLE],
        lambda unit: lqr(find_gait(), [ANGLE], limits={ANGLE: (unit(0.5), unit(0.9))}).low,
        lambda unit: sweep({}, {ANGLE: [unit(0.69), unit(0.7)]}).gaits[ANGLE],
        lambda unit: continue_branch({}, {ANGLE: (unit(0.69), unit(0.7))}, switch=False)[ANGLE][[0, -1]],
    ],
)
def test_a_range_may_be_texts_with_units_wherever_it_is_given(call):
    np.testing.assert_allclose(
        call(lambda angle: f"{math.degrees(angle)!r} deg"), call(lambda angle: angle), rtol=1e-12
    )


def marks(axis):
    """Labels along an axis, each with its position."""
    axis.figure.draw_without_rendering()
    low, high = sorted(axis.get_view_interval())
    pairs = zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
    return [
        (position, float(text.get_text().replace("−", "-")))
        for position, text in pairs
        if low <= position <= high
    ]


def check_degrees(axis, label):
    assert label == f"{ANGLE} (deg)"
    found = marks(axis)
    assert len(found) >= 3
    for position, written in found:
        assert written == pytest.approx(math.degrees(position), abs=1e-4)
        assert written == pytest.approx(round(written, 2), abs=1e-9)  # round in degrees


def test_pictures_are_marked_in_the_unit_that_was_given():
    display, ends = (
        DisplayUnits({ANGLE: "40 deg:42 deg"}),
        (math.radians(40.0), math.radians(42.0)),
    )
    found = continue_branch({FRICTION: 0.6}, {ANGLE: ends}, switch=False)
    figure = branch_diagram.figure_of(found, display=display)
    check_degrees(figure.axes[1].xaxis, figure.axes[1].get_xlabel())
    assert f"{ANGLE} from 40:" in figure.axes[0].get_title()
    (line, *_) = figure.axes[0].lines
    assert np.min(line.get_xdata()) < 1.0  # what is drawn stays in the variable's unit
    swept = sweep({FRICTION: 0.6}, {ANGLE: np.linspace(*ends, 3)})
    figure = sweep_diagram.figure_of(*swept, display)
    check_degrees(figure.axes[-1].xaxis, figure.axes[-1].get_xlabel())
    figure = branch_diagram.figure_of(found)
    assert figure.axes[1].get_xlabel() == f"{ANGLE} (rad)"
    plt.close("all")


def test_tables_are_in_the_unit_that_was_given(command):
    status, out, err = command("continue", "--vary", OVER, "--no-switch", "--friction", "0.6")
    assert status == 0, err
    assert f"{ANGLE} (deg)" in out
    first, last = re.search(r"from (\S+) \(.*\) to (\S+) \(", out.splitlines()[0]).groups()
    assert (float(first), float(last)) == pytest.approx((40.0, 42.0), abs=1e-6)
    status, out, err = command("sweep", "--vary", f"{OVER}:3", "--set", "ground.friction=0.6")
    assert status == 0, err
    header, _, *rows = out.splitlines()
    assert header.startswith(f"{ANGLE} (deg)")
    assert [float(row.split()[0]) for row in rows[:3]] == pytest.approx([40.0, 41.0, 42.0])


def test_what_an_order_frees_is_told_in_the_unit_that_it_was_given_in(command):
    arguments = ("gait", "--target", "speed=1.05", "--vary", ANGLE, "--friction", "0.6")
    degrees, radians = (
        re.search(rf"{ANGLE}\s+(\S+) (\S+)", command(*arguments, *more)[1]).groups()
        for more in (("--set", f"{ANGLE}=40 deg"), ())
    )
    assert (degrees[1], radians[1]) == ("deg", "rad")
    assert float(degrees[0]) == pytest.approx(math.degrees(float(radians[0])), rel=1e-8)


def test_a_sweep_is_drawn_and_written_as_any_result(command, tmp_path):
    sweep_ = ("sweep", "--friction", "0.5:0.6:3")
    status, display, err = command(*sweep_, "--json")
    assert status == 0, err
    found = json.loads(display)
    assert command(*sweep_, "--output", "-")[1] == display
    assert command(*sweep_, "--output", "gaits.json", "--plot", "gaits.png")[0] == 0
    assert json.loads((tmp_path / "gaits.json").read_text(encoding="utf-8")) == found
    assert (tmp_path / "gaits.png").read_bytes().startswith(b"\x89PNG")
    assert command(*sweep_, "--output", "gaits.nc")[0] == 0
    assert xarray.load_dataset(tmp_path / "gaits.nc")[FRICTION].values == pytest.approx([0.5, 0.55, 0.6])


def test_a_key_of_twenty_thousand_dots_is_answered_at_once(command, tmp_path):
    """The parser of TOML would take 25 s; the regular expression is linear in the text."""
    path = tmp_path / "deep.toml"
    for text in (".".join("x" * 20_001) + " = 1", "[" + " . ".join(['"x"'] * 20_001) + "]\ny = 1"):
        path.write_text(f"# names\n{text}\n")
        said = command.refusal("gait", "--parameters", str(path))
        assert "line 2: a key of more than 16 parts" in said and len(said) < 300


@pytest.mark.parametrize(
    "text", ['{"a":' * 900 + "1" + "}" * 900, "{" + ", ".join(f'"n{k}": 1' for k in range(30_000)) + "}"]
)
def test_a_strange_file_of_parameters_is_answered_in_one_sentence(command, tmp_path, text):
    path = tmp_path / "strange.json"
    path.write_text(text)
    assert len(command.refusal("gait", "--parameters", str(path))) < 600


def test_dots_in_comments_and_texts_are_no_keys(command, tmp_path):
    path = tmp_path / "fine.toml"
    dots = ". " * 40 + "." * 200
    path.write_text(
        f"# a{dots} of.a.paper\nground.friction = 0.6 # {dots}\n[hip]\ntouchdown_angle = '40 deg'\n"
    )
    assert command("gait", "--parameters", str(path))[0] == 0
