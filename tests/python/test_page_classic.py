"""The classic SLIP's page beside references and the core's own solver."""

import math

import numpy as np
import pytest
from conftest import some_of
from old_core import ffi
from page_runs import COMPILER, CompiledPage
from scipy.optimize import fsolve
from tdmf_slip.library.binding import c

from c_core.pages.classic import ClassicSlip

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
FIXED_POINTS = [
    (40, 1.03696, -0.0603, 4.939), (40, 3.54806, 3.7622, None), (42, 1.17889, 0.1626, 3.852),
    (42, 3.06865, 2.7634, None), (44, 1.50393, 0.5428, 2.798), (44, 2.40934, 1.66, None),
]  # fmt: skip
"""Angle in degrees, apex height, slope of the map, friction that the impact needs: the digits are trusted to
the last but one."""
FOLD = 44.59
NO_SLIP = 1e9


@pytest.fixture(scope="module")
def slip():
    return CompiledPage(ClassicSlip)


@pytest.mark.parametrize(("angle", "height", "slope", "friction"), FIXED_POINTS)
def test_fixed_points_are_those_of_the_reference(slip, angle, height, slope, friction):
    at_energy = slip.section("at_energy", touchdown_angle=math.radians(angle), tolerance=1e-14)
    assert at_energy.fixed_point([height + 1e-3]) == pytest.approx([height], abs=2e-5)
    assert at_energy.jacobian == pytest.approx(np.array([[slope]]), abs=2e-4)
    if friction:
        at_energy.after([height])
        assert at_energy.state("impact_friction") == pytest.approx(friction, abs=2e-3)
        assert at_energy.state("apex_energy") == pytest.approx(6000, abs=1e-8)


def test_two_gaits_meet_at_the_fold(slip):
    def residual(at):
        section = slip.section("at_energy", touchdown_angle=at[1], tolerance=1e-14).after(at[:1], varies=True)
        return [section.next[0] - at[0], section.jacobian[0, 0] - 1]

    assert math.degrees(fsolve(residual, [1.9, math.radians(44.5)])[1]) == pytest.approx(FOLD, abs=5e-3)


OUTCOMES = {"no_start": 1, "slides": 2, "fallen": 3}
CLOSED = {0, 4}
"""The core's outcomes; it tells a runner that turns back from one that flies on."""


def drawn(number):
    """A runner's parameters, its energy and apex height."""
    random = np.random.default_rng([473, number])
    u = random.uniform
    parameters = {
        "mass": 80 * 2 ** u(-1, 1), "stiffness": 20000 * 2 ** u(-1, 1), "free_length": u(0.8, 1.2),
        "gravity": u(5, 12),
        "touchdown_angle": u(-0.2, 1.1), "friction": NO_SLIP if u() < 0.4 else 10 ** u(-0.7, 0.5),
        "slope": u(-0.2, 0.2) if u() < 0.6 else 0.0, "retraction_rate": u(-1, 2) if u() < 0.6 else 0.0,
    }  # fmt: skip
    height = parameters["free_length"] * u(0.7, 2.5)
    energy = parameters["mass"] * (parameters["gravity"] * height + u(-1, 8) ** 2 / 2 * np.sign(u(-0.1, 1)))
    return parameters, max(0.0, energy), height


def core(parameters, energy, height):
    """A step of the core."""
    given = ffi.new("tdmf_classic *", c.tdmf_classic_default())
    for name, value in parameters.items():
        value = math.inf if value == NO_SLIP else value
        setattr(given, {"slope": "ground_slope"}.get(name, name), value)
    return c.tdmf_classic_return_map(given, energy, height)


def test_random_steps_are_those_of_the_core(slip):
    found = set()
    for number in some_of(range(20000), 1000):
        parameters, energy, height = drawn(number)
        theirs = core(parameters, energy, height)
        seeds = ["touchdown_angle", "slope", "retraction_rate"]
        mine = slip.section("at_apex", seeds=seeds, tolerance=1e-14, **parameters)
        mine.after([height, energy], varies=True)
        if mine.outcome != "stopped":
            lies = mine.mode == "slides" and parameters["friction"] == NO_SLIP  # the mass is on the ground
            outcome = OUTCOMES["fallen" if lies else mine.mode]
            assert (mine.outcome, outcome) == ("ended", theirs.outcome), number
            found.add(mine.mode)
            continue
        assert theirs.outcome in CLOSED, number
        found.add("early" if theirs.early_take_off else "closed")
        scale = parameters["mass"] * parameters["gravity"]
        assert mine.next / [1, scale] == pytest.approx(
            [theirs.next_height, theirs.next_energy / scale], abs=1e-9
        ), number
        values = {
            n: mine.state(n) for n in ("stance_time", "stance_friction", "impact_friction", "step_length")
        }
        expected = [theirs.stance_time, theirs.stance_friction, theirs.impact_friction, theirs.length]
        assert list(values.values()) == pytest.approx(expected, rel=1e-8, abs=1e-9), number
        columns = [
            theirs.by_height,
            theirs.by_energy,
            theirs.by_touchdown_angle,
            theirs.by_ground_slope,
            theirs.by_retraction_rate,
        ]
        exact = np.array([[v.height for v in columns], [v.energy for v in columns]])
        varied = np.hstack([mine.jacobian, mine.by_seeds])
        if not theirs.early_take_off:  # the core's changes are exact where the foot does not slip
            off = np.abs(varied - exact) / (1 + np.abs(exact).max(axis=1, keepdims=True))
            assert off.max() < 1e-8, number
    assert found >= {"closed", "early", "slides", "fallen", "no_start"}


@pytest.mark.parametrize("early", [False, True])
def test_derivatives_are_those_of_differences(slip, early):
    """The page's are exact where the leg leaves the cone, too."""
    given = {"touchdown_angle": 0.65, "slope": 0.03, "retraction_rate": 0.3}
    given["friction"] = 0.7 if early else NO_SLIP
    point, seeds, step = np.array([1.3, 4000.0]), ["friction", "slope", "stiffness", "mass"], 1e-6
    given |= {"stiffness": 20000.0, "mass": 80.0}
    exact = slip.section("at_apex", seeds=seeds, tolerance=1e-15, **given).after(point, varies=True)
    assert (exact.outcome, exact.state("left_early")) == ("stopped", early)

    def ends(name, size):
        values = given | ({name: given[name] * (1 + size)} if isinstance(name, str) else {})
        at = point if isinstance(name, str) else point * (1 + size * np.eye(2)[name])
        return slip.section("at_apex", tolerance=1e-15, **values).after(at).next

    for column, name in zip(np.hstack([exact.jacobian, exact.by_seeds]).T, [0, 1, *seeds], strict=True):
        if name == "friction" and not early:
            continue
        by = given[name] if isinstance(name, str) else point[name]
        found = (ends(name, step) - ends(name, -step)) / (2 * step)
        assert column * by / [1, 4000] == pytest.approx(found / [1, 4000], abs=1e-6, rel=1e-5), name
