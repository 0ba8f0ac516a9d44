"""One stride with its quantities, and how they change with its apex and with parameters, exactly."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from ..variables.table import FRICTION
from .batch import Batch
from .maps import why_no_return
from .members import check_comes_down, check_has_gaits
from .quantities import check_quantities
from .runner import Runner
from .tables import Table


@dataclass(frozen=True, eq=False)
class VariedStride:
    """A stride, and how it changes with its apex and with parameters."""

    residual: NDArray[np.float64]
    """Next apex minus this one, shape (n,)."""
    quantities: NDArray[np.float64]
    """In the order in which they were asked for, shape (q,)."""
    by_all: NDArray[np.float64]
    """Changes of `residual` and `quantities` by the coordinates and the parameters, shape (n + q, n + p)."""


def varied_stride(
    runner: Runner, apex: NDArray[np.float64], names: Sequence[str], parameters: Sequence[str]
) -> VariedStride:
    """One stride from an apex, whether it leads back there or not, with all its derivatives."""
    stride = _stride(runner, apex, names, True, parameters)
    by_apex = stride.next_apex_by - np.eye(*stride.next_apex_by.shape)
    by_all = np.vstack([by_apex, *(stride[f"{name}_by"] for name in names)])
    if not np.isfinite(by_all).all():
        raise RunError("a stride is on the edge of an event or of a law, where it has no derivatives")
    return VariedStride(stride.next_apex - apex, np.array([stride[name] for name in names]), by_all)


@dataclass(frozen=True, eq=False)
class PlainStride:
    """A stride without derivatives."""

    residual: NDArray[np.float64]
    """Next apex minus this one, shape (n,)."""
    quantities: NDArray[np.float64]
    """In the order in which they were asked for, shape (q,)."""
    word: str
    """Word of the stride's stance."""


def plain_stride(runner: Runner, apex: NDArray[np.float64], names: Sequence[str]) -> PlainStride:
    """One stride from an apex, whether it leads back there or not; with derivatives it takes much longer."""
    stride = _stride(runner, apex, names, False)
    quantities = np.array([float(stride[name]) for name in names])
    return PlainStride(stride.next_apex - apex, quantities, str(stride.word))


def _stride(
    runner: Runner,
    apex: NDArray[np.float64],
    names: Sequence[str],
    derivatives: bool,
    parameters: Sequence[str] = (),
) -> Table:
    check_quantities(runner, names)
    check_has_gaits(runner[FRICTION])
    check_comes_down(runner)
    stride = Batch(runner, apex).stride(derivatives, parameters)
    why_not = why_no_return(stride)
    if why_not is not None:
        raise RunError(why_not)
    return stride
