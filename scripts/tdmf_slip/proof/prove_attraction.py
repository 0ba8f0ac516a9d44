"""A ball around a stable gait from which every runner is proved to settle on it.

If the stride maps a box with a derivative that is below kappa < 1 in some norm, then every ball of that
norm around the gait in the box goes into itself, and strides bring its points nearer by kappa each (mean
value theorem).
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np
from flint import arb, ctx

from ..analysis.ball import Ball, cube_in
from ..errors import InputError, RunError
from ..library.batch_given import MIN_TOLERANCE
from ..library.gait import Gait
from ..library.shared_steps import shares_steps
from .dual import UndecidedError, absolute, greatest, row_sums
from .given import Exact, RunnerLike, ball_of, gait_of
from .krawczyk import Inclusion, contraction
from .parameters import Parameters
from .proof import Proved, short
from .starts import Starts

BOXES = tuple(Fraction(digit, 10**decimals) for decimals in range(3, 13) for digit in (5, 2, 1))
"""Radii that are tried, in units of the coordinates' scales."""
BITS = 64


@dataclass(frozen=True, repr=False)
class Attraction(Proved):
    """Starts that are proved to settle on a gait."""

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
    problem = ""
    for radius in BOXES:
        try:
            with ctx.workprec(BITS):
                return _within(radius, found, values)
        except UndecidedError as undecided:
            problem = str(undecided)
    return Attraction(False, values, undecided=problem)


def _within(radius: Fraction, gait: Gait, values: Mapping[str, Exact]) -> Attraction:
    """The ball of a norm around the gait in a box, and the largest box of one shape in that."""
    scales = [arb(float(scale)) for scale in gait.runner.scales]
    centre = [arb(float(x)) for x in gait.apex]
    starts = Starts(centre, [(ball_of(radius) * scale).lower().mid() for scale in scales])
    inside = Inclusion(Parameters(values), starts, BITS)
    rate, basis, weights = contraction(inside.stride.derivative)
    exact = [arb(w) for w in weights]
    reaches = [row * w for row, w in zip(row_sums(absolute(basis), exact), exact, strict=True)]
    rows = zip(starts.radii, inside.image, reaches, strict=True)
    rooms = [(room - arb(away) * arb("1.0001")) / reach for room, away, reach in rows]
    largest = functools.reduce(arb.min, rooms).lower()
    if not (rate < 1 and largest > 0):
        raise UndecidedError("whether the stride contracts")
    spans = [[x * scale for x, scale in zip(row, scales, strict=True)] for row in absolute(basis.inv())]
    worst = greatest([sum(row, arb(0)) / w for row, w in zip(spans, exact, strict=True)])
    found = [[complex(x) for x in row] for row in basis.tolist()]
    return Attraction(
        True, values, _below(largest / worst), _above(rate), radius, _below(largest), found, weights
    )


def _below(value: arb) -> float:
    """A double that is not above."""
    found = float(value.lower())
    return found * (1.0 - 1e-15)


def _above(value: arb) -> float:
    """A double that is not below."""
    return float(value.upper()) * (1.0 + 1e-15)


ENGINE_ERROR = 50.0
"""Largest error of a stride over the scales, in tolerances; see `library.batch.ACCURACY`."""


def proved_ball(gait: Gait) -> Ball:
    """A ball in which every start is proved to settle, inside that of `prove_attraction`.

    It is small, and runs have to be followed into it at a finer tolerance.
    """
    if gait.runner.reduced:
        raise InputError("ball = proved: is not for the reduced map; allowed: for the full model")
    found = prove_attraction(gait)
    if not found.proved:
        raise RunError(f"ball = proved: no ball was proved, because this is undecided: {found.undecided}")
    scales = np.asarray(gait.runner.scales)
    rows = np.linalg.inv(np.array(found.basis)) / (np.array(found.weights) * found.norm_radius)[:, None]
    both = np.concatenate([rows.real, rows.imag])
    matrix = np.linalg.cholesky(both.T @ both).T * (1.0 + 1e-9)  # rounding is far below
    radius = cube_in(matrix * scales)
    tolerance = 0.1 * radius * (1.0 - gait.lambda_max) / ENGINE_ERROR
    return Ball("proved", radius, found.rate, 0, matrix, max(tolerance, MIN_TOLERANCE), 1e-300)
