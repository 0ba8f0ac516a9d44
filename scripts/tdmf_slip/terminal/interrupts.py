"""Interrupts from the keyboard, held back where they would leave something half done."""

import contextlib
import dataclasses
import signal
import threading
from collections.abc import Callable, Iterator
from types import FrameType


@dataclasses.dataclass
class Interrupt:
    """One that may come while it is held back."""

    handler: Callable[[int, FrameType | None], object] | int | None
    """What it was meant for."""
    came: threading.Event = dataclasses.field(default_factory=threading.Event)
    """Set when it came."""

    def note(self, _number: int, _frame: object) -> None:
        """Handle the signal. An exception raised here could be lost: Python ignores those of finalizers."""
        self.came.set()

    def deliver(self) -> None:
        """Do what would have been done without this, if one came: by default, raise KeyboardInterrupt."""
        if self.came.is_set():
            self.came.clear()
            if callable(self.handler):
                self.handler(signal.SIGINT, None)


@contextlib.contextmanager
def held() -> Iterator[Interrupt]:
    """An interrupt that comes inside is delivered where it is asked for, and at the end."""
    handler = signal.getsignal(signal.SIGINT)
    interrupt = Interrupt(handler)
    if threading.current_thread() is not threading.main_thread() or not callable(handler):
        yield interrupt
        return
    signal.signal(signal.SIGINT, interrupt.note)
    try:
        yield interrupt
    finally:
        signal.signal(signal.SIGINT, handler)
        interrupt.deliver()


@contextlib.contextmanager
def kept_from_children() -> Iterator[None]:
    """Processes that begin inside get no interrupt, which a terminal sends to all: this one tells them."""
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    from multiprocessing import resource_tracker  # slow to load, and seldom needed

    resource_tracker.ensure_running()  # or it begins with the first process, and unblocks the signal
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
