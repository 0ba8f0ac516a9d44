/* Resets: what one event, and a chain of events in zero time, make of state and mode. */
#include "compare.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

static const double beyond = SCENE_PAST_EVENT;

enum {
    FLIGHT = TDMF_CONTACT_FLIGHT,
    STICK = TDMF_CONTACT_STICK,
    FORWARD = TDMF_CONTACT_SLIP_POSITIVE,
    BACKWARD = TDMF_CONTACT_SLIP_NEGATIVE,
    GRAZE = TDMF_CONTACT_GRAZE,
    DRIVE = TDMF_PHASE_DRIVE,
    COAST = TDMF_PHASE_COAST,
    RETRACT = TDMF_PHASE_RETRACT,
    PLACE = TDMF_PHASE_PLACE
};

/* Resolves at time 7 and asserts how many events that was. */
static tdmf_resolution resolve(runner *runner, int events) {
    runner->motion.time = 7.0;
    const tdmf_resolution resolution = scene_resolve(runner);
    assert_int_equal(runner->motion.state[TDMF_EVENT_COUNT], events);
    assert_true(last_event_of(&runner->motion) == (events > 0 ? 7.0 : 0.0));
    return resolution;
}

/* Resolves events and asserts the mode that is entered. */
static tdmf_resolution enter(runner *runner, int events, int contact, int phase) {
    const tdmf_resolution resolution = resolve(runner, events);
    scene_assert_mode(runner, (tdmf_contact_mode)contact, (tdmf_hip_phase)phase);
    return resolution;
}

/* ---- touchdown -------------------------------------------------------------------------------------- */

static void touch_down(runner *runner, int contact, int phase) {
    const tdmf_resolution resolution = enter(runner, 1, contact, phase);
    assert_true(resolution.state_changed && resolution.mode_changed);
    assert_int_equal(runner->motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR], 1);
    assert_true(runner->motion.state[TDMF_ENERGY_IMPACT_LOSS] > 0.0);
    assert_true(runner->motion.state[TDMF_FOOT_Y] == 0.0 && runner->motion.state[TDMF_FOOT_VY] == 0.0);
}

TEST(touchdown_sticks_inside_the_cone_and_slides_outside) {
    runner rough = scene_at_impact(TDMF_PHASE_PLACE, 0.4, 0.1), forward = rough, backward = rough;
    forward.inputs.ground.friction = backward.inputs.ground.friction = 0.1;
    scene_set_foot_velocity(-0.05, -0.1, backward.motion.state);
    touch_down(&rough, STICK, DRIVE);
    touch_down(&forward, FORWARD, DRIVE);
    touch_down(&backward, BACKWARD, DRIVE);
    assert_true(rough.motion.state[TDMF_FOOT_VX] == 0.0);
    assert_close(forward.motion.state[TDMF_FOOT_VX], 0.04, 1e-16);
    assert_close(backward.motion.state[TDMF_FOOT_VX], -0.04, 1e-16);
}

/* A stance that begins upright or ahead drives; one that begins behind only coasts. */
TEST(touchdown_behind_the_body_coasts) {
    runner ahead = scene_at_impact(TDMF_PHASE_PLACE, 1e-9, 0.1);
    runner behind = scene_at_impact(TDMF_PHASE_PLACE, -1e-9, 0.1);
    touch_down(&ahead, STICK, DRIVE);
    touch_down(&behind, STICK, COAST);
}

/* A leg that falls from upright has passed mid-stance; one that turns forward first has not. */
TEST(touchdown_upright_is_driven_unless_the_leg_falls) {
    static const struct {
        double rate, stance_torque;
        int phase;
    } cases[] = {{-0.1, 0.2, COAST}, {0.0, 0.2, COAST},   {0.1, 0.2, DRIVE},
                 {0.0, 0.0, DRIVE},  {-0.1, -0.2, COAST}, {0.0, -0.2, DRIVE}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        for (double friction = 0.0; friction < 2.0; friction += 1.0) {
            runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.1);
            runner.inputs.ground.friction = friction;
            runner.model.parameters.hip.stance_torque = cases[i].stance_torque;
            runner.motion.state[TDMF_LEG_ANGLE_RATE] = cases[i].rate;
            runner_start(&runner);
            assert_int_equal(runner.motion.mode.phase, cases[i].phase);
        }
    }
}

