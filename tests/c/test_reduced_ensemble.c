/* Many strides of the reduced map at once: runners end where the map takes them one by one, and the same, bit
 * for bit, whoever their neighbours are and however many threads there are. */
#include "compare.h"
#include "crowd.h"
#include "random.h"
#include "references.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

enum { RUNNERS = TDMF_SAMPLE_DIVISOR == 1 ? 600 : 120, STRIDES = 6 };

static const double tight = 1e-11;

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

static crowd *reduced_crowd(void) {
    crowd *crowd = make_crowd(RUNNERS, STRIDES, tight);
    random_source source = {20261122};
    for (int i = 0; i < RUNNERS; ++i) {
        tdmf_parameters parameters = tdmf_default_parameters();
        tdmf_inputs inputs = {.ground = {.friction = 0.0}};
        vary(&source, &parameters, &inputs);
        const double start[TDMF_SECTION_COUNT] = {random_uniform(&source, 0.6, 2.5),
                                                  random_uniform(&source, 0.0, 1.6), 1.0,
                                                  parameters.hip.touchdown_angle};
        place_runner(crowd, i, &parameters, &inputs, start);
    }
    crowd->ensemble.map = TDMF_REDUCED_MAP;
    return crowd;
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

/* Iterates the map from a start and returns the end of the run. */
static tdmf_ensemble_end iterate(const tdmf_ensemble_case *scenario, const double start[TDMF_SECTION_COUNT]) {
    tdmf_ensemble_end end = {.gait = -1};
    tdmf_solver solver = solver_to(0.1 * tight);
    tdmf_return_outcome outcome = TDMF_RETURN_CLOSED;
    memcpy(end.apex, start, TDMF_SECTION_COUNT * sizeof *start);
    while (outcome == TDMF_RETURN_CLOSED && end.strides < STRIDES) {
        const tdmf_return stride = reduced_map(&solver, (tdmf_system){scenario->model, &scenario->inputs},
                                               end.apex, 1e4, false, NULL, 0);
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
    assert_all_close(a->apex, b->apex, TDMF_REDUCED_COUNT, tolerance, 0.0);
    assert_close(a->time, b->time, 1e2 * tolerance);
    assert_close(a->distance, b->distance, 1e2 * tolerance);
    assert_close(a->work, b->work, tolerance);
    assert_close(a->external_work, b->external_work, tolerance);
    assert_close(a->damper_loss, b->damper_loss, tolerance);
    assert_close(a->friction_loss, b->friction_loss, tolerance);
    assert_close(a->impact_loss, b->impact_loss, tolerance);
}

TEST(runners_end_where_the_map_takes_them) {
    crowd *crowd = reduced_crowd();
    tdmf_ensemble_end expected[RUNNERS];
    for (int i = 0; i < RUNNERS; ++i) {
        expected[i] = iterate(&crowd->cases[i], crowd->starts[i]);
    }
    FOR_INSTRUCTIONS(set) {
        int of_fate[TDMF_FATE_NO_STRIDE + 1] = {0};
        run_crowd(crowd, set);
        for (int i = 0; i < RUNNERS; ++i) {
            assert_same_end(&crowd->ends[i], &expected[i]);
            ++of_fate[crowd->ends[i].fate];
        }
        assert_true(of_fate[TDMF_FATE_UNDECIDED] > RUNNERS / 4);
        assert_true(of_fate[TDMF_FATE_NO_STRIDE] > RUNNERS / 20);
        assert_true(of_fate[TDMF_FATE_NO_START] > RUNNERS / 100);
    }
}

TEST(neighbours_and_threads_do_not_matter) {
    assert_independent_runners(reduced_crowd(), 3);
}

/* ---- settling ----------------------------------------------------------------------------------------- */

/* Settling is decided by the map's two coordinates: the leg of the given gait may be anything. */
TEST(runners_settle_on_the_gaits_of_the_reference) {
    for (int i = 0; i < REDUCED_GAITS; ++i) {
        const reduced_gait *gait = &reduced_gaits[i];
        const tdmf_parameters parameters = parameters_of_reduced_gait(gait);
        const tdmf_inputs inputs = inputs_of_reduced_gait(gait);
        const double gaits[1][TDMF_POINT_LIMIT] = {{gait->apex[0], gait->apex[1], 7.0, NAN, 7.0, 7.0}};
        crowd *crowd = make_crowd(2, 2000, tight);
        for (int k = 0; k < 2; ++k) {
            const double start[TDMF_SECTION_COUNT] = {gait->apex[0] + 0.03 * k, gait->apex[1] - 0.03 * k};
            place_runner(crowd, k, &parameters, &inputs, start);
            crowd->cases[k].rules.gaits = gaits;
            crowd->cases[k].rules.gait_count = 1;
            crowd->cases[k].rules.distance = 1e-9;
        }
        crowd->ensemble.map = TDMF_REDUCED_MAP;
        run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
        const tdmf_ensemble_end *ends = crowd->ends;
        assert_int_equal(ends[0].fate, TDMF_FATE_SETTLED);
        assert_int_equal(ends[0].strides, 1);
        assert_relatively_close(ends[0].time, gait->period, 1e-9);
        assert_relatively_close(ends[0].distance, gait->length, 1e-9);
        assert_relatively_close(ends[0].work, gait->work, 1e-9);
        assert_close(ends[0].apex[TDMF_SECTION_LEG_ANGLE], parameters.hip.touchdown_angle, 0.0);
        assert_int_equal(ends[1].fate, TDMF_FATE_SETTLED);
        assert_true(ends[1].strides > 20);
    }
}

TEST(there_is_no_third_map) {
    crowd *crowd = reduced_crowd();
    crowd->ensemble.map = (tdmf_apex_map)2;
    assert_crowd_is_refused(crowd);
}
