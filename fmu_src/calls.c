/* Life cycle of an instance, the checks that every call of FMI makes first, and messages to the importer. */
#include "guid.h"
#include "run.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MESSAGE_CAPACITY = 512, LOG_ALL = (1 << (CALL_ERROR + 1)) - 1 };

static const int64_t usual_step_limit = 1000000;

/* ---- making and freeing -------------------------------------------------------------------------------- */

call_status reset(instance *fmu) {
    const unit_run fresh = {
        .interface = fmu->run.interface,
        .state = INSTANTIATED,
        .settings =
            {[SETTING_TOLERANCE] = 1e-11, [SETTING_TERMINATES] = 1.0, [SETTING_METHOD] = SOLVER_NATIVE},
        .importer_tolerance = INFINITY,
        .stop_time = INFINITY};
    fmu->run = fresh;
    memcpy(parameters_in(fmu), unit_model->parameter_defaults, UNIT_PARAMETER_COUNT * sizeof(double));
    memcpy(states_in(fmu), unit_model->state_defaults, UNIT_STATE_COUNT * sizeof(double));
    memcpy(fmu->run.starts, unit_model->state_defaults, UNIT_STATE_COUNT * sizeof(double));
    fmu->step_limit = usual_step_limit;
    fmu->current = 0;
    return CALL_OK;
}

void *instance_new(size_t size, const char *name, const char *token, interface_kind interface, bool logging,
                   const char **reason) {
    if (*reason == NULL && (name == NULL || name[0] == '\0')) {
        *reason = "the instance needs a name";
    }
    if (*reason == NULL && (token == NULL || strcmp(token, FMU_GUID) != 0)) {
        *reason = "the guid or instantiation token is not this unit's, " FMU_GUID;
    }
    if (*reason != NULL) {
        return NULL;
    }
    const size_t length = strlen(name) + 1;
    instance *made = calloc(1, size);
    char *copy = malloc(length);
    if (made == NULL || copy == NULL || allocate_memory(made) == NULL) {
        free(made);
        free(copy);
        *reason = "out of memory";
        return NULL;
    }
    memcpy(copy, name, length);
    made->name = copy;
    made->run.interface = (int32_t)interface;
    made->log_categories = logging ? LOG_ALL : 0;
    reset(made);
    return made;
}

void instance_free(instance *fmu) {
    if (fmu != NULL) {
        free(fmu->memory);
        free(fmu->name);
        free(fmu);
    }
}

/* ---- the call sequence --------------------------------------------------------------------------------- */

#define EVALUABLE (INITIALIZATION_MODE | EVENT_MODE | CONTINUOUS_TIME_MODE | TERMINATED | FAILED)

/* The states in which each interface allows a call. An entry is 0 where the interface lacks the call. */
static const unsigned allowed_states[CALL_KIND_COUNT][INTERFACE_COUNT] = {
    [ALWAYS_ALLOWED] = {ANYWHERE, ANYWHERE, ANYWHERE},
    [BEFORE_INITIALIZATION] = {INSTANTIATED, INSTANTIATED, INSTANTIATED},
    [IN_INITIALIZATION] = {INITIALIZATION_MODE, INITIALIZATION_MODE, INITIALIZATION_MODE},
    [WHILE_RUNNING] = {RUNNING, RUNNING, RUNNING},
    [SETS_VALUES] = {BEFORE_START | RUNNING, BEFORE_START | RUNNING, BEFORE_START | RUNNING},
    [SETS_RATES] = {0, BEFORE_START | STEP_MODE, BEFORE_START | STEP_MODE},
    [ENTERS_EVENT_MODE] = {CONTINUOUS_TIME_MODE, 0, STEP_MODE},
    [ENTERS_EVENT_MODE_AGAIN] = {EVENT_MODE | CONTINUOUS_TIME_MODE, 0, 0},
    [IN_EVENT_MODE] = {EVENT_MODE, 0, EVENT_MODE},
    [ENTERS_CONTINUOUS_TIME] = {EVENT_MODE, 0, 0},
    [ENTERS_STEP_MODE] = {0, 0, EVENT_MODE},
    [SETS_TIME] = {EVENT_MODE | CONTINUOUS_TIME_MODE, 0, 0},
    [INTEGRATES] = {CONTINUOUS_TIME_MODE, 0, 0},
    [EVALUATES] = {EVALUABLE, EVALUABLE, EVALUABLE},
    [ASKS_FOR_NOMINALS] = {INSTANTIATED | EVALUABLE, INSTANTIATED | EVALUABLE, INSTANTIATED | EVALUABLE},
    [STEPS_FORWARD] = {0, STEP_MODE, STEP_MODE},
    [FOLLOWS_STEP] = {0, STEP_MODE | TERMINATED | FAILED, STEP_MODE | TERMINATED | FAILED},
};

static const char *const interface_names[] = {"Model Exchange", "Co-Simulation without event mode",
                                              "Co-Simulation with event mode"};

int number_of_bit(unsigned bit) {
    int number = 0;
    while (bit >> number > 1) {
        ++number;
    }
    return number;
}

