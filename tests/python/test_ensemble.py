"""The ensemble engine as Python sees it."""

import numpy as np
import pytest
from tdmf_slip import InputError, ensemble, orbit
from tdmf_slip.orbit import Runner


@pytest.fixture(scope="module")
def gaits(unit):
    return [orbit.find_orbit(Runner.of({"ground.friction": mu}, unit)) for mu in (0.6, 1.2)]


@pytest.fixture(scope="module")
def starts(gaits):
    rng = np.random.default_rng(5)
    return np.array([gaits[i % 2].apex + rng.uniform(-0.1, 0.1, 6) for i in range(200)])


def test_every_instruction_set_ends_alike(gaits, starts):
    cases = [ensemble.Case(Runner(g.runner.values)) for g in gaits]
    numbers = np.arange(len(starts)) % 2
    ends = {
        name: ensemble.run(
            cases, starts, numbers, most_strides=3, tolerance=1e-11, instructions=name, threads=2
        )[0]
        for name in ensemble.instruction_sets()
    }
    native = ends.pop("one by one")
    assert ends
    assert (native["strides"] == 3).all()
    for found in ends.values():
        for name in ("fate", "strides", "word_code"):
            np.testing.assert_array_equal(found[name], native[name])
        for name in ("apex", "time", "distance", "work", "damper_loss", "friction_loss", "impact_loss"):
            np.testing.assert_allclose(found[name], native[name], rtol=1e-8, atol=1e-8)


def test_runners_settle_on_their_own_gait(gaits, starts):
    """Two gaits are offered to each; a runner ends on that of its friction, whose apex it reaches."""
    apices = [g.apex for g in gaits]
    cases = [ensemble.Case(Runner(g.runner.values), apices) for g in gaits]
    numbers = np.arange(len(starts)) % 2
    ends, work = ensemble.run(cases, starts, numbers, most_strides=400, near=1e-3)
    np.testing.assert_array_equal(ends["gait"], numbers)
    assert (ends["fate"] == ensemble.FATES.index("settled")).all()
    np.testing.assert_allclose(ends["apex"], np.array(apices)[numbers], atol=1e-3)
    assert work.strides == ends["strides"].sum()


def test_a_runner_too_stiff_has_not_fallen(gaits, starts):
    stiff = ensemble.Case(Runner({**gaits[0].runner.values, "hip.kd": 2.5e13}), [gaits[0].apex])
    ends, work = ensemble.run([stiff], starts[:50], most_strides=400)
    assert (ends["fate"] == ensemble.FATES.index("unsolved")).all()
    assert work.steps <= 50


@pytest.mark.parametrize(
    "wrong",
    [
        {"tolerance": 0.0},
        {"tolerance": float("nan")},
        {"threads": -1},
        {"instructions": "mmx"},
        {"tolerance": 1e300},
        {"threads": 0.5},
        {"most_strides": 0},
        {"most_strides": 2.9},
        {"most_strides": 10**12},
        {"most_strides": float("nan")},
        {"near": -1.0},
        {"case_of": np.array([0, 7])},
        {"case_of": [0.7, 0.0]},
        {"case_of": [0, 2**32]},
        {"case_of": ["a", "b"]},
        {"tolerance": 1e-300},
        {"starts": np.zeros((2, 6), dtype=complex)},
        {"starts": np.zeros((2, 5))},
    ],
)
def test_what_is_not_allowed_is_said(gaits, starts, wrong):
    arguments = {"starts": starts[:2], "most_strides": 1} | wrong
    with pytest.raises(InputError, match="allowed"):
        ensemble.run([ensemble.Case(gaits[0].runner)], arguments.pop("starts"), **arguments)


@pytest.mark.parametrize("wrong", [[[1.0] * 5], [[1.0] * 7], [[float("nan")] * 6], [3.0]])
def test_what_is_no_gait_is_said(gaits, starts, wrong):
    with pytest.raises(InputError, match="gaits"):
        ensemble.run([ensemble.Case(gaits[0].runner, wrong)], starts[:2], most_strides=1)


def test_no_case_is_none(starts):
    with pytest.raises(InputError, match="cases"):
        ensemble.run([], starts[:2], most_strides=1)
