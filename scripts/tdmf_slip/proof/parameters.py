"""A runner's parameters as balls, as the laws take them."""

from collections.abc import Mapping
from fractions import Fraction
from types import SimpleNamespace as Record
from typing import Any

from flint import arb

from ..equations import free_fall, ground_force, ground_line
from ..equations.runner import derived
from .dual import Dual, Number, value_of
from .exact import Exact
from .modes import PARAMETER

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
