"""Where an order cannot be met: the gait that is nearest to it, and which further parameter would help.

The nearest gait has the least sum of squared deviations, each over what is ordered: by the method of
Levenberg and Marquardt along the gaits, whose tangents are the null space of what closes a stride.
"""

import contextlib
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.members import VARIED
from ..library.orbit import Orbit
from ..terminal import progress
from .order import GOOD_ENOUGH, Order, Place

ITERATIONS, LOOK_AHEAD = 40, 16
"""Of the search for the nearest gait, and to see whether a further parameter helps."""
LONGEST_STEPS = (0.3, 0.1, 0.03)
"""Over the scales of apex and parameters, each tried: where words change, other steps lead elsewhere."""
LEAST_DAMPING, MOST_DAMPING = 1e-9, 1e2
LITTLE = 1e-3
"""Of the gap: what a step makes it smaller by is then no more worth a further one."""
HELPING = 0.95
"""A parameter helps if, freed too, it leaves at most this share of the gap."""
NOT_THE_RUNNERS = ("gravity",)
"""Not told as a help: nobody can turn it."""


def nearest_from(
    order: Order,
    places: Sequence[Place],
    steps: Sequence[float] = LONGEST_STEPS,
    iterations: int = ITERATIONS,
) -> Place:
    """The gait nearest to an order, of those that are reached from some gaits.

    Parameters
    ----------
    order : Order
        Which the gaits do not meet.
    places : sequence of Place
        Of the gaits.
    steps : sequence of float
        Longest steps to be tried.
    iterations : int, default 40
        Of each, with steps that are refused.

    Returns
    -------
    Place
        Of a gait that is not farther from the order than any of those given.
    """
    return min(
        (_descended(order, place, step, iterations) for place in places for step in steps), key=order.gap
    )


def _descended(order: Order, place: Place, longest: float, iterations: int) -> Place:
    """Where the gap gets no smaller."""
    damping = 1e-3
    for _ in range(iterations):
        gap = order.gap(place)
        tried = _stepped(order, place, damping, longest)
        if tried is None or order.gap(tried) >= gap:
            damping *= 10.0
            if damping > MOST_DAMPING:
                break
            continue
        place, damping = tried, max(0.1 * damping, LEAST_DAMPING)
        if order.gap(tried) <= GOOD_ENOUGH or gap - order.gap(tried) < LITTLE * gap:
            break
    return place


def _stepped(order: Order, place: Place, damping: float, longest: float) -> Place | None:
    """A step towards the order along the gaits; None where there is no gait."""
    count = len(order.closing(place))
    rows = order.rows(place)
    tangents = _null_space(rows[:count])
    slopes = rows[count:] @ tangents
    square = slopes.T @ slopes + damping * np.eye(tangents.shape[1])
    step = tangents @ np.linalg.solve(square, -slopes.T @ order.deviations(place))
    step *= min(1.0, longest / (float(np.linalg.norm(step)) or 1.0))
    try:
        return order.closed_near(place.at + step)
    except RunError:
        return None


def _null_space(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """An orthonormal basis of it, in columns, for rows that are independent."""
    basis: NDArray[np.float64] = np.linalg.svd(rows)[2][len(rows) :].T
    return basis


def parameters_that_help(
    order: Order, nearest: Place, first: Orbit, show_progress: bool = False
) -> tuple[str, ...]:
    """Parameters and inputs that bring the order nearer, each freed beside the others.

    Parameters
    ----------
    order : Order
        Which cannot be met.
    nearest : Place
        The gait nearest to it.
    first : Orbit
        The gait that the search began with.
    show_progress : bool, default False
        A bar on stderr.

    Returns
    -------
    tuple of str
        Those that leave less of the gap, the best first. What is zero stays zero: a push on the body or a
        slope of the ground is not told.
    """
    gap, begins = order.gap(nearest), (order.orbit(nearest), first)
    tried = [
        name
        for name in VARIED
        if name not in (*order.free, *NOT_THE_RUNNERS) and first.runner.values[name] != 0.0
    ]
    left: dict[str, float] = {}
    with progress.bar("what would help", len(tried), "parameters", show_progress) as bar:
        for name in tried:
            wider = order.with_one_more(name)
            with contextlib.suppress(RunError):
                places = [wider.place_of(orbit) for orbit in begins]
                left[name] = wider.gap(nearest_from(wider, places, LONGEST_STEPS[:1], LOOK_AHEAD))
            bar.update()
    return tuple(sorted((n for n in left if left[n] <= HELPING * gap), key=lambda n: left[n]))
