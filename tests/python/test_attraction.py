"""Volumes and robustness: estimates that can be checked by other means."""

import dataclasses
import math

import numpy as np
import pytest
from tdmf_slip import Batch, InputError, Runner, find_gait
from tdmf_slip.analysis import attraction, ball
from tdmf_slip.library import engine
from tdmf_slip.library.section import COORDINATES


@pytest.fixture(scope="module")
def gait():
    return find_gait({"ground.friction": 1.2})


def test_the_largest_disturbances_are_where_recovery_ends(gait, monkeypatch):
    """The native solver recovers at the reported disturbance and not at the next larger one."""
    monkeypatch.setattr(attraction, "COARSE", 50)
    found = attraction.robustness(gait)
    apart = attraction.FARTHEST / attraction.COARSE**attraction.REFINEMENTS
    compared = 0
    for name, distance in dataclasses.asdict(found).items():
        tries = ((distance, True), (distance + apart, False))
        if math.isinf(distance):  # all that was tried
            assert name == "push_backward"
            tries = ((attraction.FARTHEST, True),)
        for size, recovers in tries:
            apex = gait.apex.copy()
            direction = -1.0 if name in ("push_backward", "step_up") else 1.0
            apex[COORDINATES.index(attraction.DISTURBED[name])] += direction * size
            assert (Batch(gait.runner, apex).run(400, gait).fate == engine.SETTLED) == recovers, name
            compared += 1
    assert compared == 7
    expected = {"push_forward": 1.0, "push_backward": None, "step_down": 2.0, "step_up": 3.0}
    assert attraction.Robustness(1.0, math.inf, 2.0, 3.0).as_json() == expected


def test_starts_that_the_solver_does_not_get_through_are_counted(gait):
    stiff = Runner({**gait.runner, "foot.mass": 1e-12, "hip.kp": 1e18, "hip.kd": 1e18})
    found = attraction.attraction_volume(dataclasses.replace(gait, runner=stiff), 20)
    assert (found.settled, found.unsolved) == (0, found.as_json()["unsolved"])
    assert 0 < found.unsolved <= 20


def test_the_interval_of_a_volume_is_wilsons():
    """Newcombe (1998), table I: 81 of 263, and 0 of 20."""
    assert attraction.Volume(263, 81, 1.0).interval == pytest.approx((0.2553, 0.3662), abs=5e-5)
    assert attraction.Volume(20, 0, 1.0).interval == pytest.approx((0.0, 0.1611), abs=5e-5)


def test_a_volume_is_a_share_of_the_box_and_depends_on_its_seed_alone(gait, monkeypatch):
    monkeypatch.setattr(attraction, "STARTS_AT_ONCE", 256)
    found = attraction.attraction_volume(gait, 512)
    low, high = np.array(list(attraction.BOX.values())).T
    drawn = [attraction.starts_in_box(gait.runner, 0, number, 256) for number in range(2)]
    assert np.min(np.abs(drawn[0] - drawn[1])) > 0.0
    ends = ball.fates(gait, np.concatenate(drawn))
    assert found.settled == np.count_nonzero(ends["fate"] == engine.SETTLED)
    assert found.as_json()["volume"] == pytest.approx(found.settled / 512 * np.prod(high - low))
    assert found.volume[1] < found.volume[0] < found.volume[2]
    other = attraction.attraction_volume(gait, 512, seed=1)
    assert other != found == attraction.attraction_volume(gait, 512)
    assert abs(other.share - found.share) < 3.0 * (found.interval[1] - found.interval[0])
    with pytest.raises(InputError, match="samples = 0"):
        attraction.attraction_volume(gait, 0)


def test_starts_fill_the_box_over_the_runners_own_scales(gait):
    """A human's leg is no unit of length, nor its speed one of speed."""
    runners = Runner("human"), gait.runner
    human, paper = (attraction.starts_in_box(of, 0, 0, 4000) / of.scales for of in runners)
    np.testing.assert_allclose(human, paper, rtol=1e-12)
    low, high = np.array(list(attraction.BOX.values())).T
    assert (paper.min(axis=0) >= low).all() and (paper.max(axis=0) <= high).all()
    np.testing.assert_allclose(paper.mean(axis=0), (low + high) / 2, atol=0.03 * (high - low).max())
