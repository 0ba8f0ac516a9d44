"""Comparison of runners that are matched in the quantities that could confound it.

Runners that differ in friction also differ in speed, apex height and foot clearance. A difference between
them shows the effect of friction only if these quantities are equal.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..checks import check_once
from ..errors import InputError
from ..given import row_of
from ..library.gait import Gait, gaits_dataset
from ..library.members import checked_names
from ..library.quantities import check_quantities, checked_quantity, choice_of_quantities, quantities_of
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from ..variables.variable import Given
from .search import periodic_gait
from .targeted import TargetNotMetError, find_gait

if TYPE_CHECKING:
    import xarray

MATCHED = 1e-8
"""Largest relative deviation of a quantity that counts as held."""


@shares_steps
def compare(
    runners: Sequence[RunnerLike],
    *,
    hold: Sequence[str],
    vary: Sequence[str],
    model: str | None = None,
    progress: bool = False,
) -> xarray.Dataset:
    """Match runners in quantities that could confound a comparison.

    The first runner is the reference and stays as it is. Of each other runner, the parameters in `vary` are
    changed until its gait has the quantities in `hold` as the reference has them, as by `find_gait`. Where no
    such gait is found, the nearest is taken, and `held` says what differs.

    Parameters
    ----------
    runners : sequence of Runner, mapping of str to float, Gait or None
        Two or more runners, each as in `find_gait`.
    hold : sequence of str
        Quantities of a gait that are to be equal, by names of `library.quantities.QUANTITIES`, as `speed`,
        `apex_height` and `foot_clearance`.
    vary : sequence of str
        Parameters and inputs that may change, at least as many as quantities to match. If there are more,
        each step is the shortest one, relative to their values.
    model, progress : as in `find_gait`

    Returns
    -------
    xarray.Dataset
        Over `runner` and `step`, which is `before` or `after`: all quantities of the gaits, and as
        coordinates the parameters that vary or differ between the runners. `held`, over `runner` and
        `quantity`, is 1 where a quantity could be made equal. `gait_at(matched.isel(runner=1, step=1))` is a
        gait.

    Raises
    ------
    InputError
        There are fewer than two runners, a name is unknown, nothing is held, or `find_gait` refuses what is
        varied.
    RunError
        A runner has no gait.

    Examples
    --------
    >>> import tdmf_slip
    >>> matched = tdmf_slip.compare(
    ...     [{"ground.friction": 0.2}, {"ground.friction": 10.0}],
    ...     hold=["speed", "apex_height", "apex_leg_angle"],
    ...     vary=["hip.stance_torque", "hip.touchdown_angle", "hip.liftoff_angle_factor"],
    ... )
    >>> bool(matched["held"].all()), matched["speed"].sel(runner=1, step="after").item().__round__(6)
    (True, 0.83453)
    """
    given = row_of(runners, "runners", "a list of two runners or more")
    if len(given) < 2:
        raise InputError(f"runners: {len(given)} given; allowed: two or more, the first is the reference")
    before = [_gait_of(runner, model) for runner in given]
    own = before[0].runner.model
    names = _checked_hold(hold, own)
    varied = checked_names(vary, "vary", own)
    for gait in before:
        check_quantities(gait.runner, names)
    goal = quantities_of(before[0], names)
    pairs = [(before[0], before[0])]
    with progress_bar("compare", len(before) - 1, "runners", progress) as bar:
        for gait in before[1:]:
            pairs.append((gait, _matched(gait, goal, varied, model)))
            bar.update()
    gaits = [gait for pair in pairs for gait in pair]
    differ = (name for name in own.names if name not in own.states)
    parameters = [name for name in differ if name in varied or len({gait.runner[name] for gait in gaits}) > 1]
    places: dict[str, Any] = {
        "runner": np.arange(len(pairs)),
        "step": np.array(["before", "after"], dtype=object),
    }
    data = gaits_dataset("comparison", gaits, places, varied=parameters)
    held = np.array([_held(after, goal) for _, after in pairs], np.int8)
    data = data.assign(held=(("runner", "quantity"), held)).assign_coords(quantity=list(names))
    return data.assign_attrs(hold=", ".join(names), vary=", ".join(varied))


def _checked_hold(hold: object, model: Model) -> tuple[str, ...]:
    names = tuple(row_of(hold, "hold", "a list of names of quantities"))
    if not names:
        raise InputError(f"hold: nothing is held; allowed: {choice_of_quantities(model)}")
    for name in names:
        checked_quantity(name, "hold", model)
    check_once(names, "hold")
    return names


def _gait_of(given: Runner | Mapping[str, Given] | Gait | None, model: str | None) -> Gait:
    if isinstance(given, Gait) and Runner(given, model=model) == given.runner:
        return given
    return periodic_gait(Runner(given, model=model))


def _matched(gait: Gait, goal: Mapping[str, float], vary: Sequence[str], model: str | None) -> Gait:
    """The gait with the held quantities of the reference, or the nearest one."""
    if all(_held(gait, goal)):
        return gait
    try:
        return find_gait(gait.runner, target=goal, vary=vary, guess=gait.apex, model=model)
    except TargetNotMetError as problem:
        return problem.nearest


def _held(gait: Gait, goal: Mapping[str, float]) -> list[bool]:
    """Flags of the quantities that are equal to those of the reference."""
    has = quantities_of(gait, list(goal))
    return [
        abs(has[name] - wanted) <= MATCHED * max(abs(wanted), abs(has[name])) for name, wanted in goal.items()
    ]
