/* The importer's calls that are alike in FMI 2.0 and 3.0, and how a version's functions are found in a
 * library. The file of each version includes this once. It defines FMI(Name) as what its version calls so,
 * OWN_CALLS(DO) as a list of those of its functions that are not in ALIKE_CALLS, and DERIVATIVES as its name
 * of the states' derivatives. */
#include "fmu_calls.h"

#define ALIKE_CALLS(DO)                                                                                      \
    DO(FreeInstance)                                                                                         \
    DO(EnterInitializationMode)                                                                              \
    DO(ExitInitializationMode)                                                                               \
    DO(GetString)                                                                                            \
    DO(DoStep)                                                                                               \
    DO(SetTime)                                                                                              \
    DO(GetContinuousStates)                                                                                  \
    DO(SetContinuousStates)                                                                                  \
    DO(DERIVATIVES)                                                                                          \
    DO(GetEventIndicators)                                                                                   \
    DO(EnterEventMode)                                                                                       \
    DO(EnterContinuousTimeMode)

#define TEXT_OF(name)    #name
#define TEXT(name)       TEXT_OF(name)
#define TYPE_OF(name)    FMI(name##TYPE)
#define TYPE(name)       TYPE_OF(name)
#define DECLARE(name)    static TYPE(name) * FMI(name);
#define FIND(name)       FMI(name) = (TYPE(name) *)find_function(TEXT(FMI(name)));
#define CHECK(name, ...) check(FMI(name)(__VA_ARGS__) == FMI(OK), TEXT(FMI(name)))

ALIKE_CALLS(DECLARE)
OWN_CALLS(DECLARE)

static void find_functions(void) {
    ALIKE_CALLS(FIND)
    OWN_CALLS(FIND)
}

static void move_time(void *instance, double time) {
    CHECK(SetTime, instance, time);
}

static void read_states(void *instance, double states[STATES]) {
    CHECK(GetContinuousStates, instance, states, STATES);
}

static void write_states(void *instance, const double states[STATES]) {
    CHECK(SetContinuousStates, instance, states, STATES);
}

static void read_derivatives(void *instance, double derivatives[STATES]) {
    CHECK(DERIVATIVES, instance, derivatives, STATES);
}

static void read_indicators(void *instance, double indicators[INDICATORS]) {
    CHECK(GetEventIndicators, instance, indicators, INDICATORS);
}
