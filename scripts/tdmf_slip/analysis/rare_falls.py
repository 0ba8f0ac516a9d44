"""Mean number of strides until a rare fall on rough ground, by multilevel splitting.

Walkers are runners at their apices. The score that they are split by is learned where falls are common: on
rougher ground, how likely a runner at an apex is to fall within the next strides. The estimate does not
depend on it, only its interval does.

Multilevel splitting estimates the mean time to an event that is too rare to be simulated directly.
Walkers make a stride at a time, each with a weight. A score rises towards the event. Equally many walkers are
kept at each of its levels, by splitting and merging walkers without changing the sum of weights. A walker
that meets the event begins anew. The weight that does so in a stride is, in the long run, one over the mean
time from the start to the event (Hill's relation). This holds for any score; a poor one only makes the
interval wide. See G. A. Huber and S. Kim, Biophys. J. 70, 97 (1996); D.
Bhatt, B. W. Zhang and D. M. Zuckerman, J. Chem. Phys. 133, 014110 (2010).

A walker is a row of a structured array: the state that `Batch.save` gives and, on ground with correlated
steps, the height of the ground and the previous normal deviates. Such steps are drawn here, because a walker
that is copied takes its past along.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..checks import checked_whole
from ..errors import InputError, RunError
from ..library.batch import Batch
from ..library.batch_tables import GROUND
from ..library.c_structs import STATE
from ..library.engine import FELL
from ..library.gait import Gait
from ..library.ground import LAST_SEED, RoughGround
from ..library.laws import Law, check_law
from ..library.return_map import refuse_patch
from ..library.runner import Runner
from ..record import entries
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from .attraction import CONFIDENCE
from .ball import TOLERANCE
from .first_passage import Falls, rough_start

RIDGE, ITERATIONS = 1e-3, 25
REPLICAS = 12
"""Number of independent runs, whose spread gives the interval."""
BURN_IN = 0.25
"""Share of the strides of a run that is dropped, because weights have not settled yet."""
AHEAD = 6
"""Strides within which a fall counts when the score is learned."""
PILOT_WALKERS, PILOT_STRIDES = 512, 60
COMMON = (12.0, 60.0)
"""Range of the mean strides until the fall on the ground where the score is learned."""
ROUGHER = 1.25
TRIES = 12
SHARE_OF_STRIDES = 40
LEVELS = 16
MAX_WALKERS, MAX_STEPS = 10_000, 100_000
SMOOTHEST = 1e-9
"""Smallest roughness, m."""


def logistic_weights(features: NDArray[np.float64], falls: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Intercept and weights of a logistic regression of falls on features."""
    rows = np.concatenate([np.ones((len(features), 1)), features], axis=1)
    weights = np.zeros(rows.shape[1])
    ridge = RIDGE * len(rows) * np.eye(rows.shape[1])
    for _ in range(ITERATIONS):
        chance = 1.0 / (1.0 + np.exp(-np.clip(rows @ weights, -30.0, 30.0)))
        slope = rows.T @ (falls - chance) - ridge @ weights
        bend = (rows * (chance * (1.0 - chance))[:, None]).T @ rows + ridge
        step = np.linalg.solve(bend, slope)
        weights += step
        if np.max(np.abs(step)) < 1e-8:
            break
    return weights


def levels_of(scores: NDArray[np.float64], highest: float, count: int) -> NDArray[np.float64]:
    """Levels of a score: at each about half as many walkers arrive as at the one before."""
    seen = int(math.log2(max(len(scores), 2))) - 4
    shares = 1.0 - 0.5 ** np.arange(1, max(2, min(seen, count)) + 1)
    levels = np.unique(np.quantile(scores, shares))
    beyond = count - len(levels)
    if highest > levels[-1] and beyond > 0:
        levels = np.append(levels, np.linspace(levels[-1], highest, beyond + 2)[1:-1])
    return levels


