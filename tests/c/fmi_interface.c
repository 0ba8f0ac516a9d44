#include "fmi_interface.h"

#include "compare.h"
#include "guid.h"
#include "tdmf_slip/state.h"
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

void write_default_states(double states[CONTINUOUS_STATES]) {
    double state[TDMF_STATE_COUNT];
    tdmf_default_state(state);
    memset(states, 0, CONTINUOUS_STATES * sizeof *states);
    memcpy(states, state + TDMF_FOOT_X, TDMF_MECHANICAL_COUNT * sizeof *states);
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

double derivative_of(const fmi_interface *fmi, void *instance, uint32_t unknown, uint32_t known) {
    const double one = 1.0;
    double derivative = 0.0;
    assert_int_equal(fmi->directional_derivative(instance, &unknown, 1, &known, 1, &one, &derivative),
                     FMI_OK);
    return derivative;
}

void assert_same_states(const fmi_interface *fmi, void *instance, const fmi_interface *fmi_of_other,
                        void *other, double tolerance) {
    const uint32_t first = reference_of("foot.x");
    for (uint32_t i = first; i < first + TDMF_MECHANICAL_COUNT; ++i) {
        const char *name = fmu_variables[i].name;
        assert_close(value_of(fmi, instance, name), value_of(fmi_of_other, other, name), tolerance);
    }
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

void *begun(const fmi_interface *fmi, fmi_kind kind, const char *values) {
    void *instance = new_of_kind(fmi, kind);
    set_values(fmi, instance, values);
    begin(fmi, instance, kind);
    return instance;
}

update_answer take_event(const fmi_interface *fmi, void *instance, fmi_kind kind, const char *values) {
    update_answer answer;
    assert_int_equal(fmi->enter_event_mode(instance), FMI_OK);
    set_values(fmi, instance, values);
    assert_int_equal(fmi->update(instance, &answer), FMI_OK);
    assert_int_equal((kind == EXCHANGE ? fmi->enter_continuous_time_mode : fmi->enter_step_mode)(instance),
                     FMI_OK);
    return answer;
}

int run_to(const fmi_interface *fmi, void *instance, double end, double step) {
    const double start = value_of(fmi, instance, "time");
    step_answer answer = {.time = start};
    int events = 0;
    for (long i = 1; answer.time < end; i += answer.early ? 0 : 1) {
        const double grid = start + (double)i * step, until = grid < end - 1e-9 * step ? grid : end;
        assert_int_equal(fmi->do_step(instance, answer.time, until - answer.time, &answer), FMI_OK);
        assert_true(answer.early == (answer.time < until) && answer.event >= answer.early);
        if (answer.event) {
            take_event(fmi, instance, STEPS_WITH_EVENTS, "");
            ++events;
        }
    }
    return events;
}

void set_apex(const fmi_interface *fmi, void *instance, const tdmf_model *model, double friction,
              const double apex[TDMF_SECTION_COUNT]) {
    const tdmf_inputs inputs = tdmf_default_inputs();
    const uint32_t first = reference_of("foot.x"), clamp = reference_of("hip.swing_clamp");
    double state[TDMF_STATE_COUNT];
    tdmf_section_state((tdmf_system){model, &inputs}, apex, state);
    for (uint32_t i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        const uint32_t reference = first + i;
        assert_int_equal(fmi->set_reals(instance, &reference, 1, &state[TDMF_FOOT_X + i]), FMI_OK);
    }
    assert_int_equal(fmi->set_truth(instance, clamp, model->parameters.hip.swing_clamp), FMI_OK);
    assert_int_equal(set_value(fmi, instance, "ground.friction", friction), FMI_OK);
}

void step_by(const fmi_interface *fmi, void *instance, double step) {
    step_answer answer;
    assert_int_equal(fmi->do_step(instance, value_of(fmi, instance, "time"), step, &answer), FMI_OK);
}

/* ---- saved states ------------------------------------------------------------------------------------- */

serialized serialize(const fmi_interface *fmi, void *instance) {
    serialized state = {.size = 0};
    void *saved = NULL;
    assert_int_equal(fmi->save(instance, &saved), FMI_OK);
    assert_int_equal(fmi->measure(instance, saved, &state.size), FMI_OK);
    assert_true(state.size <= sizeof state.bytes);
    assert_int_equal(fmi->serialize(instance, saved, state.bytes, state.size), FMI_OK);
    assert_int_equal(fmi->free_saved(instance, &saved), FMI_OK);
    assert_null(saved);
    return state;
}

fmi_status restore(const fmi_interface *fmi, void *instance, const serialized *state) {
    void *saved = NULL;
    fmi_status status = fmi->deserialize(instance, state->bytes, state->size, &saved);
    if (status == FMI_OK) {
        status = fmi->restore(instance, saved);
    } else {
        assert_null(saved);
    }
    assert_int_equal(fmi->free_saved(instance, &saved), FMI_OK);
    return status;
}

fmi_status copy_state(const fmi_interface *fmi, void *from, void *to) {
    const serialized state = serialize(fmi, from);
    return restore(fmi, to, &state);
}

void assert_state(const fmi_interface *fmi, void *instance, const serialized *expected) {
    const serialized found = serialize(fmi, instance);
    assert_int_equal(found.size, expected->size);
    assert_memory_equal(found.bytes, expected->bytes, found.size);
}
