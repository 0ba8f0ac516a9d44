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

static void assert_arrives(simulation *run, double until) {
    assert_int_equal(simulation_advance(run, until), TDMF_ARRIVED);
    assert_true(run->motion.time == until);
}

/* Without them the motion is the same, bit by bit, and the record but for them. */
TEST(peaks_and_positive_work_are_left_out) {
    static const int observed[] = {TDMF_HIP_POSITIVE_WORK,         TDMF_STRIDE_POSITIVE_WORK_THEN,
                                   TDMF_STRIDE_POSITIVE_WORK,      TDMF_STRIDE_PEAK_FORCE_SO_FAR,
                                   TDMF_STRIDE_VERTICAL_SO_FAR,    TDMF_STRIDE_PEAK_FORCE,
                                   TDMF_STRIDE_PEAK_VERTICAL_FORCE};
    for (size_t i = 0; i < REFERENCE_GAITS; ++i) {
        const runner runner = runner_at_reference_apex(&reference_gaits[i]);
        simulation noting = simulation_of(&runner, 1e-11), plain = noting;
        plain.solver.without_peaks_and_positive_work = true;
        for (int k = 0; k < 3; ++k) {
            simulation_stride(&noting);
            simulation_stride(&plain);
        }
        const tdmf_stride with = last_stride_of(&noting.motion), without = last_stride_of(&plain.motion);
        assert_int_equal(noting.solver.steps, plain.solver.steps);
        assert_int_equal(noting.solver.events, plain.solver.events);
        assert_true(with.peak_force > 0.0 && with.positive_work > 0.0);
        assert_true(without.peak_force == 0.0 && without.positive_work == 0.0);
        assert_true(without.work == with.work);
        assert_string_equal(without.word, with.word);
        for (size_t k = 0; k < sizeof observed / sizeof *observed; ++k) {
            plain.motion.state[observed[k]] = noting.motion.state[observed[k]];
        }
        assert_memory_equal(plain.motion.state, noting.motion.state, sizeof noting.motion.state);
        assert_true(plain.motion.time == noting.motion.time);
    }
}

/* ---- the same events as the plain integrator ---------------------------------------------------------- */

static runner random_runner_near_the_gait(random_source *source) {
    runner runner = runner_default(random_magnitude(source, 0.1, 5.0));
    runner.model.parameters.hip.swing_clamp = random_truth(*source);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        runner.motion.state[TDMF_FOOT_X + i] *= random_uniform(source, 0.9, 1.1);
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
        assert_int_equal(motion.state[TDMF_EVENT_COUNT], runner.motion.state[TDMF_EVENT_COUNT]);
        assert_string_equal(last_stride_of(&motion).word, last_stride_of(&runner.motion).word);
        assert_all_close(&motion.state[TDMF_FOOT_X], &runner.motion.state[TDMF_FOOT_X], TDMF_MECHANICAL_COUNT,
                         1e-6, 0.0);
        assert_close(motion.state[TDMF_HIP_POSITIVE_WORK], runner.motion.state[TDMF_HIP_POSITIVE_WORK], 1e-6);
    }
}

/* The foot swings through the ground and back within one step: a leg that oscillates fast above a slow fall.
 */
TEST(a_touch_that_turns_back_is_found) {
    for (double clearance = -1e-4; clearance < 2e-4; clearance += 2e-4) {
        runner runner = runner_default(0.6);
        runner.model.parameters.leg.damping = 0.0;
        runner.model.parameters.hip.kp = runner.model.parameters.hip.kd = 0.0;
        runner.model.parameters.gravity = 1e-6;
        memset(runner.motion.state, 0, sizeof runner.motion.state);
        runner.motion.state[TDMF_LEG_LENGTH] = 0.9; /* swings to 1.1 and back in 1.9 time units */
        const double lowest = 0.2 / 1.1;
        runner.motion.state[TDMF_FOOT_Y] = lowest + clearance;
        simulation run = simulation_of(&runner, 1e-6);
        assert_arrives(&run, 1.8);
        assert_int_equal(run.motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR], clearance < 0.0 ? 1 : 0);
    }
}

/* A leg without a servo spins for ever at the rate at which its spring holds the masses together, and long
 * steps would do, but for the foot's height, which is a sine of it. */
typedef struct {
    double com_y, drop, gravity, angle, rate; /* the foot's drop below the centre of mass, and the spin */
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
    runner.model.parameters.hip.kp = runner.model.parameters.hip.kd = 0.0;
    const tdmf_parameters p = runner.model.parameters;
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
        simulation run = simulation_of(&runner, 1e-11);
        simulation_advance(&run, touchdown + 1e-6);
        const tdmf_event *first = simulation_event(&run, TDMF_GUARD_TOUCHDOWN);
        assert_non_null(first);
        assert_close(first->time, touchdown, 1e-9);
    }
}

/* ---- inputs that change ------------------------------------------------------------------------------- */

/* A friction that falls to zero in mid-stance stays there, as if it had been held there from then on. */
TEST(a_friction_that_falls_ends_at_zero) {
    const double zero = 13.0, until = 20.0;
    runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    runner.inputs.ground.friction = 0.6;
    simulation at_once = simulation_of(&runner, 1e-11);
    at_once.rates.ground.friction = -0.6 / zero;
    simulation in_two = at_once;
    assert_arrives(&at_once, until);
    assert_arrives(&in_two, zero);
    assert_true(tdmf_is_loaded(&in_two.motion.mode));
    in_two.inputs.ground.friction = in_two.rates.ground.friction = 0.0;
    assert_arrives(&in_two, until);
    assert_same_state(&at_once.motion, &in_two.motion, 1e-9);
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
    simulation run = simulation_of(&runner, 1e-11);
    assert_arrives(&run, 0.9 * period);
    const double first = run.motion.state[TDMF_STRIDE_PEAK_FORCE_SO_FAR];
    assert_arrives(&run, period);
    run.motion.state[TDMF_STRIDE_PEAK_FORCE_SO_FAR] = 0.0;
    assert_arrives(&run, 2.5 * period);
    assert_close(run.motion.state[TDMF_STRIDE_PEAK_FORCE_SO_FAR], first, 1e-9);
}

