"""The impact of touchdown (4)-(6): perfectly inelastic across the ground, with friction along it.

The foot's momentum across the ground is taken by it; friction takes as much of that along it as the cone
allows:

    v_n+ = 0;   v_t+ = 0 if |v_t-| <= rho mu |v_n-|,   else v_t+ = v_t- - mu sgn(v_t-) |v_n-|

and where it falls with speed, the like by its law through the compression: friction.py has both.
The spring and damper give no impulse, so that the body's velocity is unchanged and the leg's rates jump.
"""

from . import friction as law
from . import ground_line
from .coordinates import leg_rates_with_foot
from .functions import Record


def after(model, inputs, zone, line, state, direction, sign, sticks, falls):
    """Foot and rates of the leg after an impact that sticks, or slips to the side of `sign` (4)-(6).

    v_n+ = 0; v_t+ = 0, or v_t- - mu sgn(v_t-) |v_n-|; m_f/2 (v_t-^2 - v_t+^2 + v_n-^2) is lost.
    """
    friction = law.below(model, inputs, zone)
    along = ground_line.along(line, state.foot_vx, state.foot_vy)
    off = ground_line.off(line, state.foot_vx, state.foot_vy)
    if sticks:
        along_after = 0
    elif falls:
        along_after = law.after_falling_impact(model, friction, sign, along, off)
    else:
        along_after = law.after_impact(friction, sign, along, off)
    offset = ground_line.offset_along(line, state.foot_x, state.foot_y)
    foot = ground_line.point_on(line, offset, along_after)
    leg = leg_rates_with_foot(state, direction, foot.vx, foot.vy)
    return Record(
        foot_x=foot.x,
        foot_y=foot.y,
        foot_vx=foot.vx,
        foot_vy=foot.vy,
        leg_length_rate=leg.length,
        leg_angle_rate=leg.angle,
        loss=model.parameters.foot.mass * ((along - along_after) * (along + along_after) + off * off) / 2,
    )
