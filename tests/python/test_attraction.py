"""Volumes and robustness: estimates that can be checked by other means."""

import dataclasses
import math

import numpy as np
import pytest
from tdmf_slip import InputError, attraction, basin, ensemble
from tdmf_slip.orbit import Runner
from tdmf_slip.section import COORDINATES


@pytest.fixture(scope="module")
def gait(unit):
    return basin.stable_gait(Runner.of({"ground.friction": 1.2}, unit), unit)


def settles(gait, apex):
    """By the native solver, one runner at a time."""
    case = ensemble.Case(Runner(gait.runner.values), (gait.apex,))
    ends, _ = ensemble.run([case], np.array([apex]), most_strides=400, instructions="one by one", threads=1)
    return ends["fate"][0] == 0


def test_the_largest_disturbances_are_where_recovery_ends(gait):
    """Just short of the edge the native solver recovers, just beyond it does not."""
    found = attraction.robustness(gait)
    for axis, disturbance in (("com_speed", found.push_forward), ("com_height", found.step_down)):
        assert math.isfinite(disturbance)
        for distance, recovers in ((disturbance, True), (1.0001 * disturbance + 1e-4, False)):
            apex = gait.apex.copy()
            apex[COORDINATES.index(axis)] += distance
            assert settles(gait, apex) == recovers


def test_starts_that_the_solver_does_not_get_through_are_counted(gait):
    stiff = Runner({**gait.runner.values, "foot.mass": 1e-12, "hip.kp": 1e18, "hip.kd": 1e18})
    found = attraction.volume(dataclasses.replace(gait, runner=stiff), 20, workers=1)
    assert (found.settled, found.unsolved) == (0, found.as_json()["unsolved"])
    assert 0 < found.unsolved <= 20


def test_the_interval_of_a_volume_is_wilsons():
    """Newcombe (1998), table I: 81 of 263, and 0 of 20."""
    assert attraction.Volume(263, 81, 1.0).interval == pytest.approx((0.2553, 0.3662), abs=5e-5)
    assert attraction.Volume(20, 0, 1.0).interval == pytest.approx((0.0, 0.1611), abs=5e-5)


def test_a_volume_depends_on_its_seed_alone(gait):
    one = attraction.volume(gait, 5000, workers=1)
    assert attraction.volume(gait, 5000, workers=2) == one
    other = attraction.volume(gait, 5000, seed=1, workers=1)
    assert other != one
    assert abs(other.share - one.share) < 3.0 * (one.interval[1] - one.interval[0])
    with pytest.raises(InputError, match="samples = 0"):
        attraction.volume(gait, 0)


def test_starts_fill_the_box(gait):
    starts = attraction.Drawing(Runner(gait.runner.values), tuple(gait.apex), 0, 0, 4000).starts()
    low, high = np.array(list(attraction.BOX.values())).T
    assert (starts.min(axis=0) >= low).all() and (starts.max(axis=0) <= high).all()
    np.testing.assert_allclose(starts.mean(axis=0), (low + high) / 2, atol=0.03 * (high - low).max())
