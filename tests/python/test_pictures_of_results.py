"""Every result draws itself: what its axes name, and that the marks are its numbers."""

import importlib
import io
import json
import math

import matplotlib.pyplot as plt
import numpy as np
import pytest
import tdmf_slip
from conftest import release
from matplotlib.collections import PolyCollection
from tdmf_slip import Runner
from tdmf_slip.analysis.first_passage import FirstPassage
from tdmf_slip.analysis.rare_falls import RareFalls
from tdmf_slip.paper.reference_gaits import Drift
from tdmf_slip.pictures import style
from tdmf_slip.pictures.plot import PICTURES

ANGLE, TORQUE, FRICTION = "hip.touchdown_angle", "hip.stance_torque", "ground.friction"


def labels(axes):
    return axes.get_xlabel(), axes.get_ylabel()


def line(axes, label):
    (found,) = [one for one in axes.lines if one.get_label() == label]
    return np.array(found.get_xdata()), np.array(found.get_ydata())


def legend(figure):
    return [text.get_text() for one in figure.legends for text in one.get_texts()]


def test_every_picture_is_of_a_kind_that_there_is_and_has_a_function():
    for kind, picture in PICTURES.items():
        module, _, function = picture.draw.rpartition(".")
        assert callable(getattr(importlib.import_module(f"tdmf_slip.{module}"), function))
        assert kind.islower() or hasattr(tdmf_slip, kind)


def test_a_dataset_that_is_not_whole_is_refused(gait):
    made = tdmf_slip.stride_map(gait, gait.apex)
    with pytest.raises(tdmf_slip.InputError, match=r"is None; allowed: basin.*keep_attrs"):
        tdmf_slip.plot(made.drop_attrs())
    with pytest.raises(tdmf_slip.InputError, match=r"`result` is \[1\]; allowed: basin"):
        tdmf_slip.plot(made.assign_attrs(result=[1]))
    with pytest.raises(
        tdmf_slip.InputError, match=r"incomplete strides: .*'fate'.*; allowed: one with all its"
    ):
        tdmf_slip.plot(made.drop_vars("fate"))
    with pytest.raises(tdmf_slip.InputError, match=r"strides over 1 dimension; allowed: 2, see"):
        tdmf_slip.plot(made.isel(stride=0))
    with pytest.raises(tdmf_slip.InputError, match="int cannot be drawn"):
        tdmf_slip.plot(3)
    cube = tdmf_slip.sweep(None, {"friction": [0.6], "damping": [0.2], "torque": [0.2]}).gaits
    with pytest.raises(tdmf_slip.InputError, match="sweep over 3 dimensions; allowed: 1 or 2"):
        tdmf_slip.plot(cube)
    assert tdmf_slip.plot(cube.isel({"hip.stance_torque": 0})).axes


def test_a_basin_shows_strides_until_the_fate_and_the_gait(gait):
    height, speed = gait.apex[:2]
    axes = {"com_height": (height, height + 2.0), "com_speed": (speed, speed + 1.0)}
    found = tdmf_slip.basin(gait, axes, n=9)
    drawn = tdmf_slip.plot(found).axes[0]
    assert drawn.get_title(loc="left").endswith(f"{found.settled_share:.1%} of 81 starts settle")
    shown = [mesh.get_array() for mesh in drawn.collections if mesh.get_array() is not None]
    strides = np.ma.masked_all((9, 9))
    for part in shown:
        strides[~part.mask.reshape(9, 9)] = part.reshape(9, 9)[~part.mask.reshape(9, 9)]
    known = ~strides.mask
    assert known.any() and np.array_equal(strides[known], found["strides_until_known"].values[known])
    (cross,) = [one for one in drawn.lines if one.get_label() == "gait"]
    assert (cross.get_xdata()[0], cross.get_ydata()[0]) == (speed, height)


def test_strides_show_their_apices_and_end_where_runners_fall(gait):
    low = gait.apex * [0.75, 1.0, 1.0, 1.0, 1.0, 1.0]
    made = tdmf_slip.stride_map(gait, [gait.apex, low], strides=4, inputs={ANGLE: [[0.698] * 4, [-0.5] * 4]})
    heights, speeds = tdmf_slip.plot(made).axes
    assert labels(speeds) == ("strides", "speed of the centre of mass (l₀√(k/m))")
    for number in (0, 1):
        for axes, coordinate in ((heights, 0), (speeds, 1)):
            apices = [made["apex"][number, 0, coordinate], *made["next_apex"][number, :, coordinate]]
            np.testing.assert_array_equal(axes.lines[number].get_ydata(), apices)
    assert np.isnan(heights.lines[1].get_ydata()).any() and not np.isnan(heights.lines[0].get_ydata()).any()
    many = tdmf_slip.stride_map(gait, gait.apex + 1e-3 * np.arange(30)[:, None] * np.eye(6)[0], strides=2)
    _, median = line(tdmf_slip.plot(many).axes[0], "median of those that are up")
    assert median[1] == np.median(many["next_apex"][:, 0, 0])


