"""Sequential quadratic programming (Kraft's SLSQP, of SciPy) over gaits in a box, on one smooth region.

It ends where an iterate is on another region of the functions, or is no gait: what was found until then is
given back, and the caller goes on from there, with a smaller box or on the other region.
"""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .gaits import Candidate
from .problem import Problem, Rows

ITERATIONS = 30
ACCURACY = 1e-12
"""Of the objective, and of the constraints' violations."""


@dataclass(frozen=True, eq=False)
class Ended:
    """How a search within a box ended."""

    best: Candidate
    """The gait of least merit that was seen on the region."""
    beyond: Candidate | None
    """An iterate on another region, which ended it."""
    lost: str
    """Why an iterate is no gait, which ended it; else empty."""


class _LeftError(Exception):
    """An iterate is not on the region."""


def minimize(
    problem: Problem,
    follow: Callable[[Candidate, NDArray[np.float64]], Candidate],
    begin: Candidate,
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    is_inside: Callable[[Candidate], bool] = lambda gait: True,
) -> Ended:
    """The best gait of a region in a box around one, or how far the search came."""
    from scipy.optimize import minimize as by_scipy  # slow to load

    seen = [begin]
    ended: dict[str, Any] = {"beyond": None, "lost": ""}

    def at(coordinates: NDArray[np.float64]) -> Candidate:
        near = min(reversed(seen), key=lambda gait: float(np.linalg.norm(gait.at - coordinates)))
        if np.array_equal(near.at, coordinates):
            return near
        try:
            gait = follow(near, coordinates.copy())
        except RunError as problem:
            ended["lost"] = str(problem)
            raise _LeftError from None
        if not is_inside(gait):
            ended["beyond"] = gait
            raise _LeftError
        seen.append(gait)
        return gait

    constraints = [
        {
            "type": kind,
            "fun": lambda coordinates, rows=rows: rows(at(coordinates))[0],
            "jac": lambda coordinates, rows=rows: rows(at(coordinates))[1],
        }
        for kind, rows in (("eq", problem.equations), ("ineq", problem.margins))
        if _count(rows, begin)
    ]
    with contextlib.suppress(_LeftError):
        by_scipy(
            lambda coordinates: problem.objective(at(coordinates))[0],
            begin.at,
            jac=lambda coordinates: problem.objective(at(coordinates))[1],
            method="SLSQP",
            bounds=list(zip(low, high, strict=True)),
            constraints=constraints,
            options={"maxiter": ITERATIONS, "ftol": ACCURACY},
        )
    return Ended(min(seen, key=problem.merit), **ended)


def _count(rows: Callable[[Candidate], Rows], gait: Candidate) -> int:
    return len(rows(gait)[0])
