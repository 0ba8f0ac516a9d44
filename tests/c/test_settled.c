/* When a run of the ensemble is over before a fall or the last stride: its apex is in a gait's ball, or it is
 * stopped. */
#include "compare.h"
#include "crowd.h"
#include "reference_gaits.h"

#include <math.h>
#include <string.h>

enum { RUNNERS = 24, MAX_STRIDES = 60 };

static double gait[TDMF_POINT_LIMIT];

/* Half axes 0.2 in height and so much less in speed. */
static tdmf_ball ball;

/* Starts over the gait's apex, the first in the ball. */
static crowd *gather(void) {
    crowd *crowd = make_crowd(RUNNERS, MAX_STRIDES, 1e-8);
    tdmf_ensemble_rules *rules = &share_case(crowd)->rules;
    memcpy(gait, &reference_gaits[DEFAULT_GAIT].apex, sizeof reference_gaits[DEFAULT_GAIT].apex);
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        ball.matrix[i][i] = 2.0;
    }
    ball.matrix[TDMF_SECTION_COM_HEIGHT][TDMF_SECTION_COM_HEIGHT] = 5.0;
    ball.matrix[TDMF_SECTION_COM_SPEED][TDMF_SECTION_COM_HEIGHT] = 1.0;
    ball.matrix[TDMF_SECTION_COM_SPEED][TDMF_SECTION_COM_SPEED] = 8.0;
    for (int i = 0; i < RUNNERS; ++i) {
        crowd->starts[i][TDMF_SECTION_COM_HEIGHT] += 0.1 * i - 0.005 * (i == 0);
    }
    rules->gaits = (const double(*)[TDMF_POINT_LIMIT]) & gait;
    rules->gait_count = 1;
    rules->balls = &ball;
    crowd->ensemble.threads = 2;
    note_strides(crowd, MAX_STRIDES);
    return crowd;
}

static double norm(const double apex[TDMF_SECTION_COUNT], int coordinates) {
    double square = 0.0;
    for (int i = 0; i < coordinates; ++i) {
        double sum = 0.0;
        for (int j = 0; j < coordinates; ++j) {
            sum += ball.matrix[i][j] * (apex[j] - gait[j]);
        }
        square += sum * sum;
    }
    return sqrt(square);
}

/* The apex at the end is the first in the ball: no stride before closed in it. */
static int settled_at_the_first(const crowd *crowd, int coordinates) {
    int settled = 0;
    for (int i = 0; i < RUNNERS; ++i) {
        const tdmf_ensemble_end *end = &crowd->ends[i];
        const bool starts_inside = norm(crowd->starts[i], coordinates) <= 1.0;
        if (end->fate == TDMF_FATE_SETTLED) {
            ++settled;
            assert_int_equal(end->gait, 0);
            assert_true(norm(end->apex, coordinates) <= 1.0);
            assert_true(starts_inside == (end->strides == 0));
            for (int stride = 0; stride + 1 < end->strides; ++stride) {
                assert_true(norm(crowd->strides[i * MAX_STRIDES + stride].apex, coordinates) > 1.0);
            }
        }
    }
    return settled;
}

TEST(a_runner_in_the_ball_has_settled) {
    FOR_INSTRUCTIONS(set) {
        crowd *crowd = gather();
        run_crowd(crowd, set);
        assert_int_equal(crowd->ends[0].fate, TDMF_FATE_SETTLED);
        assert_int_equal(crowd->ends[0].strides, 0);
        assert_true(crowd->ends[2].strides > 0);
        assert_in_range(settled_at_the_first(crowd, TDMF_SECTION_COUNT), 4, RUNNERS);
    }
}

/* Whose matrix has two rows and columns: what the others say does not count. */
TEST(a_ball_of_the_reduced_map_is_of_height_and_speed) {
    crowd *crowd = gather();
    crowd->ensemble.map = TDMF_REDUCED_MAP;
    ball.matrix[TDMF_SECTION_LEG_ANGLE][TDMF_SECTION_LEG_ANGLE] = 1e9;
    run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
    assert_in_range(settled_at_the_first(crowd, TDMF_REDUCED_COUNT), 4, RUNNERS);
}

/* Runners that had not begun have not run. Interrupted runners go on to the ends of an uninterrupted run. */
TEST(a_stopped_run_goes_on_to_the_same_ends) {
    static const int stop = 1;
    crowd *whole = gather(), *stopped = gather();
    tdmf_ensemble_work work;
    whole->cases[0].rules.gait_count = stopped->cases[0].rules.gait_count = 0;
    run_crowd(whole, TDMF_BEST_INSTRUCTIONS);
    stopped->ensemble.stop = &stop;
    assert_null(tdmf_run_ensemble(&stopped->ensemble, stopped->ends, &work).variable);
    assert_int_equal(work.begun, 0);
    assert_int_equal(work.strides, 0);
    stopped->ensemble.stop = NULL;
    stopped->cases[0].rules.max_strides = 5;
    run_crowd(stopped, TDMF_BEST_INSTRUCTIONS);
    stopped->cases[0].rules.max_strides = MAX_STRIDES;
    stopped->ensemble.goes_on = true;
    run_crowd(stopped, TDMF_BEST_INSTRUCTIONS);
    for (int i = 0; i < RUNNERS; ++i) {
        assert_int_equal(stopped->ends[i].fate, whole->ends[i].fate);
        assert_int_equal(stopped->ends[i].strides, whole->ends[i].strides);
    }
}