static tdmf_motion run_from_start(runner *runner, double until, int64_t max_events) {
    tdmf_solver solver = tdmf_solver_default();
    runner_start(runner);
    tdmf_motion motion = runner->motion;
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(runner), NULL, until, &motion), TDMF_ARRIVED);
    assert_true(solver.events <= max_events);
    return motion;
}

/* Whatever pulse a drive would give it in no time is none. */
TEST(upright_runner_at_rest_stands) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.011); /* its weight */
    const tdmf_motion motion = run_from_start(&runner, 100.0, 0);
    assert_true(motion.state[TDMF_LEG_ANGLE] == 0.0 && motion.state[TDMF_LEG_ANGLE_RATE] == 0.0);
    assert_true(motion.state[TDMF_HIP_WORK] == 0.0);
}

/* The damper carries the foot's weight, and no torque could hold an upright foot: what its load is about to
 * do decides. It grows with a leg that shortens, and falls with one that lengthens against its damper. */
TEST(upright_foot_without_load_does_not_graze) {
    static const double damping = 0.2, foot_weight = 0.001;
    static const double length_rates[] = {0.0, -0.1, 0.1};
    for (int i = 0; i < 9; ++i) {
        const double length_rate = length_rates[i / 3];
        runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0);
        runner.motion.state[TDMF_LEG_LENGTH_RATE] = length_rate;
        runner.motion.state[TDMF_LEG_ANGLE_RATE] = 0.1 * (i % 3 - 1);
        runner.motion.state[TDMF_LEG_LENGTH] = 1.0 + foot_weight - damping * length_rate;
        run_from_start(&runner, 0.5, 5);
        assert_true(length_rate > 0.0 ? runner.motion.mode.contact == TDMF_CONTACT_FLIGHT
                                      : tdmf_is_loaded(&runner.motion.mode));
    }
}

/* Pulled up by a stretched leg it leaves, though the leg shortens and the load grows. Without damper and at
 * rest its load is zero and so is its rate: it is about to grow as the body falls. */
TEST(upright_foot_flies_where_it_is_pulled_up_and_stays_without_load_at_rest) {
    runner pulled = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0), resting = pulled;
    pulled.motion.state[TDMF_LEG_LENGTH_RATE] = -0.5;
    scene_set_vertical_force(&pulled, -0.01);
    resting.model.parameters.leg.damping = 0.0;
    scene_set_vertical_force(&resting, 0.0);
    runner_start(&pulled);
    runner_start(&resting);
    assert_int_equal(pulled.motion.mode.contact, TDMF_CONTACT_FLIGHT);
    assert_int_equal(pulled.motion.state[TDMF_EVENT_COUNT], 0); /* it was never loaded */
    assert_true(tdmf_is_loaded(&resting.motion.mode));
}

/* The units are k l0, here 10^4, and sqrt(m/k), here 0.01. */
TEST(thresholds_of_load_and_rest_scale) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.stiffness = 1e4;
    runner unloaded = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0);
    unloaded.model = accepted_model(&parameters);
    runner resting = unloaded;
    unloaded.motion.state[TDMF_LEG_LENGTH_RATE] = 0.1;
    scene_set_vertical_force(&unloaded, 0.0);
    runner_start(&unloaded);
    assert_int_equal(unloaded.motion.mode.contact, TDMF_CONTACT_FLIGHT);
    resting.motion.state[TDMF_LEG_ANGLE_RATE] = 5e-12; /* the drive turns it back */
    scene_set_vertical_force(&resting, 0.1);
    runner_start(&resting);
    scene_assert_mode(&resting, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
}

/* The centre of mass does not fall: it is the law of retract that is asked, whose clamp lets the foot go.
 * That of place would hold it. */
