"""Volume of a gait's region of attraction, and the disturbances that a runner recovers from."""

import functools
import math
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import NDArray

from ..checks import checked_whole
from ..errors import counted
from ..library.engine import FATES, SETTLED, UNSOLVED
from ..library.gait import Gait
from ..library.laws import Law
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..terminal.in_blocks import in_blocks, sizes_of
from .ball import STARTS_AT_ONCE, Ball, ball_of, check_attracts, fates

BOX: Mapping[str, tuple[float, float]] = {
    "com_height": (0.0, 4.0),
    "com_speed": (-2.0, 4.0),
    "leg_length": (0.5, 1.5),
    "leg_angle": (-1.6, 1.6),
    "leg_length_rate": (-2.0, 2.0),
    "leg_angle_rate": (-4.0, 4.0),
}
"""Box of the section, over its scales, from which starts are drawn. All gaits have the same box."""
CONFIDENCE = 0.95
NORMAL_QUANTILE = 1.959963984540054
"""Two-sided quantile of CONFIDENCE."""
MAX_SAMPLES = 100_000_000
FARTHEST = 5.0
"""Largest disturbance that is tried, over the scales."""
COARSE, REFINEMENTS = 500, 2
"""Number of tries along the line, and of refinements between two of them."""
EDGE_TOLERANCE = 1e-8
"""Relative tolerance of a step of the tries: a stride errs by less than a hundredth of their distance."""
DISTURBED: Mapping[str, str] = {
    "push_forward": "com_speed",
    "push_backward": "com_speed",
    "step_down": "com_height",
    "step_up": "com_height",
}
"""Coordinate of the section that each disturbance changes."""


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
    """Starts at which the solver failed; they count as not settled."""
    coordinates: tuple[str, ...] = COORDINATES
    """Coordinates of the box that are drawn; the reduced map has two."""

    def __repr__(self) -> str:
        """The share that settles, with its interval, in one line."""
        low, high = self.interval
        return (
            f"<Volume: {self.share:.4g} of the box settles ({low:.4g} to {high:.4g}), "
            f"{self.settled:,} of {counted(self.samples, 'start')}>"
        )

    @property
    def share(self) -> float:
        """Share of the samples that settle."""
        return self.settled / self.samples

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the share, by Wilson's score: sound where nearly all or nothing settles."""
        from scipy.stats import binomtest  # slow to load

        low, high = binomtest(self.settled, self.samples).proportion_ci(CONFIDENCE, "wilson")
        return float(low), float(high)

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


def starts_in_box(runner: Runner, seed: int, number: int, count: int) -> NDArray[np.float64]:
    """Starts of a block, uniform over the box, drawn by the seed and the number of the block."""
    source = np.random.default_rng([seed, number])
    low, high = np.array([BOX[name] for name in runner.coordinates]).T
    drawn: NDArray[np.float64] = runner.scales * source.uniform(low, high, size=(count, len(low)))
    return drawn


def _count_fates(
    gait: Gait, law: Law | None, ball: Ball | None, seed: int, block: tuple[int, int]
) -> NDArray[np.int64]:
    """Number of starts in a block, by its number and size, with each of `library.engine.FATES`."""
    starts = starts_in_box(gait.runner, seed, *block)
    found = fates(gait, starts, law=law, ball=ball, first_number=block[0] * STARTS_AT_ONCE)
    return np.bincount(found.fate, minlength=len(FATES))


def attraction_volume(
    gait: Gait,
    samples: int,
    *,
    seed: int = 0,
    law: Law | None = None,
    ball: Ball | str = "tested",
    executor: Executor | None = None,
    progress: bool = False,
) -> Volume:
    """Estimate the volume of a gait's region of attraction in all coordinates of the section.

    Starts are drawn uniformly over a large box around all gaits, `analysis.attraction.BOX`, and simulated
    until they settle on the gait or fall. In the reduced map the volume is an area.

    Parameters
    ----------
    gait : Gait
        A stable gait, or one that `law` makes stable.
    samples : int
        Number of starts.
    seed : int, default 0
        Seed of the starts.
    law : Law, optional
        Law that sets inputs from stride to stride.
    ball : Ball or str, default "tested"
        A start that enters this ball around the gait counts as settled: "tested", "proved", "none" or a
        ball, as in `basin`.
    executor : Executor, optional
        Runs blocks of starts; threads of this process by default. The result does not depend on it.
    progress : bool, default False
        Show the progress on stderr.

    Returns
    -------
    Volume
        The estimate with its confidence interval: `share` and `interval` of the box, `volume` in the
        section's scales.

    Raises
    ------
    InputError
        The gait attracts nothing, or an argument is out of its range.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait(friction=0.6)
    >>> low, high = tdmf_slip.attraction_volume(gait, 200).interval
    >>> 0.0 < low < high < 1.0
    True
    """
    check_attracts(gait, law)
    samples = checked_whole("samples", samples, 1, MAX_SAMPLES)
    seed = checked_whole("seed", seed, 0, 2**63)
    work = functools.partial(_count_fates, gait, law, ball_of(gait, ball, samples, law), seed)
    sizes = sizes_of(samples, STARTS_AT_ONCE)
    with in_blocks(work, [*enumerate(sizes)], "volume", "starts", executor, progress, sizes=sizes) as results:
        counted = np.sum([found for _, found in results], axis=0)
    coordinates = gait.runner.coordinates
    box = math.prod(high - low for low, high in (BOX[name] for name in coordinates))
    return Volume(samples, int(counted[SETTLED]), box, int(counted[UNSOLVED]), coordinates)


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
    """The disturbances of height and speed up to which the runner recovers from every smaller one, too."""
    check_attracts(gait, law)
    return Robustness(**{name: _reach(gait, law, name) for name in DISTURBED})


def _reach(gait: Gait, law: Law | None, disturbance: str) -> float:
    """The largest disturbance before the first that is not recovered from, on a line that is refined."""
    index = COORDINATES.index(DISTURBED[disturbance])
    direction = -1.0 if disturbance in ("push_backward", "step_up") else 1.0
    recovered, lost = 0.0, FARTHEST * gait.runner.scales[index]
    for _ in range(REFINEMENTS):
        tries = np.linspace(recovered, lost, COARSE + 1)[1:]
        starts = np.tile(gait.apex, (COARSE, 1))
        starts[:, index] += direction * tries
        found = fates(gait, starts, tolerance=EDGE_TOLERANCE, law=law)
        fails = np.flatnonzero(found.fate != SETTLED)
        if not fails.size:
            return math.inf
        first = fails[0]
        recovered, lost = tries[first - 1] if first else recovered, tries[first]
    return float(recovered)
