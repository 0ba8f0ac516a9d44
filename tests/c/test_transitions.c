/* Every reset alone: what one event makes of state, mode and record. */
#include "compare.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

static const double beyond = SCENE_PAST_EVENT;

/* Resolves at time 7 and asserts how many events that was. */
static tdmf_resolution resolve(runner *runner, int events) {
    runner->motion.time = 7.0;
    const tdmf_resolution resolution = scene_resolve(runner);
    assert_int_equal(runner->motion.record.event_count, events);
    assert_true(runner->motion.record.last_event_time == (events > 0 ? 7.0 : 0.0));
    return resolution;
}

/* ---- touchdown -------------------------------------------------------------------------------------- */

static void assert_touchdown(runner *runner) {
    const tdmf_resolution resolution = resolve(runner, 1);
    assert_true(resolution.state_changed && resolution.mode_changed);
    assert_int_equal(runner->motion.record.progress.open.touchdowns, 1);
    assert_true(runner->motion.record.impact_loss > 0.0);
    assert_true(runner->motion.state[TDMF_FOOT_Y] == 0.0 && runner->motion.state[TDMF_FOOT_VY] == 0.0);
}

TEST(touchdown_sticks_inside_the_cone) {
    runner runner = scene_at_impact(TDMF_PHASE_PLACE, 0.4, 0.1);
    assert_touchdown(&runner);
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE);
    assert_true(runner.motion.state[TDMF_FOOT_VX] == 0.0);
}

TEST(touchdown_slides_outside_the_cone) {
    runner forward = scene_at_impact(TDMF_PHASE_PLACE, 0.4, 0.1);
    runner backward = scene_at_impact(TDMF_PHASE_PLACE, 0.4, 0.1);
    forward.inputs.ground.friction = backward.inputs.ground.friction = 0.1;
    scene_set_foot_velocity(-0.05, -0.1, backward.motion.state);
    assert_touchdown(&forward);
    assert_touchdown(&backward);
    scene_assert_mode(&forward, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_DRIVE);
    scene_assert_mode(&backward, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_DRIVE);
    assert_close(forward.motion.state[TDMF_FOOT_VX], 0.04, 1e-16);
    assert_close(backward.motion.state[TDMF_FOOT_VX], -0.04, 1e-16);
}

/* A stance that begins upright or ahead drives; one that begins behind only coasts. */
TEST(touchdown_behind_the_body_coasts) {
    runner ahead = scene_at_impact(TDMF_PHASE_PLACE, 1e-9, 0.1);
    runner behind = scene_at_impact(TDMF_PHASE_PLACE, -1e-9, 0.1);
    assert_touchdown(&ahead);
    assert_touchdown(&behind);
    scene_assert_mode(&ahead, TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE);
    scene_assert_mode(&behind, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
}

/* A leg that falls from upright has passed mid-stance; one that turns forward first has not. */
TEST(touchdown_upright_is_driven_unless_the_leg_falls) {
    static const struct {
        double rate, stance_torque;
        tdmf_hip_phase phase;
    } cases[] = {{-0.1, 0.2, TDMF_PHASE_COAST},  {0.0, 0.2, TDMF_PHASE_COAST},
                 {0.1, 0.2, TDMF_PHASE_DRIVE},   {0.0, 0.0, TDMF_PHASE_DRIVE},
                 {-0.1, -0.2, TDMF_PHASE_COAST}, {0.0, -0.2, TDMF_PHASE_DRIVE}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
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
    static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};
    tdmf_solver solver = tdmf_solver_default();
    runner_start(runner);
    tdmf_motion motion = {.mode = runner->motion.mode, .record = runner->motion.record};
    memcpy(motion.state, runner->motion.state, sizeof motion.state);
    assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(runner), &no_rates, until, &motion),
                     TDMF_ARRIVED);
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
    for (int i = 0; i < 3; ++i) {
        for (double angle_rate = -0.1; angle_rate < 0.15; angle_rate += 0.1) {
            runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0);
            runner.motion.state[TDMF_LEG_LENGTH_RATE] = length_rates[i];
            runner.motion.state[TDMF_LEG_ANGLE_RATE] = angle_rate;
            runner.motion.state[TDMF_LEG_LENGTH] = 1.0 + foot_weight - damping * length_rates[i];
            run_from_start(&runner, 0.5, 5);
            assert_true(length_rates[i] > 0.0 ? runner.motion.mode.contact == TDMF_CONTACT_FLIGHT
                                              : tdmf_in_contact(&runner.motion.mode));
        }
    }
}

