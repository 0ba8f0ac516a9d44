"""Branches of this runner's gaits: as a command, doubled, drawn, and against plain strides."""

import json
from pathlib import Path

import numpy as np
import pytest
from branch_rows import met, rows_of, specials
from conftest import RELEASE
from matplotlib.backends.backend_agg import FigureCanvasAgg
from tdmf_slip import Batch, InputError, Runner, continue_branch, find_gait, gait_at, plot
from tdmf_slip.analysis.along import gaits_over
from tdmf_slip.analysis.sweeps import gaits_in
from tdmf_slip.library.engine import FATES
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.pictures.branch_diagram import figure_of, values_of
from tdmf_slip.variables.parameters import read_parameters
from tdmf_slip.variables.table import FRICTION

FAST_HUMAN = Path(__file__).with_name("fast_human.toml")
ANGLE = "hip.touchdown_angle"
STRIDES = 4_000


@pytest.fixture(scope="module")
def over_low_angle(runner):
    """A branch over falling angles that passes a period doubling."""
    return continue_branch(runner, {ANGLE: (0.575, 0.56)})


@pytest.fixture(scope="module")
def over_angle(runner):
    """The branch goes from 40 degrees upwards, around two folds."""
    return continue_branch(runner, {ANGLE: (np.radians(40.0), np.radians(53.0))}, max_step=1.0)


def settled(runner, apex, strides=STRIDES):
    """The apex after a number of plain strides, and the number of strides made."""
    return runner.settle(np.asarray(apex), strides)


def apart(runner, one, other):
    return float(np.max(np.abs(one - other) / runner.scales))


def one(branch, kind):
    (found,) = specials(rows_of(branch), kind)
    return found


def test_the_default_runner_over_the_touchdown_angle(over_angle):
    """Two real eigenvalues that meet outside the unit circle, after the second fold, are no bifurcation.

    Between the folds the branch turns twice within a millionth of a degree, where it crosses two borders.
    """
    rows = rows_of(over_angle)
    bifurcations = [s for s in specials(rows) if s.kind not in ("word border", "unclassified")]
    assert [special.kind for special in bifurcations] == ["fold", "fold", "Neimark-Sacker"]
    turns = specials(rows, "unclassified")
    borders = [
        s.value for s in specials(rows) if s.words == ("+0-+", "+0-") and s.value < bifurcations[0].value
    ]
    assert len(turns) == 2 and all("the branch turns" in turn.why for turn in turns)
    assert max(abs(turn.value - borders[0]) for turn in turns) < 1e-7
    for fold in bifurcations[:2]:
        assert np.abs(fold.gait.eigenvalues - 1.0).min() < 1e-9
    pair = bifurcations[2].gait.eigenvalues[:2]
    assert np.abs(pair) == pytest.approx([1.0, 1.0], abs=1e-9) and abs(pair[0].imag) > 0.1
    assert over_angle.ended == "end of the range" and rows[-1].value == np.radians(53.0)
    unstable = [row.gait.unstable for row in met(rows)]
    assert [n for n, m in zip(unstable, [None, *unstable], strict=False) if n != m] == [0, 1, 2, 0]


