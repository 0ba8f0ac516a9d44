"""Borders between words over two parameters: located on lines across their curve."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.gait import Gait
from ..library.runner import Runner
from ..numerics.halving import halved
from .bifurcations import WORD_BORDER, Special
from .borders import Crossing, crossings
from .branch import Branch
from .continuation import walk
from .curve import CLOSED, LONGEST, SHORTEST, Box, Curve
from .family import Family
from .meeting import PointSet
from .walking_back import RETURNED

Pair = NDArray[np.float64]
"""Two parameters over their scales."""
SHORTEST_PART = 0.02
"""Of the way from one line to the next: a shorter step shows that the gait does not go on."""
WIDTHS = (0.25, 0.5, 1.0)
"""Of the lines to both sides of where a border is expected, over the step to there."""
SAME = 1e-6
"""Two points of a curve that are as near, over the scales, are one."""


class Line(Family):
    """Gaits of one runner on a line through the plane of two parameters, by how far they are along it."""

    def __init__(
        self, runner: Runner, names: tuple[str, str], sizes: Pair, origin: Pair, way: Pair, strides: int = 1
    ) -> None:
        """Origin and unit direction are over the parameters' scales `sizes`."""
        self.runner, self.names, self.sizes, self.strides = runner, names, sizes, strides
        self.name = " and ".join(names)
        self.origin, self.way = origin, way
        self.along = dict(zip(names, map(float, way * sizes), strict=True))
        self.scales = np.append(runner.scales, 1.0)

    def runner_at(self, value: float) -> Runner:
        """The runner at a distance along the line."""
        values = (self.origin + value * self.way) * self.sizes
        return self.runner.replace(dict(zip(self.names, map(float, values), strict=True)))

    def value_of(self, gait: Gait) -> float:
        """How far along the line a gait is."""
        return float((self.pair(gait) - self.origin) @ self.way)

    def pair(self, gait: Gait) -> Pair:
        """The parameters of a gait over their scales."""
        return np.array([gait.runner[name] for name in self.names]) / self.sizes


def border_near(
    runner: Runner,
    names: tuple[str, str],
    sizes: Pair,
    known: Crossing,
    step: Pair,
) -> tuple[Pair, Crossing]:
    """The point of a curve of word borders a step away from one that is known."""
    length = float(np.linalg.norm(step))
    across = np.array([-step[1], step[0]]) / length
    gaits = [known.short.gait, known.beyond.gait]
    plain = Line(runner, names, sizes, np.zeros(2), across)
    here, goal = plain.pair(gaits[0]), plain.pair(gaits[0]) + step
    if (plain.pair(gaits[1]) - here) @ across < 0.0:
        across = -across
    words = known.border.before, known.border.after
    for width in WIDTHS:
        line = Line(runner, names, sizes, goal, across)
        try:
            ends = [
                _walked(line, gait, goal + way * width * length * across)
                for gait, way in zip(gaits, (-1.0, 1.0), strict=True)
            ]
            if (ends[0].word, ends[1].word) != words and width < WIDTHS[-1]:
                continue
            for crossing in crossings(line, *line.points(*ends)):
                if (crossing.border.before, crossing.border.after) == words:
                    return goal + crossing.border.value * across, crossing
        except (InputError, RunError):
            continue
    raise RunError(f"no border from {words[0]} to {words[1]} goes on")


def _walked(line: Line, gait: Gait, end: Pair) -> Gait:
    """The gait at other parameters, by steps on the straight way there; differentiated along the line."""
    begin = line.pair(gait)
    length = float(np.linalg.norm(end - begin))
    way = Line(line.runner, line.names, line.sizes, begin, (end - begin) / length, line.strides)
    first = way.gait(0.0, gait.apex)
    *_, last = walk(way, first, 0.0, length, SHORTEST_PART)
    return line.gait(line.value_of(last), last.apex)


