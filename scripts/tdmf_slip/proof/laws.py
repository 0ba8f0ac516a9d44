"""The model's laws in axes of the ground, over any kind of number: balls, tubes, series, and duals of them.

All of them are those of the pages in `c_core/equations`, which hold for vectors in any axes:
here x is along the line and y away from it, and the leg's sine and cosine are those of its angle from the
normal. What is added is how these two move, and the exponential of a friction that falls with speed. They are
carried along as states, so that nothing but sums, products and quotients by the leg's length, and in graze by
that sine, remains.

`runner` is a record of parameters, `at` one of the motion: length, angle, length_rate, angle_rate, sine,
cosine, and by mode foot_speed, decay, latched_angle, clock.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import SimpleNamespace as Record
from typing import Any

from ..equations import coordinates, dynamics, friction, ground_force, ground_line, hip, leg
from .dual import Number, UndecidedError, value_of
from .parameters import Mode


@dataclass
class Entered:
    """The mode that an event leads to."""

    mode: Mode
    """After the event and what follows it at the same instant."""
    values: dict[str, Number]
    """Numbers of the motion, by the names of the mode."""
    zeros: Mapping[str, int] = field(default_factory=dict)
    """Order in time to which each guard begins at exactly zero."""
    closes: bool = False
    """A stride ends here, at an apex in flight."""
    impact: bool = False
    """The foot came down."""
    margin: Number | None = None
    """Margin of an event that is forced: zero on the border."""


class _Nothing:
    """0, which costs nothing: a product with it is it, and a sum the other one."""

    def __neg__(self) -> "_Nothing":
        return self

    def __add__(self, other: Number) -> Number:
        return other

    __radd__ = __add__

    def __sub__(self, other: Number) -> Number:
        return -other

    def __rsub__(self, other: Number) -> Number:
        return other

    def __mul__(self, other: Number) -> "_Nothing":
        return self


_NOTHING = _Nothing()
_AT_REST = Record(x=_NOTHING, y=_NOTHING)

# ---- leg and hip: c_core/equations/leg.py, hip.py -----------------------------------------------------


def rest_length(runner: Any, mode: Mode) -> Number:
    """Rest length of the spring: l0 + u, and in thrust epsilon more."""
    return leg.rest_length(runner.model, runner.inputs, mode.thrusts and runner.has_thrust)


def axial_force(runner: Any, mode: Mode, at: Any) -> Number:
    """F_s = k (l - r) - c rdot, pushing body and foot apart."""
    of = runner.model.parameters.leg
    return leg.axial_force(of.stiffness, of.damping, rest_length(runner, mode), at.length, at.length_rate)


def stance_torque(runner: Any, mode: Mode) -> Number:
    """Tau = -tau0 until mid-stance, then 0 (11), and the torque from outside."""
    return hip.stance(runner.model, runner.inputs, hip.CONSTANT_INPUTS, mode.drives).torque


def servo_torque(runner: Any, mode: Mode, at: Any) -> Number:
    """The servo of the flight law (12), without its clamp."""
    if mode.places:
        clock = at.clock if runner.retracts else 0
        law = hip.place(runner.model.parameters.hip, runner.inputs.control, clock)
    else:
        law = hip.retract(runner.model.parameters.hip, at.latched_angle)
    return hip.torque(law, at.angle, at.angle_rate)


def flight_torque(runner: Any, mode: Mode, at: Any) -> Number:
    """Torque of the flight law (12), 0 where its clamp is closed, plus the external torque."""
    if not mode.places and mode.clamped:
        return hip.external(runner.inputs, hip.CONSTANT_INPUTS).torque
    return servo_torque(runner, mode, at) + runner.inputs.hip.external_torque


# ---- ground: c_core/equations/ground_force.py, friction.py, impact.py ----------------------------------


def holding_force(runner: Any, at: Any, axial: Number, across: Number) -> Any:
    """Force that would hold the foot still (10); `across` is tau/r."""
    return ground_force.holding_force(
        axial, across, -at.sine, at.cosine, runner.foot_weight_along, runner.foot_weight_off
    )


def grazing_across(runner: Any, at: Any, axial: Number) -> Number:
    """tau_eq/r, with which f_n is zero."""
    return ground_force.grazing_across(axial, -at.sine, at.cosine, runner.foot_weight_off)


def static_friction(runner: Any) -> Number:
    """Rho mu, of the cone of a foot at rest."""
    return friction.static(runner.model, runner.inputs.ground.friction)


def impulse_taken(runner: Any, speed: Number, fall: Number) -> Number:
    """What an impact that slips leaves of ``|v_t|``, of which `speed` was before, with ``|v_n|`` = `fall`.

    Where friction falls with speed, 0 says that it is not proved to leave anything.
    """
    if runner.friction_falls:
        return friction.after_falling_impact(runner.model, runner.inputs.ground.friction, 1, speed, -fall)
    return friction.after_impact(runner.inputs.ground.friction, 1, speed, -fall)


def sticking_speed(runner: Any, fall: Number) -> Number:
    """Up to which ``|v_t|`` an impact with ``|v_n|`` = `fall` comes to rest."""
    return friction.stopped_speed(runner.model, runner.inputs.ground.friction, fall, runner.friction_falls)


class _Exponent:
    """-s v/v_s, of which the exponential is known, as it is carried along."""

    def __init__(self, decay: Number) -> None:
        self.decay = decay

    def __mul__(self, one: int) -> "_Exponent":
        return self

    def exp(self) -> Number:
        return self.decay


def sliding_friction(runner: Any, mode: Mode, at: Any) -> Number:
    """Mu of a foot that slips, with the sign of its velocity; `at.decay` is e^(-s v/v_s) where it falls."""
    sliding = friction.sliding(runner.inputs.ground.friction, mode.sign)
    if not runner.friction_falls:
        return sliding
    return friction.falling(sliding, friction.excess(runner.model), _Exponent(at.decay), 1)


def fading_of(runner: Any, mode: Mode) -> Number:
    """-s/v_s, at what rate the excess of friction fades with the foot's velocity."""
    return friction.fading(runner.model, mode.sign)


