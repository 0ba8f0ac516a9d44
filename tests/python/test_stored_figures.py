"""Stored data of figures, some of it computed anew, and the pictures of the documentation."""

import re

import numpy as np
import pytest
from conftest import ROOT, some_of
from matplotlib.backends.backend_agg import FigureCanvasAgg
from tdmf_slip import Runner, compare, find_gait, gait_at, strides_to_fall
from tdmf_slip import viability as find_viable
from tdmf_slip.library.quantities import quantities_of
from tdmf_slip.paper.figures import catalogue, optimal, rough, slippery_patch, thrust, viability
from tdmf_slip.paper.figures.data import stored
from tdmf_slip.paper.matched import HOLD, VARY
from tdmf_slip.pictures import style
from tdmf_slip.pictures.style import CurveLabel

FRICTION, TORQUE, THRUST, ANGLE = "ground.friction", thrust.TORQUE, thrust.THRUST, thrust.ANGLE
RUNNERS = {
    "slope": {"friction": FRICTION, "slope_degrees": "ground.slope"},
    "thrust": {"friction": FRICTION, "stance_torque": TORQUE, "thrust": THRUST, "touchdown_angle": ANGLE},
    "optimal": {"friction": FRICTION, "stance_torque": TORQUE, "thrust": THRUST, "touchdown_angle": ANGLE},
}
"""Columns of a figure's data with the runner's values, by figure."""


def gait_of(figure, data, row):
    """The gait of a row, found anew."""
    values = {name: float(data[column][row]) for column, name in RUNNERS[figure].items()}
    if "ground.slope" in values:
        values["ground.slope"] = np.radians(values["ground.slope"])
    return find_gait(Runner(values))


@pytest.mark.parametrize("figure", RUNNERS)
def test_gaits_of_a_figure_are_what_is_kept(figure):
    data = stored(figure)
    data = data[data["stable"]] if "stable" in data else data
    rows = [data.index[data["friction"] == mu][0] for mu in sorted(set(data["friction"]))[-3:]]
    for row in rows:
        stride = gait_of(figure, data, row).stride
        for name in ("speed", "cost_of_transport"):
            assert stride[name] == pytest.approx(data[name][row], rel=1e-6), row


def test_matched_runners_on_rough_ground_are_what_is_kept():
    """Runners matched to the kinematics of friction 0.2 stay up longer with less friction."""
    data = stored("rough")
    data = data[data["matched"]]
    friction, low, high = data["friction"], data["mean_strides_low"], data["mean_strides_high"]
    assert tuple(friction) == rough.FRICTIONS
    assert np.all(high[friction >= 2.5] < 140.0) and np.all(low[friction <= 0.3] > 450.0)
    runners = compare([{FRICTION: mu} for mu in (rough.REFERENCE, 10.0)], hold=HOLD, vary=VARY)
    runner = gait_at(runners.sel(runner=1, step="after")).runner
    found = strides_to_fall(runner, rough.MATCHED_ROUGHNESS, rough.RUNNERS, rough.SEED, rough.MAX_STRIDES)
    (kept,) = data["mean_strides"][friction == 10.0]
    assert found.mean_strides == pytest.approx(kept, rel=0.1)


def test_patches_cause_falls_downhill_on_grippy_ground():
    """Some points are measured again; the guide's numbers are those of all points."""
    data = stored("slippery_patch")
    assert len(data) == 5 * 11 * 14
    first = {mu: slippery_patch.shortest(data, mu, matched=False) for mu in (10.0, 1.2, 0.6)}
    assert [round(first[friction][2]) for friction in (10.0, 1.2)] == [251, 1002]
    assert first[0.6][2] == np.inf and np.all(first[10.0] <= first[1.2])
    for gait, matched in slippery_patch.gaits(catalogue.results()):
        rows = (data["matched"] == matched) & (data["friction"] == gait.friction)
        for row in np.flatnonzero(rows)[[3, 60, 100]]:
            friction, length = data["patch_friction"][row], data["length"][row]
            assert slippery_patch.falls(gait, friction, length) == data["falls"][row]