def test_the_fast_human_over_the_friction(command):
    """It falls at 0.35, so that the branch begins above its fold, beside borders, and is followed both ways.

    Just above the fold plain strides settle on the stable gait, below it the runner falls.
    """
    printed = command.json("continue", "--parameters", FAST_HUMAN, "--vary", "ground.friction=0.35:0.5")
    assert printed["ended"] == printed["began"] == "end of the range"
    (fold,) = [special for special in printed["specials"] if special["kind"] == "fold"]
    assert fold["value"] == pytest.approx(0.3836020818, abs=1e-9)
    assert {s["kind"] for s in printed["specials"]} == {"fold", "word border"}
    points = printed["points"]
    assert (
        points[0]["value"] == points[-1]["value"] == 0.5 and min(p["value"] for p in points) >= fold["value"]
    )
    assert points[0]["stable"] != points[-1]["stable"]
    borders = [(s["from"], s["to"]) for s in printed["specials"] if s["kind"] == "word border"]
    assert [before for before, _ in borders[1:]] == [after for _, after in borders[:-1]]
    assert points[0]["word"] == borders[0][0] and points[-1]["word"] == borders[-1][1]
    human = Runner(read_parameters(FAST_HUMAN)).replace({FRICTION: fold["value"] + 1e-3})
    near = min((p for p in points if p["stable"]), key=lambda p: p["value"])
    gait = gait_near(human, near["apex"])
    runners = [human, human.replace({FRICTION: fold["value"] - 1e-3})]
    ends = Batch(runners, [gait.apex + 1e-4 * human.scales, gait.apex]).run(STRIDES)
    assert gait.stable and ends["strides"][0] == STRIDES
    assert apart(human, ends["apex"][0], gait.apex) < 1e-6
    assert FATES[ends["fate"][1]] == "fell"


