/* Variations of the maps in mode_equations.c, and their way along a step. d_ stands for the variation of what
 * follows.
 */
#include "mode_variation.h"

#include "coefficients.h"
#include "ground_line.h"
#include "kinematics.h"
#include "series_sums.h"

#include <math.h>
#include <string.h>

/* ---- flight ------------------------------------------------------------------------------------------- */

static void open_flight(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                        const tdmf_direction *d, tdmf_mode_variation *varied_mode) {
    const tdmf_point com =
        tdmf_vary_center_of_mass(model, state, tdmf_leg_direction_of(state), &d->model, d->state);
    varied_mode->at.length = d->state[TDMF_LEG_LENGTH];
    varied_mode->at.angle = d->state[TDMF_LEG_ANGLE];
    varied_mode->at.length_rate = d->state[TDMF_LEG_LENGTH_RATE];
    varied_mode->at.angle_rate = d->state[TDMF_LEG_ANGLE_RATE];
    varied_mode->com_x = com.x;
    varied_mode->com_y = com.y;
    varied_mode->com_vx = com.vx;
    varied_mode->com_vy = com.vy;
}

static void flight_variation_of_state(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                      const tdmf_direction *d, const tdmf_mode_variation *varied_mode,
                                      double d_state[TDMF_STATE_COUNT]) {
    d_state[TDMF_LEG_LENGTH] = varied_mode->at.length;
    d_state[TDMF_LEG_ANGLE] = varied_mode->at.angle;
    d_state[TDMF_LEG_LENGTH_RATE] = varied_mode->at.length_rate;
    d_state[TDMF_LEG_ANGLE_RATE] = varied_mode->at.angle_rate;
    const tdmf_point com = {varied_mode->com_x, varied_mode->com_y, varied_mode->com_vx, varied_mode->com_vy};
    tdmf_vary_foot_to(model, state, tdmf_leg_direction_of(state), &d->model, com, d_state);
}

/* The change of the centre of mass's acceleration. */
static tdmf_fall vary_fall(const tdmf_mode_equations *equations, const tdmf_change *change) {
    const tdmf_direction d = tdmf_direction_of(equations->model, change, NULL);
    return tdmf_vary_fall_of_center(equations->model, equations->push, &d.model,
                                    tdmf_vary_push(equations, &d));
}

