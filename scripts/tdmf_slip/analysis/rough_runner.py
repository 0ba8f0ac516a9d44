"""A runner on rough ground as splitting takes it: rows of bytes from apex to apex, with a score of danger.

A row holds the library's end and checkpoint. On ground with correlated steps it also holds the height of
the ground and the previous normal deviates. Such steps are drawn here, because a walker that is copied takes
its past along.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.affine_law import AffineLaw
from ..library.binding import ffi
from ..library.cases import Case, c_cases
from ..library.engine import run
from ..library.ensemble import END, FATES, ensemble_of
from ..library.gait import Gait
from ..library.recorded_strides import given_settings
from ..library.rough_ground import RoughGround
from .fates import TOLERANCE
from .logistic import logistic_weights

HEIGHT = "ground.height"
FELL = FATES.index("fell")
CHECKPOINT = ffi.sizeof("tdmf_ensemble_checkpoint")
COUNT = ffi.offsetof("tdmf_ensemble_checkpoint", "motion", "record", "stride", "count")
"""Strides that a runner's record has; those of its end are to be as many."""
KNOWN = END.itemsize + CHECKPOINT
"""Bytes of a row that are the library's."""
AHEAD = 6
"""Strides within which a fall counts when the score is learned."""
PILOT_WALKERS, PILOT_STRIDES = 512, 60
COMMON = (12.0, 60.0)
"""Mean strides until the fall, about, on the ground where the score is learned."""
ROUGHER = 1.25
TRIES = 12
SHARE_OF_STRIDES = 40


