/* Serialized states with any changes and a right checksum: refused, leaving the instance as it was, or gone
 * on with, and then saved and restored again. */
#include "instance.h" /* before cmocka, which takes a name of it for a macro */

#include "fmi3_importer.h"
#include "forge.h"
#include "fuzz.h"

static void limit_steps(fmi3Instance instance) {
    ((struct instance *)instance)->step_limit = STEPS_OF_A_CALL;
}

/* Up to some time within two strides, or still before the start. */
static void run_into_it(random_source *source, fmi3Instance instance, fmi_kind kind) {
    step_answer step;
    for (int i = 0; i < 3; ++i) {
        const uint32_t reference = random_setting(source, true);
        const double value = tame_value(source, &fmu_variables[reference]);
        fmi3SetFloat64(instance, &reference, 1, &value, 1);
    }
    if (random_chance(source, 0.1)) {
        return;
    }
    begin(&fmi3, instance, kind);
    if (kind == EXCHANGE) {
        return;
    }
    do_step(instance, 0.0, random_uniform(source, 1e-3, 50.0), &step);
}

static void look(fmi3Instance instance) {
    for (uint32_t i = 0; i < fmu_variable_count; ++i) {
        double value = 0.0;
        if (fmu_variables[i].type == VARIABLE_REAL) {
            expect_numbers((int)fmi3GetFloat64(instance, &i, 1, &value, 1), &value, 1);
        }
    }
}

static void go_on(fmi3Instance instance, double length) {
    step_answer step = {false, false, false, 0.0};
    update_answer answer;
    const double time = ((struct instance *)instance)->run.time;
    limit_steps(instance);
    look(instance);
    do_step(instance, time, length, &step);
    fmi3EnterEventMode(instance);
    update(instance, &answer);
    look(instance);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
    random_source source = {0};
    random_draw_from(bytes, size);
    const fmi_kind kind = (fmi_kind)random_index(&source, KINDS);
    const double length = random_magnitude(&source, 1e-3, 30.0);
    fmi3Instance instance = new_of_kind(&fmi3, kind);
    run_into_it(&source, instance, kind);
    serialized state = serialize(&fmi3, instance);
    const serialized before = state;
    while (random_bytes_left() > 0) {
        forge(&source, state.bytes, state.size);
    }
    if (restore(&fmi3, instance, &state) == FMI_OK) {
        go_on(instance, length);
    } else {
        assert_state(&fmi3, instance, &before);
    }
    assert_int_equal(copy_state(&fmi3, instance, instance), FMI_OK);
    end_test();
    return 0;
}
