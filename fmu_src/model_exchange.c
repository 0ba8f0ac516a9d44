/* Model Exchange: the importer integrates, the unit gives derivatives and event indicators and takes the
 * transitions. Event mode serves Co-Simulation too, where FMI has it. */
#include "instance.h"

#include <math.h>

static const unsigned evaluable =
    INITIALIZATION_MODE | EVENT_MODE | CONTINUOUS_TIME_MODE | TERMINATED | FAILED;

call_status enter_event_mode(instance *instance, const char *call, unsigned allowed_states) {
    if (!call_is_allowed(instance, call, allowed_states)) {
        return CALL_ERROR;
    }
    fmu_enter_event_mode(&instance->fmu);
    instance->state = EVENT_MODE;
    return CALL_OK;
}

/* An importer's solver makes steps as long as it likes, but none beyond a time event. */
call_status update_discrete_states(instance *instance, const char *call, discrete_update *update) {
    if (!call_is_allowed(instance, call, EVENT_MODE)) {
        return CALL_ERROR;
    }
    fmu *fmu = &instance->fmu;
    const fmu_observer observer = event_logger(instance);
    const fmu_resolution resolution = fmu_update(fmu, &observer);
    discard_view(instance);
    if (resolution.unresolved) {
        return fail(instance, call, "the events at this instant do not come to an end");
    }
    update->states_changed = resolution.state_changed;
    update->terminate = fmu_asks_to_terminate(fmu);
    const double longest = fmu_longest_step(fmu);
    update->next_time_defined = instance->interface == MODEL_EXCHANGE && isfinite(longest);
    update->next_time = update->next_time_defined ? fmu_time(fmu) + longest : 0.0;
    return CALL_OK;
}

call_status enter_continuous_time_mode(instance *instance, const char *call) {
    if (!call_is_allowed(instance, call, EVENT_MODE)) {
        return CALL_ERROR;
    }
    instance->state = CONTINUOUS_TIME_MODE;
    return CALL_OK;
}

call_status set_time(instance *instance, const char *call, double time) {
    if (!call_is_allowed(instance, call, EVENT_MODE | CONTINUOUS_TIME_MODE)) {
        return CALL_ERROR;
    }
    if (!fmu_is_time(time)) {
        return refuse(instance, call, "the time is not finite or beyond 1e100 s");
    }
    fmu_set_time(&instance->fmu, time);
    return CALL_OK;
}

call_status set_states(instance *instance, const char *call, const double states[], size_t count) {
    if (!call_is_allowed(instance, call, CONTINUOUS_TIME_MODE) ||
        !array_is_given(instance, call, states, count, FMU_STATE_COUNT)) {
        return CALL_ERROR;
    }
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        if (isnan(states[i])) {
            return discard(instance, call, "a state is not a number");
        }
    }
    fmu_try_states(&instance->fmu, states);
    discard_view(instance);
    return CALL_OK;
}

call_status get_states(instance *instance, const char *call, double states[], size_t count) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, states, count, FMU_STATE_COUNT)) {
        return CALL_ERROR;
    }
    call_status status = CALL_OK;
    const fmu_view *view = fmu_has_begun(&instance->fmu) ? NULL : current_view(instance, call, &status);
    fmu_states(&instance->fmu, view, states);
    return status;
}

call_status get_derivatives(instance *instance, const char *call, double derivatives[], size_t count) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, derivatives, count, FMU_STATE_COUNT)) {
        return CALL_ERROR;
    }
    fmu preview;
    call_status status = CALL_OK;
    const fmu *fmu = present_fmu(instance, call, &preview, &status);
    if (fmu != NULL) {
        fmu_derivatives(fmu, derivatives);
    }
    return status;
}

call_status get_indicators(instance *instance, const char *call, double indicators[], size_t count) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, indicators, count, FMU_GUARD_COUNT)) {
        return CALL_ERROR;
    }
    fmu preview;
    call_status status = CALL_OK;
    const fmu *fmu = present_fmu(instance, call, &preview, &status);
    if (fmu != NULL) {
        fmu_event_indicators(fmu, indicators);
    }
    return status;
}

call_status get_nominals(instance *instance, const char *call, double nominals[], size_t count) {
    if (!call_is_allowed(instance, call, INSTANTIATED | evaluable) ||
        !array_is_given(instance, call, nominals, count, FMU_STATE_COUNT)) {
        return CALL_ERROR;
    }
    fmu preview = instance->fmu;
    char text[FMU_TEXT];
    if (!fmu_has_begun(&preview)) {
        fmu_prepare(&preview, text); /* stays that of the defaults where refused */
    }
    fmu_nominals(&preview, nominals);
    return CALL_OK;
}
