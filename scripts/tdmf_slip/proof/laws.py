"""The model's laws in axes of the ground, over any kind of number: balls, tubes, series, and duals of them.

Forces, torques, friction and impact are those of the pages in `c_core/equations`. What is added here is the
motion in each mode, which `equations/dynamics.py` has in other axes: t along the line and n away from it. The
leg's angle is measured from n where its sine and cosine are taken. Both are carried along as states, as is
the exponential of a friction that falls with speed, so that nothing but sums, products and quotients by the
leg's length, and in graze by that sine, remains.

`runner` is a record of parameters, `at` one of the motion: length, angle, length_rate, angle_rate, sine,
cosine, and by mode foot_speed, decay, latched_angle, clock.
"""

from types import SimpleNamespace as Record
from typing import Any

from ..equations import coordinates, friction, ground_force, hip, leg
from .dual import Number
from .modes import Mode

# ---- leg and hip: c_core/equations/leg.py, hip.py -----------------------------------------------------


def rest_length(runner: Any, mode: Mode) -> Number:
    """Of the spring: l0 + u, and in thrust epsilon more."""
    return leg.rest_length(runner.model, runner.inputs, mode.thrusts and runner.has_thrust)


def axial_force(runner: Any, mode: Mode, at: Any) -> Number:
    """F_s = k (l - r) - c rdot, pushing body and foot apart."""
    of = runner.model.parameters.leg
    return leg.axial_force(of.stiffness, of.damping, rest_length(runner, mode), at.length, at.length_rate)


def stance_torque(runner: Any, mode: Mode) -> Number:
    """Tau = -tau0 until mid-stance, then 0 (11), and the torque from outside."""
    return hip.stance(runner.model, runner.inputs, hip.HELD, mode.drives).torque


def servo_torque(runner: Any, mode: Mode, at: Any) -> Number:
    """The servo of the flight law (12), without its clamp."""
    if mode.places:
        clock = at.clock if runner.retracts else 0
        law = hip.place(runner.model.parameters.hip, runner.inputs.control, clock)
    else:
        law = hip.retract(runner.model.parameters.hip, at.latched_angle)
    return hip.torque(law, at.angle, at.angle_rate)


def flight_torque(runner: Any, mode: Mode, at: Any) -> Number:
    """The flight law (12), clamped while the centre of mass rises, and the torque from outside."""
    if not mode.places and mode.clamped:
        return hip.external(runner.inputs, hip.HELD).torque
    return servo_torque(runner, mode, at) + runner.inputs.hip.external_torque


# ---- ground: c_core/equations/ground_force.py, friction.py, impact.py ----------------------------------


def holding_force(runner: Any, at: Any, axial: Number, across: Number) -> Any:
    """What would hold the foot still (10); `across` is tau/r."""
    return ground_force.holding_force(
        axial, across, -at.sine, at.cosine, runner.foot_weight_along, runner.foot_weight_off
    )


def normal_force(runner: Any, at: Any, axial: Number, across: Number) -> Number:
    """f_n = F_s cos - (tau/r) sin + m_f g cos(slope) (10)."""
    return holding_force(runner, at, axial, across).normal


def push(runner: Any, at: Any, axial: Number, across: Number) -> Number:
    """What pushes the foot along the line: p = -f_t of (10)."""
    return -holding_force(runner, at, axial, across).tangential


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


# ---- motion --------------------------------------------------------------------------------------------


def torque_across(runner: Any, mode: Mode, at: Any, axial: Number, inverse: Number) -> Number:
    """tau/r in the mode; `inverse` is 1/r."""
    if mode.contact == "graze":
        return grazing_across(runner, at, axial)
    torque = flight_torque(runner, mode, at) if mode.contact == "flight" else stance_torque(runner, mode)
    return torque * inverse


def foot_acceleration(runner: Any, mode: Mode, at: Any, axial: Number, across: Number) -> Number:
    """Of a foot on the ground along the line, in slip and graze: m_f a = p + f_t, where f_t = -s mu f_n."""
    pushed = push(runner, at, axial, across)
    if mode.contact == "slip":
        sliding = sliding_friction(runner, mode, at)
        pushed = pushed - friction.sliding_force(sliding, normal_force(runner, at, axial, across))
    return pushed * runner.inverse_foot_mass


