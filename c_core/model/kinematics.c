/* Kinematics of a point body on a leg above a point foot (7):
 *
 *     x_m = x - r sin(theta),   y_m = y + r cos(theta)
 *
 * With the unit vectors u = (-sin, cos) along the leg and t = (-cos, -sin) across it, the body's velocity is
 * the foot's plus rdot u + r thetadot t. In a variation d_ stands for the change of what follows. */
#include "kinematics.h"

#include "ground_line.h"

#include <math.h>

tdmf_point tdmf_body_from_foot(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction) {
    const double r = state[TDMF_LEG_LENGTH];
    const double sine = direction.sine;
    const double cosine = direction.cosine;
    const double along = state[TDMF_LEG_LENGTH_RATE];
    const double across = r * state[TDMF_LEG_ANGLE_RATE];
    const tdmf_point from_foot = {
        .x = -r * sine,
        .y = r * cosine,
        .vx = -along * sine - across * cosine,
        .vy = along * cosine - across * sine,
    };
    return from_foot;
}

/* The foot, and so much of the way from it to the body. */
static tdmf_point on_leg(const double state[TDMF_STATE_COUNT], double share, tdmf_point from_foot) {
    const tdmf_point point = {
        .x = state[TDMF_FOOT_X] + share * from_foot.x,
        .y = state[TDMF_FOOT_Y] + share * from_foot.y,
        .vx = state[TDMF_FOOT_VX] + share * from_foot.vx,
        .vy = state[TDMF_FOOT_VY] + share * from_foot.vy,
    };
    return point;
}

tdmf_point tdmf_body_along(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction) {
    return on_leg(state, 1.0, tdmf_body_from_foot(state, direction));
}

tdmf_point tdmf_body(const double state[TDMF_STATE_COUNT]) {
    return tdmf_body_along(state, tdmf_leg_direction_of(state));
}

tdmf_point tdmf_center_of_mass_along(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                     tdmf_leg_direction direction) {
    return on_leg(state, model->body_share, tdmf_body_from_foot(state, direction));
}

tdmf_point tdmf_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    return tdmf_center_of_mass_along(model, state, tdmf_leg_direction_of(state));
}

void tdmf_set_foot_velocity_along(double vx, double vy, tdmf_leg_direction direction,
                                  double state[TDMF_STATE_COUNT]) {
    const double sine = direction.sine;
    const double cosine = direction.cosine;
    const double lost_x = state[TDMF_FOOT_VX] - vx;
    const double lost_y = state[TDMF_FOOT_VY] - vy;
    state[TDMF_LEG_LENGTH_RATE] += -sine * lost_x + cosine * lost_y;
    state[TDMF_LEG_ANGLE_RATE] += (-cosine * lost_x - sine * lost_y) / state[TDMF_LEG_LENGTH];
    state[TDMF_FOOT_VX] = vx;
    state[TDMF_FOOT_VY] = vy;
}

void tdmf_set_foot_velocity(double vx, double vy, double state[TDMF_STATE_COUNT]) {
    tdmf_set_foot_velocity_along(vx, vy, tdmf_leg_direction_of(state), state);
}

void tdmf_set_center_of_mass(const tdmf_model *model, tdmf_point center, double state[TDMF_STATE_COUNT]) {
    const tdmf_point from_foot = tdmf_body_from_foot(state, tdmf_leg_direction_of(state));
    state[TDMF_FOOT_X] = center.x - model->body_share * from_foot.x;
    state[TDMF_FOOT_Y] = center.y - model->body_share * from_foot.y;
    state[TDMF_FOOT_VX] = center.vx - model->body_share * from_foot.vx;
    state[TDMF_FOOT_VY] = center.vy - model->body_share * from_foot.vy;
}

tdmf_point tdmf_foot_over_ground(const tdmf_ground_line *ground, const double state[TDMF_STATE_COUNT]) {
    const double x = state[TDMF_FOOT_X], y = state[TDMF_FOOT_Y];
    const double vx = state[TDMF_FOOT_VX], vy = state[TDMF_FOOT_VY];
    const tdmf_point foot = {tdmf_place_along(ground, x, y), tdmf_height_over(ground, x, y),
                             tdmf_velocity_along(ground, vx, vy), tdmf_velocity_off(ground, vx, vy)};
    return foot;
}

