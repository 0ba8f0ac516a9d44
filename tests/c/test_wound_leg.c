/* A leg that has wound: its angle is never wrapped, and an angle of a thousand is known to 1e-13 only, which
 * is the guards' margin. What a solver finds due there and the model not must not hold a run up. */
#include "compare.h"
#include "integrate.h"
#include "random.h"
#include "sample.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

static const double turn = 6.283185307179586476925;
static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};

static tdmf_motion started(const runner *runner) {
    tdmf_motion motion = {.time = 0.0};
    memcpy(motion.state, runner->motion.state, sizeof motion.state);
    assert_null(tdmf_start(SYSTEM_OF(runner), &motion).variable);
    return motion;
}

static runner random_runner(random_source *source, double angle) {
    runner runner = runner_default(pow(10.0, random_uniform(source, -2.0, 3.0)));
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.model.parameters.leg.damping *= random_uniform(source, 0.0, 1.0);
    runner.motion.state[TDMF_FOOT_Y] = random_chance(source, 0.5) ? 0.0 : random_uniform(source, 0.0, 1.0);
    runner.motion.state[TDMF_LEG_LENGTH] = random_uniform(source, 0.95, 1.05);
    runner.motion.state[TDMF_LEG_ANGLE] = angle;
    runner.motion.state[TDMF_FOOT_VX] = random_uniform(source, -0.5, 0.5);
    runner.motion.state[TDMF_FOOT_VY] = random_uniform(source, -0.5, 0.0);
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = random_uniform(source, -0.5, 0.5);
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = random_uniform(source, -0.5, 0.5);
    return runner;
}

/* Without a hip nothing depends on how often the leg has wound. */
TEST(without_a_hip_turns_do_not_matter) {
    enum { RUNS = sample_of(300) };
    random_source source = {71};
    int events = 0, compared = 0;
    for (int i = 0; i < RUNS; ++i) {
        const double turns = floor(random_uniform(&source, -150.0, 151.0));
        runner runner = random_runner(&source, random_uniform(&source, -0.7, 0.7));
        runner.model.parameters.hip.kp = runner.model.parameters.hip.kd = 0.0;
        runner.model.parameters.hip.stance_torque = 0.0;
        tdmf_motion plain = started(&runner);
        runner.motion.state[TDMF_LEG_ANGLE] += turns * turn;
        tdmf_motion wound = started(&runner);
        tdmf_solver solver = tdmf_solver_default();
        const double until = 2.0;
        if (tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, until, &plain) != TDMF_ARRIVED) {
            continue;
        }
        assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, until, &wound),
                         TDMF_ARRIVED);
        wound.state[TDMF_LEG_ANGLE] -= turns * turn;
        for (int k = 0; k < TDMF_MECHANICAL_COUNT; ++k) {
            assert_close(wound.state[k], plain.state[k], 1e-9);
        }
        events += plain.record.event_count;
        ++compared;
    }
    assert_true(compared > 2 * RUNS / 3 && events > compared);
}

/* They spin, slip, bounce and fall, but nothing is found due for ever. */
TEST(wound_legs_run_until_they_fall) {
    enum { RUNS = sample_of(1500) };
    random_source source = {72};
    int fell = 0, arrived = 0;
    for (int i = 0; i < RUNS; ++i) {
        const double angle = floor(random_uniform(&source, -158.0, 158.0)) * turn;
        runner runner = random_runner(&source, angle + random_uniform(&source, -0.75, 0.75));
        runner.motion.state[TDMF_LEG_ANGLE_RATE] *= pow(10.0, random_uniform(&source, 0.0, 4.0));
        runner.model.parameters.hip.kp *= pow(10.0, random_uniform(&source, -6.0, 0.0));
        runner.model.parameters.hip.kd *= pow(10.0, random_uniform(&source, -6.0, 0.0));
        tdmf_motion motion = started(&runner);
        tdmf_solver solver = tdmf_solver_default();
        const tdmf_outcome outcome =
            tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 50.0, &motion);
        fell += outcome == TDMF_FELL;
        arrived += outcome == TDMF_ARRIVED;
    }
    assert_int_equal(fell + arrived, RUNS);
    assert_true(fell > RUNS / 15 && arrived > RUNS / 15);
}
