"""Effect of settings on a gait's modes, in numbers.

The return map is linearized about a gait, by the apex and by the settings that are chosen at each apex. With
the deviations x of an apex and u of the settings from those of the gait, the next apex deviates by

    x' = A x + B u,

both matrices exact, by the variational equations of the C library. The horizontal position and the time are
no coordinates of the section: the map does not depend on them.

Only modes that last need a feedback. A touchdown and a sticking foot remove coordinates: some of the six
eigenvalues of a return map are 0 up to rounding, three if the foot sticks at some time, two if it does not.
The next stride forgets these modes and the effect of a setting on them. With the left invariant subspace W of
the other eigenvalues, z = W' x obeys a map of its own, z' = F z + G u.

Kalman's test: these modes are controllable if the rank of [G, F G, F^2 G, ...] is their number. The singular
values of this matrix show how near the modes are to being uncontrollable.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_names, check_once, choice_of, number_of, refusal
from ..errors import InputError
from ..library.gait import Gait, check_is_gait
from ..library.runner import Runner
from ..library.settings import SETTINGS
from ..library.strides import varied_stride
from ..record import entries
from ..variables.table import Model, full_names

CHOSEN = tuple(name for name in SETTINGS if not name.startswith("ground."))
"""Settings that a controller may choose anew at each apex: all but the ground's."""
THRUSTS = ("leg.thrust", "control.thrust")
"""Settings whose sum is clamped at 0."""
CLOSED = 1e-9
"""Largest difference of an apex and the next one, over the scales, at a gait."""
IDLE = 1e-12
"""Largest change of the next apex, over the scales, by a setting without effect."""


@dataclass(frozen=True, eq=False)
class Linearization:
    """Linearized return map by the apex and by settings; both matrices are over the scales."""

    gait: Gait
    """Gait about which the map is linearized."""
    inputs: tuple[str, ...]
    """Names of the settings that are chosen at each apex, of `CHOSEN`."""
    nominal: NDArray[np.float64]
    """Values of the settings at the gait, shape (k,), in their units."""
    state_matrix: NDArray[np.float64]
    """A, shape (n, n): derivative of the next apex by this one."""
    input_matrix: NDArray[np.float64]
    """B, shape (n, k): derivative of the next apex by the settings."""
    setting_scales: NDArray[np.float64]
    """Scales of the settings, shape (k,): 1 rad, sqrt(k/m), l0, k l0, k l0^2, and for gains of the hip k l0^2
    and l0^2 sqrt(k m), each per rad."""

    @property
    def scales(self) -> NDArray[np.float64]:
        """Scales of the section's coordinates, shape (n,)."""
        return self.gait.runner.scales

    def over_scales(self, gain: ArrayLike) -> NDArray[np.float64]:
        """Gain over the scales of settings and section, from a gain in their units."""
        scaled: NDArray[np.float64] = np.asarray(gain) * self.scales / self.setting_scales[:, None]
        return scaled


def linearize(gait: Gait, inputs: Sequence[str]) -> Linearization:
    """Linearize the return map about a gait, by the apex and by settings."""
    check_is_gait(gait, "gait")
    if gait.following:
        raise InputError(f"gait of {gait.strides} strides is not allowed; allowed: a gait of one stride")
    if not gait.error <= CLOSED:
        raise InputError(
            f"gait whose next apex is {gait.error:.2g} of the scales away is not allowed; allowed: "
            f"at most {CLOSED:g}, as in the gaits of find_gait"
        )
    runner = gait.runner
    names = _checked_names(inputs, runner.model)
    for name in names:
        _check_inside(runner, name)
    setting_scales = np.array([runner.scale_of(runner.model.variables[name].unit) for name in names])
    by_settings = varied_stride(runner, gait.apex, (), names).by_all[:, len(gait.apex) :]
    by_settings = by_settings * setting_scales / runner.scales[:, None]
    for name, moved in zip(names, np.max(np.abs(by_settings), axis=0), strict=True):
        if moved <= IDLE:
            raise InputError(
                f"inputs: {name} has no effect on the next apex of this gait; choose inputs that do"
            )
    return Linearization(
        gait=gait,
        inputs=names,
        nominal=np.array([runner[name] for name in names]),
        state_matrix=gait.jacobian * runner.scales / runner.scales[:, None],
        input_matrix=by_settings,
        setting_scales=setting_scales,
    )


def _checked_names(given: object, model: Model) -> tuple[str, ...]:
    chosen = tuple(name for name in model.settings if not name.startswith("ground."))
    allowed = f"one or more in a list: {choice_of(chosen, 'tdmf-slip variables')}"
    names = full_names(given, "inputs", allowed, model.aliases)
    if not names:
        raise refusal("inputs", given, allowed)
    check_names(names, chosen, "inputs", model.aliases, listed_by="tdmf-slip variables")
    check_once(names, "inputs")
    return names


