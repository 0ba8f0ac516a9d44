"""Modes of a stride, a runner's parameters as balls, and events that are taken as on one side of a border.

On a border between gait words, two events happen at once, and what follows is the same on both sides. The
stride of one side, continued also where the foot would do something else, is smooth across the border. The
border is where a further number, the margin of the event, vanishes.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal

from flint import arb

from ..pages.hip import PLACE, REST, RETRACT
from .dual import Dual, Number, UndecidedError, value_of
from .given import Exact
from .laws import NAMES_ON_PAGE, Motion

Contact = Literal["flight", "stick", "slip", "graze"]
LEG = ("length", "angle", "length_rate", "angle_rate")
BALLISTIC = ("clearance", "along", "off")
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
    """True if, off the ground, the hip is in place; else it is in retract."""
    drives: bool = False
    """True if the stance began with the foot ahead, and the leg has not been upright yet."""
    clamped: bool = False
    """True in retract with `hip.swing_clamp` if the servo's torque is negative: the clamp holds it at 0."""
    rises: bool = False
    """True if, off the ground, an apex is to come."""
    thrusts: bool = False
    """True once the leg has been compressed most in this stance."""

    @property
    def letter(self) -> str:
        """The mode's letter in the gait word; empty for none."""
        return {"stick": "0", "slip": "+" if self.sign > 0 else "-"}.get(self.contact, "")

    @property
    def touches(self) -> bool:
        """The foot is on the ground and loaded."""
        return self.contact in ("stick", "slip")


def moving_names(runner: Any, mode: Mode) -> tuple[str, ...]:
    """Quantities that move along with the leg, by equations that are solved as series."""
    names: tuple[str, ...] = LEG
    if mode.contact in ("slip", "graze"):
        names += ("foot_vx",)
    if not mode.touches and mode.places and runner.retracts:
        names += ("placing",)
    return names


def kept_names(runner: Any, mode: Mode) -> tuple[str, ...]:
    """Quantities that stay as they are and matter."""
    names: tuple[str, ...] = ()
    if not mode.touches and not mode.places:
        names += ("liftoff_angle",)
    return (*names, PARAMETER) if runner.is_varied else names


def names_of(runner: Any, mode: Mode) -> tuple[str, ...]:
    """All numbers that describe the motion in a mode, in the order of the rows of its matrices."""
    free = BALLISTIC if mode.contact == "flight" else ()
    return moving_names(runner, mode) + kept_names(runner, mode) + free


Kind = Literal["rest at the limit of the cone", "rest as it lifts off", "impact at the limit of the cone"]


@dataclass(frozen=True)
class Forced:
    """An event, and how it is taken."""

    index: int
    """Index among the stride's events, from 0 on."""
    event: str
    """Name of the event."""
    kind: Kind
    """Kind of the two events that happen at once there."""
    sign: int = 0
    """Sign of the slip with which a foot at the limit of the cone goes on."""

    @property
    def rival(self) -> str:
        """The guard that vanishes together with the event's; empty for none."""
        return "end of slip" if self.kind == "rest as it lifts off" else ""


LONGEST_STEP = 1.0
"""Longest step, in units of sqrt(m/k)."""
MAX_LEG_ROTATION = 10.0
"""Largest rotation of the leg in a step in flight; for longer steps no bound of the variations holds."""


class Parameters:
    """Exact values, of which one may be varied."""

    def __init__(self, values: Mapping[str, Exact], varied: str | None = None) -> None:
        """The values by the unit's names, and the name of the one that is varied."""
        self.values, self.varied = values, varied

    def balls(self, parameter: arb | None = None, *, dual: bool = False) -> Any:
        """The runner as a `Motion` without numbers of its motion: see `at`."""
        numbers: dict[str, Number] = {
            name: self.values[name].ball() for name in NAMES_ON_PAGE if name in self.values
        }
        if self.varied is not None:
            value = numbers[self.varied] if parameter is None else parameter
            numbers[self.varied] = Dual(value, {PARAMETER: arb(1)}) if dual else value
        runner = Motion.at(
            "flight", wind="calm", **{NAMES_ON_PAGE[name]: number for name, number in numbers.items()}
        )
        vars(runner).update(self._derived(runner))
        return runner

    def _matters(self, name: str, none: int = 0) -> bool:
        """True if a parameter is varied, or differs from the value at which it has no effect."""
        return name == self.varied or self.values[name] != Exact(Fraction(none))

    def _derived(self, runner: Any) -> dict[str, Any]:
        """Attributes of the runner that follow from its parameters alone."""
        matters, thrust = self._matters, value_of(runner.thrust + runner.more_thrust)
        if not (thrust > 0 or thrust <= 0):
            raise UndecidedError("the sign of the leg's thrust")
        mobility = 1 / value_of(runner.body_mass) + 1 / value_of(runner.foot_mass)
        stiffness, damping = value_of(runner.stiffness), value_of(runner.damping)
        swing = float((stiffness * mobility).sqrt())
        time = float((value_of(runner.body_mass) / stiffness).sqrt())
        length = float(value_of(runner.free_length))
        has_servo = matters("hip.kp") or matters("hip.kd")
        speed = length / time
        return {
            "slope": runner.ground_slope,
            "has_thrust": bool(thrust > 0),
            "falls_with_speed": matters("ground.stribeck_velocity"),
            "is_stickier": matters("ground.static_friction_ratio", 1),
            "retracts": matters("hip.retraction_rate"),
            "has_servo": has_servo,
            "has_clamp": has_servo and self.values["hip.swing_clamp"].rational != 0,
            "is_varied": self.varied is not None,
            "longest_step": min(LONGEST_STEP * time, MAX_LEG_ROTATION / (swing + float(damping * mobility))),
            "swing_frequency": swing,
            "energy_scale": runner.scales["J"](runner),
            "sizes": {"length": length, "length_rate": speed, "angle_rate": 1.0 / time, "foot_vx": speed}
            | {"clearance": length, "along": speed, "off": speed},
        }


def at(runner: Any, mode: Mode, values: Mapping[str, Number]) -> Any:
    """The runner at an instant of a mode, with these numbers of its motion."""
    found: Any = object.__new__(Motion)
    swing = PLACE if mode.places else REST if mode.clamped else RETRACT
    vars(found).update(vars(runner), mode=mode.contact, way=mode.sign, swing=swing, **values)
    vars(found).update(driving=int(mode.drives), thrusting=int(mode.thrusts), rises_again=int(mode.rises))
    vars(found).update(law="falling" if runner.falls_with_speed else "constant")
    return found
