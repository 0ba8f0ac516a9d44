"""Periodic gaits as fixed points of the return map, stable or not, with their eigenvalues.

The C library does the work: one stride with its exact Jacobian, and Newton's method on it.
"""

import difflib
import reprlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from numbers import Real

import numpy as np

from .errors import InputError, RunError, check_kind
from .library import c, ffi
from .section import COORDINATES, apex_of
from .unit import Unit, load

TOLERANCE = 1e-13
"""Relative tolerance of the native solver: the next apex is then that of a gait to 1e-11 of the scales, and
so is the gait itself, unless it is very sensitive, as near a fold."""
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
STATES = (
    "foot.x",
    "foot.y",
    "leg.length",
    "leg.angle",
    "foot.vx",
    "foot.vy",
    "leg.length_rate",
    "leg.angle_rate",
)
"""The mechanical states in the library's order."""
LOSSES = ("damper_loss", "friction_loss", "impact_loss")


def _members(struct: object, group: str = "") -> Iterator[str]:
    """Paths of the numbers in a C struct, which are the unit's names."""
    for name, member in struct.fields:
        if member.type.kind == "struct":
            yield from _members(member.type, f"{group}{name}.")
        else:
            yield group + name


VARIED = (*_members(ffi.typeof("tdmf_parameters")), *_members(ffi.typeof("tdmf_inputs")))
"""Parameters and inputs: what a runner's motion depends on, beside its start."""


