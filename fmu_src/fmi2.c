/* The calls of FMI 2.0: each is a row of its name, its arguments, and what it does in terms of instance.h. */
#include "fmi2Functions.h"

#ifdef FMI2_FUNCTION_PREFIX /* some copies of the header above ignore it */
#undef fmi2FullName
#define FMI2_JOINED(prefix, name)   prefix##name
#define FMI2_PREFIXED(prefix, name) FMI2_JOINED(prefix, name)
#define fmi2FullName(name)          FMI2_PREFIXED(FMI2_FUNCTION_PREFIX, name)
#endif

#include "instance.h"

#include <math.h>

typedef char agrees_status_numbers[(int)fmi2Warning == CALL_WARNING && (int)fmi2Discard == CALL_DISCARD &&
                                           (int)fmi2Error == CALL_ERROR
                                       ? 1
                                       : -1];

/* An instance with the importer's callbacks. */
typedef struct {
    instance instance;
    fmi2CallbackLogger logger; /* may be NULL */
    fmi2ComponentEnvironment environment;
} fmi2_instance;

#define CALL(name, given, does)                                                                              \
    fmi2Status fmi2##name given {                                                                            \
        static const char call[] = "fmi2" #name;                                                             \
        return (fmi2Status)(does);                                                                           \
    }
#define REFERENCES const fmi2ValueReference references[], size_t count

/* ---- life cycle of an instance ------------------------------------------------------------------------- */

