"""Fates of runners that start near a gait: they settle on it, fall, or do neither."""

from numpy.typing import ArrayLike

from ..library.batch import Batch
from ..library.laws import Law
from ..library.runner import Runner
from ..library.section import Apex
from ..library.tables import Table
from .ball import TOLERANCE as TOLERANCE
from .ball import Ball

ACCURACY = 5e-4
"""Largest error of the apex after a stride, over the scales, from anywhere in `attraction.BOX`;
from within 0.05 of a gait by a twentieth of that. Of 24,576 starts none has another fate than at 1e-10."""
MAX_STRIDES = 400
MAX_ALONG = 16384
"""Starts along each axis of a map."""
STARTS_AT_ONCE = 4096
"""In a block."""


def fates(
    runner: Runner,
    apex: Apex,
    starts: ArrayLike,
    *,
    tolerance: float = TOLERANCE,
    law: Law | None = None,
    first_number: int = 0,
    ball: Ball | None = None,
) -> Table:
    """Fates of runners, one for each row of starts, by the names of `Batch.run`.

    A law's noise is drawn by the numbers of the runners, which count from `first_number`. A runner that
    enters the gait's ball has settled. A ball may require a finer tolerance.
    """
    if ball is not None:
        tolerance = min(tolerance, ball.tolerance)
    batch = Batch(runner, starts, law=law, first_number=first_number, tolerance=tolerance)
    if ball is None:
        return batch.run(MAX_STRIDES, apex)
    return batch.run(MAX_STRIDES, apex, near=ball.near, balls=ball.matrix[None])
