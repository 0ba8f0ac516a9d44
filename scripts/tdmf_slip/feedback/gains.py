"""Gains from a gait's exact return map: dead-beat, linear quadratic, and by pole placement.

Each feedback is an affine law from the apex to the settings of the next stride, with limits on each setting.

The dead-beat gain takes modes to 0 in the fewest steps. Modes from which 0 is reached in j steps form a
subspace S_j: S_0 = {0}, and z is in S_j if F z + G u is in S_(j-1) for some u. The gain maps each S_j into
S_(j-1), with the least settings that do.

Noisy sensors and rough ground lead a runner away from its gait, here to first order. At each apex the law
measures x + v, with noise v of covariance N. The ground then steps by s, of standard deviation r. The
deviation of the next apex is x' = A (x - e s) + B G (x + v), with the unit vector e of the height. In the
long run its covariance P solves the discrete Lyapunov equation

    P = (A + B G) P (A + B G)' + B G N G' B' + r^2 A e e' A'.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_kind, check_names, checked, number_of, refusal
from ..errors import InputError, counted
from ..given import ends_given, numbers_of, row_of
from ..library.gait import Gait
from ..library.ground import LARGEST
from ..library.laws import AffineLaw
from ..record import entries
from ..variables.table import FRICTION, MODELS, by_full_name
from .controllability import (
    NEGLIGIBLE,
    Controllability,
    Linearization,
    Modes,
    controllability_of,
    lasting_modes,
    linearize,
)

TOLERANCE = 1e-9
"""Singular values below this share of the largest of F, or of G, count as 0."""


def dead_beat_gain(
    state_matrix: NDArray[np.float64], input_matrix: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Gain K for which F + G K is nilpotent, of the lowest index."""
    count = len(state_matrix)
    min_moved, min_kept = (TOLERANCE * np.linalg.norm(of, 2) for of in (input_matrix, state_matrix))
    reached, gain = np.zeros((count, 0)), np.zeros((input_matrix.shape[1], count))
    while reached.shape[1] < count:
        outside = np.eye(count) - reached @ reached.T
        moved = outside @ input_matrix
        largest = float(np.linalg.norm(moved, 2))
        settings = -np.linalg.pinv(moved, min_moved / largest if largest else 0.0) @ outside @ state_matrix
        _, values, directions = np.linalg.svd(outside @ (state_matrix + input_matrix @ settings))
        reaching = directions[values <= min_kept].T
        beside = reaching - reached @ (reached.T @ reaching)
        added = np.linalg.svd(beside, full_matrices=False)[0][:, : reaching.shape[1] - reached.shape[1]]
        if not added.shape[1]:
            raise ArithmeticError("the modes are not controllable")
        gain += settings @ added @ added.T
        reached = np.hstack([reached, added])
    return gain


