"""The apex section of the return map: six coordinates, and the start values that put a runner there."""

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np

from ..errors import InputError
from .unit import Unit

COORDINATES = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
"""Names in the unit's group `apex`; the horizontal position is dropped, the vertical velocity is zero."""

MOVING = (
    "body.mass",
    "foot.mass",
    "foot.y",
    "foot.vx",
    "leg.length",
    "leg.angle",
    "leg.length_rate",
    "leg.angle_rate",
)
"""What a section follows from."""
NOTHING: Mapping[str, float] = MappingProxyType({})


def value(unit: Unit, starts: Mapping[str, float | bool], name: str) -> float:
    """A start value, given in `starts` or the unit's own."""
    return starts.get(name, unit.start_of(name))


def scales(unit: Unit, starts: Mapping[str, float | bool] = NOTHING) -> tuple[float, ...]:
    """Scales of the coordinates: l0, l0 sqrt(k/m), l0, 1 rad, l0 sqrt(k/m), sqrt(k/m)."""
    length = value(unit, starts, "leg.free_length")
    rate = math.sqrt(value(unit, starts, "leg.stiffness") / value(unit, starts, "body.mass"))
    return length, length * rate, length, 1.0, length * rate, rate


def apex_of(values: Mapping[str, float]) -> tuple[float, ...]:
    """The section that has a motion's height, forward speed and leg; the way back from `start_values`.

    Parameters
    ----------
    values : Mapping[str, float]
        States and masses, by the unit's names.

    Raises
    ------
    InputError
        One is missing.
    """
    missing = next((name for name in MOVING if name not in values), None)
    if missing is not None:
        raise InputError(f"values: {missing} is missing; allowed: all of {', '.join(MOVING)}")
    length, angle = values["leg.length"], values["leg.angle"]
    length_rate, angle_rate = values["leg.length_rate"], values["leg.angle_rate"]
    rho = values["body.mass"] / (values["body.mass"] + values["foot.mass"])
    sine, cosine = math.sin(angle), math.cos(angle)
    height = values["foot.y"] + rho * length * cosine
    speed = values["foot.vx"] - rho * (length_rate * sine + length * angle_rate * cosine)
    return height, speed, length, angle, length_rate, angle_rate


def start_values(
    unit: Unit, apex: Sequence[float], starts: Mapping[str, float | bool] = NOTHING
) -> dict[str, float]:
    """Start values of the eight mechanical states at an apex, with the centre of mass at x = 0.

    From the body's place (7) follows x_c = x - rho r sin theta and y_c = y + rho r cos theta, where
    rho = m / (m + m_f); their rates are (com_speed, 0).

    Parameters
    ----------
    unit : Unit
        The unit whose masses serve where `starts` has none.
    apex : Sequence[float]
        The six coordinates, in the order of `COORDINATES` and the unit's units.
    starts : Mapping[str, float | bool], default NOTHING
        Start values of the same run, for its masses.

    Raises
    ------
    InputError
        Not six coordinates.
    """
    if np.shape(apex) != (len(COORDINATES),):
        raise InputError(f"an apex of shape {np.shape(apex)}: allowed: {', '.join(COORDINATES)}")
    height, speed, length, angle, length_rate, angle_rate = apex
    mass, foot = value(unit, starts, "body.mass"), value(unit, starts, "foot.mass")
    rho = mass / (mass + foot)
    sine, cosine = math.sin(angle), math.cos(angle)
    return {
        "foot.x": rho * length * sine,
        "foot.y": height - rho * length * cosine,
        "leg.length": length,
        "leg.angle": angle,
        "foot.vx": speed + rho * (length_rate * sine + length * angle_rate * cosine),
        "foot.vy": -rho * (length_rate * cosine - length * angle_rate * sine),
        "leg.length_rate": length_rate,
        "leg.angle_rate": angle_rate,
    }
