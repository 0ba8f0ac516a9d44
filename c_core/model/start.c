/* Start of a run. */
#include "tdmf_slip/automaton.h"

#include "apex.h"
#include "contact_change.h"
#include "coordinate_laws.h"
#include "ground_line.h"
#include "impact.h"
#include "leg.h"
#include "margins.h"
#include "ranges.h"
#include "record.h"
#include "touchdown.h"

#include <float.h>
#include <math.h>
#include <string.h>

static tdmf_refusal check_time(double time) {
    const tdmf_refusal refusal = {.variable = isfinite(time) ? NULL : "time",
                                  .unit = "s",
                                  .value = time,
                                  .minimum = -DBL_MAX,
                                  .maximum = DBL_MAX};
    return refusal;
}

static tdmf_refusal check_ranges(const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        if (!tdmf_in_range(&tdmf_state_ranges[i], state[i])) {
            return tdmf_out_of_range(&tdmf_state_ranges[i], state[i]);
        }
    }
    const tdmf_refusal accepted = {0};
    return accepted;
}

/* A distance from the ground counts as none up to this. */
static double ground_tolerance(const tdmf_model *model, const tdmf_ground_line *ground, double x) {
    return TDMF_AT_GROUND * model->scales.length + tdmf_rounding_of_height(ground, x);
}

static bool foot_is_at_ground(const tdmf_model *model, const tdmf_ground_line *ground,
                              const double state[TDMF_STATE_COUNT]) {
    const double x = state[TDMF_FOOT_X];
    return fabs(tdmf_height_over(ground, x, state[TDMF_FOOT_Y])) <= ground_tolerance(model, ground, x);
}

/* The velocity of a foot at the ground across it. */
static double rate_of_foot(const tdmf_model *model, const tdmf_ground_line *ground,
                           const double state[TDMF_STATE_COUNT]) {
    const double rate = tdmf_velocity_off(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    return fabs(rate) <= TDMF_AT_GROUND * model->scales.speed ? 0.0 : rate;
}

static tdmf_refusal too_low(const char *variable, double y, double ground_height, const char *rule) {
    const tdmf_refusal refusal = {.variable = variable,
                                  .unit = "m",
                                  .value = y,
                                  .minimum = ground_height,
                                  .maximum = tdmf_state_ranges[TDMF_FOOT_Y].maximum,
                                  .bound_by = rule};
    return refusal;
}

static tdmf_refusal check_posture(const tdmf_model *model, const tdmf_ground_line *ground,
                                  const double state[TDMF_STATE_COUNT]) {
    const double length = state[TDMF_LEG_LENGTH];
    const double x = state[TDMF_FOOT_X], y = state[TDMF_FOOT_Y];
    const tdmf_point body = tdmf_body(state);
    if (length < model->parameters.leg.min_length) {
        const tdmf_refusal refusal = {.variable = "leg.length",
                                      .unit = "m",
                                      .value = length,
                                      .minimum = model->parameters.leg.min_length,
                                      .maximum = tdmf_state_ranges[TDMF_LEG_LENGTH].maximum,
                                      .bound_by = "leg.min_length"};
        return refusal;
    }
    if (tdmf_height_over(ground, x, y) < -ground_tolerance(model, ground, x)) {
        return too_low("foot.y", y, tdmf_ground_height_at(ground, x), "the ground");
    }
    if (!(tdmf_height_over(ground, body.x, body.y) > 0.0)) {
        return too_low("body.y", body.y, tdmf_ground_height_at(ground, body.x),
                       "above the ground; it follows from foot.y, leg.length and leg.angle");
    }
    const tdmf_refusal accepted = {0};
    return accepted;
}

static tdmf_refusal check_start(tdmf_system system, double time, const double state[TDMF_STATE_COUNT]) {
    tdmf_refusal refusal = check_time(time);
    if (refusal.variable == NULL) {
        refusal = tdmf_check_inputs(system.inputs);
    }
    if (refusal.variable == NULL) {
        refusal = check_ranges(state);
    }
    if (refusal.variable == NULL) {
        const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
        refusal = check_posture(system.model, &ground, state);
    }
    return refusal;
}

/* Leaves a foot at the ground its velocity along it. */
static void stop_across(const tdmf_ground_line *ground, double state[TDMF_STATE_COUNT]) {
    const tdmf_point foot =
        tdmf_point_on(ground, 0.0, tdmf_velocity_along(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]));
    state[TDMF_FOOT_VX] = foot.vx;
    state[TDMF_FOOT_VY] = foot.vy;
}

