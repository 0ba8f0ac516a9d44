"""Ground whose steps hang together, that trips, and whose friction is drawn: against the same, given."""

import numpy as np
import pytest
from tdmf_slip import Batch, stride_map
from tdmf_slip.library.engine import FATES
from tdmf_slip.library.ground import RoughGround, correlated_weights, spectrum_weights

RUNNERS, STRIDES = 24, 5
FELL = FATES.index("fell")


def runs(gait, ground, runners=RUNNERS, strides=STRIDES, **how):
    starts = np.tile(gait.apex, (runners, 1))
    return Batch(gait.runner, starts, ground, **how).run(strides)


def given(gait, name, values, first_steps=0.0):
    """Strides with given inputs. Their ground has no step at the start, so the apex is lower instead."""
    starts = np.tile(gait.apex, (RUNNERS, 1))
    starts[:, 0] -= first_steps
    return stride_map(gait.runner, starts, strides=STRIDES, inputs={name: values})


def same_apices(ends, data):
    """Checks the last apices of runners that made all strides."""
    up = ends["strides"] == STRIDES
    assert np.count_nonzero(up) > RUNNERS // 2
    last = data["next_apex"].values[:, -1]
    assert ends["apex"][up] == pytest.approx(last[up], abs=1e-6)


def test_steps_that_hang_together_are_those_given(gait):
    ground = RoughGround(0.1, 7, step_weights=correlated_weights(0.7))
    steps = np.array([ground.steps(k, STRIDES) for k in range(RUNNERS)])
    heights = np.cumsum(steps, axis=1)
    same_apices(runs(gait, ground, tolerance=1e-11), given(gait, "ground.height", heights, steps[:, 0]))


def test_friction_by_stride_is_that_given(gait):
    ground = RoughGround(0.0, 7, friction_spread=0.3, friction_weights=correlated_weights(0.5))
    frictions = 0.6 * np.array([ground.frictions(k, STRIDES) for k in range(RUNNERS)])
    assert frictions.std() > 0.1
    same_apices(runs(gait, ground, tolerance=1e-11), given(gait, "ground.friction", frictions))


@pytest.mark.parametrize("correlation", [-0.6, 0.3, 0.9])
def test_a_correlation_is_what_it_is_called(correlation):
    ground = RoughGround(0.2, 5, step_weights=correlated_weights(correlation))
    steps = np.concatenate([ground.steps(k, 4000) for k in range(4)])
    assert steps.std() == pytest.approx(0.2, rel=0.1)
    for lag in (1, 2):
        estimate = np.corrcoef(steps[:-lag], steps[lag:])[0, 1]
        assert estimate == pytest.approx(correlation**lag, abs=0.05)


def test_a_spectrum_is_that_of_the_steps():
    frequencies = np.linspace(0.0, 0.5, 33)
    density = 1.0 / (0.05 + frequencies) ** 2
    steps = RoughGround(1.0, 2, step_weights=spectrum_weights(density)).steps(0, 32_500).reshape(-1, 65)
    found = (np.abs(np.fft.rfft(steps, axis=1)) ** 2).mean(axis=0)[1:]
    wanted = np.interp(np.fft.rfftfreq(65)[1:], frequencies, density)
    ratio = (found / found.sum()) / (wanted / wanted.sum())
    assert np.all(np.abs(np.log(ratio[:20])) < 0.6)


def test_who_trips_falls_at_the_step(gait):
    """A runner trips exactly if its first step is higher than its foot, which passes it by default."""
    clearance = gait.stride["foot_clearance"]
    plain, trips = RoughGround(0.6, 4), RoughGround(0.6, 4, trips=True)
    first = np.array([plain.steps(k, 1)[0] for k in range(400)])
    fell = runs(gait, trips, 400, 1)["fate"] == FELL
    assert np.array_equal(fell, first > clearance) and 5 < np.count_nonzero(fell) < 200
    assert np.count_nonzero(runs(gait, plain, 400, 1)["fate"] == FELL) < np.count_nonzero(fell)
