"""Gaits with prescribed quantities, such as speed and step frequency, found by varying parameters."""

from __future__ import annotations

import inspect
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice

import numpy as np

from ..checks import checked, near_matches, shown
from ..errors import InputError, RunError
from ..given import mapping_of, row_of
from ..library.gait import Gait
from ..library.members import NAMES, checked_names
from ..library.quantities import (
    SIGNED,
    allowed_quantities,
    check_quantities,
    checked_quantity,
    choice_of_quantities,
    quantities_of,
    quantity_given,
)
from ..library.runner import Runner
from ..library.section import Apex
from ..library.shared_steps import shares_steps
from ..terminal.text import quantity
from ..variables.parameters import RunnerLike
from ..variables.table import Model, model_of
from ..variables.variable import Given
from .gait_problem import GaitProblem
from .search import periodic_gait
from .target import (
    Help,
    Iterate,
    initial_iterates,
    iterate_at,
    least_changed,
    nearest_from,
    parameters_that_help,
    solved_from,
)

TRAVEL = ("speed", "frequency", "length")
"""Quantities of a stride; two of them determine the third, because length is speed over frequency."""
MINIMUM, MAXIMUM = 1e-9, 1e9
"""Least and largest prescribed value, in SI units."""
MET = 1e-10
"""Largest deviation of a gait that meets a target, over the prescribed values."""
LAST_STEPS = 10
"""Steps from the nearest gait towards the target, and from each of the others."""
MAX_STARTS = 8
"""Largest number of other gaits from which a search begins."""
DESCENTS = 2
"""Number of the nearest gaits from which the gait nearest to the target is searched for."""
NO_ACTION = 1e-11
"""Largest change over the scales that counts as rounding."""


class TargetNotMetError(RunError):
    """No gait was found that has the prescribed quantities."""

    def __init__(self, message: str, nearest: Gait, helps: tuple[str, ...]) -> None:
        """Keep the gait nearest to the target, and the parameters that would bring it nearer."""
        super().__init__(message)
        self.nearest, self.helps = nearest, helps

    def __reduce__(self) -> tuple[type[TargetNotMetError], tuple[str, Gait, tuple[str, ...]]]:
        """The error with its gait and hints, for pickle."""
        return type(self), (str(self), self.nearest, self.helps)


@shares_steps
def find_gait(
    runner: RunnerLike = None,
    *,
    target: Mapping[str, float] | None = None,
    vary: Sequence[str] = (),
    guess: Apex | None = None,
    model: str | Model | None = None,
    progress: bool = False,
    **values: Given,
) -> Gait:
    """Find the periodic gait of a runner, stable or not, or the gait that meets a target.

    With a guess, Newton's method finds the gait near it. Without one, the same gait is found each time:

    - the gait that the runner settles on from its start values;
    - else the gait that is reached along the friction from the unit's own;
    - else a gait from starts all over the section, a stable one if there is, which takes a second or two.

    With a target, Newton's method solves for the apex and the varied parameters at once, by exact
    derivatives, and where it fails, through targets in between. Where more parameters vary than quantities
    are prescribed, no gait nearby meets the target with a smaller change of parameters, over their values.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path, optional
        A runner; start values by the unit's names and in its units, over the unit's own; the name of a preset
        or the path of a parameter file; or a gait, whose apex then is the guess.
    target : mapping of str to float, optional
        Prescribed values, in SI units, by names of `library.quantities.QUANTITIES`, as `speed`, `frequency`
        of strides, `duty_factor`, `peak_force` of the ground across it, and `cost_of_transport`; in the full
        model also of `library.quantities.MEASURES`, as `foot_clearance`.
    vary : sequence of str
        Parameters and inputs that may change to meet the target, at least as many as prescribed quantities.
        The search begins at the runner's values.
    guess : sequence of float, shape (6,), optional
        An apex near the gait's, in the order of `library.section.COORDINATES`: m, m/s, m, rad, m/s, rad/s;
        for the reduced map the first two.
    model : str, optional
        `full`, or `reduced` for the map of an apex's height and speed, with the leg placed in flight as if by
        itself. By default that of the runner.
    progress : bool, default False
        A bar on stderr while parameters are tried that would help.
    **values : float, bool or str
        Start values over the runner's, as in `friction=0.43`, or with a unit, as in
        `touchdown_angle="40 deg"`.

    Returns
    -------
    Gait
        Apex, word, quantities of the stride, Jacobian and eigenvalues of the map. Its `runner` has the varied
        parameters; what is prescribed is met to 1e-10.

    Raises
    ------
    InputError
        A value or a name is refused, the start is not in flight, or the friction is 0; fewer parameters vary
        than quantities are prescribed, one has no effect, or several have the same effect.
    GaitNotFoundError
        No gait was found; the message says what happened on the way.
    TargetNotMetError
        No gait with this target was found: `nearest` is the nearest that was, `helps` names parameters that,
        varied too or instead of another, as the message says, meet the target or bring it nearer.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait(friction=0.2)
    >>> gait.word, gait.stable
    ('+-', True)
    >>> gait = tdmf_slip.find_gait(target={"speed": 1.0}, vary=["hip.stance_torque"])
    >>> round(gait.stride["speed"], 10)
    1.0
    """
    if isinstance(runner, Gait) and guess is None and model is None:
        guess = runner.apex
    if values:
        _check_keywords(values, model_of(runner, model))
        runner = Runner(runner, model=model, tolerance=None, **values)
    if target is None and not len(row_of(vary, "vary", NAMES)):
        return periodic_gait(runner, guess, model=model)
    wanted = checked_target(target, model_of(runner, model))
    if not wanted:
        known = choice_of_quantities(model_of(runner, model))
        raise InputError(f"target: nothing is prescribed; allowed: {known}")
    starting = Runner(runner, model=model)
    names = _checked_vary(vary, wanted, starting.model)
    check_quantities(starting, list(wanted))
    first = periodic_gait(starting, guess)
    system = GaitProblem(first.runner, names, prescribed=wanted)
    begin = iterate_at(system, system.at(first))
    _check_action(system, begin)
    iterate, share = solved_from(system, begin)
    if share < 1.0:
        others = initial_iterates(system, first)
        iterate, share, nearest = _met_from_elsewhere(system, (begin, iterate), others)
        if share < 1.0:
            helps = parameters_that_help(system, nearest, first, progress)
            raise _not_met(system, nearest, helps)
    if len(names) > len(wanted):
        iterate = least_changed(system, iterate, begin)
    return _met(system, iterate)


