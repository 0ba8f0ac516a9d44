"""Dimensions of the units that quantities are in: the one table that scales and labels are made of."""

from collections.abc import Mapping

DIMENSIONS: Mapping[str, tuple[int, int, int]] = {
    "1": (0, 0, 0),
    "rad": (0, 0, 0),
    "m": (1, 0, 0),
    "s": (0, 1, 0),
    "kg": (0, 0, 1),
    "m/s": (1, -1, 0),
    "m/s2": (1, -2, 0),
    "rad/s": (0, -1, 0),
    "Hz": (0, -1, 0),
    "rad/s2": (0, -2, 0),
    "N": (1, -2, 1),
    "N/m": (0, -2, 1),
    "N.s/m": (0, -1, 1),
    "N.m": (2, -2, 1),
    "N.m/rad": (2, -2, 1),
    "N.m.s/rad": (2, -1, 1),
    "J": (2, -2, 1),
    "W": (2, -3, 1),
    "N2.m2.s": (4, -3, 2),
}
"""Powers of length, time and mass; an angle has none."""


def scale(unit: str, length: float, time: float, mass: float) -> float:
    """How large a unit's quantities are where length, time and mass are so large."""
    of_length, of_time, of_mass = DIMENSIONS[unit]
    return length**of_length * time**of_time * mass**of_mass
