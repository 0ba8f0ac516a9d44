/* Derived from c_core/equations/coordinates.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_COORDINATE_LAWS_H
#define TDMF_DERIVED_COORDINATE_LAWS_H

#include "quantities.h"

#include <math.h>

/* The leg, as flight has it. */
typedef struct {
    double length;
    double angle;
    double length_rate;
    double angle_rate;
} tdmf_flying;

/* The body as seen from the foot, its velocity, and the foot along the line, in the ground's axes. */
typedef struct {
    double x;
    double y;
    double vx;
    double vy;
    double foot_x;
    double foot_vx;
} tdmf_standing;

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

/* Its change. */
static inline tdmf_point tdmf_vary_body_from_foot(const double state[TDMF_STATE_COUNT],
                                                  tdmf_leg_direction direction,
                                                  const double d_state[TDMF_STATE_COUNT]) {
    const double d_across = d_state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE] +
                            state[TDMF_LEG_LENGTH] * d_state[TDMF_LEG_ANGLE_RATE];
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const tdmf_point result = {
        .x = -d_state[TDMF_LEG_LENGTH] * direction.sine +
             -state[TDMF_LEG_LENGTH] * (direction.cosine * d_state[TDMF_LEG_ANGLE]),
        .y = d_state[TDMF_LEG_LENGTH] * direction.cosine +
             state[TDMF_LEG_LENGTH] * -(direction.sine * d_state[TDMF_LEG_ANGLE]),
        .vx = -d_state[TDMF_LEG_LENGTH_RATE] * direction.sine +
              -state[TDMF_LEG_LENGTH_RATE] * (direction.cosine * d_state[TDMF_LEG_ANGLE]) -
              (d_across * direction.cosine + across * -(direction.sine * d_state[TDMF_LEG_ANGLE])),
        .vy = d_state[TDMF_LEG_LENGTH_RATE] * direction.cosine +
              state[TDMF_LEG_LENGTH_RATE] * -(direction.sine * d_state[TDMF_LEG_ANGLE]) -
              (d_across * direction.sine + across * (direction.cosine * d_state[TDMF_LEG_ANGLE])),
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

/* A foot that is there and moves so, as the state has it. */
static inline void tdmf_hang_foot(const tdmf_model *model, tdmf_point center,
                                  const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                                  double written[TDMF_STATE_COUNT]) {
    const double x = -state[TDMF_LEG_LENGTH] * direction.sine;
    const double y = state[TDMF_LEG_LENGTH] * direction.cosine;
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double vx = -state[TDMF_LEG_LENGTH_RATE] * direction.sine - across * direction.cosine;
    const double vy = state[TDMF_LEG_LENGTH_RATE] * direction.cosine - across * direction.sine;
    written[TDMF_FOOT_X] = center.x - model->body_share * x;
    written[TDMF_FOOT_Y] = center.y - model->body_share * y;
    written[TDMF_FOOT_VX] = center.vx - model->body_share * vx;
    written[TDMF_FOOT_VY] = center.vy - model->body_share * vy;
}

/* Its change. */
static inline void tdmf_vary_hang_foot(const tdmf_model *model, tdmf_point center,
                                       const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                                       const tdmf_model *d_model, tdmf_point d_center,
                                       const double d_state[TDMF_STATE_COUNT],
                                       double written[TDMF_STATE_COUNT]) {
    (void)center;
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
    written[TDMF_FOOT_X] = d_center.x - (d_model->body_share * x + model->body_share * d_x);
    written[TDMF_FOOT_Y] = d_center.y - (d_model->body_share * y + model->body_share * d_y);
    written[TDMF_FOOT_VX] = d_center.vx - (d_model->body_share * vx + model->body_share * d_vx);
    written[TDMF_FOOT_VY] = d_center.vy - (d_model->body_share * vy + model->body_share * d_vy);
}

/* A foot that is there and moves so, as the state has it. */
static inline void tdmf_stand_foot(const tdmf_ground_line *line, double along, double velocity,
                                   double written[TDMF_STATE_COUNT]) {
    written[TDMF_FOOT_X] = line->cosine * along;
    written[TDMF_FOOT_Y] = line->height + line->sine * along;
    written[TDMF_FOOT_VX] = line->cosine * velocity;
    written[TDMF_FOOT_VY] = line->sine * velocity;
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

/* The leg, as flight has it. */
static inline tdmf_flying tdmf_flying_of(const double state[TDMF_STATE_COUNT]) {
    const tdmf_flying result = {
        .length = state[TDMF_LEG_LENGTH],
        .angle = state[TDMF_LEG_ANGLE],
        .length_rate = state[TDMF_LEG_LENGTH_RATE],
        .angle_rate = state[TDMF_LEG_ANGLE_RATE],
    };
    return result;
}

/* The same, as the state has it. */
static inline void tdmf_state_of_flying(const tdmf_flying *flying, double written[TDMF_STATE_COUNT]) {
    written[TDMF_LEG_LENGTH] = flying->length;
    written[TDMF_LEG_ANGLE] = flying->angle;
    written[TDMF_LEG_LENGTH_RATE] = flying->length_rate;
    written[TDMF_LEG_ANGLE_RATE] = flying->angle_rate;
}

/* The body as seen from the foot, its velocity, and the foot along the line, in the ground's axes. */
static inline tdmf_standing tdmf_standing_of(const tdmf_ground_line *line,
                                             const double state[TDMF_STATE_COUNT],
                                             tdmf_leg_direction direction) {
    const double sine = direction.sine * line->cosine - direction.cosine * line->sine;
    const double cosine = direction.cosine * line->cosine + direction.sine * line->sine;
    const double foot_vx = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY];
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double vx = -state[TDMF_LEG_LENGTH_RATE] * sine - across * cosine;
    const tdmf_standing result = {
        .x = -state[TDMF_LEG_LENGTH] * sine,
        .y = state[TDMF_LEG_LENGTH] * cosine,
        .vx = foot_vx + vx,
        .vy = state[TDMF_LEG_LENGTH_RATE] * cosine - across * sine,
        .foot_x = line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height),
        .foot_vx = foot_vx,
    };
    return result;
}