/* ---- variations --------------------------------------------------------------------------------------- */

tdmf_point tdmf_vary_body_from_foot(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                                    const double d_state[TDMF_STATE_COUNT]) {
    const double r = state[TDMF_LEG_LENGTH], d_r = d_state[TDMF_LEG_LENGTH];
    const double sine = direction.sine;
    const double cosine = direction.cosine;
    const double d_angle = d_state[TDMF_LEG_ANGLE];
    const double along = state[TDMF_LEG_LENGTH_RATE], d_along = d_state[TDMF_LEG_LENGTH_RATE];
    const double across = r * state[TDMF_LEG_ANGLE_RATE];
    const double d_across = d_r * state[TDMF_LEG_ANGLE_RATE] + r * d_state[TDMF_LEG_ANGLE_RATE];
    const tdmf_point d_from_foot = {
        .x = -d_r * sine - r * cosine * d_angle,
        .y = d_r * cosine - r * sine * d_angle,
        .vx = -d_along * sine - d_across * cosine - (along * cosine - across * sine) * d_angle,
        .vy = d_along * cosine - d_across * sine - (along * sine + across * cosine) * d_angle,
    };
    return d_from_foot;
}

tdmf_point tdmf_vary_body(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                          const double d_state[TDMF_STATE_COUNT]) {
    return on_leg(d_state, 1.0, tdmf_vary_body_from_foot(state, direction, d_state));
}

tdmf_point tdmf_vary_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                    tdmf_leg_direction direction, const tdmf_model *d,
                                    const double d_state[TDMF_STATE_COUNT]) {
    const tdmf_point from_foot = tdmf_body_from_foot(state, direction);
    tdmf_point d_center =
        on_leg(d_state, model->body_share, tdmf_vary_body_from_foot(state, direction, d_state));
    d_center.x += d->body_share * from_foot.x;
    d_center.y += d->body_share * from_foot.y;
    d_center.vx += d->body_share * from_foot.vx;
    d_center.vy += d->body_share * from_foot.vy;
    return d_center;
}

void tdmf_vary_foot_to(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                       tdmf_leg_direction direction, const tdmf_model *d, tdmf_point d_center,
                       double d_state[TDMF_STATE_COUNT]) {
    /* While the foot does not move, this is how the centre of mass moves from it. */
    d_state[TDMF_FOOT_X] = d_state[TDMF_FOOT_Y] = d_state[TDMF_FOOT_VX] = d_state[TDMF_FOOT_VY] = 0.0;
    const tdmf_point from_foot = tdmf_vary_center_of_mass(model, state, direction, d, d_state);
    d_state[TDMF_FOOT_X] = d_center.x - from_foot.x;
    d_state[TDMF_FOOT_Y] = d_center.y - from_foot.y;
    d_state[TDMF_FOOT_VX] = d_center.vx - from_foot.vx;
    d_state[TDMF_FOOT_VY] = d_center.vy - from_foot.vy;
}

void tdmf_vary_leg_to(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction, tdmf_point d,
                      double d_state[TDMF_STATE_COUNT]) {
    const double r = state[TDMF_LEG_LENGTH];
    const double sine = direction.sine;
    const double cosine = direction.cosine;
    const double along = state[TDMF_LEG_LENGTH_RATE];
    const double angle_rate = state[TDMF_LEG_ANGLE_RATE];
    const double d_r = -d.x * sine + d.y * cosine;
    const double d_angle = (-d.x * cosine - d.y * sine) / r;
    d_state[TDMF_LEG_LENGTH] = d_r;
    d_state[TDMF_LEG_ANGLE] = d_angle;
    d_state[TDMF_LEG_LENGTH_RATE] = -d.vx * sine + d.vy * cosine + r * angle_rate * d_angle;
    d_state[TDMF_LEG_ANGLE_RATE] = (-d.vx * cosine - d.vy * sine - along * d_angle - angle_rate * d_r) / r;
}
