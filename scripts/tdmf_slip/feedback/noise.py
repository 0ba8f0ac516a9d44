"""How far a runner strays from its gait where its sensors are noisy and the ground is rough, to first order.

At each apex the law measures x + v, with noise v of covariance N, and the ground then steps by s, of standard
deviation r, so that the next apex's deviation is x' = A (x - e s) + B G (x + v), with e the height. In the
long run its covariance P solves the discrete Lyapunov equation

    P = (A + B G) P (A + B G)' + B G N G' B' + r^2 A e e' A'.
"""

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind, checked
from ..errors import InputError
from ..library.ground import LARGEST
from ..library.section import COORDINATES
from .feedback import Feedback

HEIGHT = COORDINATES.index("com_height")


def apex_covariance(feedback: Feedback, roughness: float = 0.0) -> NDArray[np.float64]:
    """The covariance of a runner's apices about its gait's, in the long run and to first order.

    Parameters
    ----------
    feedback : Feedback
        With the noise of its sensors, `noise`; its limits are taken as out of reach.
    roughness : float, default 0
        Standard deviation of the steps of the ground, m.

    Returns
    -------
    ndarray of float, shape (n, n)
        In the units of the section; as measured at the apices, above the ground before it steps.

    Raises
    ------
    InputError
        No feedback, one under which the gait is unstable, or a roughness out of range.

    Examples
    --------
    A law whose sensors are off by a thousandth of the section's scales; the height of the apex then varies by

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
    scales = model.scales
    by_noise = model.input_matrix @ np.asarray(feedback.gain) / scales[:, None] * np.asarray(feedback.noise)
    by_step = roughness * model.state_matrix[:, HEIGHT] / scales
    driven = by_noise @ by_noise.T + np.outer(by_step, by_step)
    spread: NDArray[np.float64] = solve_discrete_lyapunov(feedback.closed_loop, driven)
    return spread * np.outer(scales, scales)
