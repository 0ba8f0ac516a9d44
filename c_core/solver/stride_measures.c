/* An integral I of q changes with a variation at a fixed time by the integral of dq, and by (q- - q+) dt at
 * an event that shifts by dt. The greatest value inside a mode is at a turn, where it is the same at a time
 * that is shifted; one at an event is met where the event is. */
#include "stride_measures.h"

#include "evaluation.h"
#include "first_root.h"
#include "ground_line.h"
#include "guard_series.h"
#include "positive_work.h"
#include "series_products.h"
#include "series_sums.h"
#include "step_size.h"
#include "tdmf_slip/dynamics.h"

#include <math.h>
#include <string.h>

enum { EXTREMUM_LIMIT = SERIES_ORDER_LIMIT };

/* ---- the foot's height -------------------------------------------------------------------------------- */

static double foot_height(const tdmf_motion *motion, const double state[TDMF_STATE_COUNT]) {
    return state[TDMF_FOOT_Y] - tdmf_ground_height_at(&motion->mode.ground, state[TDMF_FOOT_X]);
}

static double vary_foot_height(const tdmf_model *model, const tdmf_motion *motion,
                               const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                               const double d_state[TDMF_STATE_COUNT]) {
    const tdmf_local_seed d = tdmf_local_seed_of(model, seed, NULL);
    return d_state[TDMF_FOOT_Y] - tdmf_vary_ground_height_at(&motion->mode.ground, state[TDMF_FOOT_X],
                                                             &d.mode.ground, d_state[TDMF_FOOT_X]);
}

/* How far the leg reaches down to the ground, as a series. */
static void drop_in_step(const tdmf_step *step, double drop[SERIES_TERMS]) {
    const flight_series *f = &step->series.flight;
    expand_drop(f->length, f->angle, step->constants.flight.slope, f->angle_rate, step->order, drop);
}

double tdmf_measures_trust(const tdmf_step *step) {
    double drop[SERIES_TERMS];
    series_remainder remainder = {0.0, 0.0};
    if (step->equations->contact != TDMF_CONTACT_FLIGHT) {
        return INFINITY;
    }
    drop_in_step(step, drop);
    add_to_remainder(&remainder, drop, step->order, step->equations->model->scales.length);
    return trusted_size(&remainder, INFINITY, step->order, step->tolerance);
}

/* The state and, for a variation, its change, at a time within a step. */
static void state_in_step(const tdmf_measured_step *taken, double t, double state[TDMF_STATE_COUNT]) {
    const tdmf_mode_coordinates there = tdmf_step_at(taken->step, t);
    memcpy(state, taken->motion->state, TDMF_STATE_COUNT * sizeof *state);
    tdmf_state_in_mode(taken->step->equations, t, &there, state);
}

static tdmf_variation variation_in_step(const tdmf_measured_step *taken, int i, double t,
                                        const double state[TDMF_STATE_COUNT]) {
    tdmf_mode_variation varied_mode = taken->varied_mode[i];
    tdmf_advance_mode_variation(taken->step, t, &taken->seeds[i], &taken->varied_series[i], &varied_mode);
    return tdmf_variation_in_mode(taken->step->equations, state, &taken->seeds[i], &varied_mode);
}

static void record_height(tdmf_measured *measured, const tdmf_measured_step *taken, double t) {
    const tdmf_model *model = taken->step->equations->model;
    double state[TDMF_STATE_COUNT];
    state_in_step(taken, t, state);
    const double height = foot_height(taken->motion, state);
    if (!(height > measured->so_far.greatest_foot_height)) {
        return;
    }
    measured->so_far.greatest_foot_height = height;
    for (int i = 0; i < taken->count; ++i) {
        const tdmf_variation variation = variation_in_step(taken, i, t, state);
        measured->varied[i].greatest_foot_height =
            vary_foot_height(model, taken->motion, state, &taken->seeds[i], variation.state);
    }
}

/* ---- turns -------------------------------------------------------------------------------------------- */

typedef void record_extremum(tdmf_measured *measured, const tdmf_measured_step *taken, double t);

/* Records at each zero of a rate, a series in time, and at the end of a step that is no event; its start was
 * an end. */
static void record_extrema(tdmf_measured *measured, const tdmf_measured_step *taken, const double *rate,
                           int order, record_extremum *record) {
    const tdmf_step *step = taken->step;
    double c[SERIES_TERMS], from = 0.0;
    const double end = taken->end / step->size;
    if (order < 1) {
        return;
    }
    for (int k = 0; k <= order; ++k) {
        c[k] = rate[k] * step->search.power[k];
    }
    for (int i = 0; i < EXTREMUM_LIMIT && from < end; ++i) {
        const root extremum = first_sign_change(c, order, 0.0, from, end, mask_of(true));
        if (!extremum.is_root || !(extremum.time > from)) {
            break;
        }
        record(measured, taken, extremum.time * step->size);
        from = extremum.time;
    }
    if (!taken->ends_at_event) {
        record(measured, taken, taken->end);
    }
}

