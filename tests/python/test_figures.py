"""Figures in other formats, widths and styles, and gaits as animations."""

import json
import re

import numpy as np
import pytest
from PIL import Image
from tdmf_slip import sweep
from tdmf_slip.paper.figures import catalogue, classic, over_friction
from tdmf_slip.pictures import animation, style

CENTIMETRE = 72 / 2.54
"""A page of PDF is measured in points."""


def test_figures_have_the_width_resolution_and_format_that_are_asked_for(command, tmp_path):
    options = ("--format", "pdf,png", "--width", "17", "--resolution", "100", "--style", "print")
    assert command("figures", "--only", "figure_4", "--output", "made", *options)[0] == 0
    assert {path.suffix for path in (tmp_path / "made").iterdir()} == {".pdf", ".png", ".csv"}
    with Image.open(tmp_path / "made/figure_4a.png") as picture:
        assert picture.width == pytest.approx(17 / 2.54 * 100, abs=1)
    page = (tmp_path / "made/figure_4a.pdf").read_bytes()
    (width,) = re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) [\d.]+ \]", page)
    assert float(width) == pytest.approx(17 * CENTIMETRE, abs=0.1)
    assert b"DejaVuSerif" in page and b"CreationDate" not in page
    assert command("figures", "--only", "figure_4a, figure_2b", "--output", "again", *options)[0] == 0
    assert {path.stem for path in (tmp_path / "again").iterdir()} == {"figure_4a", "figure_2b"}
    assert (tmp_path / "again/figure_4a.pdf").read_bytes() == page


def test_a_foot_that_swings_above_the_body_is_in_the_picture(command, tmp_path):
    options = ("--friction", "0.2", "--set", "ground.slope=1.5 deg", "--frames", "12")
    assert command("animate", "--output", "run.gif", *options)[0] == 0
    with Image.open(tmp_path / "run.gif") as film:
        for number in range(film.n_frames):
            film.seek(number)
            picture = film.convert("L")
            assert picture.crop((0, 0, picture.width, 10)).getextrema()[0] > 250, number


def test_what_the_papers_text_tells_is_marked_on_the_curves_or_off_them():
    """Two statements are off the curves: cost of transport at friction 0.5, and friction at the impact."""
    results = catalogue.results()
    results.sweep = sweep(results.runner, {"friction": [10.0, 1.2, 0.6, 0.5]})
    results.equal = results.sweep.gaits.isel({"ground.friction": slice(0)})
    kept = classic.draw_friction(results), over_friction.draw_figure_9(results)
    off = {}
    for axes in (axes for figure in kept for axes in figure.axes):
        marks = [line for line in axes.lines if line.get_label() == style.PUBLISHED["label"]]
        curves = [line.get_xydata() for line in axes.lines if line.get_linestyle() != "None"]
        rising = [curve[np.argsort(curve[:, 0])].T for curve in curves if len(curve) > 2]
        for x, value in (point for mark in marks for point in mark.get_xydata()):
            off[x, value] = min(abs(np.interp(x, *curve) / value - 1.0) for curve in rising)
    speed, cost = (results.gaits[name][0] for name in ("speed", "cost_of_transport"))
    assert list(off) == [
        (40.0, 0.84),
        (40.0, 4.5),
        pytest.approx((0.5, 1.12 * speed)),
        pytest.approx((0.5, 0.75 * cost)),
    ]
    assert list(off.values()) == pytest.approx([0.0, 0.1, 0.0, 0.055], abs=0.01)


def test_axes_tell_units_as_they_are_printed():
    shown = [style.with_unit("leg.damping", unit) for unit in ("N.s/m", "m/s2", "1", "")]
    assert shown == ["leg.damping (N·s/m)", "leg.damping (m/s²)", "leg.damping", "leg.damping"]


def test_a_page_has_its_frames_in_it_and_fetches_nothing(command, tmp_path):
    gait = command("gait", "--friction", "0.2", "--json")[1]
    assert json.loads(gait)["word"] == "+-"
    (tmp_path / "gait.json").write_text(gait)
    assert command("animate", "--output", "run.html", "--from-gait", "gait.json", "--frames", "12")[0] == 0
    page = (tmp_path / "run.html").read_text()
    assert len(re.findall(r'"iVBOR[\w+/=]+"', page)) == 12
    assert "//" not in re.sub(r'"iVBOR[\w+/=]+"', "", page)
    given = ("--from-gait", "gait.json", "--friction", "0.3")
    assert "--from-gait" in command.refusal("animate", "--output", "run.html", *given)


def test_without_ffmpeg_a_film_is_refused(command, monkeypatch):
    monkeypatch.setattr(animation.FFMpegWriter, "isAvailable", lambda: False)
    said = command.refusal("animate", "--output", "run.mp4")
    assert "ffmpeg is not installed" in said and ".gif" in said
