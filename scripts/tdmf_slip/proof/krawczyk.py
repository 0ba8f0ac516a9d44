"""Fixed points of the stride: found, and proved by Krawczyk's operator.

With G(x) = P(x) - x and a point matrix Y near the inverse of its derivative,

    K(X) = m - Y G(m) + (I - Y DG(X)) (X - m)

holds every zero of G in the box X around m; where K(X) lies in the interior of X, there is exactly one.
What is proved rests on balls alone; how m and Y were found does not matter.
"""

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from flint import acb, acb_mat, arb, arb_mat, ctx
from numpy.typing import NDArray
from scipy.linalg import eig

from .dual import UndecidedError, absolute, floats_above, greatest, identity, row_sums
from .parameters import Forced, Parameters
from .proof import Box
from .starts import Starts
from .stride import Traveller
from .travelling_set import SetTraveller

SMALL = 1e6
"""Eigenvalues of at most so many times the enclosure's width are treated like those that vanish."""
LARGE = 0.05
"""Eigenvalues above this share of the largest one are kept in any case. A norm is rounder without others."""


def eigenvalues(matrix: arb_mat, rank: int) -> list[acb]:
    """Discs that hold all eigenvalues of every matrix of rank at most `rank` in an enclosure.

    The largest comes first. Discs that overlap hold, together, as many eigenvalues as there are discs.
    """
    size = matrix.nrows()
    try:
        discs = acb_mat(matrix).eig(multiple=True)
    except ValueError:
        return [acb("nan")] * size
    if sum(disc.contains(0) for disc in discs) == size - rank:  # these hold the eigenvalues that vanish
        discs = [acb(0) if disc.contains(0) else disc for disc in discs]
    real = [_real_if_alone(disc, k, discs) for k, disc in enumerate(discs)]
    return sorted(real, key=lambda disc: -float(abs(disc).mid()))


def stability(matrix: arb_mat) -> bool | None:
    """True if all eigenvalues are proved to be inside the unit circle, False if one is proved to be outside.

    The answer is None if neither is proved.

    Gershgorin's discs prove that one is outside, in a basis in which the matrix is nearly diagonal.
    """
    if contraction(matrix)[0] < 1:
        return True
    basis = _basis(matrix, LARGE)
    turned = basis.solve(acb_mat(matrix) * basis)
    sizes = absolute(turned)
    for k, row in enumerate(sizes):
        row[k] = arb(0)
    radii = [arb(0, row.upper()) for row in row_sums(sizes, [arb(1)] * len(sizes))]
    discs = [turned[k, k] + acb(radius, radius) for k, radius in enumerate(radii)]
    outside = [disc for disc in discs if abs(disc) > 1]
    rest = [disc for disc in discs if not abs(disc) > 1]
    return False if any(not any(disc.overlaps(other) for other in rest) for disc in outside) else None


def contraction(matrix: arb_mat) -> tuple[arb, acb_mat, list[float]]:
    """A norm in which every matrix of an enclosure is small, and how small.

    In a basis in which the matrix is nearly diagonal, the largest weighted sum of a row bounds the norm.
    """
    basis = _basis(matrix, np.inf)
    turned = basis.solve(acb_mat(matrix) * basis)
    sizes = absolute(turned)
    weights = [float(w) for w in _weights(floats_above(sizes), basis)]
    rows = row_sums(sizes, [arb(w) for w in weights])
    bound = greatest(rows) if all(row.is_finite() for row in rows) else arb("inf")
    return bound, basis, weights


def _weights(sizes: NDArray[np.float64], basis: acb_mat) -> NDArray[np.float64]:
    """Weights with which sums of rows are below 1, if there are any: w = v + B w/kappa.

    Here v is the extent of the unit cube, which makes the ball of the norm as round as possible.
    """
    largest = spectral_radius(sizes)
    inverse = np.array([[complex(x) for x in row] for row in basis.inv().tolist()])
    extent: NDArray[Any] = np.sum(np.abs(inverse), axis=1)
    if not largest < 1.0:
        return extent
    rate = 0.5 * (1.0 + largest)
    found: NDArray[np.float64] = np.linalg.solve(np.eye(len(sizes)) - sizes / rate, extent)
    return found


