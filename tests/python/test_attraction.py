"""Volumes and robustness: estimates that can be checked by other means."""

import dataclasses
import math
import types

import numpy as np
import pytest
from tdmf_slip import Batch, InputError, Runner, find_gait
from tdmf_slip.analysis import attraction, ball, basin
from tdmf_slip.library import engine
from tdmf_slip.library.section import COORDINATES
from tdmf_slip.variables.parameters import read_parameters


@pytest.fixture(scope="module")
def gait():
    return basin.stable_gait(Runner({"ground.friction": 1.2}))


def settles(gait, apex):
    """The native solver tells whether an apex settles, one runner at a time."""
    return Batch(gait.runner, apex).run(400, gait).fate == engine.SETTLED


def test_the_largest_disturbances_are_where_recovery_ends(gait):
    """At what is told the native solver recovers, at the next try it does not: gaps may be 5e-5 wide."""
    found = attraction.robustness(gait)
    apart = attraction.FARTHEST / attraction.COARSE**attraction.REFINEMENTS
    pushes = (found.push_forward, 1.0), (found.push_backward, -1.0)
    steps = (found.step_down, 1.0), (found.step_up, -1.0)
    for axis, ends in (("com_speed", pushes), ("com_height", steps)):
        for disturbance, direction in ends:
            tries = (disturbance, True), (disturbance + apart, False)
            if math.isinf(disturbance):  # all that was tried
                assert (axis, direction) == ("com_speed", -1.0)
                tries = ((attraction.FARTHEST, True),)
            for distance, recovers in tries:
                apex = gait.apex.copy()
                apex[COORDINATES.index(axis)] += direction * distance
                assert settles(gait, apex) == recovers
    expected = {"push_forward": 1.0, "push_backward": None, "step_down": 2.0, "step_up": 3.0}
    assert attraction.Robustness(1.0, math.inf, 2.0, 3.0).as_json() == expected


def test_starts_that_the_solver_does_not_get_through_are_counted(gait):
    stiff = Runner({**gait.runner, "foot.mass": 1e-12, "hip.kp": 1e18, "hip.kd": 1e18})
    found = attraction.volume(dataclasses.replace(gait, runner=stiff), 20)
    assert (found.settled, found.unsolved) == (0, found.as_json()["unsolved"])
    assert 0 < found.unsolved <= 20


def test_the_interval_of_a_volume_is_wilsons():
    """Newcombe (1998), table I: 81 of 263, and 0 of 20."""
    assert attraction.Volume(263, 81, 1.0).interval == pytest.approx((0.2553, 0.3662), abs=5e-5)
    assert attraction.Volume(20, 0, 1.0).interval == pytest.approx((0.0, 0.1611), abs=5e-5)


def test_a_volume_depends_on_its_seed_alone(gait):
    one = attraction.volume(gait, 5000)
    other = attraction.volume(gait, 5000, seed=1)
    assert other != one
    assert abs(other.share - one.share) < 3.0 * (one.interval[1] - one.interval[0])
    with pytest.raises(InputError, match="samples = 0"):
        attraction.volume(gait, 0)


def test_a_volume_is_a_share_of_the_box(gait):
    found = attraction.volume(gait, 2 * ball.STARTS_AT_ONCE)
    low, high = np.array(list(attraction.BOX.values())).T
    drawings = [attraction.Drawing(gait.runner, tuple(gait.apex), 0, n, 4096).starts() for n in range(2)]
    assert np.min(np.abs(drawings[0] - drawings[1])) > 0.0
    ends = ball.fates(gait.runner, gait.apex, np.concatenate(drawings))
    assert found.settled == np.count_nonzero(ends["fate"] == engine.SETTLED)
    assert found.as_json()["volume"] == pytest.approx(found.settled / 8192 * np.prod(high - low))
    assert found.volume[1] < found.volume[0] < found.volume[2]


def test_one_measure_for_each_gait_in_their_order(gait, monkeypatch):
    monkeypatch.setattr(attraction, "SAMPLES", 200)
    other = basin.stable_gait(Runner({"ground.friction": 0.6}))
    found = attraction.measure_all([other, gait])
    assert [measured.friction for measured in found] == [0.6, 1.2]
    assert [measured.word for measured in found] == [other.word, gait.word]
    assert found[1].lambda_max == pytest.approx(np.max(np.abs(np.linalg.eigvals(gait.jacobian))))
    assert found[0].volume.samples == 200 and found[1].robustness == attraction.robustness(gait)


def test_disturbances_and_starts_are_measured_by_the_runner(gait, monkeypatch):
    """A human's leg is no unit of length, nor its speed one of speed."""
    human = Runner(read_parameters("human"))
    drawn = [attraction.Drawing(r, (0.0,) * 6, 0, 0, 50).starts() / r.scales for r in (human, gait.runner)]
    np.testing.assert_allclose(*drawn, rtol=1e-12)
    tried = []

    def all_recover(_runner, _apex, starts, **_):
        tried.append(starts)
        return types.SimpleNamespace(fate=np.zeros(len(starts)))

    monkeypatch.setattr(attraction, "fates", all_recover)
    found = attraction.robustness(find_gait(human))
    assert found == attraction.Robustness(*[math.inf] * 4)
    apex = find_gait(human).apex
    ends = np.array([starts[-1] - apex for starts in tried]) / human.scales
    np.testing.assert_allclose(ends[:, :2], [[0, 5], [0, -5], [5, 0], [-5, 0]], atol=1e-9)


def test_starts_fill_the_box(gait):
    starts = attraction.Drawing(Runner(gait.runner), tuple(gait.apex), 0, 0, 4000).starts()
    low, high = np.array(list(attraction.BOX.values())).T
    assert (starts.min(axis=0) >= low).all() and (starts.max(axis=0) <= high).all()
    np.testing.assert_allclose(starts.mean(axis=0), (low + high) / 2, atol=0.03 * (high - low).max())