/* Its change. */
static inline tdmf_standing tdmf_vary_standing_of(const tdmf_ground_line *line,
                                                  const double state[TDMF_STATE_COUNT],
                                                  tdmf_leg_direction direction,
                                                  const tdmf_ground_line *d_line,
                                                  const double d_state[TDMF_STATE_COUNT]) {
    const double sine = direction.sine * line->cosine - direction.cosine * line->sine;
    const double d_sine = direction.cosine * d_state[TDMF_LEG_ANGLE] * line->cosine +
                          direction.sine * -(line->sine * d_line->slope) -
                          (-(direction.sine * d_state[TDMF_LEG_ANGLE]) * line->sine +
                           direction.cosine * (line->cosine * d_line->slope));
    const double cosine = direction.cosine * line->cosine + direction.sine * line->sine;
    const double d_cosine = -(direction.sine * d_state[TDMF_LEG_ANGLE]) * line->cosine +
                            direction.cosine * -(line->sine * d_line->slope) +
                            (direction.cosine * d_state[TDMF_LEG_ANGLE] * line->sine +
                             direction.sine * (line->cosine * d_line->slope));
    const double d_foot_vx =
        -(line->sine * d_line->slope) * state[TDMF_FOOT_VX] + line->cosine * d_state[TDMF_FOOT_VX] +
        (line->cosine * d_line->slope * state[TDMF_FOOT_VY] + line->sine * d_state[TDMF_FOOT_VY]);
    const double d_across = d_state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE] +
                            state[TDMF_LEG_LENGTH] * d_state[TDMF_LEG_ANGLE_RATE];
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double d_vx = -d_state[TDMF_LEG_LENGTH_RATE] * sine + -state[TDMF_LEG_LENGTH_RATE] * d_sine -
                        (d_across * cosine + across * d_cosine);
    const tdmf_standing result = {
        .x = -d_state[TDMF_LEG_LENGTH] * sine + -state[TDMF_LEG_LENGTH] * d_sine,
        .y = d_state[TDMF_LEG_LENGTH] * cosine + state[TDMF_LEG_LENGTH] * d_cosine,
        .vx = d_foot_vx + d_vx,
        .vy = d_state[TDMF_LEG_LENGTH_RATE] * cosine + state[TDMF_LEG_LENGTH_RATE] * d_cosine -
              (d_across * sine + across * d_sine),
        .foot_x = -(line->sine * d_line->slope) * state[TDMF_FOOT_X] + line->cosine * d_state[TDMF_FOOT_X] +
                  (line->cosine * d_line->slope * (state[TDMF_FOOT_Y] - line->height) +
                   line->sine * (d_state[TDMF_FOOT_Y] - d_line->height)),
        .foot_vx = d_foot_vx,
    };
    return result;
}

