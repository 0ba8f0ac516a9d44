"""The unit TDMF_SLIP.fmu: where it is, and the variables it offers.

Names, units, ranges, starts and enumerations are read from the unit's own model description, so that nothing
here repeats them.
"""

import atexit
import difflib
import functools
import math
import os
import reprlib
import shutil
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import NoneType

import fmpy
import numpy as np
from fmpy.model_description import ModelDescription, ModelVariable

from .errors import InputError, RunError, check_kind

PATH_VARIABLE = "TDMF_SLIP_FMU"
FILES = {2: "TDMF_SLIP.fmu", 3: "TDMF_SLIP_FMI3.fmu"}
"""The units by FMI version. Inside, both are called TDMF_SLIP; the files lie side by side."""
INTERFACES = {"me": "ModelExchange", "cs": "CoSimulation"}


def fmu_path(fmi: int = 2) -> Path:
    """Path of the unit for an FMI version: TDMF_SLIP.fmu (2) or TDMF_SLIP_FMI3.fmu (3).

    The environment variable TDMF_SLIP_FMU gives the path of the former, the latter lies beside it; without
    it, both are in this package.

    Raises:
        InputError: there is no such file, or no unit for that version.
    """
    if fmi not in tuple(FILES):
        raise InputError(f"fmi = {fmi!r} is not allowed; allowed: {', '.join(map(str, FILES))}")
    override = os.environ.get(PATH_VARIABLE)
    path = Path(override) if override else Path(__file__).parent / FILES[2]
    path = path if fmi == 2 else path.with_name(FILES[fmi])
    if path.is_file():
        return path
    if override:
        raise InputError(
            f"{PATH_VARIABLE}: {str(path)!r} is not a file; the variable has to be the path of {FILES[2]}"
        )
    raise InputError(
        f"{path.name} is missing beside the package ({path}); install the package with pip, "
        f"or set {PATH_VARIABLE} to the unit that CMake built"
    )


@dataclass(frozen=True)
class Variable:
    """One variable of the unit, with its declared type folded in."""

    name: str
    reference: int
    type: str
    """Real, Integer, Boolean, String or Enumeration."""
    unit: str
    """Unit of every value, empty where there is none."""
    description: str
    causality: str
    settable: bool
    """A start value is accepted."""
    minimum: float
    maximum: float
    start: float | bool | None
    items: Mapping[int, str]
    """Names of an enumeration's values."""
    display_units: Mapping[str, float]
    """Other units of the same quantity, and how many of each make one `unit`."""

    @property
    def allowed(self) -> str:
        """What a start value may be, in words."""
        if self.type == "Boolean":
            return "true or false"
        if self.items:
            return ", ".join(f"{name} ({value})" for value, name in self.items.items())
        unit = f" {self.unit}" if self.unit not in ("", "1") else ""
        return f"{self.minimum:g} to {self.maximum:g}{unit}"

    def value_of(self, given: object, where: str) -> float | bool:
        """A start value for this variable from a number or a text like `40 deg`, checked against its range.

        Args:
            given: number, bool, or text: a number, alone or followed by the unit or a display unit; of an
                enumeration also a name.
            where: where the value was given, for the message.

        Raises:
            InputError: not a number, an unknown unit, or out of range.
        """
        if self.type == "Boolean":
            return self._boolean(given, where)
        value = self._number(given, where)
        if not self.minimum <= value <= self.maximum or (self.items and value not in self.items):
            raise self._refusal(given, where)
        return value

    def values_of(self, given: object, where: str) -> np.ndarray:
        """One or more values for this variable, each as `value_of` takes it, in an array.

        Raises:
            InputError: not a row of such values.
        """
        try:
            if isinstance(given, str | Mapping):
                raise TypeError
            values = np.array([self.value_of(value, where) for value in given], dtype=float)
        except TypeError:
            raise InputError(
                f"{where} = {reprlib.repr(given)} is not allowed; allowed: a row of values of {self.name}"
            ) from None
        if not len(values):
            raise InputError(f"{where}: no values of {self.name}; allowed: one or more")
        return values

    def _refusal(self, given: object, where: str, hint: str = "") -> InputError:
        shown = given if str(given).isprintable() else repr(given)
        return InputError(f"{where}: {self.name} = {shown} is not allowed; allowed: {self.allowed}{hint}")

    def _boolean(self, given: object, where: str) -> bool:
        values = {"true": True, "false": False, "1": True, "0": False}
        try:
            return values[str(given).lower()]
        except KeyError:
            raise self._refusal(given, where) from None

    def _number(self, given: object, where: str) -> float:
        if isinstance(given, str) and given in self.items.values():
            given = next(value for value, name in self.items.items() if name == given)
        number, _, unit = given.strip().partition(" ") if isinstance(given, str) else (given, "", "")
        factors = {"": 1.0, self.unit: 1.0, **self.display_units}
        if unit.strip() not in factors:
            known = ", ".join(u for u in factors if u)
            raise InputError(f"{where}: {self.name} = {given}: unknown unit {unit.strip()!r}; known: {known}")
        try:
            value = float(number) / factors[unit.strip()]
        except (TypeError, ValueError, OverflowError):
            has_unit = self.unit not in ("", "1")
            hint = ", a unit after a space" if isinstance(given, str) and has_unit else ""
            raise self._refusal(given, where, hint) from None
        if isinstance(given, bool | np.bool_ | bytes) or not math.isfinite(value):
            raise self._refusal(given, where)
        return value


