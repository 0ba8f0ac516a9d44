"""Periodic gaits as fixed points of the return map, stable or not, with their eigenvalues.

The C library does the work: one stride with its exact Jacobian, and Newton's method on it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..checks import check_kind
from ..errors import InputError, RunError
from .binding import c, ffi
from .return_map import derivatives, direction, end_text, section_of
from .runner import STATES, Runner

SETTLING_STRIDES = 400
LETTERS = {2: "0", 3: "+", 4: "-"}
"""Of the gait word, by contact mode."""
STRIDE_QUANTITIES = (
    "period",
    "length",
    "speed",
    "work",
    "positive_work",
    "cost_of_transport",
    "touchdowns",
    "stance_time",
    "duty_factor",
    "slip_distance",
    "peak_force",
)
LOSSES = ("damper_loss", "friction_loss", "impact_loss")


@dataclass(frozen=True)
class Event:
    """An event within a stride."""

    time: float
    guard: int
    contact_before: int
    contact_after: int
    state: tuple[float, ...]


@dataclass(frozen=True)
class Orbit:
    """A periodic gait and its stride; units as in the model description."""

    runner: Runner
    apex: np.ndarray
    """Section, in the order of `section.COORDINATES`."""
    word: str
    liftoff_angle: float
    stride: Mapping[str, float]
    """By the names in `STRIDE_QUANTITIES` and `LOSSES`."""
    jacobian: np.ndarray
    """Of the return map; [i, k] is the change of coordinate i by coordinate k."""
    along: str | None
    """The parameter or input by which the next apex is differentiated, too; None: by none."""
    by_parameter: np.ndarray | None
    """Change of the next apex along it; None where none was asked for."""
    error: float
    """What is left of apex minus next apex, over the coordinates' scales."""
    iterations: int
    events: tuple[Event, ...] = field(repr=False)

    @property
    def friction(self) -> float:
        """Of the ground."""
        return self.runner.values["ground.friction"]

    @property
    def period(self) -> float:
        """Of the stride."""
        return self.stride["period"]

    @cached_property
    def start_values(self) -> dict[str, float]:
        """Everything a run of the unit needs to begin at this gait's apex."""
        state = ffi.new("double[]", c.TDMF_STATE_COUNT)
        c.tdmf_section_state(self.runner.model, ffi.new("double[6]", list(self.apex)), state)
        return {**self.runner.values, **dict(zip(STATES, state, strict=False))}

    @cached_property
    def eigenvalues(self) -> np.ndarray:
        """Of the Jacobian, the largest first."""
        found = np.linalg.eigvals(self.jacobian)
        return found[np.argsort(-np.abs(found), kind="stable")]

    @property
    def stable(self) -> bool:
        """All eigenvalues are inside the unit circle."""
        return bool(abs(self.eigenvalues[0]) < 1.0)

    @cached_property
    def letters(self) -> tuple[tuple[str, float], ...]:
        """Letters of the word with how long each mode lasts; graze and flight add none."""
        found: list[tuple[str, float]] = []
        flown = True
        for event, following in zip(self.events, self.events[1:], strict=False):
            letter = LETTERS.get(event.contact_after)
            flown = flown or event.contact_after == 1
            if letter is None:
                continue
            duration = following.time - event.time
            if found and found[-1][0] == letter and not flown:
                found[-1] = letter, found[-1][1] + duration
            else:
                found.append((letter, duration))
            flown = False
        return tuple(found)

    def as_json(self) -> dict[str, object]:
        """The gait as a plain object, eigenvalues as [re, im], start values for a run that begins on it."""
        names = ("period", "length", "speed", "work", "cost_of_transport")
        return {
            "friction": self.friction,
            "word": self.word,
            **{name: self.stride[name] for name in names},
            "liftoff_angle": self.liftoff_angle,
            "apex": [float(value) for value in self.apex],
            "eigenvalues": [[float(v.real), float(v.imag)] for v in self.eigenvalues.astype(complex)],
            "stable": self.stable,
            "start_values": self.start_values,
        }


def check_orbit(given: object, what: str) -> None:
    """Refuse what is no gait of the return map.

    Raises
    ------
    InputError
        It is something else.
    """
    check_kind(given, Orbit, what, "an Orbit, as find_orbit gives")


def check_has_gaits(friction: float) -> None:
    """Refuse friction 0: nothing then fixes the speed, and gaits of any speed are neighbours.

    Raises
    ------
    InputError
        It is 0.
    """
    if friction == 0.0:
        raise InputError(
            "ground.friction = 0: nothing fixes a runner's speed, so that no gait is one of its own; "
            "allowed for gaits: above 0"
        )


def find_orbit(
    runner: Runner | Mapping[str, object],
    guess: Sequence[float] | None = None,
    *,
    along: str | None = None,
) -> Orbit:
    """The periodic gait near a guess, by Newton's method.

    Parameters
    ----------
    runner : Runner or mapping of str to object
        Whose gait; start values stand for the runner that they make.
    guess : Sequence[float], optional
        An apex near the gait's; without one the runner runs from its start values first, to settle.
    along : str, optional
        A parameter or input by which the next apex is differentiated, too.

    Raises
    ------
    InputError
        The guess is no apex, the start values are not in flight, `along` is unknown, or the friction is 0.
    RunError
        The runner falls, no gait is near, the solver does not get through a stride, or the gait has no
        derivatives.
    """
    runner = Runner.of(runner)
    check_has_gaits(runner.values["ground.friction"])
    log = ffi.new("tdmf_event_log *")
    solver = runner.solver(log)
    section = section_of(runner.start_apex() if guess is None else guess)
    ran = SETTLING_STRIDES
    if guess is None:
        ran = c.tdmf_settle(solver, runner.model, runner.inputs, SETTLING_STRIDES, section)
    found = c.tdmf_find_orbit(solver, runner.model, runner.inputs, section, direction(along))
    if found.outcome != c.TDMF_ORBIT_FOUND:
        raise RunError(_why_not(runner, found, ran))
    log.count = 0
    c.tdmf_return_map(solver, runner.model, runner.inputs, found.section, np.inf, False, ffi.NULL, 0)
    return _orbit(runner, found, log, along)


def _why_not(runner: Runner, found: object, ran: int) -> str:
    where = f"no gait at friction {runner.values['ground.friction']:g}"
    if found.outcome != c.TDMF_ORBIT_NOT_FOUND:
        why = end_text(found.stride)
        settling = ran < SETTLING_STRIDES
        return f"{where}: " + (
            f"{why}, after {ran} strides" if settling else f"from the apex that was tried, {why}"
        )
    return (
        f"{where}: Newton's method stopped after {found.iterations} iterations "
        f"with the next apex {found.error:.2g} of its scales away"
    )


def _orbit(runner: Runner, found: object, log: object, along: str | None) -> Orbit:
    stride = found.stride
    jacobian, by_parameter = derivatives(runner, stride)
    quantities = {name: float(getattr(stride.stride, name)) for name in STRIDE_QUANTITIES}
    events = tuple(
        Event(e.time, e.guard, e.before.contact, e.after.contact, tuple(e.state))
        for e in log.events[0 : min(log.count, c.TDMF_EVENT_CAPACITY)]
    )
    return Orbit(
        runner=runner,
        apex=np.array(list(found.section)),
        word=ffi.string(stride.stride.word).decode(),
        liftoff_angle=stride.liftoff_angle,
        stride=quantities | {name: float(getattr(stride, name)) for name in LOSSES},
        jacobian=jacobian,
        along=along,
        by_parameter=None if along is None else by_parameter,
        error=found.error,
        iterations=found.iterations,
        events=events,
    )
