/* FMI 3.0 Co-Simulation. With event mode and early return a step ends at the first event, at its exact time
 * and before it is taken; fmi3UpdateDiscreteStates takes it. Otherwise events are taken inside the step, and
 * event mode serves to let inputs jump. */
#include "fmi3_instance.h"

fmi3Status fmi3EnterStepMode(fmi3Instance component) {
    static const char call[] = "fmi3EnterStepMode";
    instance *instance = component;
    if (!call_is_allowed(instance, call, EVENT_MODE)) {
        return fmi3Error;
    }
    if (instance->interface == MODEL_EXCHANGE) {
        return (fmi3Status)refuse(instance, call, "not allowed in Model Exchange");
    }
    instance->state = STEP_MODE;
    return fmi3OK;
}

fmi3Status fmi3DoStep(fmi3Instance component, fmi3Float64 time, fmi3Float64 step,
                      fmi3Boolean no_set_state_before, fmi3Boolean *event_handling_needed,
                      fmi3Boolean *terminate_simulation, fmi3Boolean *early_return,
                      fmi3Float64 *last_successful_time) {
    static const char call[] = "fmi3DoStep";
    (void)no_set_state_before;
    if (!call_is_allowed(component, call, STEP_MODE) ||
        !array_is_given(component, call, event_handling_needed, 1, 1) ||
        !array_is_given(component, call, terminate_simulation, 1, 1) ||
        !array_is_given(component, call, early_return, 1, 1) ||
        !array_is_given(component, call, last_successful_time, 1, 1)) {
        return fmi3Error;
    }
    fmi3_instance *own = component;
    const bool stop_at_event =
        own->instance.interface == CO_SIMULATION_WITH_EVENT_MODE && own->early_return_allowed;
    bool event = false;
    const call_status status = step_on(component, call, time, step, stop_at_event, &event);
    *event_handling_needed = event;
    *terminate_simulation = fmi3False;
    *last_successful_time = fmu_time(&own->instance.fmu);
    *early_return = event && *last_successful_time < time + step;
    return (fmi3Status)status;
}

fmi3Status fmi3GetOutputDerivatives(fmi3Instance component, const fmi3ValueReference references[],
                                    size_t count, const fmi3Int32 orders[], fmi3Float64 values[],
                                    size_t value_count) {
    static const char call[] = "fmi3GetOutputDerivatives";
    if (!call_is_allowed(component, call, ANYWHERE) ||
        !array_is_given(component, call, values, value_count, count)) {
        return fmi3Error;
    }
    return (fmi3Status)output_derivatives(component, call, references, count, (const int *)orders, values);
}
