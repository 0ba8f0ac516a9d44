"""The apex section of the return map: its six coordinates."""

import reprlib
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError

COORDINATES = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
"""Names in the unit's group `apex`; the horizontal position is dropped, the vertical velocity is zero."""

Apex = Sequence[float] | NDArray[np.float64]
"""Six coordinates, in the order of `COORDINATES` and the unit's units: m, m/s, m, rad, m/s, rad/s."""


def checked_apex(apex: Apex) -> NDArray[np.float64]:
    """An apex as an array.

    Parameters
    ----------
    apex : sequence of float, shape (6,)
        In the order of `COORDINATES`.

    Returns
    -------
    ndarray of float, shape (6,)
        The same numbers.

    Raises
    ------
    InputError
        There are not six of them, or they are no numbers.
    """
    if np.shape(apex) != (len(COORDINATES),):
        raise InputError(f"an apex of shape {np.shape(apex)}: allowed: {', '.join(COORDINATES)}")
    try:
        return np.array([float(value) for value in apex])
    except (TypeError, ValueError):
        raise InputError(f"an apex {reprlib.repr(apex)}: allowed: six numbers") from None
