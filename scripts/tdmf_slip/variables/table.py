"""The one table: variables of the unit, and coordinates and quantities of each model's strides.

Its data are derived from the runner's page and its unit. Nothing is parsed at import.
"""

import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import Any

from ..checks import check_kind, is_one_of, near_matches, shown
from ..errors import InputError, Note
from ..given import mapping_of, row_of
from . import data
from .units import paper_label
from .variable import Given, Value, Variable, attributes_of

FRICTION = "ground.friction"
"""Name of the friction of the ground."""
ALIASES: Mapping[str, str] = MappingProxyType(data.ALIASES)
"""Own names of variables by their short names. `gravity` is a variable's own name."""
SHORT_NAMES: Mapping[str, str] = MappingProxyType({full: short for short, full in ALIASES.items()})
"""Short names of variables by their own names."""
DIMENSIONS: Mapping[str, tuple[int, int, int]] = MappingProxyType(data.DIMENSIONS)
"""Powers of length, time and mass in each unit; an angle has none."""
PARAMETERS: tuple[str, ...] = data.PARAMETERS
"""Parameters of the model, in the table's order. The unit has some more, for its solver."""
INPUTS: tuple[str, ...] = data.INPUTS
"""Inputs of the model."""
STATES: tuple[str, ...] = data.STATES
"""States that take a start value: the mechanical ones, in the C library's order."""


class Variables(Mapping[str, Variable]):
    """Variables of a unit by their names, in the unit's order."""

    def __init__(self, variables: Iterable[Variable], aliases: Mapping[str, str] = ALIASES) -> None:
        """Keep variables in their order, and their short names."""
        self._by_name = {variable.name: variable for variable in variables}
        self._aliases = dict(aliases)

    def __getitem__(self, name: str) -> Variable:
        """The variable with this name; short names go through `find`."""
        return self._by_name[name]

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names."""
        return iter(self._by_name)

    def __len__(self) -> int:
        """Number of variables."""
        return len(self._by_name)

    def find(self, name: object, where: str) -> Variable:
        """The variable with this name or short name; `where`, in messages, says where it was given."""
        check_kind(name, str, where, "a variable's name")
        full = full_name(name, self._aliases)
        if full in self._by_name:
            return self._by_name[full]
        near = near_matches(name, (*self._by_name, *self._aliases))
        raise InputError(f"{where}: the unit has no variable {shown(name)}{near}")

    def start_values(self, given: Mapping[str, Given] | None, where: str) -> dict[str, Value]:
        """Checked start values by the variables' own names, each in the variable's unit."""
        checked = {}
        allowed = "values by the names of variables"
        for name, value in by_full_name(given, where, allowed, self._aliases).items():
            variable = self.find(name, where)
            if not variable.settable:
                raise InputError(f"{where}: {name} takes no start value, the unit computes it")
            checked[name] = variable.value_of(value, where)
        return checked

    def all_start_values(self, given: Mapping[str, Value]) -> dict[str, Value]:
        """Start value of every variable that takes one: the given value, or else the unit's own."""
        own = {v.name: v.start for v in self.values() if v.settable and v.start is not None}
        return {**own, **given}

    def start_of(self, name: str, given: Mapping[str, Value] | None = None) -> float:
        """The start value of a number or a Boolean: the given one, or else the unit's own."""
        start = (given or {}).get(name, self._by_name[name].start)
        assert start is not None, name
        return start

    def names(self, causality: str) -> list[str]:
        """Names of all numeric variables of a causality, in the unit's order."""
        return [v.name for v in self.values() if v.causality == causality and v.type != "String"]

    def group(self, group: str) -> list[Variable]:
        """All variables of a group, such as `stride`."""
        return [variable for variable in self.values() if variable.group == group]


VARIABLES = Variables(Variable(*row) for row in data.VARIABLES)
"""Every variable of the package's unit."""
NAMES = (*PARAMETERS, *INPUTS, *STATES)
"""Names of a runner's values, in their order."""
VARIED = tuple(name for name in (*PARAMETERS, *INPUTS) if VARIABLES[name].type != "Boolean")
"""Numeric parameters and inputs."""


@dataclass(frozen=True)
class Quantity:
    """A quantity of a stride."""

    name: str
    """Its name, as `period`."""
    unit: str
    """Its unit, `1` for a number."""
    description: str
    """Its meaning."""
    coordinate: str
    """The coordinate of the stride's first apex that it is; empty for all others."""

    @property
    def attributes(self) -> dict[str, str]:
        """Its unit and description, by the names that CF gives them."""
        return attributes_of(self.unit, self.description)


