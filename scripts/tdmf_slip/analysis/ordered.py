"""Gaits to order: the gait of a given speed, step frequency or the like, by freeing as many parameters."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice

import numpy as np

from ..checks import checked, is_one_of, near_matches, shown
from ..errors import InputError, RunError
from ..given import mapping_of, row_of
from ..library.members import check_varied
from ..library.orbit import Orbit
from ..library.quantities import QUANTITIES, SIGNED, check_quantities, quantities_of
from ..library.runner import Runner
from ..library.section import Apex
from ..unit.unit import Unit, load
from ..unit.variable import Given
from .beginnings import beginnings
from .nearest import Help, nearest_from, parameters_that_help
from .order import Order, Place
from .search import find_orbit, runner_by

TRAVEL = ("speed", "frequency", "length")
"""Any two of them set the third."""
LEAST, MOST = 1e-9, 1e9
"""Of what is ordered, in SI units."""
MET = 1e-10
"""Of what is ordered."""
LAST_STEPS = 10
"""From the nearest gait towards the order, and from each of the others."""
MOST_BEGINNINGS = 8
"""Other gaits that a search begins from."""
DESCENTS = 2
"""Of these, so many of the nearest lead on to the gait that is nearest of all."""
NO_ACTION = 1e-11
"""Changes over the scales that are no more than rounding."""


class OrderNotMetError(RunError):
    """No gait was found that has what is ordered."""

    def __init__(self, message: str, nearest: Orbit, helps: tuple[str, ...]) -> None:
        """With the gait that is nearest to the order, and the parameters that would bring it nearer."""
        super().__init__(message)
        self.nearest, self.helps = nearest, helps

    def __reduce__(self) -> tuple[type["OrderNotMetError"], tuple[str, Orbit, tuple[str, ...]]]:
        """As it was made."""
        return type(self), (str(self), self.nearest, self.helps)


def find_gait(
    runner: Runner | Mapping[str, Given] | None,
    order: Mapping[str, float],
    free: Sequence[str],
    *,
    guess: Apex | None = None,
    model: str | None = None,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> Orbit:
    """The periodic gait that has what is ordered, by freeing as many parameters or more.

    Newton's method on apex and freed parameters at once, from the gait that `find_orbit` gives; where it
    fails, through orders in between. Derivatives are exact. Where more parameters are freed than are ordered,
    each step is the shortest one, over their values.

    Parameters
    ----------
    runner : Runner or mapping of str to float, optional
        Whose gait: a runner, or start values by the unit's names and in its units, over the unit's own. Freed
        parameters begin with the values that they have here.
    order : mapping of str to float
        What the gait is to have, by names of `library.quantities.QUANTITIES`: `speed` in m/s, `frequency` of
        strides in Hz, `length` of a stride in m, `stance_time` in s, `duty_factor`, `slip_distance` of the
        foot in m, `peak_force` of the ground across it and `peak_vertical_force` in N, `cost_of_transport`;
        in the full model also those of `library.measures.MEASURE_UNITS`, as `foot_clearance`.
    free : sequence of str
        Names of parameters and inputs to be found, as many as are ordered or more.
    guess : sequence of float, optional
        An apex near that of the gait to begin with; see `find_orbit`.
    model : str, optional
        `full` or `reduced`, as in `find_orbit`.
    show_progress : bool, default False
        A bar on stderr while parameters are tried that would help.
    unit : Unit, optional
        Whose start values hold; by default that of `fmu_path`.

    Returns
    -------
    Orbit
        Stable or not; the freed parameters are in its `runner.values`. What is ordered is met to 1e-10.

    Raises
    ------
    InputError
        Nothing is ordered, or what is not allowed; a name is unknown; fewer parameters are freed; one does
        not act, or they cannot be told from each other.
    OrderNotMetError
        No such gait was found: `nearest` is the nearest that was, `helps` names parameters that, freed too
        or instead of another, as the message says, meet the order or bring it nearer.
    RunError
        There is no gait to begin with.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6}, {"speed": 1.0}, ["hip.stance_torque"])
    >>> round(gait.stride["speed"], 10)
    1.0
    """
    wanted = _checked_order(order)
    names = _checked_free(free, wanted)
    starting = runner_by(Runner.of(runner, unit), model)
    check_quantities(starting, list(wanted))
    first = find_orbit(starting, guess, unit=unit)
    system = Order(first.runner, wanted, names)
    begin = system.place_of(first)
    _check_action(system, begin)
    place, share = system.solved_from(begin)
    if share < 1.0:
        others = beginnings(system, first, load(unit))
        place, share, nearest = _met_from_elsewhere(system, (begin, place), others)
        if share < 1.0:
            helps = parameters_that_help(system, nearest, first, show_progress)
            raise _not_met(system, nearest, helps, load(unit))
    return _met(system, place)


def _met_from_elsewhere(
    order: Order, known: Sequence[Place], others: Iterator[Place]
) -> tuple[Place, float, Place]:
    """From gaits all over the freed parameters, and from the nearest one that the nearest of them lead to.

    The place that was come to, the share of the way to the order, and the nearest of all that were seen.
    """
    seen = [*known]
    for other in islice(others, MOST_BEGINNINGS):
        place, share = order.solved_from(other, LAST_STEPS)
        seen += [other, place]
        if share == 1.0:
            return place, share, place
    nearest = nearest_from(order, sorted(seen, key=order.gap)[:DESCENTS])
    place, share = order.solved_from(nearest, LAST_STEPS)
    return place, share, min(nearest, place, key=order.gap)


def _met(order: Order, place: Place) -> Orbit:
    """The gait at a place that meets the order.

    Raises
    ------
    RunError
        It is so sensitive that its own Newton's method leads elsewhere.
    """
    orbit = order.orbit(place)
    has = np.array([*quantities_of(orbit, order.names).values()])
    if not np.all(np.abs(has - order.ordered) <= MET * order.quantity_scales):
        raise RunError(
            f"the gait with {', '.join(order.names)} as ordered is too sensitive to be found to {MET:g}"
        )
    return orbit


def _checked_order(order: object) -> dict[str, float]:
    """What is ordered, by its names."""
    given = mapping_of(order, "order", f"numbers by name: {', '.join(QUANTITIES)}")
    if not given:
        raise InputError(f"order: nothing is ordered; allowed: {', '.join(QUANTITIES)}")
    for name in given:
        if not is_one_of(name, QUANTITIES):
            raise InputError(
                f"order {shown(name)} is not allowed; allowed: {', '.join(QUANTITIES)}"
                f"{near_matches(name, QUANTITIES)}"
            )
    if all(name in given for name in TRAVEL):
        raise InputError("order: speed, frequency and length; allowed: two of them, for they set the third")
    most, least = {"duty_factor": 1.0}, dict.fromkeys(SIGNED, -MOST)
    return {
        name: checked(name, value, least.get(name, LEAST), most.get(name, MOST))
        for name, value in given.items()
    }


def _checked_free(free: object, order: Mapping[str, float]) -> tuple[str, ...]:
    """The freed parameters' names."""
    names = tuple(row_of(free, "free", "a list of names of parameters and inputs"))
    for name in names:
        check_varied(name, "free")
        if names.count(name) > 1:
            raise InputError(f"free: {name} is given twice; allowed: once")
    if len(names) < len(order):
        raise InputError(
            f"free: {', '.join(names) or 'nothing'} for {', '.join(order)}; allowed: at least as many "
            f"parameters as are ordered, {len(order)}"
        )
    return names


