/* Getting and setting variables. */
#include "run.h"

#include <limits.h>

/* ---- places of values ---------------------------------------------------------------------------------- */

/* Arrays of an instance by storage. */
static const size_t places[STORAGE_COUNT] = {
    [STORED_TIME] = offsetof(instance, run.time),
    [STORED_PARAMETER] = offsetof(instance, run.motion.numbers),
    [STORED_SETTING] = offsetof(instance, run.settings),
    [STORED_INPUT] = offsetof(instance, run.motion.numbers),
    [STORED_STATE] = offsetof(instance, run.motion.numbers),
    [STORED_START] = offsetof(instance, run.starts),
    [STORED_DERIVATIVE] = offsetof(instance, view.derivatives),
    [STORED_OUTPUT] = offsetof(instance, view.outputs),
    [STORED_HELD] = offsetof(instance, view.numbers),
    [STORED_GUARD] = offsetof(instance, view.guards),
};

const double *place_of(const instance *fmu, fmu_storage storage, size_t offset) {
    return (const double *)((const char *)fmu + places[storage]) + offset;
}

double *place_in(instance *fmu, fmu_storage storage, size_t offset) {
    return (double *)((char *)fmu + places[storage]) + offset;
}

fmu_storage storage_of(const instance *fmu, const fmu_variable *variable) {
    const bool is_calculated =
        variable->storage == STORED_STATE && !variable->settable_before_start && !fmu->run.has_begun;
    return is_calculated ? STORED_HELD : variable->storage;
}

double number_of(const instance *fmu, const fmu_variable *variable) {
    if (variable->storage == STORED_WORK) {
        return fmin((double)fmu->run.work[variable->offset], INT_MAX);
    }
    const double value = *place_of(fmu, storage_of(fmu, variable), variable->offset);
    if (variable->type != VARIABLE_INTEGER || variable->storage <= STORED_START) {
        return value;
    }
    const bool is_code = variable->maximum < INT_MAX; /* code of a word; a long word has none */
    return is_code && !(value >= 0.0 && value <= variable->maximum) ? -1.0
                                                                    : fmin(fmax(value, -INT_MAX), INT_MAX);
}

double *rate_in(instance *fmu, const fmu_variable *input) {
    const bool is_state = input->offset >= UNIT_PARAMETER_COUNT;
    const int rate = is_state ? unit_input_rates[input->offset - UNIT_PARAMETER_COUNT] : -1;
    return rate < 0 ? NULL : &states_in(fmu)[rate];
}

bool is_allowed(instance *fmu, const fmu_variable *variable, double value) {
    char given[VALUE_CAPACITY];
    const char *allowed = variable->allowed;
    const bool has_unit = allowed != NULL && variable->unit != NULL;
    return (value >= variable->minimum && value <= variable->maximum) ||
           refuse(fmu, "%s = %s is refused: %s%s%s%s", variable->name, value_text(variable, value, given),
                  allowed == NULL ? "it has to be finite" : "allowed ", allowed == NULL ? "" : allowed,
                  has_unit ? " " : "", has_unit ? variable->unit : "");
}

const fmu_variable *find_variable(const instance *fmu, uint32_t reference, unsigned types) {
    static const char *const names[] = {"Real (Float64)", "Integer (Int32)", "Enumeration", "Boolean",
                                        "String"};
    if (reference >= fmu_variable_count) {
        answer(fmu, CALL_ERROR, "there is no value reference %lu", (unsigned long)reference);
        return NULL;
    }
    const fmu_variable *variable = &fmu_variables[reference];
    if ((variable->type & types) == 0) {
        answer(fmu, CALL_ERROR, "%s (value reference %lu) is of type %s", variable->name,
               (unsigned long)reference, names[number_of_bit(variable->type)]);
        return NULL;
    }
    return variable;
}

/* ---- getting ------------------------------------------------------------------------------------------ */

call_status get_numbers(instance *fmu, unsigned types, const uint32_t references[], size_t count,
                        void *values, number_writer write) {
    if (!ARE_GIVEN(fmu, count, references, values)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < count; ++i) {
        const fmu_variable *variable = find_variable(fmu, references[i], types);
        if (variable == NULL) {
            return CALL_ERROR;
        }
        const fmu_storage storage = storage_of(fmu, variable);
        if (storage > STORED_START && !bring_up_to_date(fmu, storage)) {
            return CALL_DISCARD;
        }
        write(values, i, number_of(fmu, variable));
    }
    return CALL_OK;
}