static void begin(tdmf_run *run) {
    const tdmf_ground_line *ground = &run->motion->mode.ground;
    const double rate = rate_of_foot(run->system.model, ground, run->motion->state);
    if (!foot_is_at_ground(run->system.model, ground, run->motion->state)) {
        tdmf_fly(run);
    } else {
        tdmf_lift_to_ground(ground, run->motion->state);
        if (rate > 0.0) {
            tdmf_fly(run);
        } else if (rate < 0.0) {
            tdmf_touch_down(run);
        } else {
            stop_across(ground, run->motion->state);
            tdmf_come_to_ground(run);
        }
    }
    const double vertical_velocity =
        tdmf_center_of_mass_along(run->system.model, run->motion->state, run->direction).vy;
    if (run->motion->mode.contact == TDMF_CONTACT_FLIGHT &&
        fabs(vertical_velocity) <= TDMF_APEX_AT_START * run->system.model->scales.speed) {
        tdmf_pass_apex(run);
    }
}

tdmf_refusal tdmf_start(tdmf_system system, tdmf_motion *motion) {
    const char *absent = system.model == NULL ? "model" : motion == NULL ? "motion" : NULL;
    if (absent != NULL) {
        return tdmf_absent(absent);
    }
    const tdmf_refusal refusal = check_start(system, motion->time, motion->state);
    if (refusal.variable != NULL) {
        return refusal;
    }
    tdmf_mode *mode = &motion->mode;
    memset(mode, 0, sizeof *mode);
    mode->contact = TDMF_CONTACT_FLIGHT;
    mode->phase = TDMF_PHASE_COAST; /* neither retract nor place: what comes first decides */
    mode->liftoff_angle = motion->state[TDMF_LEG_ANGLE];
    mode->rest_length = tdmf_rest_length(system.model, system.inputs, mode);
    mode->ground = tdmf_ground_line_set(system.inputs);
    for (int i = TDMF_MECHANICAL_COUNT; i < TDMF_STATE_COUNT; ++i) {
        motion->state[i] = 0.0;
    }
    tdmf_record_start(motion);
    tdmf_run run = {system, motion, tdmf_leg_direction_of(motion->state)};
    begin(&run);
    tdmf_resolve(system, motion);
    return refusal;
}

tdmf_start_variation tdmf_vary_start(tdmf_system system, const double given[TDMF_STATE_COUNT],
                                     const double started[TDMF_STATE_COUNT], const tdmf_mode *mode,
                                     const tdmf_seed *seed, const double state_seed[TDMF_STATE_COUNT]) {
    tdmf_start_variation varied = {0};
    double *d_state = varied.variation.state;
    memcpy(d_state, state_seed, TDMF_MECHANICAL_COUNT * sizeof *d_state);
    varied.variation.liftoff_angle = d_state[TDMF_LEG_ANGLE];
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    const tdmf_local_seed d = tdmf_local_seed_of(system.model, seed, NULL);
    if (foot_is_at_ground(system.model, &ground, given) && rate_of_foot(system.model, &ground, given) < 0.0) {
        varied.impact_loss = tdmf_vary_impact(system, &ground, given, &d, d_state);
    }
    tdmf_mode before = *mode;
    before.thrusts = false; /* it may from the start on */
    d_state[TDMF_LEG_WORK] =
        tdmf_vary_leg_work_between(system.model, system.inputs, started[TDMF_LEG_LENGTH], &before, mode,
                                   &d.model, &d.inputs, d_state[TDMF_LEG_LENGTH], &d.mode, &d.mode);
    const tdmf_leg_direction direction = tdmf_leg_direction_of(started);
    const tdmf_point com = tdmf_center_of_mass_along(system.model, started, direction);
    const tdmf_point d_com =
        tdmf_vary_center_of_mass_along(system.model, started, direction, &d.model, d_state);
    varied.com_height = d_com.y - tdmf_vary_ground_height_at(&ground, com.x, &d.mode.ground, d_com.x);
    return varied;
}
