"""Values in the C library's structs, by the unit's names: parameters, inputs and states."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from ..checks import is_one_of, near_matches, shown
from ..errors import GaitNotFoundError, InputError
from ..fmu.aliases import ALIASES
from ..fmu.names import by_full_name
from .binding import ffi

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


@dataclass(frozen=True)
class Member:
    """A number or a Boolean in a C struct."""

    name: str
    """The unit's name of it, as in `leg.stiffness`."""
    path: tuple[str, ...]
    """Members to go through, the last one the value itself."""
    is_flag: bool
    """It is a Boolean."""

    def write(self, struct: Any, value: float) -> None:
        """Write a value into a struct; a Boolean is 0 or 1."""
        for step in self.path[:-1]:
            struct = getattr(struct, step)
        setattr(struct, self.path[-1], bool(value) if self.is_flag else value)


def _members(struct: Any, path: tuple[str, ...] = ()) -> Iterator[Member]:
    """All numbers and Booleans of a C struct type."""
    for name, member in struct.fields:
        if member.type.kind == "struct":
            yield from _members(member.type, (*path, name))
        else:
            is_flag = member.type is ffi.typeof("bool")
            yield Member(".".join((*path, name)), (*path, name), is_flag)


PARAMETERS = tuple(_members(ffi.typeof("tdmf_parameters")))
"""Where the library's parameters are in their struct."""
INPUTS = tuple(_members(ffi.typeof("tdmf_inputs")))
"""Where its inputs are."""
VARIED = tuple(member.name for member in (*PARAMETERS, *INPUTS) if not member.is_flag)
"""Numeric parameters and inputs: those that a continuation or a derivative can vary."""
FLAGS = tuple(member.name for member in PARAMETERS if member.is_flag)
"""Boolean parameters."""
MOVING = (*VARIED, *FLAGS)
"""All parameters and inputs. A runner's motion depends on these and on its start."""


def check_varied(name: object, what: str) -> None:
    """Refuse a name that a gait cannot be followed along."""
    if not is_one_of(name, VARIED):
        raise InputError(
            f"{what} {shown(name)} is not allowed; allowed: a parameter or input of the model"
            f"{near_matches(name, (*VARIED, *ALIASES))}"
        )


def varied_alone(vary: object, allowed: str) -> tuple[str, Any]:
    """The one name that varies, and what is given of it."""
    given = by_full_name(vary, "vary", allowed)
    if len(given) != 1:
        raise InputError(f"vary: {len(given)} names; allowed: {allowed}")
    ((name, values),) = given.items()
    check_varied(name, "vary")
    return name, values


def check_has_gaits(friction: float) -> None:
    """Refuse friction 0: nothing then fixes the speed, and gaits of any speed are neighbours."""
    if friction == 0.0:
        raise InputError(
            "ground.friction = 0: nothing fixes a runner's speed, so that no gait is one of its own; "
            "allowed for gaits: above 0"
        )


def check_comes_down(values: Mapping[str, float]) -> None:
    """Refuse to search for a gait of a runner that an external force carries: it has no apex in flight."""
    push, weight = values["body.external_fy"], values["gravity"] * (values["body.mass"] + values["foot.mass"])
    if push >= weight:
        raise GaitNotFoundError(
            f"no gait: body.external_fy = {push:g} N carries the runner, which weighs {weight:g} N, so that "
            "it never comes down; allowed for gaits: less than its weight"
        )
