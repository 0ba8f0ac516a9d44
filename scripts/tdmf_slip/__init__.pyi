from .errors import InputError, RunError, TdmfSlipError
from .gait import Gait, periodic_gait
from .parameters import read_parameters
from .simulation import Run, simulate
from .unit import Unit, fmu_path, load
from .validation import Validation, validate
from .version import __version__

__all__ = [
    "Gait",
    "InputError",
    "Run",
    "RunError",
    "TdmfSlipError",
    "Unit",
    "Validation",
    "__version__",
    "fmu_path",
    "load",
    "periodic_gait",
    "read_parameters",
    "simulate",
    "validate",
]
