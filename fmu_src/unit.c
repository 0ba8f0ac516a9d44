/* A runner with its settings, FMI left out. */
#include "unit.h"

#include "variables.h"

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
}

tdmf_refusal unit_start(unit *unit) {
    tdmf_model model;
    const tdmf_refusal refusal = tdmf_model_create(&model, &unit->parameters);
    if (refusal.variable != NULL) {
        return refusal;
    }
    unit->model = model;
    return tdmf_start(&unit->model, &unit->inputs, unit->time, unit->state, &unit->mode, &unit->record);
}

void unit_look(const unit *unit, unit_view *view) {
    tdmf_derivatives(&unit->model, &unit->inputs, &unit->mode, unit->state, view->derivatives);
    view->outputs = tdmf_outputs_of(&unit->model, &unit->inputs, &unit->mode, &unit->record, unit->state);
}

bool unit_try_state(unit *unit, const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        if (isnan(state[i])) {
            return false;
        }
    }
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        unit->state[i] = fmax(-largest_trial, fmin(largest_trial, state[i]));
    }
    return true;
}

void unit_event_indicators(const unit *unit, double indicators[TDMF_GUARD_COUNT]) {
    tdmf_guards(&unit->model, &unit->inputs, &unit->mode, unit->state, indicators);
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
    tdmf_observe(&unit->model, &unit->inputs, unit->state, &unit->mode, &unit->record);
}

tdmf_resolution unit_update(unit *unit) {
    return tdmf_resolve(&unit->model, &unit->inputs, unit->time, unit->state, &unit->mode, &unit->record);
}