TEST(unloaded_foot_of_a_runner_at_rest_flies) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -0.3, -0.02);
    assert_true(tdmf_center_of_mass(&runner.model, runner.motion.state).vy == 0.0);
    runner_start(&runner);
    assert_int_equal(runner.motion.mode.contact, TDMF_CONTACT_FLIGHT);
}

/* Rounding or a coarse importer may leave a foot below the ground that rises: it is lifted, without impact.
 * One that rests there has one without loss. */
TEST(sunken_foot_that_rises_is_lifted) {
    runner rising = scene_at_impact(TDMF_PHASE_RETRACT, -0.4, 0.1), resting = rising;
    rising.motion.state[TDMF_FOOT_VY] = 0.1;
    scene_set_foot_velocity(0.0, 0.0, resting.motion.state);
    enter(&rising, 0, FLIGHT, RETRACT);
    enter(&resting, 1, STICK, COAST);
    assert_int_equal(rising.motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR], 0);
    assert_true(rising.motion.state[TDMF_FOOT_Y] == 0.0);
    assert_true(resting.motion.state[TDMF_FOOT_Y] == 0.0 &&
                resting.motion.state[TDMF_ENERGY_IMPACT_LOSS] == 0.0);
}

/* The impact's impulse is inside the cone, the force after it is not. */
TEST(sticking_impact_that_slips_at_once) {
    runner behind = scene_at_impact(TDMF_PHASE_PLACE, -0.7, 0.1);
    runner ahead = scene_at_impact(TDMF_PHASE_PLACE, 0.7, 0.1);
    behind.inputs.ground.friction = ahead.inputs.ground.friction = 0.6;
    ahead.model.parameters.hip.stance_torque = 0.0;
    enter(&behind, 1, BACKWARD, COAST);
    enter(&ahead, 1, FORWARD, DRIVE);
    assert_true(behind.motion.state[TDMF_FOOT_VX] == 0.0 && ahead.motion.state[TDMF_FOOT_VX] == 0.0);
    /* no letter for a stick that did not last */
    assert_true(behind.motion.state[TDMF_STRIDE_WORD_SO_FAR] == 0.0);
}

/* A stretched leg lifts the foot as soon as it has landed. In place the impact throws the centre of mass up
 * again: the hip stays in place, and the second apex begins its time anew. */
TEST(impact_that_leaves_at_once_stays_in_its_phase) {
    for (int phase = RETRACT; phase <= PLACE; ++phase) {
        runner runner = scene_at_impact((tdmf_hip_phase)phase, -0.3, -0.05);
        runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] = 0.9;
        runner.motion.state[TDMF_LEG_LENGTH_RATE] += phase == PLACE ? 0.005 : 0.1;
        const double before = tdmf_center_of_mass(&runner.model, runner.motion.state).vy;
        enter(&runner, 1, FLIGHT, phase);
        assert_int_equal(runner.motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR], 1);
        assert_true(runner.motion.state[TDMF_STRIDE_WORD_SO_FAR] == 0.0);
        assert_true(runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] == -0.3);
        assert_close(runner.motion.state[TDMF_FOOT_VY], 0.0, 1e-15);
        if (phase == PLACE) {
            assert_true(before < 0.0 && tdmf_center_of_mass(&runner.model, runner.motion.state).vy > 0.0);
            assert_true(runner.motion.mode.rises);
            while (runner.motion.time < 8.0 && runner.motion.mode.contact == TDMF_CONTACT_FLIGHT) {
                runner_advance(&runner, 1e-3);
                assert_int_equal(runner.motion.state[TDMF_STRIDE_IS_OPEN], !runner.motion.mode.rises);
                assert_true(runner.motion.mode.contact != TDMF_CONTACT_FLIGHT ||
                            runner.motion.mode.phase == TDMF_PHASE_PLACE);
            }
            assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
            assert_int_equal(runner.motion.state[TDMF_STRIDE_COUNT], 0);
        }
    }
}

