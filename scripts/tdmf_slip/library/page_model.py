"""Models of pages, with their tables: of one's own, in libraries that `build` made, and of the package."""

import json
import os
import threading
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..builds import FOLDER, TABLE, host
from ..checks import is_one_of, path_of, shown
from ..errors import InputError, reason
from ..variables import data
from ..variables.table import ALIASES, BUILDS, MODELS, OWN_MODELS, Model, Quantity, Variables
from ..variables.variable import Value, Variable
from ..version import __version__
from .binding import c, ffi, text_of

WORD, LIFTOFF = "stride.word", "hip.liftoff_angle"
"""Names in a unit of a stride's word and of the leg's angle at lift-off."""
OF_A_STRIDE, OF_ENERGY, OF_APEX = "stride.", "energy.", "apex."
"""Beginnings of the names of states whose values at the next crossing are quantities of a stride."""
EVENT_ROOM = 64
"""Events of a stride that are kept."""
BETWEEN_EVENTS = "-"
"""Separator of the events in the word of a stride."""
PERIOD = Quantity("period", "s", "Time from one crossing of the section to the next", "")
FREQUENCY = Quantity("frequency", "Hz", "Strides per second, one over the period", "")
_loaded: dict[tuple[Path, str, str], "PageModel"] = {}
_lock = threading.Lock()


