"""Random ground, the same for a seed: steps and friction by stride, or level segments of a terrain."""

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked, checked_flag, checked_whole, number_in, path_of, shown
from ..errors import InputError, reason
from ..given import numbers_of, row_of
from ..variables.table import MODELS, Model
from .binding import c

LARGEST = 1e9
"""Largest roughness, m."""
MIN_SEGMENT = 1e-3
"""Shortest segment, over l0; the library refuses shorter ones."""
LARGEST_SPREAD = 10.0
"""Largest standard deviation of the logarithm of friction."""
LAST_SEED = 2**64 - 1
LAST_RUNNER = 2**63 - 1
MAX_STEPS = 2**31 - 1


BARE_COMMA = re.compile(r"\d,\d")
BLANK = re.compile(r"\d\s+[\d.+-]")
"""White space alone between two numbers."""
MAX_WEIGHTS = 4096
WEIGHTLESS = 1e-12
"""Weights of a correlation end where they are less."""


def correlated_weights(correlation: float) -> tuple[float, ...]:
    """Weights of deviates of which each is correlated with the one before, the farther ones by its powers."""
    correlation = checked("correlation", correlation, -0.99, 0.99)
    if correlation == 0.0:
        return ()
    count = math.ceil(math.log(WEIGHTLESS) / math.log(abs(correlation)))
    return _of_unit_size(correlation ** np.arange(count + 1))


