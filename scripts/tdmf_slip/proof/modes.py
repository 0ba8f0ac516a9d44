"""Modes of the motion, and the numbers that describe it in each."""

from dataclasses import dataclass
from typing import Any, Literal

Contact = Literal["flight", "stick", "slip", "graze"]
LEG = ("length", "angle", "length_rate", "angle_rate")
BALLISTIC = ("height", "along", "off")
"""Centre of mass in flight: distance from the ground line, velocity along it and away from it."""
PARAMETER = "parameter"
"""Name of the varied parameter, which is carried along like a constant state."""


@dataclass(frozen=True)
class Mode:
    """Contact mode of the foot and phase of the hip."""

    contact: Contact
    """Contact mode of the foot."""
    sign: int = 0
    """Sign of the foot's velocity in slip."""
    places: bool = False
    """Off the ground: the hip is in place, else in retract."""
    drives: bool = False
    """The stance began with the foot ahead and the leg has not been upright yet."""
    clamped: bool = False
    """Retract with `hip.swing_clamp`: the servo's torque is negative, so the clamp holds it at 0."""
    rises: bool = False
    """Off the ground: an apex is to come."""
    thrusts: bool = False
    """The leg has been compressed most in this stance."""

    @property
    def letter(self) -> str:
        """Its letter in the gait word; empty for none."""
        return {"stick": "0", "slip": "+" if self.sign > 0 else "-"}.get(self.contact, "")

    @property
    def touches(self) -> bool:
        """The foot is on the ground and loaded."""
        return self.contact in ("stick", "slip")


def moving_names(runner: Any, mode: Mode) -> tuple[str, ...]:
    """Quantities that move along with the leg, by equations that are solved as series."""
    names: tuple[str, ...] = LEG
    if mode.contact in ("slip", "graze"):
        names += ("foot_speed",)
    if not mode.touches and mode.places and runner.retracts:
        names += ("clock",)
    return names


def kept_names(runner: Any, mode: Mode) -> tuple[str, ...]:
    """Quantities that stay as they are and matter."""
    names: tuple[str, ...] = ()
    if not mode.touches and not mode.places:
        names += ("latched_angle",)
    return (*names, PARAMETER) if runner.varied else names


def names_of(runner: Any, mode: Mode) -> tuple[str, ...]:
    """All numbers that tell the motion in a mode, in the order of the rows of its matrices."""
    free = BALLISTIC if mode.contact == "flight" else ()
    return moving_names(runner, mode) + kept_names(runner, mode) + free