/* The state that coordinates on the ground stand for; the leg has wound by `winding`, in radians. */
static inline void tdmf_state_of_standing(const tdmf_ground_line *line, const tdmf_standing *standing,
                                          double winding, double written[TDMF_STATE_COUNT]) {
    const double length = sqrt(standing->x * standing->x + standing->y * standing->y);
    const double angle = atan2(-standing->x, standing->y) + line->slope;
    written[TDMF_FOOT_X] = line->cosine * standing->foot_x;
    written[TDMF_FOOT_Y] = line->height + line->sine * standing->foot_x;
    written[TDMF_LEG_LENGTH] = length;
    written[TDMF_LEG_ANGLE] = angle + winding;
    written[TDMF_FOOT_VX] = line->cosine * standing->foot_vx;
    written[TDMF_FOOT_VY] = line->sine * standing->foot_vx;
    written[TDMF_LEG_LENGTH_RATE] =
        (standing->x * (standing->vx - standing->foot_vx) + standing->y * standing->vy) / length;
    written[TDMF_LEG_ANGLE_RATE] =
        (standing->x * standing->vy - standing->y * (standing->vx - standing->foot_vx)) / (length * length);
}

/* Its change. */
static inline void tdmf_vary_state_of_standing(const tdmf_ground_line *line, const tdmf_standing *standing,
                                               double winding, const double state[TDMF_STATE_COUNT],
                                               const tdmf_ground_line *d_line,
                                               const tdmf_standing *d_standing,
                                               double written[TDMF_STATE_COUNT]) {
    (void)winding;
    const double d_length = 0.5 *
                            (2.0 * (standing->x * d_standing->x) + 2.0 * (standing->y * d_standing->y)) /
                            state[TDMF_LEG_LENGTH];
    written[TDMF_FOOT_X] =
        -(line->sine * d_line->slope) * standing->foot_x + line->cosine * d_standing->foot_x;
    written[TDMF_FOOT_Y] =
        d_line->height + (line->cosine * d_line->slope * standing->foot_x + line->sine * d_standing->foot_x);
    written[TDMF_LEG_LENGTH] = d_length;
    written[TDMF_LEG_ANGLE] = (standing->y * -d_standing->x - -standing->x * d_standing->y) /
                                  (-standing->x * -standing->x + standing->y * standing->y) +
                              d_line->slope;
    written[TDMF_FOOT_VX] =
        -(line->sine * d_line->slope) * standing->foot_vx + line->cosine * d_standing->foot_vx;
    written[TDMF_FOOT_VY] =
        line->cosine * d_line->slope * standing->foot_vx + line->sine * d_standing->foot_vx;
    written[TDMF_LEG_LENGTH_RATE] = (d_standing->x * (standing->vx - standing->foot_vx) +
                                     standing->x * (d_standing->vx - d_standing->foot_vx) +
                                     (d_standing->y * standing->vy + standing->y * d_standing->vy) -
                                     state[TDMF_LEG_LENGTH_RATE] * d_length) /
                                    state[TDMF_LEG_LENGTH];
    written[TDMF_LEG_ANGLE_RATE] =
        (d_standing->x * standing->vy + standing->x * d_standing->vy -
         (d_standing->y * (standing->vx - standing->foot_vx) +
          standing->y * (d_standing->vx - d_standing->foot_vx)) -
         state[TDMF_LEG_ANGLE_RATE] * (2.0 * (state[TDMF_LEG_LENGTH] * d_length))) /
        (state[TDMF_LEG_LENGTH] * state[TDMF_LEG_LENGTH]);
}

/* theta = atan2(-x, y) + sigma, of a body there as seen from the foot, in axes turned by a slope. */
static inline double tdmf_angle_seen(double x, double y, double slope) {
    return atan2(-x, y) + slope;
}

/* What would hold the foot still under a torque (10), of a leg that stands or slips so. */
static inline tdmf_ground_force tdmf_force_on_standing(const tdmf_model *model, const tdmf_ground_line *line,
                                                       const tdmf_standing *standing, double rest_length,
                                                       double torque) {
    const double square = standing->x * standing->x + standing->y * standing->y;
    const double length = sqrt(square);
    const double rate =
        (standing->x * (standing->vx - standing->foot_vx) + standing->y * standing->vy) / length;
    const double axial =
        (model->parameters.leg.stiffness * (rest_length - length) - model->parameters.leg.damping * rate) /
        length;
    const double along = axial * standing->x - torque / square * standing->y;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double off = axial * standing->y + torque / square * standing->x;
    const tdmf_ground_force result = {
        .tangential = along + weight * line->sine,
        .normal = off + weight * line->cosine,
    };
    return result;
}

#endif
