"""Objective and constraints of a gait without dimension, their violation, and the SLSQP method over gaits.

Quantities are divided by their scales, and parameters by the width of their bounds. A linear program shows
how near a gait is to an optimum of its region. It finds the largest decrease of the objective and of the
violation of the constraints in a small box, if all were linear. If that is zero, the conditions of Karush,
Kuhn and Tucker hold.

Sequential quadratic programming (Kraft's SLSQP, of SciPy) runs in a box, in one smooth region. It ends if an
iterate is in another region of the functions, or is no gait. The caller then goes on from the best gait, with
a smaller box or in the other region.
"""

import contextlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .gaits import Candidate, Rows, Spectrum

PENALTY = 100.0
"""Weight of a violated constraint against the objective, in a comparison of two gaits."""
MET = 1e-8
"""Violation of a constraint that counts as none."""
OFF_FOLD = 1e-4
"""Least det(I - J)^2 of a gait off folds: the leading eigenvalue is then about 0.99 instead of 1."""
MIN_ROOM = 1e-2
"""Least scale of eigenvalues' margins, which is otherwise 1 less the largest allowed radius."""
LITTLE = 1e-3
"""Size of the linear program's box."""

ITERATIONS = 30
ACCURACY = 1e-12
"""Accuracy of the objective and of the constraints' violations, at which a search in a box ends."""


@dataclass(frozen=True, eq=False)
class Goal:
    """Objective and constraints by names of quantities, in SI units."""

    objective: str
    """Name of the quantity that is minimized or maximized."""
    sign: float = 1.0
    """1 to minimize, -1 to maximize."""
    at: Mapping[str, float] = field(default_factory=dict)
    """Prescribed values by quantity."""
    upper_limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    """Sign and limit by quantity: sign times the quantity must be at most sign times the limit."""
    radius: float | None = None
    """Largest allowed spectral radius; None for any."""
    fold: bool = False
    """True to keep off folds, by `OFF_FOLD`."""

    @property
    def with_spectrum(self) -> bool:
        """True if eigenvalues are constrained."""
        return self.fold or self.radius is not None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all quantities of the goal, each once."""
        return tuple(dict.fromkeys((self.objective, *self.at, *self.upper_limits)))


class Problem:
    """Goal as functions of a gait."""

    def __init__(self, goal: Goal, scales: Mapping[str, float]) -> None:
        """Keep the goal, and the scales of its quantities."""
        self.goal, self.scales = goal, scales

    def objective(self, gait: Candidate) -> tuple[float, NDArray[np.float64]]:
        """Objective with the sign for minimization, and its gradient."""
        name, sign = self.goal.objective, self.goal.sign
        row, scale = self.goal.names.index(name), sign / self.scales[name]
        return scale * float(gait.values[row]), scale * gait.slopes[row]

    def equations(self, gait: Candidate) -> Rows:
        """Residuals of the equality constraints, and their gradients."""
        goal = self.goal
        rows = [goal.names.index(name) for name in goal.at]
        scales = np.array([self.scales[name] for name in goal.at])
        off = (gait.values[rows] - np.array([*goal.at.values()])) / scales
        return off, gait.slopes[rows] / scales[:, None]

    def margins(self, gait: Candidate) -> Rows:
        """Margins of the inequality constraints, which must not be negative, and their gradients.

        The gait's own margins come last.
        """
        goal = self.goal
        rows = [goal.names.index(name) for name in goal.upper_limits]
        scales = np.array([sign / self.scales[name] for name, (sign, _) in goal.upper_limits.items()])
        left = scales * (np.array([limit for _, limit in goal.upper_limits.values()]) - gait.values[rows])
        slopes = -scales[:, None] * gait.slopes[rows]
        spectrum = gait.spectrum
        if goal.radius is not None:
            sizes, by_size = _below(spectrum, goal.radius)
            left = np.append(left, sizes)
            slopes = np.vstack([slopes, by_size[:, None] * spectrum.slopes])
        if goal.fold:
            left = np.append(left, spectrum.fold / OFF_FOLD - 1.0)
            slopes = np.vstack([slopes, spectrum.fold_slopes / OFF_FOLD])
        more, more_slopes = gait.margins
        return np.append(left, more), np.vstack([slopes, more_slopes])

    def violation(self, gait: Candidate) -> float:
        """Sum of the violations of all constraints."""
        return float(np.sum(np.abs(self.equations(gait)[0])) - np.sum(np.minimum(self.margins(gait)[0], 0.0)))

    def merit(self, gait: Candidate) -> float:
        """Objective plus the penalty of violations: the less, the better."""
        violation = self.violation(gait)
        return self.objective(gait)[0] + (PENALTY * violation if violation > MET else 0.0)

    def gain(self, gait: Candidate, away: NDArray[np.float64]) -> float:
        """Steepest fall of the merit away from a border less that along it, at a gait beside it."""
        return self.steepest(gait, away) - self.steepest(gait, away, along=True)

    def steepest(
        self, gait: Candidate, normal: NDArray[np.float64] | None = None, *, along: bool = False
    ) -> float:
        """Largest decrease of the merit, over the size of the step, to first order.

        With a normal, steps are on the side to which it points, or `along` the plane across it.
        """
        from scipy.optimize import linprog  # slow to load

        gradient = self.objective(gait)[1]
        (off, off_slopes), (left, left_slopes) = self.equations(gait), self.margins(gait)
        m, k = len(off), len(left)
        # Unknowns: the step; how far equations are off to either side; how far margins are below zero.
        cost = np.concatenate([gradient, np.full(2 * m + k, PENALTY)])
        equal = np.hstack([off_slopes, -np.eye(m), np.eye(m), np.zeros((m, k))])
        above = np.hstack([-left_slopes, np.zeros((k, 2 * m)), -np.eye(k)])
        off, left = (np.where(np.abs(rows) <= MET, 0.0, rows) / LITTLE for rows in (off, left))
        below, over = (np.clip(room / LITTLE, 0.0, 1.0) for room in (gait.at, 1.0 - gait.at))
        if normal is not None:
            row = np.concatenate([normal, np.zeros(2 * m + k)])[None, :]
            equal, off = (np.vstack([equal, row]), np.append(off, 0.0)) if along else (equal, off)
            above, left = (above, left) if along else (np.vstack([above, -row]), np.append(left, 0.0))
        found = linprog(
            cost,
            A_ub=above if len(above) else None,
            b_ub=left if len(above) else None,
            A_eq=equal if len(equal) else None,
            b_eq=-off if len(equal) else None,
            bounds=[*zip(-below, over, strict=True)] + [(0.0, None)] * (2 * m + k),
        )
        violation = self.violation(gait)
        now = PENALTY * violation / LITTLE if violation > MET else 0.0
        return max(0.0, now - float(found.fun)) if found.success else np.inf


def _below(spectrum: Spectrum, radius: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Margins of eigenvalues below a radius, and their derivatives by the eigenvalues' sizes.

    At a fold, a positive eigenvalue goes to 1 like a square root. Its margin is therefore that of
    (1 - size)^2, which is linear there. Near the limit both margins agree, except for a factor of two.
    """
    room = max(1.0 - radius, MIN_ROOM)
    off = 1.0 - spectrum.sizes
    bent = (off * np.abs(off) - (1.0 - radius) ** 2) / room
    values = np.where(spectrum.positive, bent, radius - spectrum.sizes)
    return values, np.where(spectrum.positive, -2.0 * np.abs(off) / room, -1.0)