/* The force at the end of a call counts, as an input may jump then. */
TEST(a_rising_force_is_met_where_a_call_ends) {
    const runner runner = bouncing_runner();
    simulation run = simulation_of(&runner, 1e-11);
    assert_arrives(&run, 0.2);
    const tdmf_outputs outputs = OUTPUTS_OF(&run);
    assert_true(run.motion.mode.ground_force_rising);
    assert_close(run.motion.state[TDMF_STRIDE_PEAK_FORCE_SO_FAR], outputs.contact.fy, 1e-15);
}

/* ---- limits ------------------------------------------------------------------------------------------- */

TEST(limits_end_a_call_and_leave_a_valid_motion) {
    const runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    simulation run = simulation_of(&runner, 1e-11);
    run.solver.step_limit = 10;
    assert_int_equal(simulation_advance(&run, 100.0), TDMF_TOO_MANY_STEPS);
    run.solver.step_limit = 100000;
    run.solver.event_limit = 2;
    assert_int_equal(simulation_advance(&run, 100.0), TDMF_TOO_MANY_EVENTS);
    assert_true(run.motion.time > 10.0 && run.motion.time < 100.0);
    run.solver.event_limit = 100000;
    assert_arrives(&run, 4.1 * reference_gaits[DEFAULT_GAIT].period);
    assert_int_equal(run.motion.state[TDMF_STRIDE_COUNT], 4);
}

/* Also where the fall is in the last step, or the last event, that the limits allow. */
TEST(a_fall_is_a_fall_under_any_limit) {
    runner runner = runner_default(0.6);
    runner.motion.state[TDMF_FOOT_Y] = 100.0;
    for (int i = 0; i < 2; ++i) {
        const tdmf_outcome given_up = i == 0 ? TDMF_TOO_MANY_EVENTS : TDMF_TOO_MANY_STEPS;
        tdmf_outcome outcome = given_up;
        for (long limit = 0; outcome != TDMF_FELL; ++limit) {
            simulation run = simulation_of(&runner, 1e-11);
            *(i == 0 ? &run.solver.event_limit : &run.solver.step_limit) = limit;
            outcome = simulation_advance(&run, 1e4);
            assert_int_equal(outcome, run.motion.mode.fallen ? TDMF_FELL : given_up);
        }
    }
}

/* ---- calls that do nothing ---------------------------------------------------------------------------- */

static void assert_refused(const runner *runner, double tolerance, tdmf_inputs inputs, tdmf_inputs rates,
                           double until) {
    solver_call *const solvers[] = {tdmf_native_advance, tdmf_cvode_advance};
    for (int i = 0; i < 1 + tdmf_cvode_is_available(); ++i) {
        tdmf_motion motion = runner->motion;
        tdmf_solver solver = solver_to(tolerance);
        assert_int_equal(solvers[i](&solver, (tdmf_system){&runner->model, &inputs}, &rates, until, &motion),
                         TDMF_REFUSED);
        assert_memory_equal(&motion, &runner->motion, sizeof motion);
        assert_int_equal(solver.steps, 0);
    }
}

TEST(requests_without_sense_are_refused) {
    static const double no_tolerances[] = {0.0, -1e-11, 1.0, INFINITY, NAN};
    static const double no_numbers[] = {NAN, INFINITY, -INFINITY};
    runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    const tdmf_inputs sound = runner.inputs;
    runner.motion.time = 1.0;
    for (int i = 0; i < 5; ++i) {
        assert_refused(&runner, no_tolerances[i], sound, no_rates, 30.0);
    }
    for (int i = 0; i < 3; ++i) {
        tdmf_inputs friction = sound, torque = sound;
        friction.ground.friction = torque.hip.external_torque = no_numbers[i];
        const tdmf_inputs rates[] = {{.ground.friction = no_numbers[i]},
                                     {.hip.external_torque = no_numbers[i]}};
        assert_refused(&runner, 1e-9, friction, no_rates, 30.0);
        assert_refused(&runner, 1e-9, torque, no_rates, 30.0);
        assert_refused(&runner, 1e-9, sound, rates[0], 30.0);
        assert_refused(&runner, 1e-9, sound, rates[1], 30.0);
    }
    const tdmf_inputs leaving[] = {{.ground.friction = 1e5}, {.hip.external_torque = 1e17}};
    assert_refused(&runner, 1e-9, sound, leaving[0], 30.0); /* out of range at that time */
    assert_refused(&runner, 1e-9, sound, leaving[1], 30.0);
    assert_refused(&runner, 1e-9, sound, no_rates, NAN);
    assert_refused(&runner, 1e-9, sound, no_rates, 0.5);
    assert_non_null(strstr(tdmf_outcome_text(TDMF_REFUSED), "out of range"));
}

TEST(a_call_for_no_time_changes_nothing) {
    random_source source = {64};
    for (int i = 0; i < 200; ++i) {
        const runner runner = random_runner_near_the_gait(&source);
        simulation run = simulation_of(&runner, 1e-11);
        const double until = random_uniform(&source, 0.0, 30.0);
        simulation_advance(&run, until);
        const tdmf_motion before = run.motion;
        simulation_advance(&run, run.motion.time);
        assert_memory_equal(run.motion.state, before.state, sizeof run.motion.state);
    }
}
