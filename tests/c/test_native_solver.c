/* The native solver against the reference gaits, against the plain integrator of the tests, and against its
 * own limits. */
#include "compare.h"
#include "reference_gaits.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};

static void assert_arrives(tdmf_solver *solver, const runner *runner, double until, tdmf_motion *motion) {
    assert_int_equal(tdmf_native_advance(solver, SYSTEM_OF(runner), &no_rates, until, motion), TDMF_ARRIVED);
    assert_true(motion->time == until);
}

/* Without them the motion is the same, bit by bit, and the record but for them. */
TEST(peaks_and_positive_work_are_left_out) {
    for (size_t i = 0; i < REFERENCE_GAITS; ++i) {
        const runner runner = runner_at_reference_apex(&reference_gaits[i]);
        tdmf_motion with = runner.motion, without = runner.motion;
        tdmf_solver noting = tdmf_solver_default(), plain = tdmf_solver_default();
        plain.without_peaks_and_positive_work = true;
        for (int k = 0; k < 3; ++k) {
            assert_true(tdmf_native_stride(&noting, SYSTEM_OF(&runner), INFINITY, &with).closed);
            assert_true(tdmf_native_stride(&plain, SYSTEM_OF(&runner), INFINITY, &without).closed);
        }
        assert_int_equal(noting.steps, plain.steps);
        assert_int_equal(noting.events, plain.events);
        assert_true(with.record.stride.peak_force > 0.0 && with.record.stride.positive_work > 0.0);
        assert_true(without.record.stride.peak_force == 0.0 && without.record.stride.positive_work == 0.0);
        assert_true(without.record.stride.work == with.record.stride.work);
        assert_string_equal(without.record.stride.word, with.record.stride.word);
        without.state[TDMF_HIP_POSITIVE_WORK] = with.state[TDMF_HIP_POSITIVE_WORK];
        assert_memory_equal(without.state, with.state, sizeof with.state);
        assert_true(without.time == with.time);
    }
}

/* ---- accuracy ----------------------------------------------------------------------------------------- */

/* Event by event, as accurate as the solver can be. */
TEST(the_events_of_every_gait) {
    int events = 0;
    for (size_t i = 0; i < REFERENCE_GAITS; ++i) {
        const runner runner = runner_at_reference_apex(&reference_gaits[i]);
        tdmf_event_log log = {0};
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = solver_to(1e-13);
        solver.log = &log;
        assert_true(tdmf_native_stride(&solver, SYSTEM_OF(&runner), DBL_MAX, &motion).closed);
        assert_reference_stride(&motion, &reference_gaits[i], 1e-11);
        if (!reference_gaits[i].swing_clamp) {
            assert_relatively_close(motion.record.stride.positive_work, reference_gaits[i].positive_work,
                                    1e-11);
        }
        events += assert_reference_events(&log, reference_gaits[i].events, 1e-10);
    }
    assert_int_equal(events,
                     2 * (6 + 7 + 9 + 7 + 6) + PUBLISHED_GAITS + 9 + 6); /* a release with each clamp */
}

/* ---- the same events as the plain integrator ---------------------------------------------------------- */

static runner random_runner_near_the_gait(random_source *source) {
    runner runner = runner_default(random_magnitude(source, 0.1, 5.0));
    runner.model.parameters.hip.swing_clamp = random_truth(*source);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        runner.motion.state[i] *= random_uniform(source, 0.9, 1.1);
    }
    runner_start(&runner);
    return runner;
}

TEST(random_runs_have_the_same_events) {
    enum { RUNS = sample_of(60) };
    random_source source = {2016};
    for (int i = 0; i < RUNS; ++i) {
        runner runner = random_runner_near_the_gait(&source);
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = tdmf_solver_default();
        while (runner.motion.time < 60.0 && runner_advance(&runner, 2e-3)) {
        }
        const tdmf_outcome outcome =
            tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, runner.motion.time, &motion);
        assert_int_equal(outcome, runner.motion.mode.fallen ? TDMF_FELL : TDMF_ARRIVED);
        assert_int_equal(motion.record.event_count, runner.motion.record.event_count);
        assert_string_equal(motion.record.stride.word, runner.motion.record.stride.word);
        for (int k = 0; k < TDMF_MECHANICAL_COUNT; ++k) {
            assert_close(motion.state[k], runner.motion.state[k], 1e-6);
        }
        assert_close(motion.state[TDMF_HIP_POSITIVE_WORK], runner.motion.state[TDMF_HIP_POSITIVE_WORK], 1e-6);
    }
}

