"""Value of a feedback: region of attraction, largest disturbances, and number of strides until a fall.

The largest eigenvalue does not show these: settings have limits, sensors are noisy, and disturbances large.

Noisy sensors and rough ground lead a runner away from its gait, here to first order. At each apex the law
measures x + v, with noise v of covariance N. The ground then steps by s, of standard deviation r. The
deviation of the next apex is x' = A (x - e s) + B G (x + v), with the unit vector e of the height. In the
long run its covariance P solves the discrete Lyapunov equation

    P = (A + B G) P (A + B G)' + B G N G' B' + r^2 A e e' A'.
"""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..analysis.attraction import Robustness, Volume, attraction_volume, robustness
from ..analysis.first_passage import FirstPassage, strides_to_fall
from ..blocks import in_order
from ..checks import check_kind, checked, refusal
from ..errors import InputError
from ..given import row_of
from ..library.gait import Gait, check_is_gait
from ..library.ground import LARGEST, RoughGround
from ..library.laws import AffineLaw, Law, check_law
from ..terminal.in_blocks import in_blocks
from .gains import Feedback

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
            f"feedback whose closed loop has an eigenvalue of size {feedback.lambda_max:.6g} is not allowed: "
            "the runner strays without end; allowed: below 1"
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


SAMPLES = 4000
"""Number of random starts for the region of attraction."""
RUNNERS, MAX_STRIDES = 256, 400
"""Number of runners on rough ground, and of strides after which a run is censored."""


@dataclass(frozen=True, eq=False)
class Judgement:
    """Robustness of a gait and its law, measured by many runs."""

    gait: Gait
    """Gait that was tested."""
    law: Law | None
    """Law that holds the gait; None for the runner as it is."""
    volume: Volume
    """Share of the box of `analysis.attraction` that settles on the gait, without noise."""
    robustness: Robustness
    """Largest disturbances from which the runner recovers, without noise."""
    first_passages: tuple[FirstPassage, ...]
    """Numbers of strides until a fall on ground of each roughness, with the noise of the law's sensors."""


def judge(gait: Gait, law: Law | None = None, *, roughness: Sequence[float] = (), seed: int = 0) -> Judgement:
    """Measure by many runs how well a law holds a gait, within its limits."""
    return judge_all([(gait, law)], roughness=roughness, seed=seed)[0]


def judge_all(
    trials: Sequence[tuple[Gait, Law | None]],
    *,
    roughness: Sequence[float] = (),
    seed: int = 0,
    executor: Executor | None = None,
    progress: bool = False,
) -> list[Judgement]:
    """Run `judge` for many gaits in parallel, each with its law or None."""
    allowed = "pairs of a Gait and a law or None in a list"
    for trial in row_of(trials, "trials", allowed):
        if not isinstance(trial, tuple) or len(trial) != 2:
            raise refusal("trials", trials, allowed)
        gait, law = trial
        check_is_gait(gait, "gait")
        check_law(law, gait.runner)
    grounds = [RoughGround(one, seed) for one in row_of(roughness, "roughness", "numbers in a list, m")]
    work = partial(_judged, grounds, seed)
    with in_blocks(work, trials, "feedback", "laws", executor, progress) as results:
        return in_order(results)


def _judged(grounds: Sequence[RoughGround], seed: int, trial: tuple[Gait, Law | None]) -> Judgement:
    gait, law = trial
    quiet = replace(law, noise=None) if isinstance(law, AffineLaw) else law
    passages = (
        strides_to_fall(gait.runner, ground, RUNNERS, max_strides=MAX_STRIDES, gait=gait, law=law)
        for ground in grounds
    )
    attracted = attraction_volume(gait, SAMPLES, seed=seed, law=quiet)
    return Judgement(gait, law, attracted, robustness(gait, law=quiet), tuple(passages))
