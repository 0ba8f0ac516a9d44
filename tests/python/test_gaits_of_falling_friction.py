"""Gaits under a friction that falls with speed, over where it falls: what is kept, limits, and the fold."""

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.paper.figures import falling_friction
from tdmf_slip.paper.figures.data import stored
from tdmf_slip.paper.figures.falling_friction import DOWNHILL, LEVEL, RATIOS, branch_of, runner_of

FAST = [2.2, 1.434, 1.006, 1.2, 0.0, 0.27]
"""The apex of the gait that never rests is near."""


@pytest.fixture(scope="module")
def data():
    return stored("falling_friction")


@pytest.fixture(scope="module")
def downhill():
    """Runner on a slope of -3 degrees, where two gaits were found side by side."""
    return runner_of(tdmf_slip.Runner({}), DOWNHILL, 1.5, 0.1)


@pytest.mark.parametrize("ratio", RATIOS[LEVEL])
def test_the_branch_leads_from_the_jump_to_the_static_friction(data, ratio):
    """The branch begins at v = 0, where friction jumps, and tends to friction rho mu as v grows.

    One gait of the branch is found anew.
    """
    its = branch_of(data, LEVEL, ratio)
    mu = falling_friction.FRICTIONS[LEVEL]
    jump = tdmf_slip.find_gait({"ground.friction": mu, falling_friction.RATIO: ratio}).speed
    static = tdmf_slip.find_gait({"ground.friction": mu * ratio}).speed
    speed, velocity = its["speed"], its["stribeck_velocity"]
    ends = [abs(speed[np.argmin(np.abs(velocity - at))] - static) for at in (1.0, 10.0)]
    assert ends[1] < 0.25 * ends[0]
    assert velocity[0] == 1e-3 and abs(speed[0] - jump) < velocity[0] * np.log(1.0 / velocity[0])
    row = np.flatnonzero(its["special"] == "")[90]
    gait = tdmf_slip.find_gait(runner_of(tdmf_slip.Runner({}), LEVEL, ratio, velocity[row]))
    assert (gait.word, gait.stable) == (its["word"][row], its["stable"][row])
    assert gait.speed == pytest.approx(speed[row], rel=1e-7)


def test_downhill_the_branch_turns_where_the_foot_begins_to_rest(data):
    """Stable gaits end at the least velocity. Unstable ones, whose foot never rests, begin there."""
    for ratio in RATIOS[DOWNHILL]:
        its = branch_of(data, DOWNHILL, ratio)
        (fold,) = np.flatnonzero(its["special"] == "fold")
        velocity = its["stribeck_velocity"]
        assert velocity[fold] == pytest.approx(velocity.min(), rel=1e-9)
        below, beyond = np.arange(fold), np.arange(fold + 1, len(velocity))
        assert np.all(its["stable"][below[its["word"][below] == "+-"]] == 1.0)
        assert np.all(its["word"][beyond] == "+") and not its["stable"][beyond].any()
        assert np.all(its["speed"][beyond] > its["speed"][fold])


def test_the_unstable_gait_parts_runners_that_settle_from_runners_that_run_away(downhill):
    """Runners start along the one unstable direction, on the slower and on the faster side."""
    slow, fast = tdmf_slip.find_gait(downhill), gait_near(downhill, FAST)
    assert (slow.word, slow.stable, fast.word, fast.unstable) == ("+-", True, "+", 1)
    values, vectors = np.linalg.eig(fast.jacobian)
    away = vectors[:, np.argmax(np.abs(values))].real
    away *= 0.01 * np.sign(away[1])
    run = tdmf_slip.stride_map(downhill, [fast.apex - away, fast.apex + away], strides=1500)
    speed = run["next_apex"].values[:, :, 1]
    assert np.all(np.diff(speed[1]) > 0.0) and speed[1, -1] > 1.6
    assert run["next_apex"].values[0, -1] == pytest.approx(slow.apex, abs=1e-7)
    growth = (speed[1, 50] - fast.apex[1]) / (speed[1, 0] - fast.apex[1])
    assert growth == pytest.approx(fast.lambda_max**50, rel=0.02)


def test_below_the_fold_no_gait_is_left_and_the_runner_runs_away(data, downhill):
    """A runner above the fold, from the same start, settles."""
    its = branch_of(data, DOWNHILL, 1.5)
    fold = its["stribeck_velocity"].min()
    near = runner_of(downhill, DOWNHILL, 1.5, 1.2 * fold)
    gait = gait_near(near, tdmf_slip.find_gait(downhill).apex)
    ends = tdmf_slip.stride_map(
        {**near, "ground.stribeck_velocity": np.array([0.8, 1.2]) * fold},
        gait.apex,
        strides=2000,
    )["next_apex"].values[:, :, 1]
    assert ends[1, -1] == pytest.approx(gait.apex[1], abs=1e-8)
    assert ends[0, -1] > 1.1 * gait.apex[1] and np.all(np.diff(ends[0, -100:]) > 0.0)