class Unit:
    """A unit that has been read and unpacked; use `load`."""

    def __init__(self, path: Path) -> None:
        """Read and unpack the unit at `path`; the unpacked copy goes when Python ends."""
        self.path = path
        try:
            self.description: ModelDescription = fmpy.read_model_description(str(path))
            self.folder: str = self._unpacked()
        except RunError:
            raise
        except Exception as problem:  # FMPy raises bare Exceptions, and zipfile's, for a bad file
            raise RunError(f"{path}: not a usable FMU: {problem}") from problem
        atexit.register(shutil.rmtree, self.folder, ignore_errors=True)
        factors = {
            unit.name: {other.name: float(other.factor) for other in unit.displayUnits}
            for unit in self.description.unitDefinitions
        }
        self.variables: dict[str, Variable] = {
            v.name: _variable(v, factors) for v in self.description.modelVariables
        }

    def _unpacked(self) -> str:
        try:
            return fmpy.extract(str(self.path))
        except OSError as problem:
            raise RunError(
                f"{self.path}: cannot be unpacked into {tempfile.gettempdir()}: {problem.strerror or problem}"
            ) from problem

    def find(self, name: str, where: str) -> Variable:
        """The variable called `name`.

        Raises:
            InputError: there is none; the message has the nearest names.
        """
        check_kind(name, str, where, "a variable's name")
        if name in self.variables:
            return self.variables[name]
        near = difflib.get_close_matches(name, self.variables, n=3, cutoff=0.5)
        hint = f"; near matches: {', '.join(near)}" if near else ""
        raise InputError(f"{where}: the unit has no variable {name!r}{hint}")

    def start_values(self, given: Mapping[str, object], where: str) -> dict[str, float | bool]:
        """Checked start values, each in the variable's unit, from names and numbers or texts.

        Raises:
            InputError: an unknown name, a variable that takes no start value, or a value out of range.
        """
        check_kind(given, Mapping, where, "values by the names of variables")
        checked = {}
        for name, value in given.items():
            variable = self.find(name, where)
            if not variable.settable:
                raise InputError(f"{where}: {name} takes no start value, the unit computes it")
            checked[name] = variable.value_of(value, where)
        return checked

    def start_of(self, name: str) -> float:
        """The start value that the unit itself gives to `name`."""
        return self.variables[name].start

    def names(self, causality: str) -> list[str]:
        """Names of all numeric variables of a causality, in the unit's order."""
        return [v.name for v in self.variables.values() if v.causality == causality and v.type != "String"]

    def group(self, group: str) -> list[str]:
        """Names of all variables of a group, such as `stride`."""
        return [name for name in self.variables if name.startswith(group + ".")]

    def require_interface(self, interface: str) -> str:
        """FMPy's name of an interface, `me` or `cs`.

        Raises:
            InputError: no such interface, or this unit does not offer it.
        """
        if interface not in tuple(INTERFACES):
            raise InputError(f"interface {interface!r} is unknown; allowed: {', '.join(INTERFACES)}")
        offered = {
            "me": self.description.modelExchange is not None,
            "cs": self.description.coSimulation is not None,
        }
        if not offered[interface]:
            have = ", ".join(name for name, is_there in offered.items() if is_there)
            raise InputError(f"interface {interface!r}: {self.path} does not offer it; it offers: {have}")
        return INTERFACES[interface]

    @property
    def version(self) -> str:
        """Version that the unit's description gives."""
        return str(self.description.version or "")


def load(path: Path | str | Unit | None = None) -> Unit:
    """The unit at `path`, or the one that `fmu_path` finds; read again only where the file has changed.

    A unit that is loaded already is given back as it is.

    Raises:
        InputError: there is no such file.
        RunError: the file is no usable FMU.
    """
    if isinstance(path, Unit):
        return path
    check_kind(path, (str, os.PathLike, NoneType), "unit", "a Unit, or the path of an FMU")
    path = fmu_path() if path is None else Path(path)
    try:
        return _load(path.resolve(), path.stat().st_mtime_ns)
    except OSError as problem:
        raise InputError(f"{path}: no unit there: {problem.strerror}; allowed: path of an FMU") from None


@functools.lru_cache
def _load(path: Path, modified: int) -> Unit:
    return Unit(path)


def _variable(variable: ModelVariable, factors: Mapping[str, Mapping[str, float]]) -> Variable:
    declared = variable.declaredType
    unit = variable.unit or (declared.unit if declared is not None else None) or ""
    items = getattr(declared, "items", None) or []
    return Variable(
        name=variable.name,
        reference=variable.valueReference,
        type=variable.type,
        unit=unit,
        description=variable.description or "",
        causality=variable.causality,
        settable=variable.causality == "input" or variable.initial == "exact",
        minimum=float(variable.min) if variable.min is not None else -math.inf,
        maximum=float(variable.max) if variable.max is not None else math.inf,
        start=_start(variable),
        items={int(item.value): item.name for item in items},
        display_units=factors.get(unit, {}),
    )


def _start(variable: ModelVariable) -> float | bool | None:
    if variable.start is None or variable.type == "String":
        return None
    return variable.start == "true" if variable.type == "Boolean" else float(variable.start)
