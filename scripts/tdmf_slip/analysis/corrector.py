"""Newton's method to a branch of gaits, on a plane across a direction."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..numerics.newton import solve

ITERATIONS, SHORTENINGS = 24, 12
"""Steps of Newton's method, and lengths at which each is tried, at most."""


class Branch(Protocol):
    """Strides of one runner by apex and parameter, which are over their scales."""

    def residual(self, coordinates: NDArray[np.float64]) -> NDArray[np.float64]:
        """Residual of the strides, over the scales."""

    def linearize(self, coordinates: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The residual and its derivatives by apex and parameter."""


class _OnPlane:
    """Equations of the point of a branch on the plane through a goal."""

    def __init__(self, branch: Branch, goal: NDArray[np.float64], normal: NDArray[np.float64]) -> None:
        self.branch, self.goal, self.normal = branch, goal, normal

    def residual(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.append(self.branch.residual(x), (x - self.goal) @ self.normal)

    def linearize(self, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        residual, rows = self.branch.linearize(x)
        return np.append(residual, (x - self.goal) @ self.normal), np.vstack([rows, self.normal])


def corrected(
    branch: Branch,
    goal: NDArray[np.float64],
    normal: NDArray[np.float64],
    *,
    rows: NDArray[np.float64] | None = None,
    whole: bool = False,
) -> NDArray[np.float64]:
    """The point of a branch near a goal, on the plane across a direction, by damped or by whole steps.

    `rows` are derivatives from nearby.
    """
    return solve(
        _OnPlane(branch, goal, normal),
        goal,
        jacobian=None if rows is None or whole else np.vstack([rows, normal]),
        iterations=ITERATIONS,
        shortenings=0 if whole else SHORTENINGS,
    ).x
