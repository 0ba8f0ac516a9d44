/* Variations of the maps in chart.c, and their way along a step. d_ stands for the variation of what follows.
 */
#include "carried.h"

#include "coefficients.h"
#include "kinematics.h"
#include "series_sums.h"

#include <math.h>

/* ---- flight ------------------------------------------------------------------------------------------- */

static void carry_flight(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                         const tdmf_direction *d, tdmf_carried *carried) {
    const tdmf_point com = tdmf_vary_center_of_mass(model, state, &d->model, d->state);
    carried->at.length = d->state[TDMF_LEG_LENGTH];
    carried->at.angle = d->state[TDMF_LEG_ANGLE];
    carried->at.length_rate = d->state[TDMF_LEG_LENGTH_RATE];
    carried->at.angle_rate = d->state[TDMF_LEG_ANGLE_RATE];
    carried->com_x = com.x;
    carried->com_y = com.y;
    carried->com_vx = com.vx;
    carried->com_vy = com.vy;
}

static void flight_carried_to(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                              const tdmf_direction *d, const tdmf_carried *carried,
                              double d_state[TDMF_STATE_COUNT]) {
    d_state[TDMF_LEG_LENGTH] = carried->at.length;
    d_state[TDMF_LEG_ANGLE] = carried->at.angle;
    d_state[TDMF_LEG_LENGTH_RATE] = carried->at.length_rate;
    d_state[TDMF_LEG_ANGLE_RATE] = carried->at.angle_rate;
    /* The foot does not move yet: this is how the centre of mass moves from it. */
    const tdmf_point from_foot = tdmf_vary_center_of_mass(model, state, &d->model, d_state);
    d_state[TDMF_FOOT_X] = carried->com_x - from_foot.x;
    d_state[TDMF_FOOT_Y] = carried->com_y - from_foot.y;
    d_state[TDMF_FOOT_VX] = carried->com_vx - from_foot.vx;
    d_state[TDMF_FOOT_VY] = carried->com_vy - from_foot.vy;
}