def fades(runner: Any, mode: Mode) -> bool:
    """Whether friction changes with the foot's speed."""
    return bool(mode.contact == "slip" and runner.friction_falls)


# ---- motion: c_core/equations/dynamics.py --------------------------------------------------------------


def torque_across(runner: Any, mode: Mode, at: Any, axial: Number, inverse: Number) -> Number:
    """tau/r in the mode; `inverse` is 1/r."""
    if mode.contact == "graze":
        return grazing_across(runner, at, axial)
    torque = flight_torque(runner, mode, at) if mode.contact == "flight" else stance_torque(runner, mode)
    return torque * inverse


def foot_acceleration(runner: Any, mode: Mode, at: Any, axial: Number, across: Number) -> Number:
    """Acceleration of a foot on the ground along the line, in slip and graze (8)."""
    holding = holding_force(runner, at, axial, across)
    tangential: Number = _NOTHING
    if mode.contact == "slip":
        tangential = -friction.sliding_force(sliding_friction(runner, mode, at), holding.normal)
    return dynamics.along_ground(runner.model.inverse_foot_mass, tangential, holding.tangential)


def rates(runner: Any, mode: Mode, at: Any) -> dict[str, Number]:
    """Time derivatives of what moves in the mode (8)-(9), with those of sine and cosine."""
    inverse = 1 / at.length
    axial = axial_force(runner, mode, at)
    across = torque_across(runner, mode, at, axial, inverse)
    free_body, inertia = runner.free_body, runner.model.inverse_body_mass
    if mode.contact == "flight":
        free_body = runner.push if runner.is_pushed else _AT_REST
        inertia = runner.model.inverse_reduced_mass
    foot, rates = _AT_REST, dict[str, Number]()
    if mode.contact in ("slip", "graze"):
        acceleration = foot_acceleration(runner, mode, at, axial, across)
        foot = Record(x=acceleration, y=_NOTHING)
        rates["foot_speed"] = acceleration
        if fades(runner, mode):
            rates["decay"] = fading_of(runner, mode) * acceleration * at.decay
    leg_at = Record(**vars(at), inverse_length=inverse, axial_force=axial)
    of_leg = dynamics.leg_acceleration(inertia, leg_at, across, free_body, foot)
    rates |= {
        "length": at.length_rate,
        "angle": at.angle_rate,
        "length_rate": of_leg.length,
        "angle_rate": of_leg.angle,
        "sine": at.cosine * at.angle_rate,
        "cosine": -(at.sine * at.angle_rate),
    }
    if mode.places and runner.retracts:
        rates["clock"] = 1
    return rates


