"""A runner: parameters, inputs and a start, as the C library takes them."""

import difflib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from numbers import Real

import numpy as np

from ..checks import check_kind
from ..errors import InputError
from ..unit.section import apex_of
from ..unit.unit import Unit, load
from .binding import c, ffi

TOLERANCE = 1e-13
"""Relative tolerance of the native solver: the next apex is then that of a gait to 1e-11 of the scales, and
so is the gait itself, unless it is very sensitive, as near a fold."""
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

        Raises
        ------
        InputError
            Neither a runner nor a mapping, or a name or value that the unit refuses.
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

        Raises
        ------
        InputError
            The runner has no such value, or it is neither.
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

        Raises
        ------
        InputError
            A parameter is refused.
        """
        parameters = ffi.new("tdmf_parameters *")
        assign(parameters, self.values)
        model = ffi.new("tdmf_model *")
        _check(c.tdmf_model_create(model, parameters))
        return model

    @cached_property
    def inputs(self) -> object:
        """The C inputs.

        Raises
        ------
        InputError
            An input is refused.
        """
        inputs = ffi.new("tdmf_inputs *")
        assign(inputs, self.values)
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

        Raises
        ------
        InputError
            They are refused, or the foot is not above the ground.
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


def check_varied(name: object, what: str) -> None:
    """Refuse a name that a gait cannot be followed along.

    Raises
    ------
    InputError
        It is that of neither a parameter nor an input of the model.
    """
    if name not in VARIED:
        raise InputError(
            f"{what} {name!r} is not allowed; allowed: a parameter or input of the model{_near(name, VARIED)}"
        )


def _near(name: object, names: Iterable[str]) -> str:
    """A hint at names that may have been meant."""
    near = difflib.get_close_matches(str(name), names, n=3, cutoff=0.5)
    return f"; near matches: {', '.join(near)}" if near else ""


def assign(struct: object, values: Mapping[str, float]) -> None:
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
