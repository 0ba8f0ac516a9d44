/* The importer's calls of an FMI 2.0 unit. */
#include "fmi2FunctionTypes.h"

#include "fmu_calls.h"

static const fmi2CallbackFunctions callbacks; /* no logger */

static fmi2InstantiateTYPE *instantiate;
static fmi2FreeInstanceTYPE *free_instance;
static fmi2SetupExperimentTYPE *setup_experiment;
static fmi2EnterInitializationModeTYPE *enter_initialization;
static fmi2ExitInitializationModeTYPE *exit_initialization;
static fmi2GetRealTYPE *get_real;
static fmi2GetIntegerTYPE *get_integer;
static fmi2GetStringTYPE *get_string;
static fmi2DoStepTYPE *do_step;
static fmi2SetTimeTYPE *set_time;
static fmi2GetContinuousStatesTYPE *get_states;
static fmi2SetContinuousStatesTYPE *set_states;
static fmi2GetDerivativesTYPE *get_derivatives;
static fmi2GetEventIndicatorsTYPE *get_indicators;
static fmi2EnterEventModeTYPE *enter_event_mode;
static fmi2NewDiscreteStatesTYPE *new_discrete_states;
static fmi2EnterContinuousTimeModeTYPE *enter_continuous_time_mode;

static void update(void *instance) {
    fmi2EventInfo info;
    do {
        check(new_discrete_states(instance, &info) == fmi2OK, "fmi2NewDiscreteStates");
    } while (info.newDiscreteStatesNeeded);
    check(enter_continuous_time_mode(instance) == fmi2OK, "fmi2EnterContinuousTimeMode");
}

static void *make(bool model_exchange, const char *guid) {
    const fmi2Type type = model_exchange ? fmi2ModelExchange : fmi2CoSimulation;
    void *instance = instantiate("runner", type, guid, "", &callbacks, fmi2False, fmi2False);
    check(instance != NULL, "fmi2Instantiate");
    check(setup_experiment(instance, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK, "fmi2SetupExperiment");
    check(enter_initialization(instance) == fmi2OK, "fmi2EnterInitializationMode");
    check(exit_initialization(instance) == fmi2OK, "fmi2ExitInitializationMode");
    if (model_exchange) {
        update(instance);
    }
    return instance;
}

static double real(void *instance, unsigned reference) {
    double value = 0.0;
    check(get_real(instance, &reference, 1, &value) == fmi2OK, "fmi2GetReal");
    return value;
}

static int integer(void *instance, unsigned reference) {
    int value = 0;
    check(get_integer(instance, &reference, 1, &value) == fmi2OK, "fmi2GetInteger");
    return value;
}

static const char *text(void *instance, unsigned reference) {
    const char *value = "";
    check(get_string(instance, &reference, 1, &value) == fmi2OK, "fmi2GetString");
    return value;
}

static void step(void *instance, double time, double length) {
    check(do_step(instance, time, length, fmi2True) == fmi2OK, "fmi2DoStep");
}

static void move_time(void *instance, double time) {
    check(set_time(instance, time) == fmi2OK, "fmi2SetTime");
}

static void read_states(void *instance, double states[STATES]) {
    check(get_states(instance, states, STATES) == fmi2OK, "fmi2GetContinuousStates");
}

static void write_states(void *instance, const double states[STATES]) {
    check(set_states(instance, states, STATES) == fmi2OK, "fmi2SetContinuousStates");
}

static void read_derivatives(void *instance, double derivatives[STATES]) {
    check(get_derivatives(instance, derivatives, STATES) == fmi2OK, "fmi2GetDerivatives");
}

static void read_indicators(void *instance, double indicators[INDICATORS]) {
    check(get_indicators(instance, indicators, INDICATORS) == fmi2OK, "fmi2GetEventIndicators");
}

static void take_events(void *instance) {
    check(enter_event_mode(instance) == fmi2OK, "fmi2EnterEventMode");
    update(instance);
}

fmu_calls calls_of_fmi2(void) {
    instantiate = (fmi2InstantiateTYPE *)find_function("fmi2Instantiate");
    free_instance = (fmi2FreeInstanceTYPE *)find_function("fmi2FreeInstance");
    setup_experiment = (fmi2SetupExperimentTYPE *)find_function("fmi2SetupExperiment");
    enter_initialization = (fmi2EnterInitializationModeTYPE *)find_function("fmi2EnterInitializationMode");
    exit_initialization = (fmi2ExitInitializationModeTYPE *)find_function("fmi2ExitInitializationMode");
    get_real = (fmi2GetRealTYPE *)find_function("fmi2GetReal");
    get_integer = (fmi2GetIntegerTYPE *)find_function("fmi2GetInteger");
    get_string = (fmi2GetStringTYPE *)find_function("fmi2GetString");
    do_step = (fmi2DoStepTYPE *)find_function("fmi2DoStep");
    set_time = (fmi2SetTimeTYPE *)find_function("fmi2SetTime");
    get_states = (fmi2GetContinuousStatesTYPE *)find_function("fmi2GetContinuousStates");
    set_states = (fmi2SetContinuousStatesTYPE *)find_function("fmi2SetContinuousStates");
    get_derivatives = (fmi2GetDerivativesTYPE *)find_function("fmi2GetDerivatives");
    get_indicators = (fmi2GetEventIndicatorsTYPE *)find_function("fmi2GetEventIndicators");
    enter_event_mode = (fmi2EnterEventModeTYPE *)find_function("fmi2EnterEventMode");
    new_discrete_states = (fmi2NewDiscreteStatesTYPE *)find_function("fmi2NewDiscreteStates");
    enter_continuous_time_mode =
        (fmi2EnterContinuousTimeModeTYPE *)find_function("fmi2EnterContinuousTimeMode");
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
