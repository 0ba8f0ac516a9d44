"""The ensemble engine at work. A flag ends it: raised by an interrupt, or by whoever started this thread."""

from typing import Any

from numpy import void
from numpy.typing import NDArray

from ..errors import StoppedError
from ..uninterrupted import stop_flag, uninterrupted
from .binding import c, ffi
from .structs import Ensemble

FEW = 64
"""Strides that are made without a thread beside: they take milliseconds."""


def run(ensemble: Ensemble, ends: NDArray[void], strides: int) -> Any:
    """Run a request whose values are checked. No runner makes more than so many strides."""
    work = ffi.new("tdmf_ensemble_work *")
    flag = stop_flag()

    def engine() -> bool:
        ensemble.stop = ffi.from_buffer("int[]", flag)
        try:
            complete = bool(c.tdmf_run_ensemble(ensemble, c_ends, work))
        finally:
            ensemble.stop = ffi.NULL
        if flag[0]:
            raise KeyboardInterrupt
        return complete

    c_ends = ffi.cast("tdmf_ensemble_end *", ffi.from_buffer(ends))
    try:
        complete = engine() if len(ends) * strides <= FEW else uninterrupted(engine, flag)
    except KeyboardInterrupt:
        raise StoppedError(ends[: work.begun]) from None
    if not complete:
        raise MemoryError("the ensemble engine found no memory, or its request was not sound")
    return work
