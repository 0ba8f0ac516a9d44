"""The best compromises between two quantities: the least of one for every value of the other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..analysis.search import periodic_gait
from ..analysis.targeted import TargetNotMetError
from ..checks import checked_whole
from ..errors import InputError
from ..given import row_of
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..record import origin_of
from ..terminal.progress import Bar, progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from ..variables.values import model_of
from ..variables.variable import Given
from .optimize import MAX_STARTS, STARTS
from .optimizer import Optimizer, Start
from .optimum import Optimum, reported
from .problem import Goal, check_action, checked_quantity, checked_radius, checked_space, checked_values

POINTS, MAX_POINTS = 7, 1000


@dataclass(frozen=True, eq=False, repr=False)
class Front:
    """Runners of which none is better in one quantity without being worse in the other."""

    objectives: tuple[str, str]
    """The two quantities."""
    optima: tuple[Optimum, ...]
    """From the best in the first to the best in the second."""

    def __repr__(self) -> str:
        """In a line: how many runners, between which two quantities."""
        return f"<Front of {' and '.join(self.objectives)}: {len(self.optima)} runners>"

    def as_json(self) -> dict[str, object]:
        """As a plain object."""
        return {
            **origin_of(self.optima[0].gait.runner),
            "objectives": list(self.objectives),
            "front": [best.as_json() for best in self.optima],
        }


@shares_steps
def pareto_front(
    runner: RunnerLike,
    vary: Mapping[str, tuple[Given, Given]],
    *,
    minimize: Sequence[str] = (),
    maximize: Sequence[str] = (),
    target: Mapping[str, float] | None = None,
    stable: bool | float = False,
    points: int = POINTS,
    starts: int = STARTS,
    model: str | Model | None = None,
    progress: bool = False,
) -> Front:
    """The best compromises between two quantities, from the best in one to the best in the other.

    Each is an optimum of the first quantity as `optimize` finds it, with a limit on the second; the limits
    are spread evenly between the values that the two ends have.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path
        As in `optimize`.
    vary : mapping of str to pairs of float
        As in `optimize`.
    minimize, maximize : sequence of str
        Two quantities in all; those to be minimized come first.
    target : mapping of str to float, optional
        As in `optimize`.
    stable : bool or float, default False
        As in `optimize`.
    points : int, default 7
        How many runners, both ends among them.
    starts : int, default 6
        How many searches are made at the most for the ends; the others begin at their neighbours.
    model : str, optional
        As in `optimize`.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Front
        The runners that were found.

    Raises
    ------
    InputError
        Not two quantities, and as in `optimize`.
    TargetNotMetError
        As in `optimize`.
    RunError
        As in `optimize`.

    Examples
    --------
    >>> import tdmf_slip
    >>> vary = {"hip.stance_torque": (0.15, 0.25)}
    >>> front = tdmf_slip.pareto_front(
    ...     {}, vary, minimize=["cost_of_transport"], maximize=["speed"], points=2, starts=1
    ... )
    >>> [best.parameters["hip.stance_torque"] for best in front.optima]
    [0.15, 0.25]
    """
    signs = _checked_objectives(minimize, maximize)
    (first, second), space = tuple(signs), checked_space(vary, model_of(runner, model))
    prescribed = checked_values(target, (first, second), space)
    radius = checked_radius(stable)
    goals = [Goal(name, signs[name], prescribed, radius=radius) for name in (first, second)]
    count = checked_whole("points", points, 2, MAX_POINTS)
    before = periodic_gait(Runner(runner, model=model))
    optimizer = Optimizer(before, space, checked_whole("starts", starts, 1, MAX_STARTS))
    check_action(optimizer.candidate(goals[0]), space)
    total = 2 * optimizer.count + 2 * (count - 2)
    with progress_bar("Pareto front", total, "searches", progress) as bar:
        ends = [optimizer.best(goal, bar) for goal in goals]
        inside = _between(optimizer, goals, ends[0].start, ends[1].start, count, bar)
        found = [optimizer.optimum(goals[0], ends[0]), *inside, optimizer.optimum(goals[1], ends[1])]
    return Front((first, second), tuple(found))


def _between(
    optimizer: Optimizer, goals: Sequence[Goal], begin: Start, end: Start, count: int, bar: Bar
) -> Iterator[Optimum]:
    """With limits on the second quantity, each from the one before and from the last."""
    first, second = goals
    low, high = (reported(start.gait)[second.objective] for start in (begin, end))
    for limit in np.linspace(low, high, count)[1:-1]:
        upper_limits = {second.objective: (second.sign, float(limit))}
        goal = Goal(first.objective, first.sign, first.at, upper_limits, first.radius)
        try:
            found = optimizer.best(goal, bar, (begin, end))
        except TargetNotMetError:
            continue
        begin = found.start
        yield optimizer.optimum(goal, found)


def _checked_objectives(minimize: Sequence[str], maximize: Sequence[str]) -> dict[str, float]:
    """Two quantities with their signs."""
    allowed = "names of quantities in a list, two in all"
    least, largest = row_of(minimize, "minimize", allowed), row_of(maximize, "maximize", allowed)
    signs = {checked_quantity(name, "minimize"): 1.0 for name in least}
    both = [*least, *largest]
    signs |= {checked_quantity(name, "maximize"): -1.0 for name in largest}
    if len(both) != 2 or len(signs) != 2:
        raise InputError(
            f"minimize, maximize: {', '.join(map(str, both))}; allowed: two quantities that differ"
        )
    return signs
