"""Data of figures that take minutes, as they are kept: some of it computed anew."""

import numpy as np
import pytest
from tdmf_slip import Runner, find_orbit, strides_to_fall
from tdmf_slip.paper.figures import rough, slope, stored, thrust


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


def test_gaits_of_each_actuation_are_what_is_kept():
    data = stored.columns("thrust")
    compared = 0
    for friction in thrust.FRICTIONS:
        for chosen in thrust.actuated(data).values():
            places = np.flatnonzero(chosen & (data["friction"] == friction) & (data["stable"] > 0.0))
            for place in places[len(places) // 2 :][:1]:
                torque, thrusts = (data[name][place] for name in ("hip_torque", "thrust"))
                start = {"ground.friction": friction, thrust.TORQUE: torque, thrust.THRUST: thrusts}
                stride = find_orbit(Runner.of(start)).stride
                slip = stride["slip_distance"] / stride["length"]
                assert slip == pytest.approx(data["slip_per_length"][place], rel=1e-7, abs=1e-12)
                for name in ("speed", "cost_of_transport"):
                    assert stride[name] == pytest.approx(data[name][place], rel=1e-7)
                compared += 1
    assert compared == 7


def test_figures_are_drawn_of_what_is_kept(command):
    for name in ("rough", "slope", "thrust"):
        assert command("figures", "--only", name, "--output", "made")[0] == 0
