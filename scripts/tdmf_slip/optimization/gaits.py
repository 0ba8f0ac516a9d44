"""Gaits over several parameters, with the gradients of their quantities and of their eigenvalues.

Gradients of quantities are exact, by `library.strides`. The library has no second derivatives. The derivative
of the Jacobian along the gaits therefore comes from central differences of exact Jacobians, of strides that
begin on the tangent of the gaits. Parameters are scaled by their bounds, from 0 to 1.

An eigenvalue of the Jacobian J with left and right eigenvectors y, x changes by y^H dJ x / y^H x, and its
size by the component along the eigenvalue. The spectral radius has no derivative if two eigenvalues have the
same size. Each of the leading eigenvalues is therefore kept, one of a complex pair. The radius is at most R
if each of their sizes is, and these are smooth. Where two eigenvalues meet, they have no derivative.

det(I - J)^2 measures the distance from a fold, where it goes to zero linearly with the parameters.
"""

import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.strides import strides_from, varied_gait
from ..numerics.walking import walk

AT_BOUND = 1e-9
"""Distance from a bound, over the width, at which the bound is active."""
ROUNDING = 1e-14
"""Distance from a bound, over the width, that counts as rounding."""
LEADING = 3
"""Number of leading eigenvalues; a complex pair counts once."""
MINIMUM = 1e-3
"""Size below which an eigenvalue counts as zero."""
SIMPLE = 1e-7
"""Least product of unit left and right eigenvectors; below it, two eigenvalues meet."""
CENTRAL: Mapping[float, float] = {1.0: 0.5, -1.0: -0.5}
FORWARD: Mapping[float, float] = {0.0: -1.5, 1.0: 2.0, 2.0: -0.5}
BACKWARD: Mapping[float, float] = {0.0: 1.5, -1.0: -2.0, -2.0: 0.5}
OPEN_FORWARD: Mapping[float, float] = {1.0: -2.5, 2.0: 4.0, 3.0: -1.5}
OPEN_BACKWARD: Mapping[float, float] = {-1.0: 2.5, -2.0: -4.0, -3.0: 1.5}
"""Differences of second order: weights by number of steps.

The last two do without the gait itself, which may be on the edge of a region. For example, a thrust of zero
is no event, and any other thrust is one."""
SHORTEST_SHARE = 2.0**-5
"""Shortest step, as a share of the distance between two gaits."""
FARTHEST = 0.7
"""Largest distance of a gait from its prediction, over its distance from the gait before."""
NEAR = 1e-2
"""Distance of a gait from its prediction, over the scales, up to which it belongs to the branch.

The gait must be on the same side of the fold, too."""
DIFFERENCES = (1e-5, 1e-7)
"""Steps of differences along the gaits, over the width of the bounds; the second is for narrow regions."""

SLANTS = (1.0, -1.0, 10.0, -10.0)
"""Slopes of directions between two parameters."""
ON_EDGE = "the gait is on the edge of an event, where its eigenvalues have no derivatives"
ROOM, OFF_FOLDS = 0.05, 1e-2
"""Distances of the spectrum from its limit and from folds beyond which its derivatives do not matter."""


Rows: TypeAlias = tuple[NDArray[np.float64], NDArray[np.float64]]
"""Values, shape (m,), and their gradients in rows, shape (m, d)."""
Known: TypeAlias = tuple[Gait, NDArray[np.float64]]
"""Gait, and the derivatives of its apex by the parameters."""