static void advance_flight(const tdmf_step *step, double t, const tdmf_change *change,
                           const flight_variation *tangent, tdmf_mode_variation *varied_mode) {
    const tdmf_fall d_fall = vary_fall(step->equations, change);
    varied_mode->at.length = series_at(tangent->length, step->order, t);
    varied_mode->at.length_rate = series_at(tangent->length_rate, step->order, t);
    varied_mode->at.angle = series_at(tangent->angle, step->order, t);
    /* From the momentum r^2 w, which is known to one order more than w. */
    const double r = series_at(step->series.flight.length, step->order, t);
    const double momentum = series_at(step->series.flight.momentum, step->order, t);
    varied_mode->at.angle_rate =
        (series_at(tangent->momentum, step->order, t) - 2.0 * momentum / r * varied_mode->at.length) /
        (r * r);
    varied_mode->at.work += series_integral(tangent->power, step->order - 1, t);
    varied_mode->com_x += t * (varied_mode->com_vx + 0.5 * d_fall.x * t);
    varied_mode->com_y += t * (varied_mode->com_vy + 0.5 * d_fall.y * t);
    varied_mode->com_vx += t * d_fall.x;
    varied_mode->com_vy += t * d_fall.y;
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

/* In the ground's axes the leg is seen from its normal. */
static tdmf_leg_direction seen_from_normal(const tdmf_mode_equations *equations,
                                           const double state[TDMF_STATE_COUNT]) {
    return tdmf_direction_over(&equations->ground, tdmf_leg_direction_of(state));
}

static void open_ground(const tdmf_mode_equations *equations, const double state[TDMF_STATE_COUNT],
                        const tdmf_direction *d, tdmf_mode_variation *varied_mode) {
    const tdmf_ground_line *ground = &equations->ground, *d_ground = &d->mode.ground;
    double d_state[TDMF_STATE_COUNT];
    memcpy(d_state, d->state, sizeof d_state);
    d_state[TDMF_LEG_ANGLE] -= d_ground->slope;
    const tdmf_point body = tdmf_vary_body_from_foot(state, seen_from_normal(equations, state), d_state);
    varied_mode->at.x = body.x;
    varied_mode->at.y = body.y;
    varied_mode->at.foot_x = tdmf_vary_place_along(ground, state[TDMF_FOOT_X], state[TDMF_FOOT_Y], d_ground,
                                                   d_state[TDMF_FOOT_X], d_state[TDMF_FOOT_Y]);
    varied_mode->at.foot_vx = tdmf_velocity_along(ground, d_state[TDMF_FOOT_VX], d_state[TDMF_FOOT_VY]);
    varied_mode->at.vx = varied_mode->at.foot_vx + body.vx;
    varied_mode->at.vy = body.vy;
}

static void ground_variation_of_state(const tdmf_mode_equations *equations,
                                      const double state[TDMF_STATE_COUNT], const tdmf_direction *d,
                                      const tdmf_mode_variation *varied_mode,
                                      double d_state[TDMF_STATE_COUNT]) {
    const tdmf_ground_line *ground = &equations->ground, *d_ground = &d->mode.ground;
    const tdmf_mode_coordinates *at = &varied_mode->at;
    const tdmf_point body = {at->x, at->y, at->vx - at->foot_vx, at->vy};
    const double along = tdmf_place_along(ground, state[TDMF_FOOT_X], state[TDMF_FOOT_Y]);
    const double velocity = tdmf_velocity_along(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    const tdmf_point foot = tdmf_vary_point_on(ground, along, velocity, d_ground, at->foot_x, at->foot_vx);
    d_state[TDMF_FOOT_X] = foot.x;
    d_state[TDMF_FOOT_Y] = foot.y;
    d_state[TDMF_FOOT_VX] = foot.vx;
    d_state[TDMF_FOOT_VY] = foot.vy;
    tdmf_vary_leg_to(state, seen_from_normal(equations, state), body, d_state);
    d_state[TDMF_LEG_ANGLE] += d_ground->slope;
}

static void advance_ground(const tdmf_step *step, double t, const ground_variation *tangent,
                           tdmf_mode_variation *varied_mode) {
    varied_mode->at.x = series_at(tangent->x, step->order, t);
    varied_mode->at.y = series_at(tangent->y, step->order, t);
    varied_mode->at.foot_vx = series_at(tangent->foot_vx, step->order, t);
    varied_mode->at.vx = series_at(tangent->vx, step->order, t) + varied_mode->at.foot_vx;
    varied_mode->at.vy = series_at(tangent->vy, step->order, t);
    varied_mode->at.foot_x += series_integral(tangent->foot_vx, step->order, t);
    varied_mode->at.work += series_integral(tangent->power, step->order - 1, t);
}

/* ---- both --------------------------------------------------------------------------------------------- */

tdmf_mode_variation tdmf_open_mode_variation(const tdmf_mode_equations *equations,
                                             const double state[TDMF_STATE_COUNT], const tdmf_change *change,
                                             const tdmf_variation *variation) {
    tdmf_mode_variation varied_mode = {.liftoff_angle = variation->liftoff_angle,
                                       .place_time = variation->state[TDMF_HIP_PLACE_TIME],
                                       .leg_work = variation->state[TDMF_LEG_WORK],
                                       .stance = variation->stance};
    varied_mode.at.work = variation->state[TDMF_HIP_WORK];
    const tdmf_direction d = tdmf_direction_of(equations->model, change, variation);
    if (equations->contact == TDMF_CONTACT_FLIGHT) {
        open_flight(equations->model, state, &d, &varied_mode);
    } else {
        open_ground(equations, state, &d, &varied_mode);
    }
    return varied_mode;
}

/* Adds the sizes of a coordinate's coefficients. */
static void add_sizes(const double *c, double unit, int order, double sizes[SERIES_TERMS]) {
    for (int k = 0; k <= order; ++k) {
        sizes[k] += fabs(c[k]) / unit;
    }
}

double tdmf_expand_mode_variation(const tdmf_step *step, const tdmf_mode *mode, const tdmf_change *change,
                                  const tdmf_mode_variation *varied_mode, motion_variation *tangent) {
    const tdmf_scales *scales = &step->equations->model->scales;
    const int order = step->order;
    const tdmf_mode_coordinates *at = &varied_mode->at;
    tdmf_variation variation = {.liftoff_angle = varied_mode->liftoff_angle};
    variation.state[TDMF_HIP_PLACE_TIME] = varied_mode->place_time;
    const tdmf_direction d = tdmf_direction_of(step->equations->model, change, &variation);
    double sizes[SERIES_TERMS] = {0.0};
    if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        flight_variation *flight = &tangent->flight;
        const flight_coefficients coefficients = tdmf_flight_coefficients(step->equations);
        const flight_coefficients varied = tdmf_vary_flight_coefficients(step->equations, mode, &d);
        const double start[4] = {at->length, at->angle, at->length_rate, at->angle_rate};
        const flight_forcing varied_forcing = tdmf_vary_flight_forcing(step->equations, &d);
        const flight_forcing *forcing = step->equations->is_forced ? &step->constants.flight.forcing : NULL;
        vary_flight(&coefficients, forcing, &step->series.flight, &varied, &varied_forcing, start, order,
                    flight);
        add_sizes(flight->length, scales->length, order, sizes);
        add_sizes(flight->length_rate, scales->speed, order, sizes);
        add_sizes(flight->angle, 1.0, order, sizes);
        add_sizes(flight->momentum, scales->speed * scales->length, order, sizes);
    } else {
        ground_variation *ground = &tangent->ground;
        const ground_coefficients coefficients = tdmf_ground_coefficients(step->equations);
        const ground_coefficients varied = tdmf_vary_ground_coefficients(step->equations, mode, &d);
        const double start[GROUND_START_COUNT] = {at->x, at->y, at->vx, at->vy, at->foot_vx};
        vary_ground(&coefficients, &step->series.ground, &varied, start, order, tdmf_step_ground_case(step),
                    ground);
        add_sizes(ground->x, scales->length, order, sizes);
        add_sizes(ground->y, scales->length, order, sizes);
        add_sizes(ground->vx, scales->speed, order, sizes);
        add_sizes(ground->vy, scales->speed, order, sizes);
        add_sizes(ground->foot_vx, scales->speed, order, sizes);
    }
    return tdmf_step_trusts_terms(step, sizes);
}

void tdmf_advance_mode_variation(const tdmf_step *step, double elapsed, const tdmf_change *change,
                                 const motion_variation *tangent, tdmf_mode_variation *varied_mode) {
    if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        advance_flight(step, elapsed, change, &tangent->flight, varied_mode);
    } else {
        advance_ground(step, elapsed, &tangent->ground, varied_mode);
    }
}

tdmf_variation tdmf_variation_in_mode(const tdmf_mode_equations *equations,
                                      const double state[TDMF_STATE_COUNT], const tdmf_change *change,
                                      const tdmf_mode_variation *varied_mode) {
    tdmf_variation variation = {.liftoff_angle = varied_mode->liftoff_angle, .stance = varied_mode->stance};
    variation.state[TDMF_HIP_WORK] = varied_mode->at.work;
    variation.state[TDMF_HIP_PLACE_TIME] = varied_mode->place_time;
    variation.state[TDMF_LEG_WORK] = varied_mode->leg_work;
    const tdmf_direction d = tdmf_direction_of(equations->model, change, NULL);
    if (equations->contact == TDMF_CONTACT_FLIGHT) {
        flight_variation_of_state(equations->model, state, &d, varied_mode, variation.state);
    } else {
        ground_variation_of_state(equations, state, &d, varied_mode, variation.state);
    }
    return variation;
}
