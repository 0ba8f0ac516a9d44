"""Multilevel splitting: the mean time to an event so rare that waiting for it teaches nothing.

Walkers make a stride at a time, each with a weight. Between levels of a score that rises towards the event as
many walkers are kept at each level, by splitting those that are few and merging those that are many, without
changing the sum of weights. One that meets the event begins anew, and the weight that does so in a stride is,
in the long run, one over the mean time from the start to the event (Hill's relation). That holds whatever the
score; a poor one only makes the interval wide. See G. A. Huber and S. Kim, Biophys. J. 70, 97 (1996); D.
Bhatt, B. W. Zhang and D. M. Zuckerman, J. Chem. Phys. 133, 014110 (2010).
"""

import math
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

CONFIDENCE = 0.95
REPLICAS = 12
"""Independent runs, by whose spread the interval is made."""
BURN_IN = 0.25
"""Of the strides of a run, that are forgotten: weights are not settled yet."""


class Chain(Protocol):
    """A Markov chain that is stepped many walkers at a time, rows of an array."""

    def begin(self, count: int) -> NDArray[Any]:
        """So many walkers at the start, as rows."""
        ...

    def advance(self, rows: NDArray[Any], seed: int, time: int) -> tuple[NDArray[Any], NDArray[np.bool_]]:
        """The walkers after a step, by random numbers of their own, and who met the event."""
        ...

    def score(self, rows: NDArray[Any]) -> NDArray[np.float64]:
        """How near to the event each is; larger is nearer."""
        ...


@dataclass(frozen=True, eq=False)
class RareEvent:
    """A mean time to an event, from walkers that were split."""

    rates: NDArray[np.float64]
    """Weight that met the event in a step, of each independent run, shape (replicas,)."""
    events: int
    """Walkers that met it, after the burn-in."""
    steps: int
    """Made by all walkers, the burn-in included."""

    @property
    def mean(self) -> float:
        """Steps until the event; infinite where none was met."""
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
    """Which walkers go on, with which weights: as many at each level that has any."""
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
    chain: Chain, levels: NDArray[np.float64], keep: int, steps: int, seed: int
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
    chain: Chain,
    levels: NDArray[np.float64],
    *,
    keep: int,
    steps: int,
    seed: int,
    replicas: int = REPLICAS,
    done: Any = None,
) -> RareEvent:
    """The mean time to an event, by independent runs."""
    seeds = np.random.SeedSequence(seed).generate_state(replicas, np.uint64)
    runs = []
    for one in seeds:
        runs.append(split_run(chain, levels, keep, steps, int(one)))
        if done is not None:
            done()
    return RareEvent(
        np.array([rate for rate, _, _ in runs]), sum(e for _, e, _ in runs), sum(m for _, _, m in runs)
    )
