"""Coordinates: a point body on a leg above a point foot (7), and what follows for their velocities.

x_m = x - r sin theta,   y_m = y + r cos theta
"""

from . import ground_line
from .functions import Record


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


def foot_over_ground(line, state):
    """The foot in the axes of the ground."""
    return Record(
        x=ground_line.offset_along(line, state.foot_x, state.foot_y),
        y=ground_line.height_over(line, state.foot_x, state.foot_y),
        vx=ground_line.along(line, state.foot_vx, state.foot_vy),
        vy=ground_line.off(line, state.foot_vx, state.foot_vy),
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
