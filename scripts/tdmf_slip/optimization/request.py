"""Checks of what is asked of an optimal runner: quantities, bounds, prescribed values."""

import numpy as np

from ..analysis.targeted import MAXIMUM, MINIMUM, NO_ACTION, TRAVEL
from ..checks import checked, is_one_of, near_matches, shown
from ..errors import InputError
from ..given import mapping_of, row_of
from ..library.members import check_varied
from ..library.quantities import QUANTITIES, quantity_given
from ..variables.table import VARIABLES, by_full_name
from .gaits import Candidate, Space

FROM_ZERO = ("slip_distance",)
"""Quantities that may be prescribed as zero."""
MAX_PARAMETERS = 12
LARGEST_RADIUS = 0.99
"""Largest spectral radius of a gait that is to be stable, where no other is given."""


def checked_quantity(name: object, what: str) -> str:
    """The name of a quantity."""
    if not is_one_of(name, QUANTITIES):
        raise InputError(
            f"{what} {shown(name)} is not allowed{near_matches(name, QUANTITIES)}; "
            f"allowed: {', '.join(QUANTITIES)}"
        )
    return str(name)


def checked_objective(minimize: str | None, maximize: str | None) -> tuple[str, float]:
    """The quantity of an objective, and its sign: 1 to minimize, -1 to maximize."""
    if (minimize is None) == (maximize is None):
        given = "neither" if minimize is None else "both"
        raise InputError(f"minimize, maximize: {given} given; allowed: one of them, {', '.join(QUANTITIES)}")
    if minimize is not None:
        return checked_quantity(minimize, "minimize"), 1.0
    return checked_quantity(maximize, "maximize"), -1.0


def checked_space(vary: object) -> Space:
    """The parameters that are varied, between bounds that the unit allows."""
    given = by_full_name(vary, "vary", "bounds (A, B) by the names of parameters and inputs")
    if not 1 <= len(given) <= MAX_PARAMETERS:
        raise InputError(
            f"vary: {len(given)} parameters; allowed: 1 to {MAX_PARAMETERS} parameters and inputs"
        )
    bounds = {}
    for name, pair in given.items():
        check_varied(name, "vary")
        where = f"vary {name}"
        bounds_given = row_of(pair, where, "two bounds, A below B")
        if len(bounds_given) != 2:
            raise InputError(f"{where} = {shown(pair)} is not allowed; allowed: two bounds, A below B")
        low, high = (float(VARIABLES[name].value_of(value, where)) for value in bounds_given)
        if not low < high:
            raise InputError(f"{where} = {low:g}:{high:g} is not allowed; allowed: A:B with A below B")
        bounds[name] = low, high
    return Space(bounds)


def checked_values(target: object, objectives: tuple[str, ...], space: Space) -> dict[str, float]:
    """The quantities that are prescribed."""
    given = mapping_of(target, "target", f"numbers by name: {', '.join(QUANTITIES)}")
    for name in given:
        checked_quantity(name, "target")
        if name in objectives:
            raise InputError(f"target {name}: is what is minimized or maximized; allowed: another quantity")
    if all(name in given for name in TRAVEL):
        raise InputError("target: speed, frequency and length; allowed: two of them, for they set the third")
    if len(given) > len(space.bounds):
        raise InputError(
            f"target: {', '.join(given)} by {', '.join(space.bounds)}; allowed: no more quantities than "
            "parameters"
        )
    maximum = {"duty_factor": 1.0}
    return {
        name: checked(
            name,
            quantity_given(name, value, "target"),
            0.0 if name in FROM_ZERO else MINIMUM,
            maximum.get(name, MAXIMUM),
        )
        for name, value in given.items()
    }


def checked_radius(stable: object) -> float | None:
    """The largest spectral radius that is asked for."""
    if isinstance(stable, bool | np.bool_):
        return LARGEST_RADIUS if stable else None
    return checked("stable", stable, 1e-3, 1.0)


def check_action(gait: Candidate, space: Space) -> None:
    """Refuse parameters that do not act on a gait."""
    for k, name in enumerate(space.bounds):
        if max(np.max(np.abs(gait.apex_slopes[:, k])), np.max(np.abs(gait.slopes[:, k]))) <= NO_ACTION:
            raise InputError(f"vary {name}: has no effect on this gait; allowed: a parameter that has one")