def resampled(
    weights: NDArray[np.float64], level: NDArray[np.intp], keep: int, random: np.random.Generator
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """Numbers of the walkers that go on, and their weights: equally many at each level with walkers."""
    chosen, shares = [], []
    for number in np.unique(level):
        here = np.flatnonzero(level == number)
        cumulated = np.cumsum(weights[here])
        total = cumulated[-1]
        if total <= 0.0:
            continue
        points = (np.arange(keep) + random.uniform()) * (total / keep)
        chosen.append(here[np.minimum(np.searchsorted(cumulated, points), len(here) - 1)])
        shares.append(np.full(keep, total / keep))
    return np.concatenate(chosen), np.concatenate(shares)


def split_run(
    chain: Walkers, levels: NDArray[np.float64], keep: int, steps: int, seed: int
) -> tuple[float, int, int]:
    """One run: the weight that meets the event in a step, how many walkers did, and the steps of all."""
    random = np.random.default_rng(seed)
    rows, weights = chain.begin(keep), np.full(keep, 1.0 / keep)
    burn_in = int(BURN_IN * steps)
    flux, events, made = 0.0, 0, 0
    for time in range(steps):
        rows, met = chain.advance(rows, seed, time)
        made += len(rows)
        if time >= burn_in:
            flux += float(weights[met].sum())
            events += int(np.count_nonzero(met))
        if met.any():
            rows[met] = chain.begin(int(np.count_nonzero(met)))
        level = np.searchsorted(levels, chain.score(rows), side="right")
        chosen, weights = resampled(weights, level, keep, random)
        rows = rows[chosen]
    return flux / (steps - burn_in), events, made


def rare_event(
    chain: Walkers,
    levels: NDArray[np.float64],
    *,
    keep: int,
    steps: int,
    seed: int,
    run_finished: Callable[[], object] = lambda: None,
) -> tuple[NDArray[np.float64], int, int]:
    """Rate of the event in each of some independent runs, and the numbers of events and steps in all runs."""
    runs = []
    for one in np.random.SeedSequence(seed).generate_state(REPLICAS, np.uint64):
        runs.append(split_run(chain, levels, keep, steps, int(one)))
        run_finished()
    rates, events, made = zip(*runs, strict=True)
    return np.array(rates), sum(events), sum(made)


class Walkers:
    """A runner on rough ground, from apex to apex; one that stops begins anew and has not fallen."""

    def __init__(self, gait: Gait, ground: RoughGround, law: Law | None) -> None:
        """Start from the gait on level ground."""
        self.runner, self.law = gait.runner, law
        self.ground, self.roughness = ground, ground.roughness
        self.step_weights = np.array(ground.step_weights)
        self.scales = self.runner.scales
        self.apex = np.asarray(gait.apex, dtype=float)
        self.weights = np.zeros(1 + len(_features(np.zeros((1, len(self.apex))))[0]))
        # The first stride is on level ground without a law: every walker begins where it leads.
        batch = Batch(self.runner, self.apex[None], tolerance=TOLERANCE)
        batch.step()
        self._start = np.zeros(
            1, [("state", STATE), ("height", "f8"), ("past", "f8", (len(self.step_weights),))]
        )
        self._start["state"] = batch.save()
        self._start["past"] = np.nan

    def begin(self, count: int) -> NDArray[Any]:
        """Walkers at the start. Previous deviates are NaN; the first step draws them."""
        return np.repeat(self._start, count)

    def advance(self, rows: NDArray[Any], seed: int, time: int) -> tuple[NDArray[Any], NDArray[np.bool_]]:
        """Walkers after a stride of each on a step of its own, and the mask of those that fell."""
        after, settings = self._stepped(rows, seed, time)
        own = 0.0 if settings else self.roughness
        ground = replace(self.ground, roughness=own, seed=seed, step_weights=())
        batch = Batch(self.runner, self.apex[None], ground, self.law, tolerance=TOLERANCE)
        batch.resume(rows["state"], time)
        fell = (batch.step(settings) == FELL) | self._tripped(rows, after)
        after["state"] = batch.save()
        stopped = ~fell & (after["state"]["end"]["strides"] == time)
        after[stopped] = self.begin(int(np.count_nonzero(stopped)))
        return after, fell

    def score(self, rows: NDArray[Any]) -> NDArray[np.float64]:
        """The logarithm of the odds of a fall on rougher ground, as they were learned."""
        odds: NDArray[np.float64] = self._features(rows) @ self.weights[1:] + self.weights[0]
        return odds

    def _features(self, rows: NDArray[Any]) -> NDArray[np.float64]:
        return _features((rows["state"]["end"]["apex"][..., : len(self.apex)] - self.apex) / self.scales)

    def _stepped(
        self, rows: NDArray[Any], seed: int, time: int
    ) -> tuple[NDArray[Any], dict[str, NDArray[np.float64]]]:
        """Walkers after one more step, and the height of the ground; nothing where steps are independent."""
        after = rows.copy()
        if not len(self.step_weights):
            return after, {}
        random = np.random.default_rng((seed, time))
        deviates = np.column_stack([random.normal(size=len(rows)), rows["past"][:, :-1]])
        unknown = np.isnan(deviates)
        deviates[unknown] = random.normal(size=np.count_nonzero(unknown))
        after["height"] += self.roughness * deviates @ self.step_weights
        after["past"] = deviates
        return after, {GROUND: after["height"]}

    def _tripped(self, before: NDArray[Any], after: NDArray[Any]) -> NDArray[np.bool_]:
        """Mask of walkers whose foot was below the step drawn here; the library reports its own steps."""
        if not self.ground.trips or not len(self.step_weights):
            return np.zeros(len(before), dtype=bool)
        height, _, length, angle = before["state"]["end"]["apex"][:, :4].T
        body, foot = (self.runner[name] for name in ("body.mass", "foot.mass"))
        clearance = height - body / (body + foot) * length * np.cos(angle)
        tripped: NDArray[np.bool_] = after["height"] - before["height"] > clearance
        return tripped

    def learn(self, seed: int) -> tuple[NDArray[np.float64], float]:
        """Learn the score where falls are common; returns scores on the runner's own ground and of falls."""
        own, roughness = self.roughness, self.roughness
        for attempt in range(TRIES):
            self.roughness = roughness
            features, falls, mean = self._pilot(seed + attempt)
            if mean > COMMON[1]:
                roughness *= ROUGHER
            elif mean < COMMON[0] and roughness > own:
                roughness = max(own, roughness / math.sqrt(ROUGHER))
            else:
                break
        self.roughness = own
        if not falls.any():
            raise RunError(f"no fall was seen on steps of {roughness:g} m, where the score is to be learned")
        self.weights = logistic_weights(features, falls)
        highest = float(np.quantile(features[falls] @ self.weights[1:], 0.9) + self.weights[0])
        scores = []
        rows = self.begin(PILOT_WALKERS)
        for time in range(SHARE_OF_STRIDES):
            rows, fell = self.advance(rows, seed + TRIES, time)
            rows[fell] = self.begin(int(np.count_nonzero(fell)))
            scores.append(self.score(rows))
        return np.concatenate(scores[SHARE_OF_STRIDES // 2 :]), highest

    def _pilot(self, seed: int) -> tuple[NDArray[np.float64], NDArray[np.bool_], float]:
        """Features of apices, the mask of those with a fall soon after, and the mean time to a fall."""
        rows, seen, fallen = self.begin(PILOT_WALKERS), [], []
        for time in range(PILOT_STRIDES):
            rows, fell = self.advance(rows, seed, time)
            rows[fell] = self.begin(int(np.count_nonzero(fell)))
            seen.append(self._features(rows))
            fallen.append(fell)
        falls = np.array(fallen)
        soon = np.array([falls[k + 1 : k + 1 + AHEAD].any(axis=0) for k in range(len(falls) - AHEAD)])
        begun_anew = falls[: len(soon)]
        kept = ~begun_anew.ravel()
        count = int(falls.sum())
        mean = falls.size / count if count else math.inf
        return np.concatenate(seen[: len(soon)])[kept], soon.ravel()[kept], mean


def _features(away: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bounded coordinates and their products."""
    bounded = np.tanh(away)
    left, right = np.triu_indices(bounded.shape[1])
    return np.concatenate([bounded, bounded[:, left] * bounded[:, right]], axis=1)


@dataclass(frozen=True, eq=False, repr=False)
class RareFalls(Falls):
    """Strides until a rare fall, estimated by splitting."""

    rates: NDArray[np.float64]
    """Weight that fell in a stride, of each independent run, shape (runs,)."""
    falls: int
    """Number of walkers that fell, each with its weight, after the burn-in."""
    strides: int
    """Strides of all walkers, the burn-in included."""

    @property
    def mean_strides(self) -> float:
        """Strides until the fall; infinite where none was seen."""
        rate = float(np.mean(self.rates))
        return 1.0 / rate if rate > 0.0 else math.inf

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the mean, by Student's t on the rates of the runs; above it may be open."""
        from scipy import stats  # slow to load

        count = len(self.rates)
        rate, error = float(np.mean(self.rates)), float(np.std(self.rates, ddof=1)) / math.sqrt(count)
        reach = float(stats.t.ppf(0.5 * (1.0 + CONFIDENCE), count - 1)) * error
        low = 1.0 / (rate + reach) if rate + reach > 0.0 else math.inf
        return low, 1.0 / (rate - reach) if rate > reach else math.inf

    def as_json(self) -> dict[str, object]:
        """The estimate as a plain object."""
        return super().as_json() | entries(self, "falls", "strides") | {"runs": len(self.rates)}


def rare_falls(
    runner: RunnerLike,
    roughness: float | RoughGround,
    *,
    walkers: int = 64,
    strides: int = 160,
    seed: int = 0,
    gait: Gait | None = None,
    law: Law | None = None,
    progress: bool = False,
) -> RareFalls:
    """Estimate the mean number of strides until a fall that hardly ever comes, by multilevel splitting.

    Ground, start and fall are those of `strides_to_fall`, which suits falls that are common. Here `REPLICAS`
    independent runs keep `walkers` runners at each of `LEVELS` levels of danger.

    Parameters
    ----------
    runner : as in `find_gait`
    roughness : float or RoughGround
        As in `strides_to_fall`; the ground's own seed is not used.
    walkers : int, default 64
        Runners that are kept at each level.
    strides : int, default 160
        Strides of each walker in each run. The first quarter is discarded.
    seed : int, default 0
        Seed of everything that is drawn.
    gait, law : as in `strides_to_fall`
    progress : as in `sweep`

    Returns
    -------
    RareFalls
        The mean with its confidence interval.

    Raises
    ------
    InputError
        A value is not allowed, the ground of the model cannot vary, or the law does not fit it.
    RunError
        There is no gait to start from, or no fall was seen on much rougher ground either.

    Examples
    --------
    >>> import tdmf_slip
    >>> rare = tdmf_slip.rare_falls({"ground.friction": 0.6}, 0.4, walkers=8, strides=16)
    >>> low, high = rare.interval
    >>> low < rare.mean_strides < high
    True
    """
    ground = roughness if isinstance(roughness, RoughGround) else RoughGround(roughness)
    _check_is_rough(ground)
    walkers = checked_whole("walkers", walkers, 8, MAX_WALKERS)
    strides = checked_whole("strides", strides, 8, MAX_STEPS)
    seed = checked_whole("seed", seed, 0, LAST_SEED)
    runner = Runner(runner)
    refuse_patch(runner)
    check_law(law, runner)
    runner, start = rough_start(runner, gait)
    chain = Walkers(start, ground, law)
    with progress_bar("rare falls", REPLICAS + 1, "runs", progress) as bar:
        scores, highest = chain.learn(seed % 2**32)
        bar.update()
        levels = levels_of(scores, highest, LEVELS)
        found = rare_event(chain, levels, keep=walkers, steps=strides, seed=seed, run_finished=bar.update)
    return RareFalls(start.runner, start.word, ground.roughness, *found)


def _check_is_rough(ground: RoughGround) -> None:
    """Refuse ground without steps, a terrain, and correlated friction."""
    if ground.roughness < SMOOTHEST:
        raise InputError(f"roughness = {ground.roughness:g} is not allowed; allowed: {SMOOTHEST:g} m or more")
    if ground.segment_length:
        raise InputError(
            f"segment_length = {ground.segment_length:g} m: rare_falls copies walkers from apex to apex, and "
            "copies would have the same segments ahead; allowed: ground by stride (segment_length of 0), or "
            "strides_to_fall"
        )
    if ground.friction_weights:
        raise InputError(
            "friction_weights: rare_falls does not copy the past of correlated friction with its walkers; "
            "allowed: independent friction for each stride (friction_spread), or strides_to_fall"
        )