call_status get_texts(instance *fmu, const uint32_t references[], size_t count, const char *values[]) {
    if (!ARE_GIVEN(fmu, count, references, values)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < count; ++i) {
        const fmu_variable *variable = find_variable(fmu, references[i], VARIABLE_STRING);
        if (variable == NULL) {
            return CALL_ERROR;
        }
        if (!bring_up_to_date(fmu, variable->storage)) {
            return CALL_DISCARD;
        }
        values[i] = word_text(fmu, variable->offset);
    }
    return CALL_OK;
}

/* ---- setting ------------------------------------------------------------------------------------------ */

/* The states in which a variable may be set (FMI 2.0, table of section 3.2.3, whose note 5 has the states of
 * Model Exchange; FMI 3.0.2, sections 2.3.5 and 3.2.1). States are trial values in continuous-time mode. */
static unsigned settable_in(const instance *fmu, const fmu_variable *variable) {
    const unsigned before = variable->settable_before_start ? BEFORE_START : 0;
    const bool is_steady = is_exchange(fmu) && !variable->changes_at_events;
    if (fmu_is_set_at_events(variable)) {
        return before | EVENT_MODE | STEP_MODE;
    }
    if (variable->storage == STORED_STATE) {
        return before | CONTINUOUS_TIME_MODE | (is_steady ? EVENT_MODE : 0);
    }
    return variable->storage == STORED_INPUT ? BEFORE_START | RUNNING : before;
}

/* True for a setting that changes at events only, in continuous-time mode. A new value is ignored there,
 * because solvers of some importers set all inputs at each evaluation, to the values before an event. */
static bool keeps_its_value(const instance *fmu, const fmu_variable *variable) {
    return fmu->run.state == CONTINUOUS_TIME_MODE && fmu_is_set_at_events(variable);
}

/* A state that is set in a run is a trial value of a solver. It may be outside the range of start values. */
static bool is_trial(const instance *fmu, const fmu_variable *variable) {
    return variable->storage == STORED_STATE && (fmu->run.state & BEFORE_START) == 0;
}

static call_status check_set(instance *fmu, unsigned types, uint32_t reference, double value) {
    const fmu_variable *variable = find_variable(fmu, reference, types);
    if (variable == NULL) {
        return CALL_ERROR;
    }
    if (keeps_its_value(fmu, variable)) {
        return CALL_OK;
    }
    const unsigned states = settable_in(fmu, variable);
    if ((states & (unsigned)fmu->run.state) == 0) {
        return answer(fmu, CALL_ERROR, "%s cannot be set %s", variable->name,
                      states == 0 ? "at any time" : name_of_state((call_state)fmu->run.state));
    }
    if (is_trial(fmu, variable)) {
        return isnan(value) ? answer(fmu, CALL_DISCARD, "%s is not a number", variable->name) : CALL_OK;
    }
    return is_allowed(fmu, variable, value) ? CALL_OK : answer(fmu, CALL_DISCARD, "%s", fmu->reason);
}

static call_status set_number(instance *fmu, const fmu_variable *variable, double value) {
    double *place = place_in(fmu, variable->storage, variable->offset);
    double *rate = variable->storage == STORED_INPUT ? rate_in(fmu, variable) : NULL;
    if (keeps_its_value(fmu, variable)) {
        return *place == value ? CALL_OK
                               : answer(fmu, CALL_WARNING,
                                        "%s changes in event mode only, and stays as it is", variable->name);
    }
    if (is_trial(fmu, variable)) {
        *place = within_largest(value);
        take_from_world(fmu);
    } else {
        *place = value;
        if (is_exchange(fmu) && fmu->run.has_begun) {
            take_immediate_events(fmu);
        }
    }
    if (rate != NULL) {
        *rate = 0.0;
    }
    fmu->current = 0;
    return CALL_OK;
}

call_status set_numbers(instance *fmu, unsigned types, const uint32_t references[], size_t count,
                        const void *values, number_reader read) {
    call_status status = ARE_GIVEN(fmu, count, references, values) ? CALL_OK : CALL_ERROR;
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        status = check_set(fmu, types, references[i], read(values, i));
    }
    if (status != CALL_OK) {
        return status;
    }
    for (size_t i = 0; i < count; ++i) {
        const call_status done = set_number(fmu, &fmu_variables[references[i]], read(values, i));
        status = done > status ? done : status;
    }
    return status;
}

call_status set_texts(instance *fmu, const uint32_t references[], size_t count, const char *const values[]) {
    if (!ARE_GIVEN(fmu, count, references, values)) {
        return CALL_ERROR;
    }
    const fmu_variable *variable = count == 0 ? NULL : find_variable(fmu, references[0], VARIABLE_STRING);
    if (variable != NULL) {
        answer(fmu, CALL_ERROR, "%s cannot be set at any time", variable->name);
    }
    return count == 0 ? CALL_OK : CALL_ERROR;
}
