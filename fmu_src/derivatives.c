/* Exact derivatives: of state derivatives and outputs by states and inputs, and of outputs along the run.
 *
 * Knowns are, in a run, its states, inputs and tunable parameters; before its start all that the start
 * follows from, which is what has a start value (FMI 2.0, section 2.2.8, and 3.0, 2.4.8: inputs, and
 * variables with initial = exact). Time is one always, though nothing depends on it but the instants of
 * events. */
#include "instance.h"

#include <math.h>
#include <string.h>

static bool is_known(const instance *instance, const fmu_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_INPUT ||
           variable->storage == STORED_TIME || variable->variability == VARIABILITY_TUNABLE ||
           (variable->settable_before_start && !fmu_has_begun(&instance->fmu));
}

static bool is_unknown(const fmu_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_DERIVATIVE ||
           variable->storage == STORED_OUTPUT || variable->storage == STORED_HELD;
}

static const fmu_variable *find_known(const instance *instance, const char *call, uint32_t reference) {
    const fmu_variable *variable = find_variable(instance, call, reference, VARIABLE_REAL);
    if (variable != NULL && !is_known(instance, variable)) {
        refuse(instance, call, "%s is neither a state nor an input nor tunable%s", variable->name,
               variable->settable_before_start ? ", and the run has begun" : "");
        return NULL;
    }
    return variable;
}

static const fmu_variable *find_unknown(const instance *instance, const char *call, uint32_t reference) {
    const fmu_variable *variable = find_variable(instance, call, reference, VARIABLE_REAL);
    if (variable != NULL && !is_unknown(variable)) {
        refuse(instance, call, "%s is neither an output nor a state derivative", variable->name);
        return NULL;
    }
    return variable;
}

static call_status check_seed(const instance *instance, const char *call, uint32_t reference, double seed) {
    if (!isfinite(seed)) {
        return discard(instance, call, "the seed of %s is not finite", fmu_variables[reference].name);
    }
    return CALL_OK;
}

static bool may_begin(const instance *instance, const char *call, const uint32_t unknowns[],
                      size_t unknown_count, const uint32_t knowns[], size_t known_count) {
    if (!call_is_allowed(instance, call, ANYWHERE) ||
        !array_is_given(instance, call, unknowns, unknown_count, unknown_count) ||
        !array_is_given(instance, call, knowns, known_count, known_count)) {
        return false;
    }
    for (size_t i = 0; i < known_count; ++i) {
        if (find_known(instance, call, knowns[i]) == NULL) {
            return false;
        }
    }
    for (size_t i = 0; i < unknown_count; ++i) {
        if (find_unknown(instance, call, unknowns[i]) == NULL) {
            return false;
        }
    }
    return true;
}

/* `present` is what present_fmu gave. */
static void differentiate(const instance *instance, const fmu *present, fmu *seed, fmu_view *variation) {
    if (fmu_has_begun(&instance->fmu)) {
        fmu_differentiate(present, seed, variation);
        return;
    }
    fmu_differentiate_start(&instance->fmu, present, seed, variation);
}

/* Refuses derivatives that are no numbers, as at states so large that their products overflow. */
static call_status check_derivatives(instance *instance, const char *call, const uint32_t references[],
                                     size_t count, const double values[]) {
    for (size_t i = 0; i < count; ++i) {
        if (isnan(values[i])) {
            return refuse(instance, call, "%s: there is no derivative at this state",
                          fmu_variables[references[i]].name);
        }
    }
    return CALL_OK;
}