@dataclass(frozen=True)
class Runner:
    """Parameters, inputs and a start, as the C library takes them.

    Values are in the unit's units, by the unit's names: `leg.stiffness`, `ground.friction`, `foot.y`.
    """

    values: Mapping[str, float]
    relative_tolerance: float = TOLERANCE

    def __post_init__(self) -> None:
        """Refuse values that are not all there."""
        check_kind(self.values, Mapping, "values", "numbers by the unit's names")
        missing = next((name for name in (*VARIED, *STATES) if name not in self.values), None)
        if missing is not None:
            raise InputError(f"values: {missing} is missing; allowed: all of them, as Runner.of gives them")

    @classmethod
    def of(cls, given: "Runner | Mapping[str, object] | None" = None, unit: Unit | None = None) -> "Runner":
        """The unit's own start values, and over them those given; a runner is given back as it is.

        What concerns runs of the unit only, as `solver.method` does, is left out.

        Raises:
            InputError: neither a runner nor a mapping, or a name or value that the unit refuses.
        """
        if isinstance(given, cls):
            return given
        check_kind(given or {}, Mapping, "runner", "a Runner, or start values by name")
        unit = load(unit)
        checked = unit.start_values(given or {}, "start values")
        names = [n for n, v in unit.variables.items() if v.settable and v.type == "Real"]
        return cls({name: float(checked.get(name, unit.start_of(name))) for name in names})

    def but(self, name: str, value: float | str) -> "Runner":
        """The same runner with another value, a number or a text like `40 deg`.

        Raises:
            InputError: the runner has no such value, or it is neither.
        """
        if name not in self.values:
            raise InputError(f"{name!r} is not a name in the runner's values{_near(name, self.values)}")
        if not isinstance(value, Real):
            value = load().find(name, "runner").value_of(value, "runner")
        return replace(self, values={**self.values, name: float(value)})

    def __reduce__(self) -> tuple:
        """Without what the C library has made of it, which is of use in this process only."""
        return type(self), (dict(self.values), self.relative_tolerance)

    @cached_property
    def model(self) -> object:
        """The C model of the parameters.

        Raises:
            InputError: a parameter is refused.
        """
        parameters = ffi.new("tdmf_parameters *")
        _assign(parameters, self.values)
        model = ffi.new("tdmf_model *")
        _check(c.tdmf_model_create(model, parameters))
        return model

    @cached_property
    def inputs(self) -> object:
        """The C inputs.

        Raises:
            InputError: an input is refused.
        """
        inputs = ffi.new("tdmf_inputs *")
        _assign(inputs, self.values)
        _check(c.tdmf_check_inputs(inputs))
        return inputs

    @cached_property
    def scales(self) -> np.ndarray:
        """Scales of the section's coordinates."""
        scales = ffi.new("double[6]")
        c.tdmf_section_scales(self.model, scales)
        return np.array(list(scales))

    def solver(self, log: object = ffi.NULL) -> object:
        """A native solver, noting its events in `log`."""
        solver = ffi.new("tdmf_solver *", c.tdmf_solver_default())
        if not isinstance(self.relative_tolerance, Real) or not 0 < self.relative_tolerance < 1:
            raise InputError(
                f"relative_tolerance = {self.relative_tolerance!r} is not allowed; allowed: above 0, below 1"
            )
        solver.relative_tolerance = self.relative_tolerance
        solver.log = log
        return solver

    def start_apex(self) -> np.ndarray:
        """The section at the start values; a vertical velocity, which other masses make, is left out.

        Raises:
            InputError: they are refused, or the foot is not above the ground.
        """
        section = apex_of(self.values)
        motion = ffi.new("tdmf_motion *")
        c.tdmf_section_state(self.model, ffi.new("double[6]", section), motion.state)
        mode, record = ffi.addressof(motion.mode), ffi.addressof(motion.record)
        _check(c.tdmf_start(self.model, self.inputs, 0.0, motion.state, mode, record))
        if not motion.record.open.began_at_apex:
            raise InputError(
                f"start values: foot.y = {self.values['foot.y']:g}: the search for a gait begins in flight; "
                "allowed: above 0"
            )
        return np.array(section)


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

    Raises:
        InputError: it is something else.
    """
    check_kind(given, Orbit, what, "an Orbit, as find_orbit gives")


def check_varied(name: object, what: str) -> None:
    """Refuse a name that a gait cannot be followed along.

    Raises:
        InputError: it is that of neither a parameter nor an input of the model.
    """
    if name not in VARIED:
        raise InputError(
            f"{what} {name!r} is not allowed; allowed: a parameter or input of the model{_near(name, VARIED)}"
        )


def _near(name: object, names: Iterable[str]) -> str:
    """A hint at names that may have been meant."""
    near = difflib.get_close_matches(str(name), names, n=3, cutoff=0.5)
    return f"; near matches: {', '.join(near)}" if near else ""


def check_has_gaits(friction: float) -> None:
    """Refuse friction 0: nothing then fixes the speed, and gaits of any speed are neighbours.

    Raises:
        InputError: it is 0.
    """
    if friction == 0.0:
        raise InputError(
            "ground.friction = 0: nothing fixes a runner's speed, so that no gait is one of its own; "
            "allowed for gaits: above 0"
        )


def _section(apex: Sequence[float]) -> object:
    if np.shape(apex) != (len(COORDINATES),):
        raise InputError(f"an apex of shape {np.shape(apex)}: allowed: {', '.join(COORDINATES)}")
    try:
        return ffi.new("double[6]", [float(value) for value in apex])
    except (TypeError, ValueError):
        raise InputError(f"an apex {reprlib.repr(apex)}: allowed: six numbers") from None


def find_orbit(
    runner: Runner | Mapping[str, object],
    guess: Sequence[float] | None = None,
    *,
    along: str | None = None,
) -> Orbit:
    """The periodic gait near a guess, by Newton's method.

    Args:
        runner: whose gait; start values stand for the runner that they make.
        guess: an apex near the gait's; without one the runner runs from its start values first, to settle.
        along: a parameter or input by which the next apex is differentiated, too.

    Raises:
        InputError: the guess is no apex, the start values are not in flight, `along` is unknown, or the
            friction is 0.
        RunError: the runner falls, no gait is near, the solver does not get through a stride, or the gait has
            no derivatives.
    """
    runner = Runner.of(runner)
    check_has_gaits(runner.values["ground.friction"])
    log = ffi.new("tdmf_event_log *")
    solver = runner.solver(log)
    section = _section(runner.start_apex() if guess is None else guess)
    ran = SETTLING_STRIDES
    if guess is None:
        ran = c.tdmf_settle(solver, runner.model, runner.inputs, SETTLING_STRIDES, section)
    found = c.tdmf_find_orbit(solver, runner.model, runner.inputs, section, _change(along))
    if found.outcome != c.TDMF_ORBIT_FOUND:
        raise RunError(_why_not(runner, found, ran))
    log.count = 0
    c.tdmf_return_map(solver, runner.model, runner.inputs, found.section, np.inf, False, ffi.NULL, 0)
    return _orbit(runner, found, log, along)


def stride_from(
    runner: Runner | Mapping[str, object], apex: Sequence[float], along: str
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """One stride from an apex: the next apex, the Jacobian, and the next apex's change along a parameter.

    Raises:
        RunError: no stride closes from there, or it has no derivatives.
    """
    runner, section = Runner.of(runner), _section(apex)
    stride = c.tdmf_return_map(
        runner.solver(), runner.model, runner.inputs, section, np.inf, True, _change(along), 1
    )
    if not stride.outcome.closed:
        friction = runner.values["ground.friction"]
        raise RunError(f"no stride closes at friction {friction:g}: {_end_text(stride)}")
    return np.array(list(stride.apex)), *_derivatives(runner, stride)


def _derivatives(runner: Runner, stride: object) -> tuple[np.ndarray, np.ndarray]:
    """The Jacobian, and the next apex's change along the parameter asked for, else zero."""
    jacobian = np.array([list(stride.by_section[k].apex) for k in range(len(COORDINATES))]).T
    by_parameter = np.array(list(stride.by_parameter[0].apex))
    if not (np.isfinite(jacobian).all() and np.isfinite(by_parameter).all()):
        raise RunError(
            f"at friction {runner.values['ground.friction']:g} a stride is on the edge of an event or of a "
            "law, where it has no derivatives"
        )
    return jacobian, by_parameter


