/* Chains of events in zero time: impacts with a sequel, jumps of an input, and events that coincide. */
#include "compare.h"
#include "scene.h"

#include <math.h>

static const double beyond = SCENE_PAST_EVENT;

static void resolve(runner *runner, int events) {
    scene_resolve(runner);
    assert_int_equal(runner->motion.record.event_count, events);
}

/* ---- impacts ---------------------------------------------------------------------------------------- */

/* The impact's impulse is inside the cone, the force after it is not. */
TEST(sticking_impact_that_slips_at_once) {
    runner behind = scene_at_impact(TDMF_PHASE_PLACE, -0.7, 0.1);
    runner ahead = scene_at_impact(TDMF_PHASE_PLACE, 0.7, 0.1);
    behind.inputs.ground.friction = ahead.inputs.ground.friction = 0.6;
    ahead.model.parameters.hip.stance_torque = 0.0;
    resolve(&behind, 1);
    resolve(&ahead, 1);
    scene_assert_mode(&behind, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
    scene_assert_mode(&ahead, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_DRIVE);
    assert_true(behind.motion.state[TDMF_FOOT_VX] == 0.0 && ahead.motion.state[TDMF_FOOT_VX] == 0.0);
    assert_string_equal(behind.motion.record.progress.open.word,
                        ""); /* no letter for a stick that did not last */
}

/* A stretched leg lifts the foot as soon as it has landed. */
static runner landing_on_stretched_leg(tdmf_hip_phase phase, double climb_after) {
    runner runner = scene_at_impact(phase, -0.3, -0.05);
    runner.motion.mode.liftoff_angle = 0.9;
    runner.motion.state[TDMF_LEG_LENGTH_RATE] += climb_after;
    return runner;
}

static void assert_left_at_once(const runner *runner, tdmf_hip_phase phase) {
    scene_assert_mode(runner, TDMF_CONTACT_FLIGHT, phase);
    assert_int_equal(runner->motion.record.progress.open.touchdowns, 1);
    assert_string_equal(runner->motion.record.progress.open.word, "");
    assert_true(runner->motion.mode.liftoff_angle == -0.3);
    assert_close(runner->motion.state[TDMF_FOOT_VY], 0.0, 1e-15);
}

TEST(impact_that_leaves_at_once_stays_in_retract) {
    runner runner = landing_on_stretched_leg(TDMF_PHASE_RETRACT, 0.1);
    resolve(&runner, 1);
    assert_left_at_once(&runner, TDMF_PHASE_RETRACT);
}

/* The impact throws the centre of mass up again: the hip stays in place, and the second apex, which closes a
 * stride, begins its time anew. */
TEST(impact_that_leaves_at_once_stays_in_place) {
    runner runner = landing_on_stretched_leg(TDMF_PHASE_PLACE, 0.005);
    assert_true(tdmf_center_of_mass(&runner.model, runner.motion.state).vy < 0.0);
    resolve(&runner, 1);
    assert_left_at_once(&runner, TDMF_PHASE_PLACE);
    assert_true(tdmf_center_of_mass(&runner.model, runner.motion.state).vy > 0.0);
    assert_true(runner.motion.mode.rises);
    while (runner.motion.time < 1.0 && runner.motion.mode.contact == TDMF_CONTACT_FLIGHT) {
        runner_advance(&runner, 1e-3);
        assert_true(runner.motion.record.progress.open.began_at_apex == !runner.motion.mode.rises);
        assert_int_equal(runner.motion.mode.phase, runner.motion.mode.contact == TDMF_CONTACT_FLIGHT
                                                       ? TDMF_PHASE_PLACE
                                                       : runner.motion.mode.phase);
    }
    assert_true(runner.motion.record.progress.open.began_at_apex);
    assert_int_equal(runner.motion.record.stride.count, 0);
}

/* The stretched leg lifts the foot, the hip, which swings the leg forward, holds it down. */
TEST(impact_into_graze) {
    runner runner = scene_at_impact(TDMF_PHASE_PLACE, -0.3, -0.02);
    runner.motion.mode.liftoff_angle = 0.9;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_GRAZE, TDMF_PHASE_PLACE);
    assert_true(runner.motion.mode.liftoff_angle == -0.3);
    assert_close(runner.motion.state[TDMF_FOOT_VX], 0.0, 0.0);
}

TEST(touchdown_at_the_apex) {
    runner runner = scene_at_impact(TDMF_PHASE_RETRACT, 0.4, 0.1);
    const double climb = tdmf_center_of_mass(&runner.model, runner.motion.state).vy;
    runner.motion.state[TDMF_LEG_LENGTH_RATE] += (beyond - climb) * 1.1 / cos(0.4);
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE);
    assert_true(runner.motion.record.progress.open.began_at_apex);
    assert_int_equal(runner.motion.record.progress.open.touchdowns,
                     1); /* of the stride that the apex opens */
}

/* ---- jumps of an input ------------------------------------------------------------------------------ */

/* Sticking in coast, the body rising, the foot loaded with 0.1 and held by f_x = 0.099 tan 0.3 = 0.031. */
static runner standing(double friction, double angle_rate) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -0.3, 0.1);
    runner.inputs.ground.friction = friction;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = angle_rate;
    scene_set_com_vy_by_leg(&runner, 0.05);
    scene_set_vertical_force(&runner, 0.1);
    runner.motion.time = 1.0;
    resolve(&runner, 0);
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    return runner;
}

