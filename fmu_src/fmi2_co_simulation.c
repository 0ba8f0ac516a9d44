/* FMI 2.0 Co-Simulation: the unit integrates itself. An event inside a step is its own business: it is
 * located and taken, and the step ends exactly where the importer wants it. */
#include "fmi2_instance.h"

#include <math.h>

/* Communication points that importers add up may be off by so much, over the larger of time and step. */
static const double clock_rounding = 1e-9;

static bool is_communication_point(const unit *unit, double time, double step) {
    const double own = unit->motion.time;
    return fabs(time - own) <= clock_rounding * fmax(fabs(own), step);
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real step,
                      fmi2Boolean no_set_state_before) {
    static const char call[] = "fmi2DoStep";
    (void)no_set_state_before;
    instance *instance = component;
    if (!call_is_allowed(instance, call, STEP_COMPLETE)) {
        return fmi2Error;
    }
    unit *unit = &instance->unit;
    if (!(step > 0.0 && isfinite(step) && isfinite(time + step))) {
        return fail(instance, call, "the step is not a positive number");
    }
    if (!is_communication_point(unit, time, step)) {
        return fail(instance, call, "the communication point is not where the last step ended");
    }
    const tdmf_mode before = unit->motion.mode;
    const char *obstacle = unit_advance(unit, time + step);
    forget_view(instance);
    log_changes(instance, &before);
    return obstacle == NULL ? fmi2OK : fail(instance, call, "%s", obstacle);
}

fmi2Status fmi2CancelStep(fmi2Component component) {
    return component == NULL
               ? fmi2Error
               : fail(component, "fmi2CancelStep", "no step is under way: steps are not asynchronous");
}

/* ---- derivatives of inputs and outputs ---------------------------------------------------------------- */

static fmi2Status check_input_rate(instance *instance, const char *call, fmi2ValueReference reference,
                                   fmi2Integer order, double value) {
    const unit_variable *variable = find_variable(instance, call, reference, VARIABLE_REAL);
    if (variable == NULL) {
        return fmi2Error;
    }
    if (variable->storage != STORED_INPUT) {
        return fail(instance, call, "%s is not an input", variable->name);
    }
    if (order != 1) {
        return fail(instance, call, "only first derivatives of inputs are taken, not order %d", order);
    }
    if (!isfinite(value)) {
        return discard(instance, call, "the derivative of %s is not finite", variable->name);
    }
    return fmi2OK;
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference references[],
                                       size_t count, const fmi2Integer orders[], const fmi2Real values[]) {
    static const char call[] = "fmi2SetRealInputDerivatives";
    instance *instance = component;
    if (!call_is_allowed(instance, call, BEFORE_START | STEP_COMPLETE) ||
        !array_is_given(instance, call, references, count, count) ||
        !array_is_given(instance, call, orders, count, count) ||
        !array_is_given(instance, call, values, count, count)) {
        return fmi2Error;
    }
    fmi2Status status = fmi2OK;
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        status = check_input_rate(instance, call, references[i], orders[i], values[i]);
    }
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        unit_set_number_rate(&instance->unit, &unit_variables[references[i]], values[i]);
    }
    return status;
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference references[],
                                        size_t count, const fmi2Integer orders[], fmi2Real values[]) {
    static const char call[] = "fmi2GetRealOutputDerivatives";
    instance *instance = component;
    if (!call_is_allowed(instance, call, STEP_COMPLETE | TERMINATED | FAILED) ||
        !array_is_given(instance, call, references, count, count) ||
        !array_is_given(instance, call, orders, count, count) ||
        !array_is_given(instance, call, values, count, count)) {
        return fmi2Error;
    }
    unit flow;
    unit_view change;
    unit_flow(&instance->unit, &flow);
    unit_look_along(&instance->unit, &flow, &change);
    for (size_t i = 0; i < count; ++i) {
        const unit_variable *variable = find_variable(instance, call, references[i], VARIABLE_REAL);
        if (variable == NULL) {
            return fmi2Error;
        }
        if (orders[i] != 1 || (variable->storage != STORED_OUTPUT && variable->storage != STORED_STATE)) {
            return fail(instance, call, "only first derivatives of outputs are given: %s, order %d",
                        variable->name, orders[i]);
        }
        values[i] = unit_get_number(&flow, &change, variable);
    }
    return fmi2OK;
}

/* ---- status of asynchronous steps, which there are none of -------------------------------------------- */

static fmi2Status refuse_status(fmi2Component component, const char *call) {
    if (!call_is_allowed(component, call, STEP_COMPLETE | TERMINATED | FAILED)) {
        return fmi2Error;
    }
    return discard(component, call, "steps are not asynchronous, there is no such status");
}

fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Status *value) {
    (void)kind;
    (void)value;
    return refuse_status(component, "fmi2GetStatus");
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value) {
    static const char call[] = "fmi2GetRealStatus";
    instance *instance = component;
    if (kind != fmi2LastSuccessfulTime) {
        return refuse_status(component, call);
    }
    if (!call_is_allowed(instance, call, STEP_COMPLETE | TERMINATED | FAILED) ||
        !array_is_given(instance, call, value, 1, 1)) {
        return fmi2Error;
    }
    *value = instance->unit.motion.time;
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Integer *value) {
    (void)kind;
    (void)value;
    return refuse_status(component, "fmi2GetIntegerStatus");
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value) {
    static const char call[] = "fmi2GetBooleanStatus";
    instance *instance = component;
    if (kind != fmi2Terminated) {
        return refuse_status(component, call);
    }
    if (!call_is_allowed(instance, call, STEP_COMPLETE | TERMINATED | FAILED) ||
        !array_is_given(instance, call, value, 1, 1)) {
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