class Feasibility(Problem):
    """Violation of a goal's constraints as the objective of a problem without constraints."""

    def objective(self, gait: Candidate) -> tuple[float, NDArray[np.float64]]:
        """Half the sum of squared violations, and its gradient."""
        (off, off_slopes), (left, left_slopes) = super().equations(gait), super().margins(gait)
        short = np.minimum(left, 0.0)
        return 0.5 * float(off @ off + short @ short), off @ off_slopes + short @ left_slopes

    def equations(self, gait: Candidate) -> Rows:
        """No equations: the deviations are in the objective."""
        return np.zeros(0), np.zeros((0, len(gait.at)))

    def margins(self, gait: Candidate) -> Rows:
        """No margins: the violations are in the objective."""
        return np.zeros(0), np.zeros((0, len(gait.at)))


@dataclass(frozen=True, eq=False)
class Ended:
    """End of a search within a box."""

    best: Candidate
    """Gait of least merit among the iterates in the region."""
    beyond: Candidate | None
    """Iterate in another region that ended the search, if any."""
    lost: str
    """Reason why an iterate that ended the search is no gait; else empty."""


class _LeftError(Exception):
    """An iterate is outside of the region."""


def minimize(
    problem: Problem,
    follow: Callable[[Candidate, NDArray[np.float64]], Candidate],
    begin: Candidate,
    box: tuple[NDArray[np.float64], NDArray[np.float64]],
    is_inside: Callable[[Candidate], bool] = lambda gait: True,
    accuracy: float = ACCURACY,
) -> Ended:
    """Best gait of a region in a box (low, high), and why the search left the region, if it did."""
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
        if len(rows(begin)[0])
    ]
    with contextlib.suppress(_LeftError):
        by_scipy(
            lambda coordinates: problem.objective(at(coordinates))[0],
            begin.at,
            jac=lambda coordinates: problem.objective(at(coordinates))[1],
            method="SLSQP",
            bounds=list(zip(*box, strict=True)),
            constraints=constraints,
            options={"maxiter": ITERATIONS, "ftol": accuracy},
        )
    return Ended(min(seen, key=problem.merit), **ended)
