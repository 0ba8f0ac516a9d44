"""Whether a step along a branch can be walked back: else it has led to another branch that comes near."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from .corrector import Branch, corrected
from .family import Family, Point

RETURNED = 1e-3
"""Of a step: Newton's method that comes as near to a gait that is known finds it."""


def leads_back(family: Family, found: Point, known: Point) -> bool:
    """The corrector that starts from one gait's tangent finds another, from which the first was found.

    Where it does not, they are of two branches, or the way from one to the other is too long.
    """
    begin, there = family.coordinates(found), family.coordinates(known)
    goal = begin - ((begin - there) @ found.tangent) * found.tangent
    return reaches(family, goal, found.tangent, there, begin, family.rows(found.gait))


def reaches(
    branch: Branch,
    goal: NDArray[np.float64],
    normal: NDArray[np.float64],
    known: NDArray[np.float64],
    begin: NDArray[np.float64],
    rows: NDArray[np.float64],
) -> bool:
    """Newton's method from a goal comes to a known point of a branch, on the plane across a direction.

    It has come there as soon as an iterate is near the point, over the way to it from where the step begins.
    `rows` are derivatives from nearby.
    """
    watched = _Watched(branch, known, RETURNED * float(np.linalg.norm(begin - known)))
    for whole in (False, True):
        try:
            corrected(watched, goal, normal, rows=rows, whole=whole)
        except _ReachedError:
            return True
        except (InputError, RunError):
            continue
    return False


class _ReachedError(Exception):
    """An iterate is near the known point."""


@dataclass(frozen=True, eq=False)
class _Watched:
    """A branch whose points are compared with one that is known."""

    branch: Branch
    known: NDArray[np.float64]
    distance: float

    def residual(self, coordinates: NDArray[np.float64]) -> NDArray[np.float64]:
        if np.linalg.norm(coordinates - self.known) <= self.distance:
            raise _ReachedError
        return self.branch.residual(coordinates)

    def linearize(self, coordinates: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        return self.branch.linearize(coordinates)
