/* Derived from c_core/equations/coordinates.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_COORDINATE_LAWS_H
#define TDMF_DERIVED_COORDINATE_LAWS_H

#include "quantities.h"

#include <math.h>

/* r u and rdot u + r thetadot t, what body has more than foot; u = (-sin, cos), t = (-cos, -sin). */
static inline tdmf_point tdmf_body_from_foot(const double state[TDMF_STATE_COUNT],
                                             tdmf_leg_direction direction) {
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const tdmf_point result = {
        .x = -state[TDMF_LEG_LENGTH] * direction.sine,
        .y = state[TDMF_LEG_LENGTH] * direction.cosine,
        .vx = -state[TDMF_LEG_LENGTH_RATE] * direction.sine - across * direction.cosine,
        .vy = state[TDMF_LEG_LENGTH_RATE] * direction.cosine - across * direction.sine,
    };
    return result;
}

/* The body (7). */
static inline tdmf_point tdmf_body_along(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction) {
    const double x = -state[TDMF_LEG_LENGTH] * direction.sine;
    const double y = state[TDMF_LEG_LENGTH] * direction.cosine;
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double vx = -state[TDMF_LEG_LENGTH_RATE] * direction.sine - across * direction.cosine;
    const double vy = state[TDMF_LEG_LENGTH_RATE] * direction.cosine - across * direction.sine;
    const tdmf_point result = {
        .x = state[TDMF_FOOT_X] + x,
        .y = state[TDMF_FOOT_Y] + y,
        .vx = state[TDMF_FOOT_VX] + vx,
        .vy = state[TDMF_FOOT_VY] + vy,
    };
    return result;
}

/* Its change. */
static inline tdmf_point tdmf_vary_body_along(const double state[TDMF_STATE_COUNT],
                                              tdmf_leg_direction direction,
                                              const double d_state[TDMF_STATE_COUNT]) {
    const double d_x = -d_state[TDMF_LEG_LENGTH] * direction.sine +
                       -state[TDMF_LEG_LENGTH] * (direction.cosine * d_state[TDMF_LEG_ANGLE]);
    const double d_y = d_state[TDMF_LEG_LENGTH] * direction.cosine +
                       state[TDMF_LEG_LENGTH] * -(direction.sine * d_state[TDMF_LEG_ANGLE]);
    const double d_across = d_state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE] +
                            state[TDMF_LEG_LENGTH] * d_state[TDMF_LEG_ANGLE_RATE];
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double d_vx = -d_state[TDMF_LEG_LENGTH_RATE] * direction.sine +
                        -state[TDMF_LEG_LENGTH_RATE] * (direction.cosine * d_state[TDMF_LEG_ANGLE]) -
                        (d_across * direction.cosine + across * -(direction.sine * d_state[TDMF_LEG_ANGLE]));
    const double d_vy = d_state[TDMF_LEG_LENGTH_RATE] * direction.cosine +
                        state[TDMF_LEG_LENGTH_RATE] * -(direction.sine * d_state[TDMF_LEG_ANGLE]) -
                        (d_across * direction.sine + across * (direction.cosine * d_state[TDMF_LEG_ANGLE]));
    const tdmf_point result = {
        .x = d_state[TDMF_FOOT_X] + d_x,
        .y = d_state[TDMF_FOOT_Y] + d_y,
        .vx = d_state[TDMF_FOOT_VX] + d_vx,
        .vy = d_state[TDMF_FOOT_VY] + d_vy,
    };
    return result;
}

/* The centre of mass of body and foot: the body's share m/(m + m_f) of the way from the foot to it. */
static inline tdmf_point tdmf_center_of_mass_along(const tdmf_model *model,
                                                   const double state[TDMF_STATE_COUNT],
                                                   tdmf_leg_direction direction) {
    const double x = -state[TDMF_LEG_LENGTH] * direction.sine;
    const double y = state[TDMF_LEG_LENGTH] * direction.cosine;
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double vx = -state[TDMF_LEG_LENGTH_RATE] * direction.sine - across * direction.cosine;
    const double vy = state[TDMF_LEG_LENGTH_RATE] * direction.cosine - across * direction.sine;
    const tdmf_point result = {
        .x = state[TDMF_FOOT_X] + model->body_share * x,
        .y = state[TDMF_FOOT_Y] + model->body_share * y,
        .vx = state[TDMF_FOOT_VX] + model->body_share * vx,
        .vy = state[TDMF_FOOT_VY] + model->body_share * vy,
    };
    return result;
}

