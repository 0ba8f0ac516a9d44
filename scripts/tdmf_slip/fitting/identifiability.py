"""Combinations of parameters that data do not identify, by the singular values of the weighted Jacobian.

Its rows are changes of the measured quantities over their errors, its columns are by the parameters over
their scales. A direction of the parameters is not told at all where its singular value is zero up to
rounding, and is told badly where a change as large as the parameters themselves stays within the errors of
the data.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

ROUNDING = 1e-9
"""Share of the largest singular value below which a singular value counts as zero."""
SMALL = 1e-5
"""Share of a combination's largest member below which a parameter has no part in it."""
MINOR = 0.1
"""The same in a combination that is told badly, of which every parameter has a little."""


@dataclass(frozen=True, eq=False)
class Combination:
    """Combined change of parameters that the data do not determine."""

    members: Mapping[str, float]
    """Change of each over its scale, which is its value, or 1 in its unit where it is 0; the largest is 1."""
    changes: Mapping[str, float]
    """The same in the parameters' units."""
    standard_error: float
    """By how many times such a change the data may be wrong; infinite where it changes nothing at all."""

    @property
    def name(self) -> str:
        """The changes in words, as in `hip.stance_torque +0.2, control.stance_torque -0.2`."""
        return ", ".join(f"{label} {change:+.4g}" for label, change in self.changes.items())

    def as_json(self) -> dict[str, object]:
        """As a plain object."""
        return {
            "combination": self.name,
            "changes": dict(self.changes),
            "relative": dict(self.members),
            "standard_error": self.standard_error,
        }


@dataclass(frozen=True, eq=False)
class Identified:
    """Identifiability of the parameters by a weighted Jacobian."""

    covariance: NDArray[np.float64]
    """Covariance of the identified parts of the parameters over their scales, shape (p, p)."""
    reported: NDArray[np.bool_]
    """Which parameters have no part in what is not told at all, shape (p,)."""
    unidentified: tuple[Combination, ...]
    """Combinations that are poorly identified; those that are not identified at all come first."""


def identified(
    jacobian: NDArray[np.float64], labels: Sequence[str], scales: NDArray[np.float64], quantile: float
) -> Identified:
    """Identifiability of the parameters by a weighted Jacobian."""
    _, sizes, directions = np.linalg.svd(jacobian, full_matrices=False)
    none = sizes <= ROUNDING * max(sizes[0], np.finfo(float).tiny)
    unseen = _simplest(directions[none])
    inverse = directions[~none] / sizes[~none, None]
    spreads = np.max(np.abs(directions), axis=1) / np.where(none, 1.0, sizes)
    badly = ~none & (quantile * spreads > 1.0)
    return Identified(
        covariance=inverse.T @ inverse,
        reported=np.all(np.abs(directions[none]) < SMALL, axis=0),
        unidentified=(
            *(_combination(direction, labels, scales, np.inf, SMALL) for direction in unseen),
            *(
                _combination(direction, labels, scales, float(spread), MINOR)
                for direction, spread in zip(directions[badly][::-1], spreads[badly][::-1], strict=True)
            ),
        ),
    )


def _simplest(directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Directions that span the same, each with a parameter of its own: the rows in reduced echelon form."""
    rows, taken = directions.copy(), 0
    while taken < len(rows):
        pivot = np.unravel_index(int(np.argmax(np.abs(rows[taken:]))), rows[taken:].shape)
        row, column = taken + int(pivot[0]), int(pivot[1])
        rows[[taken, row]] = rows[[row, taken]]
        rows[taken] /= rows[taken, column]
        for other in range(len(rows)):
            if other != taken:
                rows[other] -= rows[other, column] * rows[taken]
        taken += 1
    return rows


def _combination(
    direction: NDArray[np.float64],
    labels: Sequence[str],
    scales: NDArray[np.float64],
    standard_error: float,
    minimum: float,
) -> Combination:
    """With the largest member first, whose change is 1."""
    shares = np.round(direction / direction[np.argmax(np.abs(direction))], 9)
    order = [int(k) for k in np.argsort(-np.abs(shares), kind="stable") if abs(shares[k]) >= minimum]
    return Combination(
        members={labels[k]: float(shares[k]) for k in order},
        changes={labels[k]: float(shares[k] * scales[k]) for k in order},
        standard_error=standard_error,
    )
