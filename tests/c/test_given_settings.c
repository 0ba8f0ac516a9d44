/* Which row of the settings that are given a stride is made with, and where a run goes on: what an array has
 * beside a row is another runner's, so a wrong row is another stride. */
#include "compare.h"
#include "reference_gaits.h"
#include "runner.h"

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/ensemble.h"

#include <math.h>
#include <string.h>

enum { RUNNERS = 3, ROWS = 2, STRIDES = 6, FALLS = RUNNERS - 1 };

/* No two rows are alike. */
typedef struct {
    tdmf_model model;
    int setting;
    double values[RUNNERS][ROWS];
    tdmf_given_settings given;
    tdmf_ensemble_case its_case;
    double starts[RUNNERS][TDMF_SECTION_COUNT];
    tdmf_ensemble_checkpoint checkpoints[RUNNERS];
    tdmf_ensemble_stride strides[RUNNERS][STRIDES];
    tdmf_ensemble ensemble;
    tdmf_ensemble_end ends[RUNNERS];
} crowd;

static void gather(crowd *crowd, int first) {
    static const double values[RUNNERS][ROWS] = {{0.70, 0.69}, {0.71, 0.72}, {0.73, 0.695}};
    const tdmf_parameters parameters = tdmf_default_parameters();
    memset(crowd, 0, sizeof *crowd);
    assert_null(tdmf_model_create(&crowd->model, &parameters).variable);
    crowd->setting = tdmf_setting_of("hip.touchdown_angle");
    memcpy(crowd->values, values, sizeof values);
    const tdmf_given_settings given = {1, &crowd->setting, first, ROWS, &crowd->values[0][0]};
    crowd->given = given;
    const tdmf_ensemble_case its_case = {&crowd->model, tdmf_default_inputs(), {.most_strides = STRIDES}};
    crowd->its_case = its_case;
    for (int i = 0; i < RUNNERS; ++i) {
        memcpy(crowd->starts[i], &reference_gaits[2].apex, sizeof crowd->starts[i]);
    }
    const tdmf_ensemble ensemble = {.cases = &crowd->its_case,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])crowd->starts,
                                    .count = RUNNERS,
                                    .relative_tolerance = 1e-11,
                                    .threads = 1,
                                    .given = &crowd->given,
                                    .strides = &crowd->strides[0][0],
                                    .stride_count = STRIDES,
                                    .checkpoints = crowd->checkpoints};
    crowd->ensemble = ensemble;
}

/* ---- rows --------------------------------------------------------------------------------------------- */

static void assert_strides_by_rows(const crowd *crowd, int number, int first) {
    tdmf_solver solver = tdmf_solver_default();
    double apex[TDMF_SECTION_COUNT];
    memcpy(apex, crowd->starts[number], sizeof apex);
    for (int stride = 0; stride < STRIDES; ++stride) {
        const int row = stride < first + 1 ? 0 : 1;
        tdmf_model model;
        tdmf_parameters parameters = crowd->model.parameters;
        parameters.hip.touchdown_angle = crowd->values[number][row];
        assert_null(tdmf_model_create(&model, &parameters).variable);
        const tdmf_return made =
            tdmf_return_map(&solver, &model, &crowd->its_case.inputs, apex, 1e4, false, NULL, 0);
        assert_true(made.outcome.closed);
        for (int j = 0; j < TDMF_SECTION_COUNT; ++j) {
            assert_close(crowd->strides[number][stride].apex[j], made.apex[j], 1e-8);
        }
        memcpy(apex, made.apex, sizeof apex);
    }
}

