/* Rows of given settings: the row of each stride, and the row at which a run goes on. The neighbours of a row
 * belong to other runners, so a wrong row makes another stride. */
#include "compare.h"
#include "crowd.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

enum { RUNNERS = 3, ROWS = 2, STRIDES = 6, FALLS = RUNNERS - 1 };

static int setting;
static double values[RUNNERS][ROWS];
static tdmf_given_settings given;

/* No two rows are alike. */
static crowd *gather(int first, int max_strides) {
    static const double rows[RUNNERS][ROWS] = {{0.70, 0.69}, {0.71, 0.72}, {0.73, 0.695}};
    crowd *crowd = make_crowd(RUNNERS, max_strides, 1e-11);
    setting = tdmf_setting_of("hip.touchdown_angle");
    memcpy(values, rows, sizeof values);
    given = (tdmf_given_settings){1, &setting, first, ROWS, &values[0][0]};
    share_case(crowd);
    note_strides(crowd, STRIDES);
    crowd->ensemble.given = &given;
    return crowd;
}

static void go_on(crowd *crowd, int max_strides) {
    crowd->ensemble.goes_on = true;
    crowd->cases[0].rules.max_strides = max_strides;
    run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
}

static void set_row(void *context, int number, int stride, const double apex[TDMF_SECTION_COUNT],
                    tdmf_parameters *parameters, tdmf_inputs *inputs) {
    const int *first = context;
    (void)apex;
    (void)inputs;
    parameters->hip.touchdown_angle = values[number][stride < *first + 1 ? 0 : 1];
}

/* The first row holds before the first stride that is given, the last row after the last one. */
TEST(strides_are_made_with_the_rows_that_are_theirs) {
    for (int first = 0; first <= 3; ++first) {
        crowd *crowd = gather(first, STRIDES);
        run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
        for (int i = 0; i < RUNNERS; ++i) {
            strides_by_hand by_hand;
            stride_by_hand(crowd, i, set_row, &first, &by_hand);
            assert_int_equal(by_hand.closed, STRIDES);
            assert_strides_by_hand(crowd, i, &by_hand);
        }
    }
}

TEST(every_row_has_to_be_in_range) {
    for (int i = 0; i < RUNNERS * ROWS; ++i) {
        crowd *crowd = gather(0, STRIDES);
        values[i / ROWS][i % ROWS] = (double)NAN;
        assert_crowd_is_refused(crowd);
    }
}

TEST(a_run_that_has_made_its_strides_makes_no_more) {
    crowd *crowd = gather(0, 2);
    tdmf_ensemble_end before[RUNNERS];
    run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
    memcpy(before, crowd->ends, sizeof before);
    go_on(crowd, 2);
    assert_memory_equal(crowd->ends, before, sizeof before);
    assert_true(crowd->checkpoints[0].stands);
    go_on(crowd, 3);
    assert_int_equal(crowd->ends[0].strides, 3);
}

/* It drops onto a leg that is put upright, or from the second apex on onto one that is almost level. */
TEST(a_fallen_runner_has_no_checkpoint) {
    for (int row = 0; row < ROWS; ++row) {
        crowd *crowd = gather(0, 1);
        values[FALLS][row] = row == 0 ? 0.2 : 1.5;
        crowd->starts[FALLS][TDMF_SECTION_COM_SPEED] *= row;
        for (int i = 0; i < RUNNERS; ++i) {
            crowd->checkpoints[i].stands = true; /* an earlier run may have left it set */
        }
        run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
        assert_true(crowd->checkpoints[0].stands);
        assert_true(crowd->checkpoints[FALLS].stands == (row == 1));
        go_on(crowd, STRIDES);
        assert_int_equal(crowd->ends[FALLS].fate, TDMF_FATE_FELL);
        assert_false(crowd->checkpoints[FALLS].stands);
    }
}

/* The plain page has fewer modes than a checkpoint may name: a runner of another mode goes on without it. */
TEST(a_run_goes_on_in_any_mode) {
    int mode = 0;
    for (bool is_taken = true; is_taken; ++mode) {
        crowd *crowd = gather(0, 1);
        run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
        crowd->checkpoints[0].mode = mode;
        crowd->ensemble.goes_on = true;
        crowd->cases[0].rules.max_strides = 2;
        is_taken = tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL).variable == NULL;
        assert_int_equal(crowd->ends[1].strides, is_taken ? 2 : 1);
    }
    assert_true(mode > 7);
}
