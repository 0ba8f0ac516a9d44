/* CVODE on the reference gaits, and beside the native solver: limits and refusals of a call are the same.
 * That the two agree on a run is tested through the unit; here, that they do where a law reads the clock. */
#include "tdmf_slip/cvode.h"

#include "compare.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};

typedef struct {
    runner runner;
    tdmf_motion motion;
    tdmf_solver solver;
} run;

static run begin(const reference_gait *gait) {
    run run;
    memset(&run, 0, sizeof run);
    run.runner = runner_at_reference_apex(gait);
    run.solver = tdmf_solver_default();
    run.motion = run.runner.motion;
    run.solver.relative_tolerance = 1e-9;
    return run;
}

static tdmf_outcome advance(run *run, double until) {
    return tdmf_cvode_advance(&run->solver, SYSTEM_OF(&run->runner), &no_rates, until, &run->motion);
}

TEST(a_stride_of_every_gait) {
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    for (int i = 0; i < REFERENCE_GAITS; ++i) {
        run run = begin(&reference_gaits[i]);
        run.solver.relative_tolerance = 1e-12;
        assert_int_equal(advance(&run, reference_gaits[i].period + 0.01), TDMF_ARRIVED);
        assert_reference_stride(&run.motion, &reference_gaits[i], 1e-8);
        if (!reference_gaits[i].swing_clamp) {
            assert_relatively_close(run.motion.record.stride.positive_work, reference_gaits[i].positive_work,
                                    1e-8);
        }
    }
}

TEST(limits_are_those_of_a_call) {
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    for (long limit = 0; limit < 3000; limit += 600) {
        run run = begin(&reference_gaits[DEFAULT_GAIT]);
        run.solver.step_limit = limit;
        assert_int_equal(advance(&run, 300.0), TDMF_TOO_MANY_STEPS);
        assert_int_equal(run.solver.steps, limit);
        assert_true(limit == 0 ? run.motion.time == 0.0 : run.motion.time > 0.005 * (double)limit);
        run.solver = tdmf_solver_default();
        run.solver.relative_tolerance = 1e-9;
        assert_int_equal(advance(&run, 301.0), TDMF_ARRIVED);
        assert_int_equal(run.motion.record.stride.count, 12);
    }
}

TEST(requests_without_sense_are_refused) {
    run run = begin(&reference_gaits[DEFAULT_GAIT]);
    const tdmf_motion before = run.motion;
    assert_int_equal(advance(&run, NAN), TDMF_REFUSED);
    assert_int_equal(advance(&run, -1.0), TDMF_REFUSED);
    run.solver.relative_tolerance = NAN;
    assert_int_equal(advance(&run, 1.0), TDMF_REFUSED);
    run.solver.relative_tolerance = 1e-9;
    run.runner.inputs.ground.friction = NAN;
    assert_int_equal(advance(&run, 1.0), TDMF_REFUSED);
    assert_memory_equal(&run.motion, &before, sizeof before);
}

/* Lengths, times and masses scaled by powers of two: every number is the same but for its exponent, and CVODE
 * makes the same steps, but for the pivots of its linear solver. What these change is of the size of an
 * integration's own error, which in the period is a thousand times the tolerance of a step. */
