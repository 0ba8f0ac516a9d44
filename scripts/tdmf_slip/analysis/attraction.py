"""How much a gait attracts in all six coordinates of the section, and how hard a runner may be pushed."""

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import NDArray

from ..blocks.running import run_blocks
from ..checks import check_kind, checked_whole
from ..library import ensemble
from ..library.orbit import Orbit, check_orbit
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..terminal import progress
from .basin import STARTS_AT_ONCE
from .fates import fates

BOX: Mapping[str, tuple[float, float]] = {
    "com_height": (0.0, 4.0),
    "com_speed": (-2.0, 4.0),
    "leg_length": (0.5, 1.5),
    "leg_angle": (-1.6, 1.6),
    "leg_length_rate": (-2.0, 2.0),
    "leg_angle_rate": (-4.0, 4.0),
}
"""Of the section, over its scales: where starts are drawn from. The same for every gait, to compare them."""
CONFIDENCE = 0.95
NORMAL_QUANTILE = 1.959963984540054
"""Of CONFIDENCE, two-sided."""
FARTHEST = 5.0
"""Over the scales: beyond this no disturbance is tried."""
COARSE, REFINEMENTS = 500, 2
"""Tries along the line, and how often the interval between two of them is divided again."""
EDGE_TOLERANCE = 1e-8
"""Relative tolerance of a step there: a stride errs by less than a hundredth of what the tries are apart."""
MOST_SAMPLES = 100_000_000
DISTURBED: Mapping[str, str] = {
    "push_forward": "com_speed",
    "push_backward": "com_speed",
    "step_down": "com_height",
    "step_up": "com_height",
}
"""By disturbance: the coordinate of the section that it changes."""
SAMPLES = 4000
"""Starts drawn for each of many gaits."""


@dataclass(frozen=True)
class Volume:
    """A Monte-Carlo estimate of how much of the box `BOX` a gait attracts."""

    samples: int
    settled: int
    box: float
    """The box's own volume, in the section's scales."""
    unsolved: int = 0
    """Starts whose run the solver did not get through; they count as not settled."""

    @property
    def share(self) -> float:
        """Of the samples that settle."""
        return self.settled / self.samples

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the share, by Wilson's score: sound where nearly all or nothing settles."""
        z2 = NORMAL_QUANTILE**2 / self.samples
        middle = (self.share + 0.5 * z2) / (1.0 + z2)
        spread = math.sqrt(z2 * (self.share * (1.0 - self.share) + 0.25 * z2)) / (1.0 + z2)
        return max(0.0, middle - spread), min(1.0, middle + spread)

    @property
    def volume(self) -> tuple[float, float, float]:
        """Estimate, lower and upper end, in the section's scales."""
        low, high = self.interval
        return self.share * self.box, low * self.box, high * self.box

    def as_json(self) -> dict[str, object]:
        """The estimate as a plain object."""
        estimate, low, high = self.volume
        return {
            "samples": self.samples,
            "unsolved": self.unsolved,
            "share": self.share,
            "share_interval": list(self.interval),
            "volume": estimate,
            "volume_interval": [low, high],
            "confidence": CONFIDENCE,
            "box": {name: list(ends) for name, ends in BOX.items()},
        }


@dataclass(frozen=True)
class Drawing:
    """Random starts: a block of work. Its number, not its worker, decides what is drawn."""

    runner: Runner
    apex: tuple[float, ...]
    seed: int
    number: int
    count: int

    def starts(self) -> NDArray[np.float64]:
        """Uniform over the box."""
        source = np.random.default_rng([self.seed, self.number])
        low, high = np.array(list(BOX.values())).T
        return self.runner.scales * source.uniform(low, high, size=(self.count, len(COORDINATES)))


def count_fates(drawing: Drawing) -> NDArray[np.int64]:
    """How many of a block's starts have each of `ensemble.FATES`."""
    ends = fates(drawing.runner, drawing.apex, drawing.starts())
    counted: NDArray[np.int64] = np.bincount(ends["fate"], minlength=len(ensemble.FATES))
    return counted


