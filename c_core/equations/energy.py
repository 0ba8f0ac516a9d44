"""Energies of two point masses and a spring."""

from .coordinates import body as body_of
from .functions import Record


def mechanical(model, state, direction, rest_length):
    """m |v_m|^2/2 + m_f |v|^2/2,  m g y_m + m_f g y,  k (l - r)^2/2, and their sum."""
    masses = model.parameters
    body = body_of(state, direction)
    compression = rest_length - state.leg_length
    body_square = body.vx * body.vx + body.vy * body.vy
    foot_square = state.foot_vx * state.foot_vx + state.foot_vy * state.foot_vy
    kinetic = (masses.body.mass * body_square + masses.foot.mass * foot_square) / 2
    potential = masses.gravity * (masses.body.mass * body.y + masses.foot.mass * state.foot_y)
    elastic = masses.leg.stiffness * compression * compression / 2
    return Record(kinetic=kinetic, potential=potential, elastic=elastic, total=kinetic + potential + elastic)
