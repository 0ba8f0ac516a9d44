"""Coulomb friction: all that is made of its coefficient, mu. This page is its one home."""


def static(model, inputs):
    """rho mu, of a foot at rest and an impact that sticks: the cone is |f_t| <= rho mu f_n  (2)."""
    return model.parameters.ground.static_friction_ratio * inputs.ground.friction


def sliding(inputs, sign):
    """mu of a foot that slips, with the sign of its velocity."""
    return sign * inputs.ground.friction


def sliding_force(friction, normal):
    """-f_t = mu sgn(v_t) f_n, of a foot that slips."""
    return friction * normal


def room(friction, wide, sign, force):
    """rho mu f_n + s f_t, up to the edge of the cone beyond which a foot at rest slips to the side s.

    Of a wide cone, rho mu > 1, by rho mu: so it has the forces' own rounding, and nothing overflows.
    """
    if wide:
        return force.normal + sign * force.tangential / friction
    return friction * force.normal + sign * force.tangential


def after_impact(inputs, sign, along, off):
    """v_t+ = v_t- - mu sgn(v_t-) |v_n-|, of an impact that slips  (6); v_n- < 0."""
    return along + sliding(inputs, sign) * off