/* Pulled up by a stretched leg it leaves, though the leg shortens and the load grows. */
TEST(upright_foot_that_is_pulled_up_flies) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0);
    runner.motion.state[TDMF_LEG_LENGTH_RATE] = -0.5;
    scene_set_vertical_force(&runner, -0.01);
    runner_start(&runner);
    assert_int_equal(runner.motion.mode.contact, TDMF_CONTACT_FLIGHT);
    assert_int_equal(runner.motion.record.event_count, 0); /* it was never loaded */
}

/* Without damper and at rest its load is zero and so is its rate: it is about to grow as the body falls. */
TEST(upright_foot_without_load_at_rest_stays) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0);
    runner.model.parameters.leg.damping = 0.0;
    scene_set_vertical_force(&runner, 0.0);
    runner_start(&runner);
    assert_true(tdmf_in_contact(&runner.motion.mode));
}

/* The units are k l0, here 10^4, and sqrt(m/k), here 0.01. */
TEST(what_counts_as_no_load_and_as_rest_scales) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.stiffness = 1e4;
    runner unloaded = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0), resting = unloaded;
    unloaded.model = accepted_model(&parameters);
    resting.model = unloaded.model;
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
    runner rising = scene_at_impact(TDMF_PHASE_RETRACT, -0.4, 0.1);
    rising.motion.state[TDMF_FOOT_VY] = 0.1;
    runner resting = scene_at_impact(TDMF_PHASE_RETRACT, -0.4, 0.1);
    scene_set_foot_velocity(0.0, 0.0, resting.motion.state);
    resolve(&rising, 0);
    resolve(&resting, 1);
    assert_int_equal(rising.motion.mode.contact, TDMF_CONTACT_FLIGHT);
    scene_assert_mode(&resting, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    assert_int_equal(rising.motion.record.progress.open.touchdowns, 0);
    assert_true(rising.motion.state[TDMF_FOOT_Y] == 0.0);
    assert_true(resting.motion.state[TDMF_FOOT_Y] == 0.0 && resting.motion.record.impact_loss == 0.0);
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
    const tdmf_resolution resolution = resolve(&runner, 1);
    assert_true(resolution.mode_changed);
    assert_false(resolution.state_changed);
    scene_assert_mode(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE);

    const tdmf_apex *apex = &runner.motion.record.apex;
    assert_true(apex->time == 7.0);
    assert_close(apex->com_height, 1.0 + cos(0.6) / 1.1, 1e-15);
    assert_close(apex->com_speed, 0.5 + (0.125 * sin(0.6) - 0.25 * cos(0.6)) / 1.1, 1e-15);
    assert_true(apex->leg_length == 1.0 && apex->leg_angle == -0.6);
    assert_true(apex->leg_length_rate == 0.125 && apex->leg_angle_rate == 0.25);
    assert_int_equal(runner.motion.record.stride.count, 0);
}

static runner with_retract_argument(bool closed, double argument) {
    runner runner = scene_in_flight(TDMF_PHASE_RETRACT, 0.1);
    runner.motion.mode.clamp_closed = closed;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = -argument / 0.1;
    return runner;
}

