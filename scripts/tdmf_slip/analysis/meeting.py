"""Where a branch or a curve meets itself: it is closed there, or has come back over what it has been at."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from .family import Family, Point
from .walking_back import leads_back

SAME = 1e-8
"""Two points of a branch that are as near are one."""
BESIDE = 0.5
"""Of a step: a point that is farther from the straight way is not gone through."""
AT_FIRST = 64
"""So many points there is room for at first."""


class PointSet:
    """Points in a row, and those that are beside a straight way."""

    def __init__(self, dimension: int) -> None:
        """Without any point yet."""
        self._rows = np.empty((AT_FIRST, dimension))
        self._count = 0

    def __getitem__(self, number: int) -> NDArray[np.float64]:
        """A point by its number."""
        coordinates: NDArray[np.float64] = self._rows[: self._count][number]
        return coordinates

    def add(self, coordinates: NDArray[np.float64]) -> None:
        """One more point."""
        if self._count == len(self._rows):
            self._rows = np.concatenate([self._rows, np.empty_like(self._rows)])
        self._rows[self._count] = coordinates
        self._count += 1

    def beside(
        self, begin: NDArray[np.float64], end: NDArray[np.float64]
    ) -> Iterator[tuple[int, NDArray[np.float64]]]:
        """The numbers of points beside a straight way, and the nearest point on it to each."""
        way = end - begin
        away = self._rows[: self._count] - begin
        shares = away @ way / (way @ way)
        off = np.linalg.norm(away - shares[:, None] * way, axis=1)
        found = (shares > 0.0) & (shares <= 1.0) & (off <= BESIDE * np.linalg.norm(way))
        for number in np.flatnonzero(found):
            yield int(number), begin + shares[number] * way


class Track:
    """The points at which a branch has been, each with the apexes of all strides of its gait."""

    def __init__(self, family: Family, points: Sequence[Point]) -> None:
        """Whose branch it is, and where it has been already."""
        self.family = family
        self._points: list[Point] = []
        self._visited = PointSet(len(family.scales))
        for point in points:
            self.add(point)

    def add(self, point: Point) -> None:
        """One more point."""
        self._points.append(point)
        for apex in (point.gait.apex, *point.gait.following):
            self._visited.add(np.append(apex, point.value) / self.family.scales)

    def met(self, last: Point, following: Point) -> tuple[Point, str] | None:
        """The point of the track that the branch goes through in its next step."""
        for number, beside in self._visited.beside(
            self.family.coordinates(last), self.family.coordinates(following)
        ):
            if self._goes_through(self._visited[number], beside, last, following):
                number, stride = divmod(number, self.family.strides)
                return self._points[number], self._reported(self._points[number], following, stride)
        return None

    def is_new(self, points: Sequence[Point]) -> bool:
        """The branch has not been yet where it leads along some points."""
        return all(self.met(*pair) is None for pair in pairwise(points))

    def _goes_through(
        self, coordinates: NDArray[np.float64], beside: NDArray[np.float64], last: Point, following: Point
    ) -> bool:
        """The branch beside a point of the track is at it, and leads to both points.

        Close to where the branch turns sharply, the corrector finds gaits of both sides from one point.
        """
        way = self.family.coordinates(following) - self.family.coordinates(last)
        try:
            found = self.family.on_plane(beside, way / np.linalg.norm(way), last.gait)
        except (InputError, RunError):
            return False
        if np.linalg.norm(self.family.coordinates(found) - coordinates) >= SAME:
            return False
        return all(leads_back(self.family, found, other) for other in (last, following))

    def _reported(self, point: Point, following: Point, stride: int) -> str:
        where = f"back at the gait at {self.family.name} = {point.value:g}"
        if stride:
            return f"retraced: {where}, begun by another of its strides"
        if point.tangent @ following.tangent > 0.0:
            return f"closed: {where}"
        return f"retraced: {where}, from the other side"
