"""Value of feedback in the ensemble: attraction, disturbances, and strides on rough ground."""

import dataclasses
import json

import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED
from tdmf_slip.analysis import attraction
from tdmf_slip.feedback import judgement
from tdmf_slip.paper.figures import feedback
from tdmf_slip.paper.figures.data import stored

ANGLE, TORQUE = feedback.ANGLE, feedback.TORQUE


@pytest.fixture(scope="module")
def gait():
    """The swing is clamped; with a free swing, feedback does not delay the falls of this runner."""
    return tdmf_slip.find_gait({"ground.friction": 1.0, **CLAMPED})


@pytest.fixture
def few(monkeypatch):
    """Shorten the runs."""
    monkeypatch.setattr(attraction, "COARSE", 50)
    monkeypatch.setattr(judgement, "SAMPLES", 60)
    monkeypatch.setattr(judgement, "RUNNERS", 48)
    monkeypatch.setattr(judgement, "MAX_STRIDES", 200)


def test_a_runner_with_feedback_stays_up_longer_and_without_as_it_is(gait, few):
    """Runs at friction 1 are about ten times longer; 48 runners show that up to a factor of 3."""
    law = feedback.laws(gait)["quadratic regulator: angle and torque"]
    noisy = dataclasses.replace(law, noise=feedback.NOISE * gait.runner.scales, seed=1)
    held, alone = (judgement.judge(gait, its, roughness=[0.3], seed=2) for its in (noisy, None))
    (held_on_rough,), (alone_on_rough,) = held.first_passages, alone.first_passages
    assert held_on_rough.mean_strides > 3 * alone_on_rough.mean_strides
    assert alone_on_rough == tdmf_slip.strides_to_fall(gait.runner, 0.3, 48, 2, 200, gait=gait)
    assert held.volume.samples == 60 and held.volume.share >= alone.volume.share
    assert held.robustness.step_up > 0.3 and held.robustness.step_down > alone.robustness.step_down


def test_regions_of_attraction_are_those_without_noise(gait, few):
    """Under noise, no runner settles closer to the gait than its noise lets it stray."""
    law = feedback.laws(gait)["quadratic regulator: angle and torque"]
    loud = dataclasses.replace(law, noise=gait.runner.scales)
    judged = judgement.judge(gait, loud)
    assert judged.volume == judgement.judge(gait, law).volume and judged.first_passages == ()
    assert judged.robustness.step_up > 0.3


def test_a_basin_under_a_feedback_keeps_the_law(gait):
    law = feedback.laws(gait)["dead-beat: angle and torque"]
    height, speed = gait.apex[:2]
    axes = {"com_height": (height, height + 0.1), "com_speed": (speed, speed + 0.1)}
    found = tdmf_slip.basin(gait.runner, axes, 2, law=law)
    assert (found["fate"] == 0).all()
    kept = json.loads(found.attrs["law"])
    assert kept["inputs"] == [ANGLE, TORQUE] and len(kept["eigenvalues"]) == 6


def test_what_is_kept_of_the_figure_is_what_is_measured(few, monkeypatch):
    """A row is computed again with fewer runs, and agrees within the confidence of both."""
    data = stored("feedback")
    assert len(data["law"]) == len(feedback.COLOURS) * len(feedback.FRICTIONS)
    monkeypatch.setattr(judgement, "RUNNERS", 256)
    monkeypatch.setattr(judgement, "MAX_STRIDES", 400)
    gait = tdmf_slip.find_gait({"ground.friction": 10.0})
    name = "quadratic regulator: touchdown angle"
    law = dataclasses.replace(feedback.laws(gait)[name], noise=[feedback.NOISE] * 6, seed=feedback.SEED)
    found = judgement.judge(gait, law, roughness=[0.5], seed=feedback.SEED)
    (row,) = np.flatnonzero((data["law"] == name) & (data["friction"] == 10.0))
    assert found.first_passages[0].mean_strides == pytest.approx(data["mean_strides_0.5"][row], rel=0.05)
    assert found.robustness.push_backward == pytest.approx(data["push_backward"][row], abs=0.01)
    low, high = found.volume.interval
    assert low < data["attracted_share"][row] < high
    assert law.lambda_max == pytest.approx(data["lambda_max"][row], rel=1e-6)
