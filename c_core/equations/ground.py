"""Motion on the ground, in its own axes, X along the line and Y away from it.

(X, Y) is the body's position as seen from the foot, so that no sine is needed; (U, V) its rate, u the foot's
velocity, -(g_x, g_y) the acceleration that gravity and what pushes it from outside give the body.
"""

from . import friction, ground_force, leg
from .functions import Record, larger, sqrt


def start(at):
    """The states, where (vx, vy) is the body's velocity, not seen from the foot."""
    away = at.vx - at.foot_vx
    moment = angular_momentum(at.x, at.y, away, at.vy)
    return Record(x=at.x, y=at.y, vx=away, vy=at.vy, foot_vx=at.foot_vx, moment=moment)


def end(s, sticks):
    """Where a motion leads: the body's place as seen from the foot, its velocity, and the foot's."""
    foot_vx = 0 if sticks else s.foot_vx
    return Record(x=s.x, y=s.y, vx=s.vx + foot_vx, vy=s.vy, foot_vx=foot_vx)


def angular_momentum(x, y, vx, vy):
    """X V - Y U = r^2 thetadot, of the body about the foot and by its mass."""
    return x * vy - y * vx


def length_rate(x, y, vx, vy, length):
    """The rate of r = sqrt(X^2 + Y^2)."""
    return (x * vx + y * vy) / length


def motion(c, s, contact, has_torque, falls=False):
    """Xdot = U, Ydot = V; m Udot = leg - m g_x - m udot, m Vdot = leg - m g_y; m_f udot = foot.

    `has_torque` is whether a torque turns the leg, as it does in graze, `falls` whether friction falls with
    speed.
    """
    square = s.x * s.x + s.y * s.y
    length = sqrt(square)
    rate = length_rate(s.x, s.y, s.vx, s.vy, length)
    axial = leg.axial_force(c.stiffness, c.damping, c.rest_length, length, rate) / length
    if contact == "graze":
        turning = ground_force.grazing_across(axial, s.x, s.y, c.foot_weight_y)
        torque = turning * square
    else:
        torque = c.torque if has_torque else 0
        turning = torque / square
    push = ground_force.leg_push(axial, turning, s.x, s.y)
    force = ground_force.holding_force(axial, turning, s.x, s.y, c.foot_weight_x, c.foot_weight_y)
    off = push.off if contact != "graze" else -c.foot_weight_y
    normal_force = force.normal if contact != "graze" else 0
    tangential_push = -force.tangential
    coefficient = friction.falling(c.friction, c.excess, c.fading, s.foot_vx) if falls else c.friction
    friction_force = friction.sliding_force(coefficient, normal_force) if contact == "slip" else 0
    foot_acceleration = 0 if contact == "stick" else (tangential_push - friction_force) * c.inverse_foot_mass
    return Record(
        rates=Record(
            x=s.vx,
            y=s.vy,
            vx=push.along * c.inverse_body_mass - c.gravity_x - foot_acceleration,
            vy=off * c.inverse_body_mass - c.gravity_y,
            foot_vx=foot_acceleration,
            moment=torque * c.inverse_body_mass
            - c.gravity_y * s.x
            + c.gravity_x * s.y
            + s.y * foot_acceleration,
        ),
        square=square,
        length=length,
        length_rate=rate,
        axial_y=axial * s.y,
        along=push.along,
        off=off,
        turning=turning,
        torque=torque,
        normal_force=normal_force,
        tangential_push=tangential_push,
        angle_rate=s.moment / square,
        power=turning * s.moment,
        speed_square=rate * rate,
        friction_power=friction_force * s.foot_vx,
    )


def holding(model, line, standing, rest_length, torque):
    """What would hold the foot still under a torque (10), of a leg that stands or slips so."""
    s, spring = standing, model.parameters.leg
    square = s.x * s.x + s.y * s.y
    length = sqrt(square)
    rate = length_rate(s.x, s.y, s.vx - s.foot_vx, s.vy, length)
    axial = leg.axial_force(spring.stiffness, spring.damping, rest_length, length, rate) / length
    weight = ground_force.foot_weight(model)
    return ground_force.holding_force(
        axial, torque / square, s.x, s.y, weight * line.sine, weight * line.cosine
    )


def fastest(c, foot_is_free):
    """The highest rate at which the leg springs back or comes to rest."""
    inverse_mass = c.inverse_body_mass + c.inverse_foot_mass if foot_is_free else c.inverse_body_mass
    return larger(sqrt(inverse_mass * c.stiffness), inverse_mass * c.damping)


# ---- guards in these coordinates, by the names of their events, and what others are made of ---------------


def body_down(y):
    """Y, the height of the body over the ground."""
    return y


def slip_velocity_zero(foot_vx, slip_sign):
    """sgn(u) u, the speed of a foot that slips."""
    return slip_sign * foot_vx


def ahead(x, y, slope_sine, slope_cosine):
    """r sin theta, how far the foot is ahead of the body: it falls through 0 with theta."""
    return slope_sine * y - slope_cosine * x


def room(normal_force, tangential_push, cone, sign):
    """rho mu f_n + s f_t, by the cone's width: what is left up to its edge on the side s  (2)."""
    return cone.normal * normal_force - sign * (cone.tangential * tangential_push)


def rise(vx, vy, foot_vx, slope_sine, slope_cosine, share):
    """The rate at which the centre of mass rises, with the body's share of the mass."""
    return share * slope_cosine * vy + share * slope_sine * vx + slope_sine * foot_vx


def lever(x, square):
    """X/r^2: what a torque loads the foot with."""
    return x / square


def load(axial_y, torque, lever, weight_y):
    """f_n under a torque  (10), on whose foot none acts."""
    return axial_y + torque * lever + weight_y
