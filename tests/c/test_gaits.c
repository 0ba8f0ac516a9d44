/* The gaits of the references, published and further ones, from apex to apex by both solvers, and the return
 * map's Jacobian there. */
#include "compare.h"
#include "references.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

enum { GAITS = REFERENCE_GAITS + FURTHER_GAITS };

/* NULL of a published one. */
static const further_gait *further_at(int i) {
    return i < REFERENCE_GAITS ? NULL : &further_gaits[i - REFERENCE_GAITS];
}

static const reference_gait *gait_at(int i) {
    return i < REFERENCE_GAITS ? &reference_gaits[i] : &further_at(i)->gait;
}

static simulation begin(int i, double tolerance) {
    const runner runner = i < REFERENCE_GAITS ? runner_at_reference_apex(&reference_gaits[i])
                                              : runner_at_further_apex(further_at(i));
    return simulation_of(&runner, tolerance);
}

/* A stride that began where its runner did: its losses are those of the run. */
static void assert_is_gait(const tdmf_motion *motion, int i, double tolerance) {
    const reference_gait *gait = gait_at(i);
    const further_gait *further = further_at(i);
    const tdmf_stride stride = last_stride_of(motion);
    assert_int_equal(stride.count, 1);
    assert_reference_stride(motion, gait, tolerance);
    if (further == NULL) {
        if (!gait->swing_clamp) {
            assert_relatively_close(stride.positive_work, gait->positive_work, tolerance);
        }
        return;
    }
    assert_close(stride.leg_work, further->leg_work, tolerance);
    assert_relatively_close(stride.hip_work, gait->work - further->leg_work, tolerance);
    assert_close(stride.rise, further->rise, tolerance);
    assert_relatively_close(motion->state[TDMF_ENERGY_DAMPER_LOSS], further->damper_loss, tolerance);
    /* A foot that slips in the last moment of its stance loses no more than rounding. */
    assert_close(motion->state[TDMF_ENERGY_FRICTION_LOSS], further->friction_loss,
                 tolerance * fmax(further->friction_loss, 1e-3));
    assert_relatively_close(motion->state[TDMF_ENERGY_IMPACT_LOSS], further->impact_loss, tolerance);
}

/* Event by event, as accurate as the solver can be. */
TEST(the_native_solver_comes_back_to_the_apex) {
    int events = 0;
    for (int i = 0; i < GAITS; ++i) {
        const double tolerance = further_at(i) ? 1e-9 : 1e-11;
        simulation run = begin(i, 1e-13);
        simulation_stride(&run);
        assert_is_gait(&run.motion, i, tolerance);
        if (further_at(i)) {
            assert_close(run.motion.state[TDMF_ENERGY_EXTERNAL_WORK], further_at(i)->external_work,
                         tolerance);
        }
        events += assert_reference_events(&run.log, gait_at(i)->events, fmax(tolerance, 1e-10));
    }
    assert_int_equal(events, 2 * (6 + 7 + 9 + 7 + 6) + PUBLISHED_GAITS + 9 +
                                 6 /* a release with each clamp */ + 13 * 10 + 4 * 11 + 2 * 9 + 3 * 8 +
                                 6 * 7);
}

/* A hundredth past the apex, in which neither a loss nor the angle of lift-off changes any more but for the
 * damper's, whose leg is at rest by then. */
TEST(cvode_comes_back_to_the_apex) {
    skip_without_cvode();
    for (int i = 0; i < GAITS; ++i) {
        simulation run = begin(i, 1e-12);
        assert_int_equal(simulation_advance_by(tdmf_cvode_advance, &run, gait_at(i)->period + 0.01),
                         TDMF_ARRIVED);
        assert_is_gait(&run.motion, i, 1e-8);
    }
}

TEST(the_jacobian_of_further_gaits_is_that_of_the_reference) {
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        const tdmf_parameters parameters = parameters_of_further_gait(&further_gaits[i]);
        const tdmf_model model = accepted_model(&parameters);
        const tdmf_inputs inputs = inputs_of_further_gait(&further_gaits[i]);
        tdmf_solver solver = solver_to(1e-13);
        double section[TDMF_SECTION_COUNT];
        memcpy(section, &further_gaits[i].gait.apex, sizeof section);
        const tdmf_return stride =
            return_map(&solver, (tdmf_system){&model, &inputs}, section, 1e3, true, NULL, 0);
        assert_int_equal(stride.outcome, TDMF_RETURN_CLOSED);
        assert_true(assert_reference_jacobian(&stride, &further_gaits[i].gait));
    }
}
