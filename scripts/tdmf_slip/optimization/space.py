"""The parameters that are varied, each as a share of the way from its lower bound to its upper one."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..library.runner import Runner

AT_BOUND = 1e-9
"""Of the width of the bounds: what is as near to one is at it."""
ROUNDING = 1e-14
"""Distance from a bound, over the width, that rounding may leave."""


@dataclass(frozen=True, eq=False)
class Space:
    """Parameters and inputs between bounds."""

    bounds: Mapping[str, tuple[float, float]]
    """By name: the lower and the upper one, in the unit's unit."""

    @property
    def low(self) -> NDArray[np.float64]:
        """The lower bounds, shape (d,)."""
        return np.array([low for low, _ in self.bounds.values()])

    @property
    def high(self) -> NDArray[np.float64]:
        """The upper bounds, shape (d,)."""
        return np.array([high for _, high in self.bounds.values()])

    @property
    def width(self) -> NDArray[np.float64]:
        """From bound to bound, shape (d,)."""
        return self.high - self.low

    def values(self, at: NDArray[np.float64]) -> dict[str, float]:
        """The parameters' values, by name, at shares of the way from bound to bound.

        A share that rounding keeps from a bound is at the bound.
        """
        near = np.round(at)
        at = np.where(np.abs(at - near) <= ROUNDING, near, at)
        values = (1.0 - at) * self.low + at * self.high
        return dict(zip(self.bounds, map(float, values), strict=True))

    def runner_at(self, runner: Runner, at: NDArray[np.float64]) -> Runner:
        """A runner with the values of a point in the space."""
        return runner.replace(self.values(at))

    def coordinates_of(self, runner: Runner) -> NDArray[np.float64]:
        """Where a runner's values are, inside the bounds from 0 to 1, shape (d,)."""
        values = np.array([runner[name] for name in self.bounds])
        coordinates: NDArray[np.float64] = (values - self.low) / self.width
        return coordinates

    def active(self, at: NDArray[np.float64]) -> dict[str, str]:
        """By name of the parameters that are at a bound: `lower` or `upper`."""
        coordinates = dict(zip(self.bounds, at, strict=True))
        low = {name: "lower" for name, share in coordinates.items() if share <= AT_BOUND}
        return low | {name: "upper" for name, share in coordinates.items() if share >= 1.0 - AT_BOUND}
