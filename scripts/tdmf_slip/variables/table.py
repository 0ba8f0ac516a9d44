"""The one table: variables of the unit, and coordinates and quantities of each model's strides.

The build writes its data from modelDescription.xml. Nothing is parsed at import.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from ..checks import check_kind, is_one_of, near_matches, shown
from ..errors import InputError
from ..given import mapping_of, row_of
from . import data
from .units import paper_label
from .variable import Given, Value, Variable, attributes_of

FRICTION = "ground.friction"
"""Name of the friction of the ground."""
ALIASES: Mapping[str, str] = MappingProxyType(data.ALIASES)
"""From the short name of a variable to its own. `gravity` is a variable's own name."""
SHORT_NAMES: Mapping[str, str] = MappingProxyType({full: short for short, full in ALIASES.items()})
"""From a variable's own name to the short one."""
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

    def __init__(self, variables: Iterable[Variable]) -> None:
        """Keep variables in their order."""
        self._by_name = {variable.name: variable for variable in variables}

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
        full = full_name(name)
        if full in self._by_name:
            return self._by_name[full]
        near = near_matches(name, (*self._by_name, *ALIASES))
        raise InputError(f"{where}: the unit has no variable {shown(name)}{near}")

    def start_values(self, given: Mapping[str, Given] | None, where: str) -> dict[str, Value]:
        """Checked start values by the variables' own names, each in the variable's unit."""
        checked = {}
        for name, value in by_full_name(given, where, "values by the names of variables").items():
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
    """A map from apex to apex: the return map of the full model, or the reduced map."""

    name: str
    """`full` or `reduced`."""
    coordinates: tuple[str, ...]
    """Names of an apex's coordinates, in the C library's order."""
    quantities: Mapping[str, Quantity]
    """Quantities of a stride, by name."""
    scales: tuple[str, ...]
    """Names of the values that are 1 in the model's own units: a mass, a stiffness and a length."""

    def __reduce__(self) -> tuple[Any, tuple[str]]:
        """Pickle by name: there is one object for each model."""
        return model_named, (self.name,)

    @property
    def units(self) -> tuple[str, ...]:
        """Units of the coordinates."""
        return tuple(VARIABLES[f"apex.{name}"].unit for name in self.coordinates)


def _models() -> dict[str, Model]:
    quantities: dict[str, Quantity] = {}
    for row in data.QUANTITIES:
        quantities.setdefault(row[0], Quantity(*row))
    return {
        name: Model(name, coordinates, MappingProxyType({of: quantities[of] for of in those}), scales)
        for name, coordinates, those, scales in data.MODELS
    }


MODELS: Mapping[str, Model] = MappingProxyType(_models())
"""The models, by name."""


def model_named(name: object) -> Model:
    """The model with this name."""
    if not is_one_of(name, MODELS):
        raise InputError(f"model {shown(name)} is not allowed; allowed: {', '.join(MODELS)}")
    return MODELS[name]


def full_name(name: Any) -> Any:
    """A variable's own name for its short one; anything else as it is, for others to check."""
    return ALIASES.get(name, name) if isinstance(name, str) else name


def full_names(given: object, what: str, allowed: str) -> tuple[Any, ...]:
    """Variables' own names for names in a row."""
    return tuple(map(full_name, row_of(given, what, allowed)))


def by_full_name(given: object, what: str, allowed: str) -> dict[Any, Any]:
    """Values given by name, keyed by the variables' own names; a name may not be given both ways."""
    found: dict[Any, Any] = {}
    for name, value in mapping_of(given, what, allowed).items():
        full = full_name(name)
        if full in found:
            raise InputError(f"{what}: {full} and {SHORT_NAMES[full]} are the same; allowed: one of them")
        found[full] = value
    return found


def scale(unit: str, length: float, time: float, mass: float) -> float:
    """Scale of quantities in a unit, from scales of length, time and mass."""
    of_length, of_time, of_mass = DIMENSIONS[unit]
    return length**of_length * time**of_time * mass**of_mass


def paper_unit(unit: str) -> str:
    """Label of a unit in the paper's units: `l0 sqrt(k/m)` for `m/s`, the unit itself for a number."""
    powers = DIMENSIONS[unit]
    return paper_label(*powers) if any(powers) else unit
