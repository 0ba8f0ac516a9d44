/* Variations of the maps in mode_equations.c, and their way along a step. d_ stands for the variation of what
 * follows.
 */
#include "mode_variation.h"

#include "coefficients.h"
#include "ground_line.h"
#include "kinematics.h"
#include "series_sums.h"

#include <math.h>

/* ---- flight ------------------------------------------------------------------------------------------- */

static void open_flight(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                        const tdmf_direction *d, tdmf_mode_variation *varied_mode) {
    const tdmf_point com =
        tdmf_vary_center_of_mass_along(model, state, tdmf_leg_direction_of(state), &d->model, d->state);
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
    const tdmf_leg_direction direction = tdmf_leg_direction_of(state);
    const tdmf_point center = tdmf_center_of_mass_along(model, state, direction);
    const tdmf_point d_center = {varied_mode->com_x, varied_mode->com_y, varied_mode->com_vx,
                                 varied_mode->com_vy};
    d_state[TDMF_LEG_LENGTH] = varied_mode->at.length;
    d_state[TDMF_LEG_ANGLE] = varied_mode->at.angle;
    d_state[TDMF_LEG_LENGTH_RATE] = varied_mode->at.length_rate;
    d_state[TDMF_LEG_ANGLE_RATE] = varied_mode->at.angle_rate;
    tdmf_set_foot(tdmf_vary_foot_below(model, center, state, direction, &d->model, d_center, d_state),
                  d_state);
}

/* The change of the centre of mass's acceleration. */
static tdmf_vector vary_fall(const tdmf_mode_equations *equations, const tdmf_change *change) {
    const tdmf_direction d = tdmf_direction_of(equations->model, change, NULL);
    return tdmf_vary_fall_of_center(equations->model, equations->push, &d.model,
                                    tdmf_vary_push(equations, &d));
}

static void advance_flight(const tdmf_step *step, double t, const tdmf_change *change,
                           const flight_variation *tangent, tdmf_mode_variation *varied_mode) {
    const tdmf_vector d_fall = vary_fall(step->equations, change);
    varied_mode->at.length = series_at(tangent->length, step->order, t);
    varied_mode->at.length_rate = series_at(tangent->length_rate, step->order, t);
    varied_mode->at.angle = series_at(tangent->angle, step->order, t);
    /* From the momentum r^2 w, which is known to one order more than w. */
    varied_mode->at.angle_rate =
        tdmf_vary_angle_rate_of(series_at(step->series.flight.momentum, step->order, t),
                                series_at(step->series.flight.length, step->order, t),
                                series_at(tangent->momentum, step->order, t), varied_mode->at.length);
    varied_mode->at.work += series_integral(tangent->power, step->order - 1, t);
    const tdmf_mode_equations *equations = step->equations;
    const tdmf_vector none = {0.0, 0.0};
    const tdmf_point start = {equations->com_x, equations->com_y, equations->com_vx, equations->com_vy};
    const tdmf_point d_start = {varied_mode->com_x, varied_mode->com_y, varied_mode->com_vx,
                                varied_mode->com_vy};
    const tdmf_point d_com = tdmf_vary_ballistic_after(
        start, tdmf_fall_of_center(equations->model, equations->push), none, t, d_start, d_fall, none, 0.0);
    varied_mode->com_x = d_com.x;
    varied_mode->com_y = d_com.y;
    varied_mode->com_vx = d_com.vx;
    varied_mode->com_vy = d_com.vy;
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

static void open_ground(const tdmf_mode_equations *equations, const double state[TDMF_STATE_COUNT],
                        const tdmf_direction *d, tdmf_mode_variation *varied_mode) {
    const tdmf_standing d_standing = tdmf_vary_standing_of(
        &equations->ground, state, tdmf_leg_direction_of(state), &d->mode.ground, d->state);
    varied_mode->at.x = d_standing.x;
    varied_mode->at.y = d_standing.y;
    varied_mode->at.vx = d_standing.vx;
    varied_mode->at.vy = d_standing.vy;
    varied_mode->at.foot_x = d_standing.foot_x;
    varied_mode->at.foot_vx = d_standing.foot_vx;
}

static void ground_variation_of_state(const tdmf_mode_equations *equations,
                                      const double state[TDMF_STATE_COUNT], const tdmf_direction *d,
                                      const tdmf_mode_variation *varied_mode,
                                      double d_state[TDMF_STATE_COUNT]) {
    const tdmf_mode_coordinates *at = &varied_mode->at;
    const tdmf_standing standing = tdmf_standing_of(&equations->ground, state, tdmf_leg_direction_of(state));
    const tdmf_standing d_standing = {at->x, at->y, at->vx, at->vy, at->foot_x, at->foot_vx};
    tdmf_vary_state_of_standing(&equations->ground, &standing, equations->turn, state, &d->mode.ground,
                                &d_standing, d_state);
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
    const tdmf_mode_coordinates *from = &step->equations->start, *at = &varied_mode->at;
    tdmf_variation variation = {.liftoff_angle = varied_mode->liftoff_angle};
    variation.state[TDMF_HIP_PLACE_TIME] = varied_mode->place_time;
    const tdmf_direction d = tdmf_direction_of(step->equations->model, change, &variation);
    double sizes[SERIES_TERMS] = {0.0};
    if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        flight_variation *flight = &tangent->flight;
        const flight_coefficients coefficients = tdmf_flight_coefficients(step->equations);
        const flight_coefficients varied = tdmf_vary_flight_coefficients(step->equations, mode, &d);
        const flight_start varied_start = {at->length, at->angle, at->length_rate, at->angle_rate};
        const flight_start start = {from->length, from->angle, from->length_rate, from->angle_rate};
        vary_flight_by_case(&coefficients, &start, &step->series.flight, &varied, &varied_start, order,
                            step->equations->is_forced, flight);
        add_sizes(flight->length, scales->length, order, sizes);
        add_sizes(flight->length_rate, scales->speed, order, sizes);
        add_sizes(flight->angle, 1.0, order, sizes);
        add_sizes(flight->momentum, scales->speed * scales->length, order, sizes);
    } else {
        ground_variation *ground = &tangent->ground;
        const ground_coefficients coefficients = tdmf_ground_coefficients(step->equations);
        const ground_coefficients varied = tdmf_vary_ground_coefficients(step->equations, mode, &d);
        const ground_start varied_start = {at->x, at->y, at->vx, at->vy, at->foot_vx};
        const ground_start start = {from->x, from->y, from->vx, from->vy, from->foot_vx};
        vary_ground(&coefficients, &start, &step->series.ground, &varied, &varied_start, order,
                    tdmf_step_ground_case(step), ground);
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