/* Its change. */
static inline tdmf_point tdmf_vary_center_of_mass_along(const tdmf_model *model,
                                                        const double state[TDMF_STATE_COUNT],
                                                        tdmf_leg_direction direction,
                                                        const tdmf_model *d_model,
                                                        const double d_state[TDMF_STATE_COUNT]) {
    const double x = -state[TDMF_LEG_LENGTH] * direction.sine;
    const double d_x = -d_state[TDMF_LEG_LENGTH] * direction.sine +
                       -state[TDMF_LEG_LENGTH] * (direction.cosine * d_state[TDMF_LEG_ANGLE]);
    const double y = state[TDMF_LEG_LENGTH] * direction.cosine;
    const double d_y = d_state[TDMF_LEG_LENGTH] * direction.cosine +
                       state[TDMF_LEG_LENGTH] * -(direction.sine * d_state[TDMF_LEG_ANGLE]);
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double vx = -state[TDMF_LEG_LENGTH_RATE] * direction.sine - across * direction.cosine;
    const double d_across = d_state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE] +
                            state[TDMF_LEG_LENGTH] * d_state[TDMF_LEG_ANGLE_RATE];
    const double d_vx = -d_state[TDMF_LEG_LENGTH_RATE] * direction.sine +
                        -state[TDMF_LEG_LENGTH_RATE] * (direction.cosine * d_state[TDMF_LEG_ANGLE]) -
                        (d_across * direction.cosine + across * -(direction.sine * d_state[TDMF_LEG_ANGLE]));
    const double vy = state[TDMF_LEG_LENGTH_RATE] * direction.cosine - across * direction.sine;
    const double d_vy = d_state[TDMF_LEG_LENGTH_RATE] * direction.cosine +
                        state[TDMF_LEG_LENGTH_RATE] * -(direction.sine * d_state[TDMF_LEG_ANGLE]) -
                        (d_across * direction.sine + across * (direction.cosine * d_state[TDMF_LEG_ANGLE]));
    const tdmf_point result = {
        .x = d_state[TDMF_FOOT_X] + (d_model->body_share * x + model->body_share * d_x),
        .y = d_state[TDMF_FOOT_Y] + (d_model->body_share * y + model->body_share * d_y),
        .vx = d_state[TDMF_FOOT_VX] + (d_model->body_share * vx + model->body_share * d_vx),
        .vy = d_state[TDMF_FOOT_VY] + (d_model->body_share * vy + model->body_share * d_vy),
    };
    return result;
}

/* The same, as the state has it; the leg's rates come first, so that it may be written over its own. */
static inline void tdmf_set_foot_velocity_along(const double state[TDMF_STATE_COUNT],
                                                tdmf_leg_direction direction, double vx, double vy,
                                                double written[TDMF_STATE_COUNT]) {
    const double lost_y = state[TDMF_FOOT_VY] - vy;
    const double lost_x = state[TDMF_FOOT_VX] - vx;
    written[TDMF_LEG_LENGTH_RATE] =
        state[TDMF_LEG_LENGTH_RATE] + (direction.cosine * lost_y - direction.sine * lost_x);
    written[TDMF_LEG_ANGLE_RATE] =
        state[TDMF_LEG_ANGLE_RATE] -
        (direction.cosine * lost_x + direction.sine * lost_y) / state[TDMF_LEG_LENGTH];
    written[TDMF_FOOT_VX] = vx;
    written[TDMF_FOOT_VY] = vy;
}

/* The foot in the axes of the ground. */
static inline tdmf_point tdmf_foot_over(const tdmf_ground_line *line, const double state[TDMF_STATE_COUNT]) {
    const tdmf_point result = {
        .x = line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height),
        .y = line->cosine * (state[TDMF_FOOT_Y] - line->height) - line->sine * state[TDMF_FOOT_X],
        .vx = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY],
        .vy = line->cosine * state[TDMF_FOOT_VY] - line->sine * state[TDMF_FOOT_VX],
    };
    return result;
}

#endif
