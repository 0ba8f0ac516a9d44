"""Gaits without a guess: of random runners, whose gaits were sought by far more expensive means."""

import re

import numpy as np
import pytest
from conftest import CLAMPED, RELEASE
from references import read
from tdmf_slip import GaitNotFoundError, RunError, Runner, find_gait
from tdmf_slip.analysis import search
from tdmf_slip.analysis.search import periodic_gait
from tdmf_slip.library.fixed_point import gait_near, settled_gait

RUNNERS = read("random_runners.json")
FROM_ISSUE = {
    "foot.mass": 0.0297,
    "leg.damping": 0.3357,
    "gravity": 0.0083,
    "ground.friction": 0.5802,
    "hip.stance_torque": 0.064,
    "hip.touchdown_angle": 0.5071,
    "hip.kp": 0.2327,
    "hip.kd": 0.2629,
    "hip.retraction_rate": 0.0033,
    **CLAMPED,
}


def test_a_stable_gait_that_the_start_does_not_settle_on_is_found():
    gait = find_gait(FROM_ISSUE)
    assert gait.word == "+0-0+" and gait.stable
    known = gait_near(Runner(FROM_ISSUE), np.array([1.03881, 0.78713, 1.00017, 0.06397, 0.0, 0.0767]))
    assert gait.apex == pytest.approx(known.apex, abs=1e-9) and gait.lambda_max == pytest.approx(
        0.944, abs=1e-3
    )
    along = periodic_gait(FROM_ISSUE, along="hip.kd")
    assert along.along == "hip.kd" and along.by_parameter.shape == (6,)
    assert along.apex == pytest.approx(gait.apex, abs=1e-12)


def test_gaits_of_random_runners_are_found_without_a_guess():
    """All that have a stable one, and most that have unstable ones only: one of these, with --release all."""
    stable, others, missed = 0, 0, []
    for stored in RUNNERS:
        if not stored["gaits"]:
            continue
        runner = Runner(stored["runner"] | CLAMPED)
        for known in stored["gaits"]:
            again = gait_near(runner, known["apex"])
            assert again.word == known["word"] and np.allclose(again.apex, known["apex"], atol=1e-6)
        has_stable = any(known["lambda_max"] < 1.0 for known in stored["gaits"])
        stable, others = stable + has_stable, others + (not has_stable)
        if others > 1 and not has_stable and not RELEASE:
            continue
        try:
            find_gait(runner)
        except RunError:
            missed.append(has_stable)
    assert (stable, others) == (5, 5)
    assert not any(missed) and len(missed) <= 1


def test_a_gait_that_settles_at_once_is_found_as_ever(monkeypatch):
    """The longer search is not begun, and changes nothing to the last bit."""
    monkeypatch.setattr(search, "search_from_spread", lambda *_, **__: pytest.fail("searched"))
    for friction in (10.0, 0.6, 0.2):
        runner = Runner({"ground.friction": friction})
        found, plain = find_gait(runner), settled_gait(runner)
        assert found.apex.tobytes() == plain.apex.tobytes() and found.stride == plain.stride


def test_no_gait_says_what_was_tried(command):
    hopeless = {"hip.stance_torque": 0.0, "ground.friction": 0.5}
    with pytest.raises(
        RunError, match=r"[\d,]+ random starts \([\d,]+ strides\); if a gait exists, a guess"
    ) as raised:
        find_gait(hopeless)
    assert "by continuation from friction 0.6" in str(raised.value)
    status, out, said = command("gait", "--friction", "0.5", "--set", "hip.stance_torque=0")
    assert (status, out) == (1, "") and "random starts" in said


def test_a_search_ends_after_a_bounded_number_of_strides():
    """Without a bound of its own it takes a hundred times as many."""
    few = search.search_from_spread(Runner({"leg.damping": 0.0}), max_strides=1500)
    assert 1500 <= few.strides <= 1500 + search.MAX_TRIED * search.ITERATIONS * search.SHORTENINGS


def test_a_search_whose_strides_take_too_many_steps_ends_and_says_so(monkeypatch):
    """A stride of this runner takes 3,000 steps or more, two hundred times as many as is usual."""
    monkeypatch.setattr(search, "STARTS", 64)
    runner = {
        "hip.touchdown_angle": -1.4977579896173873e-08,
        "body.external_fx": -40020851.84273862,
        "control.stance_torque": -0.21469768034433284,
        "foot.mass": 3.494827639229235e-05,
        "control.touchdown_angle": 0.027782313228634767,
    }
    with pytest.raises(GaitNotFoundError, match=r"more strides were given up") as raised:
        find_gait(runner)
    _, steps = re.search(r"([\d,]+) strides in ([\d,]+) steps", str(raised.value)).groups()
    assert int(steps.replace(",", "")) <= 64 * search.STEP_LIMIT * (1 + len(search.ROUNDS))


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_a_runner_that_is_carried_has_no_gait_and_none_is_searched(model):
    """Its centre of mass rises ever faster in flight: that no apex comes takes no search to know."""
    weight = 0.01 * 1.1
    with pytest.raises(GaitNotFoundError, match=r"body\.external_fy = 0\.012 N lifts .* weighs 0\.011 N"):
        find_gait({"body.external_fy": 0.012}, model=model)
    assert find_gait({"body.external_fy": 0.2 * weight}, model=model).error < 1e-11


def test_the_reduced_map_is_searched_too():
    runner = Runner({**FROM_ISSUE, "hip.retraction_rate": 0.0})
    gait = find_gait(runner, model="reduced")
    assert len(gait.apex) == 2 and gait.error < 1e-11
    found = search.search_from_spread(gait.runner)
    assert any(np.allclose(other.apex, gait.apex, atol=1e-8) for other in found.gaits)
