/* Starts: which mode a run begins in, and when its start is an apex. */
#include "compare.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>

static const double start_time = 3.0;

static void start(runner *runner) {
    runner->motion.time = start_time;
    runner->motion.state[TDMF_EVENT_COUNT] = 99; /* left by an earlier run */
    runner->motion.state[TDMF_STRIDE_COUNT] = 99;
    assert_null(tdmf_start(SYSTEM_OF(runner), &runner->motion).variable);
    assert_true(runner->motion.state[TDMF_HIP_LIFTOFF_ANGLE] == runner->motion.state[TDMF_LEG_ANGLE]);
    assert_int_equal(runner->motion.state[TDMF_STRIDE_COUNT], 0);
    assert_string_equal(last_stride_of(&runner->motion).word, "");
    assert_true(last_event_of(&runner->motion) == start_time);
}

static void assert_begins(const runner *runner, tdmf_contact_mode contact, tdmf_hip_phase phase, int events) {
    scene_assert_mode(runner, contact, phase);
    assert_int_equal(runner->motion.state[TDMF_EVENT_COUNT], events);
}

/* ---- on the ground ---------------------------------------------------------------------------------- */

/* A falling foot begins with an impact, a loaded one in contact, one that slides in slip. Stretched by 0.05
 * the leg lifts a foot under both laws; by 0.02 the place law keeps it down. Where the stance law loads and
 * the flight law lifts, a foot may stay as it was: it starts in contact. */
TEST(a_start_on_the_ground_begins_as_its_foot_moves_and_is_loaded) {
    static const struct {
        double angle, force, vx, vy, length_rate, angle_rate, com_vy; /* 0: as it comes */
        tdmf_contact_mode contact;
        tdmf_hip_phase phase;
        int events;
    } cases[] = {{0.3, 0.1, 0.0, -0.5, 0.0, 0.0, 0.0, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE, 1},
                 {0.3, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE, 0},
                 {-0.3, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, TDMF_CONTACT_STICK, TDMF_PHASE_COAST, 0},
                 {0.3, 0.1, 1e-3, 0.0, 0.0, 0.0, 0.0, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_DRIVE, 0},
                 {0.3, 0.1, -1e-3, 0.0, 0.0, 0.0, 0.0, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_DRIVE, 0},
                 {-0.3, -0.05, 0.0, 0.0, -0.01, 0.0, 0.0, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, 0},
                 {-0.3, -0.02, 0.0, 0.0, -0.01, 0.0, 0.0, TDMF_CONTACT_GRAZE, TDMF_PHASE_PLACE, 0},
                 {-0.3, 0.01, 0.0, 0.0, 0.0, 3.0, -0.2, TDMF_CONTACT_STICK, TDMF_PHASE_COAST, 0}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        runner runner = scene_on_ground(TDMF_CONTACT_STICK, cases[i].angle, cases[i].force);
        runner.motion.state[TDMF_LEG_LENGTH_RATE] = cases[i].length_rate;
        runner.motion.state[TDMF_LEG_ANGLE_RATE] = cases[i].angle_rate;
        if (cases[i].com_vy != 0.0) {
            scene_set_com_vy_by_leg(&runner, cases[i].com_vy);
        }
        scene_set_vertical_force(&runner, cases[i].force);
        scene_set_foot_velocity(0.0, cases[i].vy, runner.motion.state);
        runner.motion.state[TDMF_FOOT_VX] = cases[i].vx;
        start(&runner);
        assert_begins(&runner, cases[i].contact, cases[i].phase, cases[i].events);
        assert_int_equal(runner.motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR], cases[i].events);
        assert_close(runner.motion.state[TDMF_ENERGY_IMPACT_LOSS], cases[i].events * 0.5 * 0.1 * 0.25, 1e-15);
    }
}

TEST(rising_foot_begins_in_flight) {
    runner rising = scene_in_flight(TDMF_PHASE_PLACE, 0.2), falling = rising;
    rising.motion.state[TDMF_FOOT_Y] = falling.motion.state[TDMF_FOOT_Y] = 0.0;
    falling.motion.state[TDMF_LEG_LENGTH_RATE] = -1.0;
    start(&rising);
    start(&falling);
    assert_begins(&rising, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT, 0);
    assert_begins(&falling, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, 0);
}

