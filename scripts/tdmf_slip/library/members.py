"""Values in the C library's structs, by the unit's names: parameters and inputs."""

from collections.abc import Container, Iterator, Mapping
from typing import Any, TypeAlias

import numpy as np

from ..checks import check_names, check_once, refusal
from ..errors import GaitNotFoundError, InputError, counted
from ..given import row_of
from ..variables.table import FRICTION, MODELS, Model, by_full_name, full_names
from .binding import ffi

Along: TypeAlias = str | Mapping[str, float]
"""A direction of parameters and inputs: the name of one, or how much of each, in its unit."""
PUSH = "body.external_fy"
"""Name of the vertical force that may carry a runner."""


def _members(struct: Any, prefix: str = "", begin: int = 0) -> Iterator[tuple[str, str, int]]:
    """Name, format and offset of all numbers and Booleans of a C struct type."""
    for name, member in struct.fields:
        path, offset = f"{prefix}{name}", begin + member.offset
        if member.type.kind == "struct":
            yield from _members(member.type, f"{path}.", offset)
        else:
            yield path, "?" if member.type is ffi.typeof("bool") else "f8", offset


def _layout(struct: Any) -> np.dtype[np.void]:
    names, formats, offsets = zip(*_members(struct), strict=True)
    return np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": ffi.sizeof(struct)})


def names_of(layout: "np.dtype[np.void]") -> tuple[str, ...]:
    """Names of a layout's fields."""
    assert layout.names is not None
    return layout.names


PARAMETERS = _layout(ffi.typeof("tdmf_parameters"))
"""The library's parameters: arrays of this type are arrays of the C struct, fields have the unit's names."""
INPUTS = _layout(ffi.typeof("tdmf_inputs"))
"""The library's inputs."""
FLAGS = tuple(name for name in names_of(PARAMETERS) if PARAMETERS[name].kind == "b")
"""Boolean parameters."""
VARIED = MODELS["full"].varied
"""Numeric parameters and inputs: those that a continuation or a derivative can vary."""
MOVING = (*VARIED, *FLAGS)
"""All parameters and inputs. A runner's motion depends on these and on its start."""


NAMES = "a list of names of parameters and inputs"
"""Names that `vary` accepts."""


def check_varied(name: object, what: str, model: Model = MODELS["full"]) -> None:
    """Refuse a name that a gait cannot be followed along."""
    check_names([name], model.varied, what, model.aliases, "a parameter or input of the model")


def checked_names(given: object, what: str, model: Model = MODELS["full"]) -> tuple[str, ...]:
    """Names of parameters and inputs in a row, each once."""
    names = full_names(given, what, NAMES, model.aliases)
    for name in names:
        check_varied(name, what, model)
    check_once(names, what)
    return names


def pairs_varied(
    vary: object, counts: Container[int], allowed: str, model: Model = MODELS["full"]
) -> dict[str, list[Any]]:
    """Both ends of a range as they are given, by the names of what varies; `counts` are numbers of names."""
    given = by_full_name(vary, "vary", allowed, model.aliases)
    if len(given) not in counts:
        raise InputError(f"vary: {counted(len(given), 'name')}; allowed: {allowed}")
    pairs = {}
    for name, ends in given.items():
        check_varied(name, "vary", model)
        pairs[name] = row_of(ends, f"vary {name}", allowed)
        if len(pairs[name]) != 2:
            raise refusal(f"vary {name}", ends, allowed)
    return pairs


def ranges_varied(
    vary: object, counts: Container[int], allowed: str, model: Model
) -> dict[str, tuple[float, float]]:
    """Both ends of ranges in the variables' own units, by the names of what varies."""
    ranges = {}
    for name, pair in pairs_varied(vary, counts, allowed, model).items():
        low, high = (float(model.variables[name].value_of(end, f"vary {name}")) for end in pair)
        ranges[name] = low, high
    return ranges


def at_friction(values: Mapping[str, Any]) -> str:
    """The friction of a runner's ground, for a message; empty for a model without one."""
    return f" at friction {values[FRICTION]:g}" if FRICTION in values else ""


def check_has_gaits(values: Mapping[str, Any]) -> None:
    """Refuse friction 0: nothing then fixes the speed, and gaits of any speed are neighbours."""
    if values.get(FRICTION) == 0.0:
        raise InputError(
            "ground.friction = 0: without friction a gait exists at every speed, so none is isolated; "
            "allowed for gaits: above 0"
        )


def check_comes_down(values: Mapping[str, float]) -> None:
    """Refuse to search for a gait of a runner that an external force carries: it has no apex in flight."""
    if PUSH not in values:
        return
    push, weight = values[PUSH], values["gravity"] * (values["body.mass"] + values["foot.mass"])
    if push >= weight:
        raise GaitNotFoundError(
            f"no gait: body.external_fy = {push:g} N lifts the runner, which weighs {weight:g} N, so it "
            "never comes down; allowed for gaits: less than its weight"
        )


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
