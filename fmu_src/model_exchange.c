/* Model Exchange: the importer integrates, the unit gives derivatives and event indicators and takes the
 * transitions. Event mode serves Co-Simulation too, where FMI has it. */
#include "instance.h"

#include <string.h>

static const unsigned evaluable =
    INITIALIZATION_MODE | EVENT_MODE | CONTINUOUS_TIME_MODE | TERMINATED | FAILED;

call_status enter_event_mode(instance *instance, const char *call, unsigned allowed_states) {
    if (!call_is_allowed(instance, call, allowed_states)) {
        return CALL_ERROR;
    }
    unit_observe(&instance->unit);
    if (instance->interface == MODEL_EXCHANGE) {
        unit_account_for_extension(&instance->unit);
    }
    instance->state = EVENT_MODE;
    return CALL_OK;
}

call_status update_discrete_states(instance *instance, const char *call, discrete_update *update) {
    if (!call_is_allowed(instance, call, EVENT_MODE)) {
        return CALL_ERROR;
    }
    unit *unit = &instance->unit;
    const unit_observer observer = event_logger(instance);
    const tdmf_resolution resolution = unit_update(unit, &observer);
    forget_view(instance);
    if (resolution.unresolved) {
        return fail(instance, call, "the events at this instant do not come to an end");
    }
    update->states_changed = resolution.state_changed;
    update->terminate = instance->interface == MODEL_EXCHANGE && unit->motion.mode.fallen &&
                        unit->settings.status.terminate_on_fall;
    return CALL_OK;
}

call_status enter_continuous_time_mode(instance *instance, const char *call) {
    if (!call_is_allowed(instance, call, EVENT_MODE)) {
        return CALL_ERROR;
    }
    instance->state = CONTINUOUS_TIME_MODE;
    return CALL_OK;
}

bool step_asks_for_event_mode(instance *instance) {
    if (unit_extension_has_changed(&instance->unit)) {
        return true;
    }
    unit_account_for_extension(&instance->unit); /* no work, from here on */
    return false;
}

call_status set_time(instance *instance, const char *call, double time) {
    if (!call_is_allowed(instance, call, EVENT_MODE | CONTINUOUS_TIME_MODE)) {
        return CALL_ERROR;
    }
    if (!unit_is_time(time)) {
        return refuse(instance, call, "the time is not finite or beyond 1e100 s");
    }
    instance->unit.motion.time = time;
    return CALL_OK;
}

call_status set_states(instance *instance, const char *call, const double states[], size_t count) {
    if (!call_is_allowed(instance, call, CONTINUOUS_TIME_MODE) ||
        !array_is_given(instance, call, states, count, TDMF_STATE_COUNT)) {
        return CALL_ERROR;
    }
    if (!unit_try_state(&instance->unit, states)) {
        return discard(instance, call, "a state is not a number");
    }
    forget_view(instance);
    return CALL_OK;
}

call_status get_states(instance *instance, const char *call, double states[], size_t count) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, states, count, TDMF_STATE_COUNT)) {
        return CALL_ERROR;
    }
    call_status status = CALL_OK;
    const unit_view *view = NULL;
    memcpy(states, instance->unit.motion.state, sizeof instance->unit.motion.state);
    if (!unit_has_begun(&instance->unit)) {
        view = current_view(instance, call, &status);
    }
    if (view != NULL) { /* the start calculates those that have no start value */
        memcpy(states + TDMF_MECHANICAL_COUNT, view->states + TDMF_MECHANICAL_COUNT,
               (TDMF_STATE_COUNT - TDMF_MECHANICAL_COUNT) * sizeof *states);
    }
    return status;
}

call_status get_derivatives(instance *instance, const char *call, double derivatives[], size_t count) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, derivatives, count, TDMF_STATE_COUNT)) {
        return CALL_ERROR;
    }
    unit preview;
    call_status status = CALL_OK;
    const unit *unit = present_unit(instance, call, &preview, &status);
    if (unit != NULL) {
        tdmf_derivatives(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state, derivatives);
    }
    return status;
}

call_status get_indicators(instance *instance, const char *call, double indicators[], size_t count) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, indicators, count, TDMF_GUARD_COUNT)) {
        return CALL_ERROR;
    }
    unit preview;
    call_status status = CALL_OK;
    const unit *unit = present_unit(instance, call, &preview, &status);
    if (unit != NULL) {
        unit_event_indicators(unit, indicators);
    }
    return status;
}

call_status get_nominals(instance *instance, const char *call, double nominals[], size_t count) {
    if (!call_is_allowed(instance, call, INSTANTIATED | evaluable) ||
        !array_is_given(instance, call, nominals, count, TDMF_STATE_COUNT)) {
        return CALL_ERROR;
    }
    unit preview = instance->unit;
    if (!unit_has_begun(&preview)) {
        tdmf_model_create(&preview.model, &preview.parameters); /* stays that of the defaults where refused */
    }
    unit_nominals(&preview, nominals);
    return CALL_OK;
}
