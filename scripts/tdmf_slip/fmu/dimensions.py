"""Dimensions of the units that quantities are in: the one table that scales and labels are made of.

It needs nothing but Python's standard library, because the live page's generator reads it too.
"""

import math
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


def paper_unit(unit: str) -> str:
    """Label of a unit in the paper's units: `l0 sqrt(k/m)` for `m/s`, empty for `1`."""
    length, time, mass = DIMENSIONS[unit]
    if (length, time, mass) == (0, 0, 0):
        return unit
    stiffness_power, mass_power = -0.5 * time, mass + 0.5 * time
    roots = {"k": 0.0, "m": 0.0}
    if time % 2:  # both powers are halves
        roots = {"k": math.copysign(0.5, stiffness_power), "m": math.copysign(0.5, mass_power)}
    powers = {"k": stiffness_power - roots["k"], "m": mass_power - roots["m"], "l0": float(length)}
    root = _fraction({name: 2.0 * power for name, power in roots.items()}, "")
    return _fraction(powers, f"sqrt({root})" if root else "")


def _fraction(powers: Mapping[str, float], last: str) -> str:
    """A product of powers with a fraction bar before the negative ones."""
    above = [_power(name, power) for name, power in powers.items() if power > 0.0]
    below = [_power(name, -power) for name, power in powers.items() if power < 0.0]
    product = " ".join([*above, *([last] if last else [])])
    return f"{product or 1}/{' '.join(below)}" if below else product


def _power(name: str, power: float) -> str:
    return name if power == 1.0 else f"{name}^{power:g}"
