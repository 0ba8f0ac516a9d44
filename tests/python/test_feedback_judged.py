"""Value of feedback in the ensemble: attraction, disturbances, and strides on rough ground."""

import dataclasses
import json

import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED
from tdmf_slip.analysis import attraction
from tdmf_slip.paper.figures import attraction as figure
from tdmf_slip.paper.figures import feedback, rough
from tdmf_slip.paper.figures.data import stored
from tdmf_slip.paper.statements import regions, rough_ground

ANGLE, TORQUE = regions.SETTINGS


@pytest.fixture(scope="module")
def gait():
    """The swing is clamped; with a free swing, feedback does not delay the falls of this runner."""
    return tdmf_slip.find_gait({"ground.friction": 1.0, **CLAMPED})


@pytest.fixture
def few(monkeypatch):
    """Shorten the runs."""
    monkeypatch.setattr(attraction, "COARSE", 50)
    monkeypatch.setattr(figure, "SAMPLES", 60)


def test_a_runner_with_feedback_stays_up_longer_and_without_as_it_is(gait, few):
    """Runs at friction 1 are about ten times longer; 48 runners show that up to a factor of 3."""
    law = feedback.laws(gait)["quadratic regulator: angle and torque"]
    noisy = dataclasses.replace(law, noise=rough_ground.NOISE * gait.runner.scales, seed=1)
    held_on_rough, alone_on_rough = (
        tdmf_slip.strides_to_fall(gait.runner, 0.3, 48, 2, 200, gait=gait, law=its) for its in (noisy, None)
    )
    assert held_on_rough.mean_strides > 3 * alone_on_rough.mean_strides
    judged = figure.judged([(gait, law), (gait, None)], seed=2)
    held, alone = (judged.iloc[row] for row in (0, 1))
    assert held["samples"] == 60 and held["attracted_share"] >= alone["attracted_share"]
    assert held["step_up"] > 0.3 and held["step_down"] > alone["step_down"]


def test_regions_of_attraction_are_those_without_noise(gait, few):
    """Under noise, no runner settles closer to the gait than its noise lets it stray."""
    law = feedback.laws(gait)["quadratic regulator: angle and torque"]
    loud = dataclasses.replace(law, noise=gait.runner.scales)
    judged = figure.judged([(gait, loud), (gait, law)])
    assert judged.iloc[0].equals(judged.iloc[1])
    assert judged["step_up"][0] > 0.3


def test_a_basin_under_a_feedback_keeps_the_law(gait):
    law = feedback.laws(gait)["dead-beat: angle and torque"]
    height, speed = gait.apex[:2]
    axes = {"com_height": (height, height + 0.1), "com_speed": (speed, speed + 0.1)}
    found = tdmf_slip.basin(gait.runner, axes, 2, law=law)
    assert (found["fate"] == 0).all()
    kept = json.loads(found.attrs["law"])
    assert kept["inputs"] == [ANGLE, TORQUE] and len(kept["eigenvalues"]) == 6


def test_what_is_kept_of_the_figure_is_what_is_measured(few):
    """A row is computed again with fewer runs, and agrees within the confidence of both."""
    data = stored("feedback")
    assert len(data["law"]) == len(feedback.COLOURS) * len(feedback.FRICTIONS)
    gait = tdmf_slip.find_gait({"ground.friction": 10.0})
    name = "quadratic regulator: touchdown angle"
    law = dataclasses.replace(feedback.laws(gait)[name], noise=[rough_ground.NOISE] * 6, seed=rough.SEED)
    (row,) = np.flatnonzero((data["law"] == name) & (data["friction"] == 10.0))
    passed = rough.passages([(gait, law, 0.5)])
    assert passed["mean_strides"][0] == pytest.approx(data["mean_strides_0.5"][row], rel=0.05)
    judged = figure.judged([(gait, law)], rough.SEED).iloc[0]
    assert judged["push_backward"] == pytest.approx(data["push_backward"][row], abs=0.01)
    assert judged["attracted_share_low"] < data["attracted_share"][row] < judged["attracted_share_high"]
    assert law.lambda_max == pytest.approx(data["lambda_max"][row], rel=1e-6)
