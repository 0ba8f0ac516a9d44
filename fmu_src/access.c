/* Getting and setting variables. */
#include "instance.h"

#include <math.h>

static const unsigned writable = BEFORE_START | RUNNING;

static const char *name_of_type(fmu_variable_type type) {
    static const char *const names[] = {"Real (Float64)", "Integer (Int32)", "Enumeration", "Boolean",
                                        "String"};
    return names[number_of_bit(type)];
}

const fmu_variable *find_variable(const instance *instance, const char *call, uint32_t reference,
                                  unsigned types) {
    if (reference >= fmu_variable_count) {
        answer(instance, CALL_ERROR, call, "there is no value reference %lu", (unsigned long)reference);
        return NULL;
    }
    const fmu_variable *variable = &fmu_variables[reference];
    if ((variable->type & types) == 0) {
        answer(instance, CALL_ERROR, call, "%s (value reference %lu) is of type %s", variable->name,
               (unsigned long)reference, name_of_type(variable->type));
        return NULL;
    }
    return variable;
}

void write_double(void *values, size_t i, double number) {
    ((double *)values)[i] = number;
}

double read_double(const void *values, size_t i) {
    return ((const double *)values)[i];
}

/* ---- getting ------------------------------------------------------------------------------------------ */

/* True for a state without a start value, before the run: the start calculates it. */
static bool follows_from_start(const instance *instance, const fmu_variable *variable) {
    return variable->storage == STORED_STATE && !variable->settable_before_start && !instance->fmu.has_begun;
}

static call_status get_number(instance *instance, const char *call, unsigned types, uint32_t reference,
                              double *value) {
    const fmu_variable *variable = find_variable(instance, call, reference, types);
    if (variable == NULL) {
        return CALL_ERROR;
    }
    call_status status = CALL_OK;
    const bool calculated = follows_from_start(instance, variable);
    const fmu_view *view =
        variable->storage <= STORED_START && !calculated ? NULL : current_view(instance, call, &status);
    if (status == CALL_OK) {
        *value = calculated ? view->states[variable->offset] : fmu_get_number(&instance->fmu, view, variable);
    }
    return status;
}

call_status get_numbers(instance *instance, const char *call, unsigned types, const uint32_t references[],
                        size_t count, void *values, number_writer write) {
    call_status status =
        MAY_BEGIN(instance, call, ANYWHERE, count, references, values) ? CALL_OK : CALL_ERROR;
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        double value = 0.0;
        status = get_number(instance, call, types, references[i], &value);
        if (status == CALL_OK) {
            write(values, i, value);
        }
    }
    return status;
}

call_status get_texts(instance *instance, const char *call, const uint32_t references[], size_t count,
                      const char *values[]) {
    call_status status =
        MAY_BEGIN(instance, call, ANYWHERE, count, references, values) ? CALL_OK : CALL_ERROR;
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        const fmu_variable *variable = find_variable(instance, call, references[i], VARIABLE_STRING);
        const fmu_view *view = variable == NULL ? NULL : current_view(instance, call, &status);
        if (variable == NULL) {
            status = CALL_ERROR;
        } else if (view != NULL) {
            values[i] = view->words[variable->offset];
        }
    }
    return status;
}

/* ---- setting ------------------------------------------------------------------------------------------ */

static bool is_settable_now(const instance *instance, const fmu_variable *variable) {
    if (fmu_is_set_at_events(variable) && (instance->state & (EVENT_MODE | STEP_MODE)) != 0) {
        return true;
    }
    if (variable->storage == STORED_INPUT && variable->variability == VARIABILITY_CONTINUOUS) {
        return true;
    }
    if (variable->storage == STORED_STATE && instance->state == CONTINUOUS_TIME_MODE) {
        return true;
    }
    if (variable->storage == STORED_STATE && instance->state == EVENT_MODE) {
        return instance->interface == MODEL_EXCHANGE && !variable->changes_at_events;
    }
    return (instance->state & BEFORE_START) != 0 && variable->settable_before_start;
}

/* True for a setting that changes at events only, in continuous-time mode. A new value is ignored there,
 * because solvers of some importers set all inputs at each evaluation, to the values before an event. */
static bool keeps_its_value(const instance *instance, const fmu_variable *variable) {
    return instance->state == CONTINUOUS_TIME_MODE && fmu_is_set_at_events(variable);
}

/* A state that is set in a run is a trial value of a solver. It may be outside the range of start values. */
static bool is_trial(const instance *instance, const fmu_variable *variable) {
    return variable->storage == STORED_STATE && (instance->state & BEFORE_START) == 0;
}

static call_status check_set(const instance *instance, const char *call, unsigned types, uint32_t reference,
                             double value) {
    const fmu_variable *variable = find_variable(instance, call, reference, types);
    if (variable == NULL) {
        return CALL_ERROR;
    }
    if (keeps_its_value(instance, variable)) {
        return CALL_OK;
    }
    if (!is_settable_now(instance, variable)) {
        const bool settable_at_times = variable->settable_before_start || variable->storage == STORED_STATE;
        return answer(instance, CALL_ERROR, call, "%s cannot be set %s", variable->name,
                      settable_at_times ? name_of_state(instance->state) : "at any time");
    }
    if (is_trial(instance, variable)) {
        return isnan(value) ? answer(instance, CALL_DISCARD, call, "%s is not a number", variable->name)
                            : CALL_OK;
    }
    char text[FMU_TEXT];
    return fmu_refuse_value(variable, value, text) == NULL ? CALL_OK
                                                           : answer(instance, CALL_DISCARD, call, "%s", text);
}

static call_status set_number(instance *instance, const char *call, uint32_t reference, double value) {
    const fmu_variable *variable = &fmu_variables[reference];
    if (keeps_its_value(instance, variable)) {
        return fmu_get_number(&instance->fmu, NULL, variable) == value
                   ? CALL_OK
                   : answer(instance, CALL_WARNING, call, "%s changes in event mode only, and stays as it is",
                            variable->name);
    }
    if (is_trial(instance, variable)) {
        double states[UNIT_CONTINUOUS_COUNT + 1];
        fmu_states(&instance->fmu, NULL, states);
        states[variable->offset] = value;
        fmu_try_states(&instance->fmu, states);
    } else {
        fmu_set_number(&instance->fmu, variable, value);
    }
    double *rate = variable->storage == STORED_INPUT ? fmu_rate_of(&instance->fmu, variable) : NULL;
    if (rate != NULL) {
        *rate = 0.0;
    }
    discard_view(instance);
    return CALL_OK;
}

call_status set_numbers(instance *instance, const char *call, unsigned types, const uint32_t references[],
                        size_t count, const void *values, number_reader read) {
    call_status status =
        MAY_BEGIN(instance, call, writable, count, references, values) ? CALL_OK : CALL_ERROR;
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        status = check_set(instance, call, types, references[i], read(values, i));
    }
    if (status != CALL_OK) {
        return status;
    }
    for (size_t i = 0; i < count; ++i) {
        const call_status done = set_number(instance, call, references[i], read(values, i));
        status = done > status ? done : status;
    }
    return status;
}

call_status set_texts(instance *instance, const char *call, const uint32_t references[], size_t count,
                      const char *const values[]) {
    if (!MAY_BEGIN(instance, call, writable, count, references, values)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < count; ++i) {
        const fmu_variable *variable = find_variable(instance, call, references[i], VARIABLE_STRING);
        return variable == NULL
                   ? CALL_ERROR
                   : answer(instance, CALL_ERROR, call, "%s cannot be set at any time", variable->name);
    }
    return CALL_OK;
}
