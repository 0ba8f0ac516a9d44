/* FMI 2.0: an instance from its making to its end, common to all interfaces. */
#include "fmi2_instance.h"
#include "guid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *fmi2GetTypesPlatform(void) {
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void) {
    return fmi2Version;
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, size_t count,
                               const fmi2String names[]) {
    instance *instance = component;
    if (!call_is_allowed(instance, "fmi2SetDebugLogging", ANYWHERE) ||
        !array_is_given(instance, "fmi2SetDebugLogging", names, count, count)) {
        return fmi2Error;
    }
    unsigned chosen = count == 0 ? (unsigned)(on ? LOG_ALL : LOG_EVENTS) : 0;
    for (size_t i = 0; i < count; ++i) {
        const unsigned category = names[i] == NULL ? 0 : log_category_named(names[i]);
        if (category == 0) {
            return fail(instance, "fmi2SetDebugLogging", "there is no log category %s",
                        names[i] == NULL ? "(null)" : names[i]);
        }
        chosen |= category;
    }
    instance->log_categories = on ? chosen : instance->log_categories & ~chosen;
    return fmi2OK;
}

/* Why no instance can be made; NULL if one can. */
static const char *reason_to_refuse(fmi2String name, fmi2Type type, fmi2String guid) {
    if (name == NULL || name[0] == '\0') {
        return "the instance needs a name";
    }
    if (type != fmi2ModelExchange && type != fmi2CoSimulation) {
        return "the type is neither Model Exchange nor Co-Simulation";
    }
    if (guid == NULL || strcmp(guid, UNIT_GUID) != 0) {
        return "the guid is not this unit's, " UNIT_GUID;
    }
    return NULL;
}

static instance *allocate(fmi2String name) {
    instance *made = calloc(1, sizeof *made);
    const size_t size = strlen(name) + 1;
    char *copy = malloc(size);
    if (made == NULL || copy == NULL) {
        free(made);
        free(copy);
        return NULL;
    }
    memcpy(copy, name, size);
    made->name = copy;
    return made;
}

static void begin_again(instance *instance) {
    unit_reset(&instance->unit);
    forget_view(instance);
    instance->state = INSTANTIATED;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resource_location,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean logging) {
    (void)resource_location;
    (void)visible;
    const fmi2CallbackLogger logger = functions == NULL ? NULL : functions->logger;
    const fmi2ComponentEnvironment environment = functions == NULL ? NULL : functions->componentEnvironment;
    const char *reason = reason_to_refuse(name, type, guid);
    instance *made = reason == NULL ? allocate(name) : NULL;
    if (made == NULL) {
        if (logger != NULL) {
            logger(environment, name == NULL ? "" : name, fmi2Error, "logStatusError", "fmi2Instantiate: %s",
                   reason == NULL ? "out of memory" : reason);
        }
        return NULL;
    }
    made->type = type;
    made->logger = logger;
    made->environment = environment;
    made->log_categories = logging ? LOG_ALL : LOG_STATUS;
    begin_again(made);
    return made;
}

void fmi2FreeInstance(fmi2Component component) {
    instance *instance = component;
    if (instance != NULL) {
        free(instance->name);
        free(instance);
    }
}

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start_time, fmi2Boolean stop_time_defined, fmi2Real stop_time) {
    static const char call[] = "fmi2SetupExperiment";
    instance *instance = component;
    if (!call_is_allowed(instance, call, INSTANTIATED)) {
        return fmi2Error;
    }
    if (!isfinite(start_time)) {
        return fail(instance, call, "the start time is not finite");
    }
    if (stop_time_defined && !(stop_time >= start_time)) {
        return fail(instance, call, "the stop time lies before the start time, or is not a number");
    }
    if (tolerance_defined && !(tolerance > 0.0 && isfinite(tolerance))) {
        return fail(instance, call, "the tolerance is not a positive number");
    }
    instance->unit.motion.time = start_time;
    instance->unit.importer_tolerance = tolerance_defined ? tolerance : INFINITY;
    forget_view(instance);
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
    instance *instance = component;
    if (!call_is_allowed(instance, "fmi2EnterInitializationMode", INSTANTIATED)) {
        return fmi2Error;
    }
    instance->state = INITIALIZATION_MODE;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
    static const char call[] = "fmi2ExitInitializationMode";
    instance *instance = component;
    if (!call_is_allowed(instance, call, INITIALIZATION_MODE)) {
        return fmi2Error;
    }
    const char *obstacle = unit_settings_obstacle(&instance->unit);
    if (obstacle != NULL) {
        return fail(instance, call, "%s", obstacle);
    }
    const tdmf_refusal refusal = unit_start(&instance->unit);
    if (refusal.variable != NULL) {
        char text[256];
        return fail(instance, call, "%s", tdmf_refusal_text(&refusal, text, sizeof text));
    }
    forget_view(instance);
    instance->state = instance->type == fmi2CoSimulation ? STEP_COMPLETE : EVENT_MODE;
    return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component component) {
    instance *instance = component;
    if (!call_is_allowed(instance, "fmi2Terminate", RUNNING)) {
        return fmi2Error;
    }
    instance->state = TERMINATED;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component component) {
    instance *instance = component;
    if (!call_is_allowed(instance, "fmi2Reset", ANYWHERE)) {
        return fmi2Error;
    }
    begin_again(instance);
    return fmi2OK;
}