/* The stretched leg lifts the foot, the hip, which swings the leg forward, holds it down. */
TEST(impact_into_graze) {
    runner runner = scene_at_impact(TDMF_PHASE_PLACE, -0.3, -0.02);
    runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] = 0.9;
    enter(&runner, 1, GRAZE, PLACE);
    assert_true(runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] == -0.3);
    assert_close(runner.motion.state[TDMF_FOOT_VX], 0.0, 0.0);
}

/* The touchdown is of the stride that the apex opens. */
TEST(touchdown_at_the_apex) {
    runner runner = scene_at_impact(TDMF_PHASE_RETRACT, 0.4, 0.1);
    const double climb = tdmf_center_of_mass(&runner.model, runner.motion.state).vy;
    runner.motion.state[TDMF_LEG_LENGTH_RATE] += (beyond - climb) * 1.1 / cos(0.4);
    enter(&runner, 1, STICK, DRIVE);
    assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
    assert_int_equal(runner.motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR], 1);
}

/* ---- apex and clamp --------------------------------------------------------------------------------- */

TEST(apex_begins_place_and_latches_the_section) {
    runner runner = scene_in_flight(TDMF_PHASE_RETRACT, 0.1);
    runner.motion.state[TDMF_LEG_ANGLE] = -0.6;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = 0.25;
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = 0.125;
    runner.motion.state[TDMF_FOOT_VX] = 0.5;
    runner.motion.mode.clamp_closed = true; /* scene_resolve asserts that it opens */
    scene_set_com_vy(&runner, beyond);
    const tdmf_resolution resolution = enter(&runner, 1, FLIGHT, PLACE);
    assert_true(resolution.mode_changed && !resolution.state_changed);
    const double expected[TDMF_SECTION_COUNT] = {
        1.0 + cos(0.6) / 1.1, 0.5 + (0.125 * sin(0.6) - 0.25 * cos(0.6)) / 1.1, 1.0, -0.6, 0.125, 0.25};
    double section[TDMF_SECTION_COUNT];
    read_apex(&runner.motion, section);
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        assert_close(section[i], expected[i], i < 2 ? 1e-15 : 0.0);
    }
    assert_true(last_apex_of(&runner.motion).time == 7.0);
    assert_int_equal(runner.motion.state[TDMF_STRIDE_COUNT], 0);
}

/* It opens and closes uncounted; inside the dead band either position stands. */
TEST(clamp_opens_and_closes_uncounted) {
    static const double arguments[] = {2e-10, -2e-10, 0.0, 0.0};
    for (int i = 0; i < 4; ++i) {
        runner runner = scene_in_flight(TDMF_PHASE_RETRACT, 0.1);
        runner.motion.mode.clamp_closed = i % 2 == 0;
        runner.motion.state[TDMF_LEG_ANGLE_RATE] = -arguments[i] / 0.1;
        assert_true(resolve(&runner, 0).mode_changed == (i < 2));
        assert_true(runner.motion.mode.clamp_closed == (i == 1 || i == 2));
    }
}

/* ---- lift-off --------------------------------------------------------------------------------------- */

static runner lifting_off(double angle_rate, double com_vy) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -0.45, 0.0);
    runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] = 0.9; /* left by an earlier stance */
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = angle_rate;
    scene_set_com_vy_by_leg(&runner, com_vy);
    scene_set_vertical_force(&runner, beyond);
    return runner;
}

/* A leg that swings forward already is clamped at 0: both laws agree to leave. One that swings backward is
 * turned round by the law of retract, which holds the foot down. After the apex place follows, at once to the
 * touchdown angle ahead. */
TEST(lift_off_goes_by_the_law_of_flight) {
    static const struct {
        double angle_rate, com_vy;
        int contact, phase;
        bool clamp_closed;
    } cases[] = {{0.5, 0.2, FLIGHT, RETRACT, true},
                 {-1.0, 0.2, GRAZE, RETRACT, false},
                 {0.5, -0.2, GRAZE, PLACE, false},
                 {2.0, -0.2, FLIGHT, PLACE, false}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        runner runner = lifting_off(cases[i].angle_rate, cases[i].com_vy);
        assert_true(enter(&runner, 1, cases[i].contact, cases[i].phase).mode_changed);
        assert_true(runner.motion.mode.clamp_closed == cases[i].clamp_closed);
        assert_true(runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] == -0.45);
    }
}