/* ---- in the air ------------------------------------------------------------------------------------- */

TEST(phase_in_the_air_follows_the_center_of_mass) {
    runner rising = scene_in_flight(TDMF_PHASE_PLACE, 0.1);
    runner falling = scene_in_flight(TDMF_PHASE_RETRACT, -0.1);
    rising.motion.state[TDMF_LEG_ANGLE_RATE] = 1.0; /* swings forward already: the clamp holds */
    start(&rising);
    start(&falling);
    assert_begins(&rising, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT, 0);
    assert_begins(&falling, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, 0);
    assert_true(rising.motion.mode.clamp_closed);
    assert_false(rising.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0 ||
                 falling.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
}

static void assert_no_second_apex(runner *runner) {
    for (int i = 0; i < 1000; ++i) {
        assert_true(runner_advance(runner, 1e-3));
    }
    assert_int_equal(runner->motion.state[TDMF_EVENT_COUNT], 0);
    assert_int_equal(runner->motion.state[TDMF_STRIDE_COUNT], 0);
    assert_true(last_apex_of(&runner->motion).time == start_time);
}

TEST(start_at_rest_height_is_an_apex) {
    static const double climbs[] = {0.0, 0.9e-12, -0.9e-12};
    for (int i = 0; i < 3; ++i) {
        runner runner = scene_in_flight(TDMF_PHASE_RETRACT, climbs[i]);
        start(&runner);
        assert_begins(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, 0);
        assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
        assert_true(last_apex_of(&runner.motion).time == start_time);
        assert_close(last_apex_of(&runner.motion).com_height, 1.0 + 1.0 / 1.1, 1e-15);
        assert_no_second_apex(&runner);
    }
}

TEST(start_beside_the_apex_is_none) {
    runner before = scene_in_flight(TDMF_PHASE_PLACE, 1.1e-12);
    runner after = scene_in_flight(TDMF_PHASE_PLACE, -1.1e-12);
    start(&before);
    start(&after);
    assert_begins(&before, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT, 0);
    assert_begins(&after, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, 0);
    assert_false(before.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0 ||
                 after.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
    runner_advance(&before, 1e-3);
    assert_begins(&before, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, 1);
}

/* 1e-12 is in units of l0 sqrt(k/m), here 100. */
TEST(nearness_to_the_apex_scales) {
    static const double climbs[] = {0.9e-10, 1.1e-10};
    for (int i = 0; i < 2; ++i) {
        runner runner = scene_in_flight(TDMF_PHASE_PLACE, climbs[i]);
        tdmf_parameters parameters = runner.model.parameters;
        parameters.leg.stiffness = 1e4;
        runner.model = accepted_model(&parameters);
        start(&runner);
        assert_int_equal(runner.motion.state[TDMF_STRIDE_IS_OPEN], i == 0);
    }
}

TEST(default_start_is_an_apex) {
    runner runner = runner_default(0.6);
    start(&runner);
    assert_begins(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, 0);
    assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
}

/* y = vy = 0, the stretched leg lifts the foot, the centre of mass stands still. */
TEST(start_on_the_ground_that_leaves_at_once_may_be_an_apex) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -0.3, -0.05);
    scene_set_com_vy_by_leg(&runner, 0.0);
    start(&runner);
    scene_assert_mode(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE);
    assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
    assert_int_equal(runner.motion.state[TDMF_EVENT_COUNT], 0);
}

TEST(start_clears_the_integrals) {
    static const int integrals[] = {
        TDMF_HIP_WORK,           TDMF_HIP_POSITIVE_WORK,    TDMF_LEG_WORK,
        TDMF_ENERGY_DAMPER_LOSS, TDMF_ENERGY_FRICTION_LOSS, TDMF_ENERGY_EXTERNAL_WORK};
    runner runner = scene_in_flight(TDMF_PHASE_RETRACT, 0.1);
    runner.motion.state[TDMF_HIP_WORK] = NAN;
    runner.motion.state[TDMF_ENERGY_DAMPER_LOSS] = 1.0;
    start(&runner);
    for (size_t i = 0; i < sizeof integrals / sizeof *integrals; ++i) {
        assert_true(runner.motion.state[integrals[i]] == 0.0);
    }
}
