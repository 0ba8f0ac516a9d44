/* A run does not know what time it is: its strides are those of a run that starts at 0, though the clock may
 * count the seconds of an epoch and be coarser than a mode is long. */
#include "compare.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"

#include <float.h>
#include <math.h>

static const double start_times[] = {-3.0, 1.7e9, -1e13, 1e15, 1e17};
enum { START_TIMES = COUNT_OF(start_times) };

static simulation start_at(const reference_gait *gait, double bend, double time, double tolerance) {
    const runner runner = runner_at_reference_apex(gait);
    simulation run = simulation_of(&runner, tolerance);
    run.motion.state[TDMF_LEG_ANGLE] += bend;
    run.motion.time = time;
    assert_null(tdmf_start(SYSTEM_OF(&run), &run.motion).variable);
    return run;
}

/* Runs seven calls of 16 s, which end at whole numbers even at 1e17; the last ends after a few strides. */
static void run_on(solver_call *advance, simulation *run) {
    const double start = run->motion.time;
    run->rates = (tdmf_inputs){.ground.friction = 1e-4, .hip.external_torque = 1e-5};
    for (int i = 1; i <= 7; ++i) {
        const double until = start + 16.0 * i;
        assert_int_equal(simulation_advance_by(advance, run, until), TDMF_ARRIVED);
        assert_true(run->motion.time == until);
        run->inputs = tdmf_inputs_after(&run->inputs, &run->rates, 16.0);
    }
}

/* The clock's digits decide neither events nor durations. */
static void assert_independent(solver_call *advance, double tolerance, double agreement) {
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        simulation at_zero = start_at(&reference_gaits[i], 0.01, 0.0, tolerance);
        run_on(advance, &at_zero);
        for (int k = 0; k < START_TIMES; ++k) {
            simulation later = start_at(&reference_gaits[i], 0.01, start_times[k], tolerance);
            run_on(advance, &later);
            assert_int_equal(later.motion.state[TDMF_STRIDE_COUNT], at_zero.motion.state[TDMF_STRIDE_COUNT]);
            assert_same_stride(last_stride_of(&later.motion), last_stride_of(&at_zero.motion), agreement);
            assert_close(last_apex_of(&later.motion).time - start_times[k],
                         last_apex_of(&at_zero.motion).time, DBL_EPSILON * fabs(start_times[k]) + 1e-9);
            assert_same_state(&later.motion, &at_zero.motion, 10.0 * agreement);
        }
    }
}

TEST(strides_of_the_native_solver) {
    assert_independent(tdmf_native_advance, 1e-11, 1e-12);
}

TEST(strides_of_cvode) {
    skip_without_cvode();
    assert_independent(tdmf_cvode_advance, 1e-12, 1e-8);
}

TEST(strides_one_by_one) {
    const reference_gait *gait = &reference_gaits[DEFAULT_GAIT];
    for (int k = 0; k < START_TIMES; ++k) {
        simulation run = start_at(gait, 0.0, start_times[k], tdmf_solver_default().relative_tolerance);
        for (int i = 0; i < 10; ++i) {
            assert_true(tdmf_native_stride(&run.solver, SYSTEM_OF(&run), INFINITY, &run.motion).closed);
            assert_relatively_close(last_stride_of(&run.motion).period, gait->period, 1e-9);
            assert_string_equal(last_stride_of(&run.motion).word, gait->word);
        }
    }
}

/* A new time set by the caller replaces both the old time and its rounding remainder. */
TEST(a_time_set_anew_is_taken_as_it_is) {
    simulation run = start_at(&reference_gaits[DEFAULT_GAIT], 0.0, 1.7e9, 1e-11);
    simulation_stride(&run);
    simulation moved = run;
    moved.motion.time = 8.0;
    assert_int_equal(simulation_advance(&moved, 9.0), TDMF_ARRIVED);
    assert_true(moved.motion.time == 9.0 && moved.motion.clock_rest == 0.0);
    assert_int_equal(simulation_advance(&run, run.motion.time + 1.0), TDMF_ARRIVED);
    assert_all_close(&run.motion.state[TDMF_FOOT_X], &moved.motion.state[TDMF_FOOT_X], TDMF_MECHANICAL_COUNT,
                     1e-6, 1e-6);
    assert_int_equal(simulation_advance(&moved, 29.0), TDMF_ARRIVED);
    assert_int_equal(simulation_advance(&run, run.motion.time + 20.0), TDMF_ARRIVED);
    assert_int_equal(moved.motion.state[TDMF_EVENT_COUNT], run.motion.state[TDMF_EVENT_COUNT]);
}

TEST(before_the_first_event_the_last_one_was_at_the_start) {
    static const double times[] = {0.0, 5.0, 1.7e9};
    for (size_t k = 0; k < COUNT_OF(times); ++k) {
        const simulation run = start_at(&reference_gaits[DEFAULT_GAIT], 0.0, times[k], 1e-11);
        assert_int_equal(OUTPUTS_OF(&run).event.count, 0);
        assert_true(OUTPUTS_OF(&run).event.last_time == times[k]);
    }
}

TEST(a_hop_later_than_the_clock_keeps_no_foot_from_landing) {
    const reference_gait *gait = &reference_gaits[DEFAULT_GAIT];
    simulation run = start_at(gait, 0.0, 0.0, 1e-11);
    run.motion.state[TDMF_HIP_HAS_HOPPED] = 1.0;
    run.motion.state[TDMF_HIP_HOP_TIME] = 1e9;
    assert_int_equal(simulation_advance(&run, 4.1 * gait->period), TDMF_ARRIVED);
    assert_int_equal(run.motion.state[TDMF_STRIDE_COUNT], 4);
    assert_string_equal(last_stride_of(&run.motion).word, gait->word);
}