@dataclass(frozen=True, eq=False)
class Space:
    """Parameters and inputs between bounds."""

    bounds: Mapping[str, tuple[float, float]]
    """Lower and upper bound by name, in the unit's unit."""

    @property
    def low(self) -> NDArray[np.float64]:
        """Lower bounds, shape (d,)."""
        return np.array([low for low, _ in self.bounds.values()])

    @property
    def high(self) -> NDArray[np.float64]:
        """Upper bounds, shape (d,)."""
        return np.array([high for _, high in self.bounds.values()])

    @property
    def width(self) -> NDArray[np.float64]:
        """Distances between the bounds, shape (d,)."""
        return self.high - self.low

    def values(self, at: NDArray[np.float64]) -> dict[str, float]:
        """Values of the parameters by name, at coordinates from 0 to 1.

        A coordinate within rounding of a bound is set to the bound.
        """
        near = np.round(at)
        at = np.where(np.abs(at - near) <= ROUNDING, near, at)
        values = (1.0 - at) * self.low + at * self.high
        return dict(zip(self.bounds, map(float, values), strict=True))

    def runner_at(self, runner: Runner, at: NDArray[np.float64]) -> Runner:
        """Runner with the values of a point in the space."""
        return runner.replace(self.values(at))

    def coordinates_of(self, runner: Runner) -> NDArray[np.float64]:
        """Coordinates of a runner's values between the bounds, from 0 to 1, shape (d,)."""
        values = np.array([runner[name] for name in self.bounds])
        coordinates: NDArray[np.float64] = (values - self.low) / self.width
        return coordinates

    def active(self, at: NDArray[np.float64]) -> dict[str, str]:
        """Active bounds by the names of the parameters: `lower` or `upper`."""
        coordinates = dict(zip(self.bounds, at, strict=True))
        low = {name: "lower" for name, share in coordinates.items() if share <= AT_BOUND}
        return low | {name: "upper" for name, share in coordinates.items() if share >= 1.0 - AT_BOUND}


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Sizes of leading eigenvalues."""

    sizes: NDArray[np.float64]
    """Sizes, the largest first, shape (m,)."""
    slopes: NDArray[np.float64]
    """Gradients of the sizes, in rows, shape (m, d)."""
    positive: NDArray[np.bool_]
    """True for positive real eigenvalues, shape (m,)."""
    fold: float
    """Square of det(I - J), which vanishes at a fold."""
    fold_slopes: NDArray[np.float64]
    """Gradient of `fold`, shape (d,)."""

    @classmethod
    def none(cls, count: int) -> "Spectrum":
        """Empty spectrum over `count` parameters."""
        return cls(np.zeros(0), np.zeros((0, count)), np.zeros(0, dtype=bool), np.inf, np.zeros(count))

    def along(self, directions: NDArray[np.float64]) -> "Spectrum":
        """Spectrum with gradients along directions, which are columns, shape (d, e)."""
        return Spectrum(
            self.sizes, self.slopes @ directions, self.positive, self.fold, self.fold_slopes @ directions
        )


def spectrum_of(
    jacobian: NDArray[np.float64], variations: Sequence[NDArray[np.float64]], simple: bool = True
) -> Spectrum:
    """Sizes of the leading eigenvalues with their gradients, and the distance from a fold."""
    from scipy.linalg import eig  # slow to load

    values, left, right = eig(jacobian, left=True)
    leading = [k for k in np.argsort(-np.abs(values), kind="stable") if values[k].imag >= 0.0][:LEADING]
    sizes, slopes = np.zeros(LEADING), np.zeros((LEADING, len(variations)))
    positive = np.zeros(LEADING, dtype=bool)
    for row, k in enumerate(leading):
        sizes[row] = abs(values[k])
        positive[row] = values[k].imag == 0.0 and values[k].real > 0.0
        if simple and sizes[row] > MINIMUM:
            slopes[row] = _slopes(values[k], left[:, k].conj(), right[:, k], variations)
    return Spectrum(sizes, slopes, positive, *_fold(jacobian, variations))


def _fold(
    jacobian: NDArray[np.float64], variations: Sequence[NDArray[np.float64]]
) -> tuple[float, NDArray[np.float64]]:
    """det(I - J)^2 and its gradient, by Jacobi's formula for the derivative of a determinant."""
    matrix = np.eye(len(jacobian)) - jacobian
    fold = float(np.linalg.det(matrix)) ** 2
    traces = [np.trace(np.linalg.solve(matrix, variation)) for variation in variations]
    return fold, -2.0 * fold * np.array(traces)


