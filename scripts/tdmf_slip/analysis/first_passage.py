"""Mean number of strides until a runner falls on rough ground.

K. Byl and R. Tedrake, "Metastable walking machines", Int. J. Robot. Res. 28, 1040 (2009), measure the
stability of walkers that fall sooner or later by this mean first-passage time.
"""

from __future__ import annotations

import math
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked_whole, refusal
from ..errors import InputError, counted
from ..library.batch import Batch
from ..library.engine import FELL, UNDECIDED, UNSOLVED
from ..library.gait import Gait, check_is_gait
from ..library.ground import RoughGround, check_has_ground
from ..library.laws import Law, numbers_up_to
from ..library.runner import Runner
from ..library.settings import checked_values
from ..record import entries
from ..terminal.in_blocks import in_blocks, largest_block, sizes_of
from ..variables.parameters import RunnerLike
from .attraction import CONFIDENCE, NORMAL_QUANTILE
from .ball import TOLERANCE
from .search import periodic_gait

MAX_RUNNERS = 100_000_000
MAX_STRIDES = 1_000_000
STRIDES_IN_A_BLOCK = 200_000
"""Largest number of strides in a block with many runners: the library sees an interrupt between blocks."""


@dataclass(frozen=True, eq=False, repr=False)
class Falls:
    """Strides of a runner until it falls on rough ground."""

    runner: Runner
    """The runner that falls."""
    word: str
    """Word of the gait on level ground from which the runners start."""
    roughness: float
    """Standard deviation of a step, m."""

    @property
    def mean_strides(self) -> float:
        """Mean number of strides until the fall, including the one that ends in it; infinite if none fell."""
        raise NotImplementedError

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the mean; above, it may be open."""
        raise NotImplementedError

    def __repr__(self) -> str:
        """One line: the runner's gait, and the mean number of strides with its interval."""
        low, high = self.interval
        roughness = f"{self.roughness:.4g} {self.runner.label('m')}"
        return (
            f"<{type(self).__name__} of the gait {self.word} on steps of {roughness}: "
            f"{self.mean_strides:.4g} strides until the fall ({low:.4g} to {high:.4g})>"
        )

    def as_json(self) -> dict[str, object]:
        """The estimate as a plain object."""
        names = ("word", "roughness", "mean_strides", "interval")
        return {**self.runner.record(), **entries(self, *names), "confidence": CONFIDENCE}