def test_gaits_of_two_strides_are_those_of_plain_strides(over_low_angle):
    """Beyond the period doubling a runner settles on a gait that repeats itself after two strides."""
    doubling = one(over_low_angle, "period doubling")
    assert over_low_angle["branch_strides"].values.tolist() == [1, 2]
    doubled = [row for row in met(rows_of(over_low_angle)) if row.branch == 1]
    assert all(row.gait.stable and row.value < doubling.value for row in doubled)
    assert doubled[-1].value == 0.56
    compared = 0
    for gait in [row.gait for row in doubled[len(doubled) // 3 :: 4]]:
        apex, ran = settled(gait.runner, gait.apex + 1e-3 * gait.runner.scales)
        assert ran == STRIDES
        both = [apart(gait.runner, apex, other) for other in (gait.apex, *gait.following)]
        assert min(both) < 1e-9 < 1e-3 < max(both)
        next_apex, _ = settled(gait.runner, apex, 1)
        assert apart(gait.runner, next_apex, apex) == pytest.approx(max(both), rel=1e-6)
        compared += 1
    assert compared >= 3


def code_of(word):
    """Code of a word in the library: base 4, the first letter most significant."""
    return int("".join(str("|-0+".index(letter)) for letter in word), 4)


BORDERED = [
    ("paper", FRICTION, 1.2, 0.2, 4),
    ("paper", ANGLE, np.radians(40.0), np.radians(52.0), 3),
    (FAST_HUMAN, FRICTION, 0.6, 0.39, 2),
]


@pytest.mark.parametrize(("preset", "name", "begin", "end", "smallest"), BORDERED[: 3 if RELEASE else 1])
def test_a_word_border_is_where_plain_strides_change_their_word(preset, name, begin, end, smallest):
    """Runners on both sides of each border settle in the ensemble, also where a word holds over 3e-6."""
    runner = Runner(read_parameters(preset))
    rows = rows_of(continue_branch(runner, {name: (begin, end)}, switch=False))
    borders = [(special.value, special) for special in specials(rows, "word border")]
    values = [rows[0].value, *(value for value, _ in borders), rows[-1].value]
    gaits, words = [], []
    for number, (value, special) in enumerate(borders, 1):
        for way, word in zip((-1, 1), special.words, strict=True):
            off = min(1e-3 * abs(value), 0.3 * abs(values[number + way] - value))
            at = value + off * np.sign(values[number + way] - value)
            gaits.append(next(gaits_over(runner, name, [at], special.gait)))
            words.append(word)
    assert all(gait.stable for gait in gaits) and [gait.word for gait in gaits] == words
    starts = [gait.apex + 1e-3 * gait.runner.scales for gait in gaits]
    ends = Batch([gait.runner for gait in gaits], starts).run(STRIDES)
    assert ends["strides"].tolist() == [STRIDES] * len(gaits)
    assert ends["word_code"].tolist() == [code_of(word) for word in words]
    for gait, apex in zip(gaits, ends["apex"], strict=True):
        assert apart(gait.runner, gait.apex, apex) < 1e-6
    assert len(gaits) >= 2 * smallest


def test_a_neimark_sacker_point_is_where_plain_strides_spiral_in_or_out(over_angle):
    rows, point = rows_of(over_angle), one(over_angle, "Neimark-Sacker")
    index = [row.kind for row in rows].index("Neimark-Sacker")
    for value, settles in ((point.value - 5e-3, False), (point.value + 5e-3, True)):
        near = min(met(rows[index - 5 : index + 6]), key=lambda row: abs(row.value - value))
        gait = next(gaits_over(near.gait.runner, ANGLE, [value], near.gait))
        apex, ran = settled(gait.runner, gait.apex + 1e-4 * gait.runner.scales)
        assert (ran == STRIDES and apart(gait.runner, apex, gait.apex) < 1e-6) == settles


@pytest.mark.filterwarnings("error")
def test_gaits_and_pictures_have_the_values_that_vary():
    """Without the stiffness the preset would mix units."""
    branch = continue_branch("human", {"leg.stiffness": (20000.0, 20100.0)}, max_points=2, switch=False)
    found = gait_at(branch.isel(point=1))
    assert found.runner == Runner("human").replace({"leg.stiffness": found.runner["leg.stiffness"]})
    assert found.runner["leg.stiffness"] == branch["leg.stiffness"].values[1]
    assert plot(branch).axes[0].get_ylabel() == "apex.com_speed (m/s)"


def test_all_points_have_the_parameter_of_their_gait(over_angle):
    """Also word borders and unclassified points, where the gait is the one just beyond."""
    found = gaits_in(over_angle)
    assert [gait.word for gait in found] == over_angle["word"].values.tolist()
    assert max(gait.error for gait in found) < 1e-9
    assert {"word border", "unclassified"} <= set(over_angle["special"].values)


def test_a_gait_is_on_the_branch_of_its_own_model_only():
    gait = find_gait(friction=0.56)
    full, reduced = (
        continue_branch(gait, {FRICTION: (0.57, 0.55)}, model=model, switch=False)
        for model in (None, "reduced")
    )
    assert full.model == "full" and gait.friction in full[FRICTION].values
    assert reduced.model == "reduced" and reduced.sizes["coordinate"] == 2


def test_a_diagram_a_dataset_and_json_with_doubled_gaits_are_one_command(command, tmp_path):
    asked = ("continue", "--vary", "hip.touchdown_angle=0.57:0.563", "--plot", "a.png", "--output", "a.nc")
    (printed,) = command.json(*asked)["branches"]
    assert printed["strides"] == 2
    assert printed["began"].startswith("period doubling at hip.touchdown_angle = 0.565")
    point = printed["points"][-1]
    assert point["strides"] == 2 and len(point["apexes"]) == 2 and point["apexes"][0] == point["apex"]
    assert point["word"].count(" ") == 1 and len(point["eigenvalues"]) == 6
    assert (tmp_path / "a.png").read_bytes()[:4] == b"\x89PNG"
    import xarray

    data = xarray.load_dataset(tmp_path / "a.nc")
    assert data.attrs["ended"] == "end of the range" and data[ANGLE].attrs["units"] == "rad"
    assert [kind for kind in data["special"].values if kind] == ["period doubling"]
    assert set(data["unstable"].values.tolist()) == {0, 1}
    assert data["branch_strides"].values.tolist() == [1, 2]
    gait = gait_at(data.isel(point=-1))
    assert gait.strides == 2 and gait.speed == data["speed"].values[-1]
    assert gait.stride["speed"] == pytest.approx(gait.stride["length"] / gait.stride["period"], rel=1e-14)
    assert values_of(data, "com_speed")[-1].tolist() == [apex[1] for apex in point["apexes"]]
    data.assign_attrs(result="basin").to_netcdf(tmp_path / "map.nc")
    complaint = command.refusal("continue", "--vary", "hip.touchdown_angle=0.57:0.563", "--output", "map.nc")
    assert "map.nc: holds a basin" in complaint


def test_lines_are_solid_where_gaits_are_stable(over_low_angle):
    axes = plot(over_low_angle).axes[0]
    lines = {line.get_label(): line for line in axes.get_lines()}
    assert {"stable, 1 stride", "unstable, 1 stride", "stable, 2 strides", "period doubling"} <= set(lines)
    assert lines["stable, 1 stride"].get_linestyle() == "-"
    assert lines["unstable, 1 stride"].get_linestyle() == "--"
    change = one(over_low_angle, "period doubling").value
    stable, unstable = (lines[f"{kind}, 1 stride"].get_xdata() for kind in ("stable", "unstable"))
    assert min(stable) == change == max(unstable)
    words = {" ".join(sorted(text.get_text().split())) for text in axes.texts}  # either stride may come first
    assert words == {"+0−", "+−", "+0− +0−", "+0− +−"}
    with pytest.raises(InputError, match=r"quantity: 'sped' is not allowed; near matches: speed"):
        figure_of(over_low_angle, "sped")


def test_words_are_beside_their_lines_and_hide_nothing(over_angle):
    figure = plot(over_angle)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    axes = figure.axes[0]
    words = [text for text in axes.texts if text.get_text()]
    assert {"+0−0+", "0−"} <= {text.get_text() for text in words} and len(words) >= 4
    boxes = np.array([text.box_of_word(canvas.get_renderer()).extents for text in words])
    low, high = boxes[:, None, :2], boxes[:, None, 2:]
    shares = np.linspace(0.0, 1.0, 50)[:, None, None]
    for line in axes.get_lines():
        ends = axes.transData.transform(line.get_xydata())
        drawn = ((1.0 - shares) * ends[:-1] + shares * ends[1:]).reshape(-1, 2)
        assert not np.any(np.all((low < drawn) & (drawn < high), axis=2))


def test_a_sweep_says_that_a_fold_ends_its_branch(command):
    """The fast human down to friction 0.35, below the fold at 0.3836, and up from there."""
    options = ("--parameters", str(FAST_HUMAN), "--json")
    status, out, said = command("sweep", "--vary", "ground.friction=0.5:0.35:4", *options)
    printed = json.loads(out)
    assert status == 1 and printed["missing"] == [0.35]
    (branch,) = printed["branches"]
    assert (branch["from"], branch["began"]) == (0.5, None) and branch["to"] == pytest.approx(0.4)
    assert branch["ended"] == "the branch ends in a fold at ground.friction = 0.3836020818"
    assert "0.3836020818" in said
    _, out, _ = command("sweep", "--friction", "0.35:0.5:4", *options)
    (branch,) = json.loads(out)["branches"]
    assert (
        branch["from"] == pytest.approx(0.4) and branch["ended"] is None and "0.3836020818" in branch["began"]
    )


def test_a_sweep_over_any_parameter_alone(command, tmp_path):
    over = ("sweep", "--vary", "leg.damping=0.15:0.25:3")
    printed = command.json(*over, "--friction", "0.43", "--output", "sweep.nc")
    assert printed["over"] == "leg.damping" and printed["missing"] == []
    for gait, value in zip(printed["gaits"], (0.15, 0.2, 0.25), strict=True):
        assert gait["value"] == gait["start_values"]["leg.damping"] == pytest.approx(value, abs=1e-15)
        assert gait["friction"] == 0.43
    import xarray

    data = xarray.load_dataset(tmp_path / "sweep.nc")
    assert data["leg.damping"].attrs["units"] == "N.s/m" and data["branch"].values.tolist() == [0, 0, 0]
    assert command.json(*over, "--set", "ground.friction=0.43")["gaits"] == printed["gaits"]
