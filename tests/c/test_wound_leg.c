/* Legs that turn much. The angle is never wrapped, and an angle of a thousand is known to 1e-13 only, which
 * is the guards' margin: what a solver finds due there and the model not must not hold a run up. And the
 * hip's positive work on a leg that whirls about the body, a hundred times as long as at rest. */
#include "compare.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

static const double turn = 6.283185307179586476925;

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
        simulation plain = simulation_of(&runner, 1e-11);
        runner.motion.state[TDMF_LEG_ANGLE] += turns * turn;
        simulation wound = simulation_of(&runner, 1e-11);
        if (simulation_advance(&plain, 2.0) != TDMF_ARRIVED) {
            continue;
        }
        assert_int_equal(simulation_advance(&wound, 2.0), TDMF_ARRIVED);
        wound.motion.state[TDMF_LEG_ANGLE] -= turns * turn;
        assert_all_close(&wound.motion.state[TDMF_FOOT_X], &plain.motion.state[TDMF_FOOT_X],
                         TDMF_MECHANICAL_COUNT, 1e-9, 0.0);
        events += (int)plain.motion.state[TDMF_EVENT_COUNT];
        ++compared;
    }
    assert_true(compared > 2 * RUNS / 3 && events > compared);
}

/* They spin, slip, bounce and fall, but nothing is found due for ever. */
TEST(wound_legs_run_until_they_fall) {
    enum { RUNS = sample_of(1500) };
    random_source source = {72};
    int ended[TDMF_REFUSED + 1] = {0};
    for (int i = 0; i < RUNS; ++i) {
        const double angle = floor(random_uniform(&source, -158.0, 158.0)) * turn;
        runner runner = random_runner(&source, angle + random_uniform(&source, -0.75, 0.75));
        runner.motion.state[TDMF_LEG_ANGLE_RATE] *= pow(10.0, random_uniform(&source, 0.0, 4.0));
        runner.model.parameters.hip.kp *= pow(10.0, random_uniform(&source, -6.0, 0.0));
        runner.model.parameters.hip.kd *= pow(10.0, random_uniform(&source, -6.0, 0.0));
        simulation run = simulation_of(&runner, 1e-11);
        ++ended[simulation_advance(&run, 50.0)];
    }
    assert_int_equal(ended[TDMF_FELL] + ended[TDMF_ARRIVED], RUNS);
    assert_true(ended[TDMF_FELL] > RUNS / 15 && ended[TDMF_ARRIVED] > RUNS / 15);
}

/* The default runner starts from an apex with the leg at 0.3 rad. SciPy's DOP853 at 3e-14 has integrated the
 * two masses in flight for 100 s, split where torque or rate change their signs. */
TEST(a_whirling_leg_has_the_positive_work_of_an_independent_integration) {
    static const struct {
        double height, length, length_rate, angle_rate, positive_work, work;
    } whirls[] = {{200.0, 60.0, 0.0, 3.3, 1467.7408724758918, -2025.3082258834435},
                  {300.0, 100.0, 0.0, 0.5, 1340.4881196975, -112.12452334817},
                  {300.0, 20.0, 5.0, 2.0, 398.38098977454, -118.69706387470}};
    const tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_inputs inputs = tdmf_default_inputs();
    for (int i = 0; i < 3; ++i) {
        const double section[TDMF_SECTION_COUNT] = {
            whirls[i].height, 1.0, whirls[i].length, 0.3, whirls[i].length_rate, whirls[i].angle_rate};
        for (double tolerance = 1e-6; tolerance > 5e-15; tolerance *= 1e-2) {
            const double error = fmax(10.0 * tolerance, 1e-12);
            simulation run = simulation_from(&parameters, &inputs, section, tolerance);
            assert_int_equal(simulation_advance(&run, 100.0), TDMF_ARRIVED);
            assert_int_equal(run.motion.mode.contact, TDMF_CONTACT_FLIGHT);
            assert_relatively_close(run.motion.state[TDMF_HIP_POSITIVE_WORK], whirls[i].positive_work, error);
            assert_relatively_close(run.motion.state[TDMF_HIP_WORK], whirls[i].work, 10.0 * error);
        }
        if (tdmf_cvode_is_available()) {
            simulation run = simulation_from(&parameters, &inputs, section, 1e-12);
            assert_int_equal(simulation_advance_by(tdmf_cvode_advance, &run, 100.0), TDMF_ARRIVED);
            assert_relatively_close(run.motion.state[TDMF_HIP_POSITIVE_WORK], whirls[i].positive_work, 1e-8);
        }
    }
}
