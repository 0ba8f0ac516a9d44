"""Where an order cannot be met: the gait that is nearest to it, and which further parameter would help.

The nearest gait has the least sum of squared deviations, each over what is ordered: by the method of
Levenberg and Marquardt along the gaits, whose tangents are the null space of what closes a stride.
"""

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..library.members import VARIED
from ..library.orbit import Orbit
from ..terminal import progress
from .order import GOOD_ENOUGH, Order, Place

ITERATIONS, LOOK_AHEAD = 30, 8
"""Of the search for the nearest gait, and to see whether a further parameter helps."""
LONGEST_STEPS = (0.3, 0.03)
"""Over the scales of apex and parameters, each tried: where words change, other steps lead elsewhere."""
LEAST_DAMPING, MOST_DAMPING = 1e-9, 1e2
LITTLE = 1e-3
"""Of the gap: what a step makes it smaller by is then no more worth a further one."""
HELPING = 0.95
"""A parameter helps if, freed too, it leaves at most this share of the gap."""
MOST_TRIED, STEPS = 5, 10
"""Parameters whose derivatives promise most are tried, each by so many steps towards the order."""
SETTINGS = "hip."
"""What a runner changes at will: these are tried instead of a freed parameter, too."""
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
    iterations : int, default 30
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


@dataclass(frozen=True)
class Help:
    """A parameter that brings an order nearer, or meets it."""

    name: str
    """Of the parameter or input."""
    instead_of: str
    """Which freed parameter then keeps its value; empty where all stay free."""
    left: float
    """Of the gap; 0 where the order is met."""
    changed: float
    """How far the gait that meets the order is from the first, over the scales."""

    def __str__(self) -> str:
        """In words, after `freeing`."""
        how = f"instead of {self.instead_of}" if self.instead_of else "too"
        return f"{self.name} {how} {'meets it' if self.left == 0.0 else 'helps'}"


def parameters_that_help(
    order: Order, nearest: Place, first: Orbit, show_progress: bool = False
) -> tuple[Help, ...]:
    """Parameters and inputs that bring the order nearer, each freed beside the others or instead of one.

    Those whose derivatives promise most, at the nearest gait or at the first one, are freed one by one from
    the first gait on, as whoever frees them begins; and those are told with which the order is met, or a gait
    is found that is nearer to it.

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
    tuple of Help
        The best first: those that meet the order by the least change, then those that leave least of the gap.
        What is zero stays zero: a push on the body or a slope of the ground is not told.
    """
    most, near = HELPING * order.gap(nearest), order.orbit(nearest)
    promising = _promising(order, (near, first))
    found: list[Help] = []
    with progress.bar("what would help", len(promising), "parameters", show_progress) as bar:
        for name in promising:
            freed = _freed_too(order, name, first, near, most)
            others = order.free if name.startswith(SETTINGS) else ()
            instead = (_freed_instead(order, name, other, first) for other in others)
            one = freed if freed.left == 0.0 else next((help for help in instead if help.left == 0.0), freed)
            found += [one] if one.left <= most else []
            bar.update()
    return tuple(sorted(found, key=lambda help: (help.left, help.changed)))


def _freed_too(order: Order, name: str, first: Orbit, near: Orbit, most: float) -> Help:
    """What is left of the gap where one more parameter is free."""
    wider = order.with_more(name)
    try:
        begin = wider.place_of(first)
        there, share = wider.solved_from(begin, STEPS)
        if wider.gap(there) > most:
            there = nearest_from(wider, (wider.place_of(near),), LONGEST_STEPS[:1], LOOK_AHEAD)
    except RunError:
        return Help(name, "", np.inf, np.inf)
    changed = float(np.linalg.norm(there.at - begin.at))
    return Help(name, "", 0.0 if share == 1.0 else wider.gap(there), changed)


def _freed_instead(order: Order, name: str, other: str, first: Orbit) -> Help:
    """Whether the order is met where one parameter is free instead of another."""
    changed = order.with_one_for(other, name)
    try:
        begin = changed.place_of(first)
        there, share = changed.solved_from(begin)
    except RunError:
        share = 0.0
    if share < 1.0:
        return Help(name, other, np.inf, np.inf)
    return Help(name, other, 0.0, float(np.linalg.norm(there.at - begin.at)))


def _promising(order: Order, orbits: Sequence[Orbit]) -> list[str]:
    """Further parameters, those first of which derivatives promise that they leave least of the gap."""
    values = orbits[0].runner.values
    names = [name for name in VARIED if name not in (*order.free, *NOT_THE_RUNNERS) and values[name] != 0.0]
    widest = order.with_more(*names)
    left = dict.fromkeys(names, np.inf)
    for orbit in orbits:
        with contextlib.suppress(RunError):
            place = widest.place_of(orbit)
            kept = list(range(len(orbit.apex) + len(order.free)))
            for further, name in enumerate(names, len(kept)):
                left[name] = min(left[name], _promised(widest, place, [*kept, further]))
    return sorted(names, key=lambda name: left[name])[:MOST_TRIED]


def _promised(order: Order, place: Place, columns: list[int]) -> float:
    """The share of the gap that is left after the longest step, along gaits, by some of what is freed."""
    off, count = order.deviations(place), len(order.closing(place))
    rows = order.rows(place)[:, columns]
    tangents = _null_space(rows[:count])
    slopes = rows[count:] @ tangents
    step = -np.linalg.lstsq(slopes, off)[0]
    step *= min(1.0, LONGEST_STEPS[0] / (float(np.linalg.norm(step)) or 1.0))
    return float(np.linalg.norm(off + slopes @ step) / np.linalg.norm(off))
