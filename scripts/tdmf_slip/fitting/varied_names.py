"""Names of what a fit is asked to vary, shared by all rows or for each of them: checked."""

from collections.abc import Sequence

import numpy as np

from ..checks import is_one_of, shown
from ..errors import InputError
from ..library.members import check_varied
from ..variables.table import full_names
from .measurements import Measurements


def profiled_names(profile: object, names: Sequence[str]) -> tuple[str, ...]:
    """Names of the parameters whose intervals are by the profile likelihood."""
    if isinstance(profile, bool | np.bool_):
        return tuple(names) if profile else ()
    chosen = full_names(profile, "profile", "True, False, or a list of names of varied parameters")
    for name in chosen:
        if not is_one_of(name, names):
            raise InputError(f"profile: {shown(name)} does not vary; allowed: {', '.join(names)}")
    return chosen


def checked_names(given: object, what: str) -> tuple[str, ...]:
    """Names of parameters, each once."""
    names = full_names(given, what, "a list of names of parameters and inputs")
    for name in names:
        check_varied(name, what)
        if names.count(name) > 1:
            raise InputError(f"{what}: {name} is given twice; allowed: once")
    return names


def check_names(shared: Sequence[str], each: Sequence[str], measurements: Measurements, priors: int) -> None:
    """Refuse names that are shared and not, and more of them than data."""
    both = next((name for name in shared if name in each), None)
    if both is not None:
        raise InputError(f"vary and vary_each: {both} is in both; allowed: in one of them")
    rows = len(measurements.rows)
    wanted = len(shared) + rows * len(each)
    if not wanted:
        raise InputError("vary: nothing varies; allowed: one parameter or more, shared or for each row")
    if wanted > measurements.count + priors:
        many = f" and {len(each)} for each of {rows} rows" if each else ""
        raise InputError(
            f"vary: {wanted} parameters ({len(shared)} shared{many}), but {measurements.where} has "
            f"{measurements.count} measured; allowed: no more than are measured"
        )
