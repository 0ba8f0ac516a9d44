/* The importer's calls of an FMI 3.0 unit. */
#include "fmi3PlatformTypes.h"

#include "fmi3FunctionTypes.h"

#include "fmu_calls.h"

static fmi3InstantiateModelExchangeTYPE *instantiate_exchange;
static fmi3InstantiateCoSimulationTYPE *instantiate_stepper;
static fmi3FreeInstanceTYPE *free_instance;
static fmi3EnterInitializationModeTYPE *enter_initialization;
static fmi3ExitInitializationModeTYPE *exit_initialization;
static fmi3GetFloat64TYPE *get_float;
static fmi3GetInt32TYPE *get_int;
static fmi3GetStringTYPE *get_string;
static fmi3DoStepTYPE *do_step;
static fmi3SetTimeTYPE *set_time;
static fmi3GetContinuousStatesTYPE *get_states;
static fmi3SetContinuousStatesTYPE *set_states;
static fmi3GetContinuousStateDerivativesTYPE *get_derivatives;
static fmi3GetEventIndicatorsTYPE *get_indicators;
static fmi3EnterEventModeTYPE *enter_event_mode;
static fmi3UpdateDiscreteStatesTYPE *update_states;
static fmi3EnterContinuousTimeModeTYPE *enter_continuous_time_mode;

static void update(void *instance) {
    fmi3Boolean needed, stop, nominals, values, defined;
    fmi3Float64 time;
    do {
        check(update_states(instance, &needed, &stop, &nominals, &values, &defined, &time) == fmi3OK,
              "fmi3UpdateDiscreteStates");
    } while (needed);
    check(enter_continuous_time_mode(instance) == fmi3OK, "fmi3EnterContinuousTimeMode");
}

static void *make(bool model_exchange, const char *guid) {
    void *instance = model_exchange ? instantiate_exchange("runner", guid, "", false, false, NULL, NULL)
                                    : instantiate_stepper("runner", guid, "", false, false, false, false,
                                                          NULL, 0, NULL, NULL, NULL);
    check(instance != NULL, "fmi3Instantiate");
    check(enter_initialization(instance, false, 0.0, 0.0, false, 0.0) == fmi3OK,
          "fmi3EnterInitializationMode");
    check(exit_initialization(instance) == fmi3OK, "fmi3ExitInitializationMode");
    if (model_exchange) {
        update(instance);
    }
    return instance;
}

static double real(void *instance, unsigned reference) {
    double value = 0.0;
    check(get_float(instance, &reference, 1, &value, 1) == fmi3OK, "fmi3GetFloat64");
    return value;
}

static int integer(void *instance, unsigned reference) {
    fmi3Int32 value = 0;
    check(get_int(instance, &reference, 1, &value, 1) == fmi3OK, "fmi3GetInt32");
    return value;
}

static const char *text(void *instance, unsigned reference) {
    const char *value = "";
    check(get_string(instance, &reference, 1, &value, 1) == fmi3OK, "fmi3GetString");
    return value;
}

static void step(void *instance, double time, double length) {
    fmi3Boolean event, stop, early;
    fmi3Float64 last;
    check(do_step(instance, time, length, true, &event, &stop, &early, &last) == fmi3OK, "fmi3DoStep");
}

static void move_time(void *instance, double time) {
    check(set_time(instance, time) == fmi3OK, "fmi3SetTime");
}

static void read_states(void *instance, double states[STATES]) {
    check(get_states(instance, states, STATES) == fmi3OK, "fmi3GetContinuousStates");
}

static void write_states(void *instance, const double states[STATES]) {
    check(set_states(instance, states, STATES) == fmi3OK, "fmi3SetContinuousStates");
}

static void read_derivatives(void *instance, double derivatives[STATES]) {
    check(get_derivatives(instance, derivatives, STATES) == fmi3OK, "fmi3GetContinuousStateDerivatives");
}

static void read_indicators(void *instance, double indicators[INDICATORS]) {
    check(get_indicators(instance, indicators, INDICATORS) == fmi3OK, "fmi3GetEventIndicators");
}

static void take_events(void *instance) {
    check(enter_event_mode(instance) == fmi3OK, "fmi3EnterEventMode");
    update(instance);
}

fmu_calls calls_of_fmi3(void) {
    instantiate_exchange = (fmi3InstantiateModelExchangeTYPE *)find_function("fmi3InstantiateModelExchange");
    instantiate_stepper = (fmi3InstantiateCoSimulationTYPE *)find_function("fmi3InstantiateCoSimulation");
    free_instance = (fmi3FreeInstanceTYPE *)find_function("fmi3FreeInstance");
    enter_initialization = (fmi3EnterInitializationModeTYPE *)find_function("fmi3EnterInitializationMode");
    exit_initialization = (fmi3ExitInitializationModeTYPE *)find_function("fmi3ExitInitializationMode");
    get_float = (fmi3GetFloat64TYPE *)find_function("fmi3GetFloat64");
    get_int = (fmi3GetInt32TYPE *)find_function("fmi3GetInt32");
    get_string = (fmi3GetStringTYPE *)find_function("fmi3GetString");
    do_step = (fmi3DoStepTYPE *)find_function("fmi3DoStep");
    set_time = (fmi3SetTimeTYPE *)find_function("fmi3SetTime");
    get_states = (fmi3GetContinuousStatesTYPE *)find_function("fmi3GetContinuousStates");
    set_states = (fmi3SetContinuousStatesTYPE *)find_function("fmi3SetContinuousStates");
    get_derivatives =
        (fmi3GetContinuousStateDerivativesTYPE *)find_function("fmi3GetContinuousStateDerivatives");
    get_indicators = (fmi3GetEventIndicatorsTYPE *)find_function("fmi3GetEventIndicators");
    enter_event_mode = (fmi3EnterEventModeTYPE *)find_function("fmi3EnterEventMode");
    update_states = (fmi3UpdateDiscreteStatesTYPE *)find_function("fmi3UpdateDiscreteStates");
    enter_continuous_time_mode =
        (fmi3EnterContinuousTimeModeTYPE *)find_function("fmi3EnterContinuousTimeMode");
    const fmu_calls calls = {make,
                             free_instance,
                             real,
                             integer,
                             text,
                             step,
                             move_time,
                             read_states,
                             write_states,
                             read_derivatives,
                             read_indicators,
                             take_events};
    return calls;
}
