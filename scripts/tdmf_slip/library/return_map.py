"""One stride from apex to apex, by the return map or the reduced one, with its exact derivatives."""

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..checks import checked
from ..errors import RunError
from ..variables.table import FRICTION, by_full_name, full_name
from ..variables.variable import Given
from .binding import ffi
from .maps import map_of, why_no_return
from .members import INPUTS, PARAMETERS, check_varied, names_of
from .runner import Runner
from .section import Apex, checked_apex

Along: TypeAlias = str | Mapping[str, float]
"""A direction of parameters and inputs: the name of one, or how much of each, in its unit."""
LARGEST_SHARE = 1e100
"""Largest share of a parameter in a direction."""


def stride_from(
    runner: Runner | Mapping[str, Given], apex: Apex, along: Along
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """One stride from an apex: the next apex, and how it changes."""
    runner = Runner(runner)
    map, section = map_of(runner), list(checked_apex(apex, runner.coordinates))
    stride = map.stride(runner.solver(), runner.c_system, section, np.inf, True, seed_of(along), 1)
    why_not = why_no_return(stride)
    if why_not is not None:
        raise RunError(f"no stride closes at friction {runner[FRICTION]:g}: {why_not}")
    return np.array(list(stride.apex)[: len(section)]), *derivatives(runner, stride)


def derivatives(runner: Runner, stride: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The Jacobian of a stride, and the next apex's change along the parameter asked for, else zero."""
    count = len(runner.coordinates)
    columns = [list(stride.variations[k].apex)[:count] for k in range(count + 1)]
    jacobian, by_parameter = np.array(columns[:count]).T, np.array(columns[count])
    if not (np.isfinite(jacobian).all() and np.isfinite(by_parameter).all()):
        raise RunError(
            f"at friction {runner[FRICTION]:g} a stride is on the edge of an event or of a law, where "
            "it has no derivatives"
        )
    return jacobian, by_parameter


def checked_direction(given: object) -> Along:
    """A direction by the variables' own names; refused unless it is a name, or finite numbers by name."""
    if not isinstance(given, Mapping):
        name = full_name(given)
        check_varied(name, "along")
        return str(name)
    shares = by_full_name(given, "along", "numbers by name")
    for name, share in shares.items():
        check_varied(name, "along")
        shares[name] = checked(f"along: {name}", share, -LARGEST_SHARE, LARGEST_SHARE)
    return shares


def seed_of(along: Along | None) -> Any:
    """The direction of a parameter or input, or of several, as the library's `tdmf_seed *`; NULL for none."""
    if along is None:
        nothing: Any = ffi.NULL
        return nothing
    seed: Any = ffi.new("tdmf_seed *")
    shares = along.items() if isinstance(along, Mapping) else [(along, 1.0)]
    for name, share in shares:
        check_varied(name, "along")
        layout, part = (PARAMETERS, "parameters") if name in names_of(PARAMETERS) else (INPUTS, "inputs")
        np.frombuffer(ffi.buffer(ffi.addressof(seed[0], part)), layout)[name] = share
    return seed