const char *fmi2GetTypesPlatform(void) {
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void) {
    return fmi2Version;
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
    const fmi2CallbackLogger logger = functions == NULL ? NULL : functions->logger;
    const fmi2ComponentEnvironment environment = functions == NULL ? NULL : functions->componentEnvironment;
    const interface_kind interface = type == fmi2ModelExchange ? MODEL_EXCHANGE : CO_SIMULATION;
    const char *reason = type == fmi2ModelExchange || type == fmi2CoSimulation
                             ? NULL
                             : "the type is neither Model Exchange nor Co-Simulation";
    fmi2_instance *made = instance_new(sizeof *made, name, guid, interface, logging != fmi2False, &reason);
    if (made == NULL) {
        if (logger != NULL) {
            logger(environment, name == NULL ? "" : name, fmi2Error, "logStatusError", "fmi2Instantiate: %s",
                   reason);
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

CALL(SetDebugLogging, (fmi2Component c, fmi2Boolean on, size_t count, const fmi2String names[]),
     set_logging(c, call, on != fmi2False, count, names))
CALL(SetupExperiment,
     (fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop,
      fmi2Real stop),
     set_experiment(c, call, has_tolerance != fmi2False, tolerance, start, has_stop != fmi2False, stop))
CALL(EnterInitializationMode, (fmi2Component c), enter_state(c, call, INSTANTIATED, INITIALIZATION_MODE))
CALL(ExitInitializationMode, (fmi2Component c), exit_initialization(c, call))
CALL(Terminate, (fmi2Component c), enter_state(c, call, RUNNING, TERMINATED))
CALL(Reset, (fmi2Component c), reset(c, call))

/* ---- variables ----------------------------------------------------------------------------------------- */

static const unsigned integers = VARIABLE_INTEGER | VARIABLE_ENUMERATION;

static void write_int(void *values, size_t i, double number) {
    ((int *)values)[i] = (int)number;
}

static double read_int(const void *values, size_t i) {
    return ((const int *)values)[i];
}

CALL(GetReal, (fmi2Component c, REFERENCES, fmi2Real values[]),
     get_numbers(c, call, VARIABLE_REAL, references, count, values, write_double))
CALL(GetInteger, (fmi2Component c, REFERENCES, fmi2Integer values[]),
     get_numbers(c, call, integers, references, count, values, write_int))
CALL(GetBoolean, (fmi2Component c, REFERENCES, fmi2Boolean values[]),
     get_numbers(c, call, VARIABLE_BOOLEAN, references, count, values, write_int))
CALL(GetString, (fmi2Component c, REFERENCES, fmi2String values[]),
     get_texts(c, call, references, count, values))
CALL(SetReal, (fmi2Component c, REFERENCES, const fmi2Real values[]),
     set_numbers(c, call, VARIABLE_REAL, references, count, values, read_double))
CALL(SetInteger, (fmi2Component c, REFERENCES, const fmi2Integer values[]),
     set_numbers(c, call, integers, references, count, values, read_int))
CALL(SetBoolean, (fmi2Component c, REFERENCES, const fmi2Boolean values[]),
     set_numbers(c, call, VARIABLE_BOOLEAN, references, count, values, read_int))
CALL(SetString, (fmi2Component c, REFERENCES, const fmi2String values[]),
     set_texts(c, call, references, count, values))
CALL(GetDirectionalDerivative,
     (fmi2Component c, const fmi2ValueReference unknowns[], size_t unknown_count,
      const fmi2ValueReference knowns[], size_t known_count, const fmi2Real seeds[], fmi2Real values[]),
     directional_derivative(c, call, unknowns, unknown_count, knowns, known_count, seeds, values))

CALL(GetFMUstate, (fmi2Component c, fmi2FMUstate *state), save_state(c, call, state))
CALL(SetFMUstate, (fmi2Component c, fmi2FMUstate state), restore_state(c, call, state))
CALL(FreeFMUstate, (fmi2Component c, fmi2FMUstate *state), free_state(c, call, state))
CALL(SerializedFMUstateSize, (fmi2Component c, fmi2FMUstate state, size_t *size),
     measure_state(c, call, state, size))
CALL(SerializeFMUstate, (fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size),
     serialize_state(c, call, state, bytes, size))
CALL(DeSerializeFMUstate, (fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state),
     deserialize_state(c, call, bytes, size, state))

/* ---- Model Exchange ------------------------------------------------------------------------------------ */

fmi2Status fmi2NewDiscreteStates(fmi2Component component, fmi2EventInfo *info) {
    static const char call[] = "fmi2NewDiscreteStates";
    if (!MAY_BEGIN(component, call, EVENT_MODE, 1, info)) {
        return fmi2Error;
    }
    discrete_update update = {0};
    const call_status status = update_discrete_states(component, call, &update);
    const fmi2EventInfo found = {.valuesOfContinuousStatesChanged = update.states_changed,
                                 .terminateSimulation = update.terminate,
                                 .nextEventTimeDefined = update.next_time_defined,
                                 .nextEventTime = update.next_time};
    *info = found;
    return (fmi2Status)status;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component component, fmi2Boolean no_set_state_before,
                                       fmi2Boolean *enter_event_mode, fmi2Boolean *terminate) {
    bool asks = false;
    const call_status status =
        complete_step(component, "fmi2CompletedIntegratorStep", enter_event_mode, terminate, &asks);
    if (status == CALL_OK) {
        *enter_event_mode = asks;
        *terminate = fmi2False;
    }
    return (fmi2Status)status;
}

CALL(EnterEventMode, (fmi2Component c), enter_event_mode(c, call, EVENT_MODE | CONTINUOUS_TIME_MODE))
CALL(EnterContinuousTimeMode, (fmi2Component c), enter_state(c, call, EVENT_MODE, CONTINUOUS_TIME_MODE))
CALL(SetTime, (fmi2Component c, fmi2Real time), set_time(c, call, time))
CALL(SetContinuousStates, (fmi2Component c, const fmi2Real states[], size_t count),
     set_states(c, call, states, count))
CALL(GetContinuousStates, (fmi2Component c, fmi2Real states[], size_t count),
     get_states(c, call, states, count))
CALL(GetDerivatives, (fmi2Component c, fmi2Real derivatives[], size_t count),
     get_derivatives(c, call, derivatives, count))
CALL(GetEventIndicators, (fmi2Component c, fmi2Real indicators[], size_t count),
     get_indicators(c, call, indicators, count))
CALL(GetNominalsOfContinuousStates, (fmi2Component c, fmi2Real nominals[], size_t count),
     get_nominals(c, call, nominals, count))

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

static const unsigned after_steps = STEP_MODE | TERMINATED | FAILED;

CALL(DoStep, (fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_set_state_before),
     step_on(c, call, time, step, false, &(bool){false}))

static call_status check_input_rate(const instance *instance, const char *call, fmi2ValueReference reference,
                                    fmi2Integer order, double value) {
    const fmu_variable *variable = find_variable(instance, call, reference, VARIABLE_REAL);
    if (variable == NULL) {
        return CALL_ERROR;
    }
    if (variable->storage != STORED_INPUT) {
        return answer(instance, CALL_ERROR, call, "%s is not an input", variable->name);
    }
    if (variable->variability != VARIABILITY_CONTINUOUS) {
        return answer(instance, CALL_ERROR, call, "%s changes at events only: it has no derivative",
                      variable->name);
    }
    if (order != 1) {
        return answer(instance, CALL_ERROR, call, "only first derivatives of inputs are taken, not order %d",
                      order);
    }
    return isfinite(value)
               ? CALL_OK
               : answer(instance, CALL_DISCARD, call, "the derivative of %s is not finite", variable->name);
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, REFERENCES, const fmi2Integer orders[],
                                       const fmi2Real values[]) {
    static const char call[] = "fmi2SetRealInputDerivatives";
    instance *instance = component;
    if (!MAY_BEGIN(instance, call, BEFORE_START | STEP_MODE, count, references, orders, values)) {
        return fmi2Error;
    }
    call_status status = CALL_OK;
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        status = check_input_rate(instance, call, references[i], orders[i], values[i]);
    }
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        double *rate = fmu_rate_of(&instance->fmu, &fmu_variables[references[i]]);
        if (rate != NULL) {
            *rate = values[i];
        }
    }
    discard_view(instance);
    return (fmi2Status)status;
}

CALL(GetRealOutputDerivatives, (fmi2Component c, REFERENCES, const fmi2Integer orders[], fmi2Real values[]),
     output_derivatives(c, call, references, count, orders, values))
CALL(CancelStep, (fmi2Component c),
     c == NULL ? CALL_ERROR : answer(c, CALL_ERROR, call, "no step is under way: steps are not asynchronous"))

/* Steps are not asynchronous, so only two statuses exist. */

static call_status refuse_status(const instance *instance, const char *call) {
    return call_is_allowed(instance, call, after_steps)
               ? answer(instance, CALL_DISCARD, call, "steps are not asynchronous, there is no such status")
               : CALL_ERROR;
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value) {
    static const char call[] = "fmi2GetRealStatus";
    const instance *instance = component;
    if (kind != fmi2LastSuccessfulTime) {
        return (fmi2Status)refuse_status(instance, call);
    }
    if (!MAY_BEGIN(instance, call, after_steps, 1, value)) {
        return fmi2Error;
    }
    *value = instance->fmu.time;
    return fmi2OK;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value) {
    static const char call[] = "fmi2GetBooleanStatus";
    if (kind != fmi2Terminated) {
        return (fmi2Status)refuse_status(component, call);
    }
    if (!MAY_BEGIN(component, call, after_steps, 1, value)) {
        return fmi2Error;
    }
    *value = fmi2False;
    return fmi2OK;
}

CALL(GetStatus, (fmi2Component c, const fmi2StatusKind kind, fmi2Status *value), refuse_status(c, call))
CALL(GetIntegerStatus, (fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value),
     refuse_status(c, call))
CALL(GetStringStatus, (fmi2Component c, const fmi2StatusKind kind, fmi2String *value), refuse_status(c, call))
