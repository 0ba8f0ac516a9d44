"""Further gaits that a fit may begin with: of runners all over what varies, those nearest to the data."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ..analysis.settled import evenly, linked, settled_gaits
from ..analysis.target import around
from ..errors import InputError, RunError
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.varied_stride import plain_stride
from .measurements import Measurements
from .search import loss_of

RUNNERS = 1024
"""Spread over what varies."""


def starts(first: Gait, measurements: Measurements, vary: Sequence[str]) -> Iterator[Gait]:
    """Gaits to begin with, the nearest to the data first; none is near a nearer one."""
    runner, shares = first.runner, evenly(RUNNERS, len(vary))
    varied = {
        name: around(runner, name, np.ascontiguousarray(row))
        for name, row in zip(vary, shares.T, strict=True)
    }
    found = settled_gaits(runner, varied, first.apex)
    runners, apexes, points, losses = [], [], [], []
    for number, apex in zip(found.numbers, found.apexes, strict=True):
        other = runner.replace({name: float(row[number]) for name, row in varied.items()})
        loss = _loss(other, apex, measurements)
        if loss is None:
            continue
        runners.append(other)
        apexes.append(apex)
        points.append(shares[number])
        losses.append(loss)
    for k in linked(np.array(points), np.array(losses)):
        try:
            yield gait_near(runners[k], apexes[k])
        except RunError:
            continue


def _loss(runner: Runner, apex: NDArray[np.float64], measurements: Measurements) -> float | None:
    """Huber's, of a gait for all rows; None where its stride does not close."""
    losses = []
    for measured in measurements.rows:
        try:
            has = plain_stride(runner, apex, tuple(measured)).quantities
        except (InputError, RunError):
            return None
        off = [(value - of.value) / of.error for value, of in zip(has, measured.values(), strict=True)]
        losses.append(loss_of(np.array(off), True))
    return sum(losses)
