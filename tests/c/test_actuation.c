/* Thrust of the leg, changes of its rest length and pushes on the body: their rules, and their place in the
 * energy ledger, by the native solver and CVODE. */
#include "compare.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

/* ---- a run --------------------------------------------------------------------------------------------- */

static simulation begin(double thrust, double tolerance) {
    simulation run = {.inputs = tdmf_default_inputs(), .solver = solver_to(tolerance)};
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.thrust = thrust;
    run.model = accepted_model(&parameters);
    tdmf_default_state(run.motion.state);
    simulation_start(&run);
    return run;
}

/* ---- ramps --------------------------------------------------------------------------------------------- */

enum { PARTS = 24 };
static const double duration = 3.1;

static tdmf_inputs random_rates(random_source *source) {
    tdmf_inputs rates = {.ground = {.friction = random_uniform(source, -0.02, 0.02)}};
    rates.hip.external_torque = random_uniform(source, -2e-3, 2e-3);
    rates.leg.extension = random_uniform(source, -5e-3, 5e-3);
    rates.body.external_fx = random_uniform(source, -1e-3, 1e-3);
    rates.body.external_fy = random_uniform(source, -1e-3, 1e-3);
    return rates;
}

/* Up and down again, so that the runner runs on. */
static simulation ramped(uint64_t seed, solver_call *advance, double tolerance, double ledger_tolerance) {
    random_source source = {seed};
    simulation run = begin(0.03, tolerance);
    tdmf_inputs rates = {.ground = {.friction = 0.0}};
    for (int i = 0; i < PARTS; ++i) {
        const double until = run.motion.time + duration;
        if (i % 2 == 0) {
            rates = random_rates(&source);
        } else {
            double *values = (double *)&rates;
            for (size_t k = 0; k < sizeof rates / sizeof *values; ++k) {
                values[k] = -values[k];
            }
        }
        assert_int_equal(advance(&run.solver, SYSTEM_OF(&run), &rates, until, &run.motion), TDMF_ARRIVED);
        run.inputs = tdmf_inputs_after(&run.inputs, &rates, duration);
        assert_close(simulation_ledger_error(&run), 0.0, ledger_tolerance);
    }
    return run;
}

TEST(ramps_of_every_input_close_the_ledger_and_agree_with_cvode) {
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        const simulation native = ramped(seed, tdmf_native_advance, 1e-12, 1e-11);
        assert_true(native.motion.state[TDMF_STRIDE_COUNT] >= 1);
        assert_true(native.motion.state[TDMF_LEG_WORK] != 0.0);
        if (tdmf_cvode_is_available()) {
            const simulation other = ramped(seed, tdmf_cvode_advance, 1e-11, 1e-8);
            assert_all_close(native.motion.state, other.motion.state, TDMF_STATE_COUNT, 1e-6, 0.0);
            assert_int_equal(native.motion.state[TDMF_EVENT_COUNT], other.motion.state[TDMF_EVENT_COUNT]);
        }
    }
}

/* ---- the rules of thrust ------------------------------------------------------------------------------- */

static const double thrust = 0.05;

static runner standing_leg(double length_rate, double leg_thrust) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -0.3, 0.2);
    runner.model.parameters.leg.thrust = leg_thrust;
    runner.motion.time = 1.0; /* after the start */
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = length_rate;
    return runner;
}

static double work_of_thrust(const runner *runner, double by) {
    const tdmf_parameters *p = &runner->model.parameters;
    const double compression = p->leg.free_length - runner->motion.state[TDMF_LEG_LENGTH];
    return 0.5 * p->leg.stiffness * by * (by + 2.0 * compression);
}

TEST(thrust_begins_where_the_leg_stops_shortening_and_outlasts_it) {
    runner runner = standing_leg(-1e-3, thrust);
    scene_resolve(&runner);
    assert_false(runner.motion.mode.thrusts);
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = 1e-9;
    assert_true(scene_resolve(&runner).mode_changed);
    assert_true(runner.motion.mode.thrusts);
    assert_int_equal(runner.motion.state[TDMF_EVENT_COUNT], 1);
    assert_close(runner.motion.state[TDMF_LEG_WORK], work_of_thrust(&runner, thrust), 1e-15);
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = -0.1;
    scene_resolve(&runner);
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = 0.1;
    scene_resolve(&runner);
    assert_true(runner.motion.mode.thrusts);
    assert_int_equal(runner.motion.state[TDMF_EVENT_COUNT], 1);
}

TEST(a_thrust_of_zero_is_noted_and_acts_where_it_is_set) {
    runner runner = standing_leg(1e-3, 0.0);
    assert_false(scene_resolve(&runner).mode_changed);
    assert_true(runner.motion.mode.thrusts);
    assert_int_equal(runner.motion.state[TDMF_EVENT_COUNT], 0);
    assert_true(runner.motion.state[TDMF_LEG_WORK] == 0.0);
    runner.inputs.control.thrust = thrust;
    const tdmf_resolution resolution = scene_resolve(&runner);
    assert_true(resolution.state_changed && resolution.mode_changed);
    assert_close(runner.motion.state[TDMF_LEG_WORK], work_of_thrust(&runner, thrust), 1e-15);
    runner.inputs.leg.extension = 0.01;
    scene_resolve(&runner);
    assert_close(runner.motion.state[TDMF_LEG_WORK], work_of_thrust(&runner, thrust + 0.01), 1e-15);
}