Limits: TypeAlias = Mapping[str, tuple[float, float]]
"""Least and largest value of settings, by name, in their units."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Feedback(AffineLaw):
    """Affine law that holds a gait, for `law=`; `dataclasses.replace` adds noise or limits."""

    linearization: Linearization
    """Linearized return map of the gait."""
    eigenvalues: NDArray[Any]
    """Eigenvalues of the closed loop within its limits, shape (n,), largest first; complex if any is."""
    S: NDArray[np.float64] | None = None
    """Solution of the Riccati equation over the scales, shape (n, n); None for other laws than `lqr`."""
    strides: int | None = None
    """Number of strides in which a dead-beat law brings its modes to 0; None for other laws."""

    def __repr__(self) -> str:
        """Settings, gait, and largest eigenvalue of the closed loop, in one line."""
        gait = self.linearization.gait
        where = f", {FRICTION} = {gait.friction:.6g}" if FRICTION in gait.runner else ""
        at = f"the gait {gait.word}{where}"
        return (
            f"<Feedback by {', '.join(self.inputs)} at {at}: largest eigenvalue {self.lambda_max:.4g}, "
            f"{gait.lambda_max:.4g} without feedback>"
        )

    @property
    def lambda_max(self) -> float:
        """Size of the largest eigenvalue."""
        return float(abs(self.eigenvalues[0]))

    def as_json(self) -> dict[str, object]:
        """Law as a plain object, by the names of an `AffineLaw`, with its eigenvalues as [re, im]."""
        names = [item.name for item in fields(AffineLaw) if item.name != "model"]
        return self.linearization.gait.runner.record() | entries(self, *names, "eigenvalues")

    @property
    def K(self) -> NDArray[np.float64]:  # noqa: N802
        """Gain K of control textbooks, shape (inputs, n): settings are nominal - K (apex - gait's apex)."""
        return -np.asarray(self.gain)

    @property
    def E(self) -> NDArray[Any]:  # noqa: N802
        """Eigenvalues of the closed loop, largest first."""
        return self.eigenvalues

    @property
    def closed_loop(self) -> NDArray[np.float64]:
        """A + B G over the scales, shape (n, n): derivative of the next apex by this one."""
        model = self.linearization
        closed: NDArray[np.float64] = model.state_matrix + model.input_matrix @ model.over_scales(self.gain)
        return closed


def _feedback(
    model: Linearization, gain: NDArray[np.float64], limits: Limits | None, **about: Any
) -> Feedback:
    """Feedback with a gain over the scales."""
    low, high = _checked_limits(model, limits)
    eigenvalues = np.linalg.eigvals(model.state_matrix + model.input_matrix @ gain)
    return Feedback(
        inputs=model.inputs,
        apex=model.gait.apex,
        nominal=model.nominal,
        gain=gain * model.setting_scales[:, None] / model.scales,
        low=low,
        high=high,
        linearization=model,
        eigenvalues=eigenvalues[np.argsort(-np.abs(eigenvalues), kind="stable")],
        model=MODELS["full"] if model.gait.runner.reduced else model.gait.runner.model,
        **about,
    )


def _checked_limits(
    model: Linearization, limits: Limits | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    own = model.gait.runner.model
    given = by_full_name(limits, "limits", "pairs of numbers by setting", own.aliases)
    check_names(given, model.inputs, "limits")
    low, high = np.empty((2, len(model.inputs)))
    for k, (name, nominal) in enumerate(zip(model.inputs, model.nominal, strict=True)):
        variable, asked = own.variables[name], given.get(name)
        ends = variable.minimum, variable.maximum
        if asked is not None:
            ends = ends_given(f"limits: {name}", asked, read=variable.without_units)
        low[k], high[k] = ends
        if not variable.minimum <= low[k] <= nominal <= high[k] <= variable.maximum:
            allowed = f"two numbers within {variable.allowed} with {nominal:g}, the gait's own, between them"
            raise refusal(f"limits: {name}", asked, allowed)
    return low, high


MAX_EIGENVALUES = 1000
"""Largest number of eigenvalues that is read; no section has as many modes."""


def dead_beat(
    gait: Gait,
    inputs: Sequence[str],
    *,
    limits: Limits | None = None,
    negligible: float = NEGLIGIBLE,
) -> Feedback:
    """Feedback that brings a runner back to its gait in the fewest strides, to first order.

    One stride suffices with as many settings as lasting modes. With fewer it takes more strides, which
    `controllability` reports. Of several such feedbacks, this is the one with the least settings, over their
    scales. The effect of a setting that acts after the foot last sticks is gone after the next stride.

    Parameters
    ----------
    gait : Gait
        The gait.
    inputs : sequence of str
        Settings that are chosen at each apex, of `controllability.CHOSEN`.
    limits : mapping of str to (float, float), optional
        Least and largest value by setting, in its unit; by default its range.
    negligible : float, default 1e-5
        Modes with a smaller eigenvalue are left alone. For example, 0.05 leaves a mode alone that a stride
        shrinks to a twentieth, and the settings then need not move it.

    Returns
    -------
    Feedback
        An affine law. All eigenvalues of its closed loop are 0, except those of modes left alone.

    Raises
    ------
    InputError
        As `linearize`; the gait's settings are outside of the limits; or a mode that lasts cannot be moved.
    RunError
        The stride has no derivatives.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> held = tdmf_slip.dead_beat(gait, ["hip.touchdown_angle", "hip.stance_torque"])
    >>> held.strides, bool(abs(held.eigenvalues[0]) < 1e-6)
    (2, True)
    """
    model, modes, reported = _movable(gait, inputs, negligible)
    try:
        gain = dead_beat_gain(modes.state_matrix, modes.input_matrix)
    except ArithmeticError:
        raise _not_movable(model, reported.eigenvalues) from None
    return _feedback(model, gain @ modes.directions.T, limits, strides=reported.strides)


def place_poles(
    gait: Gait,
    inputs: Sequence[str],
    eigenvalues: Sequence[complex] | NDArray[Any],
    *,
    limits: Limits | None = None,
    negligible: float = NEGLIGIBLE,
) -> Feedback:
    """Feedback whose closed loop has the chosen eigenvalues, by `scipy.signal.place_poles`.

    Several settings can place the same eigenvalues with many gains. SciPy chooses a gain under which the
    eigenvalues depend little on errors of the matrices.

    Parameters
    ----------
    gait, inputs : as in `dead_beat`
    eigenvalues : sequence of complex
        One for each mode that lasts, complex ones in conjugate pairs. None may be repeated more often than
        there are independent settings.
    limits, negligible : as in `dead_beat`

    Returns
    -------
    Feedback
        An affine law with these eigenvalues, and those of modes left alone.

    Raises
    ------
    InputError
        As `dead_beat`; or other eigenvalues.
    RunError
        The stride has no derivatives.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> law = tdmf_slip.place_poles(gait, ["hip.touchdown_angle", "hip.stance_torque"], [0.5, -0.2, 0.01])
    >>> print(law.eigenvalues[:3].real.round(6))
    [ 0.5  -0.2   0.01]
    """
    from scipy.signal import place_poles as place  # slow to load

    model, modes, reported = _movable(gait, inputs, negligible)
    wanted = _checked_eigenvalues(eigenvalues, reported)
    try:
        placed = place(modes.state_matrix, modes.input_matrix, wanted)
    except ValueError as problem:
        raise InputError(f"eigenvalues = {_listed(wanted)} are not allowed: {problem}") from None
    return _feedback(model, -placed.gain_matrix @ modes.directions.T, limits)


def lqr(
    gait: Gait,
    inputs: Sequence[str],
    state_weight: ArrayLike = 1.0,
    input_weight: ArrayLike = 1.0,
    *,
    limits: Limits | None = None,
) -> Feedback:
    """Linear quadratic regulator: the feedback of least cost, by `scipy.linalg.solve_discrete_are`.

    With the deviations x of the apices and u of the settings, each over its scale, the cost is the sum over
    all strides of x' Q x + u' R u.

    Parameters
    ----------
    gait, inputs : as in `dead_beat`
    state_weight : array_like of float, default 1
        Q: a number for all coordinates of the section, one for each, or a matrix of shape (n, n);
        symmetric, and without negative eigenvalues.
    input_weight : array_like of float, default 1
        R: likewise for the k settings; with positive eigenvalues only.
    limits : as in `dead_beat`

    Returns
    -------
    Feedback
        An affine law, under which the gait is stable, with `S`, the solution of the Riccati equation over the
        scales.

    Raises
    ------
    InputError
        As `linearize`; the gait's settings are outside of the limits; weights that are not allowed; or the
        gait is unstable in a mode that cannot be moved.
    RunError
        The stride has no derivatives.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> law = tdmf_slip.lqr(gait, ["hip.touchdown_angle", "hip.stance_torque"])
    >>> print(abs(gait.eigenvalues[:2]).round(3), abs(law.eigenvalues[:2]).round(3))
    [0.856 0.519] [0.541 0.022]
    """
    model = linearize(gait, inputs)
    state = _weight("state_weight", state_weight, len(model.scales), 0.0)
    setting = _weight("input_weight", input_weight, len(model.inputs), np.finfo(float).tiny)
    gain, cost = riccati_gain(model.state_matrix, model.input_matrix, state, setting)
    return _feedback(model, gain, limits, S=cost)


def riccati_gain(
    state_matrix: NDArray[np.float64],
    input_matrix: NDArray[np.float64],
    state_weight: NDArray[np.float64],
    input_weight: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Gain G of the linear quadratic regulator of x' = A x + B u, in u = G x, and S: x' S x is the cost."""
    from scipy.linalg import solve_discrete_are  # slow to load

    try:
        cost = solve_discrete_are(state_matrix, input_matrix, state_weight, input_weight)
        weighted = input_matrix.T @ cost
        gain: NDArray[np.float64] = -np.linalg.solve(
            input_weight + weighted @ input_matrix, weighted @ state_matrix
        )
    except np.linalg.LinAlgError as problem:
        raise InputError(
            f"inputs: no feedback by them makes the cost finite ({problem}); allowed: inputs that move "
            "every mode that does not decay, and weights that see it"
        ) from None
    return gain, cost


def _movable(
    gait: Gait, inputs: Sequence[str], negligible: float
) -> tuple[Linearization, Modes, Controllability]:
    """Linearized gait, its modes that last, and their controllability; refuses modes that cannot be moved."""
    model = linearize(gait, inputs)
    modes = lasting_modes(model, negligible)
    reported = controllability_of(gait.runner, modes, model.inputs)
    if not reported.controllable:
        raise _not_movable(model, reported.uncontrollable)
    return model, modes, reported


def _not_movable(model: Linearization, eigenvalues: NDArray[Any]) -> InputError:
    return InputError(
        f"inputs {', '.join(model.inputs)} do not move the mode of eigenvalue {_listed(eigenvalues)} at "
        "this gait; allowed: inputs that move every mode that lasts"
    )


def _checked_eigenvalues(given: object, reported: Controllability) -> NDArray[Any]:
    count = len(reported.eigenvalues)
    allowed = (
        f"{counted(count, 'number')}, one for each mode that lasts, which are "
        f"{_listed(reported.eigenvalues)} without feedback"
    )
    row = row_of(given, "eigenvalues", allowed, MAX_EIGENVALUES)
    numbers = [number_of(one) if not isinstance(one, complex) else one for one in row]
    wanted = np.array([np.nan if one is None else one for one in numbers], complex)
    if wanted.shape != (count,) or not np.isfinite(wanted).all():
        raise refusal("eigenvalues", given, allowed)
    pairs = np.sort_complex(wanted)
    if not np.allclose(pairs, np.sort_complex(pairs.conj()), rtol=0.0, atol=1e-14):
        raise InputError(
            f"eigenvalues = {_listed(wanted)} are not allowed; allowed: complex ones in conjugate pairs"
        )
    return wanted if np.any(wanted.imag) else wanted.real


def _listed(values: NDArray[Any]) -> str:
    return ", ".join(f"{value:.4g}" for value in values)


def _weight(name: str, given: ArrayLike, count: int, minimum: float) -> NDArray[np.float64]:
    """Weight as a symmetric matrix."""
    allowed = (
        f"a number, {count} of them, or a symmetric matrix of {count} by {count}, "
        f"{'none negative' if minimum == 0.0 else 'positive'}"
    )
    weight = numbers_of(name, given, allowed)
    if weight.shape in ((), (count,)):
        weight = np.diag(np.broadcast_to(weight, count))
    sound = weight.shape == (count, count) and np.isfinite(weight).all() and np.allclose(weight, weight.T)
    rounding = 1e-12 * np.abs(weight).max() if sound else 0.0
    if not sound or np.linalg.eigvalsh(weight)[0] < minimum - (rounding if minimum == 0.0 else 0.0):
        raise refusal(name, given, allowed)
    return weight


HEIGHT = "com_height"
"""Coordinate of the section that a step of the ground changes."""


def apex_covariance(feedback: Feedback, roughness: float = 0.0) -> NDArray[np.float64]:
    """Covariance of a runner's apices about that of its gait, in the long run and to first order.

    Parameters
    ----------
    feedback : Feedback
        Feedback with the noise of its sensors, `noise`. Its limits are ignored.
    roughness : float, default 0
        Standard deviation of the steps of the ground, m.

    Returns
    -------
    ndarray of float, shape (n, n)
        Covariance in the units of the section, of apices above the ground before it steps.

    Raises
    ------
    InputError
        No feedback, a feedback under which the gait is unstable, a roughness out of range, or a roughness
        for a section without `com_height`.

    Examples
    --------
    Sensors have an error of a thousandth of the section's scales. The standard deviation of the height is
    then

    >>> from dataclasses import replace
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> law = tdmf_slip.lqr(gait, ["hip.touchdown_angle", "hip.stance_torque"])
    >>> noisy = replace(law, noise=1e-3 * gait.runner.scales)
    >>> covariance = tdmf_slip.apex_covariance(noisy)
    >>> print(covariance.shape, f"{covariance[0, 0] ** 0.5:.2e} m")
    (6, 6) 1.18e-03 m
    """
    from scipy.linalg import solve_discrete_lyapunov  # slow to load

    check_kind(feedback, Feedback, "feedback", "a Feedback, as dead_beat, lqr and place_poles give")
    roughness = checked("roughness", roughness, 0.0, LARGEST)
    if feedback.lambda_max >= 1.0:
        raise InputError(
            f"feedback with a closed-loop eigenvalue of magnitude {feedback.lambda_max:.6g} is not allowed, "
            "because the covariance grows without bound; allowed: below 1"
        )
    model = feedback.linearization
    scales, coordinates = model.scales, model.gait.runner.coordinates
    if roughness and HEIGHT not in coordinates:
        raise InputError(
            f"roughness = {roughness:g} is not allowed; allowed: 0 for a section without {HEIGHT}, "
            f"whose coordinates are {', '.join(coordinates)}"
        )
    by_noise = model.input_matrix @ model.over_scales(feedback.gain) * np.asarray(feedback.noise) / scales
    driven = by_noise @ by_noise.T
    if roughness:
        height = coordinates.index(HEIGHT)
        by_step = roughness * model.state_matrix[:, height] / scales[height]
        driven += np.outer(by_step, by_step)
    spread: NDArray[np.float64] = solve_discrete_lyapunov(feedback.closed_loop, driven)
    return spread * np.outer(scales, scales)
