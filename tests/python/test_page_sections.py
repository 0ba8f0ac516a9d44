"""Sections of pages: return maps, Jacobians, fixed points and eigenvalues, for any page that declares one."""

import numpy as np
import pytest
from page_runs import BEHIND, COMPILER
from test_page_runner import GAITS, jacobian, runner  # noqa: F401

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")


@pytest.mark.parametrize(("reading", "gait"), GAITS, ids=[f"{r} {g['friction']}" for r, g in GAITS])
def test_the_reference_gaits_are_fixed_points_of_the_apex_map(runner, reading, gait):  # noqa: F811
    given = {"friction": gait["friction"], "swing_clamp": reading == "clamped", "tolerance": 1e-13}
    at_apex = runner.section("at_apex", **given)
    guess = np.array(gait["apex"]) * (1 + 1e-4 * np.array([1, -1, 0.1, 1, 1, -1]))
    assert at_apex.fixed_point(guess) == pytest.approx(gait["apex"], abs=1e-11)
    assert at_apex.jacobian == pytest.approx(jacobian(runner, gait["apex"], **given), abs=1e-10)
    largest = np.sort(np.abs(np.linalg.eigvals(at_apex.jacobian)))[::-1]
    expected = np.sort(np.abs(gait.get("eigenvalues", [])))[::-1]
    known = expected[expected > 0]  # others are of order 1e-8 or below
    assert largest[: len(known)] == pytest.approx(known, abs=1e-8)
    assert len(known) == 0 or (largest[len(known) :] < 1e-7).all()
    assert np.isnan(at_apex.memory[-BEHIND:]).all()


def test_a_return_map_of_too_many_seeds_is_refused(runner):  # noqa: F811
    seeds = ["friction", "kp", "kd", "gravity", "damping", "stiffness", "body_mass", "foot_mass"]
    seeds += ["free_length", "drive_torque", "touchdown_angle"]
    apex = GAITS[0][1]["apex"]
    at_apex = runner.section("at_apex", seeds=seeds[:10])
    assert at_apex.after(apex, varies=True).outcome == "stopped"
    at_apex = runner.section("at_apex", seeds=seeds)
    assert at_apex.after(apex, varies=True).outcome == "too-many-seeds"
    at_apex.given.outcome = at_apex.outcome
    text = "The return map has 11 seeds; with its coordinates, at most 16 are allowed"
    assert at_apex.given.message == text
    assert at_apex.after(apex).outcome == "stopped"