def _check_action(order: Order, place: Place) -> None:
    """Refuse parameters that do not act on the first gait, or not each in a way of its own."""
    count = len(order.closing(place))
    rows = order.rows(place)
    for name, column in zip(order.free, rows[:, count:].T, strict=True):
        if np.max(np.abs(column)) <= NO_ACTION:
            raise InputError(f"free {name}: does not act on this gait; allowed: a parameter that changes it")
    sizes = np.linalg.svd(rows, compute_uv=False)
    if sizes[-1] <= NO_ACTION * sizes[0]:
        raise InputError(
            f"free {', '.join(order.free)}: do not change {', '.join(order.names)} of this gait each in its "
            "own way; allowed: parameters that do"
        )


def _not_met(order: Order, nearest: Place, helps: Sequence[Help], unit: Unit) -> OrderNotMetError:
    """With the nearest gait, and what would help."""
    orbit = order.orbit(nearest)
    has = quantities_of(orbit, order.names)
    wanted = ", ".join(f"{n} {v:.6g}" for n, v in zip(order.names, order.ordered, strict=True))
    near = ", ".join(f"{name} {value:.6g}" for name, value in has.items())
    at = ", ".join(
        f"{name} = {orbit.runner.values[name]:.6g} {unit.variables[name].unit}".removesuffix(" 1").strip()
        for name in order.free
    )
    tip = (
        f"freeing {', '.join(map(str, helps[:3]))}"
        if helps
        else "no single further parameter that was tried helps"
    )
    return OrderNotMetError(
        f"no gait with {wanted} was found by {', '.join(order.free)}: the nearest has {near}, at {at}; {tip}",
        orbit,
        tuple(help.name for help in helps),
    )
