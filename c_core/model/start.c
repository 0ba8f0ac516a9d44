/* Start of a run. */
#include "tdmf_slip/automaton.h"

#include "apex.h"
#include "contact_change.h"
#include "ground_line.h"
#include "impact.h"
#include "kinematics.h"
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

static tdmf_refusal check_posture(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    tdmf_refusal refusal = {.unit = "m"};
    const double length = state[TDMF_LEG_LENGTH];
    const double height = tdmf_body(state).y;
    if (length < model->parameters.leg.min_length) {
        refusal.variable = "leg.length";
        refusal.value = length;
        refusal.minimum = model->parameters.leg.min_length;
        refusal.maximum = tdmf_state_ranges[TDMF_LEG_LENGTH].maximum;
        refusal.bound_by = "leg.min_length";
    } else if (state[TDMF_FOOT_Y] < 0.0) {
        refusal.variable = "foot.y";
        refusal.value = state[TDMF_FOOT_Y];
        refusal.minimum = 0.0;
        refusal.maximum = tdmf_state_ranges[TDMF_FOOT_Y].maximum;
        refusal.bound_by = "the ground";
    } else if (!(height > 0.0)) {
        refusal.variable = "body.y";
        refusal.value = height;
        refusal.minimum = 0.0;
        refusal.maximum = tdmf_state_ranges[TDMF_FOOT_Y].maximum;
        refusal.bound_by = "above the ground; it follows from foot.y, leg.length and leg.angle";
    }
    return refusal;
}

static tdmf_refusal check_start(const tdmf_model *model, const tdmf_inputs *inputs, double time,
                                const double state[TDMF_STATE_COUNT]) {
    tdmf_refusal refusal = check_time(time);
    if (refusal.variable == NULL) {
        refusal = tdmf_check_inputs(inputs);
    }
    if (refusal.variable == NULL) {
        refusal = check_ranges(state);
    }
    if (refusal.variable == NULL) {
        refusal = check_posture(model, state);
    }
    return refusal;
}

static void begin(tdmf_run *run) {
    const double y = run->state[TDMF_FOOT_Y];
    const double vy = run->state[TDMF_FOOT_VY];
    if (y > 0.0 || vy > 0.0) {
        tdmf_fly(run);
    } else if (vy < 0.0) {
        tdmf_touch_down(run);
    } else {
        tdmf_come_to_ground(run);
    }
    const double vertical_velocity = tdmf_center_of_mass_along(run->model, run->state, run->direction).vy;
    if (run->mode->contact == TDMF_CONTACT_FLIGHT &&
        fabs(vertical_velocity) <= TDMF_APEX_AT_START * run->model->scales.speed) {
        tdmf_pass_apex(run);
    }
}

tdmf_refusal tdmf_start(const tdmf_model *model, const tdmf_inputs *inputs, double time,
                        double state[TDMF_STATE_COUNT], tdmf_mode *mode, tdmf_record *record) {
    const tdmf_refusal refusal = check_start(model, inputs, time, state);
    if (refusal.variable != NULL) {
        return refusal;
    }
    memset(mode, 0, sizeof *mode);
    mode->contact = TDMF_CONTACT_FLIGHT;
    mode->phase = TDMF_PHASE_COAST; /* neither retract nor place: what comes first decides */
    mode->liftoff_angle = state[TDMF_LEG_ANGLE];
    mode->rest_length = tdmf_rest_length(model, inputs, mode);
    mode->ground = tdmf_ground_line_set(inputs);
    for (int i = TDMF_MECHANICAL_COUNT; i < TDMF_STATE_COUNT; ++i) {
        state[i] = 0.0;
    }
    tdmf_record_start(record, time, state);
    tdmf_run run = {model, inputs, time, state, mode, record, tdmf_leg_direction_of(state)};
    begin(&run);
    tdmf_resolve(model, inputs, time, state, mode, record);
    return refusal;
}

tdmf_start_variation tdmf_vary_start(const tdmf_model *model, const tdmf_inputs *inputs,
                                     const double given[TDMF_STATE_COUNT],
                                     const double started[TDMF_STATE_COUNT], const tdmf_change *change,
                                     const double state_direction[TDMF_STATE_COUNT]) {
    tdmf_start_variation varied = {0};
    double *d_state = varied.variation.state;
    memcpy(d_state, state_direction, TDMF_MECHANICAL_COUNT * sizeof *d_state);
    varied.variation.liftoff_angle = d_state[TDMF_LEG_ANGLE];
    if (given[TDMF_FOOT_Y] == 0.0 && given[TDMF_FOOT_VY] < 0.0) {
        const tdmf_direction d = tdmf_direction_of(model, change, NULL);
        varied.impact_loss = tdmf_vary_impact(model, inputs, given, started, &d, d_state);
    }
    return varied;
}