TEST(clamp_opens_and_closes_uncounted) {
    runner opens = with_retract_argument(true, 2e-10);
    runner closes = with_retract_argument(false, -2e-10);
    assert_true(resolve(&opens, 0).mode_changed);
    assert_true(resolve(&closes, 0).mode_changed);
    assert_false(opens.motion.mode.clamp_closed);
    assert_true(closes.motion.mode.clamp_closed);
}

/* Inside the dead band either position stands. */
TEST(clamp_may_settle_at_zero) {
    for (int closed = 0; closed <= 1; ++closed) {
        runner runner = with_retract_argument(closed == 1, 0.0);
        assert_false(resolve(&runner, 0).mode_changed);
    }
}

/* ---- lift-off --------------------------------------------------------------------------------------- */

static runner lifting_off(double angle, double angle_rate, double com_vy) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, angle, 0.0);
    runner.motion.mode.liftoff_angle = 0.9; /* of an earlier stance */
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = angle_rate;
    scene_set_com_vy_by_leg(&runner, com_vy);
    scene_set_vertical_force(&runner, beyond);
    return runner;
}

/* The leg swings forward already, so the clamp holds the flight torque at 0: both laws agree to leave. */
TEST(lift_off_into_flight) {
    runner runner = lifting_off(-0.45, 0.5, 0.2);
    assert_true(resolve(&runner, 1).mode_changed);
    scene_assert_mode(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT);
    assert_true(runner.motion.mode.clamp_closed);
    assert_true(runner.motion.mode.liftoff_angle == -0.45);
}

/* The leg swings backward and the retract law turns it round, which holds the foot down. */
TEST(lift_off_into_graze) {
    runner runner = lifting_off(-0.45, -1.0, 0.2);
    assert_true(resolve(&runner, 1).mode_changed);
    scene_assert_mode(&runner, TDMF_CONTACT_GRAZE, TDMF_PHASE_RETRACT);
    assert_false(runner.motion.mode.clamp_closed);
    assert_true(runner.motion.mode.liftoff_angle == -0.45);
}

/* After the apex, place follows: at once to the touchdown angle ahead. */
TEST(lift_off_while_falling_goes_to_place) {
    runner holds = lifting_off(-0.45, 0.5, -0.2);
    runner lifts = lifting_off(-0.45, 2.0, -0.2);
    resolve(&holds, 1);
    resolve(&lifts, 1);
    scene_assert_mode(&holds, TDMF_CONTACT_GRAZE, TDMF_PHASE_PLACE);
    scene_assert_mode(&lifts, TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE);
    assert_true(lifts.motion.mode.liftoff_angle == -0.45);
}

/* Where both laws agree up to rounding a graze has next to no width, and the foot leaves it at once; a gain
 * of the hip sets how far they differ: the flight law loads the foot by kd |thetadot| sin(0.45) / r. */
