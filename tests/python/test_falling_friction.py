"""Friction that falls with the foot's speed, in the limits in which it is another law."""

import numpy as np
import pytest
import tdmf_slip

SLOW = 10.0 ** np.array([-4.0, -5.0, -6.0])
FAST = 10.0 ** np.array([5.0, 6.0, 7.0])


def end_of_stride(runner, apex, velocities=0.0):
    """Where one stride leads, at each velocity at which the friction falls."""
    made = tdmf_slip.stride_map(
        runner | {"ground.stribeck_velocity": np.atleast_1d(velocities)}, apex, tolerance=1e-13
    )
    assert (made["fate"] == 0).all()
    return made["word"].values[:, 0].tolist(), made["next_apex"].values[:, 0]


def runner_and_apex(friction, ratio):
    runner = {"ground.friction": friction, "ground.static_friction_ratio": ratio}
    return runner, tdmf_slip.find_gait(runner).apex


@pytest.mark.parametrize(("friction", "ratio"), [(0.3, 2.0), (0.2, 1.5)])
def test_friction_that_falls_at_once_is_static_and_sliding_friction(friction, ratio):
    """The distance goes to 0 as v ln(1/v): so long the foot lingers in the layer when its slip begins."""
    runner, apex = runner_and_apex(friction, ratio)
    (word,), at_once = end_of_stride(runner, apex)
    words, ends = end_of_stride(runner, apex, SLOW)
    assert words == [word] * 3 == ["+0-"] * 3
    distance = np.abs(ends - at_once).max(axis=1) / SLOW
    steps = np.diff(distance) / np.diff(np.log(1.0 / SLOW))
    assert steps[1] == pytest.approx(steps[0], rel=0.03) and steps[0] > 0.1


def test_where_the_foot_slips_twice_the_limit_is_reached_too():
    """More slowly than v ln(1/v), by four fifths of the velocity's power at the least."""
    runner, apex = runner_and_apex(0.6, 1.5)
    (word,), at_once = end_of_stride(runner, apex)
    words, ends = end_of_stride(runner, apex, SLOW)
    assert words == [word] * 3 == ["+0-0+"] * 3
    distance = np.abs(ends - at_once).max(axis=1)
    assert np.all(np.diff(np.log(distance)) / np.diff(np.log(SLOW)) > 0.8) and distance[-1] < 1e-5


@pytest.mark.parametrize(("friction", "ratio"), [(0.6, 1.5), (0.3, 2.0), (0.2, 1.5)])
def test_friction_that_hardly_falls_is_the_static_one(friction, ratio):
    """The distance goes to 0 as 1/v."""
    runner, apex = runner_and_apex(friction, ratio)
    _, static = end_of_stride({"ground.friction": friction * ratio}, apex)
    _, ends = end_of_stride(runner, apex, FAST)
    distance = np.abs(ends - static).max(axis=1) * FAST
    assert distance == pytest.approx(distance[0], rel=1e-3) and distance[0] > 0.01
