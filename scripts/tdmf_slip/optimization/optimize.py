"""Optimal runners: parameters within bounds for which a quantity of the gait is least or largest."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..analysis.search import periodic_gait
from ..analysis.targeted import NO_ACTION, TargetNotMetError, checked_target
from ..checks import checked, checked_whole
from ..errors import InputError
from ..given import row_of
from ..library.gait import gaits_dataset
from ..library.members import ranges_varied
from ..library.quantities import checked_quantity, choice_of_quantities
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..record import in_dataset
from ..terminal.progress import Bar, progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from ..variables.variable import Given
from .gaits import Candidate, Space
from .optimizer import Optimizer
from .optimum import Optimum, reported
from .problem import Goal

if TYPE_CHECKING:
    import xarray

STARTS, MAX_STARTS = 6, 100


@shares_steps
def optimize(
    runner: RunnerLike,
    vary: Mapping[str, tuple[Given, Given]],
    *,
    minimize: str | None = None,
    maximize: str | None = None,
    target: Mapping[str, float] | None = None,
    stable: bool | float = False,
    starts: int = STARTS,
    model: str | Model | None = None,
    progress: bool = False,
) -> Optimum:
    """Find the parameters within bounds whose gait has the least or the most of a quantity.

    Sequential quadratic programming (SLSQP) uses exact gradients of the gait's quantities. They are smooth
    only while the gait word and the events of the stride stay. If an iterate is in another region, the
    border is located. If the objective improves beyond it, the search goes on there. Else SLSQP finds the
    best point along the border, and the gradients of both sides show whether that is an optimum, see
    `Optimum.remaining_improvement`. Near a fold the search stops where the leading eigenvalue is about 0.99,
    and `limits` reports `fold`.

    Each search is local. The first begins with the given runner. The others begin at the most promising of
    about a thousand gaits that the ensemble engine finds all over the bounds (multi-level single linkage).
    `basins` is the number of different optima among the results. The result is called local unless no gait
    can have less: a better gait that no search reaches may exist, also on a branch of unstable gaits.

    Parameters
    ----------
    runner : as in `find_gait`
    vary : mapping of str to pairs of float
        Parameters and inputs that vary, with lower and upper bounds, also as texts like `40 deg`.
    minimize, maximize : str, optional
        One of the two: the quantity, by a name of `library.quantities.QUANTITIES`, among them
        `cost_of_transport`, `speed`, `slip_distance`.
    target : mapping of str to float, optional
        Prescribed values of quantities by the same names, in SI units.
    stable : bool or float, default False
        Largest spectral radius of the gait; True stands for 0.99. The leading eigenvalues are constrained one
        by one, because they are smooth where the radius itself is not.
    starts : int, default 6
        Largest number of searches, from gaits spread over the bounds; the best result is kept. A single
        search begins at the runner's own gait.
    model, progress : as in `find_gait`

    Returns
    -------
    Optimum
        The parameters, the gait, which bounds are active, and whether it was shown to be an optimum.

    Raises
    ------
    InputError
        An unknown quantity, bounds that are none, a parameter without effect, or a value that is refused.
    TargetNotMetError
        No gait within the bounds has what is prescribed, or is stable: `nearest` is the nearest that was
        found.
    RunError
        There is no gait to begin with, or none within the bounds.

    Examples
    --------
    >>> import tdmf_slip
    >>> angles = {"hip.touchdown_angle": (0.5, 0.75)}
    >>> best = tdmf_slip.optimize({}, angles, minimize="cost_of_transport", starts=1)
    >>> best.active_bounds
    {'hip.touchdown_angle': 'upper'}
    """
    runner = Runner(runner, model=model)
    least, largest = ([] if name is None else [name] for name in (minimize, maximize))
    signs = checked_objectives(least, largest, 1, runner.model)
    optimizer, (goal,) = _prepared(runner, vary, signs, target, stable, starts)
    with progress_bar("optimize", optimizer.count, "starts", progress) as bar:
        return optimizer.best(goal, bar)


FROM_ZERO = ("slip_distance",)
"""Quantities that may be prescribed as zero."""
MAX_PARAMETERS = 12
LARGEST_RADIUS = 0.99
"""Largest spectral radius of a gait that is to be stable, where no other is given."""


def checked_objectives(
    minimize: Sequence[str], maximize: Sequence[str], count: int, model: Model
) -> dict[str, float]:
    """`count` quantities with their signs: 1 to minimize, -1 to maximize."""
    signs = {checked_quantity(name, "minimize", model): 1.0 for name in minimize}
    signs |= {checked_quantity(name, "maximize", model): -1.0 for name in maximize}
    given = [*minimize, *maximize]
    if len(given) != count or len(signs) != count:
        allowed = "one quantity" if count == 1 else "two quantities that differ"
        raise InputError(
            f"minimize, maximize: {', '.join(map(str, given)) or 'nothing'} given; allowed: {allowed}, of "
            f"{choice_of_quantities(model)}"
        )
    return signs


def checked_space(vary: object, model: Model) -> Space:
    """Varied parameters, between bounds that the unit allows."""
    allowed = f"1 to {MAX_PARAMETERS} parameters and inputs by name, each with two bounds, A below B"
    bounds = ranges_varied(vary, range(1, MAX_PARAMETERS + 1), allowed, model)
    for name, (low, high) in bounds.items():
        if not low < high:
            raise InputError(f"vary {name} = {low:g}:{high:g} is not allowed; allowed: A:B with A below B")
    return Space(bounds)


def checked_values(
    target: object, objectives: tuple[str, ...], space: Space, model: Model
) -> dict[str, float]:
    """Prescribed quantities with their values."""
    found = checked_target(target, model, FROM_ZERO)
    for name in found:
        if name in objectives:
            raise InputError(
                f"target {name}: this quantity is also minimized or maximized; allowed: another one"
            )
    if len(found) > len(space.bounds):
        raise InputError(
            f"target: {', '.join(found)} by varying {', '.join(space.bounds)}; "
            "allowed: no more targets than parameters"
        )
    return found


def checked_radius(stable: object) -> float | None:
    """Largest spectral radius that is requested; None for any."""
    if isinstance(stable, bool | np.bool_):
        return LARGEST_RADIUS if stable else None
    return checked("stable", stable, 1e-3, 1.0)


def check_action(gait: Candidate, space: Space) -> None:
    """Refuse parameters that have no effect on a gait."""
    for k, name in enumerate(space.bounds):
        if max(np.max(np.abs(gait.apex_slopes[:, k])), np.max(np.abs(gait.slopes[:, k]))) <= NO_ACTION:
            raise InputError(f"vary {name}: has no effect on this gait; choose a parameter that does")


def _prepared(
    runner: Runner,
    vary: object,
    signs: Mapping[str, float],
    target: object,
    stable: object,
    starts: object,
) -> tuple[Optimizer, list[Goal]]:
    """Check the arguments, and return the optimizer and a goal for each objective."""
    space = checked_space(vary, runner.model)
    prescribed, radius = checked_values(target, tuple(signs), space, runner.model), checked_radius(stable)
    goals = [Goal(name, sign, prescribed, radius=radius) for name, sign in signs.items()]
    count = checked_whole("starts", starts, 1, MAX_STARTS)
    optimizer = Optimizer(periodic_gait(runner), space, count)
    check_action(optimizer.candidate(goals[0]), space)
    return optimizer, goals


POINTS, MAX_POINTS = 7, 1000


def _dataset(found: tuple[tuple[str, str], tuple[Optimum, ...]]) -> xarray.Dataset:
    objectives, optima = found
    numbers = {"optimum": np.arange(len(optima), dtype=float)}
    gaits, names = [best.gait for best in optima], tuple(optima[0].parameters)
    data = gaits_dataset("front", gaits, numbers, varied=names, objectives=", ".join(objectives))
    texts = {
        "active_bounds": [", ".join(map(": ".join, best.active_bounds.items())) for best in optima],
        "limits": [", ".join(best.limits) for best in optima],
        "why": [best.why for best in optima],
    }
    variables: dict[str, Any] = {name: ("optimum", np.array(of, dtype=object)) for name, of in texts.items()}
    return data.assign(variables)


@in_dataset(_dataset)
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
) -> tuple[tuple[str, str], tuple[Optimum, ...]]:
    """Find the best compromises between two quantities, from the best in one to the best in the other.

    Each compromise is an optimum of the first quantity as `optimize` finds it, with a limit on the second.
    The limits are spread evenly between the values of the two ends.

    Parameters
    ----------
    runner, vary : as in `optimize`
    minimize, maximize : sequence of str
        Two quantities in all; those to be minimized come first.
    target, stable : as in `optimize`
    points : int, default 7
        Number of runners, both ends included.
    starts : int, default 6
        Largest number of searches for each end; the others begin at their neighbours.
    model, progress : as in `optimize`

    Returns
    -------
    xarray.Dataset
        Over `optimum`, from the best in the first quantity to the best in the second: all quantities of the
        gaits, the parameters that are varied, and of each optimum `active_bounds`, `limits`, and `why` it is
        not shown to be one, or an empty text. `gait_at(front.isel(optimum=0))` is a gait.

    Raises
    ------
    InputError
        Not two quantities.
    TdmfSlipError
        Those of `optimize`.

    Examples
    --------
    >>> import tdmf_slip
    >>> vary = {"hip.stance_torque": (0.15, 0.25)}
    >>> front = tdmf_slip.pareto_front(
    ...     {}, vary, minimize=["cost_of_transport"], maximize=["speed"], points=2, starts=1
    ... )
    >>> front["hip.stance_torque"].values.tolist()
    [0.15, 0.25]
    """
    runner = Runner(runner, model=model)
    allowed = "names of quantities in a list, two in all"
    least, largest = row_of(minimize, "minimize", allowed), row_of(maximize, "maximize", allowed)
    signs = checked_objectives(least, largest, 2, runner.model)
    count = checked_whole("points", points, 2, MAX_POINTS)
    optimizer, goals = _prepared(runner, vary, signs, target, stable, starts)
    total = 2 * optimizer.count + 2 * (count - 2)
    with progress_bar("Pareto front", total, "searches", progress) as bar:
        ends = [optimizer.best(goal, bar) for goal in goals]
        found = [ends[0], *_between(optimizer, goals, ends, count, bar), ends[1]]
    return (goals[0].objective, goals[1].objective), tuple(found)


def _between(
    optimizer: Optimizer, goals: Sequence[Goal], ends: Sequence[Optimum], count: int, bar: Bar
) -> Iterator[Optimum]:
    """Optima with limits on the second quantity, each searched from the one before and the second end."""
    first, second = goals
    low, high = (reported(best.gait)[second.objective] for best in ends)
    before = ends[0]
    for limit in np.linspace(low, high, count)[1:-1]:
        goal = replace(first, upper_limits={second.objective: (second.sign, float(limit))})
        try:
            before = optimizer.best(goal, bar, (before.gait, ends[1].gait))
        except TargetNotMetError:
            continue
        yield before
