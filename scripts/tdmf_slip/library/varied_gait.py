"""How a gait changes with parameters: by the implicit function theorem, from derivatives of its stride."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import RunError
from .runner import Runner
from .varied_stride import varied_stride


@dataclass(frozen=True, eq=False)
class VariedGait:
    """Quantities of a gait, and how they and its apex change with parameters while it stays a gait."""

    quantities: NDArray[np.float64]
    """In the order in which they were asked for, shape (q,)."""
    by_parameters: NDArray[np.float64]
    """Their changes, shape (q, p)."""
    apex_by_parameters: NDArray[np.float64]
    """Those of the apex, shape (n, p)."""
    apex_by_residual: NDArray[np.float64]
    """Derivative of the apex by the residual of its stride: the inverse of the map less one, shape (n, n)."""


def varied_gait(
    runner: Runner, apex: NDArray[np.float64], names: Sequence[str], parameters: Sequence[str]
) -> VariedGait:
    """A gait, with the derivatives of its quantities and of its apex by parameters.

    By the implicit function theorem: with the return map P, dP/dz dz + dP/dp dp = dz along the gaits.
    """
    stride, count = varied_stride(runner, apex, names, parameters), len(apex)
    try:
        inverse: NDArray[Any] = np.linalg.inv(stride.by_all[:count, :count])
    except np.linalg.LinAlgError:
        inverse = np.full((count, count), np.inf)
    if not np.isfinite(inverse).all():
        raise RunError("the gait is where two meet, and has no derivatives")
    d_apex = -inverse @ stride.by_all[:count, count:]
    of_quantities = stride.by_all[count:]
    return VariedGait(
        quantities=stride.quantities,
        by_parameters=of_quantities[:, count:] + of_quantities[:, :count] @ d_apex,
        apex_by_parameters=d_apex,
        apex_by_residual=inverse,
    )
