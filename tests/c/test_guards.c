/* Every guard alone: its value on both sides of the event and at the boundary, and which mode watches it. */
#include "compare.h"
#include "scene.h"

#include <math.h>

static const double margin = TDMF_GUARD_MARGIN;
static const double dead_band = 1e-10; /* for quantities that may settle at zero: clamp, rate of force */

/* Puts the guarded quantity, in units of its scale, to `distance` from its event. */
typedef void (*placement)(runner *runner, double distance);

static void assert_guards(runner runner, tdmf_guard guard, placement put, double width) {
    const double distances[] = {1e-2, 1e-9, 2.0 * width, 0.0, -0.5 * width, -2.0 * width, -1e-9, -1e-2};
    for (int i = 0; i < 8; ++i) {
        put(&runner, distances[i]);
        const double value = scene_guard(&runner, guard);
        assert_close(value, distances[i] + width, 0.1 * width + 1e-12 * fabs(distances[i]));
        assert_true((value > 0.0) == (distances[i] > -width));
    }
}

/* ---- placements ------------------------------------------------------------------------------------- */

static void raise_foot(runner *runner, double height) {
    runner->motion.state[TDMF_FOOT_Y] = height;
}

/* -kp (theta - eta theta_LO) - kd thetadot = argument, with kp = kd = 0.1, eta = 1.2; the clamp closes below
 * 0 and opens above. */
static void set_retract_argument(runner *runner, double distance) {
    const double argument = runner->motion.mode.clamp_closed ? -distance : distance;
    const double spring =
        -0.1 * (runner->motion.state[TDMF_LEG_ANGLE] - 1.2 * runner->motion.state[TDMF_HIP_LIFTOFF_ANGLE]);
    runner->motion.state[TDMF_LEG_ANGLE_RATE] = (spring - argument) / 0.1;
}

/* With the leg still and no torque, |f_x| = (f_y - m_f g) tan|theta|; friction sets the distance to it. */
static void set_cone(runner *runner, double distance) {
    const double force = 0.1;
    scene_set_vertical_force(runner, force);
    const double across = (force - 0.001) * tan(fabs(runner->motion.state[TDMF_LEG_ANGLE]));
    runner->inputs.ground.friction = (across + distance) / force;
}

static void set_slip_speed(runner *runner, double speed) {
    runner->motion.state[TDMF_FOOT_VX] = speed * tdmf_sign_of_slip(&runner->motion.mode);
}

static void set_leg_angle(runner *runner, double angle) {
    runner->motion.state[TDMF_LEG_ANGLE] = angle;
}

/* A leg at rest across the ground, upright on level ground: d(f_n)/dt = -c rddot = -c (k (l0 - r)/m - g) with
 * c = 0.2, g = 0.01 and gravity's part across it; of f_t nothing. A peak is where a rising rate falls below
 * 0, and a trough where a falling one rises. */
static void set_rate_of_force(runner *runner, double distance, bool rises) {
    const double slope = runner->motion.mode.ground.slope, rate = rises ? distance : -distance;
    runner->motion.state[TDMF_LEG_ANGLE] = slope;
    runner->motion.state[TDMF_LEG_LENGTH] = 1.0 - (0.01 * cos(slope) - rate / (0.2 * cos(slope)));
}

static void set_force_rate(runner *runner, double distance) {
    set_rate_of_force(runner, distance, runner->motion.mode.ground_force_rising);
}

static void set_vertical_force_rate(runner *runner, double distance) {
    set_rate_of_force(runner, distance, runner->motion.mode.vertical_force_rising);
}

static void set_lift_of_stance_law(runner *runner, double lift) {
    scene_set_vertical_force(runner, -lift);
}

static void hang_body(runner *runner, double height) {
    runner->motion.state[TDMF_FOOT_Y] =
        height - runner->motion.state[TDMF_LEG_LENGTH] * cos(runner->motion.state[TDMF_LEG_ANGLE]);
}

