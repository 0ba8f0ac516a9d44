"""The maps that take a runner from apex to apex, as the C library has them.

The return map is that of the full model. The reduced map places the leg in flight as if by itself, so that
the height and the speed of the centre of mass are all that an apex has.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import InputError
from .binding import c
from .refusals import text_of
from .runner import Runner

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
