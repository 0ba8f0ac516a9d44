"""What goes wrong, as one clear message each."""

import reprlib


class TdmfSlipError(Exception):
    """Base of this package's errors; the command prints it without a traceback."""

    exit_status = 1


class InputError(TdmfSlipError):
    """Something asked for is not possible: the message names what, where, the value and what is allowed."""

    exit_status = 2


class RunError(TdmfSlipError):
    """A run was begun and failed; the message carries what the unit and FMPy said."""


def reason(problem: Exception) -> str:
    """Why a file could not be read, in words for its user."""
    if isinstance(problem, UnicodeDecodeError):
        return "no text in UTF-8"
    return getattr(problem, "strerror", None) or str(problem)


def check_kind(given: object, kinds: type | tuple[type, ...], what: str, allowed: str) -> None:
    """Refuse what is of another kind than wanted.

    Args:
        given: what was given.
        kinds: of which it has to be one.
        what: its name, for the message.
        allowed: what it may be, in words.

    Raises:
        InputError: it is of none of them.
    """
    if not isinstance(given, kinds):
        raise InputError(f"{what} = {reprlib.repr(given)} is not allowed; allowed: {allowed}")
