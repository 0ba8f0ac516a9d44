/* When a run of the ensemble is over before a fall or the last stride: its apex is in a gait's ball, or it is
 * stopped. */
#include "compare.h"
#include "reference_gaits.h"

#include "tdmf_slip/ensemble.h"

#include <math.h>
#include <string.h>

enum { RUNNERS = 24, MAX_STRIDES = 60 };

typedef struct {
    tdmf_model model;
    double gait[1][TDMF_SECTION_COUNT], starts[RUNNERS][TDMF_SECTION_COUNT];
    tdmf_ball ball;
    tdmf_ensemble_case its_case;
    tdmf_ensemble ensemble;
    tdmf_ensemble_stride strides[RUNNERS][MAX_STRIDES];
    tdmf_ensemble_checkpoint checkpoints[RUNNERS];
    tdmf_ensemble_end ends[RUNNERS];
} population;

/* Starts over the gait's apex, the first in the ball: half axes 0.2 in height and so much less in speed. */
static void gather(population *population) {
    memset(population, 0, sizeof *population);
    population->model = table_1(false);
    memcpy(population->gait[0], &reference_gaits[DEFAULT_GAIT].apex, sizeof population->gait[0]);
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        population->ball.matrix[i][i] = 2.0;
    }
    population->ball.matrix[TDMF_SECTION_COM_HEIGHT][TDMF_SECTION_COM_HEIGHT] = 5.0;
    population->ball.matrix[TDMF_SECTION_COM_SPEED][TDMF_SECTION_COM_HEIGHT] = 1.0;
    population->ball.matrix[TDMF_SECTION_COM_SPEED][TDMF_SECTION_COM_SPEED] = 8.0;
    for (int i = 0; i < RUNNERS; ++i) {
        memcpy(population->starts[i], population->gait[0], sizeof population->gait[0]);
        population->starts[i][TDMF_SECTION_COM_HEIGHT] += 0.1 * i - 0.005 * (i == 0);
    }
    const tdmf_ensemble_case its_case = {&population->model,
                                         tdmf_default_inputs(),
                                         {.gaits = (const double(*)[TDMF_SECTION_COUNT])population->gait,
                                          .gait_count = 1,
                                          .balls = &population->ball,
                                          .max_strides = MAX_STRIDES}};
    population->its_case = its_case;
    const tdmf_ensemble ensemble = {.cases = &population->its_case,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])population->starts,
                                    .count = RUNNERS,
                                    .relative_tolerance = 1e-8,
                                    .threads = 2,
                                    .strides = &population->strides[0][0],
                                    .stride_count = MAX_STRIDES,
                                    .checkpoints = population->checkpoints};
    population->ensemble = ensemble;
}

static double norm(const population *population, const double apex[TDMF_SECTION_COUNT], int coordinates) {
    double square = 0.0;
    for (int i = 0; i < coordinates; ++i) {
        double sum = 0.0;
        for (int j = 0; j < coordinates; ++j) {
            sum += population->ball.matrix[i][j] * (apex[j] - population->gait[0][j]);
        }
        square += sum * sum;
    }
    return sqrt(square);
}

/* The apex at the end is the first in the ball: no stride before closed in it. */
static int settled_at_the_first(const population *population, int coordinates) {
    int settled = 0;
    for (int i = 0; i < RUNNERS; ++i) {
        const tdmf_ensemble_end *end = &population->ends[i];
        const bool inside = end->strides == 0 && norm(population, population->starts[i], coordinates) <= 1.0;
        if (end->fate != TDMF_FATE_SETTLED) {
            continue;
        }
        ++settled;
        assert_int_equal(end->gait, 0);
        assert_true(norm(population, end->apex, coordinates) <= 1.0);
        assert_true(inside || norm(population, population->starts[i], coordinates) > 1.0);
        for (int stride = 0; stride + 1 < end->strides; ++stride) {
            assert_true(norm(population, population->strides[i][stride].apex, coordinates) > 1.0);
        }
    }
    return settled;
}

TEST(a_runner_in_the_ball_has_settled) {
    static population population;
    int sets = 0;
    for (int set = 0; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
        gather(&population);
        population.ensemble.instructions = (tdmf_instructions)set;
        if (tdmf_has_instructions(population.ensemble.instructions)) {
            assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
            assert_int_equal(population.ends[0].fate, TDMF_FATE_SETTLED);
            assert_int_equal(population.ends[0].strides, 0);
            assert_true(population.ends[2].strides > 0);
            assert_in_range(settled_at_the_first(&population, TDMF_SECTION_COUNT), 4, RUNNERS);
            ++sets;
        }
    }
    assert_true(sets >= 2);
}

/* Whose matrix has two rows and columns: what the others say does not count. */
TEST(a_ball_of_the_reduced_map_is_of_height_and_speed) {
    static population population;
    gather(&population);
    population.ensemble.map = TDMF_REDUCED_MAP;
    population.ball.matrix[TDMF_SECTION_LEG_ANGLE][TDMF_SECTION_LEG_ANGLE] = 1e9;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    assert_in_range(settled_at_the_first(&population, TDMF_REDUCED_COUNT), 4, RUNNERS);
}

/* What had not begun has not run; what stands goes on to the same end as if nothing had been. */
TEST(a_stopped_run_goes_on_to_the_same_ends) {
    static population population, whole;
    static const int stop = 1;
    tdmf_ensemble_work work;
    gather(&whole);
    whole.its_case.rules.gait_count = 0;
    population = whole;
    whole.ensemble.cases = &whole.its_case;
    whole.ensemble.starts = (const double(*)[TDMF_SECTION_COUNT])whole.starts;
    population.ensemble.cases = &population.its_case;
    population.ensemble.starts = (const double(*)[TDMF_SECTION_COUNT])population.starts;
    population.ensemble.checkpoints = population.checkpoints;
    population.ensemble.strides = NULL;
    whole.ensemble.strides = NULL;
    whole.ensemble.checkpoints = whole.checkpoints;
    assert_true(tdmf_run_ensemble(&whole.ensemble, whole.ends, NULL));
    population.ensemble.stop = &stop;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, &work));
    assert_int_equal(work.begun, 0);
    assert_int_equal(work.strides, 0);
    population.ensemble.stop = NULL;
    population.its_case.rules.max_strides = 5;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    population.its_case.rules.max_strides = MAX_STRIDES;
    population.ensemble.goes_on = true;
    assert_true(tdmf_run_ensemble(&population.ensemble, population.ends, NULL));
    for (int i = 0; i < RUNNERS; ++i) {
        assert_int_equal(population.ends[i].fate, whole.ends[i].fate);
        assert_int_equal(population.ends[i].strides, whole.ends[i].strides);
    }
}
