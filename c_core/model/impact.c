/* The impact map. The foot's vertical momentum is taken by the ground; friction takes as much of the
 * horizontal as the cone allows (4)-(6):
 *
 *     vy+ = 0;   vx+ = 0 if |vx-| <= mu |vy-|,   else vx+ = vx- - mu sgn(vx-) |vy-|
 *
 * The spring and damper give no impulse, so the body's velocity is unchanged and the leg's rates jump. */
#include "tdmf_slip/impact.h"

#include "tdmf_slip/kinematics.h"

#include <math.h>

static double slowed_by_friction(double vx, double largest_change) {
    return fabs(vx) <= largest_change ? 0.0 : vx - copysign(largest_change, vx);
}

double tdmf_impact(const tdmf_model *model, double friction, double state[TDMF_STATE_COUNT]) {
    const double vx = state[TDMF_FOOT_VX];
    const double vy = state[TDMF_FOOT_VY];
    const double vx_after = slowed_by_friction(vx, friction * fabs(vy));
    state[TDMF_FOOT_Y] = 0.0;
    tdmf_set_foot_velocity(vx_after, 0.0, state);
    return 0.5 * model->parameters.foot.mass * ((vx - vx_after) * (vx + vx_after) + vy * vy);
}
