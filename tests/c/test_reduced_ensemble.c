/* Many strides of the reduced map at once: runners end where the map takes them one by one, and the same, bit
 * for bit, whoever their neighbours are and however many threads there are. */
#include "compare.h"
#include "random.h"
#include "reduced_gaits.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNNERS = TDMF_SAMPLE_DIVISOR == 1 ? 600 : 120, STRIDES = 6 };

static const double tight = 1e-11;

/* Each runner with a case of its own. */
typedef struct {
    tdmf_model models[RUNNERS];
    tdmf_ensemble_case cases[RUNNERS];
    int case_of[RUNNERS];
    double starts[RUNNERS][TDMF_SECTION_COUNT];
    tdmf_ensemble ensemble;
} population;

static void vary(random_source *source, tdmf_parameters *p, tdmf_inputs *inputs) {
    p->foot.mass *= random_magnitude(source, 0.5, 2.0);
    p->leg.damping *= random_magnitude(source, 0.5, 2.0);
    p->hip.stance_torque *= random_magnitude(source, 0.5, 2.0);
    p->hip.touchdown_angle = random_uniform(source, 0.1, 1.2);
    p->hip.retraction_rate = random_uniform(source, -0.03, 0.03);
    p->ground.static_friction_ratio = random_uniform(source, 1.0, 1.5);
    inputs->ground.friction = random_magnitude(source, 0.05, 5.0);
    inputs->ground.slope = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.1, 0.1);
    inputs->body.external_fx = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -1e-3, 1e-3);
    inputs->body.external_fy = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -1e-3, 1e-3);
    inputs->leg.extension = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.03, 0.03);
    p->leg.thrust = random_chance(source, 0.5) ? 0.0 : random_uniform(source, 0.0, 0.03);
    inputs->hip.external_torque = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.01, 0.01);
}

static population *make_population(void) {
    population *population = calloc(1, sizeof *population);
    random_source source = {20261122};
    assert_non_null(population);
    for (int i = 0; i < RUNNERS; ++i) {
        tdmf_ensemble_case *its_case = &population->cases[i];
        tdmf_parameters parameters = tdmf_default_parameters();
        vary(&source, &parameters, &its_case->inputs);
        population->models[i] = accepted_model(&parameters);
        its_case->model = &population->models[i];
        its_case->rules.max_strides = STRIDES;
        population->case_of[i] = i;
        const double start[TDMF_SECTION_COUNT] = {random_uniform(&source, 0.6, 2.5),
                                                  random_uniform(&source, 0.0, 1.6), 1.0,
                                                  parameters.hip.touchdown_angle};
        memcpy(population->starts[i], start, sizeof start);
    }
    const tdmf_ensemble ensemble = {.cases = population->cases,
                                    .case_count = RUNNERS,
                                    .case_of = population->case_of,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])population->starts,
                                    .count = RUNNERS,
                                    .relative_tolerance = tight,
                                    .threads = 1,
                                    .map = TDMF_REDUCED_MAP};
    population->ensemble = ensemble;
    return population;
}

static tdmf_ensemble_end *run(const tdmf_ensemble *ensemble) {
    tdmf_ensemble_end *ends = calloc((size_t)ensemble->count, sizeof *ends);
    assert_non_null(ends);
    assert_true(tdmf_run_ensemble(ensemble, ends, NULL));
    return ends;
}

/* ---- against the map ---------------------------------------------------------------------------------- */

static tdmf_fate fate_of(tdmf_return_outcome outcome, bool first) {
    switch (outcome) {
    case TDMF_RETURN_CLOSED:
    case TDMF_RETURN_TOO_LONG:
        return TDMF_FATE_UNDECIDED;
    case TDMF_RETURN_FELL:
        return TDMF_FATE_FELL;
    case TDMF_RETURN_NO_START:
        return first ? TDMF_FATE_NO_START : TDMF_FATE_NO_STRIDE;
    case TDMF_RETURN_UNSOLVED:
        return TDMF_FATE_UNSOLVED;
    default:
        return TDMF_FATE_NO_STRIDE;
    }
}

/* What the map makes of a runner. */
static tdmf_ensemble_end iterate(const tdmf_ensemble_case *its_case, const double start[TDMF_SECTION_COUNT]) {
    tdmf_ensemble_end end = {.gait = -1};
    tdmf_solver solver = solver_to(0.1 * tight);
    tdmf_return_outcome outcome = TDMF_RETURN_CLOSED;
    memcpy(end.apex, start, sizeof end.apex);
    while (outcome == TDMF_RETURN_CLOSED && end.strides < STRIDES) {
        const tdmf_return stride = tdmf_reduced_map(
            &solver, (tdmf_system){its_case->model, &its_case->inputs}, end.apex, 1e4, false, NULL, 0);
        outcome = stride.outcome;
        if (outcome == TDMF_RETURN_CLOSED) {
            memcpy(end.apex, stride.apex, sizeof stride.apex);
            ++end.strides;
            end.time += stride.stride.period;
            end.distance += stride.stride.length;
            end.work += stride.stride.work;
            end.external_work += stride.external_work;
            end.damper_loss += stride.damper_loss;
            end.friction_loss += stride.friction_loss;
            end.impact_loss += stride.impact_loss;
            end.word_code = stride.stride.word_code;
        }
    }
    end.fate = (int)fate_of(outcome, end.strides == 0);
    return end;
}

