"""TDMF-SLIP: a spring-legged runner whose foot can stick, slip, lift off and land (Or and Moravia 2016).

    >>> import tdmf_slip
    >>> run = tdmf_slip.simulate({"ground.friction": 0.43}, strides=3)
    >>> run.stride["word"], run.fallen

`simulate` runs the FMI unit once, `periodic_gait` runs it until its strides repeat, `validate` compares the
five gaits that the paper publishes; `fmu_path` is the unit itself, for any other importer.
"""

from importlib.metadata import PackageNotFoundError, version

from .errors import InputError, RunError, TdmfSlipError
from .gait import Gait, periodic_gait
from .parameters import read_parameters
from .simulation import Run, simulate
from .unit import Unit, fmu_path, load
from .validation import Validation, validate

try:
    __version__ = version("tdmf-slip")
except PackageNotFoundError:  # used from a source tree that is not installed
    __version__ = "0+unknown"

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
