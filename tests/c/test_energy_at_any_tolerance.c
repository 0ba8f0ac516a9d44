/* No outcome carries an energy that the ledger does not, however loose the tolerance and whatever the leg
 * does: not when the run arrives, nor when it falls, nor when it is given up. (Any runner:
 * test_declared_runs.c.) */
#include "compare.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>

static double energy_in(const simulation *run) {
    const tdmf_outputs now = OUTPUTS_OF(run);
    return now.energy.kinetic + fabs(now.energy.potential) + now.energy.elastic;
}

/* Above rounding and a few hundred steps' errors; energies from nothing were as large as all there is.
 * Returns how it ends. */
static tdmf_outcome run_and_check(const tdmf_parameters *p, const double state[TDMF_STATE_COUNT],
                                  double tolerance) {
    enum { CALLS = 5 };
    const tdmf_inputs inputs = tdmf_default_inputs();
    simulation run = simulation_in(p, &inputs, state, tolerance);
    double largest = energy_in(&run);
    tdmf_outcome outcome = TDMF_ARRIVED;
    for (int call = 0; call < CALLS && outcome == TDMF_ARRIVED; ++call) {
        outcome = simulation_advance(&run, run.motion.time + 2.0 * run.model.scales.time);
        largest = fmax(largest, energy_in(&run));
        assert_close(simulation_ledger_error(&run) / largest, 0.0, 1e-12 + 30.0 * tolerance);
    }
    return outcome;
}

/* In flight, foot and body fly past each other so closely that the leg turns by half a turn in next to no
 * time. Its small angular momentum throws them apart, though it was hardly resolved before at a loose
 * tolerance. */
TEST(legs_that_nearly_vanish_keep_the_ledger) {
    enum { RUNS = sample_of(2000) };
    random_source source = {21};
    int sound = 0;
    for (int i = 0; i < RUNS; ++i) {
        tdmf_parameters p = tdmf_default_parameters();
        p.leg.min_length = random_magnitude(&source, 1e-6, 1e-4);
        p.leg.damping = random_chance(&source, 0.5) ? 0.0 : random_magnitude(&source, 1e-4, 1e-2);
        p.foot.mass = random_magnitude(&source, 1e-3, 1.0);
        p.hip.kp = random_magnitude(&source, 1e-6, 1e-2);
        p.hip.kd = random_magnitude(&source, 1e-6, 1e-2);
        const double state[TDMF_STATE_COUNT] = {
            [TDMF_FOOT_Y] = 100.0,
            [TDMF_LEG_LENGTH] = random_uniform(&source, 0.5, 20.0),
            [TDMF_LEG_ANGLE] = random_uniform(&source, -1.5, 1.5),
            [TDMF_LEG_LENGTH_RATE] = -random_magnitude(&source, 1.0, 100.0),
            [TDMF_LEG_ANGLE_RATE] = random_chance(&source, 0.5) ? 0.0 : random_uniform(&source, -0.1, 0.1)};
        const tdmf_outcome outcome = run_and_check(&p, state, random_magnitude(&source, 1e-5, 1e-2));
        sound += outcome == TDMF_ARRIVED || outcome == TDMF_FELL;
    }
    assert_true(sound > RUNS / 2);
}

/* In flight under the closed clamp the leg does not turn. Its length is a sum of exponentials. The damper's
 * power is the square of such a sum, and its coefficients decrease later. */
TEST(legs_that_do_not_turn_keep_the_ledger) {
    random_source source = {23};
    for (int i = 0; i < sample_of(500); ++i) {
        tdmf_parameters p = tdmf_default_parameters();
        double state[TDMF_STATE_COUNT];
        tdmf_default_state(state);
        p.leg.damping = random_uniform(&source, 0.1, 1.0);
        p.gravity = 1e-4;
        p.hip.liftoff_angle_factor = 0.5;
        state[TDMF_LEG_LENGTH] = random_uniform(&source, 0.7, 1.3);
        state[TDMF_LEG_LENGTH_RATE] = 0.0;
        state[TDMF_LEG_ANGLE_RATE] = 0.0;
        state[TDMF_FOOT_VY] = 0.2;
        assert_int_equal(run_and_check(&p, state, random_magnitude(&source, 1e-14, 1e-12)), TDMF_ARRIVED);
    }
}

/* A servo of any strength begins to place a leg, which has turned by 1e-9 at the end: as a difference of two
 * angles, each rounded, that is known to seven digits, and so would be the work. */
TEST(servos_that_barely_turn_a_leg_keep_the_ledger) {
    const tdmf_inputs inputs = tdmf_default_inputs();
    random_source source = {24};
    for (int i = 0; i < sample_of(200); ++i) {
        tdmf_parameters p = tdmf_default_parameters();
        double state[TDMF_STATE_COUNT];
        tdmf_default_state(state);
        p.hip.kp = random_magnitude(&source, 1e3, 1e12);
        p.hip.kd = 0.0;
        state[TDMF_FOOT_Y] = 10.0;
        state[TDMF_LEG_ANGLE] = p.hip.touchdown_angle + random_uniform(&source, 0.3, 0.6);
        state[TDMF_LEG_ANGLE_RATE] = 0.0;
        state[TDMF_FOOT_VY] = -10.0;
        simulation run = simulation_in(&p, &inputs, state, 1e-13);
        assert_int_equal(run.motion.mode.phase, TDMF_PHASE_PLACE);
        const double acceleration = (1.0 / p.body.mass + 1.0 / p.foot.mass) * p.hip.kp;
        assert_int_equal(simulation_advance(&run, sqrt(2e-9 / acceleration)), TDMF_ARRIVED);
        const double work = run.motion.state[TDMF_HIP_WORK];
        assert_true(work > 1e-11 * p.hip.kp);
        assert_close(simulation_ledger_error(&run), 0.0, 1e-12 * work + 1e-14 * run.start_energy);
    }
}