const char *name_of_state(call_state state) {
    static const char *const names[] = {"before initialization",
                                        "in initialization mode",
                                        "in event mode",
                                        "in continuous-time mode",
                                        "between steps of Co-Simulation",
                                        "after termination",
                                        "after an error; reset or free the instance"};
    return names[number_of_bit(state)];
}

bool state_suits_interface(unsigned state, interface_kind interface, bool begun) {
    static const unsigned of_interface[] = {EVENT_MODE | CONTINUOUS_TIME_MODE, STEP_MODE,
                                            EVENT_MODE | STEP_MODE};
    const unsigned states = begun ? of_interface[interface] | TERMINATED | FAILED : BEFORE_START | FAILED;
    return (state & (state - 1)) == 0 && (state & states) != 0;
}

bool call_begins(instance *fmu, const char *call, call_kind kind) {
    if (fmu == NULL) {
        return false;
    }
    fmu->call = call;
    const unsigned allowed = allowed_states[kind][fmu->run.interface];
    if ((allowed & (unsigned)fmu->run.state) == 0) {
        answer(fmu, CALL_ERROR, "not allowed %s%s", allowed == 0 ? "in " : "",
               allowed == 0 ? interface_names[fmu->run.interface]
                            : name_of_state((call_state)fmu->run.state));
        return false;
    }
    return true;
}

call_status enter_state(instance *fmu, call_state state) {
    fmu->run.state = (int32_t)state;
    return CALL_OK;
}

/* ---- arrays -------------------------------------------------------------------------------------------- */

bool array_is_given(const instance *fmu, const void *array, size_t count, size_t wanted) {
    if (count != wanted) {
        answer(fmu, CALL_ERROR, "the length of the array is %lu; it must be %lu", (unsigned long)count,
               (unsigned long)wanted);
        return false;
    }
    if (array == NULL && count > 0) {
        answer(fmu, CALL_ERROR, "the array is a null pointer");
        return false;
    }
    return true;
}

bool arrays_are_given(const instance *fmu, size_t count, const void *const arrays[], size_t array_count) {
    bool are = true;
    for (size_t i = 0; i < array_count && are; ++i) {
        are = array_is_given(fmu, arrays[i], count, count);
    }
    return are;
}

/* ---- messages ------------------------------------------------------------------------------------------ */

/* The category of each status, then that of all. */
static const char *const categories[] = {"logEvents", "logStatusWarning", "logStatusDiscard",
                                         "logStatusError", "logAll"};

call_status answer(const instance *fmu, call_status status, const char *format, ...) {
    char text[MESSAGE_CAPACITY];
    const int begin = snprintf(text, sizeof text, "%s: ", fmu->call);
    va_list arguments;
    va_start(arguments, format);
    if (begin > 0 && (size_t)begin < sizeof text) {
        vsnprintf(text + begin, sizeof text - (size_t)begin, format, arguments);
    }
    va_end(arguments);
    if ((fmu->log_categories >> status & 1) != 0) {
        fmu->send(fmu, status, categories[status], text);
    }
    return status;
}

bool refuse(instance *fmu, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(fmu->reason, sizeof fmu->reason, format, arguments);
    va_end(arguments);
    return false;
}

bool logs_events(const instance *fmu) {
    return (fmu->log_categories >> CALL_OK & 1) != 0;
}

void log_event(const instance *fmu, const char *text) {
    fmu->send(fmu, CALL_OK, categories[CALL_OK], text);
}

/* The set of categories with this name; 0 if the name is unknown. */
static unsigned category_named(const char *name) {
    for (unsigned i = 0; i <= CALL_ERROR; ++i) {
        if (strcmp(categories[i], name) == 0) {
            return 1u << i;
        }
    }
    return strcmp(categories[CALL_ERROR + 1], name) == 0 ? LOG_ALL : 0;
}

call_status set_logging(instance *fmu, bool on, size_t count, const char *const names[]) {
    const char *unknown = NULL;
    unsigned named = count == 0 ? (unsigned)LOG_ALL : 0;
    if (!ARE_GIVEN(fmu, count, names)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < count; ++i) {
        const char *name = names[i] == NULL ? "(null)" : names[i];
        unknown = category_named(name) == 0 ? name : unknown;
        named |= category_named(name);
    }
    const unsigned present = on && !fmu->log_was_chosen ? 0 : fmu->log_categories;
    const call_status status =
        unknown == NULL ? CALL_OK : answer(fmu, CALL_WARNING, "there is no log category %s", unknown);
    if (named != 0) {
        fmu->log_categories = on ? present | named : present & ~named;
        fmu->log_was_chosen = true;
    }
    return status;
}

char *number_text(double number, char text[NUMBER_CAPACITY]) {
    snprintf(text, NUMBER_CAPACITY, "%.15g", number);
    char *comma = strchr(text, ','); /* decimal point of the locale */
    if (comma != NULL) {
        *comma = '.';
    }
    return text;
}

char *value_text(const fmu_variable *variable, double value, char text[VALUE_CAPACITY]) {
    char number[NUMBER_CAPACITY];
    const bool has_unit = variable->unit != NULL;
    snprintf(text, VALUE_CAPACITY, "%s%s%s", number_text(value, number), has_unit ? " " : "",
             has_unit ? variable->unit : "");
    return text;
}
