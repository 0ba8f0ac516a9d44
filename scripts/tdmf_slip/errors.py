"""What goes wrong, as one clear message each."""


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


def reason(problem: Exception) -> str:
    """Why a file could not be read, in words for its user."""
    if isinstance(problem, UnicodeDecodeError):
        return "no text in UTF-8"
    return getattr(problem, "strerror", None) or str(problem)
