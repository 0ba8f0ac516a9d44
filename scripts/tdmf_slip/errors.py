"""Errors, as one clear message each."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class TdmfSlipError(Exception):
    """Base of this package's errors; the command prints it without a traceback."""

    exit_status = 1


class InputError(TdmfSlipError):
    """Something asked for is not possible: the message names what, where, the value and what is allowed."""

    exit_status = 2


class RunError(TdmfSlipError):
    """A run was begun and failed; the message carries what the unit and FMPy said."""


class GaitNotFoundError(RunError):
    """No periodic gait was found; the message says what happened on the way."""


class Note(UserWarning):
    """A warning about a result that is valid all the same."""


class StoppedError(KeyboardInterrupt):
    """An interrupt from the keyboard ended a run of many: what was complete is kept."""

    def __init__(self, ends: "NDArray[np.void]") -> None:
        """Keep what became of each run."""
        super().__init__()
        self.ends = ends
        """Ends of the runners that had begun, with the fields of `Batch.run`."""


def counted(number: int, noun: str) -> str:
    """A number of things in a message: 1 step, 2 steps, 1,000 steps."""
    return f"{number:,} {noun}{'' if number == 1 else 's'}"


def reason(problem: Exception) -> str:
    """Why a file could not be read, in words for its user."""
    if isinstance(problem, UnicodeDecodeError):
        return "no text in UTF-8"
    return getattr(problem, "strerror", None) or str(problem)
