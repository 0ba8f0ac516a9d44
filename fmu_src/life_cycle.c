/* An instance from its making to its end, common to all interfaces and versions. */
#include "guid.h"
#include "instance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *reason_to_refuse(const char *name, const char *identification) {
    if (name == NULL || name[0] == '\0') {
        return "the instance needs a name";
    }
    if (identification == NULL || strcmp(identification, FMU_GUID) != 0) {
        return "the guid or instantiation token is not this unit's, " FMU_GUID;
    }
    return NULL;
}

static void begin_again(instance *instance) {
    fmu_reset(&instance->fmu);
    discard_view(instance);
    instance->state = INSTANTIATED;
}

instance *instance_new(size_t size, const char *name, interface_kind interface, bool logging) {
    instance *made = calloc(1, size);
    const size_t length = strlen(name) + 1;
    char *copy = malloc(length);
    if (made == NULL || copy == NULL || !fmu_create(&made->fmu, interface == MODEL_EXCHANGE)) {
        free(made);
        free(copy);
        return NULL;
    }
    memcpy(copy, name, length);
    made->name = copy;
    made->interface = interface;
    made->log_categories = logging ? LOG_ALL : 0;
    begin_again(made);
    return made;
}

void instance_free(instance *instance) {
    if (instance != NULL) {
        fmu_free(&instance->fmu);
        free(instance->name);
        free(instance);
    }
}

call_status set_experiment(instance *instance, const char *call, bool tolerance_defined, double tolerance,
                           double start_time, bool stop_time_defined, double stop_time) {
    if (!call_is_allowed(instance, call, INSTANTIATED)) {
        return CALL_ERROR;
    }
    if (!fmu_is_time(start_time)) {
        return refuse(instance, call, "the start time is not finite or beyond 1e100 s");
    }
    if (stop_time_defined && !(stop_time >= start_time)) {
        return refuse(instance, call, "the stop time lies before the start time, or is not a number");
    }
    if (tolerance_defined && !(tolerance > 0.0 && isfinite(tolerance))) {
        return refuse(instance, call, "the tolerance is not a positive number");
    }
    fmu_set_time(&instance->fmu, start_time);
    instance->fmu.importer_tolerance = tolerance_defined ? tolerance : INFINITY;
    instance->fmu.stop_time = stop_time_defined ? stop_time : INFINITY;
    discard_view(instance);
    return CALL_OK;
}

call_status enter_initialization(instance *instance, const char *call) {
    if (!call_is_allowed(instance, call, INSTANTIATED)) {
        return CALL_ERROR;
    }
    instance->state = INITIALIZATION_MODE;
    return CALL_OK;
}

call_status exit_initialization(instance *instance, const char *call) {
    if (!call_is_allowed(instance, call, INITIALIZATION_MODE)) {
        return CALL_ERROR;
    }
    if (!fmu_has_solver(&instance->fmu)) {
        return refuse(instance, call,
                      "solver.method = cvode is refused: this unit was built without "
                      "SUNDIALS; allowed: native");
    }
    char text[FMU_TEXT];
    if (fmu_start(&instance->fmu, text) != NULL) {
        return refuse(instance, call, "%s", text);
    }
    discard_view(instance);
    instance->state = instance->interface == CO_SIMULATION ? STEP_MODE : EVENT_MODE;
    return CALL_OK;
}

call_status terminate(instance *instance, const char *call) {
    if (!call_is_allowed(instance, call, RUNNING)) {
        return CALL_ERROR;
    }
    instance->state = TERMINATED;
    return CALL_OK;
}

call_status reset(instance *instance, const char *call) {
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    begin_again(instance);
    return CALL_OK;
}
