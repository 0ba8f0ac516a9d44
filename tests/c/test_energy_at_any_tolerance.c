/* No outcome carries an energy that the ledger does not, however loose the tolerance and whatever the leg
 * does: not when the run arrives, nor when it falls, nor when it is given up. (Any runner:
 * test_declared_runs.c.) */
#include "compare.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

/* Above rounding and a few hundred steps' errors; energies from nothing were as large as all there is. */
static double allowed(double tolerance) {
    return 1e-12 + 30.0 * tolerance;
}

/* Of a leg whose rest length is its free length. */
static tdmf_energy energy_of(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    const tdmf_inputs inputs = tdmf_default_inputs();
    const tdmf_mode mode = {.contact = TDMF_CONTACT_FLIGHT};
    return tdmf_mechanical_energy((tdmf_system){model, &inputs}, &mode, state);
}

static double energy_in(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    const tdmf_energy energy = energy_of(model, state);
    return energy.kinetic + fabs(energy.potential) + energy.elastic;
}

/* How often a run ended how, of those that could start. */
typedef struct {
    int ended[TDMF_REFUSED + 1];
    int runs;
} tally;

static void run_and_check(const runner *runner, double tolerance, tally *seen) {
    enum { CALLS = 5 };
    static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};
    const tdmf_model *model = &runner->model;
    tdmf_solver solver = solver_to(tolerance);
    tdmf_outcome outcome = TDMF_ARRIVED;
    tdmf_motion motion;
    memset(&motion, 0, sizeof motion);
    memcpy(motion.state, runner->motion.state, sizeof motion.state);
    if (tdmf_start((tdmf_system){model, &runner->inputs}, &motion).variable) {
        return;
    }
    double largest = energy_in(model, runner->motion.state);
    for (int call = 0; call < CALLS && outcome == TDMF_ARRIVED; ++call) {
        outcome = tdmf_native_advance(&solver, (tdmf_system){model, &runner->inputs}, &no_rates,
                                      motion.time + 2.0 * model->scales.time, &motion);
        const double change =
            energy_of(model, motion.state).total - energy_of(model, runner->motion.state).total;
        const double booked = motion.state[TDMF_HIP_WORK] - motion.state[TDMF_ENERGY_DAMPER_LOSS] -
                              motion.state[TDMF_ENERGY_FRICTION_LOSS] - motion.record.impact_loss;
        largest = fmax(largest, energy_in(model, motion.state));
        assert_close(change / largest, booked / largest, allowed(tolerance));
    }
    ++seen->runs;
    ++seen->ended[outcome];
}

/* In flight, foot and body fly past each other so near that the leg turns by half a turn in next to no time:
 * what little angular momentum it has throws them apart, though at a loose tolerance it hardly showed before.
 */
static runner leg_about_to_vanish(random_source *source) {
    tdmf_parameters p = tdmf_default_parameters();
    p.leg.min_length = random_magnitude(source, 1e-6, 1e-4);
    p.leg.damping = random_chance(source, 0.5) ? 0.0 : random_magnitude(source, 1e-4, 1e-2);
    p.foot.mass = random_magnitude(source, 1e-3, 1.0);
    p.hip.kp = random_magnitude(source, 1e-6, 1e-2);
    p.hip.kd = random_magnitude(source, 1e-6, 1e-2);
    runner runner = runner_default(0.6);
    runner.model = accepted_model(&p);
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.motion.state[TDMF_FOOT_Y] = 100.0;
    runner.motion.state[TDMF_LEG_LENGTH] = random_uniform(source, 0.5, 20.0);
    runner.motion.state[TDMF_LEG_ANGLE] = random_uniform(source, -1.5, 1.5);
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = -random_magnitude(source, 1.0, 100.0);
    runner.motion.state[TDMF_LEG_ANGLE_RATE] =
        random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.1, 0.1);
    return runner;
}

TEST(of_legs_that_nearly_vanish) {
    enum { RUNS = sample_of(2000) };
    tally seen = {{0}, 0};
    random_source source = {21};
    for (int i = 0; i < RUNS; ++i) {
        const runner runner = leg_about_to_vanish(&source);
        run_and_check(&runner, random_magnitude(&source, 1e-5, 1e-2), &seen);
    }
    assert_int_equal(seen.runs, RUNS);
    assert_true(seen.ended[TDMF_ARRIVED] + seen.ended[TDMF_FELL] > RUNS / 2);
}

/* In flight under the closed clamp nothing turns it: a sum of exponentials, whose square, the damper's power,
 * has coefficients that fall later than theirs. */
static runner leg_that_does_not_turn(random_source *source) {
    tdmf_parameters p = tdmf_default_parameters();
    p.leg.damping = random_uniform(source, 0.1, 1.0);
    p.gravity = 1e-4;
    p.hip.liftoff_angle_factor = 0.5;
    runner runner = runner_default(0.6);
    runner.model = accepted_model(&p);
    runner.motion.state[TDMF_LEG_LENGTH] = random_uniform(source, 0.7, 1.3);
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = 0.0;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = 0.0;
    runner.motion.state[TDMF_FOOT_VY] = 0.2;
    return runner;
}

TEST(of_legs_that_do_not_turn) {
    enum { RUNS = sample_of(500) };
    tally seen = {{0}, 0};
    random_source source = {23};
    for (int i = 0; i < RUNS; ++i) {
        const runner runner = leg_that_does_not_turn(&source);
        run_and_check(&runner, random_magnitude(&source, 1e-14, 1e-12), &seen);
    }
    assert_int_equal(seen.ended[TDMF_ARRIVED], RUNS);
}

/* A servo of any strength begins to place a leg, which has turned by 1e-9 at the end: as a difference of two
 * angles, each rounded, that is known to seven digits, and so would be the work. */
TEST(of_servos_that_turn_a_leg_by_next_to_nothing) {
    enum { RUNS = sample_of(200) };
    static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};
    random_source source = {24};
    for (int i = 0; i < RUNS; ++i) {
        tdmf_parameters p = tdmf_default_parameters();
        p.hip.kp = random_magnitude(&source, 1e3, 1e12);
        p.hip.kd = 0.0;
        runner runner = runner_default(0.6);
        runner.model = accepted_model(&p);
        runner.motion.state[TDMF_FOOT_Y] = 10.0;
        runner.motion.state[TDMF_LEG_ANGLE] = p.hip.touchdown_angle + random_uniform(&source, 0.3, 0.6);
        runner.motion.state[TDMF_LEG_ANGLE_RATE] = 0.0;
        runner.motion.state[TDMF_FOOT_VY] = -10.0;
        runner_start(&runner);
        assert_int_equal(runner.motion.mode.phase, TDMF_PHASE_PLACE);
        const double before = energy_of(&runner.model, runner.motion.state).total;
        const double acceleration = (1.0 / p.body.mass + 1.0 / p.foot.mass) * p.hip.kp;
        tdmf_solver solver = solver_to(1e-13);
        assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates,
                                             sqrt(2e-9 / acceleration), &runner.motion),
                         TDMF_ARRIVED);
        const double work = runner.motion.state[TDMF_HIP_WORK];
        const double loss =
            runner.motion.state[TDMF_ENERGY_DAMPER_LOSS] + runner.motion.state[TDMF_ENERGY_FRICTION_LOSS];
        const double change = energy_of(&runner.model, runner.motion.state).total - before;
        assert_true(work > 1e-11 * p.hip.kp);
        assert_close(change, work - loss, 1e-12 * work + 1e-14 * before);
    }
}