TEST(torque_jump_starts_a_slip) {
    runner backward = standing(0.4, 0.0);
    runner forward = standing(0.4, 0.0);
    backward.inputs.hip.external_torque = -0.05;
    forward.inputs.hip.external_torque = 0.1;
    resolve(&backward, 1);
    resolve(&forward, 1);
    scene_assert_mode(&backward, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
    scene_assert_mode(&forward, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
}

TEST(friction_jump_starts_a_slip) {
    runner runner = standing(0.4, 0.0);
    runner.inputs.ground.friction = 0.3;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
    assert_string_equal(runner.motion.record.progress.open.word, "0");
}

TEST(torque_jump_ends_the_contact) {
    runner runner = standing(1000.0, 0.1);
    runner.inputs.hip.external_torque = -0.5;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT);
    assert_true(runner.motion.mode.clamp_closed);
}

/* The retract law, stopping a fast backward swing, outweighs the external torque that lifts the foot. */
TEST(torque_jump_ends_the_contact_into_graze) {
    runner runner = standing(1000.0, -4.0);
    runner.inputs.hip.external_torque = -0.5;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_GRAZE, TDMF_PHASE_RETRACT);
}

/* A jump beyond both limits leaves the ground; the slip that it would start lasts no time. */
TEST(jump_past_cone_and_load_leaves_the_ground) {
    runner runner = standing(0.4, 0.1);
    runner.inputs.hip.external_torque = -0.5;
    runner.inputs.ground.friction = 0.0;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT);
    assert_string_equal(runner.motion.record.progress.open.word, "0");
}

/* Without the drive, which held it down, the foot lifts: a chain is one event. */
TEST(mid_stance_may_end_the_contact) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -0.3, -0.02);
    runner.motion.mode.phase = TDMF_PHASE_DRIVE;
    runner.motion.mode.mid_stance_pending = true;
    scene_set_com_vy_by_leg(&runner, 0.05);
    resolve(&runner, 1);
    assert_false(runner.motion.mode.mid_stance_pending);
    scene_assert_mode(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT);
}

/* Mid-stance takes the drive's torque away, and with it what held the foot, or what pushed it. */
TEST(mid_stance_may_start_a_slip) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, beyond, 0.3);
    runner.motion.mode.phase = TDMF_PHASE_DRIVE;
    runner.motion.mode.mid_stance_pending = true;
    runner.inputs.hip.external_torque = 0.2; /* balances the drive */
    runner.inputs.ground.friction = 0.2;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
}

/* Loaded by a jump, the foot at rest in graze is loaded and slips at once. */
TEST(torque_jump_ends_a_graze) {
    runner runner = scene_on_ground(TDMF_CONTACT_GRAZE, -0.3, -0.01);
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = -2.0;
    scene_set_com_vy_by_leg(&runner, 0.05);
    scene_set_vertical_force(&runner, -0.01);
    resolve(&runner, 0);
    runner.inputs.hip.external_torque = 0.2;
    runner.inputs.ground.friction = 0.1;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
    assert_true(runner.motion.state[TDMF_FOOT_VX] == 0.0);
    assert_string_equal(runner.motion.record.progress.open.word, "");
}

TEST(jumps_in_flight_cause_nothing) {
    runner runner = scene_in_flight(TDMF_PHASE_PLACE, -0.1);
    runner.inputs.hip.external_torque = 0.7;
    runner.inputs.ground.friction = 0.0;
    const tdmf_resolution resolution = scene_resolve(&runner);
    assert_false(resolution.mode_changed || resolution.state_changed);
}

/* ---- everything exactly zero ------------------------------------------------------------------------ */

static runner upright(double length) {
    runner runner = runner_default(0.0);
    runner.model.parameters.hip.stance_torque = 0.0;
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        runner.motion.state[i] = 0.0;
    }
    runner.motion.state[TDMF_LEG_LENGTH] = length;
    runner_start(&runner);
    return runner;
}

/* No friction, no torque, no lean, no speed: |f_x| = 0 is inside a cone of no width. */
TEST(upright_foot_on_ice_stands) {
    runner runner = upright(0.9);
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE);
    for (int i = 0; i < 1000; ++i) {
        assert_true(runner_advance(&runner, 1e-3));
    }
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE);
    assert_int_equal(runner.motion.record.event_count, 0);
    assert_true(runner.motion.state[TDMF_LEG_ANGLE] == 0.0 && runner.motion.state[TDMF_FOOT_VX] == 0.0);
}

/* The leg is stretched by just the foot's weight: no force on an upright foot, whose torque has no lever.
 * Which way the last bit of the force decides is as good as any, but it has to be decided once. */
TEST(upright_foot_without_load_does_not_chatter) {
    for (int i = -2; i <= 2; ++i) {
        runner runner = upright(1.0 + 0.1 * 0.01 + i * 1e-16);
        while (runner.motion.time < 10.0 && runner_advance(&runner, 1e-2)) {
        }
        assert_true(runner.resolutions < 20);
    }
}
