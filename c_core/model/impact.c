/* The impact map. The foot's momentum across the ground is taken by it; friction takes as much of that along
 * it as the cone allows (4)-(6):
 *
 *     v_n+ = 0;   v_t+ = 0 if |v_t-| <= rho mu |v_n-|,   else v_t+ = v_t- - mu sgn(v_t-) |v_n-|
 *
 * The spring and damper give no impulse, so the body's velocity is unchanged and the leg's rates jump. */
#include "impact.h"

#include "friction.h"
#include "ground_line.h"
#include "kinematics.h"

#include <math.h>

static bool sticks(const tdmf_model *model, const tdmf_inputs *inputs, double along, double off) {
    return fabs(along) <= tdmf_static_friction(model, inputs) * fabs(off);
}

static double slowed_by_friction(const tdmf_model *model, const tdmf_inputs *inputs, double along,
                                 double off) {
    return sticks(model, inputs, along, off)
               ? 0.0
               : along - copysign(tdmf_sliding_friction(inputs) * fabs(off), along);
}

double tdmf_impact_along(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground,
                         tdmf_leg_direction direction, double state[TDMF_STATE_COUNT]) {
    const double along = tdmf_velocity_along(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    const double off = tdmf_velocity_off(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    const double along_after = slowed_by_friction(model, inputs, along, off);
    const tdmf_point foot =
        tdmf_point_on(ground, tdmf_place_along(ground, state[TDMF_FOOT_X], state[TDMF_FOOT_Y]), along_after);
    state[TDMF_FOOT_X] = foot.x;
    state[TDMF_FOOT_Y] = foot.y;
    tdmf_set_foot_velocity_along(foot.vx, foot.vy, direction, state);
    return 0.5 * model->parameters.foot.mass * ((along - along_after) * (along + along_after) + off * off);
}

double tdmf_impact(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground,
                   double state[TDMF_STATE_COUNT]) {
    return tdmf_impact_along(model, inputs, ground, tdmf_leg_direction_of(state), state);
}

static double vary_slowed(const tdmf_model *model, const tdmf_inputs *inputs, double along, double off,
                          const tdmf_inputs *d_inputs, double d_along, double d_off) {
    const double d_impulse = tdmf_sliding_friction(d_inputs) * fabs(off) +
                             tdmf_sliding_friction(inputs) * copysign(1.0, off) * d_off;
    return sticks(model, inputs, along, off) ? 0.0 : d_along - copysign(1.0, along) * d_impulse;
}

double tdmf_vary_impact(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground,
                        const double before[TDMF_STATE_COUNT], const double after[TDMF_STATE_COUNT],
                        const tdmf_direction *d, double d_state[TDMF_STATE_COUNT]) {
    const tdmf_ground_line *d_ground = &d->mode.ground;
    const double vx = before[TDMF_FOOT_VX], d_vx = d_state[TDMF_FOOT_VX];
    const double vy = before[TDMF_FOOT_VY], d_vy = d_state[TDMF_FOOT_VY];
    const double along = tdmf_velocity_along(ground, vx, vy), off = tdmf_velocity_off(ground, vx, vy);
    const double d_along = tdmf_vary_velocity_along(ground, vx, vy, d_ground, d_vx, d_vy);
    const double d_off = tdmf_vary_velocity_off(ground, vx, vy, d_ground, d_vx, d_vy);
    const double along_after = tdmf_velocity_along(ground, after[TDMF_FOOT_VX], after[TDMF_FOOT_VY]);
    const double d_along_after = vary_slowed(model, inputs, along, off, &d->inputs, d_along, d_off);
    const tdmf_point d_foot = tdmf_vary_point_on(
        ground, tdmf_place_along(ground, after[TDMF_FOOT_X], after[TDMF_FOOT_Y]), along_after, d_ground,
        tdmf_vary_place_along(ground, before[TDMF_FOOT_X], before[TDMF_FOOT_Y], d_ground,
                              d_state[TDMF_FOOT_X], d_state[TDMF_FOOT_Y]),
        d_along_after);
    const tdmf_leg_direction direction = tdmf_leg_direction_of(before);
    tdmf_point d_from_foot = tdmf_vary_body_from_foot(before, direction, d_state);
    d_from_foot.vx += d_vx - d_foot.vx;
    d_from_foot.vy += d_vy - d_foot.vy;
    d_state[TDMF_FOOT_X] = d_foot.x;
    d_state[TDMF_FOOT_Y] = d_foot.y;
    d_state[TDMF_FOOT_VX] = d_foot.vx;
    d_state[TDMF_FOOT_VY] = d_foot.vy;
    tdmf_vary_leg_to(after, direction, d_from_foot, d_state);
    return 0.5 * d->model.parameters.foot.mass * ((along - along_after) * (along + along_after) + off * off) +
           model->parameters.foot.mass * (along * d_along - along_after * d_along_after + off * d_off);
}
