#include "fmi_interface.h"

#include "compare.h"
#include "guid.h"
#include "variables.h"

#include <stdio.h>
#include <string.h>

void *new_of_kind(const fmi_interface *fmi, fmi_kind kind) {
    clear_messages();
    void *instance = fmi->instantiate(kind, "runner", FMU_GUID, true, true);
    assert_non_null(instance);
    free_after_test(instance, fmi->free);
    assert_int_equal(fmi->set_logging(instance, false, 1, events_category), FMI_OK);
    return instance;
}

/* ---- variables ---------------------------------------------------------------------------------------- */

fmi_status set_value(const fmi_interface *fmi, void *instance, const char *name, double value) {
    const uint32_t reference = reference_of(name);
    return fmi->set_reals(instance, &reference, 1, &value);
}

void set_values(const fmi_interface *fmi, void *instance, const char *values) {
    char name[64];
    double value;
    for (int length = 0; sscanf(values, " %63[^=]=%lf%n", name, &value, &length) == 2; values += length) {
        const uint32_t reference = reference_of(name);
        const fmi_status status = fmu_variables[reference].type == VARIABLE_BOOLEAN
                                      ? fmi->set_truth(instance, reference, value != 0.0)
                                      : fmi->set_reals(instance, &reference, 1, &value);
        assert_int_equal(status, FMI_OK);
    }
    assert_int_equal(strlen(values), 0);
}

double value_of(const fmi_interface *fmi, void *instance, const char *name) {
    const uint32_t reference = reference_of(name);
    double value = 0.0;
    assert_int_equal(fmi->get_reals(instance, &reference, 1, &value), FMI_OK);
    return value;
}

int integer_of(const fmi_interface *fmi, void *instance, const char *name) {
    const uint32_t reference = reference_of(name);
    const bool is_item = fmu_variables[reference].type == VARIABLE_ENUMERATION;
    int value = 0;
    assert_int_equal((is_item ? fmi->get_item : fmi->get_integer)(instance, reference, &value), FMI_OK);
    return value;
}

bool truth_of(const fmi_interface *fmi, void *instance, const char *name) {
    bool value = false;
    assert_int_equal(fmi->get_truth(instance, reference_of(name), &value), FMI_OK);
    return value;
}

/* ---- running ------------------------------------------------------------------------------------------ */

void initialize_unit_at(const fmi_interface *fmi, void *instance, double start) {
    const fmi_experiment experiment = {.start = start};
    assert_int_equal(fmi->enter_initialization(instance, &experiment), FMI_OK);
    assert_int_equal(fmi->exit_initialization(instance), FMI_OK);
}

void initialize_unit(const fmi_interface *fmi, void *instance) {
    initialize_unit_at(fmi, instance, 0.0);
}

void update_and_go_on(const fmi_interface *fmi, void *instance, fmi_kind kind) {
    update_answer answer;
    assert_int_equal(fmi->update(instance, &answer), FMI_OK);
    assert_int_equal((kind == EXCHANGE ? fmi->enter_continuous_time_mode : fmi->enter_step_mode)(instance),
                     FMI_OK);
}

void begin(const fmi_interface *fmi, void *instance, fmi_kind kind) {
    initialize_unit(fmi, instance);
    if (kind != STEPS) {
        update_and_go_on(fmi, instance, kind);
    }
}

void step_by(const fmi_interface *fmi, void *instance, double step) {
    step_answer answer;
    assert_int_equal(fmi->do_step(instance, value_of(fmi, instance, "time"), step, &answer), FMI_OK);
}

/* ---- saved states ------------------------------------------------------------------------------------- */

size_t save_bytes(const fmi_interface *fmi, void *instance, unsigned char bytes[SERIALIZED_BYTES]) {
    void *saved = NULL;
    size_t size = 0;
    assert_int_equal(fmi->save(instance, &saved), FMI_OK);
    assert_int_equal(fmi->measure(instance, saved, &size), FMI_OK);
    assert_true(size <= SERIALIZED_BYTES);
    assert_int_equal(fmi->serialize(instance, saved, bytes, size), FMI_OK);
    assert_int_equal(fmi->free_saved(instance, &saved), FMI_OK);
    assert_null(saved);
    return size;
}

fmi_status restore_bytes(const fmi_interface *fmi, void *instance,
                         const unsigned char bytes[SERIALIZED_BYTES], size_t size) {
    void *saved = NULL;
    fmi_status status = fmi->deserialize(instance, bytes, size, &saved);
    if (status == FMI_OK) {
        status = fmi->restore(instance, saved);
    } else {
        assert_null(saved);
    }
    assert_int_equal(fmi->free_saved(instance, &saved), FMI_OK);
    return status;
}
