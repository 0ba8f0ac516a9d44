"""Rare falls: against the eigenvalue of a transition matrix, and against waiting for them."""

import numpy as np
import pytest
from conftest import RELEASE, assert_same, some_of
from scipy import stats
from tdmf_slip import InputError, Runner, rare_falls, strides_to_fall
from tdmf_slip.analysis import rare_falls as rare_falls_module
from tdmf_slip.analysis.rare_falls import RareFalls, levels_of, rare_event, resampled
from tdmf_slip.library.ground import RoughGround, correlated_weights, spectrum_weights


class RimlessWheel:
    """The wheel of Byl and Tedrake (2009) on slopes drawn anew at each step; it falls where it stops.

    From leg to leg, with the angle 2 alpha between them and a slope of gamma,
    w+^2 = cos^2(2 alpha) (w^2 + 2 g/l (cos(gamma - alpha) - cos(gamma + alpha))).
    """

    alpha, slope, gravity = np.pi / 8.0, np.radians(8.0), 9.81

    def __init__(self, spread):
        self.spread, alpha, slope, gravity = np.radians(spread), self.alpha, self.slope, self.gravity
        drop = np.cos(slope - alpha) - np.cos(slope + alpha)
        shrink = np.cos(2.0 * alpha) ** 2
        self.fixed = np.sqrt(shrink * 2.0 * gravity * drop / (1.0 - shrink))

    def begin(self, count):
        return np.full((count, 1), self.fixed)

    def next_speed(self, speed, slope):
        """NaN where it stops: it does not get over the leg."""
        energy = speed**2 + 2.0 * self.gravity * np.cos(slope - self.alpha)
        over = np.where(slope < self.alpha, energy > 2.0 * self.gravity, True)
        after = energy - 2.0 * self.gravity * np.cos(slope + self.alpha)
        return np.where(
            over & (after > 0.0), np.cos(2.0 * self.alpha) * np.sqrt(np.maximum(after, 0.0)), np.nan
        )

    def advance(self, rows, seed, time):
        random = np.random.default_rng((seed, time))
        after = self.next_speed(rows[:, 0], self.slope + self.spread * random.normal(size=len(rows)))
        return after[:, None].copy(), np.isnan(after)

    def score(self, rows):
        return -rows[:, 0]

    def mean_by_matrix(self, cells=500):
        """One over one less the largest eigenvalue of the chain on cells of speed, falls left out.

        w+^2/cos^2(2 alpha) = w^2 + 4 g/l sin(gamma) sin(alpha): each cell is entered by a range of slopes.
        """
        edges = np.linspace(0.0, 2.5 * self.fixed, cells + 1)
        speeds = 0.5 * (edges[1:] + edges[:-1])
        sine = (edges**2 / np.cos(2.0 * self.alpha) ** 2 - speeds[:, None] ** 2) / (
            4.0 * self.gravity * np.sin(self.alpha)
        )
        slopes = np.arcsin(np.clip(sine, -1.0, 1.0))
        stops = self.alpha - np.arccos(np.clip(1.0 - speeds**2 / (2.0 * self.gravity), -1.0, 1.0))
        chance = stats.norm.cdf((np.maximum(slopes, stops[:, None]) - self.slope) / self.spread)
        return 1.0 / (1.0 - np.max(np.abs(np.linalg.eigvals(np.diff(chance, axis=1)))))


def waited(chain, count, steps, seed):
    rows, falls = chain.begin(count), 0
    for time in range(steps):
        rows, met = chain.advance(rows, seed, time)
        falls += np.count_nonzero(met)
        rows[met] = chain.begin(np.count_nonzero(met))
    return count * steps / falls, falls


def by_splitting(chain, seed, keep=60, steps=120):
    rows = chain.begin(2000)
    for time in range(30):
        rows, met = chain.advance(rows, 7, time)
        rows[met] = chain.begin(np.count_nonzero(met))
    levels = levels_of(chain.score(rows), -0.3, 14)
    return RareFalls(Runner(), "", 0.0, *rare_event(chain, levels, keep=keep, steps=steps, seed=seed))