static void set_spare_length(runner *runner, double length) {
    runner->motion.state[TDMF_LEG_LENGTH] = runner->model.parameters.leg.min_length + length;
}

/* ---- values ----------------------------------------------------------------------------------------- */

TEST(guards_off_the_ground_watch_height_clamp_and_fall) {
    runner rising = scene_in_flight(TDMF_PHASE_RETRACT, 0.1),
           falling = scene_in_flight(TDMF_PHASE_PLACE, -0.1);
    assert_guards(falling, TDMF_GUARD_TOUCHDOWN, raise_foot, margin);
    assert_guards(rising, TDMF_GUARD_TOUCHDOWN, raise_foot, margin);
    assert_guards(falling, TDMF_GUARD_LEG_TOO_SHORT, set_spare_length, margin);
    rising.motion.state[TDMF_HIP_LIFTOFF_ANGLE] = -0.4;
    for (int closed = 0; closed < 2; ++closed) {
        rising.motion.mode.clamp_closed = closed == 1;
        assert_guards(rising, TDMF_GUARD_CLAMP, set_retract_argument, margin);
    }
    falling.motion.state[TDMF_LEG_ANGLE] = 2.0;
    falling.motion.state[TDMF_LEG_LENGTH] = 0.8;
    assert_guards(falling, TDMF_GUARD_BODY_DOWN, hang_body, margin);
}

static void assert_apex(runner runner, placement put) {
    static const double rates[] = {1e-2, 1e-9, 1e-15, -1e-15, -1e-11, -1e-9, -1e-2};
    for (int i = 0; i < 7; ++i) {
        put(&runner, rates[i]);
        const double value = scene_guard(&runner, TDMF_GUARD_APEX);
        assert_close(value, rates[i] + margin, 3e-16);
        assert_true((value > 0.0) == (rates[i] > -margin));
    }
}

TEST(apex_watches_the_climb) {
    runner in_flight = scene_in_flight(TDMF_PHASE_RETRACT, 0.1);
    in_flight.motion.state[TDMF_LEG_ANGLE_RATE] = 0.3;
    in_flight.motion.state[TDMF_LEG_ANGLE] = -0.7;
    runner in_graze = scene_on_ground(TDMF_CONTACT_GRAZE, -0.5, 0.0);
    in_graze.motion.state[TDMF_LEG_ANGLE_RATE] = 0.3;
    assert_apex(in_flight, scene_set_com_vy);
    assert_apex(in_graze, scene_set_com_vy_by_leg);
}

TEST(guards_in_contact_watch_load_cone_slip_and_leg) {
    for (int contact = TDMF_CONTACT_STICK; contact <= TDMF_CONTACT_SLIP_NEGATIVE; ++contact) {
        const runner runner = scene_on_ground((tdmf_contact_mode)contact, -0.4, 0.1);
        assert_guards(runner, TDMF_GUARD_LIFT_OFF, scene_set_vertical_force, margin);
        if (contact != TDMF_CONTACT_STICK) {
            assert_guards(runner, TDMF_GUARD_SLIP_VELOCITY_ZERO, set_slip_speed, margin);
        }
    }
    const runner ahead = scene_on_ground(TDMF_CONTACT_STICK, 0.5, 0.1);
    const runner behind = scene_on_ground(TDMF_CONTACT_STICK, -0.5, 0.1);
    assert_guards(ahead, TDMF_GUARD_SLIP_ONSET_POSITIVE, set_cone, margin);
    assert_guards(behind, TDMF_GUARD_SLIP_ONSET_NEGATIVE, set_cone, margin);
    assert_guards(ahead, TDMF_GUARD_LEG_TOO_SHORT, set_spare_length, margin);
    runner driven = ahead;
    driven.motion.mode.phase = TDMF_PHASE_DRIVE;
    driven.motion.mode.mid_stance_pending = true;
    assert_guards(driven, TDMF_GUARD_MID_STANCE, set_leg_angle, margin);
}