static void measure_height(tdmf_measured *measured, const tdmf_measured_step *taken) {
    const tdmf_step *step = taken->step;
    const flight_constants *c = &step->constants.flight;
    const ballistic com = tdmf_step_center_of_mass(step->equations);
    double drop[SERIES_TERMS], rate[SERIES_TERMS];
    drop_in_step(step, drop);
    for (int k = 0; k < step->order; ++k) {
        rate[k] = -(double)(k + 1) * c->body_share * drop[k + 1];
    }
    rate[0] += com.ground.rate;
    rate[1] -= c->normal_gravity;
    rate[2] += 0.5 * com.normal_jerk;
    record_extrema(measured, taken, rate, step->order - 1, record_height);
    if (taken->ends_at_event) {
        record_height(measured, taken,
                      taken->end); /* in flight nothing jumps, and on the ground it is least */
    }
}

static void record_slip(tdmf_measured *measured, const tdmf_measured_step *taken, double t) {
    const tdmf_step *step = taken->step;
    const double sign = tdmf_slip_sign(&taken->motion->mode);
    const double speed = sign * series_at(step->series.ground.foot_vx, step->order, t);
    if (!(speed > measured->so_far.greatest_slip_velocity)) {
        return;
    }
    measured->so_far.greatest_slip_velocity = speed;
    for (int i = 0; i < taken->count; ++i) {
        measured->varied[i].greatest_slip_velocity =
            sign * series_at(taken->varied_series[i].ground.foot_vx, step->order, t);
    }
}

static void measure_slip(tdmf_measured *measured, const tdmf_measured_step *taken) {
    const double *speed = taken->step->series.ground.foot_vx;
    double rate[SERIES_TERMS];
    for (int k = 0; k < taken->step->order; ++k) {
        rate[k] = (double)(k + 1) * speed[k + 1];
    }
    record_extrema(measured, taken, rate, taken->step->order - 1, record_slip);
}

/* ---- integrals along a step --------------------------------------------------------------------------- */

static double integral_of_product(const double *a, const double *b, int order, double t) {
    double c[SERIES_TERMS] = {0.0};
    for (int k = 0; k <= order; ++k) {
        c[k] = product(a, b, k);
    }
    return series_integral(c, order, t);
}

static double vary_positive_work(const tdmf_measured_step *taken, int i, const tdmf_spans *positive) {
    const tdmf_step *step = taken->step;
    const double *power = step->equations->contact == TDMF_CONTACT_FLIGHT
                              ? taken->varied_series[i].flight.power
                              : taken->varied_series[i].ground.power;
    double work = 0.0;
    for (int k = 0; k < positive->count; ++k) {
        work += series_integral(power, step->order - 1, positive->to[k]) -
                series_integral(power, step->order - 1, positive->from[k]);
    }
    return work;
}

static void vary_integrals(tdmf_measured *measured, const tdmf_measured_step *taken, const double *torque,
                           const tdmf_spans *positive) {
    const tdmf_step *step = taken->step;
    const tdmf_contact_mode contact = step->equations->contact;
    const bool flies = contact == TDMF_CONTACT_FLIGHT;
    const bool slips = !flies && tdmf_step_ground_case(step).slips;
    for (int i = 0; i < taken->count; ++i) {
        const motion_variation *t = &taken->varied_series[i];
        const double *d_torque = flies ? t->flight.torque : t->ground.torque;
        measured->varied[i].friction_loss +=
            slips ? series_integral(t->ground.friction_power, step->order - 1, taken->end) : 0.0;
        measured->varied[i].squared_torque +=
            2.0 * integral_of_product(torque, d_torque, step->order - 1, taken->end);
        measured->varied[i].positive_hip_work += vary_positive_work(taken, i, positive);
    }
}

static void measure_integrals(tdmf_measured *measured, const tdmf_measured_step *taken) {
    const tdmf_step *step = taken->step;
    double in_flight[SERIES_TERMS];
    const double *torque = step->series.ground.torque;
    if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        const flight_series *f = &step->series.flight;
        expand_hip_torque(&step->constants.flight.law, f->angle, f->angle_rate, step->order - 1, in_flight);
        torque = in_flight;
    }
    measured->so_far.squared_torque += integral_of_product(torque, torque, step->order - 1, taken->end);
    if (taken->count > 0) {
        tdmf_spans positive;
        tdmf_positive_spans(step, taken->end, tdmf_step_work(step, taken->end), &positive);
        vary_integrals(measured, taken, torque, &positive);
    }
}

void tdmf_measure_step(tdmf_measured *measured, const tdmf_measured_step *taken) {
    const tdmf_contact_mode contact = taken->step->equations->contact;
    measure_integrals(measured, taken);
    if (contact == TDMF_CONTACT_FLIGHT) {
        measure_height(measured, taken);
    } else if (tdmf_slip_sign(&taken->motion->mode) != 0.0) {
        measure_slip(measured, taken);
    }
}

