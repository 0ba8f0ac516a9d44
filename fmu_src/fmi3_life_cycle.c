/* FMI 3.0: an instance from its making to its end, common to both interfaces. */
#include "fmi3_instance.h"

#include <stdio.h>

typedef char agrees_status_numbers[(int)fmi3Warning == CALL_WARNING && (int)fmi3Discard == CALL_DISCARD &&
                                           (int)fmi3Error == CALL_ERROR
                                       ? 1
                                       : -1];

const char *fmi3GetVersion(void) {
    return fmi3Version;
}

fmi3Status fmi3SetDebugLogging(fmi3Instance component, fmi3Boolean on, size_t count,
                               const fmi3String names[]) {
    return (fmi3Status)set_logging(component, "fmi3SetDebugLogging", on, count, names);
}

static void send(const instance *instance, call_status status, const char *category, const char *text) {
    const fmi3_instance *own = (const fmi3_instance *)instance;
    if (own->logger != NULL) {
        own->logger(own->environment, (fmi3Status)status, category, text);
    }
}

static void refuse_instance(const char *call, const char *reason, fmi3InstanceEnvironment environment,
                            fmi3LogMessageCallback logger) {
    char text[256];
    if (logger != NULL) {
        snprintf(text, sizeof text, "%s: %s", call, reason);
        logger(environment, fmi3Error, "logStatusError", text);
    }
}

static fmi3_instance *instantiate(const char *call, interface_kind interface, fmi3String name,
                                  fmi3String token, fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                  fmi3LogMessageCallback logger) {
    const char *reason = reason_to_refuse(name, token);
    fmi3_instance *made =
        reason == NULL ? (fmi3_instance *)instance_new(sizeof *made, name, interface, logging) : NULL;
    if (made == NULL) {
        refuse_instance(call, reason == NULL ? "out of memory" : reason, environment, logger);
        return NULL;
    }
    made->instance.send = send;
    made->logger = logger;
    made->environment = environment;
    return made;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resource_path,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback logger) {
    (void)resource_path;
    (void)visible;
    return instantiate("fmi3InstantiateModelExchange", MODEL_EXCHANGE, name, token, logging, environment,
                       logger);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resource_path,
                                         fmi3Boolean visible, fmi3Boolean logging,
                                         fmi3Boolean event_mode_used, fmi3Boolean early_return_allowed,
                                         const fmi3ValueReference required_variables[], size_t required_count,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                         fmi3IntermediateUpdateCallback update) {
    static const char call[] = "fmi3InstantiateCoSimulation";
    (void)resource_path;
    (void)visible;
    (void)required_variables; /* for updates between communication points, of which the unit makes none */
    (void)required_count;
    (void)update;
    fmi3_instance *made = instantiate(call, event_mode_used ? CO_SIMULATION_WITH_EVENT_MODE : CO_SIMULATION,
                                      name, token, logging, environment, logger);
    if (made != NULL) {
        made->early_return_allowed = early_return_allowed;
    }
    return made;
}

fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String name, fmi3String token, fmi3String resource_path, fmi3Boolean visible, fmi3Boolean logging,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger, fmi3ClockUpdateCallback clock_update,
    fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock) {
    (void)name;
    (void)token;
    (void)resource_path;
    (void)visible;
    (void)logging;
    (void)clock_update;
    (void)lock;
    (void)unlock;
    refuse_instance("fmi3InstantiateScheduledExecution", "the unit has no Scheduled Execution", environment,
                    logger);
    return NULL;
}

void fmi3FreeInstance(fmi3Instance component) {
    instance_free(component);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance component, fmi3Boolean tolerance_defined,
                                       fmi3Float64 tolerance, fmi3Float64 start_time,
                                       fmi3Boolean stop_time_defined, fmi3Float64 stop_time) {
    static const char call[] = "fmi3EnterInitializationMode";
    const call_status status = set_experiment(component, call, tolerance_defined, tolerance, start_time,
                                              stop_time_defined, stop_time);
    return (fmi3Status)(status == CALL_OK ? enter_initialization(component, call) : status);
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance component) {
    return (fmi3Status)exit_initialization(component, "fmi3ExitInitializationMode");
}

fmi3Status fmi3EnterEventMode(fmi3Instance component) {
    static const char call[] = "fmi3EnterEventMode";
    instance *instance = component;
    if (instance != NULL && instance->state == STEP_MODE && instance->interface == CO_SIMULATION) {
        return (fmi3Status)refuse(instance, call, "the instance was made without event mode");
    }
    return (fmi3Status)enter_event_mode(instance, call, CONTINUOUS_TIME_MODE | STEP_MODE);
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance component, fmi3Boolean *needs_update,
                                    fmi3Boolean *terminate_simulation, fmi3Boolean *nominals_changed,
                                    fmi3Boolean *states_changed, fmi3Boolean *next_time_defined,
                                    fmi3Float64 *next_time) {
    static const char call[] = "fmi3UpdateDiscreteStates";
    if (!call_is_allowed(component, call, EVENT_MODE) ||
        !array_is_given(component, call, needs_update, 1, 1) ||
        !array_is_given(component, call, terminate_simulation, 1, 1) ||
        !array_is_given(component, call, nominals_changed, 1, 1) ||
        !array_is_given(component, call, states_changed, 1, 1) ||
        !array_is_given(component, call, next_time_defined, 1, 1) ||
        !array_is_given(component, call, next_time, 1, 1)) {
        return fmi3Error;
    }
    discrete_update update = {0};
    const call_status status = update_discrete_states(component, call, &update);
    *needs_update = fmi3False;
    *terminate_simulation = update.terminate;
    *nominals_changed = fmi3False;
    *states_changed = update.states_changed;
    *next_time_defined = update.next_time_defined;
    *next_time = update.next_time;
    return (fmi3Status)status;
}

fmi3Status fmi3Terminate(fmi3Instance component) {
    return (fmi3Status)terminate(component, "fmi3Terminate");
}

fmi3Status fmi3Reset(fmi3Instance component) {
    return (fmi3Status)reset(component, "fmi3Reset");
}
