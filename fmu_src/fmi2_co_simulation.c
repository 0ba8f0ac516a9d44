/* FMI 2.0 Co-Simulation. */
#include "fmi2_instance.h"

#include <math.h>

static const unsigned after_steps = STEP_MODE | TERMINATED | FAILED;

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real step,
                      fmi2Boolean no_set_state_before) {
    (void)no_set_state_before;
    bool event = false;
    return (fmi2Status)step_on(component, "fmi2DoStep", time, step, false, &event);
}

fmi2Status fmi2CancelStep(fmi2Component component) {
    if (component == NULL) {
        return fmi2Error;
    }
    return (fmi2Status)refuse(component, "fmi2CancelStep",
                              "no step is under way: steps are not asynchronous");
}

/* ---- derivatives of inputs and outputs ---------------------------------------------------------------- */

static call_status check_input_rate(instance *instance, const char *call, fmi2ValueReference reference,
                                    fmi2Integer order, double value) {
    const fmu_variable *variable = find_variable(instance, call, reference, VARIABLE_REAL);
    if (variable == NULL) {
        return CALL_ERROR;
    }
    if (variable->storage != STORED_INPUT) {
        return refuse(instance, call, "%s is not an input", variable->name);
    }
    if (variable->variability != VARIABILITY_CONTINUOUS) {
        return refuse(instance, call, "%s changes at events only: it has no derivative", variable->name);
    }
    if (order != 1) {
        return refuse(instance, call, "only first derivatives of inputs are taken, not order %d", order);
    }
    if (!isfinite(value)) {
        return discard(instance, call, "the derivative of %s is not finite", variable->name);
    }
    return CALL_OK;
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference references[],
                                       size_t count, const fmi2Integer orders[], const fmi2Real values[]) {
    static const char call[] = "fmi2SetRealInputDerivatives";
    instance *instance = component;
    if (!call_is_allowed(instance, call, BEFORE_START | STEP_MODE) ||
        !array_is_given(instance, call, references, count, count) ||
        !array_is_given(instance, call, orders, count, count) ||
        !array_is_given(instance, call, values, count, count)) {
        return fmi2Error;
    }
    call_status status = CALL_OK;
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        status = check_input_rate(instance, call, references[i], orders[i], values[i]);
    }
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        fmu_set_number_rate(&instance->fmu, &fmu_variables[references[i]], values[i]);
    }
    return (fmi2Status)status;
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference references[],
                                        size_t count, const fmi2Integer orders[], fmi2Real values[]) {
    return (fmi2Status)output_derivatives(component, "fmi2GetRealOutputDerivatives", references, count,
                                          orders, values);
}

/* ---- status of asynchronous steps, which there are none of -------------------------------------------- */

static fmi2Status refuse_status(fmi2Component component, const char *call) {
    if (!call_is_allowed(component, call, after_steps)) {
        return fmi2Error;
    }
    return (fmi2Status)discard(component, call, "steps are not asynchronous, there is no such status");
}

fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Status *value) {
    (void)kind;
    (void)value;
    return refuse_status(component, "fmi2GetStatus");
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value) {
    static const char call[] = "fmi2GetRealStatus";
    const instance *instance = component;
    if (kind != fmi2LastSuccessfulTime) {
        return refuse_status(component, call);
    }
    if (!call_is_allowed(component, call, after_steps) || !array_is_given(component, call, value, 1, 1)) {
        return fmi2Error;
    }
    *value = fmu_time(&instance->fmu);
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Integer *value) {
    (void)kind;
    (void)value;
    return refuse_status(component, "fmi2GetIntegerStatus");
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value) {
    static const char call[] = "fmi2GetBooleanStatus";
    if (kind != fmi2Terminated) {
        return refuse_status(component, call);
    }
    if (!call_is_allowed(component, call, after_steps) || !array_is_given(component, call, value, 1, 1)) {
        return fmi2Error;
    }
    *value = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component component, const fmi2StatusKind kind, fmi2String *value) {
    (void)kind;
    (void)value;
    return refuse_status(component, "fmi2GetStringStatus");
}