TEST(another_scale_is_the_same_work) {
    static const double finer = 1e-11;
    static const int exponents[][3] = {{0, -10, 0}, {-8, 6, 3}, {10, -4, -5}, {0, 9, 0}};
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    run plain = begin(&reference_gaits[DEFAULT_GAIT]);
    plain.solver.relative_tolerance = finer;
    assert_int_equal(advance(&plain, 60.0), TDMF_ARRIVED);
    assert_int_equal(plain.motion.record.stride.count, 2);
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; ++i) {
        const double length = ldexp(1.0, exponents[i][0]), time = ldexp(1.0, exponents[i][1]);
        const double mass = ldexp(1.0, exponents[i][2]);
        const factors by = {mass, mass / (time * time), length};
        run scaled = begin(&reference_gaits[DEFAULT_GAIT]);
        scaled.solver.relative_tolerance = finer;
        const tdmf_parameters parameters = scaled_parameters(scaled.runner.model.parameters, &by);
        scaled.runner.model = accepted_model(&parameters);
        for (int j = 0; j < TDMF_MECHANICAL_COUNT; ++j) {
            scaled.motion.state[j] *= factor_of_element(&by, j);
        }
        assert_null(tdmf_start(SYSTEM_OF(&scaled.runner), &scaled.motion).variable);
        assert_int_equal(advance(&scaled, 60.0 * time), TDMF_ARRIVED);
        assert_relatively_close((double)scaled.solver.steps, (double)plain.solver.steps, 0.03);
        assert_relatively_close(scaled.motion.record.stride.period, plain.motion.record.stride.period * time,
                                1e-7);
    }
}

/* Friction that is taken away from under a foot at rest, between two calls. */
TEST(an_input_that_has_jumped_is_met_before_the_first_step) {
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    run standing = begin(&reference_gaits[DEFAULT_GAIT]);
    assert_int_equal(advance(&standing, 10.0), TDMF_ARRIVED);
    while (standing.motion.mode.contact != TDMF_CONTACT_STICK) {
        assert_true(standing.motion.time < 30.0);
        assert_int_equal(advance(&standing, standing.motion.time + 0.05), TDMF_ARRIVED);
    }
    standing.runner.inputs.ground.friction = 0.0;
    run by_native = standing;
    assert_int_equal(advance(&standing, standing.motion.time + 1e-4), TDMF_ARRIVED);
    assert_int_equal(tdmf_native_advance(&by_native.solver, SYSTEM_OF(&by_native.runner), &no_rates,
                                         by_native.motion.time + 1e-4, &by_native.motion),
                     TDMF_ARRIVED);
    assert_true(tdmf_slip_sign(&standing.motion.mode) != 0.0);
    assert_int_equal(standing.motion.mode.contact, by_native.motion.mode.contact);
    assert_int_equal(standing.motion.record.event_count, by_native.motion.record.event_count);
    assert_true(standing.motion.state[TDMF_FOOT_VX] != 0.0);
}

/* CVODE does not integrate the clock; its steps read it all the same. */
TEST(a_leg_that_is_retracted_goes_by_the_clock) {
    int in_place = 0, others = 0;
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    run run = begin(&reference_gaits[DEFAULT_GAIT]);
    tdmf_parameters retracted = run.runner.model.parameters;
    retracted.hip.retraction_rate = 0.01;
    run.runner.model = accepted_model(&retracted);
    tdmf_motion native = run.motion;
    tdmf_solver native_solver = run.solver;
    run.solver.relative_tolerance = 1e-11;
    for (int i = 1; i <= 40; ++i) {
        const double until = 1.3 * i;
        assert_int_equal(advance(&run, until), TDMF_ARRIVED);
        assert_int_equal(
            tdmf_native_advance(&native_solver, SYSTEM_OF(&run.runner), &no_rates, until, &native),
            TDMF_ARRIVED);
        const bool is_placing = run.motion.mode.phase == TDMF_PHASE_PLACE;
        assert_true(is_placing == (run.motion.state[TDMF_HIP_PLACE_TIME] > 0.0));
        assert_close(run.motion.state[TDMF_HIP_PLACE_TIME], native.state[TDMF_HIP_PLACE_TIME], 1e-6);
        assert_close(run.motion.state[TDMF_LEG_ANGLE], native.state[TDMF_LEG_ANGLE], 1e-6);
        in_place += is_placing;
        others += !is_placing;
    }
    assert_int_equal(run.motion.record.stride.count, native.record.stride.count);
    assert_true(in_place > 5 && others > 5);
}
