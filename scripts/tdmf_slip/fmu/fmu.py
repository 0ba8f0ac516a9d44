"""The unit TDMF_SLIP.fmu: where it is, and the variables it offers.

Variables are read from the unit's own model description: another unit than the package's may have others.
"""

import functools
import math
import os
import shutil
import tempfile
from collections.abc import Mapping
from multiprocessing.util import Finalize
from pathlib import Path

import fmpy
from fmpy.model_description import ModelDescription, ModelVariable

from ..checks import is_one_of, number_of, path_of, refusal, shown
from ..errors import InputError, RunError, counted, reason
from ..variables.table import Variables
from ..variables.variable import Value, Variable

PATH_VARIABLE = "TDMF_SLIP_FMU"
FILES = {2: "TDMF_SLIP.fmu", 3: "TDMF_SLIP_FMI3.fmu"}
"""The units by FMI version. Inside, both are called TDMF_SLIP; the files lie side by side."""
INTERFACES = {"me": "ModelExchange", "cs": "CoSimulation"}


def fmu_path(fmi: int = 2) -> Path:
    """Path of the unit for an FMI version.

    The environment variable TDMF_SLIP_FMU gives the path of TDMF_SLIP.fmu, the other lies beside it; without
    it, both are in this package.

    Parameters
    ----------
    fmi : int, default 2
        Version 2 for TDMF_SLIP.fmu, or 3 for TDMF_SLIP_FMI3.fmu.

    Returns
    -------
    Path
        Path of a file that exists.

    Raises
    ------
    InputError
        There is no such file, or no unit for that version.

    Examples
    --------
    >>> import tdmf_slip
    >>> print(tdmf_slip.fmu_path().name, tdmf_slip.fmu_path(fmi=3).name)
    TDMF_SLIP.fmu TDMF_SLIP_FMI3.fmu
    """
    version = number_of(fmi)
    if version not in FILES:
        raise refusal("fmi", fmi, ", ".join(map(str, FILES)))
    override = os.environ.get(PATH_VARIABLE)
    path = Path(override) if override else Path(__file__).parents[1] / FILES[2]
    path = path if version == 2 else path.with_name(FILES[3])
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


class Fmu:
    """A unit whose description has been read; use `load`."""

    def __init__(self, path: Path) -> None:
        """Read the description of the unit at `path`."""
        self.path = path
        try:
            self.description: ModelDescription = fmpy.read_model_description(str(path))
        except Exception as problem:  # FMPy raises bare Exceptions, and zipfile's, for a bad file
            raise RunError(f"{path}: not a usable FMU: {problem}") from problem
        factors = {
            unit.name: {other.name: float(other.factor) for other in unit.displayUnits}
            for unit in self.description.unitDefinitions
        }
        self.variables = Variables(_variable_of(v, factors) for v in self.description.modelVariables)
        self._folder: Path | None = None

    def __getstate__(self) -> dict[str, object]:
        """All but the folder, which belongs to this process."""
        return self.__dict__ | {"_folder": None}

    def __repr__(self) -> str:
        """Version, standard and file of the FMU."""
        made = f"{self.description.modelName} by FMI {self.description.fmiVersion}"
        return f"<Fmu {made}: {counted(len(self.variables), 'variable')}, {self.path}>"

    @property
    def folder(self) -> str:
        """Folder of the unpacked unit. It is deleted when the process that made it ends.

        The unit is unpacked again if temporary files were cleaned meanwhile.

        Raises
        ------
        RunError
            It cannot be unpacked.
        """
        if self._folder is None or not any(self._folder.glob(f"binaries/*/*{fmpy.sharedLibraryExtension}")):
            self._folder = self._unpack()
        return str(self._folder)

    def _unpack(self) -> Path:
        try:
            folder = tempfile.mkdtemp(prefix="tdmf_slip_")
            # Deletes the folder at the end of this process only: a forked child leaves it to its parent.
            Finalize(None, shutil.rmtree, (folder,), {"ignore_errors": True}, exitpriority=0)
            return Path(fmpy.extract(str(self.path), folder))
        except OSError as problem:
            where = tempfile.tempdir or "a folder of temporary files"
            raise RunError(
                f"{self.path}: cannot be unpacked into {where}: {problem.strerror or problem}"
            ) from problem
        except Exception as problem:  # FMPy raises bare Exceptions, and zipfile's, for a bad file
            raise RunError(f"{self.path}: not a usable FMU: {problem}") from problem

    def require_interface(self, interface: str) -> str:
        """FMPy's name of an interface, `me` or `cs`; refuses one that this unit does not offer."""
        if not is_one_of(interface, INTERFACES):
            raise InputError(f"interface {shown(interface)} is unknown; allowed: {', '.join(INTERFACES)}")
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


def load_fmu(path: Path | str | Fmu | None = None) -> Fmu:
    """Load the unit at a path; it is read again only where the file has changed.

    Parameters
    ----------
    path : Path, str or Fmu, optional
        Path of the FMU, by default that of `fmu_path`. A unit that is loaded is returned as it is.

    Returns
    -------
    Fmu
        The unit with its variables.

    Raises
    ------
    InputError
        There is no such file.
    RunError
        The file is no usable FMU.

    Examples
    --------
    >>> import tdmf_slip
    >>> friction = tdmf_slip.load_fmu().variables["ground.friction"]
    >>> print(friction.start, friction.minimum, friction.description)
    0.6 0.0 Friction coefficient between foot and ground, mu
    """
    if isinstance(path, Fmu):
        return path
    path = fmu_path() if path is None else path_of(path, "fmu", "an Fmu, or the path of an FMU")
    try:
        return _load(path.resolve(), path.stat().st_mtime_ns)
    except (OSError, ValueError) as problem:  # no path at all, as with a zero byte
        raise InputError(
            f"{shown(str(path))}: cannot be read as an FMU: {reason(problem)}; allowed: the path of an FMU"
        ) from None


@functools.lru_cache
def _load(path: Path, modified: int) -> Fmu:
    return Fmu(path)


def _variable_of(variable: ModelVariable, factors: Mapping[str, Mapping[str, float]]) -> Variable:
    """A variable as the unit's description has it."""
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
        variability=variable.variability,
        settable=variable.causality == "input" or variable.initial == "exact",
        minimum=float(variable.min) if variable.min is not None else -math.inf,
        maximum=float(variable.max) if variable.max is not None else math.inf,
        start=_start(variable),
        items={int(item.value): item.name for item in items},
        display_units=factors.get(unit, {}),
    )


def _start(variable: ModelVariable) -> Value | None:
    if variable.start is None or variable.type == "String":
        return None
    return bool(variable.start == "true") if variable.type == "Boolean" else float(variable.start)
