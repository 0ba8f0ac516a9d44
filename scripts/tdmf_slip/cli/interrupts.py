"""Interrupts from the keyboard and requests to end, held back where they would leave something half done."""

import contextlib
import dataclasses
import signal
import threading
from collections.abc import Callable, Iterator, Mapping
from types import FrameType
from typing import NoReturn

Handler = Callable[[int, FrameType | None], object]
ENDING = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name))
"""Requests to end: what `kill` sends, and what comes when a terminal is closed, on Windows too."""
SIGNALS = (signal.SIGINT, *ENDING)
"""An interrupt from the keyboard, and requests to end."""


@dataclasses.dataclass
class Interrupt:
    """One that may come while it is held back."""

    handlers: Mapping[int, Handler]
    """Handlers by the number of the signal."""
    came: int | None = None
    """Number of the one that came last."""

    def record(self, number: int, _frame: object) -> None:
        """Handle the signal. An exception raised here could be lost: Python ignores those of finalizers."""
        self.came = number

    def deliver(self) -> None:
        """Do what would have been done without this, if one came: by default, raise KeyboardInterrupt."""
        number, self.came = self.came, None
        if number is not None:
            self.handlers[number](number, None)


@contextlib.contextmanager
def deferred() -> Iterator[Interrupt]:
    """An interrupt that comes inside is delivered where it is asked for, and at the end."""
    handlers = {number: signal.getsignal(number) for number in SIGNALS}
    interrupt = Interrupt({number: handler for number, handler in handlers.items() if callable(handler)})
    if threading.current_thread() is not threading.main_thread():
        yield interrupt
        return
    for number in interrupt.handlers:
        signal.signal(number, interrupt.record)
    try:
        yield interrupt
    finally:
        for number, handler in interrupt.handlers.items():
            signal.signal(number, handler)
        interrupt.deliver()


def end_in_order() -> None:
    """Have a request to end this process leave no temporary file: Python would stop where it is."""
    for number in ENDING:
        if signal.getsignal(number) == signal.SIG_DFL:  # nohup has SIGHUP ignored
            signal.signal(number, _end)


def _end(number: int, _frame: object) -> NoReturn:
    raise SystemExit(128 + number)  # exit status of a process that a signal ends, as shells give it


def ignored() -> None:
    """Neither interrupts nor requests to end are heard any more: Python ends, and is not to be disturbed."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_IGN)
