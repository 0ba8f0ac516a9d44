#include "fmi2_importer.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

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

/* ---- the table ---------------------------------------------------------------------------------------- */

static void *instantiate(fmi_kind kind, const char *name, const char *token, bool has_logger, bool logging) {
    const fmi2Type type = kind == EXCHANGE ? fmi2ModelExchange : fmi2CoSimulation;
    return fmi2Instantiate(name, type, token, NULL, has_logger ? &importer_callbacks : NULL, fmi2False,
                           logging);
}

static fmi_status enter_initialization(void *instance, const fmi_experiment *experiment) {
    const fmi2Status status = fmi2SetupExperiment(instance, experiment->has_tolerance, experiment->tolerance,
                                                  experiment->start, experiment->has_stop, experiment->stop);
    return (fmi_status)(status == fmi2OK ? fmi2EnterInitializationMode(instance) : status);
}

static fmi_status update_states(void *instance, update_answer *answer) {
    fmi2EventInfo info = {0};
    const fmi2Status status = fmi2NewDiscreteStates(instance, &info);
    *answer = (update_answer){.needs_update = info.newDiscreteStatesNeeded,
                              .terminate = info.terminateSimulation,
                              .nominals_changed = info.nominalsOfContinuousStatesChanged,
                              .states_changed = info.valuesOfContinuousStatesChanged,
                              .next_time_defined = info.nextEventTimeDefined,
                              .next_time = info.nextEventTime};
    return (fmi_status)status;
}

static fmi_status make_step(void *instance, double time, double step, step_answer *answer) {
    const fmi2Status status = fmi2DoStep(instance, time, step, fmi2True);
    *answer = (step_answer){.time = status == fmi2OK ? time + step : time};
    return (fmi_status)status;
}

static fmi_status enter_step_mode(void *instance) {
    (void)instance;
    fail_msg("FMI 2.0 has no step mode");
    return FMI_ERROR;
}

ANSWERS(get_derivatives, (void *instance, double derivatives[], size_t count),
        fmi2GetDerivatives(instance, derivatives, count))
ANSWERS(get_reals, (void *instance, const uint32_t references[], size_t count, double values[]),
        fmi2GetReal(instance, references, count, values))
ANSWERS(set_reals, (void *instance, const uint32_t references[], size_t count, const double values[]),
        fmi2SetReal(instance, references, count, values))
ANSWERS(read_integer, (void *instance, uint32_t reference, int *value),
        fmi2GetInteger(instance, &reference, 1, value))
ANSWERS(set_item, (void *instance, uint32_t reference, int value),
        fmi2SetInteger(instance, &reference, 1, &value))

static fmi_status get_truth(void *instance, uint32_t reference, bool *value) {
    fmi2Boolean truth = fmi2False;
    const fmi2Status status = fmi2GetBoolean(instance, &reference, 1, &truth);
    *value = truth != fmi2False;
    return (fmi_status)status;
}

static fmi_status set_truth(void *instance, uint32_t reference, bool value) {
    const fmi2Boolean truth = value;
    return (fmi_status)fmi2SetBoolean(instance, &reference, 1, &truth);
}

ANSWERS(directional_derivative,
        (void *instance, const uint32_t unknowns[], size_t unknown_count, const uint32_t knowns[],
         size_t known_count, const double seeds[], double values[]),
        fmi2GetDirectionalDerivative(instance, unknowns, unknown_count, knowns, known_count, seeds, values))
ANSWERS(output_derivative, (void *instance, uint32_t reference, int order, double *value),
        fmi2GetRealOutputDerivatives(instance, &reference, 1, &order, value))

static fmi_status get_item(void *instance, uint32_t reference, int *value) {
    return read_integer(instance, reference, value);
}

#define FMI_KINDS               STEPS_WITH_EVENTS
#define FMI(name)               fmi2##name
#define FMI_STATE(call, rest)   fmi2##call##FMUstate##rest
#define fmi2DeserializeFMUstate fmi2DeSerializeFMUstate
#include "fmi_alike.h"
