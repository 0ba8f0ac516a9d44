/* Kinematics of a point body on a leg above a point foot (7):
 *
 *     x_m = x - r sin(theta),   y_m = y + r cos(theta)
 *
 * With the unit vectors u = (-sin, cos) along the leg and t = (-cos, -sin) across it, the body's velocity is
 * the foot's plus rdot u + r thetadot t. */
#include "tdmf_slip/kinematics.h"

#include <math.h>

tdmf_point tdmf_body(const double state[TDMF_STATE_COUNT]) {
    const double r = state[TDMF_LEG_LENGTH];
    const double sine = sin(state[TDMF_LEG_ANGLE]);
    const double cosine = cos(state[TDMF_LEG_ANGLE]);
    const double along = state[TDMF_LEG_LENGTH_RATE];
    const double across = r * state[TDMF_LEG_ANGLE_RATE];
    const tdmf_point body = {
        .x = state[TDMF_FOOT_X] - r * sine,
        .y = state[TDMF_FOOT_Y] + r * cosine,
        .vx = state[TDMF_FOOT_VX] - along * sine - across * cosine,
        .vy = state[TDMF_FOOT_VY] + along * cosine - across * sine,
    };
    return body;
}

tdmf_point tdmf_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    const tdmf_point body = tdmf_body(state);
    const double share = model->parameters.body.mass / model->total_mass;
    const tdmf_point center = {
        .x = state[TDMF_FOOT_X] + share * (body.x - state[TDMF_FOOT_X]),
        .y = state[TDMF_FOOT_Y] + share * (body.y - state[TDMF_FOOT_Y]),
        .vx = state[TDMF_FOOT_VX] + share * (body.vx - state[TDMF_FOOT_VX]),
        .vy = state[TDMF_FOOT_VY] + share * (body.vy - state[TDMF_FOOT_VY]),
    };
    return center;
}

void tdmf_set_foot_velocity(double vx, double vy, double state[TDMF_STATE_COUNT]) {
    const double sine = sin(state[TDMF_LEG_ANGLE]);
    const double cosine = cos(state[TDMF_LEG_ANGLE]);
    const double lost_x = state[TDMF_FOOT_VX] - vx;
    const double lost_y = state[TDMF_FOOT_VY] - vy;
    state[TDMF_LEG_LENGTH_RATE] += -sine * lost_x + cosine * lost_y;
    state[TDMF_LEG_ANGLE_RATE] += (-cosine * lost_x - sine * lost_y) / state[TDMF_LEG_LENGTH];
    state[TDMF_FOOT_VX] = vx;
    state[TDMF_FOOT_VY] = vy;
}