def volume(
    gait: Orbit,
    samples: int,
    *,
    seed: int = 0,
    scheduler: str | None = None,
    workers: int | None = None,
    show_progress: bool = False,
) -> Volume:
    """Estimate the volume of a gait's region of attraction in all six coordinates.

    Parameters
    ----------
    gait : Orbit
        Stable.
    samples : int
        How many starts are drawn.
    seed : int, default 0
        Of the drawing.
    scheduler : str, optional
        Of a Dask cluster, see `run_blocks`. The result does not depend on who computes it.
    workers : int, optional
        Processes on this machine, by default one for each processor.
    show_progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Volume
        The share of the box `BOX` that settles, with its confidence interval.

    Raises
    ------
    InputError
        No gait, no samples, or no seed.
    """
    check_orbit(gait, "gait")
    samples = checked_whole("samples", samples, 1, MOST_SAMPLES)
    seed = checked_whole("seed", seed, 0, 2**63)
    counts = [min(STARTS_AT_ONCE, samples - done) for done in range(0, samples, STARTS_AT_ONCE)]
    runner = Runner(gait.runner.values)
    drawings = [Drawing(runner, tuple(gait.apex), seed, n, count) for n, count in enumerate(counts)]
    counted = np.zeros(len(ensemble.FATES), dtype=int)
    with (
        progress.bar("volume", samples, "starts", show_progress) as bar,
        run_blocks(count_fates, drawings, scheduler=scheduler, workers=workers) as results,
    ):
        for number, found in results:
            counted += found
            bar.update(counts[number])
    low, high = np.array(list(BOX.values())).T
    fate = dict(zip(ensemble.FATES, counted.tolist(), strict=True))
    return Volume(samples, fate["settled"], float(np.prod(high - low)), fate["unsolved"])


@dataclass(frozen=True)
class Robustness:
    """The largest disturbances at an apex that a runner is known to recover from, each by itself.

    Infinite where the largest that is tried, `FARTHEST`, is recovered from.
    """

    push_forward: float
    """Of the speed, m/s."""
    push_backward: float
    """Likewise, the other way."""
    step_down: float
    """Of the ground, m: the runner then starts so much higher."""
    step_up: float
    """Likewise, upwards."""

    def as_json(self) -> dict[str, float | None]:
        """The disturbances as a plain object."""
        values: dict[str, float] = asdict(self)
        return {name: value if math.isfinite(value) else None for name, value in values.items()}


def robustness(gait: Orbit) -> Robustness:
    """How far the region of attraction reaches from the gait's apex, without gap, in height and speed.

    Parameters
    ----------
    gait : Orbit
        Stable.

    Returns
    -------
    Robustness
        The largest pushes, m/s, and steps, m.

    Raises
    ------
    InputError
        No gait.
    """
    check_orbit(gait, "gait")
    reach = functools.partial(_reach, gait)
    return Robustness(
        push_forward=reach("push_forward", 1.0),
        push_backward=reach("push_backward", -1.0),
        step_down=reach("step_down", 1.0),
        step_up=reach("step_up", -1.0),
    )


def _reach(gait: Orbit, disturbance: str, direction: float) -> float:
    """The first disturbance that is not recovered from, between the tries of a line that is refined."""
    index = COORDINATES.index(DISTURBED[disturbance])
    runner = Runner(gait.runner.values)
    recovered, lost = 0.0, FARTHEST * runner.scales[index]
    for _ in range(REFINEMENTS):
        tries = np.linspace(recovered, lost, COARSE + 1)[1:]
        starts = np.tile(gait.apex, (COARSE, 1))
        starts[:, index] += direction * tries
        fails = np.flatnonzero(
            fates(runner, gait.apex, starts, tolerance=EDGE_TOLERANCE)["fate"] != ensemble.SETTLED
        )
        if not fails.size:
            return math.inf
        first = fails[0]
        recovered, lost = tries[first - 1] if first else recovered, tries[first]
    return float(recovered)


@dataclass(frozen=True)
class Attraction:
    """How stable a gait is, by the largest eigenvalue and by what it attracts."""

    friction: float
    word: str
    lambda_max: float
    volume: Volume
    robustness: Robustness


def measure(gait: Orbit) -> Attraction:
    """All of it for one gait, by one thread.

    Raises
    ------
    InputError
        No gait.
    """
    check_orbit(gait, "gait")
    return Attraction(
        gait.friction,
        gait.word,
        gait.lambda_max,
        volume(gait, SAMPLES, workers=1),
        robustness(gait),
    )


def measure_all(
    gaits: Sequence[Orbit], *, scheduler: str | None = None, workers: int | None = None
) -> list[Attraction]:
    """`measure` for many gaits, side by side; see `run_blocks`.

    Raises
    ------
    InputError
        Not gaits in a list.
    """
    check_kind(gaits, Sequence, "gaits", "Orbits in a list, as find_orbit gives")
    for gait in gaits:
        check_orbit(gait, "gaits")
    with run_blocks(measure, gaits, scheduler=scheduler, workers=workers) as results:
        return [found for _, found in sorted(results, key=lambda numbered: numbered[0])]
