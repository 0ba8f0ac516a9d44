"""The apex section of the return map: its six coordinates."""

import reprlib
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError

COORDINATES = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
"""Names in the unit's group `apex`; the horizontal position is dropped, the vertical velocity is zero."""

REDUCED = COORDINATES[:2]
"""Those that the reduced map has."""

MODELS: Mapping[str, tuple[str, ...]] = {"full": COORDINATES, "reduced": REDUCED}
"""What goes from apex to apex: the return map of the full model, or the reduced map; and its coordinates."""

Apex = Sequence[float] | NDArray[np.float64]
"""Six coordinates, in the order of `COORDINATES` and the unit's units: m, m/s, m, rad, m/s, rad/s."""


def checked_apex(apex: Apex, coordinates: Sequence[str] = COORDINATES) -> NDArray[np.float64]:
    """An apex as an array.

    Parameters
    ----------
    apex : sequence of float, shape (n,)
        In the order of the coordinates.
    coordinates : sequence of str, shape (n,), default COORDINATES
        Which an apex has: `REDUCED` in the reduced map.

    Returns
    -------
    ndarray of float, shape (n,)
        The same numbers.

    Raises
    ------
    InputError
        There are not so many, or they are no numbers.
    """
    if np.shape(apex) != (len(coordinates),):
        raise InputError(f"an apex of shape {np.shape(apex)}: allowed: {', '.join(coordinates)}")
    try:
        return np.array([float(value) for value in apex])
    except (TypeError, ValueError):
        raise InputError(
            f"an apex {reprlib.repr(apex)}: allowed: numbers for {', '.join(coordinates)}"
        ) from None


def check_axes(axes: Sequence[str], coordinates: Sequence[str] = COORDINATES) -> None:
    """Refuse names that are not those of coordinates of the section.

    Parameters
    ----------
    axes : sequence of str
        What was given as names.
    coordinates : sequence of str, optional
        Those that there are.

    Raises
    ------
    InputError
        One is not.
    """
    wrong = next((axis for axis in axes if axis not in coordinates), None)
    if wrong is not None:
        raise InputError(f"axes: {wrong!r} is not allowed; allowed: {', '.join(coordinates)}")