def _basis(matrix: arb_mat, large: float) -> acb_mat:
    """Approximate eigenvectors, and a complement of those that are left out. No proof rests on them."""
    width = max(float(x.rad()) for x in matrix.entries()) + 1e-300
    values, left, right = eig(middle_of(matrix), left=True, right=True)
    sizes = np.abs(values)
    kept = sizes > min(SMALL * width, large * np.max(sizes))
    spare = np.linalg.svd(left[:, kept].conj().T)[2][np.count_nonzero(kept) :]
    return acb_mat(np.hstack([right[:, kept], spare.conj().T]).tolist())


def _real_if_alone(disc: acb, k: int, discs: list[acb]) -> acb:
    """One eigenvalue alone in a disc that meets the real axis is real: its conjugate would lie there, too."""
    mirrored = acb(disc.real, -disc.imag)
    if disc.imag.is_zero():
        return disc
    alone = not any(
        disc.overlaps(other) or mirrored.overlaps(other) for i, other in enumerate(discs) if i != k
    )
    return acb(disc.real) if alone and disc.imag.contains(0) else disc


COARSE_BITS = 64
"""Bits of the working precision where few digits are asked for."""
MAX_STEPS = 12
FIRST_ERROR = 1e-3
"""Error before the first step, by which the share that a step leaves is guessed."""
SHARPENINGS = 12
ROOM = 1.3
"""Width of a box that is tried next, over that which the operator would just map into itself."""
TINY = 1e-13


def refined(
    parameters: Parameters,
    apex: Sequence[arb],
    jacobian: NDArray[Any],
    bits: int,
    nearness: float,
    forced: Forced | None = None,
) -> list[arb]:
    """A point near the fixed point, by Newton's method with one Jacobian; nothing is proved."""
    unknowns = len(jacobian)
    found = list(apex)
    with ctx.workprec(bits):
        points = point_inverse(jacobian)
        last = FIRST_ERROR
        for _ in range(MAX_STEPS):
            left = residual(Traveller(parameters, found, bits, forced).stride(), found)[:unknowns]
            step = points * arb_mat(unknowns, 1, left)
            found[:unknowns] = [(x - dx).mid() for x, dx in zip(found, step.entries(), strict=False)]
            size = float(max(abs(dx).upper() for dx in step.entries()))
            if not size < 0.5 * last or size * size / last < nearness:
                break
            last = size
    return found


def residual(stride: Traveller, centre: Sequence[arb]) -> list[arb]:
    """Residual at a fixed point and on a border: the way from apex to apex, and the margin."""
    return [*(after - x for after, x in zip(stride.end, centre, strict=False)), stride.margin]


def point_inverse(matrix: NDArray[Any]) -> arb_mat:
    """Points near the inverse of a matrix."""
    try:
        inverse = np.linalg.inv(matrix)
    except np.linalg.LinAlgError:
        raise UndecidedError("the inverse of the stride's derivative") from None
    return arb_mat(inverse.tolist())


def slopes_of(stride: Traveller, tilt: Sequence[arb] = ()) -> arb_mat:
    """Derivatives of the residual by the start: six rows, and one for the margin of a forced event."""
    columns = stride.derivative.ncols()
    rows = stride.derivative.tolist()
    for i in range(6):
        rows[i][i] -= 1
    for i, slope in enumerate(tilt):
        rows[i][6] -= slope
    if stride.margin_slopes:
        rows.append(stride.margin_slopes)
    return arb_mat(len(rows), columns, [x for row in rows for x in row])


