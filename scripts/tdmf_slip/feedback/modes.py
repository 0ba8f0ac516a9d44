"""Modes of a return map that last: its strides do not forget them by themselves.

A touchdown and a sticking foot lose coordinates for ever: of the six eigenvalues of a return map some are 0
but for rounding, three where the stance sticks at some time, two where it does not. These modes need no
feedback, and what a setting makes of them is forgotten, too. With the left invariant subspace W of the other
eigenvalues, z = W' x obeys a map of its own, z' = F z + G u.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..checks import number_of, refusal
from ..errors import InputError
from .linearization import Linearization

NEGLIGIBLE = 1e-5
"""A mode that a stride leaves less of is left alone."""


@dataclass(frozen=True, eq=False)
class Modes:
    """The modes that last, as a map of their own; everything over the scales."""

    directions: NDArray[np.float64]
    """W, shape (n, modes), with orthonormal columns."""
    state_matrix: NDArray[np.float64]
    """F, shape (modes, modes)."""
    input_matrix: NDArray[np.float64]
    """G, shape (modes, k)."""

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self.state_matrix)

    def gain_of(self, model: Linearization, gain: NDArray[np.float64]) -> NDArray[np.float64]:
        """A gain on the modes as one on the apex."""
        on_apex: NDArray[np.float64] = gain @ self.directions.T
        return on_apex * model.setting_scales[:, None] / model.scales


def lasting_modes(model: Linearization, negligible: float = NEGLIGIBLE) -> Modes:
    """The modes that are to be moved."""
    from scipy.linalg import schur  # slow to load

    threshold = number_of(negligible)
    if threshold is None or not 1e-9 <= threshold < 1.0:
        raise refusal("negligible", negligible, "1e-9 to below 1")

    def lasts(real: float, imaginary: float = 0.0) -> bool:
        return abs(complex(real, imaginary)) > threshold

    transposed, vectors, count = schur(model.scaled_state_matrix.T, output="real", sort=lasts)
    if not count:
        raise InputError(f"negligible = {threshold:g}: no mode of this gait lasts longer; allowed: less")
    directions = vectors[:, :count]
    return Modes(directions, transposed[:count, :count].T, directions.T @ model.scaled_input_matrix)
