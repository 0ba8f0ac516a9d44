#include "fmi3_importer.h"

#include "compare.h"
#include "guid.h"

void importer_logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                     fmi3String message) {
    (void)environment;
    (void)status;
    record_message(category, message);
}

static fmi3Instance without_events(fmi3Instance instance) {
    assert_non_null(instance);
    assert_int_equal(fmi3SetDebugLogging(instance, false, 1, events_category), fmi3OK);
    return instance;
}

fmi3Instance new_exchange(void) {
    clear_messages();
    return without_events(
        fmi3InstantiateModelExchange("runner", FMU_GUID, NULL, false, true, NULL, importer_logger));
}

fmi3Instance new_stepper(bool event_mode, bool early_return) {
    clear_messages();
    return without_events(fmi3InstantiateCoSimulation("runner", FMU_GUID, NULL, false, true, event_mode,
                                                      early_return, NULL, 0, NULL, importer_logger, NULL));
}

fmi3Status set_float(fmi3Instance instance, const char *name, double value) {
    const fmi3ValueReference reference = reference_of(name);
    return fmi3SetFloat64(instance, &reference, 1, &value, 1);
}

double get_float(fmi3Instance instance, const char *name) {
    const fmi3ValueReference reference = reference_of(name);
    double value = 0.0;
    assert_int_equal(fmi3GetFloat64(instance, &reference, 1, &value, 1), fmi3OK);
    return value;
}

int get_int(fmi3Instance instance, const char *name) {
    const fmi3ValueReference reference = reference_of(name);
    fmi3Int32 value = 0;
    assert_int_equal(fmi3GetInt32(instance, &reference, 1, &value, 1), fmi3OK);
    return value;
}

int get_enumeration(fmi3Instance instance, const char *name) {
    const fmi3ValueReference reference = reference_of(name);
    fmi3Int64 value = 0;
    assert_int_equal(fmi3GetInt64(instance, &reference, 1, &value, 1), fmi3OK);
    return (int)value;
}

void initialize3(fmi3Instance instance) {
    assert_int_equal(fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0), fmi3OK);
    assert_int_equal(fmi3ExitInitializationMode(instance), fmi3OK);
}

fmi3Status update(fmi3Instance instance, update_answer *answer) {
    return fmi3UpdateDiscreteStates(instance, &answer->needs_update, &answer->terminate,
                                    &answer->nominals_changed, &answer->states_changed,
                                    &answer->next_time_defined, &answer->next_time);
}

fmi3Status do_step(fmi3Instance instance, double time, double step, step_answer *answer) {
    return fmi3DoStep(instance, time, step, true, &answer->event, &answer->terminate, &answer->early,
                      &answer->time);
}

size_t serialize3(fmi3Instance instance, fmi3Byte bytes[SERIALIZED_BYTES]) {
    fmi3FMUState saved = NULL;
    size_t size = 0;
    assert_int_equal(fmi3GetFMUState(instance, &saved), fmi3OK);
    assert_int_equal(fmi3SerializedFMUStateSize(instance, saved, &size), fmi3OK);
    assert_true(size <= SERIALIZED_BYTES);
    assert_int_equal(fmi3SerializeFMUState(instance, saved, bytes, size), fmi3OK);
    assert_int_equal(fmi3FreeFMUState(instance, &saved), fmi3OK);
    assert_null(saved);
    return size;
}
