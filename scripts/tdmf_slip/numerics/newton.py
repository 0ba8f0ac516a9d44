"""Newton's method that keeps its Jacobian while steps without a new one converge.

A stride with its exact Jacobian costs as much as seventeen plain ones. So the Jacobian is computed where the
last step did not make the residual ten times smaller, and kept where it did. A step by a kept Jacobian that
does less is undone. So a search takes the damped steps of Newton's method, and plain strides near its end.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError, counted

KEPT = 0.1
"""A Jacobian is kept as long as each step leaves at most this share of the residual."""
CONVERGED, GOOD_ENOUGH = 1e-13, 1e-11
"""Residual at which the search stops, and that of a solution where rounding leaves more."""

Vector: TypeAlias = NDArray[np.float64]
Matrix: TypeAlias = NDArray[np.float64]


class Equations(Protocol):
    """Equations in scaled unknowns. Both methods raise RunError or InputError where there is no value."""

    def residual(self, x: Vector) -> Vector:
        """Residual, shape (m,)."""

    def linearize(self, x: Vector) -> tuple[Vector, Matrix]:
        """Residual and exact Jacobian, shape (m, n)."""


@dataclass(frozen=True, eq=False)
class Iterate:
    """A point of the search."""

    x: Vector
    """Unknowns."""
    residual: Vector
    """Residual of the equations."""
    iterations: int = 0
    """Number of steps until here."""

    @cached_property
    def error(self) -> float:
        """Largest residual."""
        return float(np.abs(self.residual).max())


class NotSolvedError(RunError):
    """The residual no longer gets smaller, and is too large for a solution."""

    def __init__(self, last: Iterate) -> None:
        """Error with the last iterate."""
        super().__init__(
            f"Newton's method stopped after {counted(last.iterations, 'iteration')} "
            f"with a residual of {last.error:.2g}"
        )
        self.last = last


def solve(
    equations: Equations,
    x: Vector,
    *,
    jacobian: Matrix | None = None,
    iterations: int = 40,
    shortenings: int = 12,
    gain: float = 1.0,
    longest: float = np.inf,
) -> Iterate:
    """Solve equations from an initial guess; with fewer equations than unknowns by the shortest steps.

    `jacobian` is one from nearby. A damped step is tried at several lengths, each half of the one before,
    until it leaves less than `gain` of the residual; it changes no unknown by more than `longest`. With no
    shortenings whole steps are taken wherever they lead: where an event is just touched the map has a square
    root, and only whole steps lead across.

    Raises NotSolvedError, or what the equations raise at the initial guess.
    """
    at = Iterate(np.asarray(x, dtype=float), equations.residual(x))
    is_exact = False
    while at.iterations < iterations and not at.error <= CONVERGED:
        if jacobian is None:
            residual, jacobian = equations.linearize(at.x)
            at, is_exact = Iterate(at.x, residual, at.iterations), True
        try:
            step = _step(jacobian, at.residual, longest)
        except np.linalg.LinAlgError:
            if at.error <= GOOD_ENOUGH:
                break
            raise RunError("Newton's method reached a point where the Jacobian is singular") from None
        if is_exact:
            following = _damped(equations, at, step, shortenings, gain)
            if following is None:
                break
        else:
            following = _moved(equations, at, step)
        is_fast = following is not None and following.error <= KEPT * at.error
        if following is not None and (is_exact or is_fast):
            at = following
        elif at.error <= GOOD_ENOUGH:
            break  # the residual is rounding
        jacobian, is_exact = jacobian if is_fast and shortenings else None, False
    if not at.error <= GOOD_ENOUGH:
        raise NotSolvedError(at)
    return at


def _step(jacobian: Matrix, residual: Vector, longest: float) -> Vector:
    if jacobian.shape[0] == jacobian.shape[1]:
        step: NDArray[Any] = np.linalg.solve(jacobian, -residual)
    else:
        step = np.linalg.lstsq(jacobian, -residual)[0]
    length = float(np.abs(step).max())
    return step * (longest / length) if length > longest else step


def _moved(equations: Equations, at: Iterate, step: Vector) -> Iterate | None:
    """The next iterate; None where it has no residual."""
    try:
        return Iterate(at.x + step, equations.residual(at.x + step), at.iterations + 1)
    except (InputError, RunError):
        return None


def _damped(equations: Equations, at: Iterate, step: Vector, shortenings: int, gain: float) -> Iterate | None:
    """The iterate at the longest part of a step that serves; None where none does."""
    if not shortenings:
        try:
            following = Iterate(at.x + step, equations.residual(at.x + step), at.iterations + 1)
        except InputError as problem:
            raise RunError(f"Newton's method leads to what is not allowed: {problem}") from None
        return following if following.error < GOOD_ENOUGH or at.error > GOOD_ENOUGH else None
    for shortening in range(shortenings):
        tried = _moved(equations, at, 0.5**shortening * step)
        if tried is not None and tried.error < gain * at.error:
            return tried
    return None
