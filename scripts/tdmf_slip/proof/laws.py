"""The model's laws, over any kind of number: floats, balls, tubes, series, and duals of them.

Everything stands in axes of the ground: t along the line, n away from it, and the leg's angle is measured
from n where its sine and cosine are taken. No law divides but by the leg's length, and in graze by the sine
of its angle; sine, cosine and the exponential of falling friction are carried along as states.

`runner` is a record of parameters, `at` one of the motion: length, angle, length_rate, angle_rate, sine,
cosine, and by mode foot_speed, latched_angle, clock, fading.
"""

from types import SimpleNamespace as Record
from typing import Any

from .dual import Number
from .modes import Mode

# ---- leg and hip ---------------------------------------------------------------------------------------


def rest_length(runner: Any, mode: Mode) -> Number:
    """Of the spring: l0 + u, and in thrust epsilon more."""
    length = runner.free_length + runner.extension
    return length + runner.thrust if mode.thrusts else length


def axial_force(runner: Any, mode: Mode, at: Any) -> Number:
    """F_s = k (l - r) - c rdot, pushing body and foot apart."""
    return runner.stiffness * (rest_length(runner, mode) - at.length) - runner.damping * at.length_rate


def stance_torque(runner: Any, mode: Mode) -> Number:
    """Tau = -tau0 until mid-stance, then 0 (11), and the torque from outside."""
    return runner.external_torque - runner.stance_torque if mode.drives else runner.external_torque


def servo_torque(runner: Any, mode: Mode, at: Any) -> Number:
    """The servo of the flight law (12), without its clamp."""
    if mode.places:
        lag = runner.touchdown_angle - at.angle
        if runner.retracts:
            lag = lag - runner.retraction_rate * at.clock
        return runner.kp * lag - runner.kd * (at.angle_rate + runner.retraction_rate)
    return runner.kp * (runner.liftoff_factor * at.latched_angle - at.angle) - runner.kd * at.angle_rate


def flight_torque(runner: Any, mode: Mode, at: Any) -> Number:
    """The flight law (12), clamped while the centre of mass rises, and the torque from outside."""
    if not mode.places and mode.clamped:
        return runner.external_torque
    return servo_torque(runner, mode, at) + runner.external_torque


# ---- ground --------------------------------------------------------------------------------------------


def normal_force(runner: Any, at: Any, axial: Number, across: Number) -> Number:
    """f_n = F_s cos - (tau/r) sin + m_f g cos(slope) (10); `across` is tau/r."""
    return axial * at.cosine - across * at.sine + runner.foot_mass * runner.gravity_off


def push(runner: Any, at: Any, axial: Number, across: Number) -> Number:
    """What pushes the foot along the line: p = F_s sin + (tau/r) cos - m_f g sin(slope)."""
    return axial * at.sine + across * at.cosine - runner.foot_mass * runner.gravity_along


def grazing_across(runner: Any, at: Any, axial: Number) -> Number:
    """tau_eq/r, with which f_n is zero."""
    return (axial * at.cosine + runner.foot_mass * runner.gravity_off) / at.sine


def sliding_friction(runner: Any, at: Any) -> Number:
    """mu(v) = mu [1 + (rho - 1) e^(-|v|/v_s)], or mu where v_s = 0."""
    if runner.fades:
        return runner.friction * (1 + (runner.static_ratio - 1) * at.fading)
    return runner.friction


def static_friction(runner: Any) -> Number:
    """Rho mu, of the cone of a foot at rest."""
    return runner.friction * runner.static_ratio


def impulse_taken(runner: Any, speed: Number, fall: Number) -> Number:
    """What an impact that slips leaves of |v_t|, of which `speed` was before, with |v_n| = `fall`.

    v_s = 0: |v| - mu |v_n|; else the solution of dv = -mu(v) dP.
    """
    loss = runner.friction * fall
    if not runner.fades:
        return speed - loss
    rise = -(runner.static_ratio - 1) * (-loss / runner.fading_speed).expm1()
    left = (-(speed - loss) / runner.fading_speed).exp()
    return speed - loss + runner.fading_speed * (-rise * left).log1p()


def sticking_speed(runner: Any, fall: Number) -> Number:
    """Up to which |v_t| an impact with |v_n| = `fall` comes to rest."""
    if not runner.fades:
        return static_friction(runner) * fall
    rise = -(runner.static_ratio - 1) * (-(runner.friction * fall) / runner.fading_speed).expm1()
    return runner.friction * fall + runner.fading_speed * rise.log1p()


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
        held = sliding_friction(runner, at) * normal_force(runner, at, axial, across)
        pushed = pushed - held if mode.sign > 0 else pushed + held
    return pushed / runner.foot_mass


def rates(runner: Any, mode: Mode, at: Any) -> dict[str, Number]:
    """Time derivatives of what moves in the mode, with those of sine, cosine and fading (8).

    rddot = r thetadot^2 + u.(a_body - a_foot), r thetaddot = theta.(a_body - a_foot) - 2 rdot thetadot, with
    u = (-sin, cos) and theta = (-cos, -sin).
    """
    inverse = 1 / at.length
    axial = axial_force(runner, mode, at)
    across = torque_across(runner, mode, at, axial, inverse)
    flies = mode.contact == "flight"
    inertia = runner.mobility if flies else runner.inverse_body_mass
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
        if mode.contact == "slip" and runner.fades:
            changes["fading"] = at.fading * acceleration * (-mode.sign / runner.fading_speed)
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
    return Record(
        length_rate=at.length_rate - at.sine * lost_along + at.cosine * lost_off,
        angle_rate=at.angle_rate - (at.cosine * lost_along + at.sine * lost_off) / at.length,
    )


def rise(runner: Any, along: Number, off: Number) -> Number:
    """The vertical part of a velocity in axes of the ground."""
    return along * runner.slope_sine + off * runner.slope_cosine