@dataclass(frozen=True, repr=False)
class FirstPassage(Falls):
    """Strides until the fall, estimated from runners of whom some are still up at the end.

    The number of strides is taken as geometric, which it is once the start is forgotten. The estimate is then
    that of maximum likelihood, strides begun over falls: a runner still up is censored, its strides count and
    it has no fall (J. F. Lawless, Statistical Models and Methods for Lifetime Data, 2nd ed., 2003, ch. 2-4).
    """

    runners: int
    """Number of runners that ran."""
    falls: int
    """Number of runners that fell."""
    strides: int
    """Strides that all runners began, including those that end in a fall."""
    stopped: int = 0
    """Runners that came to stand before the last stride; they count as censored there."""
    unsolved: int = 0
    """Runners at which the solver failed; they count as censored, too."""

    def __repr__(self) -> str:
        """One line: the runner's gait, the mean with its interval, and how many runners fell."""
        return f"{super().__repr__()[:-1]}, {self.falls:,} of {counted(self.runners, 'runner')} fell>"

    @property
    def censored(self) -> int:
        """Runners that have not fallen."""
        return self.runners - self.falls

    @property
    def mean_strides(self) -> float:
        """Mean number of strides until the fall, including the one that ends in it; infinite if none fell."""
        return self.strides / self.falls if self.falls else math.inf

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the mean, by the likelihood ratio; above, it is open where none fell."""
        half = 0.5 * NORMAL_QUANTILE**2
        if self.falls == 0:
            return -1.0 / math.expm1(-half / self.strides), math.inf
        from scipy.optimize import brentq  # slow to load

        minimum = self._likelihood(self.mean_strides) - half

        def end(factor: float) -> float:
            outside = self.mean_strides
            while self._likelihood(outside) > minimum:
                outside *= factor
            logarithm = brentq(
                lambda log_mean: max(self._likelihood(math.exp(log_mean)), -1e300) - minimum,
                *sorted((math.log(self.mean_strides), math.log(outside))),
            )
            return math.exp(logarithm)

        return 1.0 if self.mean_strides == 1.0 else end(0.5), end(2.0)

    def _likelihood(self, mean: float) -> float:
        """Logarithm of the likelihood: each stride is a trial that ends in a fall with probability 1/mean."""
        if mean <= 1.0:
            return 0.0 if self.falls == self.strides else -math.inf
        return (self.strides - self.falls) * math.log1p(-1.0 / mean) - self.falls * math.log(mean)

    def as_json(self) -> dict[str, object]:
        """The estimate as a plain object."""
        counts = ("runners", "strides", "falls", "censored", "stopped", "unsolved")
        return super().as_json() | entries(self, *counts)


def count_falls(max_strides: int, batch: Batch) -> NDArray[np.int64]:
    """Numbers of falls, strides, stopped runners and unsolved runners of a batch."""
    run = batch.run(max_strides)
    falls = np.count_nonzero(run.fate == FELL)
    strides = run.strides.sum(dtype=np.int64) + falls
    stopped = np.count_nonzero((run.fate == UNDECIDED) & (run.strides < max_strides))
    return np.array([falls, strides, stopped, np.count_nonzero(run.fate == UNSOLVED)])


def strides_to_fall(
    runner: RunnerLike,
    roughness: float | RoughGround,
    runners: int = 1000,
    seed: int = 0,
    max_strides: int = 10_000,
    *,
    gait: Gait | None = None,
    law: Law | None = None,
    foot_x: ArrayLike | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> FirstPassage:
    """Estimate the mean number of strides until a runner falls on rough ground.

    The ground gains a random step at each apex, the first included; `RoughGround.steps` has those of each
    runner, numbered from 0. A runner whose foot is below its ground for a whole stride has fallen, too.
    Runners start from the gait on level ground, and run at a relative tolerance of 1e-5 a step.

    On ground with a patch, the gait is that without the patch. The patch is left behind sooner or later, so
    that strides until the fall are not geometric: use the number of falls, not the mean.

    Parameters
    ----------
    runner : as in `find_gait`
    roughness : float or RoughGround
        Standard deviation of a step, m; or ground with correlated steps, faces that trip or drawn friction,
        and with a seed of its own.
    runners : int, default 1000
        Number of runners, each on ground of its own.
    seed : int, default 0
        Seed of the ground.
    max_strides : int, default 10000
        Strides after which a runner is censored: its strides count, but it adds no fall.
    gait : Gait, optional
        Gait that the runners start from; by default that of `find_gait`.
    law : callable or AffineLaw, optional
        Law that sets values at each apex, the first included, from its height before the ground steps; see
        `Batch`. A function is called for each block of runners.
    foot_x : array_like of float, shape () or (runners,), or "random", optional
        Positions of the feet at the start, m, by default 0. With "random" they are drawn evenly, by the
        ground's seed, from the last stride before the patch, which then begins at any phase of a stride.
    executor, progress : as in `sweep`

    Returns
    -------
    FirstPassage
        The mean by maximum likelihood, with its confidence interval.

    Raises
    ------
    InputError
        A value is not allowed, the ground of the model cannot vary, or the law does not fit it.
    RunError
        There is no gait to start from, or see `run_blocks`.

    Examples
    --------
    >>> import tdmf_slip
    >>> rough = tdmf_slip.strides_to_fall({"ground.friction": 0.6}, 0.3, runners=100, max_strides=200)
    >>> rough.falls + rough.censored
    100
    """
    ground = roughness if isinstance(roughness, RoughGround) else RoughGround(roughness, seed)
    runners = checked_whole("runners", runners, 1, MAX_RUNNERS)
    max_strides = checked_whole("max_strides", max_strides, 1, MAX_STRIDES)
    runner, start = rough_start(runner, gait)
    feet = _feet(foot_x, start, runner, runners, ground.seed)
    largest = largest_block(max_strides, STRIDES_IN_A_BLOCK)
    sizes = sizes_of(runners, largest)
    batches = [
        Batch(
            runner,
            np.tile(start.apex, (count, 1)),
            ground,
            law,
            foot_x=feet[number * largest :][:count],
            first_number=number * largest,
            tolerance=TOLERANCE,
        )
        for number, count in enumerate(sizes)
    ]
    work = partial(count_falls, max_strides)
    with in_blocks(work, batches, "rough", "runners", executor, progress, sizes=sizes) as results:
        counts = np.sum([found for _, found in results], axis=0)
    return FirstPassage(runner, start.word, ground.roughness, runners, *map(int, counts))


def rough_start(runner: RunnerLike, gait: Gait | None) -> tuple[Runner, Gait]:
    """A runner whose ground may vary, and the gait from which it starts, found without a patch of ground."""
    runner = Runner(runner)
    check_has_ground(runner.model, "runner")
    if gait is not None:
        check_is_gait(gait, "gait")
        return runner, gait
    patch = {"ground.patch_end": runner["ground.patch_begin"]} if "ground.patch_begin" in runner else {}
    return runner, periodic_gait(runner.replace(patch))


def _feet(
    foot_x: ArrayLike | None, start: Gait, runner: Runner, runners: int, seed: int
) -> NDArray[np.float64]:
    """Positions of the feet at the start, shape (runners,)."""
    if isinstance(foot_x, str) and foot_x == "random":
        before = np.random.default_rng(seed).uniform(1.0, 2.0, runners)
        return runner["ground.patch_begin"] - before * float(start.stride["length"])
    if isinstance(foot_x, str):
        raise refusal("foot_x", foot_x, f'a finite number, ({runners},) of them, or "random"')
    feet = np.atleast_1d(numbers_up_to("foot_x", 0.0 if foot_x is None else foot_x, 1))
    feet = checked_values("foot.x", feet, "foot_x", {"runner": 0})
    if feet.size not in (1, runners):
        raise InputError(
            f'foot_x of shape {feet.shape}; allowed: a finite number, ({runners},) of them, or "random"'
        )
    return np.broadcast_to(feet.ravel(), (runners,)).copy()
