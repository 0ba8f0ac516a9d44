"""The runner whose gait a command is asked for."""

import warnings
from collections.abc import Mapping

from ..errors import InputError, Note
from ..library.runner import Runner
from ..library.settings import OF_FLIGHT
from ..variables.values import NAMES
from ..variables.variable import Given
from .options import file_values, start_values


def runner_of(
    parameters: str | None, given: Mapping[str, tuple[str, Given]], model: str | None = None
) -> Runner:
    """The runner of the options."""
    starts = start_values(file_values(parameters), given)
    for name, (option, _) in given.items():
        if name not in NAMES:
            raise InputError(
                f"{option} {name}: has no meaning for gaits, which the library finds without the unit; "
                f"allowed: parameters and inputs of the model, and its state"
            )
    runner = Runner(starts, model=model)
    for name, (option, _) in given.items():
        if runner.reduced and name in OF_FLIGHT:
            warnings.warn(f"{option} {name}: has no effect in the reduced map", Note, stacklevel=2)
    return runner
