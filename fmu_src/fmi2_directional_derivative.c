/* FMI 2.0: directional derivatives, exact, of state derivatives and outputs by states and inputs. */
#include "fmi2_instance.h"

#include <math.h>
#include <string.h>

static bool is_known(const unit_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_INPUT;
}

static bool is_unknown(const unit_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_DERIVATIVE ||
           variable->storage == STORED_OUTPUT;
}

static fmi2Status add_seed(instance *instance, const char *call, fmi2ValueReference reference, double seed,
                           unit *direction) {
    const unit_variable *variable = find_variable(instance, call, reference, VARIABLE_REAL);
    if (variable == NULL) {
        return fmi2Error;
    }
    if (!is_known(variable)) {
        return fail(instance, call, "%s is neither a state nor an input", variable->name);
    }
    if (!isfinite(seed)) {
        return discard(instance, call, "the seed of %s is not finite", variable->name);
    }
    unit_set_number(direction, variable, unit_get_number(direction, NULL, variable) + seed);
    return fmi2OK;
}

static fmi2Status read_change(instance *instance, const char *call, fmi2ValueReference reference,
                              const unit *direction, const unit_view *change, double *value) {
    const unit_variable *variable = find_variable(instance, call, reference, VARIABLE_REAL);
    if (variable == NULL) {
        return fmi2Error;
    }
    if (!is_unknown(variable)) {
        return fail(instance, call, "%s is neither an output nor a state derivative", variable->name);
    }
    *value = unit_get_number(direction, change, variable);
    return fmi2OK;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[],
                                        size_t known_count, const fmi2Real seeds[], fmi2Real values[]) {
    static const char call[] = "fmi2GetDirectionalDerivative";
    instance *instance = component;
    if (!call_is_allowed(instance, call, RUNNING | TERMINATED | FAILED) ||
        !array_is_given(instance, call, unknowns, unknown_count, unknown_count) ||
        !array_is_given(instance, call, knowns, known_count, known_count) ||
        !array_is_given(instance, call, seeds, known_count, known_count) ||
        !array_is_given(instance, call, values, unknown_count, unknown_count)) {
        return fmi2Error;
    }
    unit direction;
    unit_view change;
    memset(&direction, 0, sizeof direction);
    fmi2Status status = fmi2OK;
    for (size_t i = 0; i < known_count && status == fmi2OK; ++i) {
        status = add_seed(instance, call, knowns[i], seeds[i], &direction);
    }
    unit_look_along(&instance->unit, &direction, &change);
    for (size_t i = 0; i < unknown_count && status == fmi2OK; ++i) {
        status = read_change(instance, call, unknowns[i], &direction, &change, &values[i]);
    }
    return status;
}
