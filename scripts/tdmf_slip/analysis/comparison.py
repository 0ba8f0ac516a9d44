"""Runners compared with what could confound them held equal to what the first of them has.

Two runners that differ in friction differ in speed, in how high they hop and in how high they carry the foot.
A difference between them says what friction does only where these are the same.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import InputError
from ..given import row_of
from ..library.gait import Gait, gaits_dataset
from ..library.members import checked_names
from ..library.quantities import allowed_quantities, check_quantities, checked_quantity, quantities_of
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..record import in_dataset
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


@dataclass(frozen=True)
class NotHeld:
    """A quantity that a runner could not be given."""

    runner: int
    """Number of the runner; the reference is 0."""
    quantity: str
    """Name of the quantity."""
    wanted: float
    """Value of the reference."""
    has: float
    """Value of the runner that came nearest."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """Runners with the same speed, clearance or the like, whose differences have fewer causes."""

    hold: tuple[str, ...]
    """Quantities that are to be equal."""
    vary: tuple[str, ...]
    """Names of the parameters that may change for it."""
    before: tuple[Gait, ...]
    """The gaits of the runners as they were given; the first is the reference."""
    after: tuple[Gait, ...]
    """The gaits with what is held as the reference has it, or as near to it as was found."""
    not_held: tuple[NotHeld, ...]
    """Quantities that could not be made equal: empty where all runners are matched."""

    @property
    def names(self) -> tuple[str, ...]:
        """Parameters and inputs that are varied, or of which the runners have different values."""
        gaits = (*self.before, *self.after)
        model = gaits[0].runner.model
        names = (name for name in model.names if name not in model.states)
        return tuple(
            name for name in names if name in self.vary or len({gait.runner[name] for gait in gaits}) > 1
        )


def _dataset(found: Comparison) -> xarray.Dataset:
    gaits = [gait for pair in zip(found.before, found.after, strict=True) for gait in pair]
    numbers = np.arange(len(found.after))
    places: dict[str, Any] = {"runner": numbers, "step": np.array(["before", "after"], dtype=object)}
    hold, vary = ", ".join(found.hold), ", ".join(found.vary)
    data = gaits_dataset("comparison", gaits, places, varied=found.names, hold=hold, vary=vary)
    missed = {(of.runner, of.quantity) for of in found.not_held}
    held = [[(number, name) not in missed for name in found.hold] for number in numbers.tolist()]
    held_by: dict[str, Any] = {"held": (("runner", "quantity"), np.array(held, np.int8))}
    return data.assign(held_by).assign_coords(quantity=list(found.hold))


@in_dataset(_dataset)
@shares_steps
def compare(
    runners: Sequence[RunnerLike],
    *,
    hold: Sequence[str],
    vary: Sequence[str],
    model: str | None = None,
    progress: bool = False,
) -> Comparison:
    """Match runners in what could confound a comparison.

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
    matched, not_held = [before[0]], []
    with progress_bar("compare", len(before) - 1, "runners", progress) as bar:
        for number, gait in enumerate(before[1:], start=1):
            after, missing = _matched(gait, goal, varied, number, model)
            matched.append(after)
            not_held += missing
            bar.update()
    return Comparison(names, varied, tuple(before), tuple(matched), tuple(not_held))


def _checked_hold(hold: object, model: Model) -> tuple[str, ...]:
    names = tuple(row_of(hold, "hold", "a list of names of quantities"))
    if not names:
        raise InputError(f"hold: nothing is held; allowed: {', '.join(allowed_quantities(model))}")
    for name in names:
        checked_quantity(name, "hold", model)
        if names.count(name) > 1:
            raise InputError(f"hold: {name} is given twice; allowed: once")
    return names


def _gait_of(given: Runner | Mapping[str, Given] | Gait | None, model: str | None) -> Gait:
    if isinstance(given, Gait) and Runner(given, model=model) == given.runner:
        return given
    return periodic_gait(Runner(given, model=model))


def _matched(
    gait: Gait,
    goal: Mapping[str, float],
    vary: Sequence[str],
    number: int,
    model: str | None,
) -> tuple[Gait, list[NotHeld]]:
    """The gait with what is held, or the nearest one with what it lacks."""
    if _lacking(gait, goal, number) == []:
        return gait, []
    try:
        found = find_gait(gait.runner, target=goal, vary=vary, guess=gait.apex, model=model)
    except TargetNotMetError as problem:
        found = problem.nearest
    return found, _lacking(found, goal, number)


def _lacking(gait: Gait, goal: Mapping[str, float], number: int) -> list[NotHeld]:
    has = quantities_of(gait, list(goal))
    return [
        NotHeld(number, name, wanted, has[name])
        for name, wanted in goal.items()
        if abs(has[name] - wanted) > MATCHED * max(abs(wanted), abs(has[name]))
    ]
