/* CVODE beside the native solver: limits and refusals of a call are the same.
 * That the two agree on a run is tested through the unit; here, that they do where a law reads the clock. */
#include "tdmf_slip/cvode.h"

#include "compare.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

static simulation begin(double tolerance) {
    const runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    return simulation_of(&runner, tolerance);
}

static tdmf_outcome advance(simulation *run, double until) {
    return simulation_advance_by(tdmf_cvode_advance, run, until);
}

TEST(limits_are_those_of_a_call) {
    skip_without_cvode();
    for (long limit = 0; limit < 3000; limit += 600) {
        simulation run = begin(1e-9);
        run.solver.step_limit = limit;
        assert_int_equal(advance(&run, 300.0), TDMF_TOO_MANY_STEPS);
        assert_int_equal(run.solver.steps, limit);
        assert_true(limit == 0 ? run.motion.time == 0.0 : run.motion.time > 0.005 * (double)limit);
        run.solver = solver_to(1e-9);
        assert_int_equal(advance(&run, 301.0), TDMF_ARRIVED);
        assert_int_equal(run.motion.state[TDMF_STRIDE_COUNT], 12);
    }
}

/* Lengths, times and masses are scaled by powers of two, so numbers change only their exponents. CVODE makes
 * the same steps but for the pivots of its linear solver. The pivots change results by the size of the
 * integration error, which in the period is a thousand times the tolerance of a step. */
TEST(another_scale_is_the_same_work) {
    static const double finer = 1e-11;
    static const int exponents[][3] = {{0, -10, 0}, {-8, 6, 3}, {10, -4, -5}, {0, 9, 0}};
    skip_without_cvode();
    simulation plain = begin(finer);
    assert_int_equal(advance(&plain, 60.0), TDMF_ARRIVED);
    assert_int_equal(plain.motion.state[TDMF_STRIDE_COUNT], 2);
    for (size_t i = 0; i < COUNT_OF(exponents); ++i) {
        const double length = ldexp(1.0, exponents[i][0]), time = ldexp(1.0, exponents[i][1]);
        const double mass = ldexp(1.0, exponents[i][2]);
        const factors by = {mass, mass / (time * time), length};
        simulation scaled = begin(finer);
        const tdmf_parameters parameters = scaled_parameters(scaled.model.parameters, &by);
        scaled.model = accepted_model(&parameters);
        for (int j = 0; j < TDMF_MECHANICAL_COUNT; ++j) {
            scaled.motion.state[TDMF_FOOT_X + j] *= factor_of_element(&by, TDMF_FOOT_X + j);
        }
        assert_null(tdmf_start(SYSTEM_OF(&scaled), &scaled.motion).variable);
        assert_int_equal(advance(&scaled, 60.0 * time), TDMF_ARRIVED);
        assert_relatively_close((double)scaled.solver.steps, (double)plain.solver.steps, 0.03);
        assert_relatively_close(last_stride_of(&scaled.motion).period,
                                last_stride_of(&plain.motion).period * time, 1e-7);
    }
}

/* Friction that is taken away from under a foot at rest, between two calls. */
TEST(an_input_that_has_jumped_is_met_before_the_first_step) {
    skip_without_cvode();
    simulation standing = begin(1e-9);
    assert_int_equal(advance(&standing, 10.0), TDMF_ARRIVED);
    while (standing.motion.mode.contact != TDMF_CONTACT_STICK) {
        assert_true(standing.motion.time < 30.0);
        assert_int_equal(advance(&standing, standing.motion.time + 0.05), TDMF_ARRIVED);
    }
    standing.inputs.ground.friction = 0.0;
    simulation by_native = standing;
    assert_int_equal(advance(&standing, standing.motion.time + 1e-4), TDMF_ARRIVED);
    assert_int_equal(simulation_advance(&by_native, by_native.motion.time + 1e-4), TDMF_ARRIVED);
    assert_true(tdmf_sign_of_slip(&standing.motion.mode) != 0.0);
    assert_int_equal(standing.motion.mode.contact, by_native.motion.mode.contact);
    assert_int_equal(standing.motion.state[TDMF_EVENT_COUNT], by_native.motion.state[TDMF_EVENT_COUNT]);
    assert_true(standing.motion.state[TDMF_FOOT_VX] != 0.0);
}
