"""The maps that take a runner from apex to apex, as the C library has them.

The return map is that of the full model. The reduced map places the leg in flight as if by itself, so that
the height and the speed of the centre of mass are all that an apex has.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..unit.unit import FRICTION
from .binding import c, ffi
from .runner import Runner, text_of
from .structs import FoundGait, Return, Struct


@dataclass(frozen=True)
class Map:
    """What the library has for a map."""

    stride: Callable[..., Return]
    """Of solver, model, inputs, apex, longest time, whether derivatives, changes and how many."""
    measured_stride: Callable[..., Return]
    """The same, with what is measured along the stride."""
    settle: Callable[..., int]
    """Of solver, model, inputs, strides and the apex, which becomes the last one: how many closed."""
    find: Callable[..., FoundGait]
    """Of solver, model, inputs, a guess, and a change or NULL: the fixed point near the guess."""
    fixed_point: Callable[[FoundGait], Sequence[float]]
    """Its coordinates."""
    why_not: Callable[[Return], str | None]
    """Of a stride: what ended it, in words to follow in a message; None where it closed."""


def map_of(runner: Runner) -> Map:
    """The map that a runner goes by.

    Parameters
    ----------
    runner : Runner
        Which runner.

    Returns
    -------
    Map
        The return map, or the reduced one.
    """
    return _MAPS[runner.reduced]


def why_no_gait(runner: Runner, found: FoundGait, settling: bool, ran: int) -> str:
    """Why a search found no gait, in words.

    Parameters
    ----------
    runner : Runner
        Whose gait.
    found : FoundGait
        How the search ended.
    settling : bool
        It ended before the runner had settled.
    ran : int
        After so many strides.

    Returns
    -------
    str
        For a message.
    """
    where = f"no gait at friction {runner.values[FRICTION]:g}"
    if found.outcome != c.TDMF_ORBIT_NOT_FOUND:
        why = map_of(runner).why_not(found.stride)
        return f"{where}: " + (
            f"{why}, after {ran} strides" if settling else f"from the apex that was tried, {why}"
        )
    return (
        f"{where}: Newton's method stopped after {found.iterations} iterations "
        f"with the next apex {found.error:.2g} of its scales away"
    )


def _why_no_return(stride: Any) -> str | None:
    if stride.outcome.closed:
        return None
    if not stride.began_at_apex:
        return "there is no apex above the ground"
    if stride.outcome.outcome == c.TDMF_ARRIVED:
        return "no stride closes in the time that it may take"
    return text_of(c.tdmf_outcome_text(stride.outcome.outcome))


def _why_not_reduced(stride: Any) -> str | None:
    if stride.outcome == c.TDMF_REDUCED_CLOSED:
        return None
    unsolved = stride.outcome == c.TDMF_REDUCED_UNSOLVED
    return text_of(
        c.tdmf_outcome_text(stride.solver) if unsolved else c.tdmf_reduced_outcome_text(stride.outcome)
    )


def _find_reduced(solver: Struct, model: Struct, inputs: Struct, guess: Any, change: Struct) -> FoundGait:
    found: FoundGait = c.tdmf_find_reduced_orbit(
        solver, model, inputs, guess, change, int(change != ffi.NULL)
    )
    return found


_MAPS: Mapping[bool, Map] = {
    False: Map(
        stride=c.tdmf_return_map,
        measured_stride=c.tdmf_measured_return_map,
        settle=c.tdmf_settle,
        find=c.tdmf_find_orbit,
        fixed_point=lambda found: found.section,
        why_not=_why_no_return,
    ),
    True: Map(
        stride=c.tdmf_reduced_map,
        measured_stride=c.tdmf_reduced_map,
        settle=c.tdmf_settle_reduced,
        find=_find_reduced,
        fixed_point=lambda found: found.apex,
        why_not=_why_not_reduced,
    ),
}
