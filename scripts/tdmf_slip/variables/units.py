"""Units: quantities as texts such as `20 kN/m`, and labels in the paper's units.

It needs nothing but Python's standard library, because the live page's generator reads it too.
"""

import math
import re
from collections.abc import Mapping

OTHER_UNITS: Mapping[str, tuple[str, float]] = {
    "cm": ("m", 100.0),
    "mm": ("m", 1000.0),
    "g": ("kg", 1000.0),
    "ms": ("s", 1000.0),
    "km/h": ("m/s", 3.6),
    "kN": ("N", 0.001),
    "kN/m": ("N/m", 0.001),
    "N/mm": ("N/m", 0.001),
    "degree": ("rad", 180.0 / math.pi),
    "degrees": ("rad", 180.0 / math.pi),
    "deg": ("rad", 180.0 / math.pi),
}
"""Units that people write beside those of the description, each with its SI unit and how many of it make one
SI unit."""
_SPELLINGS = {"·": ".", "*": ".", "²": "2", "^": "", "°": "deg"}
_NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(.*)", re.DOTALL)


def split(text: str) -> tuple[str, str]:
    """The number and the unit of a text, both as texts; no unit is an empty one."""
    found = _NUMBER.fullmatch(text)
    if found is None:
        return text, ""
    return found[1], spelled(found[2])


def spelled(unit: str) -> str:
    """A unit as the description spells it: `N.s/m` for `N s/m` and `N·s/m`, `m/s2` for `m/s²`."""
    for other, own in _SPELLINGS.items():
        unit = unit.replace(other, own)
    return ".".join(unit.split())


def factor(unit: str, own: str, display_units: Mapping[str, float]) -> float | None:
    """How many of a unit make one of a variable's own unit; None if the unit has another dimension."""
    if unit in ("", own):
        return 1.0
    other, number = OTHER_UNITS.get(unit, ("", 1.0))
    return number if other == own and own else display_units.get(unit)


def paper_label(length: int, time: int, mass: int) -> str:
    """Label in the paper's units of a product of powers: `l0 sqrt(k/m)` for a speed, empty for a number."""
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
