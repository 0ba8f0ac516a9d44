"""Uneven ground: a profile of straight lines, and runs of the unit over it.

The unit knows one line of ground. A co-simulation gives it, at each communication point, the line of the
profile that is below the foot; the unit puts a new line in force as soon as the foot is in flight and not
below it. So a foot that stands keeps its ground, and one that hangs below a step passes it on its way up.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_kind, checked, checked_whole
from ..errors import InputError
from .instance import Instance, opened
from .simulation import MOST_ROWS, TIMES, longest_time, time_unit
from .unit import Fmu, load_fmu
from .variable import Given

STEPS_PER_TIME_UNIT = 20
"""Communication steps in each sqrt(m/k), unless one is given."""
HEIGHT, SLOPE = "ground.height", "ground.slope"
RECORDED = ("foot.x", "foot.y", "body.x", "body.y", "com.x", "com.y", "contact.normal", "ground.pending")
"""What is recorded of a run unless something else is asked for."""
ALWAYS = ("stride.count", "status.fallen")
"""What is recorded beside that."""
MOST_LINES = 10**7


@dataclass(frozen=True)
class Line:
    """A line of ground, y = height + x tan(slope)."""

    height: float
    """At x = 0, m."""
    slope: float
    """rad."""


class Profile:
    """Ground made of straight lines through points; beyond the first and the last it goes on level."""

    def __init__(self, x: ArrayLike, y: ArrayLike) -> None:
        """Ground through points, from left to right.

        Parameters
        ----------
        x : array_like of float, shape (points,)
            Horizontal places, m, ascending; one that is given twice is a step.
        y : array_like of float, shape (points,)
            Heights, m.

        Raises
        ------
        InputError
            Not two rows of finite numbers that are equally long, or places that go back.
        """
        try:
            self.x, self.y = (np.array(row, dtype=float) for row in (x, y))
        except (TypeError, ValueError):
            raise InputError("profile: allowed: two rows of numbers, places and heights") from None
        if self.x.ndim != 1 or self.x.shape != self.y.shape or not len(self.x):
            raise InputError(
                f"profile: places {self.x.shape} and heights {self.y.shape}; allowed: two rows equally long"
            )
        if not np.all(np.isfinite([self.x, self.y])):
            raise InputError("profile: places and heights have to be finite")
        if np.any(np.diff(self.x) < 0):
            raise InputError("profile: places have to be ascending, from left to right")

    @classmethod
    def steps(cls, edges: ArrayLike, heights: ArrayLike) -> "Profile":
        """Level ground with steps.

        Parameters
        ----------
        edges : array_like of float, shape (steps,)
            Where the ground's height changes, m, ascending.
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
        places, levels = np.atleast_1d(np.asarray(edges)), np.atleast_1d(np.asarray(heights))
        if places.ndim != 1 or levels.shape != (len(places) + 1,) or not len(places):
            raise InputError(
                f"profile: edges {places.shape} and heights {levels.shape}; allowed: a height more than edges"
            )
        return cls(np.repeat(places, 2), np.repeat(levels, 2)[1:-1])

    @classmethod
    def random_steps(
        cls, count: int, tread: float, roughness: float, seed: int, begin: float = 0.0
    ) -> "Profile":
        """Level ground up to `begin`, and then steps of a random walk.

        Parameters
        ----------
        count : int
            How many steps.
        tread : float
            Distance from step to step, m.
        roughness : float
            Standard deviation of a step's height, m; their mean is 0.
        seed : int
            The same seed makes the same ground.
        begin : float, default 0
            Where the first step is, m.

        Returns
        -------
        Profile
            With a riser at each step.

        Raises
        ------
        InputError
            A number that is not allowed.
        """
        count = checked_whole("count", count, 1, MOST_LINES)
        tread = checked("tread", tread, 1e-9, 1e9)
        roughness = checked("roughness", roughness, 0.0, 1e9)
        generator = np.random.Generator(np.random.Philox(checked_whole("seed", seed, 0, 2**63 - 1)))
        heights = np.cumsum(generator.normal(0.0, roughness, count)) if roughness else np.zeros(count)
        return cls.steps(begin + tread * np.arange(count), [0.0, *heights])

    def height(self, x: ArrayLike) -> NDArray[np.float64]:
        """Height of the ground at places, on an edge that of the ground behind it.

        Parameters
        ----------
        x : array_like of float
            Horizontal places, m.

        Returns
        -------
        ndarray of float
            Heights, m, shaped as `x`.
        """
        places = np.asarray(x, dtype=float)
        lines = [self.line(place) for place in places.ravel()]
        heights = np.array(
            [
                line.height + place * math.tan(line.slope)
                for line, place in zip(lines, places.ravel(), strict=True)
            ]
        )
        return heights.reshape(places.shape)

    @property
    def steepest(self) -> float:
        """The slope of the steepest line, rad; risers are none."""
        runs, rises = np.diff(self.x), np.diff(self.y)
        slopes = np.arctan2(rises, runs)[runs > 0]
        return float(max(slopes, key=abs, default=0.0))

    def line(self, x: float) -> Line:
        """The line of ground at a place, as the unit's inputs want it.

        Parameters
        ----------
        x : float
            Horizontal place, m.

        Returns
        -------
        Line
            Its height at x = 0, and its slope.
        """
        after = int(np.searchsorted(self.x, x, side="right"))
        if after in (0, len(self.x)):
            return Line(float(self.y[0 if after == 0 else -1]), 0.0)
        run = float(self.x[after] - self.x[after - 1])
        rise = float(self.y[after] - self.y[after - 1])
        return Line(float(self.y[after - 1]) - float(self.x[after - 1]) * rise / run, math.atan2(rise, run))


