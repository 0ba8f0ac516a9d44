/* The calls of FMI 3.0: each is a row of its name, its kind, its arguments, and what it does in terms of
 * instance.h. Every variable is a scalar, so there are as many values as references. */
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

#define CALL(name, kind, given, does)                                                                        \
    fmi3Status fmi3##name given {                                                                            \
        return (fmi3Status)(call_begins(c, "fmi3" #name, kind) ? (does) : CALL_ERROR);                       \
    }
#define REFERENCES const fmi3ValueReference references[], size_t count

/* ---- life cycle of an instance ------------------------------------------------------------------------- */

const char *fmi3GetVersion(void) {
    return fmi3Version;
}

static void send(const instance *fmu, call_status status, const char *category, const char *text) {
    const fmi3_instance *own = (const fmi3_instance *)fmu;
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

void fmi3FreeInstance(fmi3Instance c) {
    instance_free(c);
}

CALL(SetDebugLogging, ALWAYS_ALLOWED,
     (fmi3Instance c, fmi3Boolean on, size_t count, const fmi3String names[]),
     set_logging(c, on, count, names))

static call_status enter_initialization(instance *fmu, bool tolerance_defined, double tolerance,
                                        double start_time, bool stop_time_defined, double stop_time) {
    const call_status status =
        set_experiment(fmu, tolerance_defined, tolerance, start_time, stop_time_defined, stop_time);
    return status == CALL_OK ? enter_state(fmu, INITIALIZATION_MODE) : status;
}

CALL(EnterInitializationMode, BEFORE_INITIALIZATION,
     (fmi3Instance c, fmi3Boolean has_tolerance, fmi3Float64 tolerance, fmi3Float64 start,
      fmi3Boolean has_stop, fmi3Float64 stop),
     enter_initialization(c, has_tolerance, tolerance, start, has_stop, stop))
CALL(ExitInitializationMode, IN_INITIALIZATION, (fmi3Instance c), exit_initialization(c))
CALL(Terminate, WHILE_RUNNING, (fmi3Instance c), enter_state(c, TERMINATED))
CALL(Reset, ALWAYS_ALLOWED, (fmi3Instance c), reset(c))

/* ---- variables and derivatives ------------------------------------------------------------------------- */

static bool counts_agree(const instance *fmu, size_t references, size_t values) {
    if (references != values) {
        answer(fmu, CALL_ERROR,
               "value references: %lu, values: %lu; both must be equal, because every variable is a scalar",
               (unsigned long)references, (unsigned long)values);
    }
    return references == values;
}

/* A call with arrays of references and values. */
#define CALL_WITH_VALUES(name, kind, given, does)                                                            \
    CALL(name, kind, given, counts_agree(c, count, value_count) ? (does) : CALL_ERROR)

/* Calls that get and set variables of a type of FMI 3.0. */
#define VARIABLES(Type, type, from_number, to_number)                                                        \
    static void write_##Type(void *values, size_t i, double number) {                                        \
        ((fmi3##Type *)values)[i] = (fmi3##Type)(from_number);                                               \
    }                                                                                                        \
    static double read_##Type(const void *values, size_t i) {                                                \
        const fmi3##Type value = ((const fmi3##Type *)values)[i];                                            \
        return (to_number);                                                                                  \
    }                                                                                                        \
    CALL_WITH_VALUES(Get##Type, ALWAYS_ALLOWED,                                                              \
                     (fmi3Instance c, REFERENCES, fmi3##Type values[], size_t value_count),                  \
                     get_numbers(c, type, references, count, values, write_##Type))                          \
    CALL_WITH_VALUES(Set##Type, SETS_VALUES,                                                                 \
                     (fmi3Instance c, REFERENCES, const fmi3##Type values[], size_t value_count),            \
                     set_numbers(c, type, references, count, values, read_##Type))

VARIABLES(Float64, VARIABLE_REAL, number, value)
VARIABLES(Int32, VARIABLE_INTEGER, number, value)
VARIABLES(Int64, VARIABLE_ENUMERATION, number, (double)value) /* as FMI 3.0 passes enumerations */
VARIABLES(Boolean, VARIABLE_BOOLEAN, number != 0.0, value ? 1.0 : 0.0)

CALL_WITH_VALUES(GetString, ALWAYS_ALLOWED,
                 (fmi3Instance c, REFERENCES, fmi3String values[], size_t value_count),
                 get_texts(c, references, count, values))
CALL_WITH_VALUES(SetString, SETS_VALUES,
                 (fmi3Instance c, REFERENCES, const fmi3String values[], size_t value_count),
                 set_texts(c, references, count, values))

#define DIRECTION                                                                                            \
    const fmi3ValueReference unknowns[], size_t unknown_count, const fmi3ValueReference knowns[],            \
        size_t known_count, const fmi3Float64 seeds[], size_t seed_count, fmi3Float64 values[],              \
        size_t value_count

CALL(GetDirectionalDerivative, ALWAYS_ALLOWED, (fmi3Instance c, DIRECTION),
     counts_agree(c, known_count, seed_count) && counts_agree(c, unknown_count, value_count)
         ? directional_derivative(c, false, unknowns, unknown_count, knowns, known_count, seeds, values)
         : CALL_ERROR)
CALL(GetAdjointDerivative, ALWAYS_ALLOWED, (fmi3Instance c, DIRECTION),
     counts_agree(c, unknown_count, seed_count) && counts_agree(c, known_count, value_count)
         ? directional_derivative(c, true, unknowns, unknown_count, knowns, known_count, seeds, values)
         : CALL_ERROR)

CALL(GetFMUState, ALWAYS_ALLOWED, (fmi3Instance c, fmi3FMUState *state), save_state(c, state))
CALL(SetFMUState, ALWAYS_ALLOWED, (fmi3Instance c, fmi3FMUState state), restore_state(c, state))
CALL(FreeFMUState, ALWAYS_ALLOWED, (fmi3Instance c, fmi3FMUState *state), free_state(state))
CALL(SerializedFMUStateSize, ALWAYS_ALLOWED, (fmi3Instance c, fmi3FMUState state, size_t *size),
     measure_state(c, state, size))
CALL(SerializeFMUState, ALWAYS_ALLOWED, (fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size),
     serialize_state(c, state, bytes, size))
CALL(DeserializeFMUState, ALWAYS_ALLOWED,
     (fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *state),
     deserialize_state(c, bytes, size, state))

/* ---- event mode ---------------------------------------------------------------------------------------- */

static call_status discrete_states(instance *fmu, fmi3Boolean *needs_update, fmi3Boolean *terminate,
                                   fmi3Boolean *nominals_changed, fmi3Boolean *states_changed,
                                   fmi3Boolean *next_time_defined, fmi3Float64 *next_time) {
    discrete_update update = {0};
    if (!ARE_GIVEN(fmu, 1, needs_update, terminate, nominals_changed, states_changed, next_time_defined,
                   next_time)) {
        return CALL_ERROR;
    }
    const call_status status = update_discrete_states(fmu, &update);
    *needs_update = *nominals_changed = fmi3False;
    *terminate = update.terminate;
    *states_changed = update.states_changed;
    *next_time_defined = update.next_time_defined;
    *next_time = update.next_time;
    return status;
}

CALL(EnterEventMode, ENTERS_EVENT_MODE, (fmi3Instance c), enter_event_mode(c))
CALL(UpdateDiscreteStates, IN_EVENT_MODE,
     (fmi3Instance c, fmi3Boolean *needs_update, fmi3Boolean *terminate, fmi3Boolean *nominals_changed,
      fmi3Boolean *states_changed, fmi3Boolean *next_time_defined, fmi3Float64 *next_time),
     discrete_states(c, needs_update, terminate, nominals_changed, states_changed, next_time_defined,
                     next_time))
CALL(EnterContinuousTimeMode, ENTERS_CONTINUOUS_TIME, (fmi3Instance c), enter_state(c, CONTINUOUS_TIME_MODE))
CALL(EnterStepMode, ENTERS_STEP_MODE, (fmi3Instance c), enter_state(c, STEP_MODE))

/* "If providesEvaluateDiscreteStates is true ..., else function is ignored" (FMI 3.0, section 2.3.5). */
CALL(EvaluateDiscreteStates, IN_EVENT_MODE, (fmi3Instance c), CALL_OK)

/* ---- Model Exchange ------------------------------------------------------------------------------------ */

static call_status completed_step(instance *fmu, fmi3Boolean *enter_event_mode, fmi3Boolean *terminate) {
    if (!ARE_GIVEN(fmu, 1, enter_event_mode, terminate)) {
        return CALL_ERROR;
    }
    *enter_event_mode = complete_step(fmu);
    *terminate = fmi3False;
    return CALL_OK;
}

CALL(CompletedIntegratorStep, INTEGRATES,
     (fmi3Instance c, fmi3Boolean no_set_state_before, fmi3Boolean *event_mode, fmi3Boolean *terminate),
     completed_step(c, event_mode, terminate))
CALL(SetTime, SETS_TIME, (fmi3Instance c, fmi3Float64 time), set_time(c, time))
CALL(SetContinuousStates, INTEGRATES, (fmi3Instance c, const fmi3Float64 states[], size_t count),
     set_states(c, states, count))
CALL(GetContinuousStates, EVALUATES, (fmi3Instance c, fmi3Float64 states[], size_t count),
     get_states(c, states, count))
CALL(GetContinuousStateDerivatives, EVALUATES, (fmi3Instance c, fmi3Float64 derivatives[], size_t count),
     get_derivatives(c, derivatives, count))
CALL(GetEventIndicators, EVALUATES, (fmi3Instance c, fmi3Float64 indicators[], size_t count),
     get_indicators(c, indicators, count))
CALL(GetNominalsOfContinuousStates, ASKS_FOR_NOMINALS, (fmi3Instance c, fmi3Float64 nominals[], size_t count),
     get_nominals(c, nominals, count))

/* The counts never change. */
static call_status get_count(const instance *fmu, size_t value, size_t *count) {
    if (!ARE_GIVEN(fmu, 1, count)) {
        return CALL_ERROR;
    }
    *count = value;
    return CALL_OK;
}

CALL(GetNumberOfEventIndicators, ALWAYS_ALLOWED, (fmi3Instance c, size_t *count),
     get_count(c, UNIT_GUARD_COUNT, count))
CALL(GetNumberOfContinuousStates, ALWAYS_ALLOWED, (fmi3Instance c, size_t *count),
     get_count(c, UNIT_CONTINUOUS_COUNT, count))

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

/* A step with event mode and early return ends at the first event, at its exact time and before it is taken;
 * fmi3UpdateDiscreteStates takes it. Otherwise events are taken inside the step, and event mode serves to let
 * inputs jump. */
static call_status do_step(fmi3_instance *own, double time, double step, fmi3Boolean *event_handling_needed,
                           fmi3Boolean *terminate, fmi3Boolean *early_return, fmi3Float64 *last_time) {
    instance *fmu = &own->instance;
    if (!ARE_GIVEN(fmu, 1, event_handling_needed, terminate, early_return, last_time)) {
        return CALL_ERROR;
    }
    const call_status status = make_step(
        fmu, time, step, fmu->run.interface == CO_SIMULATION_WITH_EVENT_MODE && own->early_return_allowed);
    *event_handling_needed = status == CALL_OK && fmu->run.event_is_pending;
    *terminate = fmi3False;
    *last_time = fmu->run.time;
    *early_return = *event_handling_needed && *last_time < time + step;
    return status;
}

CALL(DoStep, STEPS_FORWARD,
     (fmi3Instance c, fmi3Float64 time, fmi3Float64 step, fmi3Boolean no_set_state_before,
      fmi3Boolean *event_handling_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
      fmi3Float64 *last_successful_time),
     do_step(c, time, step, event_handling_needed, terminate, early_return, last_successful_time))
CALL_WITH_VALUES(GetOutputDerivatives, FOLLOWS_STEP,
                 (fmi3Instance c, REFERENCES, const fmi3Int32 orders[], fmi3Float64 values[],
                  size_t value_count),
                 output_derivatives(c, references, count, (const int *)orders, values))

/* ---- functions that every unit has to export, for what this unit does not have ------------------------- */

/* This unit has none, so only empty requests succeed. */
static call_status accept_empty(const instance *fmu, bool is_asked, const char *what) {
    return is_asked ? answer(fmu, CALL_ERROR, "the unit has no %s", what) : CALL_OK;
}

#define NONE_OF(what) accept_empty(c, count > 0 || value_count > 0, what)
#define NO_VARIABLES(Type)                                                                                   \
    CALL(Get##Type, ALWAYS_ALLOWED, (fmi3Instance c, REFERENCES, fmi3##Type values[], size_t value_count),   \
         NONE_OF("variable of type " #Type))                                                                 \
    CALL(Set##Type, ALWAYS_ALLOWED,                                                                          \
         (fmi3Instance c, REFERENCES, const fmi3##Type values[], size_t value_count),                        \
         NONE_OF("variable of type " #Type))

NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(UInt32)
NO_VARIABLES(UInt64)
CALL(GetBinary, ALWAYS_ALLOWED,
     (fmi3Instance c, REFERENCES, size_t sizes[], fmi3Binary values[], size_t value_count),
     NONE_OF("variable of type Binary"))
CALL(SetBinary, ALWAYS_ALLOWED,
     (fmi3Instance c, REFERENCES, const size_t sizes[], const fmi3Binary values[], size_t value_count),
     NONE_OF("variable of type Binary"))

#define NO_CLOCKS(name, ...)                                                                                 \
    CALL(name, ALWAYS_ALLOWED, (fmi3Instance c, REFERENCES, __VA_ARGS__), accept_empty(c, count > 0, "clock"))

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
CALL(ActivateModelPartition, ALWAYS_ALLOWED, (fmi3Instance c, fmi3ValueReference clock, fmi3Float64 time),
     accept_empty(c, true, "clock"))

CALL(EnterConfigurationMode, ALWAYS_ALLOWED, (fmi3Instance c), accept_empty(c, true, "structural parameter"))
CALL(ExitConfigurationMode, ALWAYS_ALLOWED, (fmi3Instance c), accept_empty(c, true, "structural parameter"))
CALL(GetNumberOfVariableDependencies, ALWAYS_ALLOWED,
     (fmi3Instance c, fmi3ValueReference reference, size_t *count),
     accept_empty(c, true, "dependencies per array element"))
CALL(GetVariableDependencies, ALWAYS_ALLOWED,
     (fmi3Instance c, fmi3ValueReference dependent, size_t dependent_elements[],
      fmi3ValueReference independents[], size_t independent_elements[], fmi3DependencyKind kinds[],
      size_t count),
     accept_empty(c, true, "dependencies per array element"))
