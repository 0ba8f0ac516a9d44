"""Gaits of one runner by the value of a parameter, and points of the branch that they make.

Lengths along a branch are measured over the coordinates' scales and one of the parameter.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.fixed_point import Closing, gait_near
from ..library.gait import Gait
from ..library.members import check_varied
from ..library.quantities import scales_of
from ..library.return_map import Along
from ..library.runner import Runner
from ..library.section import Apex
from ..library.strides import strides_from
from ..variables.variable import Given
from .corrector import corrected


@dataclass(frozen=True, eq=False)
class Point:
    """A gait on a branch."""

    gait: Gait
    """The gait."""
    value: float
    """Of the parameter."""
    tangent: NDArray[np.float64]
    """Unit tangent of the branch, over the scales: the coordinates, then the parameter."""

    @property
    def rises(self) -> bool:
        """The parameter grows along the branch."""
        return bool(self.tangent[-1] > 0.0)


class Family:
    """Gaits of one runner by the value of a parameter."""

    along: Along
    """By what the next apex is differentiated."""
    _last: tuple[float, Closing] | None = None

    def __init__(self, runner: Runner | Mapping[str, Given], name: str, strides: int = 1) -> None:
        """Whose gaits, over which parameter or input, and after how many strides they repeat themselves.

        The parameter's scale is its value in the runner, or 1.
        """
        check_varied(name, "name")
        self.runner = runner = Runner(runner)
        self.name = name
        self.along = name
        self.strides = strides
        self.scales = scales_of(runner, [name])

    def runner_at(self, value: float) -> Runner:
        """The runner at a value of the parameter, in its unit."""
        return self.runner.replace({self.name: value})

    def gait(self, value: float, guess: Apex, near: Gait | None = None) -> Gait:
        """The gait at a value near a guess; the Jacobian of a gait that is near may save strides."""
        return gait_near(self.runner_at(value), guess, self.strides, along=self.along, near=near)

    def strides_at(self, value: float, apex: Apex) -> Gait:
        """The strides from an apex at a value, whether they lead back to it or not."""
        return strides_from(self.runner_at(value), apex, self.strides, along=self.along)

    def value_of(self, gait: Gait) -> float:
        """The parameter's value, in its unit, at a gait of the family."""
        return gait.runner[self.name]

    def point(self, gait: Gait, along: NDArray[np.float64]) -> Point:
        """A gait as a point of its branch, which leads along a direction."""
        if gait.by_parameter is None or gait.along != self.along:
            gait = self.gait(self.value_of(gait), gait.apex)
        tangent = np.linalg.svd(self.rows(gait))[2][-1]
        return Point(gait, self.value_of(gait), tangent if tangent @ along >= 0.0 else -tangent)

    def points(self, *gaits: Gait) -> list[Point]:
        """Gaits of one branch as its points; it leads from the first to the last."""
        ends = [np.append(gait.apex, self.value_of(gait)) / self.scales for gait in gaits]
        return [self.point(gait, ends[-1] - ends[0]) for gait in gaits]

    def rows(self, gait: Gait) -> NDArray[np.float64]:
        """Derivatives of the residual by the apex and by the parameter, over the scales."""
        assert gait.by_parameter is not None
        dimension = len(gait.apex)
        rows: NDArray[np.float64]
        rows = np.hstack([gait.jacobian - np.eye(dimension), gait.by_parameter[:, None]])
        rows = rows * self.scales / self.scales[:-1, None]
        if not np.isfinite(rows).all():
            raise RunError(f"the gait at {self.name} = {self.value_of(gait):g} has no derivative")
        return rows

    def coordinates(self, point: Point) -> NDArray[np.float64]:
        """Apex and parameter of a point over the scales: the coordinates, then the parameter."""
        coordinates: NDArray[np.float64] = np.append(point.gait.apex, point.value) / self.scales
        return coordinates

    def evaluate(self, coordinates: NDArray[np.float64]) -> Gait:
        """The strides from an apex at a value of the parameter."""
        return self.strides_at(coordinates[-1] * self.scales[-1], coordinates[:-1] * self.scales[:-1])

    def residual(self, coordinates: NDArray[np.float64]) -> NDArray[np.float64]:
        """Residual of the strides from a point, over the scales."""
        return self._closing(coordinates).residual(coordinates[:-1])

    def linearize(self, coordinates: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The residual and its derivatives by apex and parameter."""
        residual, by_apex, along = self._closing(coordinates).varied(coordinates[:-1])
        return residual, np.hstack([by_apex, self.scales[-1] * along[:, None]])

    def _closing(self, coordinates: NDArray[np.float64]) -> Closing:
        """Equations at a value of the parameter.

        Those of the last value are kept, because points on a plane across the parameter have one value.
        """
        value = float(coordinates[-1] * self.scales[-1])
        if self._last is None or self._last[0] != value:
            self._last = value, Closing(self.runner_at(value), self.strides, self.along, self.scales[:-1])
        return self._last[1]

    def on_plane(
        self, goal: NDArray[np.float64], normal: NDArray[np.float64], near: Gait | None = None
    ) -> Point:
        """The point of the branch near a goal, on the plane across a direction there: by Newton's method.

        InputError where the goal itself is not allowed. Derivatives of a gait that is near may save strides.
        """
        rows = None if near is None else self.rows(near)
        try:
            try:
                found = corrected(self, goal, normal, rows=rows)
            except RunError:
                found = corrected(self, goal, normal, whole=True)
            return self.point(self.evaluate(found), normal)
        except RunError as problem:
            raise RunError(f"no gait near {self.name} = {goal[-1] * self.scales[-1]:g}: {problem}") from None

    def between(self, before: Point, after: Point, share: float) -> Point:
        """The point of the branch beside a share of the straight way from one point to the next."""
        begin, end = self.coordinates(before), self.coordinates(after)
        return self.on_plane(
            begin + share * (end - begin), (end - begin) / np.linalg.norm(end - begin), before.gait
        )

    def distance(self, before: Point, after: Point) -> float:
        """Between two points of a branch, over the scales."""
        return float(np.linalg.norm(self.coordinates(after) - self.coordinates(before)))