/* Laws that agree up to rounding leave a graze next to no width, and the foot leaves it at once. A gain of
 * the hip sets their difference: the flight law loads the foot by kd |thetadot| sin(0.45) / r. */
TEST(lift_off_into_graze_needs_laws_that_differ) {
    static const double gains[] = {0.0, 1e-12, 1e-10, 1e-6};
    for (int i = 0; i < 4; ++i) {
        runner runner = lifting_off(-1.0, 0.2);
        runner.model.parameters.hip.kp = 0.0;
        runner.model.parameters.hip.kd = gains[i];
        resolve(&runner, 1);
        assert_true(i < 3 || runner.motion.mode.contact == TDMF_CONTACT_GRAZE);
        while (runner.motion.time < 7.1) {
            assert_true(runner_advance(&runner, 1e-3));
        }
        assert_true(runner.resolutions < 5);
        assert_true(i == 3 || runner.motion.mode.contact == TDMF_CONTACT_FLIGHT);
    }
}

/* ---- slip ------------------------------------------------------------------------------------------- */

/* A still leg with f_y = 0.101 needs |f_x| = 0.1 tan|theta| to stick. */
static runner loaded_foot(int contact, double angle, double friction) {
    runner runner = scene_on_ground((tdmf_contact_mode)contact, angle, 0.101);
    runner.inputs.ground.friction = friction;
    runner.motion.state[TDMF_FOOT_VX] = beyond * tdmf_sign_of_slip(&runner.motion.mode);
    return runner;
}

/* A leg ahead of the body pushes the foot forward, one behind it backward. A slip that stops sticks inside
 * the cone; outside it, it reverses, or goes on where the excess drives it on. */
TEST(slips_begin_end_reverse_and_go_on_by_the_cone) {
    const double edge = 0.1 * tan(0.5) / 0.101;
    const struct {
        int before;
        double angle, friction;
        int events, after;
    } cases[] = {{STICK, 0.5, edge, 0, STICK},
                 {STICK, 0.5, edge - 1e-11, 1, FORWARD},
                 {STICK, -0.5, edge - 1e-11, 1, BACKWARD},
                 {FORWARD, 0.3, 0.6, 1, STICK},
                 {BACKWARD, 0.3, 0.6, 1, STICK},
                 {FORWARD, -0.5, 0.1, 1, BACKWARD},
                 {BACKWARD, 0.5, 0.1, 1, FORWARD},
                 {FORWARD, 0.5, 0.1, 1, FORWARD}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        runner runner = loaded_foot(cases[i].before, cases[i].angle, cases[i].friction);
        runner.motion.state[TDMF_STRIDE_MODE_BEGAN] = 1.0;
        const tdmf_resolution resolution = enter(&runner, cases[i].events, cases[i].after, COAST);
        assert_true(resolution.mode_changed == (cases[i].before != cases[i].after));
        assert_true(resolution.state_changed == (cases[i].before != STICK));
        assert_true(runner.motion.state[TDMF_FOOT_VX] == 0.0);
    }
}

/* A foot that rests holds up to rho mu. One whose slip comes to rest inside that sticks; outside it the foot
 * goes on along the excess, backwards here, and feels mu. */
TEST(static_friction_decides_whether_a_foot_rests) {
    const double edge = 0.1 * tan(0.5) / 0.101 / 1.25;
    static const int after[] = {STICK, FORWARD, STICK, BACKWARD};
    for (int i = 0; i < 4; ++i) {
        runner runner =
            loaded_foot(i < 2 ? STICK : FORWARD, i < 2 ? 0.5 : -0.5, edge + (i % 2 == 0 ? 1e-9 : -1e-9));
        runner.model.parameters.ground.static_friction_ratio = 1.25;
        enter(&runner, i == 0 ? 0 : 1, after[i], COAST);
        const tdmf_outputs now = OUTPUTS_OF(&runner);
        assert_true(i < 3 || fabs(now.contact.tangential - edge * now.contact.normal) < 1e-9);
    }
}

