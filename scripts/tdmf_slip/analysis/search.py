"""The gait of a runner: near a guess, by settling, along the friction, or from starts everywhere.

The last search begins all over the section, with runners side by side. They settle on stable gaits. Newton's
method from where strides come back nearest finds unstable ones, too.
"""

import contextlib
from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import GaitNotFoundError, InputError, RunError, counted
from ..library.batch import Batch
from ..library.engine import UNSOLVED
from ..library.fixed_point import Closing, gait_near, settled_gait
from ..library.gait import Gait
from ..library.members import check_comes_down
from ..library.return_map import Along
from ..library.runner import Runner
from ..library.section import Apex, checked_apex
from ..library.shared_steps import SharedSteps, search_under_way, shares_steps
from ..numerics.newton import solve
from ..variables.parameters import RunnerLike
from ..variables.table import FRICTION, VARIABLES, Model
from ..variables.variable import Values
from .along import gaits_over

MAX_STRIDES = 150_000
"""Strides of all runners of a search, about a second of two processors."""
STEP_LIMIT = 50_000
"""Largest number of steps in a runner's first stride: a foot of a thousandth of the body takes 2,300 on
average."""
MAX_STEPS, MAX_NEWTON_STEPS = 100_000_000, 500_000
"""Largest number of steps of all runners together, and of Newton's method: about ten seconds each."""
BLOCK = 1_024
"""Runners in one call of the engine; the steps of all runners are counted after each call."""
STARTS = 16_384
"""Number of starts that are drawn."""
SEED = 2016
"""Seed of the drawing: a search gives the same gait each time."""
TOLERANCE = 1e-6
"""Relative tolerance of a step: where runners settle need not be known any better."""
ROUNDS = (0, 0, 1, 2, 4, 8, 16, 32, 64, 128)
"""Strides before each look at how near to its start a stride comes back."""
KEPT = 2_048
"""Runners that go on after each look: those whose strides come back nearest."""
PROMISING, MAX_TRIED = 12, 48
"""Largest number of points from which Newton's method begins: after each look, and in all."""
ITERATIONS, SHORTENINGS, GAIN = 20, 6, 0.9
"""Steps of each, lengths at which a step is tried, and the share of the residual that it may leave."""
APART = 1e-2
"""Distance, over the scales, within which a point near a tried one is not tried."""
SAME = 1e-6
"""Largest distance of gaits that count as one, over the scales."""
SETTLED = 1e-4
"""Distance, over the scales, to which a stride returns next to a gait."""
HEIGHTS, SPEEDS, ANGLES = (0.7, 1.3), (0.05, 3.0), (-1.2, 1.5)
"""Least and largest height in l0, of low apexes; speed in l0 sqrt(k/m); angle of the leg in rad."""
RISE = 0.6
"""Largest vertical speed at lift-off, in l0 sqrt(k/m): apexes are as high as gravity lets it take them."""
LENGTHS, RATES = (0.98, 1.02), (-0.3, 0.3)
"""Lengths of the leg, in l0, and rates of its turning, in sqrt(k/m)."""


@dataclass(frozen=True, eq=False)
class Spread:
    """Result of a search from starts all over the section."""

    gaits: tuple[Gait, ...]
    """Different ones: those that runners settle on first, then by the size of their largest eigenvalue."""
    starts: int
    """Number of starts that were drawn."""
    strides: int
    """Number of strides that were made."""
    steps: int
    """Solver steps, in these strides and in those that did not close."""
    events: int
    """Events in these steps."""
    given_up: int
    """Strides that were given up, most of them because they take too many steps."""

    def __str__(self) -> str:
        """A description of the starts that were tried."""
        made = counted(self.strides, "stride")
        if self.given_up:
            made += (
                f" in {counted(self.steps, 'step')} with {counted(self.events, 'event')}; "
                f"{self.given_up:,} more strides were given up, most of them because they take too many steps"
            )
        return f"{self.starts:,} random starts ({made})"


