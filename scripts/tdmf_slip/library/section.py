"""The apex section of the return map: apices as arrays."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..checks import check_names
from ..errors import InputError
from ..given import numbers_by
from ..variables.table import MODELS

COORDINATES, REDUCED = (MODELS[name].coordinates for name in ("full", "reduced"))
"""Names in the unit's group `apex`: those of the full model, and those that the reduced map has."""

Apex = Sequence[float] | NDArray[np.float64]
"""Coordinates in the order and the units of a model's section."""


def checked_apex(apex: Apex, coordinates: Sequence[str] = COORDINATES) -> NDArray[np.float64]:
    """An apex as an array."""
    values = numbers_by("an apex", apex, coordinates)
    if values.shape != (len(coordinates),):
        raise InputError(f"an apex of shape {values.shape}: allowed: {', '.join(coordinates)}")
    return values


def check_axes(axes: Sequence[str], coordinates: Sequence[str] = COORDINATES) -> None:
    """Refuse names that are not those of coordinates of the section."""
    check_names(axes, coordinates, "axes")
