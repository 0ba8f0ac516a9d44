"""How long a runner stays up on rough ground that it hardly ever falls on: by multilevel splitting.

Walkers are runners at their apices. The score that they are split by is learned where falls are common: on
rougher ground, how likely a runner at an apex is to fall within the next strides. The estimate does not
depend on it, only its interval does.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..checks import checked, checked_whole
from ..contents import ByContents
from ..errors import InputError, RunError
from ..library.affine_law import AffineLaw, check_law
from ..library.binding import ffi
from ..library.cases import Case, c_cases
from ..library.ensemble import END, FATES, ensemble_of, run
from ..library.gait import Gait, check_is_gait
from ..library.rough_ground import LARGEST, LAST_SEED, RoughGround
from ..library.runner import Runner
from ..terminal.progress import progress_bar
from ..unit.unit import Fmu
from ..unit.variable import Given
from .fates import TOLERANCE
from .logistic import logistic_weights
from .search import periodic_gait
from .splitting import CONFIDENCE, REPLICAS, RareEvent, levels_of, rare_event

FELL = FATES.index("fell")
UNDECIDED = FATES.index("undecided")
PLACE = ffi.sizeof("tdmf_ensemble_checkpoint")
COUNT = ffi.offsetof("tdmf_ensemble_checkpoint", "motion", "record", "stride", "count")
"""Strides that a runner's record has; those of its end are to be as many."""
AHEAD = 6
"""Strides within which a fall counts when the score is learned."""
PILOT_WALKERS, PILOT_STRIDES = 512, 60
COMMON = (12.0, 60.0)
"""Mean strides until the fall, about, on the ground where the score is learned."""
ROUGHER = 1.25
TRIES = 12
LEVELS, SHARE_OF_STRIDES = 16, 40
MOST_WALKERS, MOST_STEPS = 10_000, 100_000


@dataclass(frozen=True, eq=False)
class RareFalls(ByContents):
    """Strides until a rare fall, estimated by splitting."""

    word: str
    """Of the gait on level ground that the runners start from."""
    roughness: float
    """Standard deviation of a step, m."""
    found: RareEvent
    """Rates of independent runs, falls and strides."""

    @property
    def mean_strides(self) -> float:
        """Until the fall; infinite where none was seen."""
        return self.found.mean

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the mean; above it may be open."""
        return self.found.interval

    @property
    def falls(self) -> int:
        """Of walkers, each with its weight."""
        return self.found.events

    @property
    def strides(self) -> int:
        """Made by all walkers."""
        return self.found.steps

    def as_json(self) -> dict[str, object]:
        """The estimate as a plain object."""
        return {
            "word": self.word,
            "roughness": self.roughness,
            "mean_strides": self.mean_strides,
            "interval": list(self.interval),
            "confidence": CONFIDENCE,
            "falls": self.falls,
            "strides": self.strides,
            "runs": len(self.found.rates),
        }


class RoughRunner:
    """A runner on rough ground, from apex to apex; one that stops begins anew and has not fallen."""

    def __init__(self, gait: Gait, roughness: float, law: AffineLaw | None, threads: int | None) -> None:
        """From the gait on level ground."""
        self.runner, self.threads, self.law = Runner(gait.runner.values), threads, law
        self.roughness = roughness
        self.scales = self.runner.scales
        self.apex = np.asarray(gait.apex, dtype=float)
        self.weights = np.zeros(1 + len(_features(np.zeros((1, 6)))[0]))
        level = RoughRunner.__new__(RoughRunner)
        level.__dict__.update(self.__dict__, roughness=0.0, law=None)
        starts = np.zeros((1, END.itemsize + PLACE), dtype=np.uint8)
        self._start, _ = level._run(starts, 0, 0, goes_on=False)

    def begin(self, count: int) -> NDArray[np.uint8]:
        """At the gait's apex."""
        return np.repeat(self._start, count, axis=0)

    def advance(
        self, rows: NDArray[np.uint8], seed: int, time: int
    ) -> tuple[NDArray[np.uint8], NDArray[np.bool_]]:
        """A stride of each, on a step of its own."""
        after, fates = self._run(rows, seed, time, goes_on=True)
        stopped = (fates != FELL) & (_strides(after) == time)
        if stopped.any():
            after[stopped] = self.begin(int(np.count_nonzero(stopped)))
        return after, fates == FELL

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
        places = np.ascontiguousarray(rows[:, END.itemsize :])
        places[:, COUNT : COUNT + 4] = np.frombuffer(np.int32(time).tobytes(), dtype=np.uint8)
        sections = np.repeat(self.apex[None], count, axis=0)
        request = ensemble_of(self.runner, sections, 0, TOLERANCE, self.threads, None)
        ground = RoughGround(self.roughness, seed)
        cases, kept = c_cases([Case(self.runner, ground=ground, law=self.law)], time + 1, 1.0)
        request.cases, request.case_count = cases, 1
        request.checkpoints = ffi.cast("tdmf_ensemble_checkpoint *", ffi.from_buffer(places))
        request.goes_on = goes_on
        run(request, ends)
        del kept
        bytes_of_ends = ends.view(np.uint8).reshape(count, END.itemsize)
        return np.concatenate([bytes_of_ends, places], axis=1), ends["fate"].copy()

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