/* The foot swings through the ground and back within one step: a leg that oscillates fast above a slow fall.
 */
TEST(a_touch_that_turns_back_is_found) {
    for (double clearance = -1e-4; clearance < 2e-4; clearance += 2e-4) {
        runner runner = runner_default(0.6);
        tdmf_parameters parameters = runner.model.parameters;
        parameters.leg.damping = 0.0;
        parameters.hip.kp = 0.0;
        parameters.hip.kd = 0.0;
        parameters.gravity = 1e-6;
        runner.model = accepted_model(&parameters);
        memset(runner.motion.state, 0, sizeof runner.motion.state);
        runner.motion.state[TDMF_LEG_LENGTH] = 0.9; /* swings to 1.1 and back in 1.9 time units */
        const double lowest = 0.2 / 1.1;
        runner.motion.state[TDMF_FOOT_Y] = lowest + clearance;
        runner_start(&runner);
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = tdmf_solver_default();
        solver.relative_tolerance = 1e-6; /* long steps */
        assert_arrives(&solver, &runner, 1.8, &motion);
        assert_int_equal(motion.record.progress.open.touchdowns, clearance < 0.0 ? 1 : 0);
    }
}

/* A leg without a servo spins for ever at the rate at which its spring holds the masses together, and long
 * steps would do, but for the foot's height, which is a sine of it. */
typedef struct {
    double com_y, drop, gravity, angle, rate; /* of the foot below the center of mass, and of the spin */
} spinning_fall;

static double foot_height(const spinning_fall *fall, double t) {
    return fall->com_y - 0.5 * fall->gravity * t * t - fall->drop * cos(fall->angle + fall->rate * t);
}

static double first_touchdown(const spinning_fall *fall) {
    const double look = 1e-3;
    double from = 0.0;
    while (foot_height(fall, from + look) > 0.0) {
        from += look;
    }
    double to = from + look;
    while (to - from > 1e-14 * to) {
        const double middle = 0.5 * (from + to);
        *(foot_height(fall, middle) > 0.0 ? &from : &to) = middle;
    }
    return to;
}

static runner spinning_runner(random_source *source, spinning_fall *fall) {
    runner runner = runner_default(0.6);
    tdmf_parameters p = runner.model.parameters;
    p.hip.kp = 0.0;
    p.hip.kd = 0.0;
    runner.model = accepted_model(&p);
    const double inverse_reduced_mass = 1.0 / p.body.mass + 1.0 / p.foot.mass;
    const double rate = random_uniform(source, 1.2, 2.0) * (random_chance(source, 0.5) ? 1.0 : -1.0);
    const double stiffness = inverse_reduced_mass * p.leg.stiffness;
    const double length = stiffness * p.leg.free_length / (stiffness - rate * rate);
    const double section[TDMF_SECTION_COUNT] = {random_uniform(source, 2.0, 6.0),  0.0, length,
                                                random_uniform(source, -3.0, 3.0), 0.0, rate};
    tdmf_section_state(SYSTEM_OF(&runner), section, runner.motion.state);
    runner_start(&runner);
    fall->com_y = section[TDMF_SECTION_COM_HEIGHT];
    fall->drop = length * p.body.mass / (p.body.mass + p.foot.mass);
    fall->gravity = p.gravity;
    fall->angle = section[TDMF_SECTION_LEG_ANGLE];
    fall->rate = rate;
    return runner;
}