/* The vertical force has a peak of its own on a slope only. */
TEST(force_peaks_watch_their_rates_either_way) {
    runner level = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.1), sloping = level;
    assert_true(scene_guard(&level, TDMF_GUARD_VERTICAL_FORCE_PEAK) == 1.0);
    sloping.motion.mode.ground = tdmf_ground_line_of(0.0, 0.1);
    sloping.inputs.ground.slope = 0.1;
    for (int rises = 0; rises < 2; ++rises) {
        level.motion.mode.ground_force_rising = sloping.motion.mode.vertical_force_rising = rises == 1;
        assert_guards(level, TDMF_GUARD_FORCE_PEAK, set_force_rate, dead_band);
        assert_guards(sloping, TDMF_GUARD_VERTICAL_FORCE_PEAK, set_vertical_force_rate, dead_band);
    }
}

/* With gains of zero the flight law applies nothing and the leg alone loads the foot. */
TEST(graze_is_watched_by_the_load_under_either_law) {
    for (double torque = 0.0; torque < 0.1; torque += 0.05) {
        runner stance = scene_on_ground(TDMF_CONTACT_GRAZE, -0.4, 0.0), flight = stance;
        stance.inputs.hip.external_torque = flight.inputs.hip.external_torque = torque;
        flight.model.parameters.hip.kp = flight.model.parameters.hip.kd = 0.0;
        assert_guards(stance, TDMF_GUARD_GRAZE_TO_CONTACT, set_lift_of_stance_law, margin);
        assert_guards(flight, TDMF_GUARD_GRAZE_TO_FLIGHT, scene_set_vertical_force, margin);
    }
}

/* ---- which mode watches what ------------------------------------------------------------------------ */

/* Marked are a ground that waits with a ?, a line that slopes with a / and the clamp, where there is one,
 * with a c; there is no patch. In place an apex is watched only where the runner is pushed. */
static const char *watched_guards(const tdmf_mode *mode) {
    const bool retract = mode->phase == TDMF_PHASE_RETRACT;
    const bool drive = mode->phase == TDMF_PHASE_DRIVE;
    switch (mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        return retract ? "xxc........xx.?.." : "x..........xx.?..";
    case TDMF_CONTACT_STICK:
        return drive ? "...xxx.xx..xxx./." : "...xxx..x..xxx./.";
    case TDMF_CONTACT_GRAZE:
        return retract ? ".xc......xxxx...." : ".........xxxx....";
    default:
        return drive ? "...x..xxx..xxx./." : "...x..x.x..xxx./.";
    }
}

TEST(guards_of_other_modes_are_one) {
    random_source source = {41};
    for (int i = 0; i < 500; ++i) {
        const runner runner = scene_random(&source, (tdmf_contact_mode)(TDMF_CONTACT_FLIGHT + i % 5));
        const char *watched = watched_guards(&runner.motion.mode);
        for (int guard = 0; guard < TDMF_GUARD_COUNT; ++guard) {
            const bool waits = runner.motion.mode.ground.height != runner.inputs.ground.height ||
                               runner.motion.mode.ground.slope != runner.inputs.ground.slope;
            const bool slopes = runner.motion.mode.ground.slope != 0.0;
            const bool expected = watched[guard] == 'x' || (watched[guard] == '?' && waits) ||
                                  (watched[guard] == '/' && slopes) ||
                                  (watched[guard] == 'c' && runner.model.parameters.hip.swing_clamp);
            assert_true((scene_guard(&runner, (tdmf_guard)guard) != 1.0) == expected);
        }
    }
}

TEST(fallen_run_watches_nothing) {
    random_source source = {42};
    runner runner = scene_random(&source, TDMF_CONTACT_FLIGHT);
    runner.motion.mode.fallen = true;
    runner.motion.state[TDMF_FOOT_Y] = -1.0;
    for (int guard = 0; guard < TDMF_GUARD_COUNT; ++guard) {
        assert_true(scene_guard(&runner, (tdmf_guard)guard) == 1.0);
    }
}