@dataclass(frozen=True, eq=False)
class Model:
    """A map from apex to apex: the return map of the full model, the reduced map, or that of a page."""

    name: str
    """`full` or `reduced`."""
    coordinates: tuple[str, ...]
    """Names of an apex's coordinates, in the C library's order."""
    quantities: Mapping[str, Quantity]
    """Quantities of a stride, by name."""
    scales: tuple[str, ...]
    """Names of the values that are 1 in the model's own units: a mass, a stiffness and a length."""
    variables: Variables
    """Its variables."""
    aliases: Mapping[str, str]
    """Own names of variables by their short names."""
    names: tuple[str, ...]
    """Names of a runner's values, in their order: parameters, inputs, and states that take a start value."""
    varied: tuple[str, ...]
    """Numeric parameters and inputs, which a continuation or a derivative can vary."""

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        """Pickle by name: there is one object for each model."""
        return model_named, (self.name,)

    @property
    def runner_class(self) -> type[Any] | None:
        """The class of its runners; None for that of the package's own models."""
        return None

    @property
    def is_page(self) -> bool:
        """True if the model runs as a page: one of a user's own, or a page of the package."""
        return False

    @property
    def has_ground(self) -> bool:
        """True if the ground may vary from place to place, so that runs go on from apex to apex."""
        return self is MODELS["full"]

    @property
    def build(self) -> str:
        """The build and the section of a model of one's own, by which results find it again; else empty."""
        return ""

    @property
    def full(self) -> "Model":
        """The model that has all quantities of a stride: the full one for the reduced map, else this one."""
        return self if self.is_page else MODELS["full"]

    @property
    def units(self) -> tuple[str, ...]:
        """Units of the coordinates."""
        return tuple(self.coordinate(name).unit for name in self.coordinates)

    def coordinate(self, name: str) -> Variable:
        """The variable that is a coordinate of the apex."""
        return self.variables[f"apex.{name}"]

    @cached_property
    def positions(self) -> Mapping[str, int]:
        """Place of each value of a runner."""
        return {name: position for position, name in enumerate(self.names)}

    @cached_property
    def states(self) -> tuple[str, ...]:
        """Names of the values of a runner that are states."""
        of = ("parameter", "input")
        return tuple(name for name in self.names if self.variables[name].causality not in of)

    @cached_property
    def starts(self) -> tuple[Value, ...]:
        """Default of each value of a runner."""
        return tuple(self.variables.start_of(name) for name in self.names)

    @cached_property
    def settings(self) -> tuple[str, ...]:
        """Parameters of the control law and inputs, which may change at each apex."""
        return tuple(name for name in self.varied if self.variables[name].variability != "fixed")

    def full_name(self, name: Any) -> Any:
        """A variable's own name for its short one; anything else as it is."""
        return full_name(name, self.aliases)


def _models() -> dict[str, Model]:
    quantities: dict[str, Quantity] = {}
    for row in data.QUANTITIES:
        quantities.setdefault(row[0], Quantity(*row))
    return {
        name: Model(
            name=name,
            coordinates=coordinates,
            quantities=MappingProxyType({of: quantities[of] for of in those}),
            scales=scales,
            variables=VARIABLES,
            aliases=ALIASES,
            names=NAMES,
            varied=VARIED,
        )
        for name, coordinates, those, scales in data.MODELS
    }


MODELS: Mapping[str, Model] = MappingProxyType(_models())
"""The package's own models, by name."""
OWN_MODELS: dict[str, Model] = {}
"""Models of users' own pages that were loaded last under a name."""
BUILDS: dict[str, Model] = {}
"""Models of users' own pages that were loaded, by their builds, which results record."""


def model_named(name: object) -> Model:
    """The model with this name, or the given one."""
    if isinstance(name, Model):
        return name
    known = {**OWN_MODELS, **MODELS}
    if not is_one_of(name, known):
        allowed = f"{', '.join(known)}, or a model that load_model gives"
        raise InputError(f"model {shown(name)} is not allowed; allowed: {allowed}")
    return known[name]


def model_recorded(record: Mapping[str, Any]) -> Model:
    """The model of a saved result: that of the recorded build, else the one that has the name."""
    build = record.get("build", "")
    found = BUILDS.get(build) or model_named(record.get("model", "full"))
    if found.build != build:
        warnings.warn(
            f"model {found.name}: the result is from build {build or 'unknown'}, loaded is {found.build}; "
            "load the folder of the first by load_model if the page has changed",
            Note,
            stacklevel=3,
        )
    return found


def model_of(given: object, model: object) -> Model:
    """The model that is named, else that of a runner, a gait or a model that is given, else the full one."""
    if model is not None:
        return model_named(model)
    runner = getattr(given, "runner", given)
    found = getattr(runner, "model", runner)
    return found if isinstance(found, Model) else MODELS["full"]


def full_name(name: Any, aliases: Mapping[str, str] = ALIASES) -> Any:
    """A variable's own name for its short one; anything else as it is, for others to check."""
    return aliases.get(name, name) if isinstance(name, str) else name


def full_names(
    given: object, what: str, allowed: str, aliases: Mapping[str, str] = ALIASES
) -> tuple[Any, ...]:
    """Variables' own names for names in a row."""
    return tuple(full_name(name, aliases) for name in row_of(given, what, allowed))


def by_full_name(
    given: object, what: str, allowed: str, aliases: Mapping[str, str] = ALIASES
) -> dict[Any, Any]:
    """Values given by name, keyed by the variables' own names; a name may not be given both ways."""
    found: dict[Any, Any] = {}
    for name, value in mapping_of(given, what, allowed).items():
        full = full_name(name, aliases)
        if full in found:
            short = next(short for short, own in aliases.items() if own == full)
            raise InputError(f"{what}: {full} and {short} are the same; allowed: one of them")
        found[full] = value
    return found


def paper_unit(unit: str) -> str:
    """Label of a unit in the paper's units: `l0 sqrt(k/m)` for `m/s`, the unit itself for a number."""
    powers = DIMENSIONS[unit]
    return paper_label(*powers) if any(powers) else unit
