"""Gaits along a parameter: branches through folds, their bifurcations, and borders between gait words.

A branch is followed by pseudo-arclength continuation on the exact Jacobian. At a border a contact mode
appears or vanishes: how long it lasts is zero there, and that is what is solved for.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .errors import InputError, RunError
from .orbit import Orbit, Runner, find_orbit, stride_from

ROOT_ACCURACY = 1e-11
"""Of the parameter where a test function of the gait is zero, over the larger of the values around."""
CLOSE_TO_BORDER = 1e-7
"""Distance at which a straight line through two durations is exact, likewise."""
BEYOND = 1e-8
"""Distance from a border at which the word beyond is read, likewise."""
MOST_LOOKS = 100


@dataclass(frozen=True)
class Border:
    """Where a gait's word changes."""

    value: float
    """Of the parameter."""
    before: str
    after: str

    def as_json(self, name: str = "friction") -> dict[str, object]:
        """As a plain object."""
        return {name: self.value, "from": self.before, "to": self.after}


@dataclass(frozen=True)
class Special:
    """A point of a branch where its stability or its direction changes."""

    kind: str
    """fold, period doubling, or Neimark-Sacker."""
    value: float
    orbit: Orbit


@dataclass(frozen=True)
class Branch:
    """Gaits in the order in which they were met along a parameter."""

    name: str
    values: tuple[float, ...]
    orbits: tuple[Orbit, ...]
    borders: tuple[Border, ...]
    specials: tuple[Special, ...]
    ended: str
    """Why the branch stops: at the end of the range, or in words what happened."""


class _Family:
    """Gaits of one runner by the value of a parameter."""

    def __init__(self, runner: Runner, name: str) -> None:
        if name not in runner.values:
            raise InputError(f"parameter {name!r} is unknown")
        self.runner = runner
        self.name = name

    def orbit(self, value: float, guess: Sequence[float]) -> Orbit:
        return find_orbit(self.runner.but(self.name, value), guess, along=self.name)


def gaits_over(
    runner: Runner,
    name: str,
    values: Sequence[float],
    first: Orbit,
    step_finished: Callable[[], None] = lambda: None,
) -> Iterator[Orbit]:
    """The gait at each value in turn, each from the one before; steps in between where values are far apart.

    Raises:
        RunError: the branch cannot be followed so far.
    """
    family = _Family(runner, name)
    orbit, at = first, first.runner.values[name]
    for value in values:
        for part in _walk(family, orbit, at, value):
            orbit, at = part, part.runner.values[name]
        yield orbit
        step_finished()


def _walk(family: _Family, orbit: Orbit, at: float, to: float) -> Iterator[Orbit]:
    """Gaits from one value to another, by predictions along the branch, shorter where they fail."""
    step = to - at
    if step == 0.0:
        yield family.orbit(to, orbit.apex)
        return
    smallest = 1e-9 * max(abs(at), abs(to))
    while at != to:
        step = np.clip(step, -abs(to - at), abs(to - at))
        value = to if abs(to - at - step) < smallest else at + step
        try:
            nearby = _predicted(orbit, value - at)
            following = family.orbit(value, nearby)
        except RunError:
            step *= 0.5
            if abs(step) < smallest:
                raise
            continue
        yield following
        orbit, at, step = following, value, 2.0 * step


def _predicted(orbit: Orbit, step: float) -> np.ndarray:
    """The apex at a parameter a little away, along the branch's tangent."""
    tangent = np.linalg.solve(np.eye(6) - orbit.jacobian, orbit.by_parameter)
    return orbit.apex + step * tangent


def borders_between(runner: Runner, name: str, first: Orbit, last: Orbit) -> list[Border]:
    """All changes of the word from one gait to another of the same branch, in order.

    Raises:
        RunError: a gait between them cannot be found.
    """
    family = _Family(runner, name)
    found: list[Border] = []
    inside = first
    while inside.word != last.word and len(found) < MOST_LOOKS:
        value, outside = _border(family, inside, last)
        found.append(Border(value, inside.word, outside.word))
        inside = outside
    return found


