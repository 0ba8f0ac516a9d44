"""The force of the ground on the foot (10), and the torque of graze.

With the foot on the ground, a line of slope sigma, sticking or slipping along it, and theta' = theta - sigma:

    f_n = F_s cos theta' - (tau/r) sin theta' + m_f g cos sigma
    stick: f_t = -F_s sin theta' - (tau/r) cos theta' + m_f g sin sigma      slip: f_t = -mu(v_t) sgn(v_t) f_n

f_n is the same in stick and slip, so that friction never feeds back on it: no Painleve paradox.
"""

from . import friction as law
from . import ground_line
from .functions import Record


def foot_weight(model):
    """m_f g."""
    return model.parameters.foot.mass * model.parameters.gravity


def leg_push(axial, across, x, y):
    """What the leg pushes the body with, and the foot with the opposite, in the ground's axes.

    (x, y) is the unit vector from foot to body, axial F_s and across tau/r; or it is the way there, with
    F_s/r and tau/r^2.
    """
    return Record(along=axial * x - across * y, off=axial * y + across * x)


def holding_force(axial, across, x, y, weight_x, weight_y):
    """What would hold the foot still (10): the leg's push and m_f g, in the ground's axes."""
    push = leg_push(axial, across, x, y)
    return Record(tangential=push.along + weight_x, normal=push.off + weight_y)


def grazing_across(axial, x, y, weight_y):
    """The `across` at which (10) has f_n = 0."""
    return -(axial * y + weight_y) / x


def under(model, line, leg, torque):
    """What would hold the foot still under a torque, whatever the mode  (10)."""
    weight = foot_weight(model)
    across = torque * leg.inverse_length
    return holding_force(
        leg.axial_force, across, -leg.ground_sine, leg.ground_cosine, weight * line.sine, weight * line.cosine
    )


def in_mode(model, friction, line, state, leg, torque, contact, sign, falls):
    """The force in the mode: (10) in stick, f_t = -mu sgn(v_t) f_n in slip, else none.

    `friction` is mu below the foot, `falls` whether it falls with speed.
    """
    if contact in ("flight", "graze"):
        return Record(tangential=0, normal=0)
    force = under(model, line, leg, torque)
    if contact != "stick":
        sliding = law.sliding(friction, sign)
        if falls:
            along = ground_line.along(line, state.foot_vx, state.foot_vy)
            sliding = law.falling(sliding, law.excess(model), law.fading(model, sign), along)
        force.tangential = -law.sliding_force(sliding, force.normal)
    return force


def graze_torque(model, line, leg, upright, sine):
    """tau_eq = r (F_s cos theta' + m_f g cos sigma)/sin theta', which keeps an unloaded foot at the ground.

    Of an upright leg `sine` is the smallest that may stand in the denominator.
    """
    load = leg.axial_force * leg.ground_cosine + foot_weight(model) * line.cosine
    return load / ((sine if upright else leg.ground_sine) * leg.inverse_length)