call_status directional_derivative(instance *instance, const char *call, const uint32_t unknowns[],
                                   size_t unknown_count, const uint32_t knowns[], size_t known_count,
                                   const double seeds[], double values[]) {
    if (!may_begin(instance, call, unknowns, unknown_count, knowns, known_count) ||
        !array_is_given(instance, call, seeds, known_count, known_count) ||
        !array_is_given(instance, call, values, unknown_count, unknown_count)) {
        return CALL_ERROR;
    }
    fmu seed, preview;
    fmu_view variation;
    call_status status = CALL_OK;
    const fmu *present = present_fmu(instance, call, &preview, &status);
    if (present == NULL) {
        return status;
    }
    memset(&seed, 0, sizeof seed);
    for (size_t i = 0; i < known_count; ++i) {
        const fmu_variable *known = &fmu_variables[knowns[i]];
        if (check_seed(instance, call, knowns[i], seeds[i]) != CALL_OK) {
            return CALL_DISCARD;
        }
        fmu_set_number(&seed, known, fmu_get_number(&seed, NULL, known) + seeds[i]);
    }
    differentiate(instance, present, &seed, &variation);
    for (size_t i = 0; i < unknown_count; ++i) {
        values[i] = fmu_get_number(&seed, &variation, &fmu_variables[unknowns[i]]);
    }
    return check_derivatives(instance, call, unknowns, unknown_count, values);
}

/* How the unknowns together, weighted by the seeds, change with one known. */
static double sensitivity(const instance *instance, const fmu *present, const uint32_t unknowns[],
                          size_t unknown_count, uint32_t known, const double seeds[]) {
    fmu seed;
    fmu_view variation;
    double sum = 0.0;
    memset(&seed, 0, sizeof seed);
    fmu_set_number(&seed, &fmu_variables[known], 1.0);
    differentiate(instance, present, &seed, &variation);
    for (size_t i = 0; i < unknown_count; ++i) {
        sum += seeds[i] * fmu_get_number(&seed, &variation, &fmu_variables[unknowns[i]]);
    }
    return sum;
}

call_status adjoint_derivative(instance *instance, const char *call, const uint32_t unknowns[],
                               size_t unknown_count, const uint32_t knowns[], size_t known_count,
                               const double seeds[], double values[]) {
    if (!may_begin(instance, call, unknowns, unknown_count, knowns, known_count) ||
        !array_is_given(instance, call, seeds, unknown_count, unknown_count) ||
        !array_is_given(instance, call, values, known_count, known_count)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < unknown_count; ++i) {
        if (check_seed(instance, call, unknowns[i], seeds[i]) != CALL_OK) {
            return CALL_DISCARD;
        }
    }
    fmu preview;
    call_status status = CALL_OK;
    const fmu *present = present_fmu(instance, call, &preview, &status);
    for (size_t i = 0; present != NULL && i < known_count; ++i) {
        values[i] = sensitivity(instance, present, unknowns, unknown_count, knowns[i], seeds);
    }
    return present == NULL ? status : check_derivatives(instance, call, knowns, known_count, values);
}

call_status output_derivatives(instance *instance, const char *call, const uint32_t references[],
                               size_t count, const int orders[], double values[]) {
    if (!call_is_allowed(instance, call, STEP_MODE | TERMINATED | FAILED) ||
        !array_is_given(instance, call, references, count, count) ||
        !array_is_given(instance, call, orders, count, count) ||
        !array_is_given(instance, call, values, count, count)) {
        return CALL_ERROR;
    }
    fmu flow;
    fmu_view variation;
    fmu_flow(&instance->fmu, &flow);
    fmu_differentiate(&instance->fmu, &flow, &variation);
    for (size_t i = 0; i < count; ++i) {
        const fmu_variable *variable = find_variable(instance, call, references[i], VARIABLE_REAL);
        if (variable == NULL) {
            return CALL_ERROR;
        }
        if (orders[i] != 1 || (variable->storage != STORED_OUTPUT && variable->storage != STORED_STATE)) {
            return refuse(instance, call, "only first derivatives of outputs are given: %s, order %d",
                          variable->name, orders[i]);
        }
        values[i] = fmu_get_number(&flow, &variation, variable);
    }
    return check_derivatives(instance, call, references, count, values);
}
