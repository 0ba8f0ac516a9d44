/* FMI 3.0 Model Exchange. */
#include "fmi3_instance.h"

/* Calls that Model Exchange alone has, in states that Co-Simulation with event mode reaches too. */
static bool is_model_exchange(const instance *instance, const char *call) {
    if (instance != NULL && instance->interface != MODEL_EXCHANGE) {
        refuse(instance, call, "not allowed in Co-Simulation");
        return false;
    }
    return true;
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance component) {
    static const char call[] = "fmi3EnterContinuousTimeMode";
    if (!is_model_exchange(component, call)) {
        return fmi3Error;
    }
    return (fmi3Status)enter_continuous_time_mode(component, call);
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance component, fmi3Boolean no_set_state_before,
                                       fmi3Boolean *enter_event_mode, fmi3Boolean *terminate_simulation) {
    static const char call[] = "fmi3CompletedIntegratorStep";
    instance *instance = component;
    (void)no_set_state_before;
    if (!call_is_allowed(component, call, CONTINUOUS_TIME_MODE) ||
        !array_is_given(component, call, enter_event_mode, 1, 1) ||
        !array_is_given(component, call, terminate_simulation, 1, 1)) {
        return fmi3Error;
    }
    *enter_event_mode = fmu_complete_step(&instance->fmu);
    *terminate_simulation = fmi3False;
    return fmi3OK;
}

fmi3Status fmi3SetTime(fmi3Instance component, fmi3Float64 time) {
    static const char call[] = "fmi3SetTime";
    if (!is_model_exchange(component, call)) {
        return fmi3Error;
    }
    return (fmi3Status)set_time(component, call, time);
}

fmi3Status fmi3SetContinuousStates(fmi3Instance component, const fmi3Float64 states[], size_t count) {
    return (fmi3Status)set_states(component, "fmi3SetContinuousStates", states, count);
}

fmi3Status fmi3GetContinuousStates(fmi3Instance component, fmi3Float64 states[], size_t count) {
    return (fmi3Status)get_states(component, "fmi3GetContinuousStates", states, count);
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance component, fmi3Float64 derivatives[],
                                             size_t count) {
    return (fmi3Status)get_derivatives(component, "fmi3GetContinuousStateDerivatives", derivatives, count);
}

fmi3Status fmi3GetEventIndicators(fmi3Instance component, fmi3Float64 indicators[], size_t count) {
    return (fmi3Status)get_indicators(component, "fmi3GetEventIndicators", indicators, count);
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance component, fmi3Float64 nominals[], size_t count) {
    return (fmi3Status)get_nominals(component, "fmi3GetNominalsOfContinuousStates", nominals, count);
}

/* The counts never change. */
static fmi3Status get_count(instance *instance, const char *call, size_t value, size_t *count) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, count, 1, 1)) {
        return fmi3Error;
    }
    *count = value;
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance component, size_t *count) {
    return get_count(component, "fmi3GetNumberOfEventIndicators", FMU_GUARD_COUNT, count);
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance component, size_t *count) {
    return get_count(component, "fmi3GetNumberOfContinuousStates", FMU_STATE_COUNT, count);
}
