/* The calls of FMI 2.0: each is a row of its name, its kind, its arguments, and what it does in terms of
 * instance.h. */
#include "fmi2Functions.h"

#ifdef FMI2_FUNCTION_PREFIX /* some copies of the header above ignore it */
#undef fmi2FullName
#define FMI2_JOINED(prefix, name)   prefix##name
#define FMI2_PREFIXED(prefix, name) FMI2_JOINED(prefix, name)
#define fmi2FullName(name)          FMI2_PREFIXED(FMI2_FUNCTION_PREFIX, name)
#endif

#include "instance.h"

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

#define CALL(name, kind, given, does)                                                                        \
    fmi2Status fmi2##name given {                                                                            \
        return (fmi2Status)(call_begins(c, "fmi2" #name, kind) ? (does) : CALL_ERROR);                       \
    }
#define REFERENCES const fmi2ValueReference references[], size_t count

/* ---- life cycle of an instance ------------------------------------------------------------------------- */

const char *fmi2GetTypesPlatform(void) {
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void) {
    return fmi2Version;
}

static void send(const instance *fmu, call_status status, const char *category, const char *text) {
    const fmi2_instance *own = (const fmi2_instance *)fmu;
    if (own->logger != NULL) {
        own->logger(own->environment, fmu->name, (fmi2Status)status, category, "%s", text);
    }
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resource_location,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible,
                              fmi2Boolean logging) {
    const fmi2CallbackLogger logger = functions == NULL ? NULL : functions->logger;
    fmi2ComponentEnvironment environment = functions == NULL ? NULL : functions->componentEnvironment;
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

void fmi2FreeInstance(fmi2Component c) {
    instance_free(c);
}

CALL(SetDebugLogging, ALWAYS_ALLOWED,
     (fmi2Component c, fmi2Boolean on, size_t count, const fmi2String names[]),
     set_logging(c, on != fmi2False, count, names))
CALL(SetupExperiment, BEFORE_INITIALIZATION,
     (fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop,
      fmi2Real stop),
     set_experiment(c, has_tolerance != fmi2False, tolerance, start, has_stop != fmi2False, stop))
CALL(EnterInitializationMode, BEFORE_INITIALIZATION, (fmi2Component c), enter_state(c, INITIALIZATION_MODE))
CALL(ExitInitializationMode, IN_INITIALIZATION, (fmi2Component c), exit_initialization(c))
CALL(Terminate, WHILE_RUNNING, (fmi2Component c), enter_state(c, TERMINATED))
CALL(Reset, ALWAYS_ALLOWED, (fmi2Component c), reset(c))

/* ---- variables ----------------------------------------------------------------------------------------- */

static const unsigned integers = VARIABLE_INTEGER | VARIABLE_ENUMERATION;

static void write_double(void *values, size_t i, double number) {
    ((double *)values)[i] = number;
}

static double read_double(const void *values, size_t i) {
    return ((const double *)values)[i];
}

static void write_int(void *values, size_t i, double number) {
    ((int *)values)[i] = (int)number;
}

static double read_int(const void *values, size_t i) {
    return ((const int *)values)[i];
}

CALL(GetReal, ALWAYS_ALLOWED, (fmi2Component c, REFERENCES, fmi2Real values[]),
     get_numbers(c, VARIABLE_REAL, references, count, values, write_double))
CALL(GetInteger, ALWAYS_ALLOWED, (fmi2Component c, REFERENCES, fmi2Integer values[]),
     get_numbers(c, integers, references, count, values, write_int))
CALL(GetBoolean, ALWAYS_ALLOWED, (fmi2Component c, REFERENCES, fmi2Boolean values[]),
     get_numbers(c, VARIABLE_BOOLEAN, references, count, values, write_int))
CALL(GetString, ALWAYS_ALLOWED, (fmi2Component c, REFERENCES, fmi2String values[]),
     get_texts(c, references, count, values))
CALL(SetReal, SETS_VALUES, (fmi2Component c, REFERENCES, const fmi2Real values[]),
     set_numbers(c, VARIABLE_REAL, references, count, values, read_double))
CALL(SetInteger, SETS_VALUES, (fmi2Component c, REFERENCES, const fmi2Integer values[]),
     set_numbers(c, integers, references, count, values, read_int))
CALL(SetBoolean, SETS_VALUES, (fmi2Component c, REFERENCES, const fmi2Boolean values[]),
     set_numbers(c, VARIABLE_BOOLEAN, references, count, values, read_int))
CALL(SetString, SETS_VALUES, (fmi2Component c, REFERENCES, const fmi2String values[]),
     set_texts(c, references, count, values))
CALL(GetDirectionalDerivative, ALWAYS_ALLOWED,
     (fmi2Component c, const fmi2ValueReference unknowns[], size_t unknown_count,
      const fmi2ValueReference knowns[], size_t known_count, const fmi2Real seeds[], fmi2Real values[]),
     directional_derivative(c, false, unknowns, unknown_count, knowns, known_count, seeds, values))

CALL(GetFMUstate, ALWAYS_ALLOWED, (fmi2Component c, fmi2FMUstate *state), save_state(c, state))
CALL(SetFMUstate, ALWAYS_ALLOWED, (fmi2Component c, fmi2FMUstate state), restore_state(c, state))
CALL(FreeFMUstate, ALWAYS_ALLOWED, (fmi2Component c, fmi2FMUstate *state), free_state(state))
CALL(SerializedFMUstateSize, ALWAYS_ALLOWED, (fmi2Component c, fmi2FMUstate state, size_t *size),
     measure_state(c, state, size))
CALL(SerializeFMUstate, ALWAYS_ALLOWED, (fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size),
     serialize_state(c, state, bytes, size))
CALL(DeSerializeFMUstate, ALWAYS_ALLOWED,
     (fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state),
     deserialize_state(c, bytes, size, state))

/* ---- Model Exchange ------------------------------------------------------------------------------------ */

static call_status new_discrete_states(instance *fmu, fmi2EventInfo *info) {
    discrete_update update = {0};
    if (!ARE_GIVEN(fmu, 1, info)) {
        return CALL_ERROR;
    }
    const call_status status = update_discrete_states(fmu, &update);
    const fmi2EventInfo found = {.valuesOfContinuousStatesChanged = update.states_changed,
                                 .terminateSimulation = update.terminate,
                                 .nextEventTimeDefined = update.next_time_defined,
                                 .nextEventTime = update.next_time};
    *info = found;
    return status;
}

static call_status completed_step(instance *fmu, fmi2Boolean *enter_event_mode, fmi2Boolean *terminate) {
    if (!ARE_GIVEN(fmu, 1, enter_event_mode, terminate)) {
        return CALL_ERROR;
    }
    *enter_event_mode = complete_step(fmu);
    *terminate = fmi2False;
    return CALL_OK;
}

CALL(NewDiscreteStates, IN_EVENT_MODE, (fmi2Component c, fmi2EventInfo *info), new_discrete_states(c, info))
CALL(CompletedIntegratorStep, INTEGRATES,
     (fmi2Component c, fmi2Boolean no_set_state_before, fmi2Boolean *event_mode, fmi2Boolean *terminate),
     completed_step(c, event_mode, terminate))
CALL(EnterEventMode, ENTERS_EVENT_MODE_AGAIN, (fmi2Component c), enter_event_mode(c))
CALL(EnterContinuousTimeMode, ENTERS_CONTINUOUS_TIME, (fmi2Component c), enter_state(c, CONTINUOUS_TIME_MODE))
CALL(SetTime, SETS_TIME, (fmi2Component c, fmi2Real time), set_time(c, time))
CALL(SetContinuousStates, INTEGRATES, (fmi2Component c, const fmi2Real states[], size_t count),
     set_states(c, states, count))
CALL(GetContinuousStates, EVALUATES, (fmi2Component c, fmi2Real states[], size_t count),
     get_states(c, states, count))
CALL(GetDerivatives, EVALUATES, (fmi2Component c, fmi2Real derivatives[], size_t count),
     get_derivatives(c, derivatives, count))
CALL(GetEventIndicators, EVALUATES, (fmi2Component c, fmi2Real indicators[], size_t count),
     get_indicators(c, indicators, count))
CALL(GetNominalsOfContinuousStates, ASKS_FOR_NOMINALS, (fmi2Component c, fmi2Real nominals[], size_t count),
     get_nominals(c, nominals, count))

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

static call_status check_input_rate(const instance *fmu, fmi2ValueReference reference, fmi2Integer order,
                                    double value) {
    const fmu_variable *variable = find_variable(fmu, reference, VARIABLE_REAL);
    if (variable == NULL) {
        return CALL_ERROR;
    }
    if (variable->storage != STORED_INPUT) {
        return answer(fmu, CALL_ERROR, "%s is not an input", variable->name);
    }
    if (variable->variability != VARIABILITY_CONTINUOUS) {
        return answer(fmu, CALL_ERROR, "%s changes at events only: it has no derivative", variable->name);
    }
    if (order != 1) {
        return answer(fmu, CALL_ERROR, "only first derivatives of inputs are taken, not order %d", order);
    }
    return isfinite(value) ? CALL_OK
                           : answer(fmu, CALL_DISCARD, "the derivative of %s is not finite", variable->name);
}

static call_status set_input_rates(instance *fmu, REFERENCES, const fmi2Integer orders[],
                                   const fmi2Real values[]) {
    call_status status = ARE_GIVEN(fmu, count, references, orders, values) ? CALL_OK : CALL_ERROR;
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        status = check_input_rate(fmu, references[i], orders[i], values[i]);
    }
    for (size_t i = 0; i < count && status == CALL_OK; ++i) {
        double *rate = rate_in(fmu, &fmu_variables[references[i]]);
        if (rate != NULL) {
            *rate = values[i];
        }
    }
    fmu->current = 0;
    return status;
}

CALL(DoStep, STEPS_FORWARD, (fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_set_state_before),
     make_step(c, time, step, false))
CALL(SetRealInputDerivatives, SETS_RATES,
     (fmi2Component c, REFERENCES, const fmi2Integer orders[], const fmi2Real values[]),
     set_input_rates(c, references, count, orders, values))
CALL(GetRealOutputDerivatives, FOLLOWS_STEP,
     (fmi2Component c, REFERENCES, const fmi2Integer orders[], fmi2Real values[]),
     output_derivatives(c, references, count, orders, values))
CALL(CancelStep, ALWAYS_ALLOWED, (fmi2Component c),
     answer(c, CALL_ERROR, "no step is under way: steps are not asynchronous"))

/* Steps are not asynchronous, so only two statuses exist. */

static call_status refuse_status(const instance *fmu) {
    return answer(fmu, CALL_DISCARD, "steps are not asynchronous, there is no such status");
}

static call_status get_real_status(const instance *fmu, fmi2StatusKind kind, fmi2Real *value) {
    if (kind != fmi2LastSuccessfulTime) {
        return refuse_status(fmu);
    }
    if (!ARE_GIVEN(fmu, 1, value)) {
        return CALL_ERROR;
    }
    *value = fmu->run.time;
    return CALL_OK;
}

static call_status get_boolean_status(const instance *fmu, fmi2StatusKind kind, fmi2Boolean *value) {
    if (kind != fmi2Terminated) {
        return refuse_status(fmu);
    }
    if (!ARE_GIVEN(fmu, 1, value)) {
        return CALL_ERROR;
    }
    *value = fmi2False;
    return CALL_OK;
}

CALL(GetRealStatus, FOLLOWS_STEP, (fmi2Component c, const fmi2StatusKind kind, fmi2Real *value),
     get_real_status(c, kind, value))
CALL(GetBooleanStatus, FOLLOWS_STEP, (fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value),
     get_boolean_status(c, kind, value))
CALL(GetStatus, FOLLOWS_STEP, (fmi2Component c, const fmi2StatusKind kind, fmi2Status *value),
     refuse_status(c))
CALL(GetIntegerStatus, FOLLOWS_STEP, (fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value),
     refuse_status(c))
CALL(GetStringStatus, FOLLOWS_STEP, (fmi2Component c, const fmi2StatusKind kind, fmi2String *value),
     refuse_status(c))
