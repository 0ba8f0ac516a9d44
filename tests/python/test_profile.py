"""Uneven ground: its geometry, what is refused, and runs over it."""

import math

import numpy as np
import pytest
from conftest import unit_reference
from tdmf_slip import Profile
from tdmf_slip.fmu.simulation import run_unit


def test_a_profile_has_the_height_of_its_lines():
    profile = Profile([0.0, 10.0, 10.0, 30.0], [0.0, 1.0, 2.0, -2.0])
    positions = np.array([-5.0, 0.0, 5.0, 9.999999, 10.0, 20.0, 30.0, 99.0])
    assert profile.height(positions) == pytest.approx([0.0, 0.0, 0.5, 1.0, 2.0, 0.0, -2.0, -2.0], abs=1e-6)
    line = profile.line(20.0)
    assert math.tan(line.slope) == pytest.approx(-0.2) and line.height == pytest.approx(4.0)
    assert profile.steepest == pytest.approx(math.atan(-0.2))


def test_steps_have_a_riser_at_each_edge():
    profile = Profile.steps([1.0, 2.0, 4.0], [0.0, 0.1, -0.2, 0.3])
    heights = profile.height([0.5, 1.0, 1.99, 2.0, 3.9, 4.0, 5.0])
    assert list(heights) == [0.0, 0.1, 0.1, -0.2, -0.2, 0.3, 0.3]
    assert profile.steepest == 0.0


def test_random_steps_are_those_of_their_seed():
    one, same, other = (Profile.random_steps(5000, 2.0, 0.1, seed, begin=3.0) for seed in (7, 7, 8))
    assert np.all(one.y == same.y) and np.any(one.y != other.y)
    risers = np.diff(one.y)[::2]
    assert len(risers) == 5000 and one.x[0] == 3.0 and one.x[-1] == 3.0 + 2.0 * 4999
    assert abs(np.mean(risers)) < 4 * 0.1 / math.sqrt(5000) and np.std(risers) == pytest.approx(0.1, rel=0.04)


def test_level_ground_is_the_ground_of_the_gait():
    run = run_unit(strides=2, profile=Profile([0.0], [0.0]), variables=["foot.y"])
    assert run.strides == 2 and run.stride["period"] == pytest.approx(unit_reference()["period"])
    assert not run.fallen and run.table["foot.y"].min() >= 0.0 and run.names == ("time", "foot.y")


def test_each_stance_is_on_the_line_that_was_below_the_foot():
    """Stances near an edge are left out: a communication point may come too late for them."""
    step, profile = 0.05, Profile.random_steps(12, 7.0, 0.05, seed=3, begin=20.0)
    variables = ["foot.x", "foot.y", "foot.vx", "contact.normal", "com.x"]
    run = run_unit(strides=4, profile=profile, output_interval=step, variables=variables)
    rows = run.table
    standing = rows[rows["contact.normal"] > 0]
    assert run.strides == 4 and len(standing) > 60
    away = np.min(np.abs(standing["foot.x"][:, None] - profile.x), axis=1) > 0.3
    assert np.sum(away) > 40
    assert standing["foot.y"][away] == pytest.approx(profile.height(standing["foot.x"][away]), abs=1e-12)
    assert np.ptp(standing["foot.y"]) > 0.05


def test_a_gait_climbs_a_slope_as_a_line():
    """A profile that is one line is the line that the unit can be given itself."""
    slope = 0.01
    profile = Profile([-1e3, 1e3], [-1e3 * math.tan(slope), 1e3 * math.tan(slope)])
    over = run_unit(strides=3, profile=profile)
    run = run_unit({"ground.slope": slope}, strides=3, interface="cs", output_interval=0.05)
    assert over.stride["rise"] > 0.2
    for name in ("speed", "rise"):
        assert over.stride[name] == pytest.approx(run.stride[name], rel=1e-8), name
