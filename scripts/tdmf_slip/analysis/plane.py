"""Gaits over two parameters at which an eigenvalue is where a bifurcation puts it.

With a gait's point u, its apex z and both parameters, the equations are P(u) - z = 0 and g(u) = 0. On a curve
of folds g is det(J - I), on one of period doublings det(J + I), and on one of Neimark-Sacker points the
determinant of J's bialternate product less I: the product of all (a b - 1) over pairs of eigenvalues.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.gait import Gait
from ..library.members import check_varied
from ..library.quantities import scales_of
from ..library.runner import Runner
from ..library.strides import strides_from
from .bifurcations import FOLD, NEIMARK_SACKER, PERIOD_DOUBLING
from .corrector import corrected
from .walking_back import reaches

DIFFERENCE = 1e-6
"""Over the scales: by how much points differ by which g is differentiated."""


@dataclass(frozen=True, eq=False)
class CurvePoint:
    """A gait over two parameters, with the derivatives of its equations."""

    at: NDArray[np.float64]
    """Apex and parameters, over the scales."""
    gait: Gait
    """The gait."""
    matrix: NDArray[np.float64]
    """Derivatives of the equations, shape (n + 1, n + 2)."""

    @property
    def tangent(self) -> NDArray[np.float64]:
        """Unit tangent of the curve."""
        tangent: NDArray[np.float64] = np.linalg.svd(self.matrix)[2][-1]
        return tangent


def bialternate(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """The bialternate product of a matrix with itself: its eigenvalues are the products of pairs."""
    pairs = list(combinations(range(len(matrix)), 2))
    rows = [[matrix[i, k] * matrix[j, m] - matrix[i, m] * matrix[j, k] for k, m in pairs] for i, j in pairs]
    return np.array(rows)


def _determinant(matrix: NDArray[np.float64], number: float) -> float:
    return float(np.linalg.det(matrix - number * np.eye(len(matrix))))


TESTS: Mapping[str, Callable[[NDArray[np.float64]], float]] = {
    FOLD: lambda jacobian: _determinant(jacobian, 1.0),
    PERIOD_DOUBLING: lambda jacobian: _determinant(jacobian, -1.0),
    NEIMARK_SACKER: lambda jacobian: _determinant(bialternate(jacobian), 1.0),
}
"""Functions of the Jacobian that are zero on a curve, by its kind."""


class Plane:
    """Gaits of one runner over two parameters."""

    def __init__(self, runner: Runner, names: tuple[str, str], kind: str, strides: int = 1) -> None:
        """Whose gaits, over which parameters or inputs, and which bifurcation is looked for."""
        for name in names:
            check_varied(name, "name")
        self.runner, self.names, self.kind, self.strides = runner, names, kind, strides
        self.scales = scales_of(runner, names)

    def strides_at(self, at: NDArray[np.float64], along: str) -> Gait:
        """The strides from a point over the scales, differentiated by one of the parameters, too."""
        values = at * self.scales
        runner = self.runner.replace(dict(zip(self.names, map(float, values[-2:]), strict=True)))
        return strides_from(runner, values[:-2], self.strides, along=along)

    def zero(self, gait: Gait) -> float:
        """The function that is zero on the curve."""
        return TESTS[self.kind](gait.jacobian)

    def evaluate(self, at: NDArray[np.float64]) -> CurvePoint:
        """A point with all derivatives: those of g by differences."""
        both = [self.strides_at(at, name) for name in self.names]
        scales, dimension = self.scales[:-2], len(at) - 2
        by_parameters = np.array([gait.by_parameter for gait in both]).T
        rows = (
            np.hstack([both[0].jacobian - np.eye(dimension), by_parameters]) * self.scales / scales[:, None]
        )
        steps = DIFFERENCE * np.eye(len(at))
        shifted = [
            [self.zero(self.strides_at(at + s * e, self.names[0])) for e in steps] for s in (1.0, -1.0)
        ]
        gradient = (np.array(shifted[0]) - np.array(shifted[1])) / (2.0 * DIFFERENCE)
        matrix = np.vstack([rows, gradient])
        if not np.isfinite(matrix).all():
            raise RunError("a gait has no derivatives")
        return CurvePoint(at, both[0], matrix)

    def corrected(
        self, goal: NDArray[np.float64], normal: NDArray[np.float64], near: CurvePoint
    ) -> CurvePoint:
        """The point of the curve near a goal on the plane across a direction, from a point that is near."""
        curve = self._equations(near)
        return self.evaluate(corrected(curve, goal, normal, rows=curve.scaled(near.matrix)))

    def _equations(self, near: CurvePoint) -> "_Curve":
        return _Curve(self, float(np.linalg.norm(near.matrix[-1])))

    def leads_back(self, found: CurvePoint, known: CurvePoint) -> bool:
        """The corrector that starts from one point's tangent finds another, from which the first was found.

        Where it does not, they are of two curves, or the way from one to the other is too long.
        """
        curve, tangent = self._equations(found), found.tangent
        goal = found.at - ((found.at - known.at) @ tangent) * tangent
        return reaches(curve, goal, tangent, known.at, found.at, curve.scaled(found.matrix))


@dataclass(frozen=True)
class _Curve:
    """Equations of a curve; the last one is over the size of its gradient nearby."""

    plane: Plane
    size: float

    def residual(self, coordinates: NDArray[np.float64]) -> NDArray[np.float64]:
        return self._off(self.plane.strides_at(coordinates, self.plane.names[0]))

    def linearize(self, coordinates: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        point = self.plane.evaluate(coordinates)
        return self._off(point.gait), self.scaled(point.matrix)

    def scaled(self, matrix: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.vstack([matrix[:-1], matrix[-1:] / self.size])

    def _off(self, gait: Gait) -> NDArray[np.float64]:
        return np.append(gait.left_over / self.plane.scales[:-2], self.plane.zero(gait) / self.size)
