/* Variations of the maps in mode_equations.c, and their way along a step. d_ stands for the variation of what
 * follows.
 */
#include "mode_variation.h"

#include "coefficients.h"
#include "coordinate_laws.h"
#include "ground_line.h"
#include "leg.h"
#include "motion_coordinates.h"
#include "motion_ends.h"

#include <math.h>

/* ---- flight ------------------------------------------------------------------------------------------- */

static void open_flight(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                        const tdmf_local_seed *d, tdmf_mode_variation *varied_mode) {
    varied_mode->at.flying = tdmf_flying_of(d->state);
    varied_mode->com =
        tdmf_vary_center_of_mass_along(model, state, tdmf_leg_direction_of(state), &d->model, d->state);
}

static void flight_variation_of_state(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                      const tdmf_local_seed *d, const tdmf_mode_variation *varied_mode,
                                      double d_state[TDMF_STATE_COUNT]) {
    const tdmf_leg_direction direction = tdmf_leg_direction_of(state);
    const tdmf_point center = tdmf_center_of_mass_along(model, state, direction);
    tdmf_state_of_flying(&varied_mode->at.flying, d_state);
    tdmf_vary_hang_foot(model, center, state, direction, &d->model, varied_mode->com, d_state, d_state);
}

static void advance_flight(const tdmf_step *step, const elapsed_time *elapsed, const tdmf_seed *seed,
                           const flight_variation *varied_series, tdmf_mode_variation *varied_mode) {
    const tdmf_mode_equations *equations = step->equations;
    const tdmf_local_seed d = tdmf_local_seed_of(equations->model, seed, NULL);
    const flight_start end = tdmf_vary_end_flight(&step->series.flight, elapsed, step->order, varied_series);
    tdmf_set_flight(&end, &varied_mode->at.flying);
    varied_mode->at.work += integral_to(varied_series->power, elapsed, step->order - 1);
    varied_mode->com =
        tdmf_vary_ballistic_under(equations->model, &equations->inputs, equations->com, elapsed->power[1],
                                  &d.model, &d.inputs, varied_mode->com, 0.0);
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

static void open_ground(const tdmf_mode_equations *equations, const double state[TDMF_STATE_COUNT],
                        const tdmf_local_seed *d, tdmf_mode_variation *varied_mode) {
    varied_mode->at.standing = tdmf_vary_standing_of(&equations->ground, state, tdmf_leg_direction_of(state),
                                                     &d->mode.ground, d->state);
}

static void ground_variation_of_state(const tdmf_mode_equations *equations,
                                      const double state[TDMF_STATE_COUNT], const tdmf_local_seed *d,
                                      const tdmf_mode_variation *varied_mode,
                                      double d_state[TDMF_STATE_COUNT]) {
    const tdmf_standing standing = tdmf_standing_of(&equations->ground, state, tdmf_leg_direction_of(state));
    tdmf_vary_state_of_standing(&equations->ground, &standing, equations->winding, state, &d->mode.ground,
                                &varied_mode->at.standing, d_state);
}

static void advance_ground(const tdmf_step *step, const elapsed_time *elapsed,
                           const ground_variation *varied_series, tdmf_mode_variation *varied_mode) {
    const bool sticks = step->equations->contact == TDMF_CONTACT_STICK;
    const ground_start end =
        tdmf_vary_end_ground(&step->series.ground, elapsed, step->order, sticks, varied_series);
    tdmf_set_ground(&end, &varied_mode->at.standing);
    if (!sticks) {
        varied_mode->at.standing.foot_x += integral_to(varied_series->foot_vx, elapsed, step->order);
    }
    varied_mode->at.work += integral_to(varied_series->power, elapsed, step->order - 1);
}

/* ---- both --------------------------------------------------------------------------------------------- */

tdmf_mode_variation tdmf_open_mode_variation(const tdmf_mode_equations *equations,
                                             const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                             const tdmf_variation *variation) {
    tdmf_mode_variation varied_mode = {.constant = *variation};
    varied_mode.at.work = variation->state[TDMF_HIP_WORK];
    const tdmf_local_seed d = tdmf_local_seed_of(equations->model, seed, variation);
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

double tdmf_expand_mode_variation(const tdmf_step *step, const tdmf_mode *mode, const tdmf_seed *seed,
                                  const tdmf_mode_variation *varied_mode, motion_variation *varied_series) {
    const tdmf_scales *scales = &step->equations->model->scales;
    const int order = step->order;
    const tdmf_mode_coordinates *from = &step->equations->start, *at = &varied_mode->at;
    const tdmf_local_seed d = tdmf_local_seed_of(step->equations->model, seed, &varied_mode->constant);
    double sizes[SERIES_TERMS] = {0.0};
    if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        flight_variation *flight = &varied_series->flight;
        const flight_coefficients coefficients = tdmf_flight_coefficients(step->equations);
        const flight_coefficients varied = tdmf_vary_flight_coefficients(step->equations, mode, &d);
        const flight_start varied_start = tdmf_flight_start_of(&at->flying);
        const flight_start start = tdmf_flight_start_of(&from->flying);
        vary_flight_by_case(&coefficients, &start, &step->series.flight, &varied, &varied_start, order,
                            step->equations->is_forced, flight);
        add_sizes(flight->length, scales->length, order, sizes);
        add_sizes(flight->length_rate, scales->speed, order, sizes);
        add_sizes(flight->angle, 1.0, order, sizes);
        add_sizes(flight->momentum, scales->speed * scales->length, order, sizes);
    } else {
        ground_variation *ground = &varied_series->ground;
        const ground_coefficients coefficients = tdmf_ground_coefficients(step->equations);
        const ground_coefficients varied = tdmf_vary_ground_coefficients(step->equations, mode, &d);
        const ground_start varied_start = tdmf_ground_start_of(&at->standing);
        const ground_start start = tdmf_ground_start_of(&from->standing);
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

void tdmf_advance_mode_variation(const tdmf_step *step, double elapsed, const tdmf_seed *seed,
                                 const motion_variation *varied_series, tdmf_mode_variation *varied_mode) {
    elapsed_time at;
    set_elapsed(&at, step->search.power, step->size, elapsed, step->order);
    if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        advance_flight(step, &at, seed, &varied_series->flight, varied_mode);
    } else {
        advance_ground(step, &at, &varied_series->ground, varied_mode);
    }
}

tdmf_variation tdmf_variation_in_mode(const tdmf_mode_equations *equations,
                                      const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                      const tdmf_mode_variation *varied_mode) {
    tdmf_variation variation = varied_mode->constant;
    variation.state[TDMF_HIP_WORK] = varied_mode->at.work;
    const tdmf_local_seed d = tdmf_local_seed_of(equations->model, seed, NULL);
    if (equations->contact == TDMF_CONTACT_FLIGHT) {
        flight_variation_of_state(equations->model, state, &d, varied_mode, variation.state);
    } else {
        ground_variation_of_state(equations, state, &d, varied_mode, variation.state);
    }
    return variation;
}
