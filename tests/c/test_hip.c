/* The hip's control law by phase, with Table 1: tau0 = 0.2, kp = kd = 0.1, eta = 1.2, theta0 = 40 degrees. */
#include "compare.h"
#include "scene.h"

#include <math.h>

static const double touchdown_angle = 0.69813170079773179; /* 40 degrees */

static double torque_of(const runner *runner) {
    return tdmf_hip_torque(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state);
}

static runner leg_in_flight(tdmf_hip_phase phase, double angle, double angle_rate) {
    runner runner = scene_in_flight(phase, 0.1);
    runner.motion.state[TDMF_LEG_ANGLE] = angle;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = angle_rate;
    runner.motion.mode.liftoff_angle = -0.5;
    return runner;
}

static runner leg_in_drive(void) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.3, 0.3);
    runner.motion.mode.phase = TDMF_PHASE_DRIVE;
    runner.motion.mode.mid_stance_pending = true;
    return runner;
}

/* The first correction: in forward running theta falls, and the stance torque must do positive work. */
TEST(drive_does_positive_work_in_forward_running) {
    runner runner = leg_in_drive();
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = -1.0;
    double derivatives[TDMF_STATE_COUNT];
    tdmf_derivatives(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state, derivatives);
    assert_close(torque_of(&runner), -0.2, 1e-17);
    assert_close(derivatives[TDMF_HIP_WORK], 0.2, 1e-17);
}

TEST(coast_applies_nothing) {
    const runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.3, 0.3);
    assert_true(torque_of(&runner) == 0.0);
}

/* The second correction: retract stops the leg's backward swing with a positive torque... */
TEST(retract_stops_the_backward_swing) {
    const runner runner = leg_in_flight(TDMF_PHASE_RETRACT, -0.5, -1.0);
    assert_close(torque_of(&runner), -0.1 * (-0.5 + 0.6) + 0.1, 1e-16);
    assert_true(torque_of(&runner) > 0.0);
}

/* With the clamp its torque is never negative. */
TEST(retract_pulls_back_without_the_clamp_alone) {
    random_source source = {31};
    for (int i = 0; i < 1000; ++i) {
        const double angle = random_uniform(&source, -1.5, 1.5);
        const double rate = random_uniform(&source, -2.0, 2.0);
        const double servo = -0.1 * (angle + 0.6) - 0.1 * rate;
        runner runner = leg_in_flight(TDMF_PHASE_RETRACT, angle, rate);
        assert_close(torque_of(&runner), servo, 1e-15);
        runner.motion.mode.clamp_closed = servo < 0.0;
        assert_close(torque_of(&runner), fmax(servo, 0.0), 1e-15);
    }
}

/* While the clamp stands as last located the torque is smooth, or a solver could not step up to the kink. */
TEST(clamp_stays_as_located) {
    runner opening = leg_in_flight(TDMF_PHASE_RETRACT, -0.6, -1e-11);
    runner closing = leg_in_flight(TDMF_PHASE_RETRACT, -0.6, 1e-11);
    opening.motion.mode.clamp_closed = true;
    assert_true(torque_of(&opening) == 0.0);
    assert_close(torque_of(&closing), -1e-12, 1e-16);
}

TEST(place_swings_to_the_touchdown_angle) {
    const runner behind = leg_in_flight(TDMF_PHASE_PLACE, -0.5, 0.0);
    const runner there = leg_in_flight(TDMF_PHASE_PLACE, touchdown_angle, 0.0);
    const runner beyond = leg_in_flight(TDMF_PHASE_PLACE, 1.0, 0.5);
    assert_close(torque_of(&behind), 0.1 * (0.5 + touchdown_angle), 1e-15);
    assert_close(torque_of(&there), 0.0, 1e-15);
    assert_close(torque_of(&beyond), -0.1 * (1.0 - touchdown_angle) - 0.05, 1e-15);
}

