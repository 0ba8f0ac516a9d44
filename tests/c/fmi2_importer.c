#include "fmi2_importer.h"

#include "guid.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static void logger(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status,
                   fmi2String category, fmi2String message, ...) {
    (void)environment;
    (void)instance;
    (void)status;
    char text[1024];
    va_list arguments;
    va_start(arguments, message);
    vsnprintf(text, sizeof text, message, arguments);
    va_end(arguments);
    record_message(category, text);
}

const fmi2CallbackFunctions importer_callbacks = {.logger = logger};

static fmi2Component new_of_type(fmi2Type type) {
    clear_messages();
    fmi2Component component =
        fmi2Instantiate("runner", type, FMU_GUID, NULL, &importer_callbacks, fmi2False, fmi2True);
    assert_non_null(component);
    assert_int_equal(fmi2SetDebugLogging(component, fmi2False, 1, events_category), fmi2OK);
    return component;
}

fmi2Component new_instance(void) {
    return new_of_type(fmi2ModelExchange);
}

fmi2Component new_slave(void) {
    return new_of_type(fmi2CoSimulation);
}

fmi2Status set_real(fmi2Component component, const char *name, double value) {
    const fmi2ValueReference reference = reference_of(name);
    return fmi2SetReal(component, &reference, 1, &value);
}

double get_real(fmi2Component component, const char *name) {
    const fmi2ValueReference reference = reference_of(name);
    double value = 0.0;
    assert_int_equal(fmi2GetReal(component, &reference, 1, &value), fmi2OK);
    return value;
}

int get_integer(fmi2Component component, const char *name) {
    const fmi2ValueReference reference = reference_of(name);
    int value = 0;
    assert_int_equal(fmi2GetInteger(component, &reference, 1, &value), fmi2OK);
    return value;
}

void initialize(fmi2Component component) {
    assert_int_equal(fmi2SetupExperiment(component, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
}

void start_running(fmi2Component component) {
    fmi2EventInfo info;
    initialize(component);
    assert_int_equal(fmi2NewDiscreteStates(component, &info), fmi2OK);
    assert_int_equal(fmi2EnterContinuousTimeMode(component), fmi2OK);
}

size_t serialize2(fmi2Component component, fmi2Byte bytes[SERIALIZED_BYTES]) {
    fmi2FMUstate saved = NULL;
    size_t size = 0;
    assert_int_equal(fmi2GetFMUstate(component, &saved), fmi2OK);
    assert_int_equal(fmi2SerializedFMUstateSize(component, saved, &size), fmi2OK);
    assert_true(size <= SERIALIZED_BYTES);
    assert_int_equal(fmi2SerializeFMUstate(component, saved, bytes, size), fmi2OK);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    assert_null(saved);
    return size;
}
