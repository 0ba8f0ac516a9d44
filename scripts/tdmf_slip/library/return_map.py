"""One stride from apex to apex, by the return map or the reduced one, with its exact derivatives.

The maps that take a runner from apex to apex, as the C library has them.

The return map is that of the full model. The reduced map places the leg in flight as if by itself, so that
the height and the speed of the centre of mass are all that an apex has.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..checks import checked
from ..errors import InputError, RunError
from ..variables.table import FRICTION, by_full_name, full_name
from ..variables.variable import Given
from .binding import c, ffi, text_of
from .members import INPUTS, PARAMETERS, check_varied, names_of
from .runner import Runner
from .section import Apex, checked_apex

PATCH = ("ground.patch_begin", "ground.patch_end")
"""Where a part of the ground with its own friction begins and ends, along the ground."""


@dataclass(frozen=True)
class Map:
    """Functions of the library for a map."""

    stride: Callable[..., Any]
    """Takes solver, system, apex, longest time, whether derivatives, seeds and how many."""
    measured_stride: Callable[..., Any]
    """The same, with what is measured along the stride."""
    settle: Callable[..., int]
    """Takes solver, system, strides and the apex, which becomes the last one; returns how many closed."""


def map_of(runner: Runner) -> Map:
    """The map that a runner goes by."""
    refuse_patch(runner)
    return _MAPS[runner.reduced]


def refuse_patch(values: Mapping[str, float]) -> None:
    """Refuse a patch of ground: an apex does not tell where the foot is."""
    begin, end = (values[name] for name in PATCH)
    if begin < end:
        raise InputError(
            f"ground.patch_end = {end:g}: gaits and maps of apices have no place for a patch of ground; "
            f"allowed: ground.patch_begin = {begin:g}, which is none; simulate, and "
            "stride_map by the full model without derivatives, take a patch"
        )


def why_no_return(stride: Any) -> str | None:
    """Reason why a stride ended, in words for a message; None where it closed."""
    if stride.outcome == c.TDMF_RETURN_CLOSED:
        return None
    if stride.outcome == c.TDMF_RETURN_UNSOLVED:
        return text_of(c.tdmf_outcome_text(stride.solver))
    return text_of(c.tdmf_return_outcome_text(stride.outcome))


_MAPS: Mapping[bool, Map] = {
    False: Map(
        stride=c.tdmf_return_map,
        measured_stride=c.tdmf_measured_return_map,
        settle=c.tdmf_settle,
    ),
    True: Map(
        stride=c.tdmf_reduced_map,
        measured_stride=c.tdmf_reduced_map,
        settle=c.tdmf_settle_reduced,
    ),
}


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
