"""Friction of foot and ground: all that is made of its coefficient, mu. This page is its one home.

Coulomb's law, and friction that falls with the foot's speed (Stribeck) where v_s > 0, from that of a foot at
rest to that of one that slips:

    mu(v) = mu [1 + (rho - 1) e^(-|v|/v_s)]

`friction` is mu below the foot, `sign` the direction s in which it slips. The law uses s v for |v|, so that
it stays smooth for a trial step that goes past v = 0.
"""

from .functions import exp, expm1, larger, log1p, where


def below(model, inputs, zone):
    """mu below a foot: a patch of ground has a friction of its own."""
    return where(zone, "patch", model.parameters.ground.patch_friction, inputs.ground.friction)


def static(model, friction):
    """rho mu, of a foot at rest and an impact that sticks: the cone is |f_t| <= rho mu f_n  (2)."""
    return model.parameters.ground.static_friction_ratio * friction


def sliding(friction, sign):
    """mu of a foot that slips, with the sign of its velocity."""
    return sign * friction


def excess(model):
    """rho - 1, by what share more a foot at rest is held than one that slips fast."""
    return model.parameters.ground.static_friction_ratio - 1


def fading(model, sign):
    """-s/v_s, at what rate the excess fades with the foot's velocity."""
    return -sign / model.parameters.ground.stribeck_velocity


def falling(friction, excess, fading, along):
    """mu(v) = mu [1 + (rho - 1) e^(-s v/v_s)], of a friction that falls with speed."""
    exponent = fading * along
    decay = exp(exponent)
    share = 1 + excess * decay
    return friction * share


def sliding_force(friction, normal):
    """-f_t = mu sgn(v_t) f_n, of a foot that slips."""
    return friction * normal


def room(friction, sign, force):
    """rho mu f_n + s f_t, up to the edge of the cone beyond which a foot at rest slips to the side s  (2)."""
    return friction * force.normal + sign * force.tangential


def width(model, friction):
    """max(1, rho mu), by which the room in a cone is measured: so a wide one has the forces' own rounding."""
    largest = static(model, friction)
    return larger(1, largest)


# ---- impact: dv = -s mu(v) dP, P from 0 to |v_n-|, by the foot's mass --------------------------------------


def impulse(friction, compression):
    """b = mu |v_n-|, what friction takes of |v_t| in an impact whose compression is `compression`."""
    return friction * compression


def gained(model, taken):
    """q = (rho - 1)(1 - e^(-b/v_s)), by what e^(|v_t|/v_s) would change in an impact that comes to rest."""
    return -excess(model) * expm1(-taken / model.parameters.ground.stribeck_velocity)


def stopped_speed(model, friction, compression, falls):
    """|v_t-| up to which an impact comes to rest: rho b, or b + v_s ln(1 + q) where friction falls."""
    if falls:
        taken = impulse(friction, compression)
        return taken + model.parameters.ground.stribeck_velocity * log1p(gained(model, taken))
    return static(model, friction) * compression


def after_impact(friction, sign, along, off):
    """v_t+ = v_t- - mu sgn(v_t-) |v_n-|, of an impact that slips  (6); v_n- < 0."""
    return along + sliding(friction, sign) * off


def after_falling_impact(model, friction, sign, along, off):
    """|v_t+| = |v_t-| - b + v_s ln(1 - q e^(-(|v_t-| - b)/v_s)), under a friction that falls with speed.

    What is below 0 by rounding is 0.
    """
    scale = model.parameters.ground.stribeck_velocity
    taken = impulse(friction, -off)
    left = sign * along - taken
    speed = left + scale * log1p(-gained(model, taken) * exp(-left / scale))
    return sign * larger(speed, 0)
