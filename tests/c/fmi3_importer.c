#include "fmi3_importer.h"

#include "compare.h"
#include "guid.h"

void importer_logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                     fmi3String message) {
    (void)environment;
    (void)status;
    record_message(category, message);
}

fmi3Instance new_stepper(bool event_mode, bool early_return) {
    clear_messages();
    fmi3Instance instance = fmi3InstantiateCoSimulation("runner", FMU_GUID, NULL, false, true, event_mode,
                                                        early_return, NULL, 0, NULL, importer_logger, NULL);
    assert_non_null(instance);
    free_after_test(instance, fmi3FreeInstance);
    assert_int_equal(fmi3SetDebugLogging(instance, false, 1, events_category), fmi3OK);
    return instance;
}

/* ---- calls with many answers -------------------------------------------------------------------------- */

fmi3Status update(fmi3Instance instance, update_answer *answer) {
    return fmi3UpdateDiscreteStates(instance, &answer->needs_update, &answer->terminate,
                                    &answer->nominals_changed, &answer->states_changed,
                                    &answer->next_time_defined, &answer->next_time);
}

fmi3Status do_step(fmi3Instance instance, double time, double step, step_answer *answer) {
    return fmi3DoStep(instance, time, step, true, &answer->event, &answer->terminate, &answer->early,
                      &answer->time);
}

/* ---- the table ---------------------------------------------------------------------------------------- */

static void *instantiate(fmi_kind kind, const char *name, const char *token, bool has_logger, bool logging) {
    const fmi3LogMessageCallback logger = has_logger ? importer_logger : NULL;
    const bool events = kind == STEPS_WITH_EVENTS;
    return kind == EXCHANGE ? fmi3InstantiateModelExchange(name, token, NULL, false, logging, NULL, logger)
                            : fmi3InstantiateCoSimulation(name, token, NULL, false, logging, events, events,
                                                          NULL, 0, NULL, logger, NULL);
}

ANSWERS(enter_initialization, (void *instance, const fmi_experiment *experiment),
        fmi3EnterInitializationMode(instance, experiment->has_tolerance, experiment->tolerance,
                                    experiment->start, experiment->has_stop, experiment->stop))
ANSWERS(enter_step_mode, (void *instance), fmi3EnterStepMode(instance))
ANSWERS(update_states, (void *instance, update_answer *answer), update(instance, answer))
ANSWERS(make_step, (void *instance, double time, double step, step_answer *answer),
        do_step(instance, time, step, answer))
ANSWERS(get_derivatives, (void *instance, double derivatives[], size_t count),
        fmi3GetContinuousStateDerivatives(instance, derivatives, count))
ANSWERS(get_reals, (void *instance, const uint32_t references[], size_t count, double values[]),
        fmi3GetFloat64(instance, references, count, values, count))
ANSWERS(set_reals, (void *instance, const uint32_t references[], size_t count, const double values[]),
        fmi3SetFloat64(instance, references, count, values, count))

static fmi_status read_integer(void *instance, uint32_t reference, int *value) {
    fmi3Int32 integer = 0;
    const fmi3Status status = fmi3GetInt32(instance, &reference, 1, &integer, 1);
    *value = integer;
    return (fmi_status)status;
}

static fmi_status get_item(void *instance, uint32_t reference, int *value) {
    fmi3Int64 item = 0;
    const fmi3Status status = fmi3GetInt64(instance, &reference, 1, &item, 1);
    *value = (int)item;
    return (fmi_status)status;
}

static fmi_status set_item(void *instance, uint32_t reference, int value) {
    const fmi3Int64 item = value;
    return (fmi_status)fmi3SetInt64(instance, &reference, 1, &item, 1);
}

ANSWERS(get_truth, (void *instance, uint32_t reference, bool *value),
        fmi3GetBoolean(instance, &reference, 1, value, 1))
ANSWERS(set_truth, (void *instance, uint32_t reference, bool value),
        fmi3SetBoolean(instance, &reference, 1, &value, 1))
ANSWERS(directional_derivative,
        (void *instance, const uint32_t unknowns[], size_t unknown_count, const uint32_t knowns[],
         size_t known_count, const double seeds[], double values[]),
        fmi3GetDirectionalDerivative(instance, unknowns, unknown_count, knowns, known_count, seeds,
                                     known_count, values, unknown_count))
ANSWERS(output_derivative, (void *instance, uint32_t reference, int order, double *value),
        fmi3GetOutputDerivatives(instance, &reference, 1, &order, value, 1))

#define FMI_KINDS             KINDS
#define FMI(name)             fmi3##name
#define FMI_STATE(call, rest) fmi3##call##FMUState##rest
#include "fmi_alike.h"