def torque(runner: Any, mode: Mode, at: Any) -> Number:
    """The total hip torque in the mode."""
    if mode.contact == "graze":
        return at.length * grazing_across(runner, at, axial_force(runner, mode, at))
    return flight_torque(runner, mode, at) if mode.contact == "flight" else stance_torque(runner, mode)


# ---- where body and foot are: c_core/equations/coordinates.py, impact.py --------------------------------


def _state(at: Any, foot_vx: Number = 0, foot_vy: Number = 0) -> Any:
    """The leg as the pages have it, over a foot in the origin that moves so."""
    return Record(
        foot_x=0,
        foot_y=0,
        foot_vx=foot_vx,
        foot_vy=foot_vy,
        leg_length=at.length,
        leg_length_rate=at.length_rate,
        leg_angle_rate=at.angle_rate,
    )


def fly(runner: Any, at: Any, speed: Number) -> Record:
    """State of a foot on the ground with a speed along it, by the centre of mass: height, along, off."""
    center = coordinates.center_of_mass(runner.model, _state(at, speed), at)
    return Record(height=center.y, along=center.vx, off=center.vy)


def foot_velocity(runner: Any, at: Any) -> Record:
    """Velocity of a foot in flight: along, off."""
    center = Record(x=0, y=at.height, vx=at.along, vy=at.off)
    foot = coordinates.foot_below(runner.model, center, _state(at), at)
    return Record(along=foot.vx, off=foot.vy)


def body_over_foot(at: Any) -> Number:
    """How far the body is away from the line more than the foot."""
    return coordinates.way_from_foot(at.length, at).y


def foot_height(runner: Any, at: Any) -> Number:
    """Height of a foot in flight above the line."""
    return at.height - runner.model.body_share * body_over_foot(at)


def kick(at: Any, lost_along: Number, lost_off: Number) -> Record:
    """Rates of the leg after an impact that takes a velocity from the foot and leaves the body its own."""
    rates_after = coordinates.leg_rates_with_foot(_state(at, lost_along, lost_off), at, 0, 0)
    return Record(length_rate=rates_after.length, angle_rate=rates_after.angle)


def rise(runner: Any, along: Number, off: Number) -> Number:
    """The vertical part of a velocity in axes of the ground."""
    return ground_line.vector_on(runner.line, along, off).y


def positive(number: Number, what: str) -> bool:
    """The sign of a number that is not zero."""
    value = value_of(number)
    if value > 0:
        return True
    if value < 0:
        return False
    raise UndecidedError(what)


def foot_rests(velocity: Number) -> bool:
    """Whether a velocity is exactly zero."""
    return bool(value_of(velocity) == 0)


def absolute(number: Number, what: str, runner: Any, fall: Number) -> Number:
    """The absolute value; where the sign is open, a bound that suffices to show that an impact sticks."""
    value = value_of(number)
    if value > 0:
        return number
    if value < 0:
        return -number
    if abs(value) < value_of(sticking_speed(runner, fall)):
        return abs(value)
    raise UndecidedError(what)