def _slopes(
    value: complex, left: NDArray[Any], right: NDArray[Any], variations: Sequence[NDArray[np.float64]]
) -> list[float]:
    """Gradient of an eigenvalue's size, by y^H and x."""
    product = left @ right
    if abs(product) < SIMPLE:
        raise RunError("two leading eigenvalues of the gait meet, where they have no derivative")
    towards = np.conj(value) / abs(value)
    return [float((towards * (left @ variation @ right) / product).real) for variation in variations]


@dataclass(frozen=True, eq=False)
class Candidate:
    """Gait with the gradients of its quantities by the parameters, which are scaled by their bounds."""

    at: NDArray[np.float64]
    """Parameters, scaled by their bounds, from 0 to 1, shape (d,)."""
    gait: Gait
    """Gait at these parameters."""
    apex_slopes: NDArray[np.float64]
    """Derivatives of the apex by the parameters, shape (n, d)."""
    values: NDArray[np.float64]
    """Values of the requested quantities, shape (q,)."""
    slopes: NDArray[np.float64]
    """Gradients of the quantities, in rows, shape (q, d)."""
    spectrum: Spectrum
    """Sizes of the leading eigenvalues with their gradients; empty if they were not requested."""

    @property
    def margins(self) -> Rows:
        """Margins of bounds on the parameters beyond those on `at`: none."""
        return np.zeros(0), np.zeros((0, len(self.at)))

    @property
    def region(self) -> tuple[object, ...]:
        """Word and events of the stride; all functions are smooth while these stay."""
        return self.gait.sequence


