/* Gaits on slopes, with swing-leg retraction and with static friction, from apex to apex by every solver, and
 * the return map's derivatives there, by the section and by what the two laws depend on. */
#include "further_gaits.h"

#include "compare.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"
#include "tdmf_slip/ensemble.h"
#include "tdmf_slip/return_map.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};
static const double tight = 1e-12;

/* A stride that began where its runner did: its losses are those of the run. */
static void assert_is_gait(const tdmf_motion *motion, const further_gait *further, double tolerance) {
    const reference_gait *gait = &further->gait;
    const tdmf_stride *stride = &motion->record.stride;
    assert_int_equal(stride->count, 1);
    assert_reference_stride(motion, gait, tolerance);
    assert_close(stride->leg_work, further->leg_work, tolerance);
    assert_relatively_close(stride->hip_work, gait->work - further->leg_work, tolerance);
    assert_close(stride->rise, further->rise, tolerance);
    assert_relatively_close(motion->state[TDMF_ENERGY_DAMPER_LOSS], further->damper_loss, tolerance);
    /* A foot that slips in the last moment of its stance loses no more than rounding. */
    assert_close(motion->state[TDMF_ENERGY_FRICTION_LOSS], further->friction_loss,
                 tolerance * fmax(further->friction_loss, 1e-3));
    assert_relatively_close(motion->record.impact_loss, further->impact_loss, tolerance);
}

/* ---- by the native solver ------------------------------------------------------------------------------ */

TEST(the_native_solver_comes_back_to_the_apex) {
    int events = 0;
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        const runner runner = runner_at_further_apex(&further_gaits[i]);
        tdmf_event_log log = {0};
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = solver_to(tight);
        solver.log = &log;
        assert_true(tdmf_native_stride(&solver, SYSTEM_OF(&runner), DBL_MAX, &motion).closed);
        assert_is_gait(&motion, &further_gaits[i], 1e-9);
        assert_close(motion.state[TDMF_ENERGY_EXTERNAL_WORK], further_gaits[i].external_work, 1e-9);
        events += assert_reference_events(&log, further_gaits[i].gait.events, 1e-9);
    }
    assert_int_equal(events, 13 * 10 + 4 * 11 + 2 * 9 + 3 * 8 + 6 * 7);
}

/* ---- by lanes ------------------------------------------------------------------------------------------ */

static void assert_lanes_come_back(tdmf_instructions instructions) {
    static tdmf_model models[FURTHER_GAITS];
    tdmf_ensemble_case cases[FURTHER_GAITS];
    int case_of[FURTHER_GAITS];
    double starts[FURTHER_GAITS][TDMF_SECTION_COUNT];
    tdmf_ensemble_end ends[FURTHER_GAITS];
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        const tdmf_ensemble_case its_case = {&models[i], tdmf_default_inputs(), {.max_strides = 1}};
        const tdmf_parameters parameters = parameters_of_further_gait(&further_gaits[i]);
        models[i] = accepted_model(&parameters);
        cases[i] = its_case;
        cases[i].inputs = inputs_of_further_gait(&further_gaits[i]);
        case_of[i] = i;
        memcpy(starts[i], &further_gaits[i].gait.apex, sizeof starts[i]);
    }
    const tdmf_ensemble ensemble = {.cases = cases,
                                    .case_count = FURTHER_GAITS,
                                    .case_of = case_of,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])starts,
                                    .count = FURTHER_GAITS,
                                    .relative_tolerance = 1e-11,
                                    .instructions = instructions,
                                    .threads = 1};
    assert_true(tdmf_run_ensemble(&ensemble, ends, NULL));
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        const further_gait *further = &further_gaits[i];
        assert_int_equal(ends[i].strides, 1);
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            assert_close(ends[i].apex[k], starts[i][k], 1e-9);
        }
        assert_relatively_close(ends[i].time, further->gait.period, 1e-9);
        assert_relatively_close(ends[i].distance, further->gait.length, 1e-9);
        assert_relatively_close(ends[i].work, further->gait.work, 1e-9);
        assert_relatively_close(ends[i].hip_work, further->gait.work - further->leg_work, 1e-9);
        assert_close(ends[i].leg_work, further->leg_work, 1e-9);
        assert_close(ends[i].external_work, further->external_work, 1e-9);
        assert_relatively_close(ends[i].damper_loss, further->damper_loss, 1e-9);
        assert_relatively_close(ends[i].friction_loss, further->friction_loss, 1e-9);
        assert_relatively_close(ends[i].impact_loss, further->impact_loss, 1e-9);
    }
}

TEST(lanes_come_back_to_the_apex) {
    int sets = 0;
    for (int set = TDMF_ONE_BY_ONE; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
        if (tdmf_has_instructions((tdmf_instructions)set)) {
            assert_lanes_come_back((tdmf_instructions)set);
            ++sets;
        } else {
            print_message("not here: %s\n", tdmf_instructions_name((tdmf_instructions)set));
        }
    }
    assert_true(sets >= 2);
}