def spectrum_weights(density: ArrayLike) -> tuple[float, ...]:
    """Weights of deviates that have a given spectrum."""
    power = numbers_of("density", density)
    if power.ndim != 1 or not 2 <= len(power) <= MAX_WEIGHTS // 2 or not np.all(np.isfinite(power)):
        raise InputError(
            f"density of shape {power.shape}; allowed: a row of 2 to {MAX_WEIGHTS // 2} finite numbers"
        )
    if np.any(power < 0.0) or not np.any(power):
        raise InputError(
            "density: has a negative number, or all are 0; allowed: numbers of 0 or more, not all 0"
        )
    count = 2 * len(power) - 1
    even = np.fft.irfft(np.sqrt(power), count)
    return _of_unit_size(np.roll(even, count // 2))


def _of_unit_size(weights: NDArray[Any]) -> tuple[float, ...]:
    return tuple((weights / np.linalg.norm(weights)).tolist())


@dataclass(frozen=True)
class RoughGround:
    """Random ground: steps by which its height changes at the apices of a runner, and friction by stride.

    Both are drawn by a counter from the seed, the runner's number and the stride's: results do not depend on
    lanes, threads or workers. With a `segment_length` the ground is a terrain instead: level segments, each
    with a height and a friction of its own, of which the foot meets the one below it.

    Segment k reaches from x = k `segment_length` to the next, to which the edge between them belongs; foot
    and ground begin at x = 0. No edge is missed. A stance belongs to the segment on which it begins: a foot
    that slips over an edge keeps its height and its friction until it lifts off. A foot that swings into the
    face of a segment passes that step on its way up; until then the segment from which it came goes on below.
    """

    roughness: float = 0.0
    """Standard deviation of a step, or of the height of a segment, m; their mean is 0."""
    seed: int = 0
    """Seed of all steps, and of friction."""
    step_weights: tuple[float, ...] = ()
    """A step is the sum of weight j times the deviate of j strides before; none: each is its own deviate. See
    `correlated_weights` and `spectrum_weights`."""
    trips: bool = False
    """True if the runner falls when its foot is below a step that it meets. By default the foot passes the
    step on its way up, and the runner falls only if the foot stays below for a whole stride. On a terrain a
    foot trips where it swings or slips into the face of a segment."""
    friction_spread: float = 0.0
    """Standard deviation of the logarithm of a stride's friction, about the runner's own."""
    friction_weights: tuple[float, ...] = ()
    """Weights of the friction's deviates, like `step_weights`."""
    segment_length: float = 0.0
    """Length of level segments, m, at least `MIN_SEGMENT` l0. Each segment then has its own height and
    friction, drawn by its number. By default, each stride has them."""
    heights: tuple[float, ...] = ()
    """Heights of the segments, m, instead of drawn ones. They repeat after the last one, and runner n begins
    on segment n."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        object.__setattr__(self, "roughness", checked("roughness", self.roughness, 0.0, LARGEST))
        object.__setattr__(self, "seed", checked_whole("seed", self.seed, 0, LAST_SEED))
        spread = checked("friction_spread", self.friction_spread, 0.0, LARGEST_SPREAD)
        object.__setattr__(self, "friction_spread", spread)
        object.__setattr__(self, "trips", checked_flag("trips", self.trips))
        for name in ("step_weights", "friction_weights"):
            object.__setattr__(self, name, _checked_weights(name, getattr(self, name)))
        object.__setattr__(
            self, "segment_length", checked("segment_length", self.segment_length, 0.0, LARGEST)
        )
        object.__setattr__(self, "heights", _checked_heights(self.heights))
        if self.heights and not self.segment_length:
            raise InputError("heights without a segment_length; allowed: segment_length above 0 m")
        if self.heights and self.roughness:
            raise InputError(
                f"roughness = {self.roughness:g} with heights; allowed: one of them, the other left out"
            )

    @property
    def is_drawn(self) -> bool:
        """True if the ground differs from that of the runner's inputs."""
        return bool(self.roughness or self.friction_spread or self.segment_length)

    @property
    def rules(self) -> dict[str, Any]:
        """Rules of the ground for the engine, by name."""
        names = ("roughness", "seed", "trips", "friction_spread", "step_weights", "friction_weights")
        return {name: getattr(self, name) for name in names}

    @property
    def terrain(self) -> dict[str, Any]:
        """Segments of the ground for the engine."""
        return {"length": self.segment_length, "heights": self.heights}

    def check_runner(self, values: Mapping[str, float | bool], scales: NDArray[np.float64]) -> None:
        """Refuse short segments (`scales[0]` is l0), and on a terrain a push or ground not level."""
        if not self.segment_length:
            return
        shortest = MIN_SEGMENT * float(scales[0])
        if self.segment_length < shortest:
            raise InputError(
                f"segment_length = {self.segment_length:g} m is not allowed; allowed: {shortest:g} m or more"
            )
        for name in ("ground.slope", "body.external_fx", "body.external_fy"):
            if values.get(name, 0.0) != 0.0:
                raise InputError(f"{name} = {values[name]:g} on a terrain (segment_length); allowed: 0")

    def frictions(self, runner: int, count: int) -> NDArray[np.float64]:
        """Factors of the friction in the first strides of one runner."""
        return np.exp(
            self.friction_spread * self._drawn(c.tdmf_friction_deviate, self.friction_weights, runner, count)
        )

    def _drawn(
        self, deviate: Callable[..., float], weights: tuple[float, ...], runner: int, count: int
    ) -> NDArray[np.float64]:
        runner = checked_whole("runner", runner, 0, LAST_RUNNER)
        strides = range(checked_whole("count", count, 0, MAX_STEPS))
        if not weights:
            return np.array([deviate(self.seed, runner, n) for n in strides], float)
        before = len(weights) - 1
        numbers = [n % 2**32 for n in range(-before, len(strides))]
        drawn = np.array([deviate(self.seed, runner, n) for n in numbers], float)
        return np.convolve(drawn, weights, "valid") if len(strides) else np.zeros(0)

    def steps(self, runner: int, count: int) -> NDArray[np.float64]:
        """The first steps of one runner."""
        return self.roughness * self._drawn(c.tdmf_ground_step, self.step_weights, runner, count)

    def segment_heights(self, runner: int, count: int) -> NDArray[np.float64]:
        """Heights of the first segments below one runner, from x = 0 on, m over its `ground.height`."""
        if not self.segment_length:
            raise InputError(
                "segment_length = 0: this ground steps at each apex and has no segments; allowed: above 0"
            )
        if not self.heights:
            return self.steps(runner, count)
        runner = checked_whole("runner", runner, 0, LAST_RUNNER)
        segments = runner + np.arange(checked_whole("count", count, 0, MAX_STEPS))
        return np.array(self.heights)[segments % len(self.heights)]


def check_has_ground(model: Model, what: str) -> None:
    """Refuse a model whose ground is one line everywhere."""
    if not model.has_ground:
        name = "reduced map" if model is MODELS["reduced"] else f"model {model.name}"
        raise InputError(
            f"{what}: the {name} has no ground that varies from place to place; allowed: the full model, and "
            "models of one's own whose page is a subclass of tdmf_slip.pages.Runner"
        )


def read_heights(path: str) -> tuple[float, ...]:
    """Heights of segments from a file.

    Parameters
    ----------
    path : str
        A text file with numbers, m, separated by white space or commas; what follows a `#` is a comment. A
        comma between two digits may be a decimal sign: it is refused unless other numbers have a decimal
        point.

    Returns
    -------
    tuple of float
        In their order.

    Raises
    ------
    InputError
        There is no such file, or what is in it are no numbers.
    """
    try:
        text = path_of(path, "heights", "the path of a file").read_text(encoding="utf-8-sig")
    except (OSError, ValueError) as problem:
        raise InputError(f"{path}: {reason(problem)}; allowed: a text file of heights in m") from None
    lines = [line.partition("#")[0] for line in text.splitlines()]
    with_points = any("." in line for line in lines)
    heights = []
    for number, line in enumerate(lines, 1):
        bare = BARE_COMMA.search(line)
        if bare and (not with_points or BLANK.search(line)):
            raise InputError(
                f"{path}, line {number}: {shown(line.strip())}: the comma may be between two numbers, or in "
                "one; allowed: decimal points, with a comma and a space between numbers"
            )
        try:
            heights += [number_in(word) for word in line.replace(",", " ").split()]
        except ValueError:
            raise InputError(
                f"{path}, line {number}: {shown(line.strip())} is not a height; allowed: numbers, in m"
            ) from None
    if not heights:
        raise InputError(f"{path}: has no heights; allowed: one or more numbers, in m")
    return _checked_heights(heights)


def _checked_heights(heights: object) -> tuple[float, ...]:
    given = tuple(row_of(heights, "heights", "numbers in a row, m"))
    return tuple(checked("heights", height, -LARGEST, LARGEST) for height in given)


def _checked_weights(name: str, weights: object) -> tuple[float, ...]:
    """A row of numbers as a tuple."""
    given = tuple(row_of(weights, name, "numbers in a row"))
    if len(given) > MAX_WEIGHTS:
        raise InputError(f"{name}: {len(given)} given; allowed: up to {MAX_WEIGHTS}")
    return tuple(checked(name, weight, -LARGEST, LARGEST) for weight in given)