/* -kp (theta - theta0 + omega s) - kd (thetadot + omega), s after place began. */
TEST(place_follows_a_leg_that_is_retracted) {
    random_source source = {33};
    for (int i = 0; i < 1000; ++i) {
        const double angle = random_uniform(&source, -1.5, 1.5), rate = random_uniform(&source, -2.0, 2.0);
        const double omega = random_uniform(&source, -0.5, 0.5), since = random_uniform(&source, 0.0, 30.0);
        runner runner = leg_in_flight(TDMF_PHASE_PLACE, angle, rate);
        runner.model.parameters.hip.retraction_rate = omega;
        runner.motion.state[TDMF_HIP_PLACE_TIME] = since;
        assert_close(torque_of(&runner),
                     -0.1 * (angle - touchdown_angle + omega * since) - 0.1 * (rate + omega), 1e-14);
        double derivatives[TDMF_STATE_COUNT];
        tdmf_derivatives(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state, derivatives);
        assert_true(derivatives[TDMF_HIP_PLACE_TIME] == 1.0);
        runner.motion.mode.phase = TDMF_PHASE_RETRACT;
        runner.motion.state[TDMF_HIP_PLACE_TIME] = 0.0;
        assert_close(torque_of(&runner), -0.1 * (angle + 0.6) - 0.1 * rate, 1e-15);
        tdmf_derivatives(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state, derivatives);
        assert_true(derivatives[TDMF_HIP_PLACE_TIME] == 0.0);
    }
}

TEST(external_torque_adds_to_the_law) {
    runner runners[] = {
        leg_in_drive(),
        scene_on_ground(TDMF_CONTACT_SLIP_POSITIVE, -0.3, 0.3),
        leg_in_flight(TDMF_PHASE_RETRACT, -0.5, -1.0),
        leg_in_flight(TDMF_PHASE_PLACE, -0.5, 1.0),
    };
    for (int i = 0; i < 4; ++i) {
        const double law = torque_of(&runners[i]);
        runners[i].inputs.hip.external_torque = -0.0625;
        assert_close(torque_of(&runners[i]), law - 0.0625, 1e-16);
    }
}

/* In graze the total is what keeps the foot unloaded at the ground, whatever is added from outside. */
TEST(graze_torque_unloads_the_foot) {
    random_source source = {32};
    for (int i = 0; i < 1000; ++i) {
        runner runner = scene_random(&source, TDMF_CONTACT_GRAZE);
        const double torque = torque_of(&runner);
        const tdmf_ground_force force =
            tdmf_sticking_force(SYSTEM_OF(&runner), &runner.motion.mode, torque, runner.motion.state);
        const double scale = runner.model.scales.force * (1.0 + runner.model.parameters.leg.damping);
        assert_close(force.normal, 0.0, 1e-13 * scale);
        runner.inputs.hip.external_torque = 0.3 * runner.model.scales.energy;
        assert_true(torque_of(&runner) == torque);
    }
}

/* Graze ends where the ground force under either law has the sign that the law must not give it. */
TEST(graze_is_watched_by_the_ground_force_under_either_law) {
    runner runner = leg_in_drive();
    runner.inputs.hip.external_torque = 0.05;
    const double stance =
        tdmf_contact_force(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state).normal;
    runner.motion.mode.phase = TDMF_PHASE_PLACE;
    runner.motion.mode.contact = TDMF_CONTACT_GRAZE;
    const double law = -0.1 * (0.3 - touchdown_angle) + 0.05;
    const double flight =
        tdmf_sticking_force(SYSTEM_OF(&runner), &runner.motion.mode, law, runner.motion.state).normal;
    assert_close(scene_guard(&runner, TDMF_GUARD_GRAZE_TO_CONTACT), -stance, 1e-12);
    assert_close(scene_guard(&runner, TDMF_GUARD_GRAZE_TO_FLIGHT), flight, 1e-12);
}
