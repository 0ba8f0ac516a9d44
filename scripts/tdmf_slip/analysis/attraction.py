"""How stable gaits are: by the largest eigenvalue, by what they attract, and by what is recovered from."""

import functools
import math
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import NDArray

from ..blocks import in_order, run_blocks
from ..checks import check_kind, checked_whole
from ..library.engine import FATES, SETTLED, UNSOLVED
from ..library.gait import Gait, check_is_gait
from ..library.laws import Law
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..terminal.progress import progress_bar
from .ball import STARTS_AT_ONCE, Ball, ball_of, check_attracts, fates

BOX: Mapping[str, tuple[float, float]] = {
    "com_height": (0.0, 4.0),
    "com_speed": (-2.0, 4.0),
    "leg_length": (0.5, 1.5),
    "leg_angle": (-1.6, 1.6),
    "leg_length_rate": (-2.0, 2.0),
    "leg_angle_rate": (-4.0, 4.0),
}
"""Box of the section, over its scales, from which starts are drawn: one for all gaits, to compare them."""
CONFIDENCE = 0.95
NORMAL_QUANTILE = 1.959963984540054
"""Two-sided quantile of CONFIDENCE."""
MAX_SAMPLES = 100_000_000
FARTHEST = 5.0
"""Over the scales: beyond this no disturbance is tried."""
COARSE, REFINEMENTS = 500, 2
"""Tries along the line, and how often the interval between two of them is divided again."""
EDGE_TOLERANCE = 1e-8
"""Relative tolerance of a step there: a stride errs by less than a hundredth of what the tries are apart."""
DISTURBED: Mapping[str, str] = {
    "push_forward": "com_speed",
    "push_backward": "com_speed",
    "step_down": "com_height",
    "step_up": "com_height",
}
"""Coordinate of the section that each disturbance changes."""
SAMPLES = 4000
"""Starts drawn for each of many gaits."""


@dataclass(frozen=True)
class Volume:
    """A Monte-Carlo estimate of how much of the box `BOX` a gait attracts."""

    samples: int
    """Number of starts that were drawn."""
    settled: int
    """Number of samples that settled on the gait."""
    box: float
    """The box's own volume, in the section's scales."""
    unsolved: int = 0
    """Starts whose run the solver did not get through; they count as not settled."""
    coordinates: tuple[str, ...] = COORDINATES
    """Coordinates of the box that are drawn: in the reduced map two."""

    @property
    def share(self) -> float:
        """Share of the samples that settle."""
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
            "box": {name: list(BOX[name]) for name in self.coordinates},
        }


@dataclass(frozen=True, eq=False)
class Drawing:
    """Random starts: a block of work. Its number, not its worker, decides what is drawn."""

    runner: Runner
    """The runner."""
    apex: tuple[float, ...]
    """Apex of the gait, shape (n,)."""
    seed: int
    """Seed of the whole estimate."""
    number: int
    """Number of the block."""
    count: int
    """Number of starts in it."""
    law: Law | None = None
    """Law that sets the runners, if any."""
    ball: Ball | None = None
    """Ball of attraction in which a start has settled, if any."""

    def starts(self) -> NDArray[np.float64]:
        """Uniform over the box."""
        source = np.random.default_rng([self.seed, self.number])
        low, high = np.array([BOX[name] for name in self.runner.coordinates]).T
        return self.runner.scales * source.uniform(low, high, size=(self.count, len(low)))


def count_fates(drawing: Drawing) -> NDArray[np.int64]:
    """Number of starts in a block with each of `library.engine.FATES`."""
    found = fates(
        drawing.runner,
        drawing.apex,
        drawing.starts(),
        law=drawing.law,
        ball=drawing.ball,
        first_number=drawing.number * STARTS_AT_ONCE,
    )
    counted: NDArray[np.int64] = np.bincount(found.fate, minlength=len(FATES))
    return counted