def starts_of(runner: Runner, count: int, seed: int = SEED) -> NDArray[np.float64]:
    """Apexes all over the part of the section where gaits may be."""
    source = np.random.default_rng(seed)
    scales = runner.c_model.scales
    weightless = scales.length / (scales.time**2 * runner["gravity"])
    heights = source.uniform(*HEIGHTS, count) + 0.5 * weightless * source.uniform(0.0, RISE, count) ** 2
    drawn = np.column_stack(
        [
            heights,
            np.exp(source.uniform(np.log(SPEEDS[0]), np.log(SPEEDS[1]), count)),
            source.uniform(*LENGTHS, count),
            source.uniform(*ANGLES, count),
            np.zeros(count),
            source.uniform(*RATES, count),
        ]
    )
    return drawn[:, : len(runner.coordinates)] * runner.scales


@shares_steps
def search_from_spread(
    runner: Runner, *, along: Along | None = None, max_gaits: int = 1, max_strides: int = MAX_STRIDES
) -> Spread:
    """Gaits of a runner from starts all over the section, but for those that lead backwards."""
    found = _Found(runner, along, search_under_way())
    runs = _Runs(runner, starts_of(runner, STARTS), max_strides)
    nearest: list[tuple[float, NDArray[np.float64]]] = []
    for apices, returns in runs.looks():
        order = np.argsort(returns)[:PROMISING]
        nearest += [(float(returns[k]), apices[k]) for k in order]
        for k in order[returns[order] < SETTLED]:
            found.try_from(apices[k])
        if found.stable >= max_gaits:
            break
    else:
        for _, apex in sorted(nearest, key=lambda pair: pair[0]):
            found.try_from(apex)
    gaits = sorted(found.gaits, key=lambda gait: (not gait.stable, gait.lambda_max))
    strides, steps, events = (sum(pair) for pair in zip(runs.done, found.work.done(), strict=True))
    return Spread(tuple(gaits), STARTS, strides, steps, events, runs.given_up)


