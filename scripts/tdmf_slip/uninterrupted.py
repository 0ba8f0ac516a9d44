"""Work that an interrupt from the keyboard stops through a flag instead of an exception in its middle.

Python runs signal handlers in the main thread only, between two of its instructions. So the work is done in
a thread beside, and the main thread waits. No handler is replaced.
"""

from __future__ import annotations

import _thread
import contextvars
import sys
import threading
from array import array
from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar

Result = TypeVar("Result")
Flag: TypeAlias = "array[int]"
"""One number, 1 where it is raised; C reads it as an `int *`."""

LOOKING_UP = 0.1
"""Seconds after which a wait hears interrupts, on systems where they do not end it."""


_this_thread = threading.local()


def stop_flag() -> Flag:
    """Flag that stops work in this thread: one that `stops_by` was given here, or else a new one."""
    flag: Flag = getattr(_this_thread, "flag", None) or array("i", [0])
    return flag


def stops_by(flag: Flag) -> None:
    """Have whatever is done in this thread stop when a flag is raised."""
    _this_thread.flag = flag


def uninterrupted(work: Callable[[], Result], flag: Flag | None = None) -> Result:
    """Do work to its end, or until it stops because `flag[0]` is 1. Raise what came meanwhile only then.

    In other threads than the main one no interrupts come, and the work is done there.
    """
    if threading.get_ident() != threading.main_thread().ident:
        return work()
    flag = stop_flag() if flag is None else flag
    outcome: list[tuple[Result, None] | tuple[Any, BaseException]] = []
    interrupt: BaseException | None = None
    ended, context, callers = threading.Lock(), contextvars.copy_context(), sys._getframe(1)

    def beside() -> None:
        _ = callers  # keeps alive what C points to, should one more interrupt end the wait itself
        stops_by(flag)
        try:
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
    finally:
        flag[0] = 1
    result, failure = outcome[0]
    if (raised := interrupt or failure) is not None:
        raise raised
    return result