def test_runs_show_their_last_strides_over_what_is_varied():
    runs = tdmf_slip.simulate_many([{FRICTION: 0.6}, {FRICTION: 1.2}], strides=2)
    speeds, costs = tdmf_slip.plot(runs).axes
    assert costs.get_xlabel() == FRICTION and speeds.get_ylabel() == "speed (l₀√(k/m))"
    frictions, drawn = line(speeds, "ran")
    assert frictions.tolist() == [0.6, 1.2] and np.array_equal(drawn, runs["speed"])


def test_runs_sweeps_branches_and_gaits_show_their_numbers(gait):
    run = tdmf_slip.simulate(gait, strides=2)
    sweep = tdmf_slip.sweep({}, {FRICTION: [0.7, 0.6, 0.45]})
    branch = tdmf_slip.continue_branch(gait, {"leg.damping": (0.2, 0.22)})
    path = tdmf_slip.trajectory(gait, times=np.linspace(0.0, 20.0, 50))
    for result, x, y in (
        (run, run["time"], run["contact.fy"]),
        (sweep, sweep.gaits[FRICTION], sweep.gaits["speed"]),
        (branch, branch["leg.damping"], branch["lambda_max"]),
        (path, path["time"], path["foot.y"]),
    ):
        drawn = [one.get_xydata() for axes in tdmf_slip.plot(result).axes for one in axes.lines]
        assert any(np.array_equal(of, np.column_stack([x, y])) for of in drawn), result
    edges = {tuple(one.get_ydata()) for axes in gait.plot().axes for one in axes.lines}
    assert {(0.6, 0.6), (-0.6, -0.6)} <= edges  # the friction cone's


def test_feedbacks_grids_and_fronts_show_their_numbers(gait):
    law = tdmf_slip.dead_beat(gait, [ANGLE, TORQUE])
    left, right = tdmf_slip.plot(law).axes
    for label, values in (("without", gait.eigenvalues), ("with the law", law.eigenvalues)):
        x, y = line(left, label)
        assert np.array_equal(x + 1j * y, values)
    assert len(right.patches) == 2 * 6
    grid = tdmf_slip.sweep({}, {"leg.damping": [0.2, 0.21], FRICTION: [0.7, 0.43]}).gaits
    speeds, words, _ = tdmf_slip.plot(grid).axes
    assert np.array_equal(speeds.collections[0].get_array().reshape(2, 2), grid["speed"])
    assert len(words.get_legend().get_texts()) == 2
    sought = {"minimize": ["cost_of_transport"], "maximize": ["speed"], "points": 2, "starts": 1}
    front = tdmf_slip.pareto_front({}, {TORQUE: (0.15, 0.25)}, **sought)
    assert np.allclose(tdmf_slip.plot(front).axes[0].lines[0].get_ydata(), front["speed"], rtol=1e-12)


@release
def test_a_proved_gait_shows_its_eigenvalues_and_enclosures():
    pytest.importorskip("flint")
    proof = tdmf_slip.prove({FRICTION: 0.6})
    left, right = tdmf_slip.plot(proof).axes
    assert len(line(left, style.word(proof.word))[0]) == len(right.patches) == 6
    assert right.patches[0].get_width() == pytest.approx(float(proof.apex[0].rad()))


def test_controllability_shows_modes_beside_the_unit_circle(gait):
    found = tdmf_slip.controllability(gait, [ANGLE, TORQUE])
    figure = tdmf_slip.plot(found)
    left, right = figure.axes
    assert labels(left) == ("real part of the eigenvalue", "imaginary part of the eigenvalue")
    x, y = line(left, "can be moved")
    assert np.array_equal(x + 1j * y, found.eigenvalues)
    circle = np.hypot(*line(left, "unit circle"))
    assert np.allclose(circle, 1.0, rtol=1e-12)
    heights = np.array([bar.get_height() for bar in right.patches]).reshape(2, -1)
    assert np.array_equal(heights.T, found.modal_controllability)
    assert {ANGLE, TORQUE} <= set(legend(figure))


def test_an_optimum_shows_what_it_changed(gait):
    found = tdmf_slip.optimize(gait, {TORQUE: (0.19, 0.21)}, maximize="speed", starts=1)
    upper, lower = tdmf_slip.plot(found).axes
    assert upper.get_xlabel() == "change from the runner that was given (%)"
    names = [text.get_text() for text in upper.get_yticklabels()]
    width = upper.patches[names.index("speed")].get_width()
    assert width == pytest.approx(100.0 * (found.value / gait.speed - 1.0), rel=1e-12) and width > 0.0
    (bar,) = lower.patches
    assert bar.get_width() == pytest.approx(
        100.0 * (found.parameters[TORQUE] / gait.runner[TORQUE] - 1.0), rel=1e-12
    )


