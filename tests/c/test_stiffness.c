/* Runners too stiff for the native solver are given up in words, before they cost much, wherever they are
 * met; never as a fall. CVODE takes them. */
#include "compare.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};

static runner runner_of(const tdmf_parameters *parameters) {
    runner runner = runner_default(0.6);
    runner.model = accepted_model(parameters);
    return runner;
}

static double energy_missing(const runner *runner, const tdmf_motion *motion) {
    const double change =
        tdmf_mechanical_energy(SYSTEM_OF(runner), &motion->mode, motion->state).total -
        tdmf_mechanical_energy(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state).total;
    return change - motion->state[TDMF_HIP_WORK] + motion->state[TDMF_ENERGY_DAMPER_LOSS] +
           motion->state[TDMF_ENERGY_FRICTION_LOSS] + motion->record.impact_loss;
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
    tdmf_motion motion = runner->motion;
    tdmf_solver solver = tdmf_solver_default();
    const tdmf_outcome outcome = tdmf_native_advance(&solver, SYSTEM_OF(runner), &no_rates, 0.1, &motion);
    assert_int_equal(outcome, TDMF_TOO_STIFF);
    assert_true(solver.steps <= 1);
    assert_non_null(strstr(tdmf_outcome_text(outcome), "CVODE"));
    assert_false(motion.mode.fallen);
    assert_memory_equal(motion.state, runner->motion.state, sizeof motion.state);
}

TEST(coefficients_tell_a_stiff_runner_at_once) {
    for (int kind = 0; kind < STIFF_KINDS; ++kind) {
        const tdmf_parameters parameters = stiff_parameters(kind);
        runner flying = runner_of(&parameters);
        runner_start(&flying);
        assert_given_up_at_once(&flying);
    }
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.damping = 1e9;
    runner standing = runner_of(&parameters);
    memset(standing.motion.state, 0, sizeof standing.motion.state);
    standing.motion.state[TDMF_LEG_LENGTH] = 0.99;
    standing.motion.state[TDMF_LEG_ANGLE] = -0.1;
    runner_start(&standing);
    scene_assert_mode(&standing, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
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
        runner_start(&runner);
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = tdmf_solver_default();
        const tdmf_outcome outcome =
            tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 1.0, &motion);
        assert_true(outcome == TDMF_ARRIVED || outcome == TDMF_TOO_STIFF);
        assert_true(solver.steps <= TDMF_STIFFNESS_LIMIT);
        assert_true(outcome == TDMF_ARRIVED || solver.steps <= 1 || solver.steps == TDMF_STIFFNESS_LIMIT);
        assert_close(energy_missing(&runner, &motion), 0.0, 1e-9);
        arrived += outcome == TDMF_ARRIVED;
        by_counting += outcome == TDMF_TOO_STIFF && solver.steps > 1;
        at_once += outcome == TDMF_TOO_STIFF && solver.steps <= 1;
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
    runner_start(&runner);
    scene_assert_mode(&runner, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
    tdmf_motion motion = runner.motion;
    tdmf_solver solver = tdmf_solver_default();
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 100.0, &motion),
                     TDMF_TOO_STIFF);
    assert_int_equal(solver.steps, TDMF_STIFFNESS_LIMIT);
    assert_true(motion.time > 0.0 && motion.time < 1.0);
    assert_close(energy_missing(&runner, &motion), 0.0, 1e-9);
}

/* Over many times of sqrt(m/k), as many steps as a call allows. */
TEST(long_calls_may_make_more_steps) {
    const runner runner = runner_at_reference_apex(&reference_gaits[DEFAULT_GAIT]);
    tdmf_motion motion = runner.motion;
    tdmf_solver solver = solver_to(1e-14);
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 3e4, &motion), TDMF_ARRIVED);
    assert_true(solver.steps > 2 * TDMF_STIFFNESS_LIMIT);
}

TEST(cvode_takes_stiff_runners) {
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    const tdmf_parameters parameters = stiff_parameters(0);
    runner runner = runner_of(&parameters);
    runner.motion.state[TDMF_LEG_ANGLE] = 1.2; /* so much damping holds it there: the foot stays in the air */
    runner_start(&runner);
    tdmf_motion motion = runner.motion;
    tdmf_solver solver = tdmf_solver_default();
    assert_int_equal(tdmf_cvode_advance(&solver, SYSTEM_OF(&runner), &no_rates, 100.0, &motion),
                     TDMF_ARRIVED);
    assert_close(energy_missing(&runner, &motion), 0.0, 1e-8);
}

TEST(no_gait_is_said_not_to_be_found_for_a_fall) {
    const tdmf_parameters parameters = stiff_parameters(0);
    const runner runner = runner_of(&parameters);
    tdmf_solver solver = tdmf_solver_default();
    double section[TDMF_SECTION_COUNT];
    memcpy(section, &reference_gaits[DEFAULT_GAIT].apex, sizeof section);
    const tdmf_return stride = tdmf_return_map(&solver, SYSTEM_OF(&runner), section, 1e3, true, NULL, 0);
    assert_true(stride.outcome == TDMF_RETURN_UNSOLVED);
    assert_int_equal(stride.solver, TDMF_TOO_STIFF);
    const tdmf_orbit orbit = tdmf_find_orbit(&solver, SYSTEM_OF(&runner), section, NULL, 0);
    assert_int_equal(orbit.outcome, TDMF_ORBIT_UNSOLVED);
    assert_int_equal(orbit.stride.solver, TDMF_TOO_STIFF);
    assert_int_equal(tdmf_settle(&solver, SYSTEM_OF(&runner), 5, section), 0);
}