static void carry_flight_on(const tdmf_step *step, double t, const tdmf_change *change,
                            const flight_variation *tangent, tdmf_carried *carried) {
    const double d_gravity = change->parameters.gravity;
    carried->at.length = series_at(tangent->length, step->order, t);
    carried->at.length_rate = series_at(tangent->length_rate, step->order, t);
    carried->at.angle = series_at(tangent->angle, step->order, t);
    /* From the momentum r^2 w, which is known to one order more than w. */
    const double r = series_at(step->series.flight.length, step->order, t);
    const double momentum = series_at(step->series.flight.momentum, step->order, t);
    carried->at.angle_rate =
        (series_at(tangent->momentum, step->order, t) - 2.0 * momentum / r * carried->at.length) / (r * r);
    carried->at.work += series_integral(tangent->power, step->order - 1, t);
    carried->com_x += t * carried->com_vx;
    carried->com_y += t * (carried->com_vy - 0.5 * d_gravity * t);
    carried->com_vy -= t * d_gravity;
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

static void carry_ground(const double state[TDMF_STATE_COUNT], const double d_state[TDMF_STATE_COUNT],
                         tdmf_carried *carried) {
    const tdmf_point body = tdmf_vary_body_from_foot(state, d_state);
    carried->at.x = body.x;
    carried->at.y = body.y;
    carried->at.foot_x = d_state[TDMF_FOOT_X];
    carried->at.foot_vx = d_state[TDMF_FOOT_VX];
    carried->at.vx = carried->at.foot_vx + body.vx;
    carried->at.vy = body.vy;
}

static void ground_carried_to(const double state[TDMF_STATE_COUNT], const tdmf_carried *carried,
                              double d_state[TDMF_STATE_COUNT]) {
    const tdmf_coordinates *at = &carried->at;
    const tdmf_point body = {at->x, at->y, at->vx - at->foot_vx, at->vy};
    d_state[TDMF_FOOT_X] = at->foot_x;
    d_state[TDMF_FOOT_VX] = at->foot_vx;
    tdmf_vary_leg_to(state, body, d_state);
}

static void carry_ground_on(const tdmf_step *step, double t, const ground_variation *tangent,
                            tdmf_carried *carried) {
    carried->at.x = series_at(tangent->x, step->order, t);
    carried->at.y = series_at(tangent->y, step->order, t);
    carried->at.foot_vx = series_at(tangent->foot_vx, step->order, t);
    carried->at.vx = series_at(tangent->vx, step->order, t) + carried->at.foot_vx;
    carried->at.vy = series_at(tangent->vy, step->order, t);
    carried->at.foot_x += series_integral(tangent->foot_vx, step->order, t);
    carried->at.work += series_integral(tangent->power, step->order - 1, t);
}

/* ---- both --------------------------------------------------------------------------------------------- */

tdmf_carried tdmf_carry(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                        const tdmf_change *change, const tdmf_variation *variation) {
    tdmf_carried carried = {.liftoff_angle = variation->liftoff_angle,
                            .place_time = variation->state[TDMF_HIP_PLACE_TIME]};
    carried.at.work = variation->state[TDMF_HIP_WORK];
    if (chart->contact == TDMF_CONTACT_FLIGHT) {
        const tdmf_direction d = tdmf_direction_of(chart->model, change, variation);
        carry_flight(chart->model, state, &d, &carried);
    } else {
        carry_ground(state, variation->state, &carried);
    }
    return carried;
}

/* Adds the sizes of a coordinate's coefficients. */
static void add_sizes(const double *c, double unit, int order, double sizes[SERIES_TERMS]) {
    for (int k = 0; k <= order; ++k) {
        sizes[k] += fabs(c[k]) / unit;
    }
}

double tdmf_carried_expand(const tdmf_step *step, const tdmf_mode *mode, const tdmf_change *change,
                           const tdmf_carried *carried, motion_variation *tangent) {
    const tdmf_scales *scales = &step->chart->model->scales;
    const int order = step->order;
    const tdmf_coordinates *at = &carried->at;
    tdmf_variation variation = {.liftoff_angle = carried->liftoff_angle};
    variation.state[TDMF_HIP_PLACE_TIME] = carried->place_time;
    const tdmf_direction d = tdmf_direction_of(step->chart->model, change, &variation);
    double sizes[SERIES_TERMS] = {0.0};
    if (step->chart->contact == TDMF_CONTACT_FLIGHT) {
        flight_variation *flight = &tangent->flight;
        const flight_coefficients coefficients = tdmf_flight_coefficients(step->chart);
        const flight_coefficients varied = tdmf_vary_flight_coefficients(step->chart, mode, &d);
        const double start[4] = {at->length, at->angle, at->length_rate, at->angle_rate};
        vary_flight(&coefficients, &step->series.flight, &varied, start, order, flight);
        add_sizes(flight->length, scales->length, order, sizes);
        add_sizes(flight->length_rate, scales->speed, order, sizes);
        add_sizes(flight->angle, 1.0, order, sizes);
        add_sizes(flight->momentum, scales->speed * scales->length, order, sizes);
    } else {
        ground_variation *ground = &tangent->ground;
        const ground_coefficients coefficients = tdmf_ground_coefficients(step->chart);
        const ground_coefficients varied = tdmf_vary_ground_coefficients(step->chart, mode, &d);
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

void tdmf_carry_on(const tdmf_step *step, double elapsed, const tdmf_change *change,
                   const motion_variation *tangent, tdmf_carried *carried) {
    if (step->chart->contact == TDMF_CONTACT_FLIGHT) {
        carry_flight_on(step, elapsed, change, &tangent->flight, carried);
    } else {
        carry_ground_on(step, elapsed, &tangent->ground, carried);
    }
}

tdmf_variation tdmf_carried_to(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                               const tdmf_change *change, const tdmf_carried *carried) {
    tdmf_variation variation = {.liftoff_angle = carried->liftoff_angle};
    variation.state[TDMF_HIP_WORK] = carried->at.work;
    variation.state[TDMF_HIP_PLACE_TIME] = carried->place_time;
    if (chart->contact == TDMF_CONTACT_FLIGHT) {
        const tdmf_direction d = tdmf_direction_of(chart->model, change, NULL);
        flight_carried_to(chart->model, state, &d, carried, variation.state);
    } else {
        ground_carried_to(state, carried, variation.state);
    }
    return variation;
}