def test_a_comparison_has_no_bar_where_a_quantity_is_held():
    found = tdmf_slip.compare([{FRICTION: 0.6}, {FRICTION: 0.7}], hold=["speed"], vary=[TORQUE])
    (axes,) = tdmf_slip.plot(found).axes
    names = [text.get_text() for text in axes.get_yticklabels()]
    widths = dict(zip(names, (bar.get_width() for bar in axes.patches), strict=True))
    assert abs(widths["speed"]) < 1e-5 and abs(widths["slip distance"]) > 0.1
    assert axes.get_xlabel() == "difference from runner 0 (%)"


def test_strides_to_fall_show_who_is_still_up():
    found = FirstPassage(Runner(), "+0+", 0.02, runners=100, falls=80, strides=1600)
    figure = tdmf_slip.plot(found)
    (axes,) = figure.axes
    assert labels(axes) == ("strides begun", "probability of not having fallen")
    strides, still_up = line(axes, "mean 20 strides until the fall")
    assert np.allclose(still_up, 0.95**strides, rtol=1e-9)
    (band,) = [one for one in axes.collections if isinstance(one, PolyCollection)]
    low, high = found.interval
    vertices = band.get_paths()[0].vertices
    at = vertices[np.isclose(vertices[:, 0], strides[200], rtol=1e-12), 1]
    assert sorted(at) == pytest.approx(sorted((1.0 - 1.0 / np.array([low, high])) ** strides[200]), rel=1e-9)


def test_rare_falls_are_drawn_also_where_the_interval_is_open():
    rates = np.array([0.0, 0.0, 3e-6])
    found = RareFalls(Runner(), "+0+", 0.01, rates, 3, 1000)
    assert math.isinf(found.interval[1])
    (axes,) = tdmf_slip.plot(found).axes
    strides, still_up = line(axes, "mean 1e+06 strides until the fall")
    assert np.allclose(still_up, np.exp(-1e-6 * strides), rtol=1e-4)


def test_a_proved_attraction_bounds_the_distance_stride_by_stride():
    pytest.importorskip("flint")
    from tdmf_slip.proof.prove_attraction import Attraction

    proof = Attraction(proved=True, values={}, radius=1e-3, rate=0.5, norm_radius=2e-3)
    (axes,) = tdmf_slip.plot(proof).axes
    strides, bound = axes.lines[0].get_data()
    assert np.allclose(bound, 2e-3 * 0.5**strides) and axes.get_xlabel() == "strides"
    with pytest.raises(tdmf_slip.InputError, match="the attraction is undecided, the word"):
        tdmf_slip.plot(Attraction(proved=False, values={}, undecided="the word"))


def test_a_validation_shows_each_value_beside_what_is_allowed():
    drifts = [
        Drift(0.6, "period", 1.0, 1.0, 0.0, 1e-6, "clamp"),
        Drift(0.6, "speed", 1.0, 1.1, 1e-5, 1e-6, "clamp"),
        Drift(0.6, "word", "+0+", "+0+", 0.0, 0.0, "clamp"),
        Drift(math.nan, "fold", 1.0, 1.0, 1e-9, 1e-6),
    ]
    plt.close("all")
    figure = tdmf_slip.plot(tdmf_slip.Validation({}, [], drifts))
    assert not plt.get_fignums()  # else a notebook shows it twice
    (axes,) = figure.axes
    assert sorted(line(axes, "as recorded: 3 values")[0]) == pytest.approx([1e-6, 1e-6, 1e-3])
    assert line(axes, "differs: 1 value")[0] == pytest.approx([10.0])
    assert [text.get_text() for text in axes.get_yticklabels()] == ["0.6, clamp", "of no single gait"]
    assert "allowed" in axes.get_xlabel()


def test_pyplot_keeps_a_figure_only_where_it_has_windows(monkeypatch):
    """A script's `pyplot.show()` opens the figure, and a notebook shows it once."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    gait = tdmf_slip.find_gait(friction=0.43)
    for framework, kept in ((None, False), ("tk", True)):
        monkeypatch.setattr(FigureCanvasAgg, "required_interactive_framework", framework)
        plt.close("all")
        figure = gait.plot()
        assert bool(plt.get_fignums()) == kept
        figure.savefig(io.BytesIO())
    plt.close("all")


def test_the_command_draws_a_gait_and_says_where_the_picture_is(command, tmp_path):
    status, out, said = command("gait", "--friction", "0.43", "--plot")
    assert status == 0 and out.startswith("word") and said == f"picture: {tmp_path / 'gait.png'}\n"
    assert plt.imread(tmp_path / "gait.png").std() > 0.05
    status, out, _ = command("gait", "--friction", "0.43", "--plot", "my.svg", "--json")
    assert status == 0 and json.loads(out)["word"] == "+0-" and (tmp_path / "my.svg").is_file()
