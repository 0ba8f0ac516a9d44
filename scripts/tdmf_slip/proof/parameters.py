"""A runner's parameters as balls, as the laws take them.

An event that is taken as it would be on one side of a border between gait words.

On the border two things happen at once, and what follows is the same on both sides. The stride of one side,
taken also where it is not what the foot does, is smooth across the border; the border is where a further
number, the margin of the event, vanishes.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import SimpleNamespace as Record
from typing import Any, Literal

from flint import arb

from ..equations import free_fall, ground_force, ground_line
from ..equations.runner import derived
from .dual import Dual, Number, value_of
from .given import Exact

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
"""In units of sqrt(m/k)."""
MAX_LEG_ROTATION = 10.0
"""Largest rotation of the leg in a step in flight; for longer steps no bound of the variations holds."""


class Parameters:
    """Exact values, of which one may be varied."""

    def __init__(self, values: Mapping[str, Exact], varied: str | None = None) -> None:
        """The values by the unit's names, and the name of the one that is varied."""
        self.values, self.varied = values, varied

    def balls(self, parameter: arb | None = None, *, dual: bool = False) -> Any:
        """The record that the laws take."""
        numbers: dict[str, Number] = {name: value.ball() for name, value in self.values.items()}
        if self.varied is not None:
            value = numbers[self.varied] if parameter is None else parameter
            numbers[self.varied] = Dual(value, {PARAMETER: arb(1)}) if dual else value
        return _record(numbers, self.values, self.varied)


def _record(of: Mapping[str, Number], exact: Mapping[str, Exact], varied: str | None) -> Any:
    """The laws' names of the unit's variables, and what follows from them once."""

    def matters(name: str, none: int = 0) -> bool:
        return name == varied or exact[name] != Exact(Fraction(none))

    has_servo = matters("hip.kp") or matters("hip.kd")
    slope = of["ground.slope"]
    line = Record(height=of["ground.height"], slope=slope, sine=slope.sin(), cosine=slope.cos())
    masses = derived(of["body.mass"], of["foot.mass"])
    model = Record(parameters=nested(of), **vars(masses))
    inputs = model.parameters
    push = free_fall.push_on_body(model, inputs)
    weight = ground_force.foot_weight(model)
    inverse_reduced_mass = value_of(masses.inverse_reduced_mass)
    stiffness, damping = value_of(of["leg.stiffness"]), value_of(of["leg.damping"])
    swing = float((stiffness * inverse_reduced_mass).sqrt())
    time = float((value_of(of["body.mass"]) / stiffness).sqrt())
    length = float(value_of(of["leg.free_length"]))

    def along_line(vector: Any) -> Any:
        """A vector in the axes of the ground."""
        x, y = vector.x, vector.y
        return Record(x=ground_line.along(line, x, y), y=ground_line.off(line, x, y))

    return Record(
        model=model,
        inputs=inputs,
        line=line,
        has_thrust=bool(value_of(of["leg.thrust"] + of["control.thrust"]) > 0),
        foot_weight_along=weight * line.sine,
        foot_weight_off=weight * line.cosine,
        push=along_line(push),
        free_body=along_line(free_fall.of_body(model, push)),
        free_center=along_line(free_fall.of_center(model, push)),
        is_pushed=matters("body.external_fx") or matters("body.external_fy"),
        friction_falls=matters("ground.stribeck_velocity"),
        is_stickier=matters("ground.static_friction_ratio", 1),
        retracts=matters("hip.retraction_rate"),
        has_servo=has_servo,
        has_clamp=has_servo and exact["hip.swing_clamp"].rational != 0,
        varied=varied is not None,
        longest_step=min(
            LONGEST_STEP * time, MAX_LEG_ROTATION / (swing + float(damping * inverse_reduced_mass))
        ),
        swing=swing,
        energy_scale=of["leg.stiffness"] * of["leg.free_length"] * of["leg.free_length"],
        scales={
            "length": length,
            "length_rate": length / time,
            "angle_rate": 1.0 / time,
            "foot_speed": length / time,
            "height": length,
            "along": length / time,
            "off": length / time,
        },
    )


def nested(of: Mapping[str, Number]) -> Any:
    """Numbers by the paths of their names, as the pages of laws take them."""
    record = Record()
    for name, number in of.items():
        *path, last = name.split(".")
        inner = record
        for step in path:
            if not hasattr(inner, step):
                setattr(inner, step, Record())
            inner = getattr(inner, step)
        setattr(inner, last, number)
    return record
