"""The ensemble engine at work, in a thread of its own, so that an interrupt is heard and ends it."""

import threading
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import StoppedError
from ..terminal import interrupts
from .binding import c, ffi
from .structs import Ensemble

ENGINE = "tdmf_slip ensemble"
"""Name of the thread beside."""
FEW = 64
"""Runners that are followed without a thread of their own: they take milliseconds."""
LOOKING_UP = 0.1
"""Seconds after which a wait for the engine looks whether an interrupt came."""


def run(ensemble: Ensemble, ends: NDArray[np.void]) -> Any:
    """Run a request whose values are checked."""
    work = ffi.new("tdmf_ensemble_work *")
    if threading.current_thread() is threading.main_thread() and len(ends) > FEW:
        complete = _run_beside(ensemble, ends, work)
    else:
        complete = c.tdmf_run_ensemble(ensemble, _c_ends(ends), work)
    if not complete:
        raise MemoryError("the ensemble engine found no memory, or its request was not sound")
    return work


def _c_ends(ends: NDArray[np.void]) -> object:
    return ffi.cast("tdmf_ensemble_end *", ffi.from_buffer(ends))


def _run_beside(ensemble: Ensemble, ends: NDArray[np.void], work: Any) -> bool:
    """In another thread: this one hears interrupts, and stops it."""
    stop, ended, results = ffi.new("int *", 0), threading.Lock(), []

    def engine() -> None:
        ensemble.stop = stop
        complete = False
        try:
            complete = bool(c.tdmf_run_ensemble(ensemble, _c_ends(ends), work))
        finally:
            ensemble.stop = ffi.NULL
            results.append(complete)
            ended.release()

    ended.acquire()
    try:
        with interrupts.deferred() as interrupt:
            threading.Thread(target=engine, name=ENGINE, daemon=True).start()
            problem = _wait(results, ended, interrupt, stop)
    finally:
        stop[0] = 1
    if isinstance(problem, KeyboardInterrupt):
        raise StoppedError(ends[: work.begun]) from None
    if problem is not None:
        raise problem
    return results[0]


def _wait(
    results: list[bool], ended: threading.Lock, interrupt: interrupts.Interrupt, stop: Any
) -> BaseException | None:
    """Until the engine has its result, and what an interrupt raised meanwhile, which stops it.

    Interrupts are held back, for one that is raised inside of `threading` may leave a lock held for ever.
    """
    raised = None
    while not results:
        ended.acquire(timeout=LOOKING_UP)
        try:
            interrupt.deliver()
        except BaseException as problem:  # a second interrupt changes nothing
            raised, stop[0] = problem, 1
    return raised