/* ---- the ends of a stride ----------------------------------------------------------------------------- */

void tdmf_measure_start(tdmf_measured *measured, const tdmf_model *model, const tdmf_motion *motion,
                        const tdmf_seed *seeds, const tdmf_variation *variations, int count) {
    memset(measured, 0, sizeof *measured);
    measured->so_far.greatest_foot_height = foot_height(motion, motion->state);
    for (int i = 0; i < count; ++i) {
        measured->varied[i].greatest_foot_height =
            vary_foot_height(model, motion, motion->state, &seeds[i], variations[i].state);
    }
}

static double squared_torque_of(tdmf_system system, const tdmf_mode *mode,
                                const double state[TDMF_STATE_COUNT]) {
    const double torque = tdmf_evaluate(system, mode, state).torque;
    return torque * torque;
}

void tdmf_measure_end(tdmf_measured *measured, const tdmf_motion *motion) {
    tdmf_stride_measures *m = &measured->so_far;
    m->positive_hip_work = motion->record.stride.positive_work;
    m->friction_loss = motion->state[TDMF_ENERGY_FRICTION_LOSS];
}

void tdmf_vary_measured_end(tdmf_measured *measured, int number, tdmf_system system,
                            const tdmf_motion *motion, const double derivatives[TDMF_STATE_COUNT],
                            double shift) {
    tdmf_stride_measures *d = &measured->varied[number];
    d->positive_hip_work += derivatives[TDMF_HIP_POSITIVE_WORK] * shift;
    d->squared_torque += squared_torque_of(system, &motion->mode, motion->state) * shift;
}

/* ---- events ------------------------------------------------------------------------------------------- */

static void add_shifts(tdmf_measured *measured, tdmf_system system, const tdmf_event_state *before,
                       const tdmf_event_state *after, const tdmf_met_event *met, int count) {
    const double less_power =
        before->derivatives[TDMF_HIP_POSITIVE_WORK] - after->derivatives[TDMF_HIP_POSITIVE_WORK];
    const double less_friction =
        before->derivatives[TDMF_ENERGY_FRICTION_LOSS] - after->derivatives[TDMF_ENERGY_FRICTION_LOSS];
    const double less_torque = squared_torque_of(system, &before->mode, before->state) -
                               squared_torque_of(system, &after->mode, after->state);
    for (int i = 0; i < count; ++i) {
        measured->varied[i].positive_hip_work += less_power * met[i].shift;
        measured->varied[i].friction_loss += less_friction * met[i].shift;
        measured->varied[i].squared_torque += less_torque * met[i].shift;
    }
}

/* A thrust of 0 does none, but one that is a little larger does positive work where it begins. */
static void measure_jump(tdmf_measured *measured, const tdmf_event_state *before,
                         const tdmf_event_state *after, const tdmf_met_event *met, int count) {
    const double work = after->state[TDMF_LEG_WORK] - before->state[TDMF_LEG_WORK];
    const bool begins = after->mode.thrusts && !before->mode.thrusts;
    if (work > 0.0 || (work == 0.0 && begins)) {
        measured->so_far.positive_leg_work += work;
        for (int i = 0; i < count; ++i) {
            measured->varied[i].positive_leg_work +=
                met[i].after[TDMF_LEG_WORK] - met[i].before[TDMF_LEG_WORK];
        }
    }
}

static void record_slip_at_event(tdmf_measured *measured, const tdmf_model *model,
                                 const tdmf_event_state *event_state, const tdmf_seed *seeds,
                                 const tdmf_met_event *met, bool is_after, int count) {
    const double sign = tdmf_slip_sign(&event_state->mode);
    const tdmf_ground_line *line = &event_state->mode.ground;
    const double vx = event_state->state[TDMF_FOOT_VX], vy = event_state->state[TDMF_FOOT_VY];
    const double speed = sign * tdmf_velocity_along(line, vx, vy);
    if (!(speed > measured->so_far.greatest_slip_velocity)) {
        return;
    }
    measured->so_far.greatest_slip_velocity = speed;
    for (int i = 0; i < count; ++i) {
        const tdmf_local_seed d = tdmf_local_seed_of(model, &seeds[i], NULL);
        const double *d_state = is_after ? met[i].after : met[i].before;
        measured->varied[i].greatest_slip_velocity =
            sign * tdmf_vary_velocity_along(line, vx, vy, &d.mode.ground, d_state[TDMF_FOOT_VX],
                                            d_state[TDMF_FOOT_VY]);
    }
}

void tdmf_measure_event(tdmf_measured *measured, tdmf_system system, const tdmf_event_state *before,
                        const tdmf_event_state *after, const tdmf_seed *seeds, const tdmf_met_event *met,
                        int count) {
    add_shifts(measured, system, before, after, met, count);
    measure_jump(measured, before, after, met, count);
    record_slip_at_event(measured, system.model, before, seeds, met, false, count);
    record_slip_at_event(measured, system.model, after, seeds, met, true, count);
}
