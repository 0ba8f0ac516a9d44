/* A runner with its settings, FMI left out. */
#include "unit.h"

#include "tdmf_slip/cvode.h"
#include "variables.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* Far beyond any motion, and far enough from overflow for every product of the equations. */
static const double largest_trial = 1e60;

void unit_reset(unit *unit) {
    memset(unit, 0, sizeof *unit);
    for (size_t i = 0; i < unit_variable_count; ++i) {
        const unit_variable *variable = &unit_variables[i];
        if (variable->settable_before_start) {
            unit_set_number(unit, variable, variable->start);
        }
    }
    tdmf_model_create(&unit->model, &unit->parameters);
    unit->importer_tolerance = INFINITY;
    unit->solver = tdmf_solver_default();
}

tdmf_refusal unit_start(unit *unit) {
    tdmf_model model;
    const tdmf_refusal refusal = tdmf_model_create(&model, &unit->parameters);
    if (refusal.variable != NULL) {
        return refusal;
    }
    unit->model = model;
    unit->solver.relative_tolerance =
        fmin(unit->settings.solver.relative_tolerance, unit->importer_tolerance);
    return tdmf_start(&unit->model, &unit->inputs, unit->motion.time, unit->motion.state, &unit->motion.mode,
                      &unit->motion.record);
}

static int as_integer(long count) {
    return count < INT_MAX ? (int)count : INT_MAX;
}

void unit_look(const unit *unit, unit_view *view) {
    tdmf_derivatives(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state, view->derivatives);
    view->outputs = tdmf_outputs_of(&unit->model, &unit->inputs, &unit->motion.mode, &unit->motion.record,
                                    unit->motion.state);
    view->work.solver.steps = as_integer(unit->solver.steps);
    view->work.solver.evaluations = as_integer(unit->solver.evaluations);
}

void unit_look_along(const unit *unit, const struct unit *direction, unit_view *change) {
    const tdmf_motion *motion = &unit->motion;
    const tdmf_tangent tangent = tdmf_tangent_along(&unit->model, &unit->inputs, &motion->mode, motion->state,
                                                    &direction->inputs, direction->motion.state);
    memset(change, 0, sizeof *change);
    memcpy(change->derivatives, tangent.derivatives, sizeof change->derivatives);
    change->outputs.body.x = tangent.body.x;
    change->outputs.body.y = tangent.body.y;
    change->outputs.body.vx = tangent.body.vx;
    change->outputs.body.vy = tangent.body.vy;
    change->outputs.com.x = tangent.com.x;
    change->outputs.com.y = tangent.com.y;
    change->outputs.com.vx = tangent.com.vx;
    change->outputs.com.vy = tangent.com.vy;
    change->outputs.contact.fx = tangent.contact.fx;
    change->outputs.contact.fy = tangent.contact.fy;
    change->outputs.hip.torque = tangent.torque;
    change->outputs.energy.kinetic = tangent.energy.kinetic;
    change->outputs.energy.potential = tangent.energy.potential;
    change->outputs.energy.elastic = tangent.energy.elastic;
    change->outputs.energy.total = tangent.energy.total;
}

void unit_flow(const unit *unit, struct unit *direction) {
    memset(direction, 0, sizeof *direction);
    tdmf_derivatives(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state,
                     direction->motion.state);
    direction->inputs.ground.friction = unit->input_rates.friction;
    direction->inputs.hip.external_torque = unit->input_rates.external_torque;
}

bool unit_try_state(unit *unit, const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        if (isnan(state[i])) {
            return false;
        }
    }
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        unit->motion.state[i] = fmax(-largest_trial, fmin(largest_trial, state[i]));
    }
    return true;
}

void unit_event_indicators(const unit *unit, double indicators[TDMF_GUARD_COUNT]) {
    tdmf_guards(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state, indicators);
}

void unit_nominals(const unit *unit, double nominals[TDMF_STATE_COUNT]) {
    const tdmf_scales *scales = &unit->model.scales;
    nominals[TDMF_FOOT_X] = scales->length;
    nominals[TDMF_FOOT_Y] = scales->length;
    nominals[TDMF_LEG_LENGTH] = scales->length;
    nominals[TDMF_LEG_ANGLE] = 1.0;
    nominals[TDMF_FOOT_VX] = scales->speed;
    nominals[TDMF_FOOT_VY] = scales->speed;
    nominals[TDMF_LEG_LENGTH_RATE] = scales->speed;
    nominals[TDMF_LEG_ANGLE_RATE] = 1.0 / scales->time;
    for (int i = TDMF_MECHANICAL_COUNT; i < TDMF_STATE_COUNT; ++i) {
        nominals[i] = scales->energy;
    }
}

void unit_observe(unit *unit) {
    tdmf_observe(&unit->model, &unit->inputs, unit->motion.state, &unit->motion.mode, &unit->motion.record);
}

tdmf_resolution unit_update(unit *unit) {
    return tdmf_resolve(&unit->model, &unit->inputs, unit->motion.time, unit->motion.state,
                        &unit->motion.mode, &unit->motion.record);
}

const char *unit_settings_obstacle(const unit *unit) {
    if (unit->settings.solver.method == SOLVER_CVODE && !tdmf_cvode_is_available()) {
        return "solver.method = cvode is refused: this unit was built without SUNDIALS; allowed: native";
    }
    return NULL;
}

const char *unit_advance(unit *unit, double until) {
    const double start = unit->motion.time;
    const bool by_cvode = unit->settings.solver.method == SOLVER_CVODE;
    const tdmf_outcome outcome = (by_cvode ? tdmf_cvode_advance : tdmf_native_advance)(
        &unit->solver, &unit->model, &unit->inputs, &unit->input_rates, until, &unit->motion);
    if (outcome == TDMF_FELL) {
        unit->motion.time = until;
    }
    unit->inputs = tdmf_inputs_after(&unit->inputs, &unit->input_rates, unit->motion.time - start);
    return outcome == TDMF_ARRIVED || outcome == TDMF_FELL ? NULL : tdmf_outcome_text(outcome);
}

int unit_first_difference(const unit *a, const unit *b) {
    for (size_t i = 0; i < unit_variable_count; ++i) {
        const unit_variable *variable = &unit_variables[i];
        const bool is_parameter =
            variable->storage == STORED_PARAMETER || variable->storage == STORED_SETTING;
        if (is_parameter && unit_get_number(a, NULL, variable) != unit_get_number(b, NULL, variable)) {
            return (int)i;
        }
    }
    return -1;
}
