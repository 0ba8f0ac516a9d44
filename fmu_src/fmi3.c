/* The calls of FMI 3.0: each is a row of its name, its arguments, and what it does in terms of instance.h.
 * Every variable is a scalar, so there are as many values as references. */
#include "fmi3Functions.h"

#include "instance.h"

#include <stdio.h>

typedef char agrees_status_numbers[(int)fmi3Warning == CALL_WARNING && (int)fmi3Discard == CALL_DISCARD &&
                                           (int)fmi3Error == CALL_ERROR
                                       ? 1
                                       : -1];

/* An instance with the importer's callback and options. */
typedef struct {
    instance instance;
    bool early_return_allowed;
    fmi3LogMessageCallback logger; /* may be NULL */
    fmi3InstanceEnvironment environment;
} fmi3_instance;

#define CALL(name, given, does)                                                                              \
    fmi3Status fmi3##name given {                                                                            \
        static const char call[] = "fmi3" #name;                                                             \
        return (fmi3Status)(does);                                                                           \
    }
#define REFERENCES const fmi3ValueReference references[], size_t count

/* ---- life cycle of an instance ------------------------------------------------------------------------- */

const char *fmi3GetVersion(void) {
    return fmi3Version;
}

static void send(const instance *instance, call_status status, const char *category, const char *text) {
    const fmi3_instance *own = (const fmi3_instance *)instance;
    if (own->logger != NULL) {
        own->logger(own->environment, (fmi3Status)status, category, text);
    }
}

static fmi3_instance *instantiate(const char *call, interface_kind interface, const char *reason,
                                  fmi3String name, fmi3String token, fmi3Boolean logging,
                                  fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger) {
    char text[256];
    fmi3_instance *made = instance_new(sizeof *made, name, token, interface, logging, &reason);
    if (made != NULL) {
        made->instance.send = send;
        made->logger = logger;
        made->environment = environment;
    } else if (logger != NULL) {
        snprintf(text, sizeof text, "%s: %s", call, reason);
        logger(environment, fmi3Error, "logStatusError", text);
    }
    return made;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resource_path,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback logger) {
    return instantiate("fmi3InstantiateModelExchange", MODEL_EXCHANGE, NULL, name, token, logging,
                       environment, logger);
}

