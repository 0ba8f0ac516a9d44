/* FMI 2.0: an instance from its making to its end, common to both interfaces. */
#include "fmi2_instance.h"

typedef char agrees_status_numbers[(int)fmi2Warning == CALL_WARNING && (int)fmi2Discard == CALL_DISCARD &&
                                           (int)fmi2Error == CALL_ERROR
                                       ? 1
                                       : -1];

const char *fmi2GetTypesPlatform(void) {
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void) {
    return fmi2Version;
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, size_t count,
                               const fmi2String names[]) {
    return (fmi2Status)set_logging(component, "fmi2SetDebugLogging", on != fmi2False, count, names);
}

static void send(const instance *instance, call_status status, const char *category, const char *text) {
    const fmi2_instance *own = (const fmi2_instance *)instance;
    if (own->logger != NULL) {
        own->logger(own->environment, instance->name, (fmi2Status)status, category, "%s", text);
    }
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resource_location,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean logging) {
    (void)resource_location;
    (void)visible;
    const fmi2CallbackLogger logger = functions == NULL ? NULL : functions->logger;
    const fmi2ComponentEnvironment environment = functions == NULL ? NULL : functions->componentEnvironment;
    const char *reason = reason_to_refuse(name, guid);
    if (reason == NULL && type != fmi2ModelExchange && type != fmi2CoSimulation) {
        reason = "the type is neither Model Exchange nor Co-Simulation";
    }
    const interface_kind interface = type == fmi2ModelExchange ? MODEL_EXCHANGE : CO_SIMULATION;
    fmi2_instance *made =
        reason == NULL ? (fmi2_instance *)instance_new(sizeof *made, name, interface, logging != fmi2False)
                       : NULL;
    if (made == NULL) {
        if (logger != NULL) {
            logger(environment, name == NULL ? "" : name, fmi2Error, "logStatusError", "fmi2Instantiate: %s",
                   reason == NULL ? "out of memory" : reason);
        }
        return NULL;
    }
    made->instance.send = send;
    made->logger = logger;
    made->environment = environment;
    return made;
}

void fmi2FreeInstance(fmi2Component component) {
    instance_free(component);
}

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start_time, fmi2Boolean stop_time_defined, fmi2Real stop_time) {
    return (fmi2Status)set_experiment(component, "fmi2SetupExperiment", tolerance_defined != fmi2False,
                                      tolerance, start_time, stop_time_defined != fmi2False, stop_time);
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
    return (fmi2Status)enter_initialization(component, "fmi2EnterInitializationMode");
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
    return (fmi2Status)exit_initialization(component, "fmi2ExitInitializationMode");
}

fmi2Status fmi2Terminate(fmi2Component component) {
    return (fmi2Status)terminate(component, "fmi2Terminate");
}

fmi2Status fmi2Reset(fmi2Component component) {
    return (fmi2Status)reset(component, "fmi2Reset");
}