def test_viable_shares_of_matched_runners_are_what_is_kept():
    """Viable set of one runner, computed anew."""
    data = stored("viability")
    assert tuple(data["friction"]) == viability.FRICTIONS
    for what in ("share", "robustness"):
        assert (data[f"inner_{what}"] <= data[f"outer_{what}"]).all()
    (row,) = np.flatnonzero(data["friction"] == 1.2)
    values = {FRICTION: 1.2, **{name: data[name][row] for name in viability.VARY}}
    gait, reference = (find_gait(of, model="reduced") for of in (values, {FRICTION: viability.REFERENCE}))
    for name in viability.HOLD:
        (value,), (wanted,) = (quantities_of(of, [name]).values() for of in (gait, reference))
        assert value == pytest.approx(wanted, rel=1e-6)
    found = find_viable(values, axes=viability.VIABLE_PLANE, vary=viability.CHOSEN, n=viability.CELLS)
    assert found.inner_share == pytest.approx(data["inner_share"][row], abs=1e-3)
    assert float(found["outer_robustness"].mean()) == pytest.approx(data["outer_robustness"][row], abs=1e-3)


def test_the_search_finds_no_better_runners_than_those_kept_and_the_cheapest_slips_on_purpose():
    data = stored("optimal")
    costs, slips = {}, {}
    for row in np.flatnonzero((data["friction"] > 0.58) & (data["friction"] < 0.6)):
        gait = gait_of("optimal", data, row)
        objective = optimal.CHEAPEST if data["cheapest"][row] else optimal.MIN_SLIP
        (again,) = optimal.best(gait.runner, objective, [])
        assert again.why == ""
        for name in ("speed", "cost_of_transport", "slip_distance"):
            assert again.gait.stride[name] == pytest.approx(data[name][row], rel=1e-4)
        costs[objective], slips[objective] = (data[of][row] for of in ("cost_of_transport", "slip_distance"))
    assert costs[optimal.CHEAPEST] < costs[optimal.MIN_SLIP]
    assert slips[optimal.CHEAPEST] > 1.5 * slips[optimal.MIN_SLIP]


def _crosses_a_line(label, renderer):
    box = label.box_of_word(renderer)
    paths = (line.get_transform().transform_path(line.get_path()) for line in label.axes.lines)
    return any(path.cleaned(remove_nans=True).intersects_bbox(box, filled=False) for path in paths)


def test_figures_are_drawn_of_what_is_kept_with_legends_inside_and_words_beside_curves(command, monkeypatch):
    found, crossed = [], []
    save = style.save

    def look(figure, path, **how):
        renderer = FigureCanvasAgg(figure).get_renderer()
        figure.draw(renderer)
        legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes if axes.get_legend())]
        boxes = [legend.get_window_extent(renderer) for legend in legends]
        found.extend(box.x0 >= 0 and box.x1 <= figure.bbox.width for box in boxes)
        labels = [text for axes in figure.axes for text in axes.texts if isinstance(text, CurveLabel)]
        crossed.extend(_crosses_a_line(label, renderer) for label in labels)
        save(figure, path, **how)

    monkeypatch.setattr(style, "save", look)
    for name in some_of(["falling_friction", "feedback", "slippery_patch", "rough", "optimal", "thrust"], 2):
        assert command("figures", "--only", name, "--output", "made", "--format", "png")[0] == 0
    assert len(found) >= 2 and all(found)
    assert len(crossed) >= 10 and not any(crossed)


def test_each_picture_of_the_documentation_is_shown_and_is_remade_by_one_command(command):
    """`scripts/pictures` ends with an error where it has not made one; here it is not run."""
    said = command.refusal("figures", "--only", "?")
    figures = set(said.partition("allowed: ")[2].strip().split(", "))
    script = (ROOT / "scripts/pictures").read_text(encoding="utf-8")
    assert "tdmf-slip figures" in script
    others = set(re.findall(r"\$made/(\w+)\.(?:png|gif)", script))
    pages = [ROOT / "README.md", *(ROOT / "documentation").rglob("*.md")]
    text = "".join(page.read_text(encoding="utf-8") for page in pages)
    pictures = list((ROOT / "documentation/pictures").iterdir())
    assert len(pictures) >= 15
    for picture in pictures:
        assert picture.stem in figures | others, picture.name
        assert f"pictures/{picture.name}" in text, picture.name