def test_the_matrix_agrees_with_waiting():
    """The matrix is checked where waiting is possible, before it judges rarer falls."""
    chain = RimlessWheel(3.0)
    mean, falls = waited(chain, 10_000, 200, 5)
    assert falls > 200
    assert chain.mean_by_matrix() == pytest.approx(mean, rel=4.0 / np.sqrt(falls))
    assert RimlessWheel(1.6).mean_by_matrix() > 1e5  # too rare to wait for


@pytest.mark.parametrize("spread", some_of([1.6, 2.0, 3.0], 1))
def test_rare_falls_of_the_rimless_wheel_are_those_of_its_transition_matrix(spread):
    chain = RimlessWheel(spread)
    exact, inside, seeds = chain.mean_by_matrix(), 0, range(5)
    estimates = []
    for seed in seeds:
        found = by_splitting(chain, seed)
        low, high = found.interval
        inside += low <= exact <= high
        estimates.append(1.0 / found.mean_strides)
        assert found.falls >= 30
    assert np.mean(estimates) == pytest.approx(1.0 / exact, rel=0.3)
    assert inside >= 3


def test_resampling_keeps_weights():
    random = np.random.default_rng(3)
    weights, level = random.uniform(size=500), random.integers(0, 5, 500)
    kept = np.zeros(500)
    for _ in range(400):
        chosen, shares = resampled(weights, level, 40, random)
        assert shares.sum() == pytest.approx(weights.sum())
        np.add.at(kept, chosen, shares)
    for number in range(5):
        here = level == number
        assert kept[here].sum() / 400 == pytest.approx(weights[here].sum())
    assert np.abs(kept / 400 - weights).mean() < 0.1 * weights.mean()


GROUNDS = {
    "plain": RoughGround(0.3, 5),
    "all of it": RoughGround(
        0.3, 5, step_weights=spectrum_weights([0.0, 1.0, 2.0]), trips=True, friction_spread=0.3
    ),
    "steps that hang together": RoughGround(0.3, 5, step_weights=correlated_weights(0.7)),
    "trips": RoughGround(0.3, 5, trips=True),
    "friction by stride": RoughGround(0.3, 5, friction_spread=1.5),
}


@pytest.mark.parametrize("name", GROUNDS if RELEASE else list(GROUNDS)[:2])
def test_a_runner_falls_as_often_as_by_waiting(name, monkeypatch):
    """Plain steps as large make another mean, so that a ground that is passed over would be seen.

    Their intervals are apart. Friction by stride changes the mean by a fifth, as much as an interval is wide.
    """
    monkeypatch.setattr(rare_falls_module, "PILOT_WALKERS", 512 if RELEASE else 128)
    ground, runner = GROUNDS[name], {"ground.friction": 0.6}
    waiting = strides_to_fall(runner, ground, 400, max_strides=2_000)
    split = rare_falls(runner, ground, walkers=12, strides=40, seed=3)
    assert waiting.falls >= 350 and split.falls >= 60
    low, high = split.interval
    assert low < waiting.interval[1] and waiting.interval[0] < high and high < 3.0 * low
    if name == "plain":
        assert_same(rare_falls(runner, ground, walkers=12, strides=40, seed=3), split)
        return
    plain = strides_to_fall(runner, ground.roughness, 400, seed=6, max_strides=2_000)
    assert max(plain.interval[0] / waiting.interval[1], waiting.interval[0] / plain.interval[1]) > 1.0


def test_ground_that_splitting_does_not_know_is_refused_by_name():
    with pytest.raises(InputError, match=r"friction_weights: .* correlated friction"):
        rare_falls({}, RoughGround(0.3, friction_spread=0.1, friction_weights=(0.6, 0.8)))
    with pytest.raises(InputError, match="roughness = 0 is not allowed"):
        rare_falls({}, RoughGround(friction_spread=0.1))
