/* FMI 2.0: getting and setting variables. A set is all or nothing; it checks each variable's own range, while
 * checks across variables wait for the end of initialization, because importers set one by one in any order.
 */
#include "fmi2_instance.h"

static const unsigned writable = BEFORE_START | RUNNING;

static bool may_begin(instance *instance, const char *call, unsigned states,
                      const fmi2ValueReference references[], const void *values, size_t count) {
    return call_is_allowed(instance, call, states) &&
           array_is_given(instance, call, references, count, count) &&
           array_is_given(instance, call, values, count, count);
}

/* ---- getting ------------------------------------------------------------------------------------------ */

static bool is_derived(const unit_variable *variable) {
    return variable->storage == STORED_OUTPUT || variable->storage == STORED_DERIVATIVE ||
           variable->storage == STORED_WORK;
}

static fmi2Status get_number(instance *instance, const char *call, fmi2ValueReference reference,
                             unit_variable_type type, double *value) {
    const unit_variable *variable = find_variable(instance, call, reference, type);
    if (variable == NULL) {
        return fmi2Error;
    }
    fmi2Status status = fmi2OK;
    const unit_view *view = is_derived(variable) ? current_view(instance, call, &status) : NULL;
    if (status == fmi2OK) {
        *value = unit_get_number(&instance->unit, view, variable);
    }
    return status;
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[]) {
    fmi2Status status =
        may_begin(component, "fmi2GetReal", READABLE, references, values, count) ? fmi2OK : fmi2Error;
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        status = get_number(component, "fmi2GetReal", references[i], VARIABLE_REAL, &values[i]);
    }
    return status;
}

static fmi2Status get_integers(fmi2Component component, const char *call, unit_variable_type type,
                               const fmi2ValueReference references[], size_t count, int values[]) {
    fmi2Status status = may_begin(component, call, READABLE, references, values, count) ? fmi2OK : fmi2Error;
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        double value = 0.0;
        status = get_number(component, call, references[i], type, &value);
        if (status == fmi2OK) {
            values[i] = (int)value;
        }
    }
    return status;
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Integer values[]) {
    return get_integers(component, "fmi2GetInteger", VARIABLE_INTEGER, references, count, values);
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Boolean values[]) {
    return get_integers(component, "fmi2GetBoolean", VARIABLE_BOOLEAN, references, count, values);
}

fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference references[], size_t count,
                         fmi2String values[]) {
    static const char call[] = "fmi2GetString";
    fmi2Status status = may_begin(component, call, READABLE, references, values, count) ? fmi2OK : fmi2Error;
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        const unit_variable *variable = find_variable(component, call, references[i], VARIABLE_STRING);
        const unit_view *view = variable == NULL ? NULL : current_view(component, call, &status);
        if (variable == NULL) {
            status = fmi2Error;
        } else if (view != NULL) {
            values[i] = unit_get_text(view, variable);
        }
    }
    return status;
}

/* ---- setting ------------------------------------------------------------------------------------------ */

static bool is_settable_now(const instance *instance, const unit_variable *variable) {
    const bool before_start = (instance->state & BEFORE_START) != 0;
    return variable->storage == STORED_INPUT || (before_start && variable->settable_before_start);
}

static fmi2Status check_set(instance *instance, const char *call, fmi2ValueReference reference,
                            unit_variable_type type, double value) {
    const unit_variable *variable = find_variable(instance, call, reference, type);
    if (variable == NULL) {
        return fmi2Error;
    }
    if (!is_settable_now(instance, variable)) {
        return fail(instance, call, "%s cannot be set %s", variable->name,
                    variable->settable_before_start ? "any more once the run has started" : "at any time");
    }
    const tdmf_refusal refusal = unit_refuse_value(variable, value);
    if (refusal.variable != NULL) {
        char text[256];
        return discard(instance, call, "%s", tdmf_refusal_text(&refusal, text, sizeof text));
    }
    return fmi2OK;
}

static void set_number(instance *instance, fmi2ValueReference reference, double value) {
    unit_set_number(&instance->unit, &unit_variables[reference], value);
    if (unit_variables[reference].storage == STORED_INPUT) {
        unit_set_number_rate(&instance->unit, &unit_variables[reference], 0.0);
    }
    forget_view(instance);
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[]) {
    static const char call[] = "fmi2SetReal";
    fmi2Status status = may_begin(component, call, writable, references, values, count) ? fmi2OK : fmi2Error;
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        status = check_set(component, call, references[i], VARIABLE_REAL, values[i]);
    }
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        set_number(component, references[i], values[i]);
    }
    return status;
}

static fmi2Status set_integers(fmi2Component component, const char *call, unit_variable_type type,
                               const fmi2ValueReference references[], size_t count, const int values[]) {
    fmi2Status status = may_begin(component, call, writable, references, values, count) ? fmi2OK : fmi2Error;
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        status = check_set(component, call, references[i], type, values[i]);
    }
    for (size_t i = 0; i < count && status == fmi2OK; ++i) {
        set_number(component, references[i], values[i]);
    }
    return status;
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Integer values[]) {
    return set_integers(component, "fmi2SetInteger", VARIABLE_INTEGER, references, count, values);
}

fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Boolean values[]) {
    return set_integers(component, "fmi2SetBoolean", VARIABLE_BOOLEAN, references, count, values);
}

fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference references[], size_t count,
                         const fmi2String values[]) {
    static const char call[] = "fmi2SetString";
    if (!may_begin(component, call, writable, references, values, count)) {
        return fmi2Error;
    }
    for (size_t i = 0; i < count; ++i) {
        const unit_variable *variable = find_variable(component, call, references[i], VARIABLE_STRING);
        return variable == NULL ? fmi2Error
                                : fail(component, call, "%s cannot be set at any time", variable->name);
    }
    return fmi2OK;
}
