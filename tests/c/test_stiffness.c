/* Runners too stiff for the native solver are given up in words, before they cost much, wherever they are
 * met; never as a fall. CVODE takes them. */
#include "compare.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

static runner runner_of(const tdmf_parameters *parameters) {
    runner runner = runner_default(0.6);
    runner.model = accepted_model(parameters);
    return runner;
}

/* One value of Table 1 made so large, or the foot so light, that no step is long enough. */
enum { STIFF_KINDS = 5 };
static tdmf_parameters stiff_parameters(int kind) {
    tdmf_parameters p = tdmf_default_parameters();
    double *const stiffened[STIFF_KINDS] = {&p.hip.kd, &p.hip.kd, &p.leg.damping, &p.hip.kp, &p.foot.mass};
    static const double values[STIFF_KINDS] = {2.5e13, 1e18, 1e12, 1e18, 1e-12};
    *stiffened[kind] = values[kind];
    return p;
}

static void assert_given_up_at_once(const runner *runner) {
    simulation run = simulation_of(runner, 1e-11);
    const tdmf_motion before = run.motion;
    const tdmf_outcome outcome = simulation_advance(&run, 0.1);
    assert_int_equal(outcome, TDMF_TOO_STIFF);
    assert_true(run.solver.steps <= 1);
    assert_non_null(strstr(tdmf_outcome_text(outcome), "CVODE"));
    assert_false(run.motion.mode.fallen);
    assert_memory_equal(run.motion.state, before.state, sizeof before.state);
}

TEST(coefficients_tell_a_stiff_runner_at_once) {
    for (int kind = 0; kind < STIFF_KINDS; ++kind) {
        const tdmf_parameters parameters = stiff_parameters(kind);
        const runner flying = runner_of(&parameters);
        assert_given_up_at_once(&flying);
    }
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.damping = 1e9;
    runner standing = runner_of(&parameters);
    memset(standing.motion.state, 0, sizeof standing.motion.state);
    standing.motion.state[TDMF_LEG_LENGTH] = 0.99;
    standing.motion.state[TDMF_LEG_ANGLE] = -0.1;
    assert_given_up_at_once(&standing);
}

/* The more damping, the more steps, up to the limit and never beyond; what was reached then is sound. */
TEST(no_call_makes_more_steps_than_the_limit) {
    enum { RUNS = 60 };
    int arrived = 0, by_counting = 0, at_once = 0;
    random_source source = {20};
    for (int i = 0; i < RUNS; ++i) {
        tdmf_parameters parameters = tdmf_default_parameters();
        parameters.hip.kd = random_magnitude(&source, 1.0, 1e6);
        parameters.foot.mass = random_magnitude(&source, 1e-7, 0.1);
        runner runner = runner_of(&parameters);
        runner.motion.state[TDMF_FOOT_Y] = random_uniform(&source, 0.9, 1.1);
        simulation run = simulation_of(&runner, 1e-11);
        const tdmf_outcome outcome = simulation_advance(&run, 1.0);
        const int64_t steps = run.solver.steps;
        assert_true(outcome == TDMF_ARRIVED || outcome == TDMF_TOO_STIFF);
        assert_true(steps <= TDMF_STIFFNESS_LIMIT);
        assert_true(outcome == TDMF_ARRIVED || steps <= 1 || steps == TDMF_STIFFNESS_LIMIT);
        assert_close(simulation_ledger_error(&run), 0.0, 1e-9);
        arrived += outcome == TDMF_ARRIVED;
        by_counting += outcome == TDMF_TOO_STIFF && steps > 1;
        at_once += outcome == TDMF_TOO_STIFF && steps <= 1;
    }
    assert_true(arrived > 5 && at_once > 5);
    assert_int_equal(arrived + by_counting + at_once, RUNS);
}

/* A slip may be over before it is too long: the same light foot that is refused in flight may slide. */
TEST(in_slip_the_steps_are_counted) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.foot.mass = 1e-9;
    runner runner = runner_of(&parameters);
    runner.inputs.ground.friction = 0.01;
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.motion.state[TDMF_LEG_LENGTH] = 0.9;
    runner.motion.state[TDMF_LEG_ANGLE] = -0.5;
    runner.motion.state[TDMF_FOOT_VX] = -0.1;
    simulation run = simulation_of(&runner, 1e-11);
    assert_int_equal(run.motion.mode.contact, TDMF_CONTACT_SLIP_NEGATIVE);
    assert_int_equal(simulation_advance(&run, 100.0), TDMF_TOO_STIFF);
    assert_int_equal(run.solver.steps, TDMF_STIFFNESS_LIMIT);
    assert_true(run.motion.time > 0.0 && run.motion.time < 1.0);
    assert_close(simulation_ledger_error(&run), 0.0, 1e-9);
}

/* Over many times of sqrt(m/k), as many steps as a call allows. */
TEST(long_calls_may_make_more_steps) {
    const runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    simulation run = simulation_of(&runner, 1e-14);
    assert_int_equal(simulation_advance(&run, 3e4), TDMF_ARRIVED);
    assert_true(run.solver.steps > 2 * TDMF_STIFFNESS_LIMIT);
}

TEST(cvode_takes_stiff_runners) {
    skip_without_cvode();
    const tdmf_parameters parameters = stiff_parameters(0);
    runner runner = runner_of(&parameters);
    runner.motion.state[TDMF_LEG_ANGLE] = 1.2; /* strong damping holds it there: the foot stays in the air */
    simulation run = simulation_of(&runner, 1e-11);
    assert_int_equal(simulation_advance_by(tdmf_cvode_advance, &run, 100.0), TDMF_ARRIVED);
    assert_close(simulation_ledger_error(&run), 0.0, 1e-8);
}

TEST(no_gait_is_said_not_to_be_found_for_a_fall) {
    const tdmf_parameters parameters = stiff_parameters(0);
    const runner runner = runner_of(&parameters);
    tdmf_solver solver = tdmf_solver_default();
    double section[TDMF_SECTION_COUNT];
    memcpy(section, &reference_gaits[DEFAULT_GAIT].apex, sizeof section);
    const tdmf_return stride = return_map(&solver, SYSTEM_OF(&runner), section, 1e3, true, NULL, 0);
    assert_true(stride.outcome == TDMF_RETURN_UNSOLVED);
    assert_int_equal(stride.solver, TDMF_TOO_STIFF);
    const tdmf_orbit orbit = find_orbit(TDMF_RETURN_MAP, &solver, SYSTEM_OF(&runner), section, NULL, 0);
    assert_int_equal(orbit.outcome, TDMF_ORBIT_UNSOLVED);
    assert_int_equal(orbit.stride.solver, TDMF_TOO_STIFF);
    assert_int_equal(settle(TDMF_RETURN_MAP, &solver, SYSTEM_OF(&runner), 5, section), 0);
}
