"""A ball around a gait in which every start is proved to settle, for maps of fates."""

import numpy as np

from ..analysis.ball import Ball, cube_in
from ..errors import InputError, RunError
from ..library.batch_given import MIN_TOLERANCE
from ..library.gait import Gait
from .prove_attraction import prove_attraction

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
