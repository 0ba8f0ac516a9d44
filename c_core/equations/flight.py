"""Flight: the centre of mass is exactly ballistic, so that only the leg moves, and gravity drops out.

With M = 1/m + 1/m_f, v = rdot, w = thetadot and L = r^2 w. A force on the body, which gives it the
acceleration p, does not drop out: vdot gains u.p and Ldot r t.p, with u = (-sin, cos) along the leg and
t = (-cos, -sin) across it.
"""

from . import hip, leg
from .functions import Record, cos, larger, plus_unless_zero, sin, sqrt


def start(leg):
    """The states, by a leg."""
    momentum = leg.length * leg.length * leg.angle_rate
    return Record(length=leg.length, angle=leg.angle, length_rate=leg.length_rate, momentum=momentum)


def end(s):
    """The leg where a motion leads, its turning by the momentum, which is known to one order more."""
    return Record(
        length=s.length,
        angle=s.angle,
        length_rate=s.length_rate,
        angle_rate=s.momentum / (s.length * s.length),
    )


def motion(c, s, pushed):
    """vdot = r w^2 + M F_s,  Ldot = M tau,  w = L/r^2, and what the push on the body adds."""
    square = s.length * s.length
    angle_rate = s.momentum / square
    rate_square = angle_rate * angle_rate
    axial_force = leg.axial_force(c.stiffness, c.damping, c.rest_length, s.length, s.length_rate)
    torque = hip.torque(c, s.angle, angle_rate)
    sine, cosine = (sin(s.angle), cos(s.angle)) if pushed else (0, 0)
    push_along = c.push_y * cosine - c.push_x * sine
    push_across = -(c.push_x * cosine + c.push_y * sine)
    push_moment = s.length * push_across
    return Record(
        rates=Record(
            length=s.length_rate,
            length_rate=s.length * rate_square + c.inverse_reduced_mass * axial_force + push_along,
            angle=angle_rate,
            momentum=c.inverse_reduced_mass * torque + push_moment,
        ),
        square=square,
        angle_rate=angle_rate,
        rate_square=rate_square,
        speed_square=s.length_rate * s.length_rate,
        push_moment=push_moment,
        torque=torque,
        power=torque * angle_rate,
    )


def hip_torque(c, angle, angle_rate):
    """The hip's torque along a motion."""
    return hip.torque(c, angle, angle_rate)


def work(c, start, integrals, turned, time):
    """The hip's work while the leg turns, of a torque that is affine in angle, rate and time.

    The integral of t w is taken by parts.
    """
    by_angle = turned * (c.gain * (c.target - start.angle - turned / 2) + c.torque)
    damped = plus_unless_zero(by_angle, -c.rate_gain, integrals.rate_square)
    return plus_unless_zero(damped, c.torque_rate, time * (start.angle + turned) - integrals.angle)


def fastest(c, length, pushed):
    """The highest rate at which leg, servo or what hangs in a push springs back or comes to rest."""
    inverse_length = 1 / length
    by_square = c.inverse_reduced_mass * inverse_length * inverse_length
    stiffness = larger(c.inverse_reduced_mass * c.stiffness, by_square * c.gain)
    if pushed:
        stiffness = larger(stiffness, (abs(c.push_x) + abs(c.push_y)) * inverse_length)
    return larger(sqrt(stiffness), larger(c.inverse_reduced_mass * c.damping, by_square * c.rate_gain))


def drop(length, angle, slope):
    """r cos(theta - sigma), which the body is above the foot over a ground of that slope."""
    seen = angle - slope
    return length * cos(seen)