/* The cone is asked with the total torque: an upright leg alone would stick. */
TEST(slip_that_stops_under_external_torque_reverses) {
    runner runner = loaded_foot(FORWARD, 0.0, 0.6);
    runner.inputs.hip.external_torque = -0.2;
    enter(&runner, 1, BACKWARD, COAST);
}

/* The foot stops late. */
TEST(stopping_the_foot_leaves_the_body_alone) {
    runner runner = loaded_foot(FORWARD, 0.3, 0.6);
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = -1.0;
    runner.motion.state[TDMF_FOOT_VX] = -0.01;
    const tdmf_point before = tdmf_body(runner.motion.state);
    resolve(&runner, 1);
    const tdmf_point after = tdmf_body(runner.motion.state);
    assert_close(after.vx, before.vx, 1e-15);
    assert_close(after.vy, before.vy, 1e-15);
}

/* ---- mid-stance and force peak ---------------------------------------------------------------------- */

static runner at_mid_stance(double angle, double force) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, angle, force);
    runner.motion.mode.phase = TDMF_PHASE_DRIVE;
    runner.motion.mode.mid_stance_pending = true;
    return runner;
}

TEST(mid_stance_ends_the_drive_for_good) {
    runner runner = at_mid_stance(beyond, 0.3);
    assert_true(enter(&runner, 1, STICK, COAST).mode_changed);
    for (double angle = 0.2; angle > -0.3; angle -= 0.4) {
        runner.motion.state[TDMF_LEG_ANGLE] = angle;
        assert_false(scene_resolve(&runner).mode_changed);
    }
    assert_int_equal(runner.motion.state[TDMF_EVENT_COUNT], 1);
    assert_true(OUTPUTS_OF(&runner).hip.torque == 0.0);
}

/* Without the drive, which held it down, the foot lifts; without the torque that balanced the drive, it
 * slips: a chain is one event. */
TEST(mid_stance_may_end_the_contact_or_start_a_slip) {
    runner lifted = at_mid_stance(-0.3, -0.02), slipping = at_mid_stance(beyond, 0.3);
    scene_set_com_vy_by_leg(&lifted, 0.05);
    slipping.inputs.hip.external_torque = 0.2;
    slipping.inputs.ground.friction = 0.2;
    enter(&lifted, 1, FLIGHT, RETRACT);
    enter(&slipping, 1, FORWARD, COAST);
    assert_false(lifted.motion.mode.mid_stance_pending);
}

/* A still, compressed leg pushes off: f_y falls. */
TEST(force_peak_is_noted_uncounted) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.3);
    runner.motion.mode.ground_force_rising = true;
    const tdmf_resolution resolution = resolve(&runner, 0);
    assert_false(resolution.mode_changed || resolution.state_changed);
    assert_false(runner.motion.mode.ground_force_rising);
    assert_close(runner.motion.state[TDMF_STRIDE_PEAK_FORCE_SO_FAR], 0.3, 1e-15);
}

/* ---- graze ------------------------------------------------------------------------------------------ */

static runner grazing(double force, double vx) {
    runner runner = scene_on_ground(TDMF_CONTACT_GRAZE, -0.45, force);
    runner.motion.state[TDMF_FOOT_VX] = vx;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = -1.0;
    scene_set_com_vy_by_leg(&runner, 0.2);
    scene_set_vertical_force(&runner, force);
    return runner;
}

/* It lasts between the laws. A foot that is loaded slips with its velocity. At rest it sticks if its load is
 * large enough, as after a jump of the external torque; at the first load the cone is a point, and the weight
 * of the foot on its slanting leg makes it slip. */