class RoughRunner:
    """A runner on rough ground, from apex to apex; one that stops begins anew and has not fallen."""

    def __init__(self, gait: Gait, ground: RoughGround, law: AffineLaw | None) -> None:
        """From the gait on level ground."""
        self.runner, self.law = gait.runner.replace(model="full"), law
        self.ground, self.roughness = ground, ground.roughness
        self.step_weights = np.array(ground.step_weights)
        self.scales = self.runner.scales
        self.apex = np.asarray(gait.apex, dtype=float)
        self.weights = np.zeros(1 + len(_features(np.zeros((1, 6)))[0]))
        level = RoughRunner.__new__(RoughRunner)
        level.__dict__.update(self.__dict__, ground=RoughGround(), roughness=0.0, law=None)
        starts = np.zeros((1, KNOWN + 8 * len(self.step_weights)), dtype=np.uint8)
        self._start, _ = level._run(starts, 0, 0, goes_on=False)
        past = [0.0, *[math.nan] * (len(self.step_weights) - 1)] if len(self.step_weights) else []
        self._start[0, KNOWN:] = np.array(past).view(np.uint8)

    def begin(self, count: int) -> NDArray[np.uint8]:
        """Rows at the gait's apex. Previous deviates are NaN; the first step draws them."""
        return np.repeat(self._start, count, axis=0)

    def advance(
        self, rows: NDArray[np.uint8], seed: int, time: int
    ) -> tuple[NDArray[np.uint8], NDArray[np.bool_]]:
        """A stride of each, on a step of its own."""
        after, fates = self._run(rows, seed, time, goes_on=True)
        fell = (fates == FELL) | self._tripped(rows, after)
        stopped = ~fell & (_strides(after) == time)
        if stopped.any():
            after[stopped] = self.begin(int(np.count_nonzero(stopped)))
        return after, fell

    def score(self, rows: NDArray[np.uint8]) -> NDArray[np.float64]:
        """The logarithm of the odds of a fall on rougher ground, as they were learned."""
        odds: NDArray[np.float64] = self._features(rows) @ self.weights[1:] + self.weights[0]
        return odds

    def _features(self, rows: NDArray[np.uint8]) -> NDArray[np.float64]:
        return _features((_ends(rows)["apex"] - self.apex) / self.scales)

    def _run(
        self, rows: NDArray[np.uint8], seed: int, time: int, *, goes_on: bool
    ) -> tuple[NDArray[np.uint8], NDArray[np.intc]]:
        """One stride more, the one after `time`; what a row holds is the library's end and place."""
        count = len(rows)
        ends = np.ascontiguousarray(_ends(rows))
        ends["strides"] = time
        checkpoints = np.ascontiguousarray(rows[:, END.itemsize : KNOWN])
        checkpoints[:, COUNT : COUNT + 4] = np.frombuffer(np.int32(time).tobytes(), dtype=np.uint8)
        past, settings = self._stepped(rows, seed, time)
        sections = np.repeat(self.apex[None], count, axis=0)
        request = ensemble_of(self.runner, sections, 0, TOLERANCE, None, None)
        ground = replace(
            self.ground, roughness=0.0 if settings else self.roughness, seed=seed, step_weights=()
        )
        cases, kept = c_cases([Case(self.runner, ground=ground, law=self.law)], time + 1, 1.0)
        request.cases, request.case_count = cases, 1
        request.checkpoints = ffi.cast("tdmf_ensemble_checkpoint *", ffi.from_buffer(checkpoints))
        request.goes_on = goes_on
        given, kept_settings = given_settings(settings, time) if settings else (ffi.NULL, None)
        request.given = given
        run(request, ends, 1)
        del kept, kept_settings
        bytes_of_ends = ends.view(np.uint8).reshape(count, END.itemsize)
        return np.concatenate([bytes_of_ends, checkpoints, past], axis=1), ends["fate"].copy()

    def _stepped(
        self, rows: NDArray[np.uint8], seed: int, time: int
    ) -> tuple[NDArray[np.uint8], dict[str, NDArray[np.float64]]]:
        """Past after one more step, and height of the ground; nothing where steps are independent."""
        if not len(self.step_weights):
            return rows[:, KNOWN:], {}
        past = np.ascontiguousarray(rows[:, KNOWN:]).view(np.float64)
        random = np.random.default_rng((seed, time))
        deviates = np.column_stack([random.normal(size=len(rows)), past[:, 1:]])
        unknown = np.isnan(deviates)
        deviates[unknown] = random.normal(size=np.count_nonzero(unknown))
        height = past[:, 0] + self.roughness * deviates @ self.step_weights
        after = np.column_stack([height, deviates[:, :-1]])
        return np.ascontiguousarray(after).view(np.uint8), {HEIGHT: height[:, None]}

    def _tripped(self, before: NDArray[np.uint8], after: NDArray[np.uint8]) -> NDArray[np.bool_]:
        """Where a step that was drawn here came above the foot; of its own steps the library tells it."""
        if not self.ground.trips or not len(self.step_weights):
            return np.zeros(len(before), dtype=bool)
        height, _, length, angle = _ends(before)["apex"][:, :4].T
        body, foot = (self.runner[name] for name in ("body.mass", "foot.mass"))
        clearance = height - body / (body + foot) * length * np.cos(angle)
        tripped: NDArray[np.bool_] = _heights(after) - _heights(before) > clearance
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


def _ends(rows: NDArray[np.uint8]) -> NDArray[Any]:
    return np.ascontiguousarray(rows[:, : END.itemsize]).view(END)[:, 0]


def _heights(rows: NDArray[np.uint8]) -> NDArray[np.float64]:
    """To which the ground has come."""
    heights: NDArray[np.float64] = np.ascontiguousarray(rows[:, KNOWN : KNOWN + 8]).view(np.float64)[:, 0]
    return heights


def _strides(rows: NDArray[np.uint8]) -> NDArray[np.intc]:
    strides: NDArray[np.intc] = _ends(rows)["strides"]
    return strides


def _features(away: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coordinates, bounded, and their products."""
    bounded = np.tanh(away)
    left, right = np.triu_indices(bounded.shape[1])
    return np.concatenate([bounded, bounded[:, left] * bounded[:, right]], axis=1)
