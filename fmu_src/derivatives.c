/* Exact derivatives: of state derivatives and outputs by states and inputs, and of outputs along the run.
 *
 * The knowns of a run are its states, inputs and tunable parameters. Before the start they are all variables
 * with a start value, because the start follows from these (FMI 2.0, section 2.2.8, and 3.0, 2.4.8: inputs,
 * and variables with initial = exact). Time is always a known, although only the instants of events depend on
 * it. */
#include "instance.h"

#include <math.h>
#include <string.h>

static bool is_known(const instance *instance, const fmu_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_INPUT ||
           variable->storage == STORED_TIME || variable->variability == VARIABILITY_TUNABLE ||
           (variable->settable_before_start && !instance->fmu.has_begun);
}

static bool is_unknown(const fmu_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_DERIVATIVE ||
           variable->storage == STORED_OUTPUT || variable->storage == STORED_HELD;
}

typedef struct {
    const uint32_t *references;
    size_t count;
} variable_list;

static bool are_suitable(const instance *instance, const char *call, variable_list list, bool as_known) {
    bool suit = array_is_given(instance, call, list.references, list.count, list.count);
    for (size_t i = 0; i < list.count && suit; ++i) {
        const fmu_variable *variable = find_variable(instance, call, list.references[i], VARIABLE_REAL);
        if (variable == NULL) {
            return false;
        }
        suit = as_known ? is_known(instance, variable) : is_unknown(variable);
        if (!suit) {
            answer(instance, CALL_ERROR, call, "%s is neither %s%s", variable->name,
                   as_known ? "a state nor an input nor tunable" : "an output nor a state derivative",
                   as_known && variable->settable_before_start ? ", and the run has begun" : "");
        }
    }
    return suit;
}

/* Refuses derivatives that are NaN, for example where states are so large that their products overflow. */
static call_status check_derivatives(const instance *instance, const char *call, const uint32_t references[],
                                     size_t count, const double values[]) {
    for (size_t i = 0; i < count; ++i) {
        if (isnan(values[i])) {
            return answer(instance, CALL_ERROR, call, "%s: there is no derivative at this state",
                          fmu_variables[references[i]].name);
        }
    }
    return CALL_OK;
}

/* The derivative of each unknown along the seeds of the knowns, in one pass. For the adjoint, the derivative
 * by each known of the sum of the unknowns, weighted by the seeds: a pass for each known. */
static call_status derivatives(const instance *instance, const char *call, variable_list unknowns,
                               variable_list knowns, const double seeds[], double values[], bool is_adjoint) {
    const variable_list seeded = is_adjoint ? unknowns : knowns, written = is_adjoint ? knowns : unknowns;
    if (!call_is_allowed(instance, call, ANYWHERE) || !are_suitable(instance, call, knowns, true) ||
        !are_suitable(instance, call, unknowns, false) ||
        !array_is_given(instance, call, seeds, seeded.count, seeded.count) ||
        !array_is_given(instance, call, values, written.count, written.count)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < seeded.count; ++i) {
        if (!isfinite(seeds[i])) {
            return answer(instance, CALL_DISCARD, call, "the seed of %s is not finite",
                          fmu_variables[seeded.references[i]].name);
        }
    }
    fmu seed, preview;
    fmu_view variation;
    call_status status = CALL_OK;
    const fmu *present = present_fmu(instance, call, &preview, &status);
    const size_t passes = is_adjoint ? knowns.count : 1;
    for (size_t pass = 0; present != NULL && pass < passes; ++pass) {
        const size_t first = is_adjoint ? pass : 0, end = is_adjoint ? pass + 1 : knowns.count;
        double sum = 0.0;
        memset(&seed, 0, sizeof seed);
        for (size_t i = first; i < end; ++i) {
            const fmu_variable *known = &fmu_variables[knowns.references[i]];
            fmu_set_number(&seed, known, fmu_get_number(&seed, NULL, known) + (is_adjoint ? 1.0 : seeds[i]));
        }
        if (instance->fmu.has_begun) {
            fmu_differentiate(present, &seed, &variation);
        } else {
            fmu_differentiate_start(&instance->fmu, present, &seed, &variation);
        }
        for (size_t i = 0; i < unknowns.count; ++i) {
            const double value = fmu_get_number(&seed, &variation, &fmu_variables[unknowns.references[i]]);
            sum += is_adjoint ? seeds[i] * value : 0.0;
            values[is_adjoint ? pass : i] = is_adjoint ? sum : value;
        }
    }
    return present == NULL ? status
                           : check_derivatives(instance, call, written.references, written.count, values);
}

call_status directional_derivative(instance *instance, const char *call, const uint32_t unknowns[],
                                   size_t unknown_count, const uint32_t knowns[], size_t known_count,
                                   const double seeds[], double values[]) {
    const variable_list of = {unknowns, unknown_count}, by = {knowns, known_count};
    return derivatives(instance, call, of, by, seeds, values, false);
}

call_status adjoint_derivative(instance *instance, const char *call, const uint32_t unknowns[],
                               size_t unknown_count, const uint32_t knowns[], size_t known_count,
                               const double seeds[], double values[]) {
    const variable_list of = {unknowns, unknown_count}, by = {knowns, known_count};
    return derivatives(instance, call, of, by, seeds, values, true);
}

call_status output_derivatives(instance *instance, const char *call, const uint32_t references[],
                               size_t count, const int orders[], double values[]) {
    if (!MAY_BEGIN(instance, call, STEP_MODE | TERMINATED | FAILED, count, references, orders, values)) {
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
            return answer(instance, CALL_ERROR, call,
                          "only first derivatives of outputs are given: %s, order %d", variable->name,
                          orders[i]);
        }
        values[i] = fmu_get_number(&flow, &variation, variable);
    }
    return check_derivatives(instance, call, references, count, values);
}