TEST(lift_off_into_graze_needs_laws_that_differ) {
    static const double gains[] = {0.0, 1e-12, 1e-10, 1e-6};
    for (int i = 0; i < 4; ++i) {
        runner runner = lifting_off(-0.45, -1.0, 0.2);
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
static runner loaded_foot(tdmf_contact_mode contact, double angle, double friction) {
    runner runner = scene_on_ground(contact, angle, 0.101);
    runner.inputs.ground.friction = friction;
    return runner;
}

/* A leg ahead of the body pushes the foot forward, one behind it backward. */
TEST(slip_sets_on_the_way_the_excess_drives) {
    const double edge = 0.1 * tan(0.5) / 0.101;
    runner holds = loaded_foot(TDMF_CONTACT_STICK, 0.5, edge);
    runner ahead = loaded_foot(TDMF_CONTACT_STICK, 0.5, edge - 1e-11);
    runner behind = loaded_foot(TDMF_CONTACT_STICK, -0.5, edge - 1e-11);
    resolve(&holds, 0);
    assert_false(resolve(&ahead, 1).state_changed);
    assert_false(resolve(&behind, 1).state_changed);
    scene_assert_mode(&holds, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    scene_assert_mode(&ahead, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
    scene_assert_mode(&behind, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
}

TEST(slip_that_stops_inside_the_cone_sticks) {
    runner forward = loaded_foot(TDMF_CONTACT_SLIP_POSITIVE, 0.3, 0.6);
    runner backward = loaded_foot(TDMF_CONTACT_SLIP_NEGATIVE, 0.3, 0.6);
    forward.motion.state[TDMF_FOOT_VX] = beyond;
    backward.motion.state[TDMF_FOOT_VX] = -beyond;
    assert_true(resolve(&forward, 1).state_changed);
    assert_true(resolve(&backward, 1).state_changed);
    scene_assert_mode(&forward, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    scene_assert_mode(&backward, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    assert_true(forward.motion.state[TDMF_FOOT_VX] == 0.0 && backward.motion.state[TDMF_FOOT_VX] == 0.0);
}

TEST(slip_that_stops_outside_the_cone_reverses) {
    runner forward = loaded_foot(TDMF_CONTACT_SLIP_POSITIVE, -0.5, 0.1);
    runner backward = loaded_foot(TDMF_CONTACT_SLIP_NEGATIVE, 0.5, 0.1);
    forward.motion.state[TDMF_FOOT_VX] = beyond;
    backward.motion.state[TDMF_FOOT_VX] = -beyond;
    resolve(&forward, 1);
    resolve(&backward, 1);
    scene_assert_mode(&forward, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
    scene_assert_mode(&backward, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
}

/* A foot that rests holds up to rho mu. One whose slip comes to rest inside that sticks; outside it the foot
 * goes on along the excess, backwards here, and feels mu. */
TEST(static_friction_decides_whether_a_foot_rests) {
    const double edge = 0.1 * tan(0.5) / 0.101;
    runner holds = loaded_foot(TDMF_CONTACT_STICK, 0.5, edge / 1.25 + 1e-9);
    runner gives = loaded_foot(TDMF_CONTACT_STICK, 0.5, edge / 1.25 - 1e-9);
    runner sticks = loaded_foot(TDMF_CONTACT_SLIP_POSITIVE, -0.5, edge / 1.25 + 1e-9);
    runner goes_on = loaded_foot(TDMF_CONTACT_SLIP_POSITIVE, -0.5, edge / 1.25 - 1e-9);
    runner *const runners[] = {&holds, &gives, &sticks, &goes_on};
    for (int i = 0; i < 4; ++i) {
        runners[i]->model.parameters.ground.static_friction_ratio = 1.25;
        runners[i]->motion.state[TDMF_FOOT_VX] = i < 2 ? 0.0 : beyond;
        resolve(runners[i], i == 0 ? 0 : 1);
    }
    scene_assert_mode(&holds, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    scene_assert_mode(&gives, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
    scene_assert_mode(&sticks, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    scene_assert_mode(&goes_on, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
    const tdmf_ground_force force =
        tdmf_contact_force(SYSTEM_OF(&goes_on), &goes_on.motion.mode, goes_on.motion.state);
    assert_close(force.tangential, goes_on.inputs.ground.friction * force.normal, 1e-15);
}

/* The cone is asked with the total torque: an upright leg alone would stick. */
TEST(slip_that_stops_under_external_torque_reverses) {
    runner runner = loaded_foot(TDMF_CONTACT_SLIP_POSITIVE, 0.0, 0.6);
    runner.inputs.hip.external_torque = -0.2;
    runner.motion.state[TDMF_FOOT_VX] = beyond;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST);
}

/* Velocity touches zero, but the excess drives the foot on as before. */
TEST(slip_that_touches_zero_goes_on) {
    runner runner = loaded_foot(TDMF_CONTACT_SLIP_POSITIVE, 0.5, 0.1);
    runner.motion.record.progress.open.contact_start.time = 1.0;
    runner.motion.state[TDMF_FOOT_VX] = beyond;
    assert_false(resolve(&runner, 1).mode_changed);
    scene_assert_mode(&runner, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
    assert_true(runner.motion.state[TDMF_FOOT_VX] == 0.0);
    assert_string_equal(runner.motion.record.progress.open.word, "+");
}

/* The foot stops late. */
TEST(stopping_the_foot_leaves_the_body_alone) {
    runner runner = loaded_foot(TDMF_CONTACT_SLIP_POSITIVE, 0.3, 0.6);
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = -1.0;
    runner.motion.state[TDMF_FOOT_VX] = -0.01;
    const tdmf_point before = tdmf_body(runner.motion.state);
    resolve(&runner, 1);
    const tdmf_point after = tdmf_body(runner.motion.state);
    assert_close(after.vx, before.vx, 1e-15);
    assert_close(after.vy, before.vy, 1e-15);
}

/* ---- mid-stance and force peak ---------------------------------------------------------------------- */

TEST(mid_stance_ends_the_drive_for_good) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, beyond, 0.3);
    runner.motion.mode.phase = TDMF_PHASE_DRIVE;
    runner.motion.mode.mid_stance_pending = true;
    assert_true(resolve(&runner, 1).mode_changed);
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    runner.motion.state[TDMF_LEG_ANGLE] = 0.2;
    assert_false(scene_resolve(&runner).mode_changed);
    runner.motion.state[TDMF_LEG_ANGLE] = -0.2;
    assert_false(scene_resolve(&runner).mode_changed);
    assert_int_equal(runner.motion.record.event_count, 1);
    assert_true(tdmf_hip_torque(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state) == 0.0);
}

TEST(force_peak_is_noted_uncounted) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.3);
    runner.motion.mode.ground_force_rising = true; /* while a still, compressed leg pushes off: f_y falls */
    const tdmf_resolution resolution = resolve(&runner, 0);
    assert_false(resolution.mode_changed || resolution.state_changed);
    assert_false(runner.motion.mode.ground_force_rising);
    assert_close(runner.motion.record.progress.open.peak_force, 0.3, 1e-15);
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

TEST(graze_lasts_between_the_laws) {
    runner runner = grazing(-1e-3, 0.0);
    assert_false(resolve(&runner, 0).mode_changed);
}

TEST(graze_to_contact_slips_with_its_velocity) {
    static const double speeds[] = {0.1, -0.1, 1e-12};
    static const tdmf_contact_mode entered[] = {TDMF_CONTACT_SLIP_POSITIVE, TDMF_CONTACT_SLIP_NEGATIVE,
                                                TDMF_CONTACT_SLIP_POSITIVE};
    for (int i = 0; i < 3; ++i) {
        runner runner = grazing(-beyond, speeds[i]);
        resolve(&runner, 1);
        scene_assert_mode(&runner, entered[i], TDMF_PHASE_COAST);
        assert_true(runner.motion.mode.liftoff_angle == -0.45);
    }
}

/* A foot at rest sticks if its load is large enough, as after a jump of the external torque; at the
 * first load the cone is a point, and the weight of the foot on its slanting leg makes it slip. */
TEST(graze_to_contact_at_rest_asks_the_cone) {
    runner loaded = grazing(0.05, 0.0);
    runner touching = grazing(-beyond, 0.0);
    resolve(&loaded, 1);
    resolve(&touching, 1);
    scene_assert_mode(&loaded, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    scene_assert_mode(&touching, TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_COAST);
}

/* The torque of the flight law, which was swinging the leg forward, has gone: it lifts too. */
TEST(graze_to_flight_keeps_the_angle_of_lift_off) {
    runner runner = grazing(-1e-3, 0.1);
    runner.motion.mode.liftoff_angle = -0.4;
    runner.motion.state[TDMF_LEG_ANGLE_RATE] = 0.5;
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT);
    assert_true(runner.motion.mode.liftoff_angle == -0.4);
    assert_true(runner.motion.mode.clamp_closed);
}

/* The phase follows the centre of mass, but a stride closes in flight only. */
TEST(apex_in_graze_closes_no_stride) {
    runner runner = grazing(-1e-3, 0.1);
    runner.motion.record.progress.open.began_at_apex = true;
    runner.motion.mode.clamp_closed = true;
    scene_set_com_vy_by_leg(&runner, beyond);
    scene_set_vertical_force(&runner, -1e-3);
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_GRAZE, TDMF_PHASE_PLACE);
    assert_int_equal(runner.motion.record.stride.count, 0);
    assert_true(runner.motion.record.apex.time == 0.0);
    assert_true(runner.motion.record.progress.open.began_at_apex);
}

/* ---- fall ------------------------------------------------------------------------------------------- */

static void assert_falls(runner runner) {
    double before[TDMF_STATE_COUNT];
    memcpy(before, runner.motion.state, sizeof before);
    const tdmf_resolution resolution = resolve(&runner, 0);
    assert_true(resolution.mode_changed);
    assert_false(resolution.state_changed);
    assert_true(runner.motion.mode.fallen);
    assert_memory_equal(before, runner.motion.state, sizeof before);
    assert_false(scene_resolve(&runner).mode_changed);
}

TEST(body_at_the_ground_and_short_leg_are_falls) {
    runner flat = scene_in_flight(TDMF_PHASE_PLACE, -0.1);
    flat.motion.state[TDMF_LEG_ANGLE] = 2.5;
    flat.motion.state[TDMF_FOOT_Y] = 0.5;
    runner crushed = scene_on_ground(TDMF_CONTACT_SLIP_NEGATIVE, 0.1, 0.1);
    crushed.motion.state[TDMF_LEG_LENGTH] = 0.05 + beyond;
    assert_falls(flat);
    assert_falls(crushed);
}

/* ---- exactly zero, and nothing due
 * ------------------------------------------------------------------------------------ */

TEST(an_event_is_due_where_its_guard_is_zero) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, -TDMF_GUARD_MARGIN, 0.1);
    runner.motion.mode.phase = TDMF_PHASE_DRIVE;
    runner.motion.mode.mid_stance_pending = true;
    assert_true(scene_guard(&runner, TDMF_GUARD_MID_STANCE) == 0.0);
    assert_int_equal(tdmf_first_due(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state),
                     TDMF_GUARD_MID_STANCE);
    resolve(&runner, 1);
    scene_assert_mode(&runner, TDMF_CONTACT_STICK, TDMF_PHASE_COAST);
    assert_int_equal(tdmf_first_due(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state),
                     TDMF_GUARD_COUNT);
}

static void assert_rests(runner runner) {
    resolve(&runner, 0); /* notes the ground force */
    scene_snapshot before;
    scene_take_snapshot(&runner, &before);
    runner.motion.time = 8.0;
    const tdmf_resolution resolution = scene_resolve(&runner);
    assert_false(resolution.state_changed || resolution.mode_changed);
    scene_assert_unchanged(&runner, &before);
}

TEST(resolving_with_nothing_due_changes_nothing) {
    assert_rests(scene_in_flight(TDMF_PHASE_RETRACT, 0.1));
    assert_rests(scene_in_flight(TDMF_PHASE_PLACE, -0.1));
    assert_rests(scene_on_ground(TDMF_CONTACT_STICK, 0.3, 0.1));
    assert_rests(scene_on_ground(TDMF_CONTACT_SLIP_POSITIVE, 0.3, 0.1));
    assert_rests(scene_on_ground(TDMF_CONTACT_SLIP_NEGATIVE, 0.3, 0.1));
    assert_rests(grazing(-1e-3, 0.1));
}