/* Before the first stride given the first row, after the last one the last row. */
static void strides_are_made_with_the_rows_that_are_theirs(void **state) {
    (void)state;
    crowd crowd;
    for (int first = 0; first <= 3; ++first) {
        gather(&crowd, first);
        assert_true(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
        for (int i = 0; i < RUNNERS; ++i) {
            assert_int_equal(crowd.ends[i].strides, STRIDES);
            assert_strides_by_rows(&crowd, i, first);
        }
    }
}

static void every_row_has_to_be_in_range(void **state) {
    (void)state;
    crowd crowd;
    for (int i = 0; i < RUNNERS * ROWS; ++i) {
        gather(&crowd, 0);
        crowd.values[i / ROWS][i % ROWS] = (double)NAN;
        crowd.ends[0].strides = 77;
        assert_false(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
        assert_int_equal(crowd.ends[0].strides, 77);
    }
}

/* ---- going on ----------------------------------------------------------------------------------------- */

static void a_run_that_has_made_its_strides_makes_no_more(void **state) {
    (void)state;
    crowd crowd;
    gather(&crowd, 0);
    crowd.its_case.rules.most_strides = 2;
    assert_true(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
    tdmf_ensemble_end before[RUNNERS];
    memcpy(before, crowd.ends, sizeof before);
    crowd.ensemble.goes_on = true;
    assert_true(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
    assert_memory_equal(crowd.ends, before, sizeof before);
    assert_true(crowd.checkpoints[0].stands);
    crowd.its_case.rules.most_strides = 3;
    assert_true(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
    assert_int_equal(crowd.ends[0].strides, 3);
}

/* It drops onto a leg that is put upright, or from the second apex on onto one that is almost level. */
static void make_fall(crowd *crowd, int number, int row) {
    crowd->values[number][row] = row == 0 ? 0.2 : 1.5;
    if (row == 0) {
        crowd->starts[number][TDMF_SECTION_COM_SPEED] = 0.0;
    }
}

static void who_has_fallen_stands_nowhere(void **state) {
    (void)state;
    crowd crowd;
    gather(&crowd, 0);
    make_fall(&crowd, FALLS, 0);
    for (int i = 0; i < RUNNERS; ++i) {
        crowd.checkpoints[i].stands = true; /* as an earlier run may have left it */
    }
    crowd.its_case.rules.most_strides = 1;
    assert_true(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
    assert_int_equal(crowd.ends[FALLS].fate, TDMF_FATE_FELL);
    assert_false(crowd.checkpoints[FALLS].stands);
    assert_true(crowd.checkpoints[0].stands);
}

static void who_falls_later_stands_nowhere_then(void **state) {
    (void)state;
    crowd crowd;
    gather(&crowd, 0);
    make_fall(&crowd, FALLS, 1);
    crowd.its_case.rules.most_strides = 1;
    assert_true(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
    assert_true(crowd.checkpoints[FALLS].stands);
    crowd.its_case.rules.most_strides = STRIDES;
    crowd.ensemble.goes_on = true;
    assert_true(tdmf_run_ensemble(&crowd.ensemble, crowd.ends, NULL));
    assert_int_equal(crowd.ends[FALLS].fate, TDMF_FATE_FELL);
    assert_false(crowd.checkpoints[FALLS].stands);
}

/* ---- at an apex --------------------------------------------------------------------------------------- */

/* They widen a guard's margin; a stride is not to depend on those of the stride before. */
static void a_stride_begins_without_false_crossings(void **state) {
    (void)state;
    crowd crowd;
    tdmf_runner runner;
    tdmf_solver solver = tdmf_solver_default();
    gather(&crowd, 0);
    assert_true(tdmf_runner_begin(&runner, &crowd.ensemble, 0, &crowd.ends[0]));
    runner.false_crossings = 5;
    assert_true(tdmf_runner_stride(&runner, &solver));
    assert_int_equal(crowd.ends[0].strides, 1);
    assert_int_equal(runner.false_crossings, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strides_are_made_with_the_rows_that_are_theirs),
        cmocka_unit_test(every_row_has_to_be_in_range),
        cmocka_unit_test(a_run_that_has_made_its_strides_makes_no_more),
        cmocka_unit_test(who_has_fallen_stands_nowhere),
        cmocka_unit_test(who_falls_later_stands_nowhere_then),
        cmocka_unit_test(a_stride_begins_without_false_crossings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
