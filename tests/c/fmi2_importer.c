#include "fmi2_importer.h"

#include "guid.h"
#include "variables.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

int message_count;
char last_message[1024];
char last_category[64];

void forget_messages(void) {
    message_count = 0;
    last_message[0] = '\0';
    last_category[0] = '\0';
}

static void logger(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status,
                   fmi2String category, fmi2String message, ...) {
    (void)environment;
    (void)instance;
    (void)status;
    va_list arguments;
    va_start(arguments, message);
    vsnprintf(last_message, sizeof last_message, message, arguments);
    va_end(arguments);
    snprintf(last_category, sizeof last_category, "%s", category);
    ++message_count;
}

const fmi2CallbackFunctions importer_callbacks = {.logger = logger};

static fmi2Component new_of_type(fmi2Type type) {
    forget_messages();
    fmi2Component component =
        fmi2Instantiate("runner", type, UNIT_GUID, NULL, &importer_callbacks, fmi2False, fmi2False);
    assert_non_null(component);
    return component;
}

fmi2Component new_instance(void) {
    return new_of_type(fmi2ModelExchange);
}

fmi2Component new_slave(void) {
    return new_of_type(fmi2CoSimulation);
}

fmi2ValueReference reference_of(const char *name) {
    for (size_t i = 0; i < unit_variable_count; ++i) {
        if (strcmp(unit_variables[i].name, name) == 0) {
            return (fmi2ValueReference)i;
        }
    }
    fail_msg("there is no variable %s", name);
    return 0;
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
