/* Gaits on slopes, with swing-leg retraction and with static friction, from apex to apex by both solvers, and
 * the return map's Jacobian there. */
#include "further_gaits.h"

#include "compare.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"
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
