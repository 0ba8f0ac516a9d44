/* A run does not know what time it is: its strides are those of a run that starts at 0, though the clock may
 * count the seconds of an epoch and be coarser than a mode is long. */
#include "compare.h"
#include "instant.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double start_times[] = {-3.0, 1.7e9, -1e13, 1e15, 1e17};
enum { START_TIMES = sizeof start_times / sizeof start_times[0] };

static tdmf_motion start_at(const runner *runner, double time) {
    tdmf_motion motion;
    memset(&motion, 0, sizeof motion);
    motion.time = time;
    memcpy(motion.state, runner->motion.state, sizeof motion.state);
    assert_null(tdmf_start(SYSTEM_OF(runner), &motion).variable);
    return motion;
}

static runner runner_at_gait(const reference_gait *gait) {
    runner runner = runner_at_reference_apex(gait);
    runner.motion.state[TDMF_LEG_ANGLE] += 0.01;
    return runner;
}

static void assert_same_stride(const tdmf_stride *a, const tdmf_stride *b, double tolerance) {
    assert_int_equal(a->count, b->count);
    assert_string_equal(a->word, b->word);
    assert_int_equal(a->touchdowns, b->touchdowns);
    assert_relatively_close(a->period, b->period, tolerance);
    assert_relatively_close(a->length, b->length, tolerance);
    assert_relatively_close(a->speed, b->speed, tolerance);
    assert_relatively_close(a->work, b->work, tolerance);
    assert_relatively_close(a->positive_work, b->positive_work, tolerance);
    assert_relatively_close(a->stance_time, b->stance_time, tolerance);
    assert_relatively_close(a->duty_factor, b->duty_factor, tolerance);
    assert_close(a->slip_distance, b->slip_distance, tolerance);
    assert_relatively_close(a->peak_force, b->peak_force, tolerance);
    assert_relatively_close(a->peak_vertical_force, b->peak_vertical_force, tolerance);
}

/* In calls that end where the clock can tell; the last of them ends after a few strides. */
static void run_on(solver_call *advance, const runner *runner, double tolerance, double call, int calls,
                   tdmf_motion *motion) {
    static const tdmf_inputs ramp = {.ground.friction = 1e-4, .hip.external_torque = 1e-5};
    const double start = motion->time;
    tdmf_inputs inputs = runner->inputs;
    for (int i = 1; i <= calls; ++i) {
        tdmf_solver solver = tdmf_solver_default();
        solver.relative_tolerance = tolerance;
        const double until = start + call * i;
        assert_int_equal(advance(&solver, (tdmf_system){&runner->model, &inputs}, &ramp, until, motion),
                         TDMF_ARRIVED);
        assert_true(motion->time == until);
        inputs = tdmf_inputs_after(&inputs, &ramp, call);
    }
}

/* The clock's digits decide neither events nor durations. Calls of 16 s end at whole numbers, even at 1e17.
 */
static void assert_independent(solver_call *advance, double tolerance, double agreement) {
    int compared = 0;
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        const runner runner = runner_at_gait(&reference_gaits[i]);
        tdmf_motion at_zero = start_at(&runner, 0.0);
        run_on(advance, &runner, tolerance, 16.0, 7, &at_zero);
        for (int k = 0; k < START_TIMES; ++k) {
            tdmf_motion later = start_at(&runner, start_times[k]);
            run_on(advance, &runner, tolerance, 16.0, 7, &later);
            assert_same_stride(&later.record.stride, &at_zero.record.stride, agreement);
            assert_close(later.record.apex.time - start_times[k], at_zero.record.apex.time,
                         DBL_EPSILON * fabs(start_times[k]) + 1e-9);
            for (int s = 0; s < TDMF_STATE_COUNT; ++s) {
                assert_close(later.state[s], at_zero.state[s], 10.0 * agreement);
            }
            ++compared;
        }
    }
    assert_int_equal(compared, REFERENCE_GAITS / EVERY_OTHER * START_TIMES);
}

TEST(strides_of_the_native_solver) {
    assert_independent(tdmf_native_advance, 1e-11, 1e-12);
}

TEST(strides_of_cvode) {
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    assert_independent(tdmf_cvode_advance, 1e-12, 1e-8);
}

TEST(strides_one_by_one) {
    const runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    for (int k = 0; k < START_TIMES; ++k) {
        tdmf_motion motion = start_at(&runner, start_times[k]);
        tdmf_solver solver = tdmf_solver_default();
        for (int i = 0; i < 10; ++i) {
            assert_true(tdmf_native_stride(&solver, SYSTEM_OF(&runner), INFINITY, &motion).closed);
            assert_relatively_close(motion.record.stride.period, reference_gaits[DEFAULT_GAIT].period, 1e-9);
            assert_string_equal(motion.record.stride.word, reference_gaits[DEFAULT_GAIT].word);
        }
    }
}

/* An instant is good to twice the digits of a double, whatever is added in between. */
TEST(instants_lose_nothing) {
    enum { PARTS = 100000 };
    const tdmf_instant start = {1.7e9, 0.0};
    const double step = 0x1.23456789abcdep-20;
    tdmf_instant now = start;
    for (int i = 0; i < PARTS; ++i) {
        now = tdmf_instant_after(now, step);
        assert_true(now.time + now.rest == now.time);
    }
    assert_relatively_close(tdmf_time_between(start, now), PARTS * step, 1e-15);
    now = tdmf_instant_after(now, -PARTS * step);
    assert_close(tdmf_time_between(start, now), 0.0, 1e-17);
}

/* Where somebody sets the time anew, what rounding left out of the old one is gone with it. */
TEST(a_time_set_anew_is_taken_as_it_is) {
    const runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    tdmf_motion motion = start_at(&runner, 1.7e9);
    tdmf_solver solver = tdmf_solver_default();
    assert_true(tdmf_native_stride(&solver, SYSTEM_OF(&runner), INFINITY, &motion).closed);
    tdmf_motion moved = motion;
    moved.time = 8.0;
    static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 9.0, &moved), TDMF_ARRIVED);
    assert_true(moved.time == 9.0 && moved.record.progress.now.time == 9.0 &&
                moved.record.progress.now.rest == 0.0);
    const tdmf_instant end = tdmf_instant_after(motion.record.progress.now, 1.0);
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, end.time, &motion),
                     TDMF_ARRIVED);
    for (int s = 0; s < TDMF_STATE_COUNT; ++s) {
        assert_close(motion.state[s], moved.state[s], 1e-6);
    }
}
