"""Gaits of one runner by the value of a parameter, and points of the branch that they make.

Lengths along a branch are measured over the coordinates' scales and one of the parameter.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.members import check_varied
from ..library.orbit import Orbit, orbit_near
from ..library.return_map import stride_from
from ..library.runner import Runner
from ..library.section import Apex
from ..unit.variable import Given

NEWTON_ITERATIONS = 12
NEWTON_CONVERGED = 1e-10


@dataclass(frozen=True)
class Point:
    """A gait on a branch."""

    orbit: Orbit
    """The gait."""
    value: float
    """Of the parameter."""
    direction: NDArray[np.float64]
    """Unit tangent of the branch, over the scales: the coordinates, then the parameter."""

    @property
    def rises(self) -> bool:
        """The parameter grows along the branch."""
        return bool(self.direction[-1] > 0.0)


class Family:
    """Gaits of one runner by the value of a parameter."""

    def __init__(self, runner: Runner | Mapping[str, Given], name: str) -> None:
        """Whose gaits, and over which parameter or input; its scale is its value in the runner, or 1.

        Raises
        ------
        InputError
            No such parameter or input, or what is given makes no runner.
        """
        check_varied(name, "name")
        self.runner = runner = Runner.of(runner)
        self.name = name
        self.scales = np.append(runner.scales, abs(runner.values[name]) or 1.0)

    def orbit(self, value: float, guess: Apex) -> Orbit:
        """The gait at a value near a guess.

        Parameters
        ----------
        value : float
            Of the parameter.
        guess : sequence of float, shape (n,)
            An apex near the gait's.

        Returns
        -------
        Orbit
            Differentiated by the parameter, too.

        Raises
        ------
        InputError
            The value is not allowed.
        RunError
            There is none.
        """
        return orbit_near(self.runner.but(self.name, value), guess, along=self.name)

    def value_of(self, orbit: Orbit) -> float:
        """Of the parameter.

        Parameters
        ----------
        orbit : Orbit
            A gait of the family.

        Returns
        -------
        float
            In the parameter's unit.
        """
        return orbit.runner.values[self.name]

    def point(self, orbit: Orbit, along: NDArray[np.float64]) -> Point:
        """A gait as a point of its branch, which leads along a direction.

        Parameters
        ----------
        orbit : Orbit
            The gait.
        along : ndarray of float, shape (n + 1,)
            Coordinates and parameter, over the scales.

        Returns
        -------
        Point
            With its tangent.

        Raises
        ------
        RunError
            The gait has no tangent.
        """
        if orbit.by_parameter is None or orbit.along != self.name:
            orbit = self.orbit(self.value_of(orbit), orbit.apex)
        assert orbit.by_parameter is not None
        rows = (
            np.hstack([orbit.jacobian - np.eye(len(orbit.apex)), orbit.by_parameter[:, None]]) * self.scales
        )
        if not np.isfinite(rows).all():
            raise RunError(f"the gait at {self.name} = {self.value_of(orbit):g} has no derivative")
        tangent = np.linalg.svd(rows)[2][-1]
        return Point(orbit, self.value_of(orbit), tangent if tangent @ along >= 0.0 else -tangent)

    def place(self, point: Point) -> NDArray[np.float64]:
        """Apex and parameter over the scales.

        Parameters
        ----------
        point : Point
            On a branch.

        Returns
        -------
        ndarray of float, shape (n + 1,)
            Coordinates, then the parameter.
        """
        place: NDArray[np.float64] = np.append(point.orbit.apex, point.value) / self.scales
        return place

    def on_plane(self, goal: NDArray[np.float64], normal: NDArray[np.float64]) -> Point:
        """The point of the branch near a goal, on the plane across a direction there: by Newton's method.

        Parameters
        ----------
        goal : ndarray of float, shape (n + 1,)
            Apex and parameter over the scales.
        normal : ndarray of float, shape (n + 1,)
            A unit vector along the branch.

        Returns
        -------
        Point
            Where branch and plane meet.

        Raises
        ------
        InputError
            A value of the parameter is not allowed.
        RunError
            There is none.
        """
        where = f"no gait near {self.name} = {goal[-1] * self.scales[-1]:g}"
        place, scales = goal.copy(), self.scales[:-1]
        for _ in range(NEWTON_ITERATIONS):
            runner = self.runner.but(self.name, place[-1] * self.scales[-1])
            try:
                apex, jacobian, by_parameter = stride_from(runner, place[:-1] * scales, self.name)
            except RunError as problem:
                raise RunError(f"{where}: {problem}") from None
            across = (
                np.hstack([jacobian - np.eye(len(apex)), by_parameter[:, None]])
                * self.scales
                / scales[:, None]
            )
            residual = np.append(apex / scales - place[:-1], (place - goal) @ normal)
            try:
                change = np.linalg.solve(np.vstack([across, normal]), -residual)
            except np.linalg.LinAlgError:
                break
            place = place + change
            if np.max(np.abs(change)) < NEWTON_CONVERGED:
                return self.point(self.orbit(place[-1] * self.scales[-1], place[:-1] * scales), normal)
        raise RunError(where)

    def between(self, before: Point, after: Point, share: float) -> Point:
        """The point of the branch beside a share of the straight way from one point to the next.

        Parameters
        ----------
        before, after : Point
            On the branch.
        share : float
            From 0 at `before` to 1 at `after`.

        Returns
        -------
        Point
            On the branch.

        Raises
        ------
        RunError
            There is none.
        """
        begin, end = self.place(before), self.place(after)
        return self.on_plane(begin + share * (end - begin), (end - begin) / np.linalg.norm(end - begin))

    def distance(self, before: Point, after: Point) -> float:
        """Between two points, over the scales.

        Parameters
        ----------
        before, after : Point
            On a branch.

        Returns
        -------
        float
            A pure number.
        """
        return float(np.linalg.norm(self.place(after) - self.place(before)))