def _change(along: str | None) -> object:
    """The unit direction of a parameter or input."""
    if along is None:
        return ffi.NULL
    check_varied(along, "along")
    change = ffi.new("tdmf_change *")
    _assign(change.parameters, {along: 1.0})
    _assign(change.inputs, {along: 1.0})
    return change


def _why_not(runner: Runner, found: object, ran: int) -> str:
    where = f"no gait at friction {runner.values['ground.friction']:g}"
    if found.outcome != c.TDMF_ORBIT_NOT_FOUND:
        why = _end_text(found.stride)
        settling = ran < SETTLING_STRIDES
        return f"{where}: " + (
            f"{why}, after {ran} strides" if settling else f"from the apex that was tried, {why}"
        )
    return (
        f"{where}: Newton's method stopped after {found.iterations} iterations "
        f"with the next apex {found.error:.2g} of its scales away"
    )


def _end_text(stride: object) -> str:
    """What ended a stride that has not closed: a fall, or what the solver met."""
    if not stride.began_at_apex:
        return "there is no apex above the ground"
    if stride.outcome.outcome == c.TDMF_ARRIVED:
        return "no stride closes in the time that it may take"
    return ffi.string(c.tdmf_outcome_text(stride.outcome.outcome)).decode()


def _orbit(runner: Runner, found: object, log: object, along: str | None) -> Orbit:
    stride = found.stride
    jacobian, by_parameter = _derivatives(runner, stride)
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


def _assign(struct: object, values: Mapping[str, float]) -> None:
    """Write values into the members of a struct whose paths are their names; others are left out."""
    for name, value in values.items():
        owner, (*path, member) = struct, name.split(".")
        for step in path:
            owner = getattr(owner, step, None)
        if hasattr(owner, member):
            setattr(owner, member, value)


def _check(refusal: object) -> None:
    if refusal.variable != ffi.NULL:
        text = ffi.new("char[256]")
        c.tdmf_refusal_text(ffi.new("tdmf_refusal *", refusal), text, len(text))
        raise InputError(ffi.string(text).decode())