def _border(family: _Family, inside: Orbit, last: Orbit) -> tuple[float, Orbit]:
    """Where the word of `inside` ends on the way to `last`, and the gait just beyond.

    The gaits on both sides are brought together until a letter's duration is all but zero, each time nine
    tenths of the way to where the last two say it vanishes. A look that does not serve halves what is left,
    and so does every second one: that finds durations which end as a square root does, where a guard is just
    touched.
    """
    name = family.name
    outside = last
    smallest = 1e-9 * max(abs(inside.runner.values[name]), abs(last.runner.values[name]))
    sides: dict[str, list[Orbit]] = {inside.word: [inside], last.word: [last]}
    for looks in range(MOST_LOOKS):
        low, high = inside.runner.values[name], outside.runner.values[name]
        size = max(abs(low), abs(high), smallest)
        if abs(high - low) <= ROOT_ACCURACY * size:
            return 0.5 * (low + high), outside
        vanishing = _vanishing_point(name, sides[inside.word], sides[outside.word], low, high)
        look = 0.5 * (low + high)
        if vanishing is not None:
            near, value = vanishing
            if abs(near - value) <= CLOSE_TO_BORDER * size:
                beyond = value + np.copysign(min(BEYOND * size, 0.5 * abs(high - value)), high - low)
                reached = family.orbit(beyond, outside.apex)
                if reached.word != inside.word:
                    return value, reached
            elif looks % 2 == 0 and min(low, high) < value + 0.1 * (near - value) < max(low, high):
                look = value + 0.1 * (near - value)
        tried = family.orbit(look, _between(inside, outside, look, name))
        sides.setdefault(tried.word, []).append(tried)
        if tried.word == inside.word:
            inside = tried
        else:
            outside = tried
    words = f"{inside.word} and {outside.word}"
    raise RunError(f"border between {words} not located near {name} = {low:g}")


def _between(inside: Orbit, outside: Orbit, value: float, name: str) -> np.ndarray:
    low, high = inside.runner.values[name], outside.runner.values[name]
    share = (value - low) / (high - low)
    return (1.0 - share) * inside.apex + share * outside.apex


def _vanishing_point(
    name: str, inside: Sequence[Orbit], outside: Sequence[Orbit], low: float, high: float
) -> tuple[float, float] | None:
    """The last value on the side with more letters, and where by its last two gaits a letter ends."""
    side = inside if len(inside[-1].word) > len(outside[-1].word) else outside
    if len(side) < 2 or len(side[-1].letters) != len(side[-2].letters):
        return None
    near, far = side[-1], side[-2]
    at, step = near.runner.values[name], near.runner.values[name] - far.runner.values[name]
    roots = [
        at - duration * step / (duration - before)
        for (_, duration), (_, before) in zip(near.letters, far.letters, strict=True)
        if duration != before
    ]
    slack = BEYOND * abs(at)  # the border may lie on a gait already tried, or beside it by rounding
    within = [root for root in roots if min(low, high) - slack <= root <= max(low, high) + slack]
    return (at, min(within, key=lambda root: abs(root - at))) if within else None


def trace(
    runner: Runner,
    name: str,
    first: Orbit,
    end: float,
    *,
    largest_step: float = 0.05,
    most_points: int = 1000,
    step_finished: Callable[[], None] = lambda: None,
) -> Branch:
    """Follow the branch of a gait, through folds, until the parameter leaves the range.

    Pseudo-arclength continuation: each gait is sought on the plane across the branch's tangent. Lengths along
    the branch are measured over the coordinates' scales, and over the first value of the parameter.

    Args:
        runner: whose gaits.
        name: parameter or input that is varied.
        first: a gait to begin at.
        end: value of the parameter at which to stop; where a fold leads back, the branch stops at its first.
        largest_step: along the branch.
        most_points: stop after so many gaits.
        step_finished: called after each gait.
    """
    family = _Family(runner, name)
    start = first.runner.values[name]
    scales = np.append(runner.scales, abs(start) or 1.0)
    first = family.orbit(start, first.apex)
    direction = _tangent(first, scales)
    direction *= np.sign(direction[-1] * (end - start))
    orbits, directions, ended = [first], [direction], f"{most_points} gaits"
    step = largest_step / 10.0
    while len(orbits) < most_points:
        try:
            origin = np.append(orbits[-1].apex, orbits[-1].runner.values[name]) / scales
            following = _newton_on_plane(family, origin + step * directions[-1], directions[-1], scales)
        except RunError as problem:
            step *= 0.5
            if step < 1e-7:
                ended = str(problem)
                break
            continue
        tangent = _tangent(following, scales)
        tangent *= np.sign(tangent @ directions[-1])
        orbits.append(following)
        directions.append(tangent)
        step_finished()
        value = following.runner.values[name]
        if not min(start, end) < value < max(start, end):
            ended = "end of the range"
            break
        step = min(largest_step, 1.5 * step)
    return _branch(family, orbits, directions, scales, ended)


def _tangent(orbit: Orbit, scales: np.ndarray) -> np.ndarray:
    """Unit vector along the branch, over the scales."""
    rows = np.hstack([orbit.jacobian - np.eye(6), orbit.by_parameter[:, None]]) * scales
    return np.linalg.svd(rows)[2][-1]