def _check_inside(runner: Runner, name: str) -> None:
    """Refuse a setting with a one-sided derivative."""
    value, variable = runner[name], runner.model.variables[name]
    if name in THRUSTS:
        total = sum(runner.get(thrust, 0.0) for thrust in THRUSTS)
        if total <= 0.0:
            raise InputError(
                f"inputs: {name} cannot be lowered at this gait, whose thrust is {total:g} m, so its "
                "derivative is one-sided; allowed: a gait with a thrust above 0"
            )
    elif not variable.minimum < value < variable.maximum:
        raise InputError(
            f"inputs: {name} = {value:g} at this gait is at the end of its range, so its "
            f"derivative is one-sided; allowed: inside {variable.allowed}"
        )


NEGLIGIBLE = 1e-5
"""Eigenvalue below which a mode is left alone."""


@dataclass(frozen=True, eq=False)
class Modes:
    """Map of the modes that last, over the scales."""

    directions: NDArray[np.float64]
    """W, shape (n, modes), with orthonormal columns."""
    state_matrix: NDArray[np.float64]
    """F, shape (modes, modes)."""
    input_matrix: NDArray[np.float64]
    """G, shape (modes, k)."""

    @property
    def count(self) -> int:
        """Number of the modes."""
        return len(self.state_matrix)


def lasting_modes(model: Linearization, negligible: float = NEGLIGIBLE) -> Modes:
    """Modes that a feedback has to move, over a basis that does not depend on rounding.

    Schur vectors are unique up to signs or rotations, which rounding may change. A QR decomposition with
    pivots of their transpose takes these away: its triangular factor is unique up to signs.
    """
    from scipy.linalg import qr, schur  # slow to load

    threshold = number_of(negligible)
    if threshold is None or not 1e-9 <= threshold < 1.0:
        raise refusal("negligible", negligible, "1e-9 to below 1")

    def lasts(real: float, imaginary: float = 0.0) -> bool:
        return abs(complex(real, imaginary)) > threshold

    _, vectors, count = schur(model.state_matrix.T, output="real", sort=lasts)
    if not count:
        raise InputError(f"negligible = {threshold:g}: no mode of this gait lasts longer; allowed: less")
    rotation, triangular, _ = qr(vectors[:, :count].T, mode="economic", pivoting=True)
    basis = vectors[:, :count] @ (rotation * np.sign(np.diag(triangular)))
    return Modes(basis, basis.T @ model.state_matrix @ basis, basis.T @ model.input_matrix)


RANK_TOLERANCE = 1e-9
"""Singular values below this share of the largest count as 0."""


@dataclass(frozen=True, eq=False, repr=False)
class Controllability:
    """Effect of settings on the modes of a gait; all numbers are over the scales."""

    runner: Runner
    """Runner of the gait."""
    inputs: tuple[str, ...]
    """Settings that are chosen at each apex."""
    eigenvalues: NDArray[Any]
    """Eigenvalues of the modes that last, shape (modes,), the largest first; complex if any of them is."""
    negligible: int
    """Number of modes that a stride removes by itself, because a foot lands and sticks."""
    rank: int
    """Rank of the controllability matrix."""
    singular_values: NDArray[np.float64]
    """Singular values of the controllability matrix, shape (modes,), the largest first."""
    modal_controllability: NDArray[np.float64]
    """Effect of each setting on each mode in a stride, shape (modes, k), by left eigenvectors of length 1."""
    uncontrollable: NDArray[Any]
    """Eigenvalues of the modes that no setting moves, shape (modes - rank,)."""
    strides: int | None
    """Fewest strides in which a dead-beat law brings all modes to 0; None if some cannot be moved."""

    def __repr__(self) -> str:
        """One line: how many of the modes can be moved, by what, and how well."""
        return (
            f"<Controllability by {', '.join(self.inputs)}: {self.rank} of {len(self.eigenvalues)} modes, "
            f"smallest over largest singular value {self.conditioning:.3g}>"
        )

    @property
    def controllable(self) -> bool:
        """True if every mode that lasts can be moved."""
        return not len(self.uncontrollable)

    @property
    def stabilizable(self) -> bool:
        """True if every mode that does not decay can be moved."""
        return bool(np.all(np.abs(self.uncontrollable) < 1.0))

    @property
    def conditioning(self) -> float:
        """Smallest singular value over the largest: 0 if a mode cannot be moved."""
        return float(self.singular_values[-1] / self.singular_values[0])

    def as_json(self) -> dict[str, object]:
        """Numbers as a plain object, eigenvalues as [re, im]."""
        spectrum = ("inputs", "eigenvalues", "negligible", "rank", "singular_values")
        return self.runner.record() | entries(
            self, *spectrum, "modal_controllability", "uncontrollable", "strides"
        )


def controllability(gait: Gait, inputs: Sequence[str], *, negligible: float = NEGLIGIBLE) -> Controllability:
    """Compute the effect on a gait's modes of settings that are chosen at each apex.

    Parameters
    ----------
    gait : Gait
        The gait.
    inputs : sequence of str
        Which settings, of `controllability.CHOSEN`.
    negligible : float, default 1e-5
        Modes whose eigenvalue is smaller are left alone.

    Returns
    -------
    Controllability
        Rank, singular values, and the effect of each setting on each mode.

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
    """Controllability of modes."""
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
    """Least number of strides for which the controllability matrix has full rank."""
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
