"""Priors of parameters, checked."""

import math
from collections.abc import Sequence
from typing import TypeAlias

from ..checks import number_of, refusal, shown
from ..errors import InputError
from ..given import row_of
from ..library.members import check_varied
from ..variables.table import VARIABLES, by_full_name
from ..variables.variable import Given
from .unknowns import Prior

PriorGiven: TypeAlias = "tuple[Given, float] | Sequence[float]"
"""A value, also a text with its unit, and its standard error in the unit's unit."""


def checked_priors(given: object, each: Sequence[str]) -> tuple[Prior, ...]:
    """The priors of a fit."""
    priors = []
    for name, pair in by_full_name(given, "priors", "pairs of value and standard error by name").items():
        check_varied(name, "priors")
        where = f"priors {name}"
        if name in each:
            raise InputError(f"{where}: each row has its own; allowed: a parameter that all rows share")
        reported = row_of(pair, where, "a value and its standard error")
        if len(reported) != 2:
            raise InputError(
                f"{where} = {shown(pair)} is not allowed; allowed: a value and its standard error"
            )
        value = float(VARIABLES[name].value_of(reported[0], where))
        error = number_of(reported[1])
        if error is None or not 0.0 < error < math.inf:
            raise refusal(f"{where}: error", reported[1], "a standard error above 0")
        priors.append(Prior(name, value, error))
    return tuple(priors)