/* `required` and `update` are for updates between communication points, which the unit does not make. */
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resource_path,
                                         fmi3Boolean visible, fmi3Boolean logging,
                                         fmi3Boolean event_mode_used, fmi3Boolean early_return_allowed,
                                         const fmi3ValueReference required[], size_t required_count,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                         fmi3IntermediateUpdateCallback update) {
    fmi3_instance *made = instantiate("fmi3InstantiateCoSimulation",
                                      event_mode_used ? CO_SIMULATION_WITH_EVENT_MODE : CO_SIMULATION, NULL,
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
    return instantiate("fmi3InstantiateScheduledExecution", CO_SIMULATION,
                       "the unit has no Scheduled Execution", name, token, logging, environment, logger);
}

void fmi3FreeInstance(fmi3Instance component) {
    instance_free(component);
}

CALL(SetDebugLogging, (fmi3Instance c, fmi3Boolean on, size_t count, const fmi3String names[]),
     set_logging(c, call, on, count, names))

fmi3Status fmi3EnterInitializationMode(fmi3Instance component, fmi3Boolean tolerance_defined,
                                       fmi3Float64 tolerance, fmi3Float64 start_time,
                                       fmi3Boolean stop_time_defined, fmi3Float64 stop_time) {
    static const char call[] = "fmi3EnterInitializationMode";
    const call_status status = set_experiment(component, call, tolerance_defined, tolerance, start_time,
                                              stop_time_defined, stop_time);
    return (fmi3Status)(status == CALL_OK ? enter_state(component, call, INSTANTIATED, INITIALIZATION_MODE)
                                          : status);
}

CALL(ExitInitializationMode, (fmi3Instance c), exit_initialization(c, call))
CALL(Terminate, (fmi3Instance c), enter_state(c, call, RUNNING, TERMINATED))
CALL(Reset, (fmi3Instance c), reset(c, call))

/* ---- variables and derivatives ------------------------------------------------------------------------- */

static bool counts_agree(const instance *instance, const char *call, size_t references, size_t values) {
    if (instance != NULL && references != values) {
        answer(instance, CALL_ERROR, call, "%lu value references and %lu values: every variable is a scalar",
               (unsigned long)references, (unsigned long)values);
        return false;
    }
    return true;
}

/* Calls that get and set variables of a type of FMI 3.0. */
#define VARIABLES(Type, type, from_number, to_number)                                                        \
    static void write_##Type(void *values, size_t i, double number) {                                        \
        ((fmi3##Type *)values)[i] = (fmi3##Type)(from_number);                                               \
    }                                                                                                        \
    static double read_##Type(const void *values, size_t i) {                                                \
        const fmi3##Type value = ((const fmi3##Type *)values)[i];                                            \
        return (to_number);                                                                                  \
    }                                                                                                        \
    CALL(Get##Type, (fmi3Instance c, REFERENCES, fmi3##Type values[], size_t value_count),                   \
         counts_agree(c, call, count, value_count)                                                           \
             ? get_numbers(c, call, type, references, count, values, write_##Type)                           \
             : CALL_ERROR)                                                                                   \
    CALL(Set##Type, (fmi3Instance c, REFERENCES, const fmi3##Type values[], size_t value_count),             \
         counts_agree(c, call, count, value_count)                                                           \
             ? set_numbers(c, call, type, references, count, values, read_##Type)                            \
             : CALL_ERROR)

VARIABLES(Float64, VARIABLE_REAL, number, value)
VARIABLES(Int32, VARIABLE_INTEGER, number, value)
VARIABLES(Int64, VARIABLE_ENUMERATION, number, (double)value) /* as FMI 3.0 passes enumerations */
VARIABLES(Boolean, VARIABLE_BOOLEAN, number != 0.0, value ? 1.0 : 0.0)

CALL(GetString, (fmi3Instance c, REFERENCES, fmi3String values[], size_t value_count),
     counts_agree(c, call, count, value_count) ? get_texts(c, call, references, count, values) : CALL_ERROR)
CALL(SetString, (fmi3Instance c, REFERENCES, const fmi3String values[], size_t value_count),
     counts_agree(c, call, count, value_count) ? set_texts(c, call, references, count, values) : CALL_ERROR)

#define DIRECTION                                                                                            \
    const fmi3ValueReference unknowns[], size_t unknown_count, const fmi3ValueReference knowns[],            \
        size_t known_count, const fmi3Float64 seeds[], size_t seed_count, fmi3Float64 values[],              \
        size_t value_count

CALL(GetDirectionalDerivative, (fmi3Instance c, DIRECTION),
     counts_agree(c, call, known_count, seed_count) && counts_agree(c, call, unknown_count, value_count)
         ? directional_derivative(c, call, unknowns, unknown_count, knowns, known_count, seeds, values)
         : CALL_ERROR)
CALL(GetAdjointDerivative, (fmi3Instance c, DIRECTION),
     counts_agree(c, call, unknown_count, seed_count) && counts_agree(c, call, known_count, value_count)
         ? adjoint_derivative(c, call, unknowns, unknown_count, knowns, known_count, seeds, values)
         : CALL_ERROR)

CALL(GetFMUState, (fmi3Instance c, fmi3FMUState *state), save_state(c, call, state))
CALL(SetFMUState, (fmi3Instance c, fmi3FMUState state), restore_state(c, call, state))
CALL(FreeFMUState, (fmi3Instance c, fmi3FMUState *state), free_state(c, call, state))
CALL(SerializedFMUStateSize, (fmi3Instance c, fmi3FMUState state, size_t *size),
     measure_state(c, call, state, size))
CALL(SerializeFMUState, (fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size),
     serialize_state(c, call, state, bytes, size))
CALL(DeserializeFMUState, (fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *state),
     deserialize_state(c, call, bytes, size, state))

/* ---- event mode ---------------------------------------------------------------------------------------- */

fmi3Status fmi3EnterEventMode(fmi3Instance component) {
    static const char call[] = "fmi3EnterEventMode";
    const instance *instance = component;
    if (instance != NULL && instance->state == STEP_MODE && instance->interface == CO_SIMULATION) {
        return (fmi3Status)answer(instance, CALL_ERROR, call, "the instance was made without event mode");
    }
    return (fmi3Status)enter_event_mode(component, call, CONTINUOUS_TIME_MODE | STEP_MODE);
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance component, fmi3Boolean *needs_update,
                                    fmi3Boolean *terminate_simulation, fmi3Boolean *nominals_changed,
                                    fmi3Boolean *states_changed, fmi3Boolean *next_time_defined,
                                    fmi3Float64 *next_time) {
    static const char call[] = "fmi3UpdateDiscreteStates";
    if (!MAY_BEGIN(component, call, EVENT_MODE, 1, needs_update, terminate_simulation, nominals_changed,
                   states_changed, next_time_defined, next_time)) {
        return fmi3Error;
    }
    discrete_update update = {0};
    const call_status status = update_discrete_states(component, call, &update);
    *needs_update = *nominals_changed = fmi3False;
    *terminate_simulation = update.terminate;
    *states_changed = update.states_changed;
    *next_time_defined = update.next_time_defined;
    *next_time = update.next_time;
    return (fmi3Status)status;
}

/* Refuses calls of one interface in states that the other interface has, too. */
static bool has_interface(const instance *instance, const char *call, bool is_exchange) {
    if (instance != NULL && (instance->interface == MODEL_EXCHANGE) != is_exchange) {
        answer(instance, CALL_ERROR, call, "not allowed in %s",
               is_exchange ? "Co-Simulation" : "Model Exchange");
        return false;
    }
    return true;
}

CALL(EnterContinuousTimeMode, (fmi3Instance c),
     has_interface(c, call, true) ? enter_state(c, call, EVENT_MODE, CONTINUOUS_TIME_MODE) : CALL_ERROR)
CALL(EnterStepMode, (fmi3Instance c),
     has_interface(c, call, false) ? enter_state(c, call, EVENT_MODE, STEP_MODE) : CALL_ERROR)

/* "If providesEvaluateDiscreteStates is true ..., else function is ignored" (FMI 3.0, section 2.3.5). */
CALL(EvaluateDiscreteStates, (fmi3Instance c), call_is_allowed(c, call, EVENT_MODE) ? CALL_OK : CALL_ERROR)

/* ---- Model Exchange ------------------------------------------------------------------------------------ */

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance component, fmi3Boolean no_set_state_before,
                                       fmi3Boolean *enter_event_mode, fmi3Boolean *terminate_simulation) {
    bool asks = false;
    const call_status status = complete_step(component, "fmi3CompletedIntegratorStep", enter_event_mode,
                                             terminate_simulation, &asks);
    if (status == CALL_OK) {
        *enter_event_mode = asks;
        *terminate_simulation = fmi3False;
    }
    return (fmi3Status)status;
}

CALL(SetTime, (fmi3Instance c, fmi3Float64 time),
     has_interface(c, call, true) ? set_time(c, call, time) : CALL_ERROR)
CALL(SetContinuousStates, (fmi3Instance c, const fmi3Float64 states[], size_t count),
     set_states(c, call, states, count))
CALL(GetContinuousStates, (fmi3Instance c, fmi3Float64 states[], size_t count),
     get_states(c, call, states, count))
CALL(GetContinuousStateDerivatives, (fmi3Instance c, fmi3Float64 derivatives[], size_t count),
     get_derivatives(c, call, derivatives, count))
CALL(GetEventIndicators, (fmi3Instance c, fmi3Float64 indicators[], size_t count),
     get_indicators(c, call, indicators, count))
CALL(GetNominalsOfContinuousStates, (fmi3Instance c, fmi3Float64 nominals[], size_t count),
     get_nominals(c, call, nominals, count))

/* The counts never change. */
static call_status get_count(const instance *instance, const char *call, size_t value, size_t *count) {
    if (!MAY_BEGIN(instance, call, ANYWHERE, 1, count)) {
        return CALL_ERROR;
    }
    *count = value;
    return CALL_OK;
}

CALL(GetNumberOfEventIndicators, (fmi3Instance c, size_t *count), get_count(c, call, UNIT_GUARD_COUNT, count))
CALL(GetNumberOfContinuousStates, (fmi3Instance c, size_t *count),
     get_count(c, call, UNIT_CONTINUOUS_COUNT, count))

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

/* A step with event mode and early return ends at the first event, at its exact time and before it is taken;
 * fmi3UpdateDiscreteStates takes it. Otherwise events are taken inside the step, and event mode serves to let
 * inputs jump. */
fmi3Status fmi3DoStep(fmi3Instance component, fmi3Float64 time, fmi3Float64 step,
                      fmi3Boolean no_set_state_before, fmi3Boolean *event_handling_needed,
                      fmi3Boolean *terminate_simulation, fmi3Boolean *early_return,
                      fmi3Float64 *last_successful_time) {
    static const char call[] = "fmi3DoStep";
    if (!MAY_BEGIN(component, call, STEP_MODE, 1, event_handling_needed, terminate_simulation, early_return,
                   last_successful_time)) {
        return fmi3Error;
    }
    fmi3_instance *own = component;
    const bool stop_at_event =
        own->instance.interface == CO_SIMULATION_WITH_EVENT_MODE && own->early_return_allowed;
    bool event = false;
    const call_status status = step_on(component, call, time, step, stop_at_event, &event);
    *event_handling_needed = event;
    *terminate_simulation = fmi3False;
    *last_successful_time = own->instance.fmu.time;
    *early_return = event && *last_successful_time < time + step;
    return (fmi3Status)status;
}

CALL(GetOutputDerivatives,
     (fmi3Instance c, REFERENCES, const fmi3Int32 orders[], fmi3Float64 values[], size_t value_count),
     call_is_allowed(c, call, ANYWHERE) && array_is_given(c, call, values, value_count, count)
         ? output_derivatives(c, call, references, count, (const int *)orders, values)
         : CALL_ERROR)

/* ---- functions that every unit has to export, for what this unit does not have ------------------------- */

/* This unit has none, so only empty requests succeed. */
static call_status accept_empty(const instance *instance, const char *call, bool is_asked, const char *what) {
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    return is_asked ? answer(instance, CALL_ERROR, call, "the unit has no %s", what) : CALL_OK;
}

#define NONE_OF(what) accept_empty(c, call, count > 0 || value_count > 0, what)
#define NO_VARIABLES(Type)                                                                                   \
    CALL(Get##Type, (fmi3Instance c, REFERENCES, fmi3##Type values[], size_t value_count),                   \
         NONE_OF("variable of type " #Type))                                                                 \
    CALL(Set##Type, (fmi3Instance c, REFERENCES, const fmi3##Type values[], size_t value_count),             \
         NONE_OF("variable of type " #Type))

NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(UInt32)
NO_VARIABLES(UInt64)
CALL(GetBinary, (fmi3Instance c, REFERENCES, size_t sizes[], fmi3Binary values[], size_t value_count),
     NONE_OF("variable of type Binary"))
CALL(SetBinary,
     (fmi3Instance c, REFERENCES, const size_t sizes[], const fmi3Binary values[], size_t value_count),
     NONE_OF("variable of type Binary"))

#define NO_CLOCKS(name, ...)                                                                                 \
    CALL(name, (fmi3Instance c, REFERENCES, __VA_ARGS__), accept_empty(c, call, count > 0, "clock"))

NO_CLOCKS(GetClock, fmi3Clock values[])
NO_CLOCKS(SetClock, const fmi3Clock values[])
NO_CLOCKS(GetIntervalDecimal, fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[])
NO_CLOCKS(GetIntervalFraction, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
          fmi3IntervalQualifier qualifiers[])
NO_CLOCKS(GetShiftDecimal, fmi3Float64 shifts[])
NO_CLOCKS(GetShiftFraction, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
NO_CLOCKS(SetIntervalDecimal, const fmi3Float64 intervals[])
NO_CLOCKS(SetIntervalFraction, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
NO_CLOCKS(SetShiftDecimal, const fmi3Float64 shifts[])
NO_CLOCKS(SetShiftFraction, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
CALL(ActivateModelPartition, (fmi3Instance c, fmi3ValueReference clock, fmi3Float64 time),
     accept_empty(c, call, true, "clock"))

CALL(EnterConfigurationMode, (fmi3Instance c), accept_empty(c, call, true, "structural parameter"))
CALL(ExitConfigurationMode, (fmi3Instance c), accept_empty(c, call, true, "structural parameter"))
CALL(GetNumberOfVariableDependencies, (fmi3Instance c, fmi3ValueReference reference, size_t *count),
     accept_empty(c, call, true, "dependencies per array element"))
CALL(GetVariableDependencies,
     (fmi3Instance c, fmi3ValueReference dependent, size_t dependent_elements[],
      fmi3ValueReference independents[], size_t independent_elements[], fmi3DependencyKind kinds[],
      size_t count),
     accept_empty(c, call, true, "dependencies per array element"))
