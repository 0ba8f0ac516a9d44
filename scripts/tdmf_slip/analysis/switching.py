"""From a period doubling to the gaits of twice the period: found beside it, and followed as a branch.

On such a branch the period may double again: its gaits of four strides are followed likewise. A doubling
whose gaits are not followed says why.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from .bifurcations import PERIOD_DOUBLING, Special, special_points
from .borders import Border
from .branch import Branch
from .family import Family, Point
from .steps import Limits, follow

MAX_STRIDES = 4
"""Of the gaits that are followed: a period doubling of theirs is told, and no farther branch."""
DEPARTURES = (1e-2, 3e-3, 1e-3, 3e-2)
"""Over the scales: how far from a period doubling the first gait of twice the period is sought."""
UNEVEN = 0.5
"""The two halves of the first gait lie on both sides of the doubling, so that they are two departures apart,
up to this: else it is of another branch."""
OPPOSITE = -0.5
"""Cosine of the angle by which the way from one half of a gait to the other turns where they swap places."""


def reported_branch(family: Family, points: Sequence[Point], began: str, ended: str) -> Branch:
    """Points as a branch, with all that happens between them."""
    borders: list[Border] = []
    specials: list[Special] = []
    for index, (before, after) in enumerate(pairwise(points)):
        its_borders, its_specials = special_points(family, before, after)
        borders += its_borders
        specials += [replace(special, index=index) for special in its_specials]
    return Branch(
        family.name,
        tuple(point.value for point in points),
        tuple(point.gait for point in points),
        tuple(borders),
        tuple(specials),
        began,
        ended,
        family.strides,
    )


def with_doubled_branches(
    branch: Branch,
    family_of: Callable[[int], Family],
    limits: Limits,
    step_finished: Callable[[], None] = lambda: None,
) -> Branch:
    """A branch with those of twice the period from its period doublings, each once, and with theirs."""
    strides = 2 * branch.strides
    met: list[float] = []
    found: list[Branch] = []
    specials = list(branch.specials)
    for number, special in enumerate(branch.specials):
        if special.kind != PERIOD_DOUBLING or any(abs(special.value - v) <= 1e-8 * abs(v) for v in met):
            continue
        if strides > MAX_STRIDES:
            specials[number] = replace(special, why=f"gaits of {strides} strides are not followed")
            continue
        family = family_of(strides)
        first = departure(family, special)
        if first is None:
            specials[number] = replace(special, why=f"no gait of {strides} strides was found beside it")
            continue
        points, ended = follow(family, first, limits, step_finished, _meets_halves(family, branch))
        other = reported_branch(family, points, _at_doubling(family, special.value), ended)
        met += [d.value for d in branch.specials if ended == _at_doubling(family, d.value)]
        found.append(with_doubled_branches(other, family_of, limits, step_finished))
    return replace(branch, specials=tuple(specials), branches=tuple(found))


def _at_doubling(family: Family, value: float) -> str:
    return f"period doubling at {family.name} = {value:.10g}"


def _meets_halves(family: Family, branch: Branch) -> Callable[[Point, Point], str]:
    """Where the two halves of gaits of twice the period change places: at a doubling of the branch they left.

    From there on the same gaits would be met again, begun by their other half.
    """

    def halves_apart(point: Point) -> NDArray[np.float64]:
        apart: NDArray[np.float64]
        apart = (point.gait.following[branch.strides - 1] - point.gait.apex) / family.scales[:-1]
        return apart

    def ends_between(before: Point, after: Point) -> str:
        old, new = halves_apart(before), halves_apart(after)
        if old @ new > OPPOSITE * np.linalg.norm(old) * np.linalg.norm(new):
            return ""
        doublings = [special.value for special in branch.specials if special.kind == PERIOD_DOUBLING]
        middle = 0.5 * (before.value + after.value)
        return _at_doubling(family, min(doublings, key=lambda value: abs(value - middle)))

    return ends_between


def departure(family: Family, doubling: Special) -> Point | None:
    """The first gait of twice the period beside a period doubling, in the direction away from it."""
    gait, scales = doubling.gait, family.scales
    eigenvalues, vectors = np.linalg.eig(gait.jacobian)
    vector = vectors[:, np.argmin(np.abs(eigenvalues + 1.0))].real / scales[:-1]
    way = np.append(vector / np.linalg.norm(vector), 0.0)
    begin = np.append(gait.apex, doubling.value) / scales
    for distance in DEPARTURES:
        try:
            found = family.on_plane(begin + distance * way, way)
        except (InputError, RunError):
            continue
        halfway = found.gait.following[family.strides // 2 - 1]
        apart = float(np.linalg.norm((halfway - found.gait.apex) / scales[:-1])) / distance
        if abs(apart - 2.0) < UNEVEN:
            return found
    return None