TEST(a_spinning_leg_touches_down_in_time) {
    enum { FALLS = sample_of(200) };
    random_source source = {881};
    for (int i = 0; i < FALLS; ++i) {
        spinning_fall fall;
        const runner runner = spinning_runner(&source, &fall);
        const double touchdown = first_touchdown(&fall);
        tdmf_event_log log = {0};
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = tdmf_solver_default();
        solver.log = &log;
        tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, touchdown + 1e-6, &motion);
        int first = 0;
        while (first < log.count && log.events[first].guard != TDMF_GUARD_TOUCHDOWN) {
            ++first;
        }
        assert_true(first < log.count);
        assert_close(log.events[first].time, touchdown, 1e-9);
    }
}

/* ---- inputs that change ------------------------------------------------------------------------------- */

/* A friction that falls to zero in mid-stance stays there, as if it had been held there from then on. */
TEST(a_friction_that_falls_ends_at_zero) {
    const double zero = 13.0, until = 20.0;
    const tdmf_inputs falling = {.ground.friction = -0.6 / zero};
    runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    runner.inputs.ground.friction = 0.6;
    tdmf_motion at_once = runner.motion;
    tdmf_motion in_two = at_once;
    tdmf_solver solver = tdmf_solver_default();
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &falling, until, &at_once),
                     TDMF_ARRIVED);
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &falling, zero, &in_two), TDMF_ARRIVED);
    assert_true(tdmf_in_contact(&in_two.mode));
    runner.inputs.ground.friction = 0.0;
    assert_arrives(&solver, &runner, until, &in_two);
    for (int k = 0; k < TDMF_STATE_COUNT; ++k) {
        assert_close(at_once.state[k], in_two.state[k], 1e-9);
    }
}

/* A runner that stands and bounces without loss. */
static runner bouncing_runner(void) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.damping = 0.0;
    runner runner = runner_default(0.6);
    runner.model = accepted_model(&parameters);
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.motion.state[TDMF_LEG_LENGTH] = 0.99;
    runner.motion.state[TDMF_LEG_ANGLE] = -1e-12;
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = -0.005;
    runner_start(&runner);
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    return runner;
}

/* All peaks of such a bounce are the same, and the second is found as the first was. */
TEST(every_peak_of_the_force_is_met) {
    const double period = 6.283185307179586;
    const runner runner = bouncing_runner();
    tdmf_motion motion = runner.motion;
    tdmf_solver solver = tdmf_solver_default();
    assert_arrives(&solver, &runner, 0.9 * period, &motion);
    const double first = motion.record.progress.open.peak_force;
    assert_arrives(&solver, &runner, period, &motion);
    motion.record.progress.open.peak_force = 0.0;
    assert_arrives(&solver, &runner, 2.5 * period, &motion);
    assert_close(motion.record.progress.open.peak_force, first, 1e-9);
}

/* The force at the end of a call counts, as an input may jump then. */
TEST(a_rising_force_is_met_where_a_call_ends) {
    const runner runner = bouncing_runner();
    tdmf_motion motion = runner.motion;
    tdmf_solver solver = tdmf_solver_default();
    assert_arrives(&solver, &runner, 0.2, &motion);
    const tdmf_outputs outputs = tdmf_outputs_of(SYSTEM_OF(&runner), &motion);
    assert_true(motion.mode.ground_force_rising);
    assert_close(motion.record.progress.open.peak_force, outputs.contact.fy, 1e-15);
}

/* ---- limits ------------------------------------------------------------------------------------------- */

TEST(limits_end_a_call_and_leave_a_valid_motion) {
    const runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    tdmf_motion motion = runner.motion;
    tdmf_solver solver = tdmf_solver_default();
    solver.step_limit = 10;
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 100.0, &motion),
                     TDMF_TOO_MANY_STEPS);
    solver.step_limit = 100000;
    solver.event_limit = 2;
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 100.0, &motion),
                     TDMF_TOO_MANY_EVENTS);
    assert_true(motion.time > 10.0 && motion.time < 100.0);
    solver.event_limit = 100000;
    assert_arrives(&solver, &runner, 4.1 * reference_gaits[DEFAULT_GAIT].period, &motion);
    assert_int_equal(motion.record.stride.count, 4);
}