def simulate_over(
    profile: Profile,
    start_values: Mapping[str, Given] | None = None,
    *,
    strides: int | None = None,
    stop_time: float | None = None,
    communication_step: float | None = None,
    variables: Iterable[str] = RECORDED,
    fmu: Fmu | None = None,
) -> NDArray[np.void]:
    """Run the unit over a profile, in Co-Simulation; a fall ends the run and is a result.

    Parameters
    ----------
    profile : Profile
        The ground. The run begins over whatever line is below the foot.
    start_values : mapping of str to float, bool or str, optional
        By variable name, a number in the variable's unit or a text like `40 deg`.
    strides : int, optional
        End with the communication step in which so many strides have closed.
    stop_time : float, optional
        s. With `strides`, whichever comes first; one of them is needed.
    communication_step : float, optional
        s between two looks at what is below the foot; by default a twentieth of sqrt(m/k).
    variables : iterable of str, optional
        Names to record.
    fmu : Fmu, optional
        The unit to run; by default that of `fmu_path`.

    Returns
    -------
    structured ndarray, shape (rows,)
        A row at the start and after each communication step: `time`, the variables, `stride.count` and
        `status.fallen`.

    Raises
    ------
    InputError
        Something given is not allowed, by this package or by the unit.
    RunError
        The unit failed.

    Examples
    --------
    >>> import tdmf_slip
    >>> steps = tdmf_slip.Profile.random_steps(count=10, tread=7.0, roughness=0.02, seed=1, begin=20.0)
    >>> rows = tdmf_slip.simulate_over(steps, strides=2)
    >>> print(rows["stride.count"][-1], rows["status.fallen"][-1])
    2 False
    """
    fmu = load_fmu(fmu)
    starts = fmu.start_values(start_values, "start values")
    check_kind(profile, Profile, "profile", "a Profile")
    if strides is None and stop_time is None:
        raise InputError("strides, stop_time: neither is given; allowed: one of them, or both")
    most = math.inf if strides is None else checked_whole("strides", strides, 1, 10**9)
    end = (
        longest_time(fmu, starts, int(most)) if stop_time is None else checked("stop_time", stop_time, *TIMES)
    )
    step = communication_step
    step = (
        time_unit(fmu, starts) / STEPS_PER_TIME_UNIT
        if step is None
        else checked("communication_step", step, *TIMES)
    )
    names = list(dict.fromkeys([*(fmu.find(name, "variables").name for name in variables), *ALWAYS]))
    fmu.variables[SLOPE].value_of(profile.steepest, "profile, its steepest line")
    place = float(starts.get("foot.x", fmu.start_of("foot.x")))
    with opened(fmu, "cs") as instance:
        instance.start({**starts, **_inputs(profile, place)})
        rows = _rows(instance, profile, names, step, end, most)
    kinds = [("time", float), *((name, type(value)) for name, value in zip(names, rows[0][1:], strict=True))]
    return np.array(rows, dtype=kinds)


def _inputs(profile: Profile, place: float) -> dict[str, float]:
    line = profile.line(place)
    return {HEIGHT: line.height, SLOPE: line.slope}


def _rows(
    instance: Instance, profile: Profile, names: list[str], step: float, end: float, strides: float
) -> list[tuple[float | int | bool | str, ...]]:
    rows = [(0.0, *instance.read(names).values())]
    time = 0.0
    while time < end and not instance.boolean("status.fallen") and instance.integer("stride.count") < strides:
        if len(rows) > MOST_ROWS:
            raise InputError(
                f"communication_step = {step:g}: more than {MOST_ROWS:,} rows; allowed: a longer one"
            )
        instance.set(_inputs(profile, instance.real("foot.x")))
        instance.advance(time, step)
        time = len(rows) * step
        rows.append((time, *instance.read(names).values()))
    return rows