@dataclass(frozen=True, eq=False, kw_only=True)
class PageModel(Model):
    """A model of a page, as `load_model` gives it. As a runner it stands for the page's own values."""

    folder: Path | None
    """The folder of the build; None for a page of the package."""
    section: int
    """Number of the section of its return map; -1 for a page without one."""
    table: Mapping[str, Any]
    """The model's table, as `build` wrote it."""
    library: Any
    """The functions of its library."""
    page: Any
    """The model as its library's `tdmf_page *`."""

    def __reduce__(self) -> tuple[Any, tuple[str, str | None]]:
        """Pickle by the folder, which the other process has to have, or by the name in the package."""
        if self.folder is None:
            return package_model, (self.name, self.section_name)
        return _unpickled, (str(self.folder), self.section_name)

    def __repr__(self) -> str:
        """One line: the page's name, and the coordinates of its section."""
        return (
            f"<Model {self.name}: {self.table['about']} Coordinates: {', '.join(self.coordinates) or 'none'}>"
        )

    @property
    def runner_class(self) -> type[Any]:
        """The class of its runners."""
        from .page_runner import PageRunner  # knows models

        return PageRunner

    @property
    def is_page(self) -> bool:
        """True: the model runs as a page."""
        return True

    @property
    def has_ground(self) -> bool:
        """True if the page has the ground of `tdmf_slip.pages.Runner`."""
        return bool(self.library.tdmf_page_has_ground(self.page))

    @property
    def build(self) -> str:
        """The identity of the build, and the section of the return map."""
        if self.folder is None:
            return ""
        return " ".join([self.table["id"], *([self.section_name] if self.section_name else [])])

    @property
    def unit(self) -> Path:
        """The file of the FMI 2.0 unit that the build made."""
        path = None if self.folder is None else self.folder / f"{self.table['name']}.fmu"
        if path is None or not path.is_file():
            raise InputError(
                f"model {self.name}: {self.folder} has no unit; allowed: a build with its units "
                "(without unit=False, --no-unit), or trajectory, which needs none"
            )
        return path

    @property
    def section_name(self) -> str | None:
        """Name of the section; None for a page without one."""
        return self.table["sections"][self.section]["name"] if self.section >= 0 else None

    def coordinate(self, name: str) -> Variable:
        """The variable that is a coordinate of the section."""
        return self._coordinates[name]

    @cached_property
    def _coordinates(self) -> Mapping[str, Variable]:
        states = self.table["states"]
        return {
            name: _variable(states[number])
            for name, number in zip(self.coordinates, self.coordinate_numbers, strict=True)
        }

    @cached_property
    def coordinate_numbers(self) -> tuple[int, ...]:
        """Numbers of the states that are coordinates of the section."""
        if self.section < 0:
            return ()
        names = [state["name"] for state in self.table["states"]]
        return tuple(names.index(name) for name in self.table["sections"][self.section]["coordinates"])

    @cached_property
    def value_places(self) -> tuple[tuple[bool, int], ...]:
        """Place of each value of a runner: whether it is a state, and its number."""
        places = {
            of["public"]: (kind == "states", number)
            for kind in ("states", "parameters")  # a held state may have the name of a parameter
            for number, of in enumerate(self.table[kind])
        }
        return tuple(places[name] for name in self.names)

    def setting_number(self, name: str) -> int:
        """Number of a setting for the engine: that of the parameter, or of the state behind all of them."""
        is_state, number = self.value_places[self.positions[name]]
        return number + len(self.table["parameters"]) if is_state else number

    @cached_property
    def state_numbers(self) -> Mapping[str, int]:
        """Numbers of states by their names in a unit."""
        return {state["public"]: number for number, state in enumerate(self.table["states"])}

    @cached_property
    def quantity_states(self) -> Mapping[str, int | None]:
        """Number of the state that is a quantity of a stride; None for the time of the run."""
        of = self.state_numbers
        own = {"liftoff_angle": LIFTOFF}
        return {
            name: of.get(own.get(name, f"{OF_A_STRIDE}{name}"), of.get(f"{OF_ENERGY}{name}"))
            for name, quantity in self.quantities.items()
            if name != "frequency" and not quantity.coordinate
        }

    @cached_property
    def letters(self) -> str:
        """Letters of the words of strides; empty where a word is the names of its events."""
        number = self.state_numbers.get(WORD)
        return "" if number is None else str(self.table["states"][number]["letters"])

    @cached_property
    def noted(self) -> Mapping[int, int]:
        """Columns of the states that make quantities and words of strides, by their numbers."""
        numbers = [number for number in self.quantity_states.values() if number is not None]
        word = [self.state_numbers[WORD]] if self.letters else []
        return {number: column for column, number in enumerate(dict.fromkeys([*numbers, *word]))}

    @cached_property
    def totals(self) -> frozenset[int]:
        """Numbers of the states that count from the start of a run, which a quantity of a stride does not."""
        return frozenset(n for name, n in self.state_numbers.items() if name.startswith(OF_ENERGY))

    def words(self, codes: Iterable[float], events: Iterable[Iterable[int]]) -> list[str]:
        """Words of strides: texts whose letters are the digits of numbers, or names of events."""
        if self.letters:
            return [text_of_code(code, self.letters) for code in codes]
        names = self.table["events"]
        return [BETWEEN_EVENTS.join(names[event] for event in row) for row in events]

    @property
    def checked_section(self) -> int:
        """Number of the section. Raises InputError where the page has none."""
        if self.section < 0:
            raise InputError(
                f"model {self.name}: its page has no section, so that it has no strides; "
                "allowed: simulate, or a page with @section"
            )
        return self.section

    @cached_property
    def clock(self) -> int | None:
        """Number of the state that is the time."""
        roles = [state["role"] for state in self.table["states"]]
        return roles.index("clock") if "clock" in roles else None

    def numbers(self, values: Sequence[Value]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Parameters and states in the order of their numbers, for values of a runner."""
        found = tuple(
            np.array([one["start"] for one in self.table[kind]], float) for kind in ("parameters", "states")
        )
        for (is_state, number), value in zip(self.value_places, values, strict=True):
            found[is_state][number] = value
        return found[0], found[1]

    def why_refused(self, requirement: int, states: NDArray[np.float64]) -> str:
        """The reason why a start with these states is refused, in words: a requirement, from 1."""
        if requirement == 0:
            return "a number is out of its range or not finite"
        of = self.table["requirements"][requirement - 1]
        number = self.state_numbers.get(of["variable"])
        given = "" if number is None else f" = {states[number]:.9g}"
        return f"{of['variable']}{given} at the start; it must be {of['allowed']}"

    def seed(self, along: Mapping[str, float]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """A direction of parameters and inputs, as changes of parameters and states."""
        found = np.zeros(len(self.table["parameters"])), np.zeros(len(self.table["states"]))
        for name, share in along.items():
            is_state, number = self.value_places[self.positions[name]]
            found[is_state][number] = share
        return found

    def check_current(self) -> None:
        """Refuse to go on with a library that was built anew meanwhile."""
        if self.folder is not None and _identity(self.folder)["id"] != self.table["id"]:
            raise InputError(
                f"model {self.name}: {self.folder} was built anew while it was loaded; "
                "load it again by load_model"
            )


def load_model(path: str | os.PathLike[str], *, section: str | None = None) -> PageModel:
    """Load a model of one's own, as `build` or `tdmf-slip build` made it.

    It may be given for a runner, which then has the page's own values, and for the name of a model:
    `find_gait(model, stiffness=2)`, `Runner("parameters.toml", model=model)`.

    Parameters
    ----------
    path : str or Path
        The folder of the page, or that of the build.
    section : str, optional
        The section of the return map, by default the page's first.

    Returns
    -------
    Model
        The model, with `coordinates` of the section, `quantities` of a stride, and the table of its
        `variables`.

    Raises
    ------
    InputError
        There is no build for this machine, another version of this package made it, or it has no such
        section.

    Examples
    --------
    >>> import tdmf_slip
    >>> folder = tdmf_slip.new("my_ball", start="scratch")
    >>> build = tdmf_slip.build(folder)
    >>> ball = tdmf_slip.load_model(folder)
    >>> gait = tdmf_slip.find_gait(ball, restitution=0.5)
    >>> print(gait.jacobian.round(10))
    [[0.5]]
    """
    given = path_of(path, "load_model", "the folder of a page, or of a build")
    folder = next((one for one in (given / FOLDER, given) if (one / TABLE).is_file()), None)
    if folder is None:
        raise InputError(
            f"load_model {shown(str(given))}: has no build in it; first make one: tdmf-slip build {given}"
        )
    folder = folder.resolve()
    table = _identity(folder)
    names = [of["name"] for of in table["sections"]]
    if section is not None and not is_one_of(section, names):
        allowed = ", ".join(names) or "none, the page has no section"
        raise InputError(f"load_model: section {shown(section)} is not allowed; allowed: {allowed}")
    number = names.index(section) if section is not None else 0 if names else -1
    with _lock:
        key = folder, str(table["id"]), str(number)
        if key not in _loaded:
            _loaded[key] = _model(folder, table, number, _library(folder, table))
        model = _loaded[key]
        OWN_MODELS[model.name] = model
        BUILDS[model.build] = model
        return model


@cache
def package_model(name: str, section: str) -> PageModel:
    """Return the model of a page in the package's library, from the table that was derived with its C."""
    table = json.loads(Path(data.__file__).with_name(f"{name}.json").read_text(encoding="utf-8"))
    number = [of["name"] for of in table["sections"]].index(section)
    return _model(None, table, number, c)


def text_of_code(code: float, letters: str) -> str:
    """A text whose letters are the digits of a number; empty for a number below 0."""
    digits, rest = [], int(code)
    while rest > 0:
        rest, digit = divmod(rest, len(letters))
        digits.append(letters[digit])
    return "".join(reversed(digits))


def _unpickled(folder: str, section: str | None) -> PageModel:
    return load_model(folder, section=section)


def _identity(folder: Path) -> Mapping[str, Any]:
    """The table in the folder of a build, made by this version."""
    try:
        table: Mapping[str, Any] = json.loads((folder / TABLE).read_text(encoding="utf-8"))
        version = table["version"]
    except (OSError, ValueError, KeyError, TypeError) as problem:
        raise InputError(f"model {folder}: {reason(problem)}; build it anew") from None
    if version != __version__:
        raise InputError(
            f"model {folder}: was built by tdmf-slip {version}, this is {__version__}; build it anew"
        )
    return table


def _model(folder: Path | None, table: Mapping[str, Any], section: int, library: Any) -> PageModel:
    page = library.tdmf_page_named(table["c_name"].encode())
    quantities = [*table["parameters"], *(s for s in table["states"] if s["role"] in ("input", "start"))]
    variables = {of["public"]: _variable(of) for of in quantities}
    aliases = {of["name"]: of["public"] for of in quantities if of["name"] not in variables}
    aliases |= {
        short: own
        for short, own in ALIASES.items()
        if own in variables and short not in variables and short not in aliases
    }
    coordinates = _coordinates_of(table, section)
    varied = (of["public"] for of in quantities if of["role"] != "start" and not of["is_boolean"])
    return PageModel(
        name=table["c_name"],
        coordinates=tuple(coordinates),
        quantities=_quantities_of(table, coordinates),
        scales=tuple(name for name in MODELS["full"].scales if name in variables),
        variables=Variables(variables.values(), aliases),
        aliases=MappingProxyType(aliases),
        names=tuple(variables),
        varied=tuple(varied),
        folder=folder,
        section=section,
        table=table,
        library=library,
        page=page,
    )


def _library(folder: Path, table: Mapping[str, Any]) -> Any:
    """The library for this machine, loaded."""
    made = table["libraries"]
    own = host()
    if own not in made:
        raise InputError(
            f"model {folder}: was built for {', '.join(made)}, this is {own}; build it here, too"
        )
    path = folder / made[own]
    try:
        library = ffi.dlopen(str(path))
    except OSError as problem:
        raise InputError(f"{path}: cannot be loaded as a library: {problem}; build it anew") from None
    found = text_of(library.tdmf_page_build())
    if found != table["id"]:
        raise InputError(f"{path}: is build {found}, not {table['id']} as {TABLE} says; build it anew")
    return library


def _variable(of: Mapping[str, Any]) -> Variable:
    """A quantity of the page as a variable."""
    role = of["role"]
    return Variable(
        name=of["public"],
        reference=0,
        type="Boolean" if of["is_boolean"] else "Real",
        unit=of["unit"] or "1",
        description=of["meaning"],
        causality="parameter" if role in ("fixed", "tunable") else "local" if role == "start" else "input",
        variability={"fixed": "fixed", "tunable": "tunable", "setting": "discrete"}.get(role, "continuous"),
        settable=True,
        minimum=of["least"],
        maximum=of["most"],
        start=bool(of["start"]) if of["is_boolean"] else of["start"],
        items={},
        display_units={},
    )


def _coordinates_of(table: Mapping[str, Any], section: int) -> Mapping[str, Mapping[str, Any]]:
    """States that are coordinates of the section, by names without `apex.` or `apex_`."""
    if section < 0:
        return {}
    states = {state["name"]: state for state in table["states"]}
    found = (states[name] for name in table["sections"][section]["coordinates"])
    return {of["public"].removeprefix(OF_APEX).removeprefix("apex_"): of for of in found}


def _quantities_of(
    table: Mapping[str, Any], coordinates: Mapping[str, Mapping[str, Any]]
) -> Mapping[str, Quantity]:
    """Quantities of a stride: the period, states named for a stride or an energy, and coordinates."""
    of_apex = {q.coordinate: name for name, q in MODELS["full"].quantities.items() if q.coordinate}
    found = {"period": PERIOD}
    for of in table["states"]:
        begin = next((b for b in (OF_A_STRIDE, OF_ENERGY) if of["public"].startswith(b)), None)
        if begin and of["is_named"] and not of["letters"]:
            name = of["public"].removeprefix(begin)
            found[name] = Quantity(name, of["unit"] or "1", of["meaning"], "")
        if of["public"] == LIFTOFF:
            found["liftoff_angle"] = Quantity("liftoff_angle", of["unit"], of["meaning"], "")
    found["frequency"] = FREQUENCY
    for name, of in coordinates.items():
        own = of_apex.get(name, f"apex_{name}")
        found[own] = Quantity(own, of["unit"] or "1", of["meaning"], name)
    return MappingProxyType(found)
