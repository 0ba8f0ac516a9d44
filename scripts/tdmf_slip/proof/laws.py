"""The runner's page on any kind of number: balls, tubes, series, and duals of them.

The laws are those of the page. A proof follows the leg by its length and its angle, and vectors by components
along the ground and off it. `sine` and `cosine` are those of the leg's angle from the ground's normal. They
are carried along as states, and so is `decay`, by which a friction falls with speed. What remains is sums,
products, and quotients by the leg's length, and in graze by that sine.
"""

import functools
from collections.abc import Callable
from types import SimpleNamespace as Record
from typing import Any

from ..pages import RunnerOnOneLine
from .dual import Number


def once(law: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """A law that is evaluated once at an instant."""

    @functools.wraps(law)
    def kept(r: Any) -> Any:
        values, key = vars(r), f"kept {law.__name__}"
        if key not in values:
            values[key] = law(r)
        return values[key]

    return kept


class _Push:
    """Force of leg and hip on the body, by components that are computed where they are asked for."""

    def __init__(self, r: Any, across: Number) -> None:
        self.r, self.across = r, across

    @functools.cached_property
    def along(self) -> Number:
        return -(self.r.spring() * self.r.sine) - self.across * self.r.cosine

    @functools.cached_property
    def off(self) -> Number:
        return self.r.spring() * self.r.cosine - self.across * self.r.sine


class Motion(RunnerOnOneLine):
    """A runner at an instant.

    In flight `clearance` is the distance of the centre of mass from the ground line; `along` and `off` are
    its velocity. On the ground it is known by the foot's velocity `foot_vx` along the line.
    """

    def leg(r: Any) -> Any:
        """Length and angle of the leg, and their rates."""
        return Record(length=r.length, angle=r.angle, length_rate=r.length_rate, angle_rate=r.angle_rate)

    @once
    def spring(r: Any) -> Number:
        """Force of spring and damper."""
        return RunnerOnOneLine.spring(r)

    @once
    def standing(r: Any) -> Any:
        """Force of the ground on a foot at rest, under the stance law."""
        return RunnerOnOneLine.standing(r)

    @once
    def inverse_length(r: Any) -> Number:
        """1/r."""
        return 1 / r.length

    def friction_falls(r: Any) -> bool:
        """True if friction depends on the slip speed, even if it falls by zero."""
        return bool(r.falls_with_speed)

    def fading(r: Any) -> Number:
        """e^(-s v/v_s), as it is carried along."""
        return r.decay

    # ---- (8)-(10) in these coordinates

    def push(r: Any, torque: Number) -> Any:
        """Force of leg and hip on the body, by components on the ground line."""
        return _Push(r, torque * r.inverse_length())

    def grazing_across(r: Any) -> Number:
        """tau_eq/r, where the torque tau_eq keeps the foot on the ground without force."""
        weight = r.on_line(0, r.foot_mass * r.gravity)
        return (r.spring() * r.cosine + weight.off) / r.sine

    def torque(r: Any) -> Number:
        """Total hip torque."""
        return r.length * r.grazing_across() if r.mode == "graze" else super().torque()

    def turned(r: Any, across: Number, inertia: Number, free: Any, foot: Number) -> dict[str, Number]:
        """Rates of the leg: rddot = r w^2 + u.(a_body - a_foot), r wdot = t.(a_body - a_foot) - 2 rdot w.

        `across` is tau/r. By 1/m as `inertia` the body has the acceleration `free` without the leg, and the
        foot has `foot` along the ground. By 1/m + 1/m_f `free` is what pushes the body alone.
        """
        along, off = free.along - foot, free.off
        turning = across * inertia - (along * r.cosine + off * r.sine) - 2 * r.length_rate * r.angle_rate
        return {
            "length": r.length_rate,
            "angle": r.angle_rate,
            "length_rate": r.length * r.angle_rate * r.angle_rate
            + r.spring() * inertia
            + (off * r.cosine - along * r.sine),
            "angle_rate": turning * r.inverse_length(),
            "sine": r.cosine * r.angle_rate,
            "cosine": -(r.sine * r.angle_rate),
        }

    def pushes(r: Any) -> Any:
        """Acceleration of a free body by the external force, by components on the ground line."""
        outside = r.on_line(r.external_fx, r.external_fy)
        return Record(along=outside.along / r.body_mass, off=outside.off / r.body_mass)

    def flight(r: Any) -> Any:
        """Rates of the leg in flight."""
        mobility = 1 / r.body_mass + 1 / r.foot_mass
        across = r.swing_torque() * r.inverse_length()
        return r.turned(across, mobility, r.pushes(), 0) | r.swing_rates()

    def on_ground(
        r: Any, push: Any, torque: Number | None, foot_acceleration: Number = 0
    ) -> dict[str, Number]:
        """Rates of the leg, and of the foot along the ground."""
        weight, outside = r.on_line(0, r.gravity), r.pushes()
        free = Record(along=outside.along - weight.along, off=outside.off - weight.off)
        rates: dict[str, Number] = r.turned(push.across, 1 / r.body_mass, free, foot_acceleration)
        rates["foot_vx"] = foot_acceleration
        if r.mode == "slip" and r.friction_falls():
            rates["decay"] = r.fading_rate() * foot_acceleration * r.decay
        return rates

    def fading_rate(r: Any) -> Number:
        """-s/v_s, the rate at which the excess of friction fades with the foot's velocity."""
        return -r.way / r.stribeck_velocity

    def graze(r: Any) -> Any:
        """Rates of the leg and the foot in graze."""
        weight, push = r.on_line(0, r.foot_mass * r.gravity), _Push(r, r.grazing_across())
        return r.on_ground(push, None, -(push.along + weight.along) / r.foot_mass) | r.swing_rates()

    def fall(r: Any) -> Any:
        """Acceleration of the centre of mass in flight."""
        mass = r.body_mass + r.foot_mass
        return r.on_line(r.external_fx / mass, r.external_fy / mass - r.gravity)

    # ---- where body and foot are (7)

    def foot_above(r: Any, height: Number, slope: Number) -> Number:
        """Distance from the line to a foot in flight."""
        return r.clearance - r.share() * r.length * r.cosine

    def body_above(r: Any) -> Number:
        """Distance from the line to the body."""
        over_foot = r.length * r.cosine
        return r.clearance + (1 - r.share()) * over_foot if r.mode == "flight" else over_foot

    def body_from_foot(r: Any) -> Any:
        """Velocity of the body relative to the foot."""
        turn = r.length * r.angle_rate
        return Record(
            along=-(r.length_rate * r.sine) - turn * r.cosine, off=r.length_rate * r.cosine - turn * r.sine
        )

    def center(r: Any) -> Any:
        """Distance of the centre of mass from the line, and its velocity."""
        if r.mode == "flight":
            return Record(clearance=r.clearance, along=r.along, off=r.off)
        body, share = r.body_from_foot(), r.share()
        return Record(
            clearance=share * r.length * r.cosine,
            along=r.foot_vx + share * body.along,
            off=share * body.off,
        )

    def foot(r: Any) -> Any:
        """Velocity of a foot in flight."""
        body, share = r.body_from_foot(), r.share()
        return Record(along=r.along - share * body.along, off=r.off - share * body.off)

    def rise(r: Any) -> Number:
        """Vertical velocity of the centre of mass."""
        center = r.center()
        return r.in_world(center.along, center.off, 0, 0).y

    def kicked(r: Any, lost_along: Number, lost_off: Number) -> dict[str, Number]:
        """Rates of the leg after an impact that takes a velocity from the foot; the body keeps its own."""
        turn = r.cosine * lost_along + r.sine * lost_off
        return {
            "length_rate": r.length_rate + (r.cosine * lost_off - r.sine * lost_along),
            "angle_rate": r.angle_rate - turn * r.inverse_length(),
        }

    def work_of_thrust(r: Any, begins: bool) -> Number:
        """Work of the jump of the rest length with which thrust begins or ends."""
        before, after = (r.replace(thrusting=int(on)) for on in (not begins, begins))
        return before.lengthened(after).leg_work


NAMES_ON_PAGE = {
    Motion.public(name): name
    for kind in ("parameter", "state")
    for name, quantity in Motion.quantities(kind).items()
    if kind == "parameter" or quantity.is_input
}
"""Names of parameters, settings and inputs on the page, by their names in the unit."""
