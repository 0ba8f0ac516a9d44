/* The importer's calls of an FMI 3.0 unit. */
#include "fmi3PlatformTypes.h"

#include "fmi3FunctionTypes.h"

#define FMI(name)   fmi3##name
#define DERIVATIVES GetContinuousStateDerivatives
#define OWN_CALLS(DO)                                                                                        \
    DO(InstantiateModelExchange)                                                                             \
    DO(InstantiateCoSimulation)                                                                              \
    DO(GetFloat64)                                                                                           \
    DO(GetInt32)                                                                                             \
    DO(UpdateDiscreteStates)
#include "alike.h"

static void update(void *instance) {
    fmi3Boolean needed, stop, nominals, values, defined;
    fmi3Float64 time;
    do {
        CHECK(UpdateDiscreteStates, instance, &needed, &stop, &nominals, &values, &defined, &time);
    } while (needed);
    CHECK(EnterContinuousTimeMode, instance);
}

static void *make(bool model_exchange, const char *guid) {
    void *instance = model_exchange
                         ? fmi3InstantiateModelExchange("runner", guid, "", false, false, NULL, NULL)
                         : fmi3InstantiateCoSimulation("runner", guid, "", false, false, false, false, NULL,
                                                       0, NULL, NULL, NULL);
    check(instance != NULL, "fmi3Instantiate");
    CHECK(EnterInitializationMode, instance, false, 0.0, 0.0, false, 0.0);
    CHECK(ExitInitializationMode, instance);
    if (model_exchange) {
        update(instance);
    }
    return instance;
}

static double real(void *instance, unsigned reference) {
    double value = 0.0;
    CHECK(GetFloat64, instance, &reference, 1, &value, 1);
    return value;
}

static int integer(void *instance, unsigned reference) {
    fmi3Int32 value = 0;
    CHECK(GetInt32, instance, &reference, 1, &value, 1);
    return value;
}

static const char *text(void *instance, unsigned reference) {
    const char *value = "";
    CHECK(GetString, instance, &reference, 1, &value, 1);
    return value;
}

static void step(void *instance, double time, double length) {
    fmi3Boolean event, stop, early;
    fmi3Float64 last;
    CHECK(DoStep, instance, time, length, true, &event, &stop, &early, &last);
}

static void take_events(void *instance) {
    CHECK(EnterEventMode, instance);
    update(instance);
}

fmu_calls calls_of_fmi3(void) {
    find_functions();
    const fmu_calls calls = {make,
                             fmi3FreeInstance,
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
