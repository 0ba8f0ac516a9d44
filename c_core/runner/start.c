/* Start of a run: what is refused, and the decision of the runner's page about the rest. */
#include "automaton.h"
#include "ground_line.h"
#include "input_rates.h"
#include "kinematics.h"
#include "margins.h"
#include "page_fields.h"
#include "page_solver.h"
#include "ranges.h"
#include "refusal.h"
#include "rest_length.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- refusals ------------------------------------------------------------------------------------------ */

static tdmf_refusal check_ranges(const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        const double value = state[TDMF_FOOT_X + i];
        if (!tdmf_in_range(&tdmf_state_ranges[i], value)) {
            return tdmf_out_of_range(&tdmf_state_ranges[i], value);
        }
    }
    const tdmf_refusal accepted = {0};
    return accepted;
}

/* A distance from the ground counts as none up to this. */
static double ground_tolerance(const tdmf_model *model, const tdmf_ground_line *ground, double x) {
    return TDMF_AT_GROUND * model->scales.length + tdmf_rounding_of_height(ground, x);
}

static tdmf_refusal too_low(const char *variable, double y, double ground_height, const char *rule) {
    const tdmf_refusal refusal = {.code = TDMF_OUT_OF_RANGE,
                                  .variable = variable,
                                  .unit = "m",
                                  .value = y,
                                  .minimum = ground_height,
                                  .maximum = tdmf_state_ranges[TDMF_FOOT_Y - TDMF_FOOT_X].maximum,
                                  .bound_by = rule};
    return refusal;
}

static tdmf_refusal check_posture(const tdmf_model *model, const tdmf_ground_line *ground,
                                  const double state[TDMF_STATE_COUNT]) {
    const double length = state[TDMF_LEG_LENGTH];
    const double x = state[TDMF_FOOT_X], y = state[TDMF_FOOT_Y];
    const tdmf_point body = tdmf_body(state);
    if (length < model->parameters.leg.min_length) {
        const tdmf_refusal refusal = {.code = TDMF_OUT_OF_RANGE,
                                      .variable = "leg.length",
                                      .unit = "m",
                                      .value = length,
                                      .minimum = model->parameters.leg.min_length,
                                      .maximum = tdmf_state_ranges[TDMF_LEG_LENGTH - TDMF_FOOT_X].maximum,
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

static tdmf_refusal check_start(tdmf_system system, const tdmf_motion *motion) {
    tdmf_refusal why = {0};
    if (tdmf_accepts_pointer(&why, "model", system.model) && tdmf_accepts_pointer(&why, "motion", motion) &&
        tdmf_accepts_number(&why, "time", "s", motion->time, -DBL_MAX, DBL_MAX) &&
        tdmf_accepts(&why, tdmf_check_inputs(system.inputs)) &&
        tdmf_accepts(&why, check_ranges(motion->state))) {
        const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
        return check_posture(system.model, &ground, motion->state);
    }
    return why;
}

/* ---- the start ----------------------------------------------------------------------------------------- */

/* The page at the start of a run from `motion`, whose mode and memory begin anew. */
static tdmf_page_point point_at_start(tdmf_system system, tdmf_motion *motion) {
    tdmf_mode *mode = &motion->mode;
    memset(mode, 0, sizeof *mode);
    mode->contact = TDMF_CONTACT_FLIGHT;
    mode->phase = TDMF_PHASE_RETRACT; /* the page decides */
    mode->ground = tdmf_ground_line_set(system.inputs);
    mode->rest_length = tdmf_rest_length(system.model, system.inputs, mode);
    double given[TDMF_MECHANICAL_COUNT];
    memcpy(given, motion->state + TDMF_FOOT_X, sizeof given);
    memcpy(motion->state, tdmf_runner_model.state_defaults, sizeof motion->state);
    memcpy(motion->state + TDMF_FOOT_X, given, sizeof given);
    motion->state[TDMF_HIP_LIFTOFF_ANGLE] = motion->state[TDMF_LEG_ANGLE];
    motion->begun = motion->time;
    motion->clock_rest = 0.0;
    tdmf_page_point point = tdmf_page_of_motion(system, &tdmf_zero_input_rates, motion);
    point.mode = MODE_start_of_run;
    return point;
}

tdmf_refusal tdmf_start(tdmf_system system, tdmf_motion *motion) {
    const tdmf_refusal refusal = check_start(system, motion);
    if (refusal.variable != NULL) {
        return refusal;
    }
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    const tdmf_point foot = tdmf_foot_over_ground(&ground, motion->state);
    const bool is_impact = foot.y <= ground_tolerance(system.model, &ground, motion->state[TDMF_FOOT_X]) &&
                           foot.vy < -TDMF_AT_GROUND * system.model->scales.speed;
    double memory[TDMF_SETTLING_MEMORY], given[TDMF_MECHANICAL_COUNT];
    memcpy(given, motion->state + TDMF_FOOT_X, sizeof given);
    tdmf_page_point point = point_at_start(system, motion);
    tdmf_page_run run = tdmf_run_at(&point, memory);
    run.order = LEAST_ORDER;
    run.tolerance = 1e-11;
    tdmf_page_run_to(&tdmf_runner_model, &run, 0.0);
    point.mode = run.mode;
    point.above = run.above;
    tdmf_motion_of_page(system, &point, run.mode, motion);
    if (motion->mode.contact == TDMF_CONTACT_FLIGHT && motion->state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR] == 0.0) {
        memcpy(motion->state + TDMF_FOOT_X, given, sizeof given); /* removes the rounding of the two maps */
    }
    /* An impact counts as an event and as a touchdown; that a foot at rest is on the ground is none. */
    motion->state[TDMF_EVENT_COUNT] = is_impact;
    motion->state[TDMF_EVENT_LAST_TIME] = is_impact ? 0.0 : -DBL_MIN; /* so that an event at time 0 is new */
    motion->state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR] *= is_impact;
    motion->state[TDMF_HIP_TOUCHDOWN_TIME] = -DBL_MIN;
    tdmf_observe(system, motion);
    return refusal;
}
