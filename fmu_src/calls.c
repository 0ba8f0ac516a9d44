/* Life cycle of an instance, the checks that every call of FMI makes first, and the view that calls read. */
#include "guid.h"
#include "instance.h"
#include "page_cvode.h"
#include "run.h"

#include <stdlib.h>
#include <string.h>

/* ---- making and freeing -------------------------------------------------------------------------------- */

static void begin_again(instance *instance) {
    fmu_reset(&instance->fmu);
    discard_view(instance);
    instance->state = INSTANTIATED;
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
    if (made == NULL || copy == NULL || allocate_memory(&made->fmu) == NULL) {
        free(made);
        free(copy);
        *reason = "out of memory";
        return NULL;
    }
    memcpy(copy, name, length);
    made->name = copy;
    made->interface = interface;
    made->log_categories = logging ? LOG_ALL : 0;
    made->fmu.is_exchange = interface == MODEL_EXCHANGE;
    begin_again(made);
    return made;
}

void instance_free(instance *instance) {
    if (instance != NULL) {
        free(instance->fmu.memory);
        free(instance->name);
        free(instance);
    }
}

/* ---- checks -------------------------------------------------------------------------------------------- */

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
    const unsigned of_interface = interface == MODEL_EXCHANGE  ? EVENT_MODE | CONTINUOUS_TIME_MODE
                                  : interface == CO_SIMULATION ? STEP_MODE
                                                               : EVENT_MODE | STEP_MODE;
    const unsigned states = begun ? of_interface | TERMINATED | FAILED : BEFORE_START | FAILED;
    return (state & (state - 1)) == 0 && (state & states) != 0;
}

bool call_is_allowed(const instance *instance, const char *call, unsigned allowed_states) {
    if (instance == NULL) {
        return false;
    }
    if ((instance->state & allowed_states) == 0) {
        answer(instance, CALL_ERROR, call, "not allowed %s", name_of_state(instance->state));
        return false;
    }
    return true;
}

bool array_is_given(const instance *instance, const char *call, const void *array, size_t count,
                    size_t wanted) {
    if (count != wanted) {
        answer(instance, CALL_ERROR, call, "the array has %lu elements, %lu are needed", (unsigned long)count,
               (unsigned long)wanted);
        return false;
    }
    if (array == NULL && count > 0) {
        answer(instance, CALL_ERROR, call, "the array is a null pointer");
        return false;
    }
    return true;
}

bool call_may_begin(const instance *instance, const char *call, unsigned allowed_states, size_t count,
                    const void *const arrays[], size_t array_count) {
    bool may = call_is_allowed(instance, call, allowed_states);
    for (size_t i = 0; i < array_count && may; ++i) {
        may = array_is_given(instance, call, arrays[i], count, count);
    }
    return may;
}

/* ---- the view ------------------------------------------------------------------------------------------ */

void discard_view(instance *instance) {
    instance->view_is_current = false;
}

const fmu *present_fmu(const instance *instance, const char *call, fmu *preview, call_status *status) {
    char text[FMU_TEXT];
    if (instance->fmu.has_begun) {
        return &instance->fmu;
    }
    *preview = instance->fmu;
    if (fmu_start(preview, text) != NULL) {
        *status = answer(instance, CALL_DISCARD, call, "no outputs yet: %s", text);
        return NULL;
    }
    return preview;
}

const fmu_view *current_view(instance *instance, const char *call, call_status *status) {
    if (!instance->view_is_current) {
        fmu preview;
        const fmu *present = present_fmu(instance, call, &preview, status);
        if (present == NULL) {
            return NULL;
        }
        fmu_evaluate(present, &instance->view);
        instance->view_is_current = true;
    }
    return &instance->view;
}

/* ---- the call sequence --------------------------------------------------------------------------------- */

call_status enter_state(instance *instance, const char *call, unsigned from, call_state to) {
    if (!call_is_allowed(instance, call, from)) {
        return CALL_ERROR;
    }
    instance->state = to;
    return CALL_OK;
}

call_status set_experiment(instance *instance, const char *call, bool tolerance_defined, double tolerance,
                           double start_time, bool stop_time_defined, double stop_time) {
    if (!call_is_allowed(instance, call, INSTANTIATED)) {
        return CALL_ERROR;
    }
    const char *wrong = NULL;
    if (!fmu_is_time(start_time)) {
        wrong = "the start time is not finite or beyond 1e100 s";
    } else if (stop_time_defined && !(stop_time >= start_time)) {
        wrong = "the stop time lies before the start time, or is not a number";
    } else if (tolerance_defined && !(tolerance > 0.0 && isfinite(tolerance))) {
        wrong = "the tolerance is not a positive number";
    }
    if (wrong != NULL) {
        return answer(instance, CALL_ERROR, call, "%s", wrong);
    }
    fmu_set_time(&instance->fmu, start_time);
    instance->fmu.importer_tolerance = tolerance_defined ? tolerance : INFINITY;
    instance->fmu.stop_time = stop_time_defined ? stop_time : INFINITY;
    discard_view(instance);
    return CALL_OK;
}

call_status exit_initialization(instance *instance, const char *call) {
    char text[FMU_TEXT];
    if (!call_is_allowed(instance, call, INITIALIZATION_MODE)) {
        return CALL_ERROR;
    }
    if (instance->fmu.settings[SETTING_METHOD] != SOLVER_NATIVE && !tdmf_page_cvode_is_available()) {
        return answer(instance, CALL_ERROR, call,
                      "solver.method = cvode is refused: this unit was built without "
                      "SUNDIALS; allowed: native");
    }
    if (fmu_start(&instance->fmu, text) != NULL) {
        return answer(instance, CALL_ERROR, call, "%s", text);
    }
    discard_view(instance);
    instance->state = instance->interface == CO_SIMULATION ? STEP_MODE : EVENT_MODE;
    return CALL_OK;
}

call_status reset(instance *instance, const char *call) {
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    begin_again(instance);
    return CALL_OK;
}