/* Also where the fall is in the last step, or the last event, that the limits allow. */
TEST(a_fall_is_a_fall_under_any_limit) {
    runner runner = runner_default(0.6);
    runner.motion.state[TDMF_FOOT_Y] = 100.0;
    runner_start(&runner);
    for (int i = 0; i < 2; ++i) {
        tdmf_solver solver = tdmf_solver_default();
        long *limit = i == 0 ? &solver.event_limit : &solver.step_limit;
        tdmf_motion motion = runner.motion;
        for (*limit = 0; !motion.mode.fallen; ++*limit) {
            motion = runner.motion;
            const tdmf_outcome outcome =
                tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 1e4, &motion);
            assert_int_equal(outcome, motion.mode.fallen ? TDMF_FELL
                                      : i == 0           ? TDMF_TOO_MANY_EVENTS
                                                         : TDMF_TOO_MANY_STEPS);
        }
    }
}

/* ---- calls that do nothing ---------------------------------------------------------------------------- */

static void assert_refused(const runner *runner, double tolerance, tdmf_inputs inputs, tdmf_inputs rates,
                           double until) {
    tdmf_motion motion = runner->motion;
    const tdmf_motion before = motion;
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = tolerance;
    assert_int_equal(
        tdmf_native_advance(&solver, (tdmf_system){&runner->model, &inputs}, &rates, until, &motion),
        TDMF_REFUSED);
    assert_memory_equal(&motion, &before, sizeof motion);
    assert_int_equal(solver.steps, 0);
}

TEST(requests_without_sense_are_refused) {
    static const double no_tolerances[] = {0.0, -1e-11, 1.0, INFINITY, NAN};
    static const double no_numbers[] = {NAN, INFINITY, -INFINITY};
    runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    runner.motion.time = 1.0;
    for (size_t i = 0; i < sizeof no_tolerances / sizeof no_tolerances[0]; ++i) {
        assert_refused(&runner, no_tolerances[i], runner.inputs, no_rates, 30.0);
    }
    for (size_t i = 0; i < sizeof no_numbers / sizeof no_numbers[0]; ++i) {
        tdmf_inputs inputs = runner.inputs;
        tdmf_inputs rates = no_rates;
        inputs.ground.friction = no_numbers[i];
        assert_refused(&runner, 1e-9, inputs, no_rates, 30.0);
        inputs = runner.inputs;
        inputs.hip.external_torque = no_numbers[i];
        assert_refused(&runner, 1e-9, inputs, no_rates, 30.0);
        rates.ground.friction = no_numbers[i];
        assert_refused(&runner, 1e-9, runner.inputs, rates, 30.0);
        rates = no_rates;
        rates.hip.external_torque = no_numbers[i];
        assert_refused(&runner, 1e-9, runner.inputs, rates, 30.0);
    }
    const tdmf_inputs leaving[] = {{.ground.friction = 1e5}, {.hip.external_torque = 1e17}};
    for (size_t i = 0; i < sizeof leaving / sizeof leaving[0]; ++i) {
        assert_refused(&runner, 1e-9, runner.inputs, leaving[i], 30.0); /* by then out of range */
    }
    assert_refused(&runner, 1e-9, runner.inputs, no_rates, NAN);
    assert_refused(&runner, 1e-9, runner.inputs, no_rates, 0.5);
    assert_non_null(strstr(tdmf_outcome_text(TDMF_REFUSED), "out of range"));
}

TEST(a_call_for_no_time_changes_nothing) {
    random_source source = {64};
    for (int i = 0; i < 200; ++i) {
        const runner runner = random_runner_near_the_gait(&source);
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = tdmf_solver_default();
        const double until = random_uniform(&source, 0.0, 30.0);
        tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, until, &motion);
        const tdmf_motion before = motion;
        tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, motion.time, &motion);
        assert_memory_equal(motion.state, before.state, sizeof motion.state);
    }
}