TEST(graze_ends_where_the_foot_is_loaded) {
    static const struct {
        double force, vx;
        int events, contact, phase;
    } cases[] = {{-1e-3, 0.0, 0, GRAZE, RETRACT},     {-beyond, 0.1, 1, FORWARD, COAST},
                 {-beyond, -0.1, 1, BACKWARD, COAST}, {-beyond, 1e-12, 1, FORWARD, COAST},
                 {0.05, 0.0, 1, STICK, COAST},        {-beyond, 0.0, 1, FORWARD, COAST}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        runner runner = grazing(cases[i].force, cases[i].vx);
        enter(&runner, cases[i].events, cases[i].contact, cases[i].phase);
        assert_true(runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] == -0.45);
    }
}

/* The torque of the flight law, which was swinging the leg forward, has gone: it lifts too. */
TEST(graze_to_flight_keeps_the_angle_of_lift_off) {
    runner runner = grazing(-1e-3, 0.1);
    runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] = -0.4;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = 0.5;
    enter(&runner, 1, FLIGHT, RETRACT);
    assert_true(runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] == -0.4 && runner.motion.mode.clamp_closed);
}

/* The phase follows the centre of mass, but a stride closes in flight only. */
TEST(apex_in_graze_closes_no_stride) {
    runner runner = grazing(-1e-3, 0.1);
    runner.motion.state[TDMF_STRIDE_IS_OPEN] = 1.0;
    runner.motion.mode.clamp_closed = true;
    scene_set_com_vy_by_leg(&runner, beyond);
    scene_set_vertical_force(&runner, -1e-3);
    enter(&runner, 1, GRAZE, PLACE);
    assert_int_equal(runner.motion.state[TDMF_STRIDE_COUNT], 0);
    assert_true(last_apex_of(&runner.motion).time == 0.0);
    assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
}

/* ---- jumps of an input ------------------------------------------------------------------------------ */

/* Sticking in coast, the body rising, the foot loaded with 0.1 and held by f_x = 0.099 tan 0.3 = 0.031. */
static runner standing(double friction, double angle_rate) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -0.3, 0.1);
    runner.inputs.ground.friction = friction;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = angle_rate;
    scene_set_com_vy_by_leg(&runner, 0.05);
    scene_set_vertical_force(&runner, 0.1);
    enter(&runner, 0, STICK, COAST);
    return runner;
}

/* A law of retract that stops a fast backward swing outweighs the torque that lifts the foot. A jump beyond
 * both limits leaves the ground; the slip that it would start lasts no time. */
TEST(jumps_of_torque_and_friction_end_a_stance_or_start_a_slip) {
    static const struct {
        double before, angle_rate, torque, friction;
        int contact, phase;
    } cases[] = {{0.4, 0.0, -0.05, 0.4, BACKWARD, COAST}, {0.4, 0.0, 0.1, 0.4, FORWARD, COAST},
                 {0.4, 0.0, 0.0, 0.3, BACKWARD, COAST},   {1e3, 0.1, -0.5, 1e3, FLIGHT, RETRACT},
                 {1e3, -4.0, -0.5, 1e3, GRAZE, RETRACT},  {0.4, 0.1, -0.5, 0.0, FLIGHT, RETRACT}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        runner runner = standing(cases[i].before, cases[i].angle_rate);
        runner.motion.state[TDMF_STRIDE_MODE_BEGAN] = 1.0;
        runner.inputs.hip.external_torque = cases[i].torque;
        runner.inputs.ground.friction = cases[i].friction;
        enter(&runner, 1, cases[i].contact, cases[i].phase);
        assert_true(runner.motion.mode.clamp_closed == (cases[i].contact == FLIGHT));
        assert_string_equal(OUTPUTS_OF(&runner).open_word, "0");
    }
}