def _check_keywords(values: Mapping[str, Given], model: Model) -> None:
    """Refuse a keyword that is neither an argument nor a variable."""
    known = (*inspect.signature(find_gait).parameters, *model.aliases, *model.variables)
    for name in values:
        if name not in known:
            raise InputError(
                f"find_gait: {shown(name)} is neither an argument nor a variable{near_matches(name, known)}"
            )


def _met_from_elsewhere(
    target: GaitProblem, known: Sequence[Iterate], others: Iterator[Iterate]
) -> tuple[Iterate, float, Iterate]:
    """Search from gaits all over the varied parameters, and from the nearest gait that these lead to.

    Returns the point that was reached, the share of the way to the target, and the nearest point of all.
    """
    seen = [*known]
    for other in islice(others, MAX_STARTS):
        iterate, share = solved_from(target, other, LAST_STEPS)
        seen += [other, iterate]
        if share == 1.0:
            return iterate, share, iterate
    nearest = nearest_from(target, sorted(seen, key=lambda one: one.gap)[:DESCENTS])
    iterate, share = solved_from(target, nearest, LAST_STEPS)
    return iterate, share, min(nearest, iterate, key=lambda one: one.gap)


def _met(target: GaitProblem, iterate: Iterate) -> Gait:
    """The gait at a point that meets the target."""
    gait = target.gait_at(iterate.x)
    has = np.array([*quantities_of(gait, target.quantities).values()])
    if not np.all(np.abs(has - target.goal) <= MET * target.quantity_scales):
        raise RunError(
            f"the gait with {', '.join(target.quantities)} as prescribed is too sensitive to be found to "
            f"{MET:g}"
        )
    return gait


def checked_target(target: object, model: Model, from_zero: Sequence[str] = ()) -> dict[str, float]:
    """Prescribed values by the names of their quantities; those in `from_zero` may be zero."""
    given = mapping_of(target, "target", f"numbers by name: {choice_of_quantities(model)}")
    for name in given:
        checked_quantity(name, "target", model)
    if all(name in given for name in TRAVEL):
        raise InputError("target: speed, frequency and length; allowed: two of them, the third follows")
    signed = allowed_quantities(model) if model.is_page else SIGNED
    maximum, minimum = {"duty_factor": 1.0}, dict.fromkeys(signed, -MAXIMUM) | dict.fromkeys(from_zero, 0.0)
    numbers = {name: quantity_given(name, value, "target", model) for name, value in given.items()}
    return {
        name: checked(name, value, minimum.get(name, MINIMUM), maximum.get(name, MAXIMUM))
        for name, value in numbers.items()
    }


def _checked_vary(vary: object, target: Mapping[str, float], model: Model) -> tuple[str, ...]:
    """The varied parameters' names."""
    names = checked_names(vary, "vary", model)
    if len(names) < len(target):
        raise InputError(
            f"vary: {', '.join(names) or 'nothing'} for the targets {', '.join(target)}; allowed: at least "
            f"as many parameters as targets, {len(target)}"
        )
    return names


def _check_action(target: GaitProblem, iterate: Iterate) -> None:
    """Refuse parameters without an effect on the first gait, or with the same effect as others."""
    for name, column in zip(target.names, iterate.rows[:, target.count :].T, strict=True):
        if np.max(np.abs(column)) <= NO_ACTION:
            raise InputError(f"vary {name}: has no effect on this gait; choose a parameter that does")
    sizes = np.linalg.svd(iterate.rows, compute_uv=False)
    if sizes[-1] <= NO_ACTION * sizes[0]:
        raise InputError(
            f"vary {', '.join(target.names)}: have the same effect on {', '.join(target.quantities)} of this "
            "gait; allowed: parameters whose effects differ"
        )


def _not_met(target: GaitProblem, nearest: Iterate, helps: Sequence[Help]) -> TargetNotMetError:
    """The error, with the nearest gait and what would help."""
    gait = target.gait_at(nearest.x)
    has = quantities_of(gait, target.quantities)
    wanted = ", ".join(f"{n} {v:.6g}" for n, v in zip(target.quantities, target.goal, strict=True))
    near = ", ".join(f"{name} {value:.6g}" for name, value in has.items())
    runner = gait.runner
    at = ", ".join(
        f"{name} = {quantity(runner[name], runner.label(runner.model.variables[name].unit), 6)}"
        for name in target.names
    )
    tip = f"try: {'; '.join(map(str, helps[:3]))}" if helps else "varying one more parameter came no nearer"
    return TargetNotMetError(
        f"no gait with {wanted} was found by varying {', '.join(target.names)}; "
        f"the nearest one has {near}, at {at}; {tip}",
        gait,
        tuple(help.name for help in helps),
    )
