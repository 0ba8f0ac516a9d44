"""The search along a border between two pieces, for the best place on it.

Parameters on the border are x = x0 + T u + n s(u), with the normal n at x0, a basis T of the plane across it,
and s(u) solved for. So the objective and the constraints are functions of u alone, as smooth as those of the
piece and the border are, and their derivatives are those along T + n ds/du, which is in the border's own
plane.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .border import Border, across
from .gaits import Candidate, Gaits
from .pieces import Piece
from .problem import Problem, Rows
from .slsqp import minimize
from .space import AT_BOUND

RADIUS, SMALLEST = 0.05, 1e-7
"""Half the width of the first box, and of the last one; of the bounds' width."""
ROUNDS = 20


@dataclass(frozen=True)
class OnBorder(Candidate):
    """A gait on a border; `at` is u, over which the slopes are."""

    border: Border
    """There."""
    offset: float
    """s, by which the border is off the plane."""
    plane: NDArray[np.float64]
    """Changes of the parameters by u, shape (d, d - 1): T + n ds/du."""


class AlongBorder(Problem):
    """A problem over a border; the bounds of the parameters are among the margins."""

    def __init__(self, problem: Problem, free: NDArray[np.bool_]) -> None:
        """Of the problem itself, and which of the parameters are varied."""
        super().__init__(problem.goal, problem.scales)
        self._problem, self._free = problem, free

    def objective(self, gait: Candidate) -> tuple[float, NDArray[np.float64]]:
        """As the problem has it."""
        return self._problem.objective(gait)

    def equations(self, gait: Candidate) -> Rows:
        """As the problem has them."""
        return self._problem.equations(gait)

    def margins(self, gait: Candidate) -> Rows:
        """Those of the problem, and of the bounds."""
        assert isinstance(gait, OnBorder)
        left, slopes = self._problem.margins(gait)
        at, plane = gait.border.short.at[self._free], gait.plane[self._free]
        return np.concatenate([left, at, 1.0 - at]), np.vstack([slopes, plane, -plane])


def best_along(gaits: Gaits, problem: Problem, border: Border, piece: Piece, stationary: float) -> Border:
    """The best place on a border, as the piece on this side has it.

    Parameters
    ----------
    gaits : Gaits
        Of which runner, over which parameters.
    problem : Problem
        What is asked.
    border : Border
        Where to begin.
    piece : Piece
        On this side.
    stationary : float
        Fall of the merit that counts as none.

    Returns
    -------
    Border
        There, or where the search came to.
    """
    origin = border.short.at
    free = (origin > AT_BOUND) & (origin < 1.0 - AT_BOUND)
    normal = np.where(free, border.normal, 0.0)
    size = float(np.linalg.norm(normal))
    basis = np.eye(len(origin))[:, free] @ _plane(border.normal[free])
    if size < AT_BOUND or basis.shape[1] == 0:
        return border
    normal /= size
    wanted = AlongBorder(problem, free)

    def on_border(there: Border, u: NDArray[np.float64]) -> OnBorder:
        short = there.short
        bend = -(there.normal @ basis) / (there.normal @ normal)
        plane = basis + np.outer(normal, bend)
        return OnBorder(
            at=u,
            orbit=short.orbit,
            apex_slopes=short.apex_slopes @ plane,
            values=short.values,
            slopes=short.slopes @ plane,
            spectrum=short.spectrum.along(plane),
            border=there,
            offset=float((short.at - origin) @ normal),
            plane=plane,
        )

    def follow(near: Candidate, u: NDArray[np.float64]) -> OnBorder:
        assert isinstance(near, OnBorder)
        at = near.border.short.at + near.plane @ (u - near.at)
        return on_border(across(gaits, near.border.short, at, normal, piece.has), u)

    here, radius = on_border(border, np.zeros(basis.shape[1])), RADIUS
    for _ in range(ROUNDS):
        ended = minimize(wanted, follow, here, here.at - radius, here.at + radius)
        progress = wanted.merit(here) - wanted.merit(ended.best)
        assert isinstance(ended.best, OnBorder)
        here = ended.best
        fall = problem.steepest(here.border.short, here.border.normal, along=True)
        radius *= 2.0 if not ended.lost and progress > 0.0 else 0.25
        if (not ended.lost and fall <= stationary) or radius < SMALLEST:
            break
    return here.border


def _plane(normal: NDArray[np.float64]) -> NDArray[np.float64]:
    """An orthonormal basis of what is across a vector, in columns."""
    basis: NDArray[np.float64] = np.linalg.svd(normal[None, :])[2][1:].T
    return basis
