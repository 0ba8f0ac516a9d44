"""Data of figures that take minutes, as they are kept: some of it computed anew."""

import numpy as np
import pytest
from tdmf_slip import Runner, find_orbit, strides_to_fall
from tdmf_slip.paper.figures import rough, slope, stored


def test_a_mean_on_rough_ground_is_what_is_kept():
    data = stored.columns("rough")
    (place,) = np.flatnonzero((data["roughness"] == 0.5) & (data["friction"] == 1.2))
    found = strides_to_fall(
        {"ground.friction": 1.2}, 0.5, rough.RUNNERS, rough.SEED, rough.MOST_STRIDES, workers=1
    )
    assert found.mean_strides == pytest.approx(data["mean_strides"][place], rel=0.05)


def test_gaits_on_slopes_are_what_is_kept():
    data = stored.columns("slope")
    for friction in slope.COLOURS:
        place = np.flatnonzero(data["friction"] == friction)[0]
        angle = np.radians(data["slope_degrees"][place])
        gait = find_orbit(Runner.of({"ground.friction": friction, "ground.slope": angle}))
        for name in ("speed", "cost_of_transport"):
            assert gait.stride[name] == pytest.approx(data[name][place], rel=1e-7)


def test_figures_are_drawn_of_what_is_kept(command):
    for name in ("rough", "slope"):
        assert command("figures", "--only", name, "--output", "made")[0] == 0
