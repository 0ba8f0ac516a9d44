"""Random ground: a step of its height at each apex and a friction for each stride, the same for a seed."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked, checked_whole
from ..errors import InputError
from ..given import row_of
from .binding import c, ffi

LARGEST = 1e9
"""Roughness, m."""
LARGEST_SPREAD = 10.0
"""Of the logarithm of friction."""
LAST_SEED = 2**64 - 1
LAST_RUNNER = 2**63 - 1
MAX_STEPS = 2**31 - 1


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
    power = np.asarray(density, dtype=float)
    if power.ndim != 1 or not 2 <= len(power) <= MAX_WEIGHTS // 2 or not np.all(np.isfinite(power)):
        raise InputError(
            f"density of shape {power.shape}; allowed: a row of 2 to {MAX_WEIGHTS // 2} finite numbers"
        )
    if np.any(power < 0.0) or not np.any(power):
        raise InputError("density: allowed: numbers of 0 or more, not all 0")
    count = 2 * len(power) - 1
    even = np.fft.irfft(np.sqrt(power), count)
    return _of_unit_size(np.roll(even, count // 2))


def _of_unit_size(weights: NDArray[Any]) -> tuple[float, ...]:
    return tuple((weights / np.linalg.norm(weights)).tolist())


@dataclass(frozen=True)
class RoughGround:
    """What a runner meets: steps by which the ground's height changes at its apices, and friction by stride.

    Both are drawn by a counter from the seed, the runner's number and the stride's: results do not depend on
    lanes, threads or workers.
    """

    roughness: float = 0.0
    """Standard deviation of a step, m; their mean is 0."""
    seed: int = 0
    """Of all steps, and of friction."""
    step_weights: tuple[float, ...] = ()
    """A step is the sum of weight j times the deviate of j strides before; none: each is its own deviate. See
    `correlated_weights` and `spectrum_weights`."""
    trips: bool = False
    """A foot that is below a step as it comes has met it, and the runner falls. By default it passes the step
    on its way up, and falls only where it stays below for a whole stride."""
    friction_spread: float = 0.0
    """Standard deviation of the logarithm of a stride's friction, about the runner's own."""
    friction_weights: tuple[float, ...] = ()
    """As those of the steps."""

    def __post_init__(self) -> None:
        """Refuse values out of range."""
        object.__setattr__(self, "roughness", checked("roughness", self.roughness, 0.0, LARGEST))
        object.__setattr__(self, "seed", checked_whole("seed", self.seed, 0, LAST_SEED))
        spread = checked("friction_spread", self.friction_spread, 0.0, LARGEST_SPREAD)
        object.__setattr__(self, "friction_spread", spread)
        for name in ("step_weights", "friction_weights"):
            object.__setattr__(self, name, _checked_weights(name, getattr(self, name)))

    @property
    def is_drawn(self) -> bool:
        """Something of it is."""
        return bool(self.roughness or self.friction_spread)

    def write(self, rules: Any) -> list[object]:
        """Write it into the rules of a case."""
        rules.roughness, rules.seed, rules.trips = self.roughness, self.seed, self.trips
        rules.friction_spread = self.friction_spread
        steps, friction = (
            ffi.new("double[]", list(weights)) if weights else ffi.NULL
            for weights in (self.step_weights, self.friction_weights)
        )
        rules.step_weights, rules.step_weight_count = steps, len(self.step_weights)
        rules.friction_weights, rules.friction_weight_count = friction, len(self.friction_weights)
        return [steps, friction]

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


def _checked_weights(name: str, weights: object) -> tuple[float, ...]:
    """As a tuple of numbers."""
    given = tuple(row_of(weights, name, "numbers in a row"))
    if len(given) > MAX_WEIGHTS:
        raise InputError(f"{name}: {len(given)} given; allowed: up to {MAX_WEIGHTS}")
    return tuple(checked(name, weight, -LARGEST, LARGEST) for weight in given)
