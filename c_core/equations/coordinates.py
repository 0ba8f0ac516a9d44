"""Coordinates: a point body on a leg above a point foot (7), and what follows for their velocities.

x_m = x - r sin theta,   y_m = y + r cos theta
"""

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


def leg_rates_with_foot(state, direction, vx, vy):
    """The leg's rates where the foot has another velocity and the body keeps its own."""
    lost_x = state.foot_vx - vx
    lost_y = state.foot_vy - vy
    return Record(
        length=state.leg_length_rate + (direction.cosine * lost_y - direction.sine * lost_x),
        angle=state.leg_angle_rate - (direction.cosine * lost_x + direction.sine * lost_y) / state.leg_length,
    )