def _newton_on_plane(family: _Family, goal: np.ndarray, direction: np.ndarray, scales: np.ndarray) -> Orbit:
    point = goal.copy()
    for _ in range(12):
        runner = family.runner.but(family.name, point[-1] * scales[-1])
        apex, jacobian, by_parameter = stride_from(runner, point[:-1] * scales[:-1], family.name)
        matrix = np.vstack(
            [
                np.hstack([jacobian - np.eye(6), by_parameter[:, None]]) * scales / scales[:-1, None],
                direction,
            ]
        )
        residual = np.append(apex / scales[:-1] - point[:-1], (point - goal) @ direction)
        change = np.linalg.solve(matrix, -residual)
        point = point + change
        if np.max(np.abs(change)) < 1e-10:
            return family.orbit(point[-1] * scales[-1], point[:-1] * scales[:-1])
    raise RunError(f"no gait near {family.name} = {goal[-1] * scales[-1]:g}")


def _branch(
    family: _Family, orbits: list[Orbit], directions: list[np.ndarray], scales: np.ndarray, ended: str
) -> Branch:
    name = family.name
    borders: list[Border] = []
    specials: list[Special] = []
    for k in range(1, len(orbits)):
        try:
            borders += _borders_at(family, orbits, k)
            specials += _specials_at(family, orbits, directions, scales, k)
        except RunError as problem:  # the branch stands, what happens on this piece of it is not known
            ended += f"; {problem}"
    return Branch(
        name,
        tuple(o.runner.values[name] for o in orbits),
        tuple(orbits),
        tuple(borders),
        tuple(specials),
        ended,
    )


def _borders_at(family: _Family, orbits: Sequence[Orbit], k: int) -> list[Border]:
    before, after = orbits[k - 1], orbits[k]
    return borders_between(family.runner, family.name, before, after) if before.word != after.word else []


def _specials_at(
    family: _Family, orbits: Sequence[Orbit], directions: Sequence[np.ndarray], scales: np.ndarray, k: int
) -> Iterator[Special]:
    before, after = orbits[k - 1], orbits[k]
    if before.word != after.word:
        return
    if np.sign(directions[k - 1][-1]) != np.sign(directions[k][-1]):
        yield Special("fold", *_turning(family, before, directions[k - 1], scales))
    for kind, test in _TESTS.items():
        if test(before) * test(after) < 0.0:
            yield Special(kind, *_sign_change(family, before, after, test))


def _period_doubling(orbit: Orbit) -> float:
    return float(np.linalg.det(orbit.jacobian + np.eye(6)))


def _neimark_sacker(orbit: Orbit) -> float:
    """Largest complex pair's distance from the unit circle; 1 where there is none near."""
    pairs = [abs(v) - 1.0 for v in orbit.eigenvalues if abs(v.imag) > 1e-9]
    return max(pairs, default=1.0) if pairs else -1.0


_TESTS = {"period doubling": _period_doubling, "Neimark-Sacker": _neimark_sacker}


def _sign_change(
    family: _Family, before: Orbit, after: Orbit, test: Callable[[Orbit], float]
) -> tuple[float, Orbit]:
    """Where a test function of the gait is zero, between two of them, by false position on the parameter."""
    name = family.name
    low, high = before, after
    low_value, high_value = test(before), test(after)
    middle = after
    for _ in range(MOST_LOOKS):
        a, b = low.runner.values[name], high.runner.values[name]
        value = b - high_value * (b - a) / (high_value - low_value)
        middle = family.orbit(value, _between(low, high, value, name))
        found = test(middle)
        if abs(b - a) <= ROOT_ACCURACY * abs(b) or found == 0.0 or abs(found) < 1e-12:
            break
        if found * high_value < 0.0:
            low, low_value = high, high_value
        else:
            low_value *= 0.5
        high, high_value = middle, found
    return middle.runner.values[name], middle


def _turning(family: _Family, before: Orbit, start: np.ndarray, scales: np.ndarray) -> tuple[float, Orbit]:
    """The fold beyond a gait: where the tangent has no share along the parameter."""
    orbit, direction = before, start
    step = 1e-2
    for _ in range(MOST_LOOKS):
        following = _newton_on_plane(
            family,
            np.append(orbit.apex, orbit.runner.values[family.name]) / scales + step * direction,
            direction,
            scales,
        )
        tangent = _tangent(following, scales)
        tangent *= np.sign(tangent @ direction)
        change = tangent[-1] - direction[-1]
        if change == 0.0 or abs(tangent[-1]) < 1e-9:
            return following.runner.values[family.name], following
        orbit, direction, step = following, tangent, -tangent[-1] * step / change
    return orbit.runner.values[family.name], orbit