def volume(
    gait: Gait,
    samples: int,
    *,
    seed: int = 0,
    law: Law | None = None,
    ball: Ball | str = "tested",
    executor: Executor | None = None,
    progress: bool = False,
) -> Volume:
    """Estimate the volume of a gait's region of attraction in all coordinates: an area in the reduced map."""
    check_attracts(gait, law)
    samples = checked_whole("samples", samples, 1, MAX_SAMPLES)
    seed = checked_whole("seed", seed, 0, 2**63)
    counts = [min(STARTS_AT_ONCE, samples - done) for done in range(0, samples, STARTS_AT_ONCE)]
    around = ball_of(gait, ball, samples, law)
    runner = gait.runner
    drawings = [
        Drawing(runner, tuple(gait.apex), seed, n, count, law, around) for n, count in enumerate(counts)
    ]
    counted = np.zeros(len(FATES), dtype=int)
    with (
        progress_bar("volume", samples, "starts", progress) as bar,
        run_blocks(count_fates, drawings, executor) as results,
    ):
        for number, found in results:
            counted += found
            bar.update(counts[number])
    low, high = np.array([BOX[name] for name in runner.coordinates]).T
    settled, unsolved = int(counted[SETTLED]), int(counted[UNSOLVED])
    return Volume(samples, settled, float(np.prod(high - low)), unsolved, runner.coordinates)


@dataclass(frozen=True)
class Robustness:
    """The largest disturbances at an apex that a runner is known to recover from, each by itself.

    Infinite where the largest that is tried, `FARTHEST`, is recovered from.
    """

    push_forward: float
    """Increase of the speed, m/s."""
    push_backward: float
    """Decrease of the speed, m/s."""
    step_down: float
    """Drop of the ground, m: the runner then starts so much higher."""
    step_up: float
    """Rise of the ground, m."""

    def as_json(self) -> dict[str, float | None]:
        """The disturbances as a plain object."""
        values: dict[str, float] = asdict(self)
        return {name: value if math.isfinite(value) else None for name, value in values.items()}


def robustness(gait: Gait, law: Law | None = None) -> Robustness:
    """How far the region of attraction reaches from the gait's apex, without gap, in height and speed."""
    check_attracts(gait, law)
    reach = functools.partial(_reach, gait, law)
    return Robustness(
        push_forward=reach("push_forward", 1.0),
        push_backward=reach("push_backward", -1.0),
        step_down=reach("step_down", 1.0),
        step_up=reach("step_up", -1.0),
    )


def _reach(gait: Gait, law: Law | None, disturbance: str, direction: float) -> float:
    """The first disturbance that is not recovered from, between the tries of a line that is refined."""
    index = COORDINATES.index(DISTURBED[disturbance])
    runner = gait.runner
    recovered, lost = 0.0, FARTHEST * runner.scales[index]
    for _ in range(REFINEMENTS):
        tries = np.linspace(recovered, lost, COARSE + 1)[1:]
        starts = np.tile(gait.apex, (COARSE, 1))
        starts[:, index] += direction * tries
        found = fates(runner, gait.apex, starts, tolerance=EDGE_TOLERANCE, law=law)
        fails = np.flatnonzero(found.fate != SETTLED)
        if not fails.size:
            return math.inf
        first = fails[0]
        recovered, lost = tries[first - 1] if first else recovered, tries[first]
    return float(recovered)


@dataclass(frozen=True)
class Attraction:
    """How stable a gait is, by the largest eigenvalue and by what it attracts."""

    friction: float
    """Friction coefficient of the ground."""
    word: str
    """Word of the gait."""
    lambda_max: float
    """Size of the largest eigenvalue."""
    volume: Volume
    """How much of the box settles on the gait."""
    robustness: Robustness
    """The largest disturbances that the runner recovers from."""


def measure(gait: Gait) -> Attraction:
    """All of it for one gait."""
    check_is_gait(gait, "gait")
    return Attraction(
        gait.friction,
        gait.word,
        gait.lambda_max,
        volume(gait, SAMPLES),
        robustness(gait),
    )


def measure_all(gaits: Sequence[Gait], *, executor: Executor | None = None) -> list[Attraction]:
    """`measure` for many gaits, side by side; see `run_blocks`."""
    check_kind(gaits, Sequence, "gaits", "Gaits in a list, as find_gait gives")
    for gait in gaits:
        check_is_gait(gait, "gaits")
    with run_blocks(measure, gaits, executor) as results:
        return in_order(results)