/* Loaded by a jump, a foot at rest in graze slips at once. In flight nothing happens. */
TEST(jumps_end_a_graze_and_cause_nothing_in_flight) {
    runner graze = scene_on_ground(TDMF_CONTACT_GRAZE, -0.3, -0.01);
    graze.motion.state[TDMF_LEG_ANGLE_RATE] = -2.0;
    scene_set_com_vy_by_leg(&graze, 0.05);
    scene_set_vertical_force(&graze, -0.01);
    resolve(&graze, 0);
    graze.inputs.hip.external_torque = 0.2;
    graze.inputs.ground.friction = 0.1;
    enter(&graze, 1, FORWARD, COAST);
    assert_true(graze.motion.state[TDMF_FOOT_VX] == 0.0);
    assert_true(graze.motion.state[TDMF_STRIDE_WORD_SO_FAR] == 0.0);
    runner flight = scene_in_flight(TDMF_PHASE_PLACE, -0.1);
    flight.inputs.hip.external_torque = 0.7;
    flight.inputs.ground.friction = 0.0;
    const tdmf_resolution resolution = scene_resolve(&flight);
    assert_false(resolution.mode_changed || resolution.state_changed);
}

/* ---- fall, exactly zero, and nothing due ------------------------------------------------------------- */

TEST(body_at_the_ground_and_short_leg_are_falls) {
    runner falls[] = {scene_in_flight(TDMF_PHASE_PLACE, -0.1),
                      scene_on_ground(TDMF_CONTACT_SLIP_NEGATIVE, 0.1, 0.1)};
    falls[0].motion.state[TDMF_LEG_ANGLE] = 2.5;
    falls[0].motion.state[TDMF_FOOT_Y] = 0.5;
    falls[1].motion.state[TDMF_LEG_LENGTH] = 0.05 + beyond;
    for (int i = 0; i < 2; ++i) {
        const runner before = falls[i];
        const tdmf_resolution resolution = resolve(&falls[i], 0);
        assert_true(resolution.mode_changed && !resolution.state_changed);
        assert_true(falls[i].motion.mode.fallen);
        assert_same_state(&falls[i].motion, &before.motion, 0.0);
        assert_false(scene_resolve(&falls[i]).mode_changed);
    }
}

TEST(an_event_is_due_where_its_guard_is_zero) {
    runner runner = at_mid_stance(-TDMF_GUARD_MARGIN, 0.1);
    assert_true(scene_guard(&runner, TDMF_GUARD_MID_STANCE) == 0.0);
    assert_int_equal(tdmf_first_due(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state),
                     TDMF_GUARD_MID_STANCE);
    enter(&runner, 1, STICK, COAST);
    assert_int_equal(tdmf_first_due(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state),
                     TDMF_GUARD_COUNT);
}

TEST(resolving_with_nothing_due_changes_nothing) {
    runner at_rest[] = {scene_in_flight(TDMF_PHASE_RETRACT, 0.1),
                        scene_in_flight(TDMF_PHASE_PLACE, -0.1),
                        scene_on_ground(TDMF_CONTACT_STICK, 0.3, 0.1),
                        scene_on_ground(TDMF_CONTACT_SLIP_POSITIVE, 0.3, 0.1),
                        scene_on_ground(TDMF_CONTACT_SLIP_NEGATIVE, 0.3, 0.1),
                        grazing(-1e-3, 0.1)};
    for (size_t i = 0; i < COUNT_OF(at_rest); ++i) {
        resolve(&at_rest[i], 0); /* notes the ground force */
        const tdmf_motion before = at_rest[i].motion;
        at_rest[i].motion.time = 8.0;
        const tdmf_resolution resolution = scene_resolve(&at_rest[i]);
        assert_false(resolution.state_changed || resolution.mode_changed);
        assert_same_state(&at_rest[i].motion, &before, 0.0);
        assert_memory_equal(&at_rest[i].motion.mode, &before.mode, sizeof before.mode);
    }
}

static runner upright(double length) {
    runner runner = runner_default(0.0);
    runner.model.parameters.hip.stance_torque = 0.0;
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.motion.state[TDMF_LEG_LENGTH] = length;
    runner_start(&runner);
    return runner;
}

/* No friction, no torque, no lean, no speed: |f_x| = 0 is inside a cone of no width. */
TEST(upright_foot_on_ice_stands) {
    runner runner = upright(0.9);
    for (int i = 0; i < 1000; ++i) {
        assert_true(runner_advance(&runner, 1e-3));
    }
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE);
    assert_int_equal(runner.motion.state[TDMF_EVENT_COUNT], 0);
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
