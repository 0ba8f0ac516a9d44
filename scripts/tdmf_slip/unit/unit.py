"""The unit TDMF_SLIP.fmu: where it is, and the variables it offers.

Names, units, ranges, starts and enumerations are read from the unit's own model description, so that nothing
here repeats them.
"""

import atexit
import difflib
import functools
import os
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path
from types import NoneType

import fmpy
from fmpy.model_description import ModelDescription

from ..checks import check_kind
from ..errors import InputError, RunError
from .variable import Variable, variable_of

PATH_VARIABLE = "TDMF_SLIP_FMU"
FILES = {2: "TDMF_SLIP.fmu", 3: "TDMF_SLIP_FMI3.fmu"}
"""The units by FMI version. Inside, both are called TDMF_SLIP; the files lie side by side."""
FRICTION = "ground.friction"
"""Name of the friction of the ground."""
INTERFACES = {"me": "ModelExchange", "cs": "CoSimulation"}


def fmu_path(fmi: int = 2) -> Path:
    """Path of the unit for an FMI version: TDMF_SLIP.fmu (2) or TDMF_SLIP_FMI3.fmu (3).

    The environment variable TDMF_SLIP_FMU gives the path of the former, the latter lies beside it; without
    it, both are in this package.

    Raises
    ------
    InputError
        There is no such file, or no unit for that version.
    """
    if fmi not in tuple(FILES):
        raise InputError(f"fmi = {fmi!r} is not allowed; allowed: {', '.join(map(str, FILES))}")
    override = os.environ.get(PATH_VARIABLE)
    path = Path(override) if override else Path(__file__).parents[1] / FILES[2]
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
            v.name: variable_of(v, factors) for v in self.description.modelVariables
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

        Raises
        ------
        InputError
            There is none; the message has the nearest names.
        """
        check_kind(name, str, where, "a variable's name")
        if name in self.variables:
            return self.variables[name]
        near = difflib.get_close_matches(name, self.variables, n=3, cutoff=0.5)
        hint = f"; near matches: {', '.join(near)}" if near else ""
        raise InputError(f"{where}: the unit has no variable {name!r}{hint}")

    def start_values(self, given: Mapping[str, object], where: str) -> dict[str, float | bool]:
        """Checked start values, each in the variable's unit, from names and numbers or texts.

        Raises
        ------
        InputError
            An unknown name, a variable that takes no start value, or a value out of range.
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

        Raises
        ------
        InputError
            No such interface, or this unit does not offer it.
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

    Raises
    ------
    InputError
        There is no such file.
    RunError
        The file is no usable FMU.
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