class _Runs:
    """Runners side by side."""

    def __init__(self, runner: Runner, starts: NDArray[np.float64], max_strides: int) -> None:
        self.runner, self.apexes, self.max_strides = runner, starts, max_strides
        self.done = (0, 0, 0)
        self.given_up = 0

    def looks(self) -> Iterator[tuple[NDArray[np.float64], NDArray[np.float64]]]:
        """Ends of strides and their distances from the starts, over the scales, after each round."""
        for strides in ROUNDS:
            if strides:
                self.apexes = self._after(strides)[1]
            begins, ends = self._after(1)
            if not len(ends):
                return
            returns = np.linalg.norm((ends - begins) / self.runner.scales, axis=1)
            yield ends, returns
            self.apexes = ends[np.argsort(returns)[:KEPT]]

    def _after(self, strides: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Apexes from which all strides close, and their last apexes, within the strides that are left."""
        apexes = self.apexes[: (self.max_strides - self.done[0]) // strides]
        begins, ends = [apexes[:0]], [apexes[:0]]
        for first in range(0, len(apexes), BLOCK):
            made, steps, events = self.done
            if steps >= MAX_STEPS:
                break
            block = apexes[first : first + BLOCK]
            batch = Batch(self.runner, block, tolerance=TOLERANCE, step_limit=STEP_LIMIT)
            found = batch.run(strides)
            work = found.attributes["work_done"]
            self.done = made + work["strides"], steps + work["steps"], events + work["events"]
            self.given_up += int(np.count_nonzero(found.fate == UNSOLVED))
            closed = found.strides == strides
            begins.append(block[closed])
            ends.append(found.apex[closed])
        return np.concatenate(begins), np.concatenate(ends)


class _Found:
    """Gaits by Newton's method from one point after the other."""

    def __init__(self, runner: Runner, along: Along | None, work: SharedSteps) -> None:
        self.runner, self.closing, self.work = runner, Closing(runner, along=along), work
        self.gaits: list[Gait] = []
        self._tried: list[NDArray[np.float64]] = []

    @property
    def stable(self) -> int:
        """Number of stable gaits."""
        return sum(gait.stable for gait in self.gaits)

    def try_from(self, apex: NDArray[np.float64]) -> None:
        """Search from a point, unless a point near it was tried or belongs to a gait."""
        _, steps, _ = self.work.done()
        if (
            len(self._tried) >= MAX_TRIED
            or steps >= MAX_NEWTON_STEPS
            or self._is_near(apex, self._tried, APART)
        ):
            return
        self._tried.append(apex)
        with contextlib.suppress(InputError, RunError):
            near = solve(
                self.closing,
                apex / self.runner.scales,
                iterations=ITERATIONS,
                shortenings=SHORTENINGS,
                gain=GAIN,
            )
            gait = self.closing.gait(near.x * self.runner.scales)
            known = [other.apex for other in self.gaits]
            if gait.stride["length"] > 0.0 and not self._is_near(gait.apex, known, SAME):
                self.gaits.append(gait)

    def _is_near(
        self, apex: NDArray[np.float64], others: Sequence[NDArray[np.float64]], distance: float
    ) -> bool:
        return any(np.linalg.norm((apex - other) / self.runner.scales) < distance for other in others)


@shares_steps
def periodic_gait(
    runner: RunnerLike = None,
    guess: Apex | None = None,
    *,
    along: Along | None = None,
    model: str | Model | None = None,
) -> Gait:
    """The gait of `find_gait` without a target, differentiated along a parameter too where that is wanted."""
    runner = Runner(runner, model=model)
    if guess is not None:
        apex = checked_apex(guess, runner.coordinates)
        if not np.isfinite(apex).all():
            raise InputError(f"guess = {apex.tolist()} is not allowed; allowed: finite numbers")
        return gait_near(runner, apex, along=along)
    check_comes_down(runner)
    try:
        return settled_gait(runner, along=along)
    except RunError as problem:
        found, tried = _beyond_settling(runner, along)
        if found is None:
            raise GaitNotFoundError(
                f"{problem}; {tried}; if a gait exists, a guess near its apex may find it"
            ) from None
        return found if along in (None, found.along) else gait_near(runner, found.apex, along=along)


def _beyond_settling(runner: Runner, along: Along | None) -> tuple[Gait | None, str]:
    """A gait by the longer searches, or what was tried, in words."""
    found = _along_friction(runner)
    if found is not None:
        return found, ""
    spread = search_from_spread(runner, along=along)
    if spread.gaits:
        return spread.gaits[0], ""
    home = VARIABLES.start_of(FRICTION)
    way = f"by continuation from friction {home:g}, nor " if runner.get(FRICTION, home) != home else ""
    return None, f"nor was one found {way}from {spread}"


def _along_friction(runner: Runner) -> Gait | None:
    """The gait that is reached from the one at the unit's own friction; None where there is none."""
    home = VARIABLES.start_of(FRICTION)
    if runner.get(FRICTION, home) == home:
        return None
    try:
        start = settled_gait(runner.replace({FRICTION: home}), along=FRICTION)
        return next(gaits_over(runner, FRICTION, [runner[FRICTION]], start))
    except RunError:
        return None


def first_gait(
    runner: Runner, name: str, values: Values, thorough: Container[int]
) -> tuple[int, Gait | None, str]:
    """Number of the first value of a parameter with a gait, that gait, and why the first value has none.

    At values of the numbers in `thorough` the gait is searched for longer, at others it has to settle.
    """
    why = ""
    for number, value in enumerate(values):
        search = periodic_gait if number in thorough else settled_gait
        try:
            return number, search(runner.replace({name: float(value)})), why
        except RunError as problem:
            why = why or str(problem)
    return len(values), None, why
