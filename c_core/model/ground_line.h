/* The ground: a line with tangent t = (cos(sigma), sin(sigma)) and normal n = (-sin(sigma), cos(sigma))
 * through its pivot (0, h), and what of places and velocities is along it and across. In a variation d_
 * stands for the change of what follows; of a line that changes, height and slope are given. */
#ifndef TDMF_MODEL_GROUND_LINE_H
#define TDMF_MODEL_GROUND_LINE_H

#include "tdmf_slip/kinematics.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#include <float.h>
#include <math.h>

/* The line that the inputs have set last. */
static inline tdmf_ground_line tdmf_ground_line_set(const tdmf_inputs *inputs) {
    return tdmf_ground_line_of(inputs->ground.height, inputs->ground.slope);
}

/* The line set last waits to be in force. */
static inline bool tdmf_ground_is_pending(const tdmf_inputs *inputs, const tdmf_mode *mode) {
    return mode->ground.height != inputs->ground.height || mode->ground.slope != inputs->ground.slope;
}

/* ---- places ------------------------------------------------------------------------------------------- */

/* From the pivot along the line. */
static inline double tdmf_place_along(const tdmf_ground_line *line, double x, double y) {
    return line->cosine * x + line->sine * (y - line->height);
}

/* The distance from the line, negative below. */
static inline double tdmf_height_over(const tdmf_ground_line *line, double x, double y) {
    return line->cosine * (y - line->height) - line->sine * x;
}

static inline double tdmf_vary_place_along(const tdmf_ground_line *line, double x, double y,
                                           const tdmf_ground_line *d_line, double d_x, double d_y) {
    return line->cosine * d_x + line->sine * (d_y - d_line->height) +
           tdmf_height_over(line, x, y) * d_line->slope;
}

static inline double tdmf_vary_height_over(const tdmf_ground_line *line, double x, double y,
                                           const tdmf_ground_line *d_line, double d_x, double d_y) {
    return line->cosine * (d_y - d_line->height) - line->sine * d_x -
           tdmf_place_along(line, x, y) * d_line->slope;
}

/* What a distance from a line may be wrong by that is high up or deep down at x, where places are rounded. */
static inline double tdmf_rounding_of_height(const tdmf_ground_line *line, double x) {
    return 4.0 * DBL_EPSILON * (fabs(line->height) + fabs(line->sine * x));
}

/* The height of the line at x. */
static inline double tdmf_ground_height_at(const tdmf_ground_line *line, double x) {
    return line->height + x * (line->sine / line->cosine);
}

static inline double tdmf_vary_ground_height_at(const tdmf_ground_line *line, double x,
                                                const tdmf_ground_line *d_line, double d_x) {
    return d_line->height + d_x * (line->sine / line->cosine) +
           x * d_line->slope / (line->cosine * line->cosine);
}

/* ---- velocities --------------------------------------------------------------------------------------- */

static inline double tdmf_velocity_along(const tdmf_ground_line *line, double vx, double vy) {
    return line->cosine * vx + line->sine * vy;
}

static inline double tdmf_velocity_off(const tdmf_ground_line *line, double vx, double vy) {
    return line->cosine * vy - line->sine * vx;
}

static inline double tdmf_vary_velocity_along(const tdmf_ground_line *line, double vx, double vy,
                                              const tdmf_ground_line *d_line, double d_vx, double d_vy) {
    return tdmf_velocity_along(line, d_vx, d_vy) + tdmf_velocity_off(line, vx, vy) * d_line->slope;
}

static inline double tdmf_vary_velocity_off(const tdmf_ground_line *line, double vx, double vy,
                                            const tdmf_ground_line *d_line, double d_vx, double d_vy) {
    return tdmf_velocity_off(line, d_vx, d_vy) - tdmf_velocity_along(line, vx, vy) * d_line->slope;
}

/* ---- points on the line ------------------------------------------------------------------------------- */

/* At a distance from the pivot, with a velocity along the line. */
static inline tdmf_point tdmf_point_on(const tdmf_ground_line *line, double along, double velocity) {
    const tdmf_point point = {line->cosine * along, line->height + line->sine * along,
                              line->cosine * velocity, line->sine * velocity};
    return point;
}

/* Puts the foot onto the line, from a place beside it. */
static inline void tdmf_lift_to_ground(const tdmf_ground_line *line, double state[TDMF_STATE_COUNT]) {
    const tdmf_point foot =
        tdmf_point_on(line, tdmf_place_along(line, state[TDMF_FOOT_X], state[TDMF_FOOT_Y]), 0.0);
    state[TDMF_FOOT_X] = foot.x;
    state[TDMF_FOOT_Y] = foot.y;
}

static inline tdmf_point tdmf_vary_point_on(const tdmf_ground_line *line, double along, double velocity,
                                            const tdmf_ground_line *d_line, double d_along,
                                            double d_velocity) {
    const double turn = d_line->slope;
    const tdmf_point d_point = {
        .x = line->cosine * d_along - line->sine * along * turn,
        .y = d_line->height + line->sine * d_along + line->cosine * along * turn,
        .vx = line->cosine * d_velocity - line->sine * velocity * turn,
        .vy = line->sine * d_velocity + line->cosine * velocity * turn,
    };
    return d_point;
}

#endif
