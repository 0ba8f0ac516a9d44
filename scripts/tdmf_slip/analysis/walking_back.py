"""Whether a step along a branch can be walked back: else it has led to another branch that comes near."""

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from .corrector import SHORTENINGS, iterates
from .family import Family, Point

RETURNED = 1e-3
"""Of a step: Newton's method that comes as near to a gait that is known finds it."""


def leads_back(family: Family, found: Point, known: Point) -> bool:
    """The corrector that starts from one gait's tangent finds another, from which the first was found.

    Where it does not, they are of two branches, or the way from one to the other is too long.
    """
    begin, there = family.coordinates(found), family.coordinates(known)
    goal = begin - ((begin - there) @ found.tangent) * found.tangent
    return reaches(family, goal, found.tangent, there, float(np.linalg.norm(begin - there)))


def reaches(
    family: Family,
    goal: NDArray[np.float64],
    normal: NDArray[np.float64],
    known: NDArray[np.float64],
    step: float,
) -> bool:
    """Newton's method from a goal, on the plane across a direction there, finds a gait that is known."""
    for shortenings in (SHORTENINGS, 0):
        try:
            for _, coordinates in iterates(family, goal, normal, shortenings):
                if np.linalg.norm(coordinates - known) <= RETURNED * step:
                    return True
        except (InputError, RunError, np.linalg.LinAlgError):
            continue
    return False
