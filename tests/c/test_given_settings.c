/* Which row of the settings that are given a stride is made with, and where a run goes on: what an array has
 * beside a row is another runner's, so a wrong row is another stride. */
#include "compare.h"
#include "reference_gaits.h"
#include "simulation.h"

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
} population;

static void gather(population *population, int first) {
    static const double values[RUNNERS][ROWS] = {{0.70, 0.69}, {0.71, 0.72}, {0.73, 0.695}};
    const tdmf_parameters parameters = tdmf_default_parameters();
    memset(population, 0, sizeof *population);
    population->model = accepted_model(&parameters);
    population->setting = tdmf_setting_of("hip.touchdown_angle");
    memcpy(population->values, values, sizeof values);
    const tdmf_given_settings given = {1, &population->setting, first, ROWS, &population->values[0][0]};
    population->given = given;
    const tdmf_ensemble_case its_case = {&population->model, tdmf_default_inputs(), {.max_strides = STRIDES}};
    population->its_case = its_case;
    for (int i = 0; i < RUNNERS; ++i) {
        memcpy(population->starts[i], &reference_gaits[DEFAULT_GAIT].apex, sizeof population->starts[i]);
    }
    const tdmf_ensemble ensemble = {.cases = &population->its_case,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])population->starts,
                                    .count = RUNNERS,
                                    .relative_tolerance = 1e-11,
                                    .threads = 1,
                                    .given = &population->given,
                                    .strides = &population->strides[0][0],
                                    .stride_count = STRIDES,
                                    .checkpoints = population->checkpoints};
    population->ensemble = ensemble;
}

/* ---- rows --------------------------------------------------------------------------------------------- */

static void assert_strides_by_rows(const population *population, int number, int first) {
    tdmf_solver solver = tdmf_solver_default();
    double apex[TDMF_SECTION_COUNT];
    memcpy(apex, population->starts[number], sizeof apex);
    for (int stride = 0; stride < STRIDES; ++stride) {
        const int row = stride < first + 1 ? 0 : 1;
        tdmf_parameters parameters = population->model.parameters;
        parameters.hip.touchdown_angle = population->values[number][row];
        const tdmf_model model = accepted_model(&parameters);
        const tdmf_return made = tdmf_return_map(&solver, (tdmf_system){&model, &population->its_case.inputs},
                                                 apex, 1e4, false, NULL, 0);
        assert_true(made.outcome == TDMF_RETURN_CLOSED);
        for (int j = 0; j < TDMF_SECTION_COUNT; ++j) {
            assert_close(population->strides[number][stride].apex[j], made.apex[j], 1e-8);
        }
        memcpy(apex, made.apex, sizeof apex);
    }
}

/* The first row holds before the first stride that is given, the last row after the last one. */
TEST(strides_are_made_with_the_rows_that_are_theirs) {
    population population;
    for (int first = 0; first <= 3; ++first) {
        gather(&population, first);
        assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
        for (int i = 0; i < RUNNERS; ++i) {
            assert_int_equal(population.ends[i].strides, STRIDES);
            assert_strides_by_rows(&population, i, first);
        }
    }
}

TEST(every_row_has_to_be_in_range) {
    population population;
    for (int i = 0; i < RUNNERS * ROWS; ++i) {
        gather(&population, 0);
        population.values[i / ROWS][i % ROWS] = (double)NAN;
        population.ends[0].strides = 77;
        assert_false(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
        assert_int_equal(population.ends[0].strides, 77);
    }
}

/* ---- going on ----------------------------------------------------------------------------------------- */

TEST(a_run_that_has_made_its_strides_makes_no_more) {
    population population;
    gather(&population, 0);
    population.its_case.rules.max_strides = 2;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    tdmf_ensemble_end before[RUNNERS];
    memcpy(before, population.ends, sizeof before);
    population.ensemble.goes_on = true;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    assert_memory_equal(population.ends, before, sizeof before);
    assert_true(population.checkpoints[0].stands);
    population.its_case.rules.max_strides = 3;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    assert_int_equal(population.ends[0].strides, 3);
}

/* It drops onto a leg that is put upright, or from the second apex on onto one that is almost level. */
static void make_fall(population *population, int number, int row) {
    population->values[number][row] = row == 0 ? 0.2 : 1.5;
    if (row == 0) {
        population->starts[number][TDMF_SECTION_COM_SPEED] = 0.0;
    }
}

TEST(who_has_fallen_stands_nowhere) {
    population population;
    gather(&population, 0);
    make_fall(&population, FALLS, 0);
    for (int i = 0; i < RUNNERS; ++i) {
        population.checkpoints[i].stands = true; /* as an earlier run may have left it */
    }
    population.its_case.rules.max_strides = 1;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    assert_int_equal(population.ends[FALLS].fate, TDMF_FATE_FELL);
    assert_false(population.checkpoints[FALLS].stands);
    assert_true(population.checkpoints[0].stands);
}

TEST(who_falls_later_stands_nowhere_then) {
    population population;
    gather(&population, 0);
    make_fall(&population, FALLS, 1);
    population.its_case.rules.max_strides = 1;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    assert_true(population.checkpoints[FALLS].stands);
    population.its_case.rules.max_strides = STRIDES;
    population.ensemble.goes_on = true;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    assert_int_equal(population.ends[FALLS].fate, TDMF_FATE_FELL);
    assert_false(population.checkpoints[FALLS].stands);
}
