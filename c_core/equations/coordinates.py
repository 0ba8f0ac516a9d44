"""Coordinates: a point body on a leg above a point foot (7), and what follows for their velocities.

x_m = x - r sin theta,   y_m = y + r cos theta
"""

from . import ground_line
from .functions import Record, atan2, sqrt
from .leg import direction_over


def way_from_foot(length, direction):
    """r u, the way to the body; u = (-sin, cos)."""
    return Record(x=-length * direction.sine, y=length * direction.cosine)


def body_from_foot(state, direction):
    """r u and rdot u + r thetadot t, what body has more than foot; u = (-sin, cos), t = (-cos, -sin)."""
    way = way_from_foot(state.leg_length, direction)
    along = state.leg_length_rate
    across = state.leg_length * state.leg_angle_rate
    return Record(
        x=way.x,
        y=way.y,
        vx=-along * direction.sine - across * direction.cosine,
        vy=along * direction.cosine - across * direction.sine,
    )


def body(state, direction):
    """The body  (7)."""
    from_foot = body_from_foot(state, direction)
    return Record(
        x=state.foot_x + from_foot.x,
        y=state.foot_y + from_foot.y,
        vx=state.foot_vx + from_foot.vx,
        vy=state.foot_vy + from_foot.vy,
    )


def center_of_mass(model, state, direction):
    """The centre of mass of body and foot: the body's share m/(m + m_f) of the way from the foot to it."""
    from_foot = body_from_foot(state, direction)
    return Record(
        x=state.foot_x + model.body_share * from_foot.x,
        y=state.foot_y + model.body_share * from_foot.y,
        vx=state.foot_vx + model.body_share * from_foot.vx,
        vy=state.foot_vy + model.body_share * from_foot.vy,
    )


def foot_below(model, center, state, direction):
    """The foot of a leg whose centre of mass is there and moves so."""
    from_foot = body_from_foot(state, direction)
    return Record(
        x=center.x - model.body_share * from_foot.x,
        y=center.y - model.body_share * from_foot.y,
        vx=center.vx - model.body_share * from_foot.vx,
        vy=center.vy - model.body_share * from_foot.vy,
    )


def foot_at(point):
    """A foot that is there and moves so, as the state has it."""
    return Record(foot_x=point.x, foot_y=point.y, foot_vx=point.vx, foot_vy=point.vy)


def foot_over_ground(line, state):
    """The foot in the axes of the ground."""
    return Record(
        x=ground_line.offset_along(line, state.foot_x, state.foot_y),
        y=ground_line.height_over(line, state.foot_x, state.foot_y),
        vx=ground_line.along(line, state.foot_vx, state.foot_vy),
        vy=ground_line.off(line, state.foot_vx, state.foot_vy),
    )


def angle_seen(x, y, slope):
    """theta = atan2(-x, y) + sigma, of a body there as seen from the foot, in axes turned by a slope."""
    return atan2(-x, y) + slope


def leg_to(body, slope):
    """The leg to a body that is there and moves so as seen from the foot, in axes turned by a slope.

    r = |(x, y)|, theta = atan2(-x, y) + sigma, and their rates.
    """
    length = sqrt(body.x * body.x + body.y * body.y)
    return Record(
        length=length,
        angle=angle_seen(body.x, body.y, slope),
        length_rate=(body.x * body.vx + body.y * body.vy) / length,
        angle_rate=(body.x * body.vy - body.y * body.vx) / (length * length),
    )


def leg_rates_with_foot(state, direction, vx, vy):
    """The leg's rates where the foot has another velocity and the body keeps its own."""
    lost_x = state.foot_vx - vx
    lost_y = state.foot_vy - vy
    return Record(
        length=state.leg_length_rate + (direction.cosine * lost_y - direction.sine * lost_x),
        angle=state.leg_angle_rate - (direction.cosine * lost_x + direction.sine * lost_y) / state.leg_length,
    )


def with_foot_velocity(state, direction, vx, vy):
    """The same, as the state has it; the leg's rates come first, so that it may be written over its own."""
    leg = leg_rates_with_foot(state, direction, vx, vy)
    return Record(leg_length_rate=leg.length, leg_angle_rate=leg.angle, foot_vx=vx, foot_vy=vy)


def in_flight(state):
    """The leg, as flight has it."""
    return Record(
        length=state.leg_length,
        angle=state.leg_angle,
        length_rate=state.leg_length_rate,
        angle_rate=state.leg_angle_rate,
    )


def from_flight(flying):
    """The same, as the state has it."""
    return Record(
        leg_length=flying.length,
        leg_angle=flying.angle,
        leg_length_rate=flying.length_rate,
        leg_angle_rate=flying.angle_rate,
    )


def on_ground(line, state, direction):
    """The body as seen from the foot, its velocity, and the foot along the line, in the ground's axes."""
    body = body_from_foot(state, direction_over(line, direction))
    foot_vx = ground_line.along(line, state.foot_vx, state.foot_vy)
    return Record(
        x=body.x,
        y=body.y,
        vx=foot_vx + body.vx,
        vy=body.vy,
        foot_x=ground_line.offset_along(line, state.foot_x, state.foot_y),
        foot_vx=foot_vx,
    )


def from_ground(line, at, winding):
    """The state that coordinates on the ground stand for; the leg has wound by `winding`, in radians."""
    body = Record(x=at.x, y=at.y, vx=at.vx - at.foot_vx, vy=at.vy)
    leg = leg_to(body, line.slope)
    foot = ground_line.point_on(line, at.foot_x, at.foot_vx)
    return Record(
        foot_x=foot.x,
        foot_y=foot.y,
        leg_length=leg.length,
        leg_angle=leg.angle + winding,
        foot_vx=foot.vx,
        foot_vy=foot.vy,
        leg_length_rate=leg.length_rate,
        leg_angle_rate=leg.angle_rate,
    )
