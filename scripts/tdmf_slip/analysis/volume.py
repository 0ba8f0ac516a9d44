"""How much a gait attracts in all six coordinates of the section, by random starts."""

import math
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..blocks import run_blocks
from ..checks import checked_whole
from ..library.engine import FATES, SETTLED, UNSOLVED
from ..library.gait import Gait
from ..library.laws import Law
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..terminal.progress import progress_bar
from .ball import Ball, ball_of
from .controlled_gait import check_attracts
from .fates import STARTS_AT_ONCE, fates

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
MAX_SAMPLES = 100_000_000


@dataclass(frozen=True)
class Volume:
    """A Monte-Carlo estimate of how much of the box `BOX` a gait attracts."""

    samples: int
    """Starts that were drawn."""
    settled: int
    """So many of them settled on the gait."""
    box: float
    """The box's own volume, in the section's scales."""
    unsolved: int = 0
    """Starts whose run the solver did not get through; they count as not settled."""
    coordinates: tuple[str, ...] = COORDINATES
    """Those of the box that are drawn: in the reduced map two."""

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
            "box": {name: list(BOX[name]) for name in self.coordinates},
        }


@dataclass(frozen=True, eq=False)
class Drawing:
    """Random starts: a block of work. Its number, not its worker, decides what is drawn."""

    runner: Runner
    """Whose starts."""
    apex: tuple[float, ...]
    """The gait's, shape (n,)."""
    seed: int
    """Of the whole estimate."""
    number: int
    """Of the block."""
    count: int
    """Starts in it."""
    law: Law | None = None
    """By which runners are set."""
    ball: Ball | None = None
    """In which a start has settled."""

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
