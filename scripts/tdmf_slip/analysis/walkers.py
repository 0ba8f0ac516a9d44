"""Walkers on rough ground for splitting: states of runners at apices, with a score of danger.

A walker is a row of a structured array: the state that `Batch.save` gives and, on ground with correlated
steps, the height of the ground and the previous normal deviates. Such steps are drawn here, because a walker
that is copied takes its past along.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.batch import Batch
from ..library.batch_tables import GROUND
from ..library.c_structs import STATE
from ..library.engine import FELL
from ..library.gait import Gait
from ..library.ground import RoughGround
from ..library.laws import Law
from .fates import TOLERANCE
from .logistic import logistic_weights

AHEAD = 6
"""Strides within which a fall counts when the score is learned."""
PILOT_WALKERS, PILOT_STRIDES = 512, 60
COMMON = (12.0, 60.0)
"""Mean strides until the fall, about, on the ground where the score is learned."""
ROUGHER = 1.25
TRIES = 12
SHARE_OF_STRIDES = 40


class Walkers:
    """A runner on rough ground, from apex to apex; one that stops begins anew and has not fallen."""

    def __init__(self, gait: Gait, ground: RoughGround, law: Law | None) -> None:
        """From the gait on level ground."""
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
        """A stride of each, on a step of its own."""
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
        return _features((rows["state"]["end"]["apex"] - self.apex) / self.scales)

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
        """Learn the score where falls are common; scores on the runner's own ground, and that of falls."""
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
        """Apices, after which of them a runner fell within some strides, and the mean time to a fall."""
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
    """Coordinates, bounded, and their products."""
    bounded = np.tanh(away)
    left, right = np.triu_indices(bounded.shape[1])
    return np.concatenate([bounded, bounded[:, left] * bounded[:, right]], axis=1)