def middle_of(matrix: arb_mat) -> NDArray[np.float64]:
    """Midpoints of a matrix as doubles."""
    middle = np.array([[float(x.mid()) for x in row] for row in matrix.tolist()])
    if not np.all(np.isfinite(middle)):
        raise UndecidedError("the derivative of the stride")
    return middle


def unique_box(
    parameters: Parameters,
    radii: Sequence[Fraction],
    box_of: Callable[[Fraction], Box],
    beyond: int,
    forced: Forced | None = None,
) -> Box:
    """The first of some boxes in which exactly one fixed point is proved to lie."""
    problem = UndecidedError("the inclusion of the fixed point in the box")
    for radius in radii:
        bits, box = max(COARSE_BITS, beyond + round(-math.log2(radius))), box_of(radius)
        with ctx.workprec(bits):
            starts = box.starts()
        try:
            Inclusion(parameters, starts, bits, forced)
            return box
        except UndecidedError as undecided:
            problem = undecided
    raise problem


class NotIncludedError(UndecidedError):
    """The operator does not map a box into itself."""

    def __init__(self, box: list[float] | None) -> None:
        """Radii of a box that it may map into itself, if there are any."""
        super().__init__("the inclusion of the fixed point in the box")
        self.box = box


class Inclusion:
    """Krawczyk's operator on a box, and what it proves."""

    def __init__(
        self, parameters: Parameters, starts: Starts, bits: int, forced: Forced | None = None
    ) -> None:
        """Compute the operator by the stride of all starts of the box."""
        self.stride = SetTraveller(parameters, starts, bits, forced).stride()
        with ctx.workprec(bits):
            self._solve(starts, residual(self.stride, starts.centre), slopes_of(self.stride, starts.tilt))

    def _solve(self, starts: Starts, left: list[arb], slopes: arb_mat) -> None:
        unknowns = slopes.nrows()
        square = arb_mat(unknowns, unknowns, [slopes[i, j] for i in range(unknowns) for j in range(unknowns)])
        inverse = point_inverse(middle_of(square))
        shift = -(inverse * arb_mat(unknowns, 1, left[:unknowns]))
        if slopes.ncols() > unknowns:  # G(m, q) lies in G(m, middle of q) + DG (q - middle)
            by = arb_mat(unknowns, 1, [slopes[i, unknowns] for i in range(unknowns)])
            shift = shift - inverse * by * arb_mat(1, 1, [arb(0, starts.radii[unknowns])])
        rest = identity(unknowns) - inverse * square
        radii = arb_mat(unknowns, 1, [arb(0, r) for r in starts.radii[:unknowns]])
        image = shift + rest * radii
        balls = zip(image.entries(), starts.radii, strict=False)
        widths = floats_above(absolute(rest))
        self.contraction = spectral_radius(widths)
        """Approximate share of the box that the operator leaves; 1 or more proves nothing."""
        if not all(ball.is_finite() and abs(ball) < radius for ball, radius in balls):
            raise NotIncludedError(self._better_box(widths, floats_above(absolute(shift))))
        for _ in range(SHARPENINGS):
            image = shift + rest * image
        self.image = [float(abs(ball).upper()) for ball in image.entries()]
        """Radii around the centre that hold the solution, to rounding of doubles."""
        self.solution = [x + dx for x, dx in zip(starts.centre, image.entries(), strict=False)]
        """Enclosure of the solution, shape (6,) or (7,)."""

    def _better_box(self, widths: NDArray[np.float64], shift: NDArray[np.float64]) -> list[float] | None:
        """Radii of a box just larger than the solution of  box = shift + widths box."""
        if not self.contraction < 1.0:
            return None
        minimum = np.linalg.solve(np.eye(len(widths)) - widths, shift.ravel())
        return [ROOM * max(size, TINY) for size in minimum]


def spectral_radius(matrix: NDArray[np.float64]) -> float:
    """The largest size of an eigenvalue; infinite where an entry is not finite."""
    return float(np.max(np.abs(np.linalg.eigvals(matrix)))) if np.all(np.isfinite(matrix)) else math.inf