/* ---- by CVODE ------------------------------------------------------------------------------------------ */

TEST(cvode_comes_back_to_the_apex) {
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        const runner runner = runner_at_further_apex(&further_gaits[i]);
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = solver_to(1e-12);
        /* A hundredth past the apex, in which neither a loss nor the angle of lift-off changes any more but
         * for the damper's, whose leg is at rest by then. */
        assert_int_equal(tdmf_cvode_advance(&solver, SYSTEM_OF(&runner), &no_rates,
                                            further_gaits[i].gait.period + 0.01, &motion),
                         TDMF_ARRIVED);
        assert_is_gait(&motion, &further_gaits[i], 1e-8);
    }
}

/* ---- derivatives --------------------------------------------------------------------------------------- */

static tdmf_return stride_of(const further_gait *further, const tdmf_parameters *parameters,
                             const tdmf_seed *seed) {
    tdmf_model model;
    const tdmf_inputs inputs = inputs_of_further_gait(further);
    tdmf_solver solver = tdmf_solver_default();
    double section[TDMF_SECTION_COUNT];
    solver.relative_tolerance = 1e-13;
    memcpy(section, &further->gait.apex, sizeof section);
    assert_null(tdmf_model_create(&model, parameters).variable);
    const tdmf_return stride = tdmf_return_map(&solver, (tdmf_system){&model, &inputs}, section, 1e3, true,
                                               seed, seed != NULL ? 1 : 0);
    assert_true(stride.outcome == TDMF_RETURN_CLOSED);
    return stride;
}

TEST(the_jacobian_is_that_of_the_reference) {
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        const tdmf_parameters parameters = parameters_of_further_gait(&further_gaits[i]);
        const tdmf_return stride = stride_of(&further_gaits[i], &parameters, NULL);
        assert_true(assert_reference_jacobian(&stride, &further_gaits[i].gait));
    }
}

enum { LAWS_PARAMETERS = 6 };

static double *const *parameters_of_the_laws(tdmf_parameters *p, double *members[LAWS_PARAMETERS]) {
    members[0] = &p->hip.retraction_rate;
    members[1] = &p->ground.static_friction_ratio;
    members[2] = &p->hip.kd;
    members[3] = &p->hip.touchdown_angle;
    members[4] = &p->leg.thrust;
    members[5] = &p->ground.stribeck_velocity;
    return members;
}

/* By central differences; at the least static friction and thrust by one that looks ahead, of second order as
 * well. */
TEST(by_parameters_the_gaits_are_differentiated) {
    const double step = 3e-6;
    int compared = 0, one_sided = 0;
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        for (int k = 0; k < LAWS_PARAMETERS; ++k) {
            const tdmf_parameters at = parameters_of_further_gait(&further_gaits[i]);
            tdmf_parameters moved[3] = {at, at, at};
            double *members[LAWS_PARAMETERS];
            tdmf_seed seed;
            tdmf_return strides[3];
            if (k == 5 && at.ground.stribeck_velocity == 0.0) {
                continue; /* there, there is none */
            }
            memset(&seed, 0, sizeof seed);
            *parameters_of_the_laws(&seed.parameters, members)[k] = 1.0;
            const bool ahead =
                (k == 1 && at.ground.static_friction_ratio == 1.0) || (k == 4 && at.leg.thrust == 0.0);
            for (int j = 0; j < 3; ++j) {
                *parameters_of_the_laws(&moved[j], members)[k] += (ahead ? j : j - 1) * step;
                strides[j] = stride_of(&further_gaits[i], &moved[j], NULL);
            }
            const tdmf_return exact = stride_of(&further_gaits[i], &at, &seed);
            double size = 1.0;
            for (int c = 0; c < TDMF_SECTION_COUNT; ++c) {
                size = fmax(size, fabs(exact.variations[TDMF_SECTION_COUNT].apex[c]));
            }
            for (int c = 0; c < TDMF_SECTION_COUNT; ++c) {
                const double forward =
                    4.0 * strides[1].apex[c] - 3.0 * strides[0].apex[c] - strides[2].apex[c];
                const double difference = ahead ? forward : strides[2].apex[c] - strides[0].apex[c];
                assert_close(exact.variations[TDMF_SECTION_COUNT].apex[c], difference / (2.0 * step),
                             1e-6 * size);
                ++compared;
            }
            one_sided += ahead;
        }
    }
    assert_int_equal(compared, (FURTHER_GAITS * LAWS_PARAMETERS - 22) * TDMF_SECTION_COUNT);
    assert_int_equal(one_sided, 16 + 22);
}
