"""Follow a curve of solutions of any equations by predictor and corrector.

A curve is given by a `Problem` with one equation less than it has unknowns. Unknowns are over their scales,
and the last ones are parameters, which have ranges. `follow` predicts by a cubic through the last two points,
or along the tangent, and corrects on the plane across the tangent. A step counts only if it can be walked
back: the corrector that starts from the new point's tangent has to find the old point. Otherwise the step may
have led to another curve that comes near.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import dropwhile, pairwise
from typing import Any

import numpy as np

from ..errors import InputError, RunError
from .newton import Matrix, Vector, solve
from .walking import halved

SHORTEST_STEP = 1e-7
"""Length over the scales: where no step of this length finds a point, the curve ends or has a corner."""
SHARP = 1e-4
"""Steps up to this length may turn by any angle."""
STRAIGHT = 0.9
"""Least cosine between the tangents at both ends of a longer step."""
FARTHEST, NEAR = 0.5, 10.0
"""Largest distance of a point from its prediction, over the step: in a longer step, and at a corner."""
RETURNED = 1e-3
"""Share of a step: Newton's method that comes as near to a known point would find it."""
ON_EDGE = 1e-9
"""Share of a range: a point this near to an end of the range is on the edge."""
TRUSTED = 0.1
"""Largest distance of an extrapolated point from the one along the tangent, over the step."""
BESIDE = 0.5
"""Share of a step: the step does not pass points farther from its straight way."""
BEYOND = (1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
"""Distances beyond a corner at which the map of the other side is evaluated."""
MAX_BACK = 100
"""Largest number of steps from beyond a corner back to it."""
ITERATIONS, SHORTENINGS = 24, 12
"""Largest number of Newton's steps, and of lengths at which each is tried."""
CLOSED = "closed: back where it has been"
"""Reason why a curve ended that met itself."""


@dataclass(frozen=True, eq=False)
class Point:
    """A point of a curve."""

    x: Vector
    """Unknowns over the scales, shape (n,)."""
    tangent: Vector
    """Unit tangent of the curve, shape (n,)."""
    gait: Any
    """Solution at the point as the problem describes it, such as a `Gait`."""
    rows: Matrix
    """Jacobian of the residual, shape (n - 1, n)."""
    before: Point | None = None
    """Point before it on the curve, from which the next one is extrapolated."""

    @property
    def rises(self) -> bool:
        """True if the last unknown grows along the curve."""
        return bool(self.tangent[-1] > 0.0)

    def reversed(self) -> Point:
        """The same point with its tangent the other way."""
        return replace(self, tangent=-self.tangent)

    def along(self, direction: Vector) -> Point:
        """The same point with its tangent along a direction."""
        return self if self.tangent @ direction >= 0.0 else self.reversed()

    def extrapolated(self, goal: Vector, across: Vector) -> Vector:
        """Prediction of the next point, on the plane across a direction through a goal.

        A cubic has the places and tangents of this point and the one before. Where it meets the plane too far
        from the goal, or where there is no point before, the prediction is the goal.
        """
        if self.before is None:
            return goal
        way = self.before.x - self.x
        length, reach = across @ way, across @ (goal - self.x)
        with np.errstate(divide="ignore", invalid="ignore"):  # where a tangent is in the plane
            slope, slope_before = (one.tangent / (across @ one.tangent) for one in (self, self.before))
            share, off = reach / length, way - length * slope
            turn = length * (slope_before - slope)
            bend = 3.0 * off - turn + share * (turn - 2.0 * off)
            guess: Vector = self.x + reach * slope + share**2 * bend
        return guess if np.linalg.norm(guess - goal) <= TRUSTED * abs(reach) else goal


@dataclass(frozen=True, eq=False)
class Limits:
    """Ranges of the parameters, and lengths and number of the steps."""

    low: Vector
    """Least value of each parameter, in its unit."""
    high: Vector
    """Largest value of each parameter."""
    max_step: float = 0.2
    """Longest step, over the scales."""
    max_points: int = 1000
    """Largest number of points in one direction."""
    begin: float | None = None
    """Value of the only parameter that is reported as the beginning of its range."""
    parts: float = 50.0
    """Least number of steps across the range of a parameter, to first order."""
    first_step: float | None = None
    """Length of the first step, by default a tenth of the longest."""

    def longest(self, problem: Problem, last: Point) -> float:
        """The longest step from a point."""
        rates = np.abs(last.tangent * problem.scales)[-len(self.low) :] * self.parts
        with np.errstate(divide="ignore"):
            return float(min(self.max_step, np.min((self.high - self.low) / rates)))

    def edge(self, problem: Problem, last: Point) -> tuple[float, int, float]:
        """The step along the tangent to the next edge, the number of its parameter, and its value.

        The step is zero on an edge that the curve leads beyond.
        """
        found = np.inf, 0, float(self.low[0])
        rates = (last.tangent * problem.scales)[-len(self.low) :].tolist()
        for number, (rate, value) in enumerate(zip(rates, problem.values(last.x).tolist(), strict=True)):
            low, high = float(self.low[number]), float(self.high[number])
            edge = high if rate > 0.0 else low
            way = 0.0 if abs(edge - value) <= ON_EDGE * (high - low) else edge - value
            if rate != 0.0 and way / rate < found[0]:
                found = way / rate, number, edge
        return found

    def include(self, problem: Problem, point: Point) -> bool:
        """True if a point is in the ranges."""
        values, more = problem.values(point.x), ON_EDGE * (self.high - self.low)
        return bool(np.all((self.low - more <= values) & (values <= self.high + more)))


class Problem:
    """A curve given by equations; subclasses evaluate them and give reasons for its ends."""

    scales: Vector
    """Scales of the unknowns, shape (n,)."""
    names: tuple[str, ...]
    """Names of the parameters, the last unknowns."""
    same = 1e-8
    """Distance, over the scales, within which points count as one."""

    def residual(self, x: Vector) -> Vector:
        """Residual, shape (n - 1,)."""
        raise NotImplementedError

    def linearize(self, x: Vector) -> tuple[Vector, Matrix]:
        """Residual and its Jacobian, shape (n - 1, n)."""
        raise NotImplementedError

    def describe(self, x: Vector) -> tuple[Any, Matrix]:
        """Description of a solution, and the Jacobian of the residual."""
        raise NotImplementedError

    def label(self, known: object) -> object:
        """Label of a description; the equations are smooth between points of one label."""
        return None

    def visited(self, point: Point) -> Sequence[Vector]:
        """All places of a point. A gait of two strides has one at each of its apexes."""
        return [point.x]

    def ends_between(self, before: Point, after: Point) -> str:
        """Reason why the curve ends between two points, or an empty text."""
        return ""

    def at_edge(self, value: float, limits: Limits) -> str:
        """Reason why a curve ended at the edge of a range."""
        return "edge of the ranges"

    def where_met(self, point: Point, following: Point, number: int) -> str:
        """Reason why a curve ended that came back to a point, by the number of the place in `visited`."""
        return CLOSED

    def lost(self, last: Point, why: Exception) -> str:
        """Reason why a curve cannot be followed from its last point on."""
        return f"lost: {why}"

    def values(self, x: Vector) -> Vector:
        """Values of the parameters, in their units."""
        count = len(self.names)
        values: Vector = x[-count:] * self.scales[-count:]
        return values

    def where(self, x: Vector) -> str:
        """Names and values of the parameters at a point, for messages."""
        values = zip(self.names, self.values(x), strict=True)
        return ", ".join(f"{name} = {value:g}" for name, value in values)

    def point(self, x: Vector, along: Vector) -> Point:
        """A solution as a point whose tangent leads along a direction."""
        known, rows = self.describe(x)
        return Point(x, np.linalg.svd(rows)[2][-1], known, rows).along(along)

    def solution(
        self, goal: Vector, across: Vector, rows: Matrix | None, guess: Vector | None = None
    ) -> Vector:
        """The solution near a goal on the plane across a direction, or on several, by damped or whole steps.

        `across` has the shape (n,) or (k, n); `rows` are a Jacobian from nearby. The damped steps begin at
        the guess, by default the goal. RunError where there is no solution, InputError where the guess itself
        is not allowed.
        """
        plane = _OnPlane(self, goal, across)
        near = None if rows is None else np.vstack([rows, across])
        guess = goal if guess is None else guess
        try:
            return solve(plane, guess, jacobian=near, iterations=ITERATIONS, shortenings=SHORTENINGS).x
        except RunError:
            return solve(plane, goal, iterations=ITERATIONS, shortenings=0).x

    def correct(self, goal: Vector, across: Vector, near: Point | None = None) -> Point:
        """The curve's point near a goal on the plane across a direction; its tangent goes along it.

        A point that is near may save some evaluations by its Jacobian and its extrapolation.
        """
        rows, guess = (None, goal) if near is None else (near.rows, near.extrapolated(goal, across))
        try:
            return self.point(self.solution(goal, across, rows, guess), across)
        except RunError as problem:
            raise RunError(f"no gait near {self.where(goal)}: {problem}") from None

    def between(self, before: Point, after: Point, share: float) -> Point:
        """The curve's point beside a share of the straight way from one point to the next."""
        way = after.x - before.x
        return self.correct(before.x + share * way, way / np.linalg.norm(way), before)

    def leads_back(self, found: Point, known: Point) -> bool:
        """True if the corrector that starts from the tangent of one point finds the known one."""
        way = found.x - known.x
        goal = found.x - (way @ found.tangent) * found.tangent
        plane = _OnPlane(self, goal, found.tangent, known.x, RETURNED * float(np.linalg.norm(way)))
        for shortenings, rows in ((SHORTENINGS, np.vstack([found.rows, found.tangent])), (0, None)):
            try:
                solve(plane, goal, jacobian=rows, iterations=ITERATIONS, shortenings=shortenings)
            except _ReachedError:
                return True
            except (InputError, RunError):
                continue
        return False


class _ReachedError(Exception):
    """An iterate is near the known solution."""


@dataclass(frozen=True, eq=False)
class _OnPlane:
    """Equations of a curve with that of a plane; raises _ReachedError near a known solution."""

    problem: Problem
    goal: Vector
    across: Vector
    known: Vector | None = None
    near: float = 0.0

    def residual(self, x: Vector) -> Vector:
        if self.known is not None and np.linalg.norm(x - self.known) <= self.near:
            raise _ReachedError
        return np.append(self.problem.residual(x), self.across @ (x - self.goal))

    def linearize(self, x: Vector) -> tuple[Vector, Matrix]:
        residual, rows = self.problem.linearize(x)
        return np.append(residual, self.across @ (x - self.goal)), np.vstack([rows, self.across])


def follow(
    problem: Problem,
    start: Point,
    direction: float,
    limits: Limits,
    *,
    known: Sequence[Point] = (),
    step_finished: Callable[[], object] = lambda: None,
) -> tuple[list[Point], str]:
    """Follow a curve until it leaves the ranges, meets itself, or cannot be followed.

    It goes along the tangent of the first point, or against it for a negative direction. `known` are points
    where the curve has been already. Returns the points in their order, and why there are no more.
    """
    start = start if direction > 0.0 else start.reversed()
    points, step = [start], limits.first_step or limits.max_step / 10.0
    track = Track(problem, [*known, start])
    while len(points) < limits.max_points:
        last = points[-1]
        to_edge, _, edge = limits.edge(problem, last)
        if to_edge <= 0.0:
            return points, problem.at_edge(edge, limits)
        try:
            following, step = next_point(problem, last, step, limits.longest(problem, last), limits)
            further = [following]
        except (InputError, RunError) as why:
            further = _past_corner(problem, last, track, limits)
            if not further:
                return points, problem.lost(last, why)
            step = float(np.linalg.norm(further[-1].x - [last, *further][-2].x))
        for following in further:
            ended = problem.ends_between(points[-1], following)
            if ended:
                return points, ended
            met = track.met(points[-1], following)
            points.append(following if met is None else met[0])
            track.add(points[-1])
            step_finished()
            if met is not None:
                return points, met[1]
    return points, f"number of points: {limits.max_points}"


def both_ways(
    problem: Problem, start: Point, limits: Limits, step_finished: Callable[[], object] = lambda: None
) -> tuple[list[Point], str, str]:
    """Follow a curve to both sides of a point; returns the points and the reasons for both ends."""
    points, ended = follow(problem, start, 1.0, limits, step_finished=step_finished)
    if ended.startswith("closed") and points[-1] is start:
        return points, ended, ended
    if limits.begin is not None and problem.values(start.x)[-1] == limits.begin:
        return points, "", ended
    back, began = follow(problem, start, -1.0, limits, known=points[1:], step_finished=step_finished)
    return [*(point.reversed() for point in back[:0:-1]), *points], began, ended


def next_point(
    problem: Problem, last: Point, step: float, longest: float, limits: Limits | None = None
) -> tuple[Point, float]:
    """The next point by a step along the tangent, and the length to try for the step after it.

    A step that leads beyond an edge of the limits is shortened, and its point is on the edge.
    """
    to_edge, number, edge = (np.inf, 0, 0.0) if limits is None else limits.edge(problem, last)

    def attempt(step: float) -> tuple[Point, float]:
        goal, across = last.x + step * last.tangent, last.tangent
        if step == to_edge:
            position = number - len(problem.names)
            goal[position] = edge / problem.scales[position]
            across = np.sign(last.tangent[position]) * np.eye(len(goal))[position]
        following = problem.correct(goal, across, last).along(last.tangent)
        off = float(np.linalg.norm(following.x - goal))
        turns = following.tangent @ last.tangent < STRAIGHT
        if limits is not None and not limits.include(problem, following):
            raise RunError(f"the branch leaves the range near {problem.where(last.x)}")
        if off > NEAR * step or (step > SHARP and (turns or off > FARTHEST * step)):
            raise RunError(f"the branch turns sharply at {problem.where(last.x)}")
        if not problem.leads_back(following, last):
            raise RunError(f"from {problem.where(last.x)} no gait is found that leads back to it")
        is_smooth = problem.label(following.gait) == problem.label(last.gait)
        return replace(following, before=replace(last, before=None) if is_smooth else None), off

    (following, off), step = halved(attempt, min(step, longest, to_edge), 0.5 * SHORTEST_STEP)
    return following, min(longest, (1.5 if off < 0.1 * step else 1.0) * step)


class Track:
    """Points at which a curve has been."""

    def __init__(self, problem: Problem, points: Sequence[Point]) -> None:
        self.problem = problem
        self._places: list[tuple[Point, int]] = []
        self._rows = np.empty((64, len(problem.scales)))
        for point in points:
            self.add(point)

    def add(self, point: Point) -> None:
        """Add a point."""
        for number, x in enumerate(self.problem.visited(point)):
            if len(self._places) == len(self._rows):
                self._rows = np.concatenate([self._rows, np.empty_like(self._rows)])
            self._rows[len(self._places)] = x
            self._places.append((point, number))

    def met(self, last: Point, following: Point) -> tuple[Point, str] | None:
        """The visited point that the curve goes through in its next step, and the reason to end there."""
        way = following.x - last.x
        away = self._rows[: len(self._places)] - last.x
        shares = away @ way / (way @ way)
        off = np.linalg.norm(away - shares[:, None] * way, axis=1)
        for place in np.flatnonzero((shares > 0.0) & (shares <= 1.0) & (off <= BESIDE * np.linalg.norm(way))):
            if self._goes_through(self._rows[place], shares[place], last, following):
                point, number = self._places[place]
                return point, self.problem.where_met(point, following, number)
        return None

    def is_new(self, points: Sequence[Point]) -> bool:
        """True if the way along some points leads through none where the curve has been."""
        return all(self.met(*pair) is None for pair in pairwise(points))

    def _goes_through(self, x: Vector, share: float, last: Point, following: Point) -> bool:
        """True if the curve goes through a place, and leads from there to both ends of a step.

        Near a sharp turn the corrector finds points of both sides from one prediction.
        """
        try:
            found = self.problem.between(last, following, share)
        except (InputError, RunError):
            return False
        if np.linalg.norm(found.x - x) >= self.problem.same:
            return False
        return all(self.problem.leads_back(found, other) for other in (last, following))


def _past_corner(problem: Problem, last: Point, track: Track, limits: Limits) -> list[Point]:
    """Points of the curve beyond a corner at which its label changes; empty if none is found."""
    here = problem.label(last.gait)
    for distance in BEYOND if here is not None else ():
        try:
            other = problem.point(last.x + distance * last.tangent, last.tangent)
            if problem.label(other.gait) == here:
                continue
            for way in (last.tangent, other.tangent, -other.tangent):
                found = _on_other_side(problem, last, distance * way)
                inside = all(limits.include(problem, point) for point in found)
                if found and inside and track.is_new([last, *found]):
                    return found
        except (InputError, RunError):
            continue
    return []


def _on_other_side(problem: Problem, last: Point, step: Vector) -> list[Point]:
    """Points on the way to one with another label a step away; empty if its curve does not lead back."""
    length = np.linalg.norm(step)
    try:
        found = problem.correct(last.x + step, step / length)
    except (InputError, RunError):
        return []
    way = found.x - last.x
    if np.linalg.norm(way) > NEAR * length or problem.label(found.gait) == problem.label(last.gait):
        return []
    found = found.along(way)
    return [found] if problem.leads_back(found, last) else _way_to(problem, last, found)


def _way_to(problem: Problem, corner: Point, found: Point) -> list[Point]:
    """Points from a corner to one beyond it, found by walking back from there; empty if that fails.

    Where an event is just touched the map has a square root: close to it the tangent turns without end.
    """
    back = [found.reversed()]
    longest = float(np.linalg.norm(found.x - corner.x))
    step, here = longest / 4.0, problem.label(corner.gait)
    for _ in range(MAX_BACK):
        left = float(np.linalg.norm(back[-1].x - corner.x))
        if left <= SHARP:
            there = dropwhile(lambda point: problem.label(point.gait) == here, reversed(back))
            return [point.reversed() for point in there]
        if left > 2.0 * longest:
            break
        try:
            following, step = next_point(problem, back[-1], step, 0.5 * left)
        except (InputError, RunError):
            break
        back.append(following)
    return []
