"""The apex section of the return map: its six coordinates."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from ..checks import is_one_of, shown
from ..errors import InputError
from ..given import numbers_by

COORDINATES = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
"""Names in the unit's group `apex`; the horizontal position is dropped, the vertical velocity is zero."""

REDUCED = COORDINATES[:2]
"""Those that the reduced map has."""

MODELS: Mapping[str, tuple[str, ...]] = {"full": COORDINATES, "reduced": REDUCED}
"""What goes from apex to apex: the return map of the full model, or the reduced map; and its coordinates."""

Apex = Sequence[float] | NDArray[np.float64]
"""Six coordinates, in the order of `COORDINATES` and the unit's units: m, m/s, m, rad, m/s, rad/s."""


def checked_apex(apex: Apex, coordinates: Sequence[str] = COORDINATES) -> NDArray[np.float64]:
    """An apex as an array."""
    values = numbers_by("an apex", apex, coordinates)
    if values.shape != (len(coordinates),):
        raise InputError(f"an apex of shape {values.shape}: allowed: {', '.join(coordinates)}")
    return values


def check_axes(axes: Sequence[str], coordinates: Sequence[str] = COORDINATES) -> None:
    """Refuse names that are not those of coordinates of the section."""
    for axis in axes:
        if not is_one_of(axis, coordinates):
            raise InputError(f"axes: {shown(axis)} is not allowed; allowed: {', '.join(coordinates)}")


def is_reduced(model: object) -> bool:
    """Whether a model, one of `MODELS`, is the reduced one."""
    if not is_one_of(model, MODELS):
        raise InputError(f"model {shown(model)} is not allowed; allowed: {', '.join(MODELS)}")
    return model == "reduced"
