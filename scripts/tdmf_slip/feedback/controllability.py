"""Effect of settings on a gait's modes, in numbers.

R. E. Kalman's test: the modes are controllable where [G, F G, F^2 G, ...] has their rank. How near they are
to losing it, its singular values tell.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..library.gait import Gait
from ..library.runner import Runner
from .linearization import linearize
from .modes import NEGLIGIBLE, Modes, lasting_modes

RANK_TOLERANCE = 1e-9
"""Singular values below this share of the largest count as 0."""


@dataclass(frozen=True, eq=False, repr=False)
class Controllability:
    """Which modes of a gait its settings can move, and how far; everything over the scales."""

    runner: Runner
    """The gait's runner."""
    inputs: tuple[str, ...]
    """Those that are chosen at each apex."""
    eigenvalues: NDArray[Any]
    """Eigenvalues of the modes that last, shape (modes,), the largest first; complex where any is."""
    negligible: int
    """Modes that a stride forgets by itself: of a foot that lands and sticks."""
    rank: int
    """Rank of the controllability matrix."""
    singular_values: NDArray[np.float64]
    """Singular values of the controllability matrix, shape (modes,), the largest first."""
    modal_controllability: NDArray[np.float64]
    """How far each setting moves each mode in a stride, shape (modes, k): by the mode's left eigenvector of
    length 1."""
    uncontrollable: NDArray[Any]
    """Eigenvalues of the modes that no setting moves, shape (modes - rank,)."""
    strides: int | None
    """In so few a dead-beat law moves all modes to the gait; None where some cannot be moved."""

    def __repr__(self) -> str:
        """In a line: how many of the modes can be moved, by what, and how well."""
        return (
            f"<Controllability by {', '.join(self.inputs)}: {self.rank} of {len(self.eigenvalues)} modes, "
            f"least over largest singular value {self.conditioning:.3g}>"
        )

    @property
    def controllable(self) -> bool:
        """Whether every mode that lasts can be moved."""
        return not len(self.uncontrollable)

    @property
    def stabilizable(self) -> bool:
        """Whether every mode that grows can be moved."""
        return bool(np.all(np.abs(self.uncontrollable) < 1.0))

    @property
    def conditioning(self) -> float:
        """The smallest singular value over the largest: 0 where a mode cannot be moved."""
        return float(self.singular_values[-1] / self.singular_values[0])

    def as_json(self) -> dict[str, object]:
        """The numbers as a plain object, eigenvalues as [re, im]."""
        return {
            **self.runner.record(),
            "inputs": list(self.inputs),
            "eigenvalues": _pairs(self.eigenvalues),
            "negligible": self.negligible,
            "rank": self.rank,
            "singular_values": self.singular_values.tolist(),
            "modal_controllability": self.modal_controllability.tolist(),
            "uncontrollable": _pairs(self.uncontrollable),
            "strides": self.strides,
        }


def controllability(gait: Gait, inputs: Sequence[str], *, negligible: float = NEGLIGIBLE) -> Controllability:
    """Effect on a gait's modes of settings that are chosen at each apex.

    Parameters
    ----------
    gait : Gait
        The gait.
    inputs : sequence of str
        Which settings, of `linearization.CHOSEN`.
    negligible : float, default 1e-5
        Modes whose eigenvalue is smaller are left alone.

    Returns
    -------
    Controllability
        Rank, singular values, and what each setting does to each mode.

    Raises
    ------
    InputError
        As `linearize` and `lasting_modes`.
    RunError
        The stride has no derivatives.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> found = tdmf_slip.controllability(gait, ["hip.touchdown_angle", "hip.stance_torque"])
    >>> found.rank, found.negligible, found.strides
    (3, 3, 2)
    """
    model = linearize(gait, inputs)
    return controllability_of(model.gait.runner, lasting_modes(model, negligible), model.inputs)


def controllability_of(runner: Runner, modes: Modes, inputs: tuple[str, ...]) -> Controllability:
    """Controllability of modes that are known."""
    eigenvalues, left = _left_eigenvectors(modes.state_matrix)
    vectors, values, _ = np.linalg.svd(controllability_matrix(modes))
    rank = int(np.count_nonzero(values > RANK_TOLERANCE * values[0]))
    beyond = vectors[:, rank:]
    uncontrollable: NDArray[Any] = np.linalg.eigvals(beyond.T @ modes.state_matrix @ beyond)
    return Controllability(
        runner=runner,
        inputs=inputs,
        eigenvalues=eigenvalues,
        negligible=len(modes.directions) - modes.count,
        rank=rank,
        singular_values=values,
        modal_controllability=np.abs(left.conj().T @ modes.input_matrix),
        uncontrollable=uncontrollable,
        strides=_strides(modes) if rank == modes.count else None,
    )


def controllability_matrix(modes: Modes, strides: int | None = None) -> NDArray[np.float64]:
    """Effect of the settings on the modes in several strides: [G, F G, F^2 G, ...]."""
    parts = [modes.input_matrix]
    while len(parts) < (modes.count if strides is None else strides):
        parts.append(modes.state_matrix @ parts[-1])
    return np.hstack(parts)


def _strides(modes: Modes) -> int:
    """The first in which the matrix has full rank."""
    for strides in range(1, modes.count):
        values = np.linalg.svd(controllability_matrix(modes, strides))[1]
        if np.count_nonzero(values > RANK_TOLERANCE * values[0]) == modes.count:
            return strides
    return modes.count


def _left_eigenvectors(matrix: NDArray[np.float64]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Eigenvalues, the largest first, and left eigenvectors of length 1 in columns."""
    from scipy.linalg import eig  # slow to load

    values, left = eig(matrix, left=True, right=False)
    order = np.argsort(-np.abs(values), kind="stable")
    values, left = values[order], left[:, order]
    return (values if np.any(values.imag) else values.real), left


def _pairs(values: NDArray[Any]) -> list[list[float]]:
    return [[float(value.real), float(value.imag)] for value in values.astype(complex)]
