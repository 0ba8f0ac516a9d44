"""Where else a search for a gait to order may begin: at gaits whose freed parameters are far from the first.

Newton's method leads to an order from a gait that is near, and on a way of orders from one of the same
branch; where that branch ends, or the way leads where no gait is, another gait may still lead there.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, RunError
from ..library.orbit import Orbit
from ..library.runner import Runner
from ..library.scales import scale_of
from ..library.varied_stride import plain_stride
from ..unit.unit import Unit
from .linkage import linked
from .order import Order, Place
from .settled import evenly, settled_gaits

RUNNERS = 1024
"""Spread over the freed parameters."""
FACTOR = 4.0
"""To both sides of a freed parameter's value, that of a runner may be other by as much."""
FROM_ZERO = 0.4
"""Of its scale, where that value is zero."""
NONE = 1e-6
"""Of what is ordered: less counts as none of it."""


def beginnings(order: Order, first: Orbit, unit: Unit) -> Iterator[Place]:
    """Gaits from which an order may be reached, the nearest to it first.

    Parameters
    ----------
    order : Order
        What is ordered, and what is freed.
    first : Orbit
        A gait with the freed parameters' own values.
    unit : Unit
        Whose ranges hold.

    Yields
    ------
    Place
        Of a gait.
    """
    runner = first.runner
    shares = evenly(RUNNERS, len(order.free))
    varied = {
        name: around(runner, unit, name, np.ascontiguousarray(row))
        for name, row in zip(order.free, shares.T, strict=True)
    }
    found = settled_gaits(runner, varied, first.apex)
    values = np.column_stack(list(varied.values()))
    known, places, gaps = [], [], []
    for number, apex in zip(found.numbers, found.apexes, strict=True):
        at = np.append(apex, values[number]) / order.scales
        try:
            quantities = plain_stride(order.runner_at(at), apex, order.names).quantities
        except (InputError, RunError):
            continue
        known.append(at)
        places.append(shares[number])
        gaps.append(_gap(quantities, order.ordered))
    for k in linked(np.array(places), np.array(gaps)):
        try:
            yield order.closed_near(known[k])
        except RunError:
            continue


def around(runner: Runner, unit: Unit, name: str, shares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values of a parameter: by factors of its own or, where that is zero, about it.

    Parameters
    ----------
    runner : Runner
        Whose.
    unit : Unit
        Whose range of the parameter holds.
    name : str
        Of the parameter or input.
    shares : ndarray of float
        From 0 to 1, of the way from the least value to the greatest.

    Returns
    -------
    ndarray of float
        In the unit's unit.
    """
    variable, value = unit.variables[name], runner.values[name]
    if value:
        values = value * FACTOR ** (2.0 * shares - 1.0)
    else:
        reach = FROM_ZERO * scale_of(runner, variable.unit)
        low, high = max(-reach, variable.minimum), min(reach, variable.maximum)
        values = low + shares * (high - low)
    clipped: NDArray[np.float64] = np.clip(values, variable.minimum, variable.maximum)
    return clipped


def _gap(quantities: NDArray[np.float64], ordered: NDArray[np.float64]) -> float:
    """How far a gait is from an order, by factors: half is as far as twice; where signs differ, over it."""
    size = np.abs(ordered)
    size[size == 0.0] = 1.0
    factors = np.maximum(quantities / size, NONE) / np.maximum(ordered / size, NONE)
    positive = (ordered > 0.0) & (quantities >= 0.0)
    off = np.where(positive, np.log(factors), (quantities - ordered) / size)
    return float(np.linalg.norm(off))
