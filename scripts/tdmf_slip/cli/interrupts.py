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
"""Requests to end: the signal of `kill`, and those of a terminal that is closed, on Windows too."""
SIGNALS = (signal.SIGINT, *ENDING)
"""An interrupt from the keyboard, and requests to end."""


@dataclasses.dataclass
class Interrupt:
    """An interrupt or a request to end that may arrive while it is held back."""

    handlers: Mapping[int, Handler]
    """Handlers by the number of the signal."""
    arrived: int | None = None
    """Number of the last signal that arrived."""

    def record(self, number: int, _frame: object) -> None:
        """Record the signal. An exception raised here could be lost: Python ignores those of finalizers."""
        self.arrived = number

    def deliver(self) -> None:
        """Call the original handler if a signal arrived; that of Python raises KeyboardInterrupt."""
        number, self.arrived = self.arrived, None
        if number is not None:
            self.handlers[number](number, None)


@contextlib.contextmanager
def deferred() -> Iterator[Interrupt]:
    """Hold interrupts back inside the block; `deliver` and the end of the block pass them on."""
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
