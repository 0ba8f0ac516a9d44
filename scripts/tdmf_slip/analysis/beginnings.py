"""Where else a search for a gait with a target may begin: gaits with varied parameters far from the first's.

Newton's method leads to a target from a gait that is near, and on a way of targets from one of the same
branch; where that branch ends, or the way leads where no gait is, another gait may still lead there.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.scales import scale_of
from ..library.varied_stride import plain_stride
from ..variables.table import VARIABLES
from .linkage import linked
from .settled import evenly, settled_gaits
from .target import Iterate, Target

RUNNERS = 1024
"""Spread over the varied parameters."""
FACTOR = 4.0
"""To both sides of a varied parameter's value, that of a runner may be other by as much."""
FROM_ZERO = 0.4
"""Of its scale, where that value is zero."""
NONE = 1e-6
"""Of what is prescribed: less counts as none of it."""


def beginnings(target: Target, first: Gait) -> Iterator[Iterate]:
    """Gaits from which a target may be reached, the nearest to it first."""
    runner = first.runner
    shares = evenly(RUNNERS, len(target.vary))
    varied = {
        name: around(runner, name, np.ascontiguousarray(row))
        for name, row in zip(target.vary, shares.T, strict=True)
    }
    found = settled_gaits(runner, varied, first.apex)
    values = np.column_stack(list(varied.values()))
    known, points, gaps = [], [], []
    for number, apex in zip(found.numbers, found.apexes, strict=True):
        at = np.append(apex, values[number]) / target.scales
        try:
            quantities = plain_stride(target.runner_at(at), apex, target.names).quantities
        except (InputError, RunError):
            continue
        known.append(at)
        points.append(shares[number])
        gaps.append(_gap(quantities, target.prescribed))
    for k in linked(np.array(points), np.array(gaps)):
        try:
            yield target.closed_near(known[k])
        except RunError:
            continue


def around(runner: Runner, name: str, shares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values of a parameter: by factors of its own or, where that is zero, about it."""
    variable, value = VARIABLES[name], runner[name]
    if value:
        values = value * FACTOR ** (2.0 * shares - 1.0)
    else:
        reach = FROM_ZERO * scale_of(runner, variable.unit)
        low, high = max(-reach, variable.minimum), min(reach, variable.maximum)
        values = low + shares * (high - low)
    clipped: NDArray[np.float64] = np.clip(values, variable.minimum, variable.maximum)
    return clipped


def _gap(quantities: NDArray[np.float64], prescribed: NDArray[np.float64]) -> float:
    """How far a gait is from a target, by factors: half is as far as twice; where signs differ, over it."""
    size = np.abs(prescribed)
    size[size == 0.0] = 1.0
    factors = np.maximum(quantities / size, NONE) / np.maximum(prescribed / size, NONE)
    positive = (prescribed > 0.0) & (quantities >= 0.0)
    off = np.where(positive, np.log(factors), (quantities - prescribed) / size)
    return float(np.linalg.norm(off))