def border_curve(
    runner: Runner,
    names: tuple[str, str],
    sizes: NDArray[np.float64],
    box: Box,
    branch: Branch,
    special: Special,
    max_points: int,
    tell: Callable[[], None],
) -> Curve:
    """The curve of a word border, both ways."""
    family = Family(branch.gaits[0].runner, names[0])
    around = family.points(*branch.gaits[special.index : special.index + 2])
    known = next(c for c in crossings(family, *around) if (c.border.before, c.border.after) == special.words)
    here = BorderPoint(np.array([special.value, runner[names[1]]]) / sizes, known)
    track = BorderTrack(runner, names, sizes, [here])
    back, began = _border_followed(track, box, here, -1.0, max_points, tell)
    forth: list[BorderPoint] = []
    ended = began
    if began != CLOSED:
        forth, ended = _border_followed(track, box, here, 1.0, max_points, tell)
    points = np.array([point.pair for point in (*back[::-1], here, *forth)]) * sizes
    return Curve(runner, WORD_BORDER, names, points, began, ended, special.words)


@dataclass(frozen=True, eq=False)
class BorderPoint:
    """A point of a curve of borders."""

    pair: Pair
    """Where it is."""
    crossing: Crossing
    """The gaits on both sides."""


class BorderTrack:
    """A curve of borders as far as it has been followed."""

    def __init__(
        self, runner: Runner, names: tuple[str, str], sizes: Pair, points: Sequence[BorderPoint]
    ) -> None:
        """Whose gaits, over which parameters with which scales, and where it has been already."""
        self.runner, self.names, self.sizes = runner, names, sizes
        self._points: list[BorderPoint] = []
        self._rows = PointSet(len(runner.scales) + len(names))
        for point in points:
            self.add(point)

    def add(self, point: BorderPoint) -> None:
        """One more point."""
        self._points.append(point)
        self._rows.add(self._row(point))

    def _row(self, point: BorderPoint) -> NDArray[np.float64]:
        return np.append(point.crossing.short.gait.apex / self.runner.scales, point.pair)

    def near(self, known: BorderPoint, step: Pair) -> BorderPoint:
        """The point of the curve a step away from one that is known."""
        return BorderPoint(*border_near(self.runner, self.names, self.sizes, known.crossing, step))

    def stepped(self, last: BorderPoint, step: Pair) -> BorderPoint:
        """The point a step away, if the same step back leads to where it came from."""
        found = self.near(last, step)
        way = self._row(found) - self._row(last)
        back = self.near(found, last.pair - found.pair)
        if np.linalg.norm(self._row(back) - self._row(last)) > RETURNED * np.linalg.norm(way):
            raise RunError("no border is found that leads back")
        return found

    def met(self, last: BorderPoint, following: BorderPoint) -> BorderPoint | None:
        """The point of the track that the curve goes through in its next step, or None."""
        for number, beside in self._rows.beside(self._row(last), self._row(following)):
            point = self._points[number]
            try:
                found = self.near(last, beside[-2:] - last.pair)
            except (InputError, RunError):
                continue
            if np.linalg.norm(self._row(found) - self._row(point)) < SAME:
                return point
        return None


def _border_followed(
    track: BorderTrack,
    box: Box,
    last: BorderPoint,
    sign: float,
    max_points: int,
    tell: Callable[[], None],
) -> tuple[list[BorderPoint], str]:
    """The curve of a border from a point on, without it, and why it stops."""
    way = np.array([0.0, sign])
    found: list[BorderPoint] = []
    step = 0.1
    while len(found) < max_points:
        longest = LONGEST / np.max(np.abs(way) / box.size)
        try:
            following, step = halved(partial(_stepped, track, last, longest * way), step, SHORTEST / LONGEST)
        except (InputError, RunError) as problem:
            return found, f"lost: {problem}"
        tell()
        if box.outside(following.pair):
            share = box.share(last.pair, following.pair)
            edge = last.pair + share * (following.pair - last.pair)
            return [*found, BorderPoint(edge, following.crossing)], "edge of the ranges"
        again = track.met(last, following)
        if again is not None:
            return [*found, again], CLOSED
        way = (following.pair - last.pair) / np.linalg.norm(following.pair - last.pair)
        found.append(following)
        track.add(following)
        last, step = following, min(1.0, 2.0 * step)
    return found, f"number of points: {max_points}"


def _stepped(track: BorderTrack, last: BorderPoint, way: Pair, share: float) -> BorderPoint:
    """The point of a border a share of a way further."""
    return track.stepped(last, share * way)
