/* FMI 2.0 Model Exchange. */
#include "fmi2_instance.h"

#include <string.h>

fmi2Status fmi2EnterEventMode(fmi2Component component) {
    return (fmi2Status)enter_event_mode(component, "fmi2EnterEventMode", EVENT_MODE | CONTINUOUS_TIME_MODE);
}

fmi2Status fmi2NewDiscreteStates(fmi2Component component, fmi2EventInfo *info) {
    static const char call[] = "fmi2NewDiscreteStates";
    if (!call_is_allowed(component, call, EVENT_MODE) || !array_is_given(component, call, info, 1, 1)) {
        return fmi2Error;
    }
    discrete_update update = {0};
    const call_status status = update_discrete_states(component, call, &update);
    memset(info, 0, sizeof *info);
    info->valuesOfContinuousStatesChanged = update.states_changed ? fmi2True : fmi2False;
    info->terminateSimulation = update.terminate ? fmi2True : fmi2False;
    info->nextEventTimeDefined = update.next_time_defined ? fmi2True : fmi2False;
    info->nextEventTime = update.next_time;
    return (fmi2Status)status;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component component) {
    return (fmi2Status)enter_continuous_time_mode(component, "fmi2EnterContinuousTimeMode");
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component component, fmi2Boolean no_set_state_before,
                                       fmi2Boolean *enter_event_mode, fmi2Boolean *terminate) {
    static const char call[] = "fmi2CompletedIntegratorStep";
    instance *instance = component;
    (void)no_set_state_before;
    if (!call_is_allowed(component, call, CONTINUOUS_TIME_MODE) ||
        !array_is_given(component, call, enter_event_mode, 1, 1) ||
        !array_is_given(component, call, terminate, 1, 1)) {
        return fmi2Error;
    }
    *enter_event_mode = fmu_complete_step(&instance->fmu) ? fmi2True : fmi2False;
    *terminate = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2SetTime(fmi2Component component, fmi2Real time) {
    return (fmi2Status)set_time(component, "fmi2SetTime", time);
}

fmi2Status fmi2SetContinuousStates(fmi2Component component, const fmi2Real states[], size_t count) {
    return (fmi2Status)set_states(component, "fmi2SetContinuousStates", states, count);
}

fmi2Status fmi2GetContinuousStates(fmi2Component component, fmi2Real states[], size_t count) {
    return (fmi2Status)get_states(component, "fmi2GetContinuousStates", states, count);
}

fmi2Status fmi2GetDerivatives(fmi2Component component, fmi2Real derivatives[], size_t count) {
    return (fmi2Status)get_derivatives(component, "fmi2GetDerivatives", derivatives, count);
}

fmi2Status fmi2GetEventIndicators(fmi2Component component, fmi2Real indicators[], size_t count) {
    return (fmi2Status)get_indicators(component, "fmi2GetEventIndicators", indicators, count);
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component component, fmi2Real nominals[], size_t count) {
    return (fmi2Status)get_nominals(component, "fmi2GetNominalsOfContinuousStates", nominals, count);
}
