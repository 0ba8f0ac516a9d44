"""Work that an interrupt from the keyboard stops through a flag instead of an exception in its middle.

Python runs signal handlers in the main thread only, between two of its instructions. So the work runs in
another thread while the main thread waits. No handler is replaced.
"""

from __future__ import annotations

import _thread
import contextlib
import contextvars
import sys
import threading
from array import array
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias, TypeVar

Result = TypeVar("Result")
Flag: TypeAlias = "array[int]"
"""One number, 1 where it is raised; C reads it as an `int *`."""

LOOKING_UP = 0.1
"""Seconds after which a wait hears interrupts, on systems where they do not end it."""


_this_thread = threading.local()


def new_flag() -> Flag:
    """A flag that is not raised."""
    return array("i", [0])


def stop_flag() -> Flag:
    """The flag that stops work in this thread, see `stopped_by`; elsewhere a new one."""
    flag: Flag | None = getattr(_this_thread, "flag", None)
    return new_flag() if flag is None else flag


def in_block() -> bool:
    """True if this thread runs one block of many, which must leave the other processors alone."""
    return getattr(_this_thread, "flag", None) is not None


def check_stop() -> None:
    """Raise KeyboardInterrupt where the flag of this thread is raised."""
    flag: Flag | None = getattr(_this_thread, "flag", None)
    if flag is not None and flag[0]:
        raise KeyboardInterrupt


@contextlib.contextmanager
def stopped_by(flag: Flag) -> Iterator[None]:
    """Context in which work of this thread stops when a flag is raised."""
    before = getattr(_this_thread, "flag", None)
    _this_thread.flag = flag
    try:
        yield
    finally:
        _this_thread.flag = before


def uninterrupted(work: Callable[[], Result], flag: Flag | None = None) -> Result:
    """Do work to its end, or until it stops because `flag[0]` is 1. Raise what came meanwhile only then.

    In other threads than the main one no interrupts come, and the work runs there.
    """
    if threading.get_ident() != threading.main_thread().ident:
        return work()
    flag = stop_flag() if flag is None else flag
    outcome: list[tuple[Result, None] | tuple[Any, BaseException]] = []
    interrupt: BaseException | None = None
    ended, context, callers = threading.Lock(), contextvars.copy_context(), sys._getframe(1)

    def beside() -> None:
        _ = callers  # keeps alive what C points to, should one more interrupt end the wait itself
        try:
            with stopped_by(flag):
                outcome.append((context.run(work), None))
        except BaseException as problem:  # raised again where the work is waited for
            outcome.append((None, problem))
        finally:
            ended.release()

    ended.acquire()
    try:
        _thread.start_new_thread(beside, ())  # `threading` waits for locks, which an interrupt leaves held
        while not outcome:
            try:
                while not ended.acquire(timeout=LOOKING_UP):
                    pass
            except BaseException as problem:  # what the host's handler raises; no call before the flag is set
                interrupt, flag[0] = problem, 1
    except BaseException:
        flag[0] = 1
        raise
    result, failure = outcome[0]
    if (raised := interrupt or failure) is not None:
        raise raised
    return result
