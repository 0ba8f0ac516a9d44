"""Interrupts from the keyboard and requests to end, held back where they would leave something half done."""

import contextlib
import signal
import threading
from collections.abc import Iterator
from typing import NoReturn

ENDING = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name))
"""Requests to end: the signal of `kill`, and those of a terminal that is closed, on Windows too."""
SIGNALS = (signal.SIGINT, *ENDING)
"""An interrupt from the keyboard, and requests to end."""


@contextlib.contextmanager
def deferred() -> Iterator[None]:
    """Hold interrupts back inside the block; its end passes the last one on to its handler."""
    is_main = threading.current_thread() is threading.main_thread()
    found = {number: signal.getsignal(number) for number in (SIGNALS if is_main else ())}
    handlers = {number: handler for number, handler in found.items() if callable(handler)}
    arrived: list[int] = []
    for number in handlers:
        # An exception raised by a handler here could be lost: Python ignores those of finalizers.
        signal.signal(number, lambda number, _frame: arrived.append(number))
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
        if arrived:
            handlers[arrived[-1]](arrived[-1], None)


def end_in_order() -> None:
    """End in order on a request to end, so that no temporary file is left. Python would stop at once."""
    for number in ENDING:
        if signal.getsignal(number) == signal.SIG_DFL:  # nohup has SIGHUP ignored
            signal.signal(number, _end)


def _end(number: int, _frame: object) -> NoReturn:
    raise SystemExit(128 + number)  # exit status of a process that a signal ends, as shells give it


def ignored() -> None:
    """Ignore interrupts and requests to end from now on, because Python is already ending."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_IGN)