def _strides(rows: NDArray[np.uint8]) -> NDArray[np.intc]:
    strides: NDArray[np.intc] = _ends(rows)["strides"]
    return strides


def _features(away: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coordinates, bounded, and their products."""
    bounded = np.tanh(away)
    left, right = np.triu_indices(bounded.shape[1])
    return np.concatenate([bounded, bounded[:, left] * bounded[:, right]], axis=1)


def rare_falls(
    runner: Runner | Mapping[str, Given],
    roughness: float,
    *,
    walkers: int = 64,
    strides: int = 160,
    seed: int = 0,
    gait: Gait | None = None,
    law: AffineLaw | None = None,
    threads: int | None = None,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> RareFalls:
    """The mean number of strides until a fall that hardly ever comes, by multilevel splitting.

    Ground, start and fall are those of `strides_to_fall`, which waits for falls and serves where they come.
    Here `REPLICAS` independent runs keep so many walkers at each of `LEVELS` levels of danger.

    Parameters
    ----------
    runner : Runner or mapping of str to float
        Who runs: a runner, or start values by the unit's names and in its units, over the unit's own.
    roughness : float
        Standard deviation of a step, m.
    walkers : int, default 64
        Kept at each level.
    strides : int, default 160
        Of each walker in each run, of which the first quarter is forgotten.
    seed : int, default 0
        Of everything that is drawn.
    gait : Gait, optional
        What they start from; by default the gait that `find_gait` finds.
    law : AffineLaw, optional
        By which settings are made anew at each apex, as in `strides_to_fall`.
    threads : int, optional
        By default one for each processor. Results do not depend on it.
    progress : bool, default False
        A bar on stderr.
    fmu : Fmu, optional
        Whose start values hold; by default that of `fmu_path`.

    Returns
    -------
    RareFalls
        The mean with its confidence interval.

    Raises
    ------
    InputError
        A value is not allowed, the runner goes by the reduced map, or the law does not fit it.
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
    runner = Runner.of(runner, fmu)
    if runner.reduced:
        raise InputError(
            "runner by the reduced map is not allowed on rough ground; allowed: by the full model"
        )
    check_law(law, runner)
    roughness = checked("roughness", roughness, 1e-9, LARGEST)
    walkers = checked_whole("walkers", walkers, 8, MOST_WALKERS)
    strides = checked_whole("strides", strides, 8, MOST_STEPS)
    seed = checked_whole("seed", seed, 0, LAST_SEED)
    if gait is not None:
        check_is_gait(gait, "gait")
    start = periodic_gait(runner, fmu=fmu) if gait is None else gait
    chain = RoughRunner(start, roughness, law, threads)
    with progress_bar("rare falls", REPLICAS + 1, "runs", progress) as bar:
        scores, highest = chain.learn(seed % 2**32)
        bar.update()
        levels = levels_of(scores, highest, LEVELS)
        found = rare_event(chain, levels, keep=walkers, steps=strides, seed=seed, done=bar.update)
    return RareFalls(start.word, roughness, found)
