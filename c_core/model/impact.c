/* The impact map. The foot's vertical momentum is taken by the ground; friction takes as much of the
 * horizontal as the cone allows (4)-(6):
 *
 *     vy+ = 0;   vx+ = 0 if |vx-| <= rho mu |vy-|,   else vx+ = vx- - mu sgn(vx-) |vy-|
 *
 * The spring and damper give no impulse, so the body's velocity is unchanged and the leg's rates jump. */
#include "impact.h"

#include "friction.h"
#include "kinematics.h"

#include <math.h>

static bool sticks(const tdmf_model *model, const tdmf_inputs *inputs, double vx, double vy) {
    return fabs(vx) <= tdmf_static_friction(model, inputs) * fabs(vy);
}

static double slowed_by_friction(const tdmf_model *model, const tdmf_inputs *inputs, double vx, double vy) {
    return sticks(model, inputs, vx, vy) ? 0.0 : vx - copysign(tdmf_sliding_friction(inputs) * fabs(vy), vx);
}

double tdmf_impact_along(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_leg_direction direction,
                         double state[TDMF_STATE_COUNT]) {
    const double vx = state[TDMF_FOOT_VX];
    const double vy = state[TDMF_FOOT_VY];
    const double vx_after = slowed_by_friction(model, inputs, vx, vy);
    state[TDMF_FOOT_Y] = 0.0;
    tdmf_set_foot_velocity_along(vx_after, 0.0, direction, state);
    return 0.5 * model->parameters.foot.mass * ((vx - vx_after) * (vx + vx_after) + vy * vy);
}

double tdmf_impact(const tdmf_model *model, const tdmf_inputs *inputs, double state[TDMF_STATE_COUNT]) {
    return tdmf_impact_along(model, inputs, tdmf_leg_direction_of(state), state);
}

static double vary_slowed(const tdmf_model *model, const tdmf_inputs *inputs, double vx, double vy,
                          const tdmf_inputs *d_inputs, double d_vx, double d_vy) {
    const double d_impulse =
        tdmf_sliding_friction(d_inputs) * fabs(vy) + tdmf_sliding_friction(inputs) * copysign(1.0, vy) * d_vy;
    return sticks(model, inputs, vx, vy) ? 0.0 : d_vx - copysign(1.0, vx) * d_impulse;
}

double tdmf_vary_impact(const tdmf_model *model, const tdmf_inputs *inputs,
                        const double before[TDMF_STATE_COUNT], const double after[TDMF_STATE_COUNT],
                        const tdmf_direction *d, double d_state[TDMF_STATE_COUNT]) {
    const double vx = before[TDMF_FOOT_VX], d_vx = d_state[TDMF_FOOT_VX];
    const double vy = before[TDMF_FOOT_VY], d_vy = d_state[TDMF_FOOT_VY];
    const double vx_after = after[TDMF_FOOT_VX];
    const double d_vx_after = vary_slowed(model, inputs, vx, vy, &d->inputs, d_vx, d_vy);
    tdmf_point d_from_foot = tdmf_vary_body_from_foot(before, tdmf_leg_direction_of(before), d_state);
    d_from_foot.vx += d_vx - d_vx_after;
    d_from_foot.vy += d_vy;
    d_state[TDMF_FOOT_Y] = 0.0;
    d_state[TDMF_FOOT_VX] = d_vx_after;
    d_state[TDMF_FOOT_VY] = 0.0;
    tdmf_vary_leg_to(after, d_from_foot, d_state);
    return 0.5 * d->model.parameters.foot.mass * ((vx - vx_after) * (vx + vx_after) + vy * vy) +
           model->parameters.foot.mass * (vx * d_vx - vx_after * d_vx_after + vy * d_vy);
}
