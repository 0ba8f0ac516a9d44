/* FMI 2.0 Model Exchange: the importer integrates, the unit gives derivatives and event indicators and takes
 * the transitions. */
#include "fmi2_instance.h"

#include <math.h>
#include <string.h>

static const unsigned evaluable = EVENT_MODE | CONTINUOUS_TIME_MODE | TERMINATED | FAILED;

fmi2Status fmi2EnterEventMode(fmi2Component component) {
    instance *instance = component;
    if (!call_is_allowed(instance, "fmi2EnterEventMode", EVENT_MODE | CONTINUOUS_TIME_MODE)) {
        return fmi2Error;
    }
    unit_observe(&instance->unit);
    instance->state = EVENT_MODE;
    return fmi2OK;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component component, fmi2EventInfo *info) {
    static const char call[] = "fmi2NewDiscreteStates";
    instance *instance = component;
    if (!call_is_allowed(instance, call, EVENT_MODE) || !array_is_given(instance, call, info, 1, 1)) {
        return fmi2Error;
    }
    const tdmf_mode before = instance->unit.motion.mode;
    const tdmf_resolution resolution = unit_update(&instance->unit);
    forget_view(instance);
    log_changes(instance, &before);
    if (resolution.unresolved) {
        return fail(instance, call, "the events at this instant do not come to an end");
    }
    memset(info, 0, sizeof *info);
    info->valuesOfContinuousStatesChanged = resolution.state_changed ? fmi2True : fmi2False;
    info->terminateSimulation =
        instance->unit.motion.mode.fallen && instance->unit.settings.status.terminate_on_fall ? fmi2True
                                                                                              : fmi2False;
    return fmi2OK;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component component) {
    instance *instance = component;
    if (!call_is_allowed(instance, "fmi2EnterContinuousTimeMode", EVENT_MODE)) {
        return fmi2Error;
    }
    instance->state = CONTINUOUS_TIME_MODE;
    return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component component, fmi2Boolean no_set_state_before,
                                       fmi2Boolean *enter_event_mode, fmi2Boolean *terminate) {
    static const char call[] = "fmi2CompletedIntegratorStep";
    (void)no_set_state_before;
    instance *instance = component;
    if (!call_is_allowed(instance, call, CONTINUOUS_TIME_MODE) ||
        !array_is_given(instance, call, enter_event_mode, 1, 1) ||
        !array_is_given(instance, call, terminate, 1, 1)) {
        return fmi2Error;
    }
    *enter_event_mode = fmi2False;
    *terminate = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2SetTime(fmi2Component component, fmi2Real time) {
    instance *instance = component;
    if (!call_is_allowed(instance, "fmi2SetTime", EVENT_MODE | CONTINUOUS_TIME_MODE)) {
        return fmi2Error;
    }
    if (!isfinite(time)) {
        return fail(instance, "fmi2SetTime", "the time is not finite");
    }
    instance->unit.motion.time = time;
    return fmi2OK;
}

fmi2Status fmi2SetContinuousStates(fmi2Component component, const fmi2Real states[], size_t count) {
    static const char call[] = "fmi2SetContinuousStates";
    instance *instance = component;
    if (!call_is_allowed(instance, call, CONTINUOUS_TIME_MODE) ||
        !array_is_given(instance, call, states, count, TDMF_STATE_COUNT)) {
        return fmi2Error;
    }
    if (!unit_try_state(&instance->unit, states)) {
        return discard(instance, call, "a state is not a number");
    }
    forget_view(instance);
    return fmi2OK;
}

fmi2Status fmi2GetContinuousStates(fmi2Component component, fmi2Real states[], size_t count) {
    static const char call[] = "fmi2GetContinuousStates";
    instance *instance = component;
    if (!call_is_allowed(instance, call, evaluable | INITIALIZATION_MODE) ||
        !array_is_given(instance, call, states, count, TDMF_STATE_COUNT)) {
        return fmi2Error;
    }
    memcpy(states, instance->unit.motion.state, sizeof instance->unit.motion.state);
    return fmi2OK;
}

fmi2Status fmi2GetDerivatives(fmi2Component component, fmi2Real derivatives[], size_t count) {
    static const char call[] = "fmi2GetDerivatives";
    instance *instance = component;
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, derivatives, count, TDMF_STATE_COUNT)) {
        return fmi2Error;
    }
    const unit *unit = &instance->unit;
    tdmf_derivatives(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state, derivatives);
    return fmi2OK;
}

fmi2Status fmi2GetEventIndicators(fmi2Component component, fmi2Real indicators[], size_t count) {
    static const char call[] = "fmi2GetEventIndicators";
    instance *instance = component;
    if (!call_is_allowed(instance, call, evaluable | INITIALIZATION_MODE) ||
        !array_is_given(instance, call, indicators, count, TDMF_GUARD_COUNT)) {
        return fmi2Error;
    }
    unit_event_indicators(&instance->unit, indicators);
    return fmi2OK;
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component component, fmi2Real nominals[], size_t count) {
    static const char call[] = "fmi2GetNominalsOfContinuousStates";
    instance *instance = component;
    if (!call_is_allowed(instance, call, INSTANTIATED | evaluable) ||
        !array_is_given(instance, call, nominals, count, TDMF_STATE_COUNT)) {
        return fmi2Error;
    }
    unit_nominals(&instance->unit, nominals);
    return fmi2OK;
}
