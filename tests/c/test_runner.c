/* A runner of an ensemble on its way from lane to lane. */
#include "compare.h"
#include "members.h"
#include "reference_gaits.h"
#include "runner.h"

#include <string.h>

/* Steps are limited by stride and by time scale, however often the mode changes in them. */
static void limits_of_steps_go_along(void **state) {
    tdmf_model model;
    tdmf_runner runner;
    tdmf_ensemble_end end;
    double fields[MEMBER_FIELDS];
    member_progress now;
    (void)state;
    const tdmf_parameters parameters = tdmf_default_parameters();
    assert_null(tdmf_model_create(&model, &parameters).variable);
    const tdmf_ensemble_case its_case = {&model, tdmf_default_inputs(), {.max_strides = 1}};
    double apex[1][TDMF_SECTION_COUNT];
    memcpy(apex, &reference_gaits[DEFAULT_GAIT].apex, sizeof apex);
    const tdmf_ensemble ensemble = {
        .cases = &its_case, .case_count = 1, .starts = (const double(*)[TDMF_SECTION_COUNT])apex, .count = 1};
    assert_true(tdmf_runner_begin(&runner, &ensemble, 0, &end));
    assert_int_equal(tdmf_runner_load(&runner, fields), FLYING_FIELDS);
    memcpy(&now, fields, sizeof now);
    assert_true(now.steps.left > 1e5 && now.steps.span == 0.0 && now.steps.in_span == 0.0);
    const step_count made = {77.0, 0.25, 3.0};
    now.steps = made;
    memcpy(fields, &now, sizeof now);
    assert_true(tdmf_runner_take_event(&runner, fields, TDMF_GUARD_COUNT));
    assert_int_equal(tdmf_runner_load(&runner, fields), FLYING_FIELDS);
    memcpy(&now, fields, sizeof now);
    assert_memory_equal(&now.steps, &made, sizeof made);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(limits_of_steps_go_along)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
