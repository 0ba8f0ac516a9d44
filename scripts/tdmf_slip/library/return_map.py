"""The return map: one stride from apex to apex, with its exact derivatives."""

import reprlib
from collections.abc import Mapping, Sequence

import numpy as np

from ..errors import InputError, RunError
from ..unit.section import COORDINATES
from .binding import c, ffi
from .runner import Runner, assign, check_varied


def stride_from(
    runner: Runner | Mapping[str, object], apex: Sequence[float], along: str
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """One stride from an apex: the next apex, the Jacobian, and the next apex's change along a parameter.

    Raises
    ------
    RunError
        No stride closes from there, or it has no derivatives.
    """
    runner, section = Runner.of(runner), section_of(apex)
    stride = c.tdmf_return_map(
        runner.solver(), runner.model, runner.inputs, section, np.inf, True, direction(along), 1
    )
    if not stride.outcome.closed:
        friction = runner.values["ground.friction"]
        raise RunError(f"no stride closes at friction {friction:g}: {end_text(stride)}")
    return np.array(list(stride.apex)), *derivatives(runner, stride)


def derivatives(runner: Runner, stride: object) -> tuple[np.ndarray, np.ndarray]:
    """The Jacobian, and the next apex's change along the parameter asked for, else zero."""
    jacobian = np.array([list(stride.by_section[k].apex) for k in range(len(COORDINATES))]).T
    by_parameter = np.array(list(stride.by_parameter[0].apex))
    if not (np.isfinite(jacobian).all() and np.isfinite(by_parameter).all()):
        raise RunError(
            f"at friction {runner.values['ground.friction']:g} a stride is on the edge of an event or of a "
            "law, where it has no derivatives"
        )
    return jacobian, by_parameter


def direction(along: str | None) -> object:
    """The unit direction of a parameter or input."""
    if along is None:
        return ffi.NULL
    check_varied(along, "along")
    change = ffi.new("tdmf_change *")
    assign(change.parameters, {along: 1.0})
    assign(change.inputs, {along: 1.0})
    return change


def end_text(stride: object) -> str:
    """What ended a stride that has not closed: a fall, or what the solver met."""
    if not stride.began_at_apex:
        return "there is no apex above the ground"
    if stride.outcome.outcome == c.TDMF_ARRIVED:
        return "no stride closes in the time that it may take"
    return ffi.string(c.tdmf_outcome_text(stride.outcome.outcome)).decode()


def section_of(apex: Sequence[float]) -> object:
    """An apex as the C library takes it.

    Raises
    ------
    InputError
        It is not one.
    """
    if np.shape(apex) != (len(COORDINATES),):
        raise InputError(f"an apex of shape {np.shape(apex)}: allowed: {', '.join(COORDINATES)}")
    try:
        return ffi.new("double[6]", [float(value) for value in apex])
    except (TypeError, ValueError):
        raise InputError(f"an apex {reprlib.repr(apex)}: allowed: six numbers") from None