class Gaits:
    """Gaits of a runner over several parameters."""

    def __init__(
        self,
        runner: Runner,
        space: Space,
        names: Sequence[str],
        spectrum: bool = False,
        radius: float | None = None,
    ) -> None:
        """Keep the runner, the parameters, and the names of the requested quantities.

        `spectrum` requests eigenvalues, and `radius` is their limit, if any.
        """
        self.runner, self.space, self.names, self.with_spectrum = runner, space, tuple(names), spectrum
        self.radius = np.inf if radius is None else radius

    def candidate(self, gait: Gait, at: NDArray[np.float64] | None = None) -> Candidate:
        """Gait with its gradients; `at` is by default that of its runner."""
        at = self.space.coordinates_of(gait.runner) if at is None else at
        varied = varied_gait(gait.runner, gait.apex, self.names, list(self.space.bounds))
        apex_slopes = varied.apex_by_parameters * self.space.width
        spectrum = Spectrum.none(len(at))
        if self.with_spectrum:
            spectrum = self._spectrum(gait, at, apex_slopes)
        slopes = varied.by_parameters * self.space.width
        return Candidate(at, gait, apex_slopes, varied.quantities, slopes, spectrum)

    def _spectrum(self, gait: Gait, at: NDArray[np.float64], apex_slopes: NDArray[np.float64]) -> Spectrum:
        """Spectrum of a gait, without slopes if they do not exist and no limit is near."""
        try:
            return spectrum_of(gait.jacobian, self._jacobian_variations(gait, at, apex_slopes))
        except RunError:
            spectrum = spectrum_of(gait.jacobian, [np.zeros_like(gait.jacobian)] * len(at), simple=False)
            if spectrum.sizes[0] > self.radius - ROOM or spectrum.fold < OFF_FOLDS:
                raise
            return spectrum

    def _jacobian_variations(
        self, gait: Gait, at: NDArray[np.float64], apex_slopes: NDArray[np.float64]
    ) -> list[NDArray[np.float64]]:
        """Derivatives of the map's Jacobian along the gaits, by each parameter.

        On the border of a region, both ways along a parameter may leave the region or the bounds. A direction
        between two parameters may stay inside. If the derivative by one of them is known, it gives the other.
        """

        def along(direction: NDArray[np.float64]) -> NDArray[np.float64]:
            def stride(step: float) -> Gait:
                runner = self.space.runner_at(self.runner, at + step * direction)
                return strides_from(runner, gait.apex + step * (apex_slopes @ direction))

            return _jacobian_variation(gait, stride)

        directions: list[NDArray[np.float64]] = []
        variations: list[NDArray[np.float64]] = []

        def add(direction: NDArray[np.float64]) -> None:
            if np.linalg.matrix_rank([*directions, direction]) > len(directions):
                with contextlib.suppress(RunError):
                    variations.append(along(direction))
                    directions.append(direction)

        axes = np.eye(len(at))
        for axis in axes:
            add(axis)
        for axis, (known, slant) in product(axes, product([*directions], SLANTS)):
            add(axis + slant * known)
        if len(directions) < len(axes):
            raise RunError(ON_EDGE)
        return list(np.tensordot(np.linalg.inv(directions), variations, axes=1))

    def gait_from(self, near: Candidate, at: NDArray[np.float64]) -> Gait:
        """Gait at a point, followed from a known gait on the same branch.

        Steps become shorter if a gait is far from its prediction along the tangent, or if the sign of
        det(I - J) shows that it belongs to another branch. Only gaits that run forward count.
        """
        way = at - near.at

        def advance(known: Known, done: float, to: float) -> Known:
            gait, slopes = known
            there = at if to == 1.0 else near.at + to * way
            guess = gait.apex + slopes @ (there - (near.at + done * way))
            try:
                found = self._checked(there, guess, gait)
                return found, slopes if to == 1.0 else self.candidate(found, there).apex_slopes
            except InputError as problem:
                raise RunError(str(problem)) from None

        *_, (_, (found, _)) = walk((near.gait, near.apex_slopes), 0.0, 1.0, advance, shortest=SHORTEST_SHARE)
        return found

    def _checked(self, at: NDArray[np.float64], guess: NDArray[np.float64], before: Gait) -> Gait:
        found = gait_near(self.space.runner_at(self.runner, at), guess)
        if found.stride["length"] <= 0.0:
            raise RunError("the gait there does not run forward")
        scales = found.runner.scales
        off, way = (float(np.linalg.norm((found.apex - apex) / scales)) for apex in (guess, before.apex))
        if off > max(NEAR, FARTHEST * way) or (_orientation(found) != _orientation(before)):
            raise RunError("the gait there is of another branch")
        return found

    def follow(self, near: Candidate, at: NDArray[np.float64]) -> Candidate:
        """Gait at a point with its gradients, followed from a known gait."""
        return self.candidate(self.gait_from(near, at), at)


def _orientation(gait: Gait) -> bool:
    """Side of a fold: True if det(I - J) is positive."""
    return bool(np.linalg.det(np.eye(len(gait.jacobian)) - gait.jacobian) > 0.0)


def _jacobian_variation(gait: Gait, stride: Callable[[float], Gait]) -> NDArray[np.float64]:
    """Derivative of the Jacobian by differences on both sides of a gait, or on one in the same region."""
    for length, weights in product(DIFFERENCES, (CENTRAL, FORWARD, BACKWARD, OPEN_FORWARD, OPEN_BACKWARD)):
        try:
            gaits = [stride(length * steps) if steps else gait for steps in weights]
        except (InputError, RunError):
            continue
        if len({other.sequence for other in gaits}) == 1 and gaits[0].word == gait.word:
            terms = [w / length * other.jacobian for w, other in zip(weights.values(), gaits, strict=True)]
            variation: NDArray[np.float64] = np.sum(terms, axis=0)
            return variation
    raise RunError(ON_EDGE)
