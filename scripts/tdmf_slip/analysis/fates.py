"""What becomes of runners that start somewhere about a gait: they settle on it, fall, or neither."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_size
from ..library import ensemble
from ..library.affine_law import AffineLaw
from ..library.runner import Runner
from ..library.section import Apex
from ..variables.variable import Given
from .ball import TOLERANCE as TOLERANCE
from .ball import Ball

ACCURACY = 5e-4
"""By which the apex after a stride then errs at the most, over the scales, from anywhere in `volume.BOX`;
from within 0.05 of a gait by a twentieth of that. Of 24,576 starts none has another fate than at 1e-10."""
MAX_STRIDES = 400
MAX_ALONG = 16384
"""Starts along each axis of a map."""
STARTS_AT_ONCE = 4096
"""In a block."""


def fates(
    runner: Runner | Mapping[str, Given],
    apex: Apex,
    starts: ArrayLike,
    *,
    tolerance: float = TOLERANCE,
    law: AffineLaw | None = None,
    first_number: int = 0,
    ball: Ball | None = None,
) -> NDArray[np.void]:
    """What becomes of runners that start somewhere, an apex to a row.

    By their numbers, which begin with the first, a law's noise is drawn. A start that comes into the gait's
    ball has settled; if the ball asks for it, the tolerance is finer.
    """
    starts = np.asarray(starts)
    check_size("starts", len(starts) if starts.ndim else 1, "runners", ensemble.MAX_RUNNERS)
    case = ensemble.Case(Runner(runner), (apex,), law=law, balls=() if ball is None else (ball.matrix,))
    return ensemble.run_ensemble(
        [case],
        starts,
        max_strides=MAX_STRIDES,
        first_number=first_number,
        near=ensemble.NEAR if ball is None else ball.near,
        tolerance=tolerance if ball is None else min(tolerance, ball.tolerance),
    )[0]
