"""Uneven ground: a profile of straight lines."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked, checked_whole
from ..errors import InputError, counted
from ..given import numbers_of

MAX_LINES = 10**7
FARTHEST = 1e9
"""Largest position, tread and roughness, m."""


@dataclass(frozen=True)
class Line:
    """A line of ground, y = height + x tan(slope)."""

    height: float
    """Height at x = 0, m."""
    slope: float
    """Slope, rad."""


class Profile:
    """Ground made of straight lines through points; beyond the first and the last it goes on level.

    Examples
    --------
    >>> import tdmf_slip
    >>> ramp = tdmf_slip.Profile([0.0, 10.0], [0.0, 1.0])
    >>> print(ramp.height([-5.0, 5.0, 20.0]))
    [0.  0.5 1. ]
    """

    def __init__(self, x: ArrayLike, y: ArrayLike) -> None:
        """Ground through points, from left to right.

        Parameters
        ----------
        x : array_like of float, shape (points,)
            Horizontal positions, m, ascending; one that is given twice is a step.
        y : array_like of float, shape (points,)
            Heights, m.

        Raises
        ------
        InputError
            Not two rows of finite numbers that are equally long, or positions that go back.
        """
        self.x = numbers_of("profile: positions", x, "numbers in a row, m")
        self.y = numbers_of("profile: heights", y, "numbers in a row, m")
        if self.x.ndim != 1 or self.x.shape != self.y.shape or not len(self.x):
            raise InputError(
                f"profile: positions {self.x.shape} and heights {self.y.shape}; "
                "allowed: two rows equally long"
            )
        if not np.all(np.isfinite([self.x, self.y])):
            raise InputError("profile: positions and heights have to be finite")
        if np.any(np.diff(self.x) < 0):
            raise InputError("profile: positions have to be ascending, from left to right")

    def __repr__(self) -> str:
        """The number of points, with the ranges of their positions and heights."""
        at, high = (f"{np.min(row):g} to {np.max(row):g} m" for row in (self.x, self.y))
        return f"<Profile of {counted(len(self.x), 'point')}: positions {at}, heights {high}>"

    @classmethod
    def steps(cls, edges: ArrayLike, heights: ArrayLike) -> Profile:
        """Level ground with steps.

        Parameters
        ----------
        edges : array_like of float, shape (steps,)
            Positions at which the height changes, m, ascending.
        heights : array_like of float, shape (steps + 1,)
            Heights before the first edge, between the edges, and after the last, m.

        Returns
        -------
        Profile
            With a riser at each edge.

        Raises
        ------
        InputError
            Not such rows.
        """
        positions = np.atleast_1d(numbers_of("profile: edges", edges, "numbers in a row, m"))
        levels = np.atleast_1d(numbers_of("profile: heights", heights, "numbers in a row, m"))
        if positions.ndim != 1 or levels.shape != (len(positions) + 1,) or not len(positions):
            raise InputError(
                f"profile: edges {positions.shape} and heights {levels.shape}; "
                "allowed: a height more than edges"
            )
        return cls(np.repeat(positions, 2), np.repeat(levels, 2)[1:-1])

    @classmethod
    def random_steps(
        cls, count: int, tread: float, roughness: float, seed: int, begin: float = 0.0
    ) -> Profile:
        """Level ground up to `begin`, and then steps of a random walk.

        Parameters
        ----------
        count : int
            Number of steps.
        tread : float
            Distance from step to step, m.
        roughness : float
            Standard deviation of a step's height, m; their mean is 0.
        seed : int
            The same seed makes the same ground.
        begin : float, default 0
            Position of the first step, m.

        Returns
        -------
        Profile
            With a riser at each step.

        Raises
        ------
        InputError
            A number that is not allowed.
        """
        count = checked_whole("count", count, 1, MAX_LINES)
        tread = checked("tread", tread, 1e-9, FARTHEST)
        roughness = checked("roughness", roughness, 0.0, FARTHEST)
        begin = checked("begin", begin, -FARTHEST, FARTHEST)
        generator = np.random.Generator(np.random.Philox(checked_whole("seed", seed, 0, 2**63 - 1)))
        heights = np.cumsum(generator.normal(0.0, roughness, count)) if roughness else np.zeros(count)
        return cls.steps(begin + tread * np.arange(count), [0.0, *heights])

    def height(self, x: ArrayLike) -> NDArray[np.float64]:
        """Height of the ground at positions, on an edge that of the ground behind it.

        Parameters
        ----------
        x : array_like of float
            Horizontal positions, m.

        Returns
        -------
        ndarray of float
            Heights, m, shaped as `x`.
        """
        positions = numbers_of("x", x, "numbers, m")
        lines = [self.line(position) for position in positions.ravel()]
        heights = np.array(
            [
                line.height + position * math.tan(line.slope)
                for line, position in zip(lines, positions.ravel(), strict=True)
            ]
        )
        return heights.reshape(positions.shape)

    @property
    def steepest(self) -> float:
        """The slope of the steepest line, rad; risers are none."""
        runs, rises = np.diff(self.x), np.diff(self.y)
        slopes = np.arctan2(rises, runs)[runs > 0]
        return float(max(slopes, key=abs, default=0.0))

    def line(self, x: float) -> Line:
        """The line of ground at a position, as the unit's inputs want it.

        Parameters
        ----------
        x : float
            Horizontal position, m.

        Returns
        -------
        Line
            Its height at x = 0, and its slope.
        """
        x = checked("x", x, -sys.float_info.max, sys.float_info.max)
        after = int(np.searchsorted(self.x, x, side="right"))
        if after in (0, len(self.x)):
            return Line(float(self.y[0 if after == 0 else -1]), 0.0)
        run = float(self.x[after] - self.x[after - 1])
        rise = float(self.y[after] - self.y[after - 1])
        return Line(float(self.y[after - 1]) - float(self.x[after - 1]) * rise / run, math.atan2(rise, run))
