/* The importer's calls of an FMI 2.0 unit. */
#include "fmi2FunctionTypes.h"

#define FMI(name)     fmi2##name
#define DERIVATIVES   GetDerivatives
#define OWN_CALLS(DO) DO(Instantiate) DO(SetupExperiment) DO(GetReal) DO(GetInteger) DO(NewDiscreteStates)
#include "alike.h"

static const fmi2CallbackFunctions callbacks; /* no logger */

static void update(void *instance) {
    fmi2EventInfo info;
    do {
        CHECK(NewDiscreteStates, instance, &info);
    } while (info.newDiscreteStatesNeeded);
    CHECK(EnterContinuousTimeMode, instance);
}

static void *make(bool model_exchange, const char *guid) {
    const fmi2Type type = model_exchange ? fmi2ModelExchange : fmi2CoSimulation;
    void *instance = fmi2Instantiate("runner", type, guid, "", &callbacks, fmi2False, fmi2False);
    check(instance != NULL, "fmi2Instantiate");
    CHECK(SetupExperiment, instance, fmi2False, 0.0, 0.0, fmi2False, 0.0);
    CHECK(EnterInitializationMode, instance);
    CHECK(ExitInitializationMode, instance);
    if (model_exchange) {
        update(instance);
    }
    return instance;
}

static double real(void *instance, unsigned reference) {
    double value = 0.0;
    CHECK(GetReal, instance, &reference, 1, &value);
    return value;
}

static int integer(void *instance, unsigned reference) {
    int value = 0;
    CHECK(GetInteger, instance, &reference, 1, &value);
    return value;
}

static const char *text(void *instance, unsigned reference) {
    const char *value = "";
    CHECK(GetString, instance, &reference, 1, &value);
    return value;
}

static void step(void *instance, double time, double length) {
    CHECK(DoStep, instance, time, length, fmi2True);
}

static void take_events(void *instance) {
    CHECK(EnterEventMode, instance);
    update(instance);
}

fmu_calls calls_of_fmi2(void) {
    find_functions();
    const fmu_calls calls = {make,
                             fmi2FreeInstance,
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