static void assert_same_end(const tdmf_ensemble_end *a, const tdmf_ensemble_end *b) {
    static const double tolerance = 1e-7;
    assert_int_equal(a->fate, b->fate);
    assert_int_equal(a->strides, b->strides);
    assert_int_equal(a->word_code, b->word_code);
    for (int i = 0; i < TDMF_REDUCED_COUNT; ++i) {
        assert_close(a->apex[i], b->apex[i], tolerance);
    }
    assert_close(a->time, b->time, 1e2 * tolerance);
    assert_close(a->distance, b->distance, 1e2 * tolerance);
    assert_close(a->work, b->work, tolerance);
    assert_close(a->external_work, b->external_work, tolerance);
    assert_close(a->damper_loss, b->damper_loss, tolerance);
    assert_close(a->friction_loss, b->friction_loss, tolerance);
    assert_close(a->impact_loss, b->impact_loss, tolerance);
}

TEST(runners_end_where_the_map_takes_them) {
    population *population = make_population();
    tdmf_ensemble_end expected[RUNNERS];
    int sets = 0;
    for (int i = 0; i < RUNNERS; ++i) {
        expected[i] = iterate(&population->cases[i], population->starts[i]);
    }
    for (int set = TDMF_ONE_BY_ONE; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
        int of_fate[TDMF_FATE_NO_STRIDE + 1] = {0};
        if (!tdmf_has_instructions((tdmf_instructions)set)) {
            continue;
        }
        ++sets;
        population->ensemble.instructions = (tdmf_instructions)set;
        tdmf_ensemble_end *ends = run(&population->ensemble);
        for (int i = 0; i < RUNNERS; ++i) {
            assert_same_end(&ends[i], &expected[i]);
            ++of_fate[ends[i].fate];
        }
        assert_true(of_fate[TDMF_FATE_UNDECIDED] > RUNNERS / 4);
        assert_true(of_fate[TDMF_FATE_NO_STRIDE] > RUNNERS / 20);
        assert_true(of_fate[TDMF_FATE_NO_START] > RUNNERS / 100);
        free(ends);
    }
    assert_true(sets >= 2);
    free(population);
}

/* ---- neighbours and threads --------------------------------------------------------------------------- */

TEST(neighbours_and_threads_do_not_matter) {
    population *population = make_population();
    tdmf_ensemble_end *together = run(&population->ensemble);
    population->ensemble.threads = 3;
    tdmf_ensemble_end *shared = run(&population->ensemble);
    assert_memory_equal(shared, together, RUNNERS * sizeof *together);
    for (int i = 0; i < RUNNERS; i += 3) {
        tdmf_ensemble one = population->ensemble;
        one.starts = &population->ensemble.starts[i];
        one.case_of = &population->case_of[i];
        one.count = 1;
        tdmf_ensemble_end *alone = run(&one);
        assert_memory_equal(alone, &together[i], sizeof *alone);
        free(alone);
    }
    free(shared);
    free(together);
    free(population);
}

/* ---- settling ----------------------------------------------------------------------------------------- */

/* By the two coordinates that the map has: the leg of the gait that is given is anything. */
TEST(runners_settle_on_the_gaits_of_the_reference) {
    for (int i = 0; i < REDUCED_GAITS; ++i) {
        const reduced_gait *gait = &reduced_gaits[i];
        const tdmf_parameters parameters = parameters_of_reduced_gait(gait);
        const double gaits[1][TDMF_SECTION_COUNT] = {{gait->apex[0], gait->apex[1], 7.0, NAN, 7.0, 7.0}};
        const double starts[2][TDMF_SECTION_COUNT] = {{gait->apex[0], gait->apex[1]},
                                                      {gait->apex[0] + 0.03, gait->apex[1] - 0.03}};
        const tdmf_model model = accepted_model(&parameters);
        const tdmf_ensemble_case its_case = {
            &model,
            inputs_of_reduced_gait(gait),
            {.gaits = gaits, .gait_count = 1, .distance = 1e-9, .max_strides = 2000}};
        const tdmf_ensemble ensemble = {.cases = &its_case,
                                        .case_count = 1,
                                        .starts = starts,
                                        .count = 2,
                                        .relative_tolerance = tight,
                                        .threads = 1,
                                        .map = TDMF_REDUCED_MAP};
        tdmf_ensemble_end *ends = run(&ensemble);
        assert_int_equal(ends[0].fate, TDMF_FATE_SETTLED);
        assert_int_equal(ends[0].strides, 1);
        assert_relatively_close(ends[0].time, gait->period, 1e-9);
        assert_relatively_close(ends[0].distance, gait->length, 1e-9);
        assert_relatively_close(ends[0].work, gait->work, 1e-9);
        assert_close(ends[0].apex[TDMF_SECTION_LEG_ANGLE], parameters.hip.touchdown_angle, 0.0);
        assert_int_equal(ends[1].fate, TDMF_FATE_SETTLED);
        assert_true(ends[1].strides > 20);
        free(ends);
    }
}

TEST(there_is_no_third_map) {
    population *population = make_population();
    tdmf_ensemble_end end = {.strides = 77};
    population->ensemble.map = (tdmf_ensemble_map)2;
    assert_false(tdmf_run_ensemble(&population->ensemble, &end, NULL));
    assert_int_equal(end.strides, 77);
    free(population);
}
