"""A ball around a stable gait from which every runner is proved to settle on it.

If the stride maps a box with a derivative that is below kappa < 1 in some norm, then every ball of that
norm around the gait in the box goes into itself, and strides bring its points nearer by kappa each (mean
value theorem).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np
from flint import acb_mat, arb, ctx

from ..analysis.ball import Ball, cube_in
from ..errors import InputError, RunError
from ..library.batch_given import MIN_TOLERANCE
from ..library.gait import Gait
from ..library.shared_steps import shares_steps
from ..version import __version__
from .dual import UndecidedError
from .given import Exact, RunnerLike, ball_of, gait_of
from .krawczyk import Inclusion, contraction
from .parameters import Parameters
from .proof import Proved, short
from .starts import Fineness, Starts

BOXES = tuple(Fraction(digit, 10**decimals) for decimals in range(3, 13) for digit in (5, 2, 1))
"""Radii that are tried, in units of the coordinates' scales."""
BITS = 64


@dataclass(frozen=True, repr=False)
class Attraction(Proved):
    """Starts that are proved to settle on a gait."""

    proved: bool
    """False is undecided."""
    values: Mapping[str, Exact] = field(repr=False)
    """The runner's parameters, exactly, by the unit's names."""
    radius: float = 0.0
    """Every apex no farther from the gait's in any coordinate, in units of the scales, settles on it."""
    rate: float = 1.0
    """Upper bound of the factor by which each stride shrinks the distance, in the norm of `basis`."""
    box: Fraction = Fraction(0)
    """Radius of the box in which the derivative was enclosed, in units of the scales."""
    norm_radius: float = 0.0
    """Radius of the ball: the largest ``|(S^-1 x)_i| / w_i`` in it."""
    basis: Sequence[Sequence[complex]] = field(default=(), repr=False)
    """The norm's S, shape (6, 6): approximate eigenvectors of the Jacobian."""
    weights: Sequence[float] = field(default=(), repr=False)
    """The norm's w, shape (6,)."""
    undecided: str = ""
    """Statement that could not be decided."""
    version: str = field(default=__version__, repr=False, compare=False)
    """The version that proved it."""

    def as_json(self) -> dict[str, object]:
        """The proof as a plain object."""
        return {
            **self.statement(),
            "radius": self.radius,
            "rate": self.rate,
            "box": short(self.box) if self.proved else None,
            "norm_radius": self.norm_radius,
            "basis": [[[entry.real, entry.imag] for entry in row] for row in self.basis],
            "weights": list(self.weights),
            "undecided": self.undecided or None,
        }

    @property
    def sentence(self) -> str:
        """Statement that is proved, or left open."""
        if not self.proved:
            return f"Undecided: {self.undecided}."
        return (
            f"Every start whose apex is within {self.radius:.3g} of the gait's in each coordinate settles on "
            "the gait. In a norm that belongs to the gait's Jacobian, each stride multiplies the distance "
            f"from the gait by {self.rate:.4g} or less."
        )


@shares_steps
def prove_attraction(gait: RunnerLike = None) -> Attraction:
    """A ball around a stable gait in which every start settles on it, proved.

    Parameters
    ----------
    gait : Gait, Runner or mapping of str to value, optional
        As in `prove`.

    Returns
    -------
    Attraction
        The largest of some that are tried.

    Raises
    ------
    InputError
        A value or a name is refused.
    RunError
        No gait was found.

    Examples
    --------
    >>> import tdmf_slip
    >>> ball = tdmf_slip.prove_attraction({"ground.friction": 0.6})
    >>> print(ball.proved, f"{ball.radius:.1e}")
    True 2.8e-06
    """
    found, values = gait_of(gait)
    if not found.stable:
        return Attraction(
            False, values, undecided="whether the stride contracts: the gait is found to be unstable"
        )
    parameters, fine = Parameters(values), Fineness(BITS)
    scales = [float(scale) for scale in found.runner.scales]
    centre = [arb(float(x)) for x in found.apex]
    problem = "whether the stride contracts"
    for radius in BOXES:
        with ctx.workprec(BITS):
            size = ball_of(radius)
            starts = Starts(centre, [(size * scale).lower().mid() for scale in scales])
        try:
            inside = Inclusion(parameters, starts, fine)
        except UndecidedError as undecided:
            problem = str(undecided)
            continue
        with ctx.workprec(BITS):
            rate, basis, weights = contraction(inside.stride.derivative)
            if not rate < 1:
                problem = "whether the stride contracts"
                continue
            largest, cube = _balls(starts, inside.image, basis, weights, scales)
        if largest > 0.0:
            rows = [[complex(x) for x in row] for row in basis.tolist()]
            return Attraction(True, values, cube, _above(rate), radius, largest, rows, weights)
    return Attraction(False, values, undecided=problem)


def _balls(
    starts: Starts, away: Sequence[float], basis: acb_mat, weights: Sequence[float], scales: Sequence[float]
) -> tuple[float, float]:
    """The largest ball of the norm around the gait in the box, and the largest box of one shape in that."""
    size = len(weights)
    exact = [arb(w) for w in weights]
    rooms = []
    for i in range(size):
        reach = sum((abs(basis[i, j]) * exact[j] for j in range(size)), arb(0))
        rooms.append(((starts.radii[i] - arb(away[i]) * arb("1.0001")) / reach).lower())
    largest = rooms[0]
    for room in rooms:
        largest = largest.min(room)
    inverse = basis.inv()
    worst = arb(0)
    for i in range(size):
        total = sum((abs(inverse[i, j]) * arb(scales[j]) for j in range(size)), arb(0)) / exact[i]
        worst = worst.max(total)
    return _below(largest), _below(largest / worst)


def _below(value: arb) -> float:
    """A double that is not above."""
    found = float(value.lower())
    return found * (1.0 - 1e-15)


def _above(value: arb) -> float:
    """A double that is not below."""
    return float(value.upper()) * (1.0 + 1e-15)


ENGINE_ERROR = 50.0
"""A stride errs by so many tolerances at the most, over the scales; see `library.batch.ACCURACY`."""


def proved_ball(gait: Gait) -> Ball:
    """A ball in which every start is proved to settle, inside that of `prove_attraction`.

    It is small, and runs have to be followed into it at a finer tolerance.
    """
    if gait.runner.reduced:
        raise InputError("ball proved: of the reduced map; allowed: of the full model")
    found = prove_attraction(gait)
    if not found.proved:
        raise RunError(f"ball proved: undecided: {found.undecided}")
    scales = np.asarray(gait.runner.scales)
    rows = np.linalg.inv(np.array(found.basis)) / (np.array(found.weights) * found.norm_radius)[:, None]
    both = np.concatenate([rows.real, rows.imag])
    matrix = np.linalg.cholesky(both.T @ both).T * (1.0 + 1e-9)  # rounding is far below
    radius = cube_in(matrix * scales)
    tolerance = 0.1 * radius * (1.0 - gait.lambda_max) / ENGINE_ERROR
    return Ball("proved", radius, found.rate, 0, matrix, max(tolerance, MIN_TOLERANCE), 1e-300)
