"""The ensemble engine at work, in a thread of its own, so that an interrupt is heard and ends it."""

import threading
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import StoppedError
from .binding import c, ffi
from .structs import Ensemble

ENGINE = "tdmf_slip ensemble"
"""Name of the thread beside."""
FEW = 64
"""Runners that are followed without a thread of their own: they take milliseconds."""
LOOKING_UP = 0.1
"""Seconds after which a wait for the engine looks whether an interrupt came."""


def run(ensemble: Ensemble, ends: NDArray[np.void]) -> Any:
    """Run a request whose values are checked.

    Parameters
    ----------
    ensemble : Ensemble
        The library's `tdmf_ensemble *`.
    ends : structured ndarray, shape (runners,)
        Of the type `END`: what became of each runner is written there.

    Returns
    -------
    Struct
        The library's `tdmf_ensemble_work *`.

    Raises
    ------
    MemoryError
        There is no memory.
    """
    work = ffi.new("tdmf_ensemble_work *")
    if threading.current_thread() is threading.main_thread() and len(ends) > FEW:
        complete = _run_beside(ensemble, ends, work)
    else:
        complete = c.tdmf_run_ensemble(ensemble, _c_ends(ends), work)
    if not complete:
        raise MemoryError("the ensemble engine found no memory")
    return work


def _c_ends(ends: NDArray[np.void]) -> object:
    return ffi.cast("tdmf_ensemble_end *", ffi.from_buffer(ends))


def _run_beside(ensemble: Ensemble, ends: NDArray[np.void], work: Any) -> bool:
    """In another thread: this one hears interrupts, and stops it."""
    stop, done, found = ffi.new("int *", 0), threading.Event(), []

    def engine() -> None:
        try:
            found.append(c.tdmf_run_ensemble(ensemble, _c_ends(ends), work))
        finally:
            done.set()

    ensemble.stop = stop
    try:
        threading.Thread(target=engine, name=ENGINE, daemon=True).start()
        came = _wait(done, stop)
    finally:
        stop[0] = 1
        ensemble.stop = ffi.NULL
    if isinstance(came, KeyboardInterrupt):
        raise StoppedError(ends[: work.begun]) from None
    if came is not None:
        raise came
    return bool(found and found[0])


def _wait(done: threading.Event, stop: Any) -> BaseException | None:
    """Until the engine is done, and what came meanwhile, which stops it."""
    came = None
    while not done.is_set():
        try:
            done.wait(LOOKING_UP)
        except BaseException as problem:  # a second interrupt changes nothing
            came, stop[0] = problem, 1
    return came