/* Along a stance of the native solver, in which nothing asks for the flag. */
TEST(the_native_solver_notes_a_thrust_of_zero) {
    simulation run = begin(0.0, 1e-11);
    while (!tdmf_is_loaded(&run.motion.mode) || run.motion.state[TDMF_LEG_LENGTH_RATE] < 0.0) {
        assert_false(run.motion.mode.thrusts);
        assert_int_equal(simulation_advance(&run, run.motion.time + 0.05), TDMF_ARRIVED);
    }
    assert_true(run.motion.mode.thrusts);
    while (tdmf_is_loaded(&run.motion.mode)) {
        simulation_advance(&run, run.motion.time + 0.01);
    }
    assert_int_equal(run.motion.mode.contact, TDMF_CONTACT_GRAZE);
    assert_true(run.motion.mode.thrusts);
    while (run.motion.mode.contact == TDMF_CONTACT_GRAZE) {
        simulation_advance(&run, run.motion.time + 0.01);
    }
    assert_int_equal(run.motion.mode.contact, TDMF_CONTACT_FLIGHT);
    assert_false(run.motion.mode.thrusts);
}

TEST(an_impact_on_a_lengthening_leg_thrusts_before_it_is_asked_whether_it_stays) {
    runner thrusting = scene_at_impact(TDMF_PHASE_PLACE, -0.3, -0.02);
    thrusting.motion.time = 1.0; /* after the start */
    runner free = thrusting;
    thrusting.model.parameters.leg.thrust = 0.5;
    thrusting.motion.state[TDMF_LEG_LENGTH_RATE] += 0.3;
    free.motion.state[TDMF_LEG_LENGTH_RATE] += 0.3;
    scene_resolve(&thrusting);
    scene_resolve(&free);
    assert_true(tdmf_is_loaded(&thrusting.motion.mode) && thrusting.motion.mode.thrusts);
    assert_int_equal(thrusting.motion.state[TDMF_EVENT_COUNT], 1);
    assert_false(tdmf_is_loaded(&free.motion.mode));
}

TEST(graze_keeps_thrust_and_does_not_start_it) {
    for (int on = 0; on < 2; ++on) {
        runner runner = scene_on_ground(TDMF_CONTACT_GRAZE, -0.3, -0.01);
        runner.motion.state[TDMF_LEG_LENGTH_RATE] = 0.1;
        runner.motion.state[TDMF_LEG_ANGLE_RATE] = -2.0;
        scene_set_vertical_force(&runner, -0.01);
        runner.motion.mode.thrusts = on == 1;
        scene_resolve(&runner);
        assert_int_equal(runner.motion.mode.contact, TDMF_CONTACT_GRAZE);
        assert_int_equal(runner.motion.mode.thrusts, on);
        scene_set_vertical_force(&runner, 0.1);
        scene_resolve(&runner);
        assert_true(tdmf_is_loaded(&runner.motion.mode) && runner.motion.mode.thrusts);
    }
}

/* ---- pushes -------------------------------------------------------------------------------------------- */

/* Lifted in place, the runner rises; let go, it passes a second apex, with a word that is empty. */
TEST(a_runner_lifted_in_place_passes_a_second_apex) {
    simulation run = begin(0.0, 1e-11);
    run.inputs.body.external_fy = 0.05;
    simulation_advance(&run, 6.0);
    assert_int_equal(run.motion.mode.phase, TDMF_PHASE_PLACE);
    assert_true(tdmf_center_of_mass(&run.model, run.motion.state).vy > 0.1);
    assert_int_equal(run.motion.state[TDMF_STRIDE_COUNT], 0);
    run.inputs.body.external_fy = 0.0;
    simulation_advance(&run, 30.0);
    assert_int_equal(run.motion.state[TDMF_STRIDE_COUNT], 1);
    assert_string_equal(last_stride_of(&run.motion).word, "");
    assert_close(run.motion.state[TDMF_HIP_PLACE_TIME], 30.0 - last_apex_of(&run.motion).time, 1e-12);
    assert_close(simulation_ledger_error(&run), 0.0, 1e-12);
}

/* The push grows and fades within one call: the solver has to see the rise and the apex itself. */
TEST(a_push_that_ramps_may_lift_and_drop_in_place) {
    const tdmf_inputs grows = {.body = {.external_fy = 0.02}}, fades = {.body = {.external_fy = -0.02}};
    for (int i = 0; i < 2; ++i) {
        simulation run = begin(0.0, 1e-11);
        solver_call *const advance = i == 0 ? tdmf_native_advance : tdmf_cvode_advance;
        if (i == 1 && !tdmf_cvode_is_available()) {
            continue;
        }
        advance(&run.solver, SYSTEM_OF(&run), &grows, 3.0, &run.motion);
        run.inputs.body.external_fy = 0.06;
        advance(&run.solver, SYSTEM_OF(&run), &fades, 12.0, &run.motion);
        assert_int_equal(run.motion.state[TDMF_STRIDE_COUNT], 1);
        /* vy(t) = integral of F/M - g, with F = 0.02 t to 3, then 0.06 - 0.02 (t - 3). */
        const double mass = 1.1, g = 0.01, peak = 0.09 / mass - 3.0 * g;
        const double a = 0.01 / mass, b = 0.06 / mass - g;
        const double apex = 3.0 + (b + sqrt(b * b + 4.0 * a * peak)) / (2.0 * a);
        assert_close(last_apex_of(&run.motion).time, apex, i == 0 ? 1e-9 : 1e-6);
    }
}
