"""Coulomb friction: all that is made of its coefficient, mu. This page is its one home."""

from .functions import Record, larger


def static(model, inputs):
    """rho mu, of a foot at rest and an impact that sticks: the cone is |f_t| <= rho mu f_n  (2)."""
    return model.parameters.ground.static_friction_ratio * inputs.ground.friction


def sliding(inputs, sign):
    """mu of a foot that slips, with the sign of its velocity."""
    return sign * inputs.ground.friction


def sliding_force(friction, normal):
    """-f_t = mu sgn(v_t) f_n, of a foot that slips."""
    return friction * normal


def room(friction, sign, force):
    """rho mu f_n + s f_t, up to the edge of the cone beyond which a foot at rest slips to the side s  (2)."""
    return friction * force.normal + sign * force.tangential


def width(model, inputs):
    """max(1, rho mu), by which the room in a cone is measured: so a wide one has the forces' own rounding."""
    return larger(1, static(model, inputs))


def cone(friction):
    """The weights of f_n and |f_t| in the room that a cone leaves, measured by its width."""
    widest = larger(1, friction)
    return Record(normal=friction / widest, tangential=1 / widest)


def after_impact(inputs, sign, along, off):
    """v_t+ = v_t- - mu sgn(v_t-) |v_n-|, of an impact that slips  (6); v_n- < 0."""
    return along + sliding(inputs, sign) * off