def rates(runner: Any, mode: Mode, at: Any) -> dict[str, Number]:
    """Time derivatives of what moves in the mode, with those of sine and cosine (8).

    rddot = r thetadot^2 + u.(a_body - a_foot), r thetaddot = theta.(a_body - a_foot) - 2 rdot thetadot, with
    u = (-sin, cos) and theta = (-cos, -sin).
    """
    inverse = 1 / at.length
    axial = axial_force(runner, mode, at)
    across = torque_across(runner, mode, at, axial, inverse)
    flies = mode.contact == "flight"
    inertia = runner.inverse_reduced_mass if flies else runner.inverse_body_mass
    along_leg, across_leg = axial * inertia, across * inertia
    if not flies:
        pull_along, pull_off = runner.push_along - runner.gravity_along, runner.push_off - runner.gravity_off
    elif runner.is_pushed:
        pull_along, pull_off = runner.push_along, runner.push_off
    if not flies or runner.is_pushed:
        along_leg = along_leg - pull_along * at.sine + pull_off * at.cosine
        across_leg = across_leg - pull_along * at.cosine - pull_off * at.sine
    changes: dict[str, Number] = {}
    if mode.contact in ("slip", "graze"):
        acceleration = foot_acceleration(runner, mode, at, axial, across)
        along_leg = along_leg + at.sine * acceleration
        across_leg = across_leg + at.cosine * acceleration
        changes["foot_speed"] = acceleration
        if fades(runner, mode):
            changes["decay"] = fading_of(runner, mode) * acceleration * at.decay
    turn = at.length * at.angle_rate
    changes |= {
        "length": at.length_rate,
        "angle": at.angle_rate,
        "length_rate": turn * at.angle_rate + along_leg,
        "angle_rate": (across_leg - 2 * at.length_rate * at.angle_rate) * inverse,
        "sine": at.cosine * at.angle_rate,
        "cosine": -(at.sine * at.angle_rate),
    }
    if mode.places and runner.retracts:
        changes["clock"] = 1
    return changes


def torque(runner: Any, mode: Mode, at: Any) -> Number:
    """The total hip torque in the mode."""
    if mode.contact == "graze":
        return at.length * grazing_across(runner, at, axial_force(runner, mode, at))
    return flight_torque(runner, mode, at) if mode.contact == "flight" else stance_torque(runner, mode)


# ---- where body and foot are ---------------------------------------------------------------------------


def fly(runner: Any, at: Any, speed: Number) -> Record:
    """A foot on the ground with a speed along it, told by the centre of mass: height, along, off."""
    share = runner.body_share
    turn = at.length * at.angle_rate
    return Record(
        height=share * at.length * at.cosine,
        along=speed - share * (at.length_rate * at.sine + turn * at.cosine),
        off=share * (at.length_rate * at.cosine - turn * at.sine),
    )


def foot_velocity(runner: Any, at: Any) -> Record:
    """Of a foot in flight: along, off."""
    share = runner.body_share
    turn = at.length * at.angle_rate
    return Record(
        along=at.along + share * (at.length_rate * at.sine + turn * at.cosine),
        off=at.off - share * (at.length_rate * at.cosine - turn * at.sine),
    )


def foot_height(runner: Any, at: Any) -> Number:
    """Of a foot in flight above the line."""
    return at.height - runner.body_share * (at.length * at.cosine)


def kick(at: Any, lost_along: Number, lost_off: Number) -> Record:
    """Rates of the leg after an impact that takes a velocity from the foot and leaves the body its own."""
    state = Record(
        leg_length=at.length,
        leg_length_rate=at.length_rate,
        leg_angle_rate=at.angle_rate,
        foot_vx=lost_along,
        foot_vy=lost_off,
    )
    rates_after = coordinates.leg_rates_with_foot(state, at, 0, 0)
    return Record(length_rate=rates_after.length, angle_rate=rates_after.angle)


def rise(runner: Any, along: Number, off: Number) -> Number:
    """The vertical part of a velocity in axes of the ground."""
    return along * runner.slope_sine + off * runner.slope_cosine
