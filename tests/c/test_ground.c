/* The line that the runner runs on: when a new one is in force, and what does not depend on where it is. */
#include "compare.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- runs by the native solver ------------------------------------------------------------------------- */

/* The default runner with a leg of another length, scaled as section 5 of the paper has it. */
static tdmf_parameters parameters_of(double length) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.gravity *= length;
    parameters.leg.free_length *= length;
    parameters.leg.min_length *= length;
    parameters.hip.stance_torque *= length * length;
    parameters.hip.kp *= length * length;
    parameters.hip.kd *= length * length;
    return parameters;
}

/* The run starts at the apex of the gait at friction 0.6, over a line. */
static simulation run_of_length(double length, double height, double slope) {
    const tdmf_parameters parameters = parameters_of(length);
    const tdmf_model model = accepted_model(&parameters);
    const double *apex = (const double *)&reference_gaits[DEFAULT_GAIT].apex;
    tdmf_inputs inputs = tdmf_default_inputs();
    double section[TDMF_SECTION_COUNT], scales[TDMF_SECTION_COUNT];
    tdmf_section_scales(&model, scales);
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        section[i] = apex[i] * scales[i];
    }
    inputs.ground.height = height;
    inputs.ground.slope = slope;
    return simulation_from(&parameters, &inputs, section, tdmf_solver_default().relative_tolerance);
}

static simulation run_at_apex(double height, double slope) {
    return run_of_length(1.0, height, slope);
}

static void set_line(simulation *run, double height, double slope) {
    run->inputs.ground.height = height;
    run->inputs.ground.slope = slope;
    tdmf_resolve(SYSTEM_OF(run), &run->motion);
}

static bool waits(const simulation *run) {
    const tdmf_outputs outputs = OUTPUTS_OF(run);
    return outputs.ground.pending;
}

/* ---- when a new line is in force ----------------------------------------------------------------------- */

TEST(a_line_below_a_foot_in_flight_is_in_force_at_once_as_one_event) {
    simulation run = run_at_apex(0.0, 0.0);
    const double events = run.motion.state[TDMF_EVENT_COUNT];
    set_line(&run, -0.1, 0.02);
    assert_false(waits(&run));
    assert_true(run.motion.mode.ground.height == -0.1 && run.motion.mode.ground.slope == 0.02);
    assert_int_equal(run.motion.state[TDMF_EVENT_COUNT], events + 1);
    simulation_stride(&run);
    const tdmf_event *touchdown = simulation_event(&run, TDMF_GUARD_TOUCHDOWN);
    assert_non_null(touchdown);
    assert_close(touchdown->state[TDMF_FOOT_Y], -0.1 + touchdown->state[TDMF_FOOT_X] * tan(0.02), 1e-12);
}

/* All that happens in zero time is one event, however many calls it takes. */
TEST(a_line_set_at_the_instant_of_an_event_is_part_of_that_event) {
    simulation run = run_at_apex(0.0, 0.0);
    simulation_stride(&run);
    const double events = run.motion.state[TDMF_EVENT_COUNT];
    assert_true(last_event_of(&run.motion) == run.motion.time);
    set_line(&run, -0.1, 0.02);
    assert_true(run.motion.mode.ground.height == -0.1);
    assert_int_equal(run.motion.state[TDMF_EVENT_COUNT], events);
}

TEST(the_same_line_set_again_is_no_event) {
    simulation run = run_at_apex(0.3, 0.01);
    const double events = run.motion.state[TDMF_EVENT_COUNT];
    set_line(&run, 0.3, 0.01);
    assert_false(waits(&run));
    assert_int_equal(run.motion.state[TDMF_EVENT_COUNT], events);
}

/* A step under a stance: until lift-off the old ground is the ground. */
TEST(a_foot_that_stands_keeps_its_ground) {
    simulation run = run_at_apex(0.0, 0.0);
    assert_int_equal(simulation_advance(&run, 12.5), TDMF_ARRIVED);
    assert_true(tdmf_is_loaded(&run.motion.mode));
    set_line(&run, -0.05, 0.0);
    assert_true(waits(&run));
    assert_true(run.motion.mode.ground.height == 0.0 && run.motion.state[TDMF_FOOT_Y] == 0.0);
    simulation_stride(&run);
    const tdmf_event *lift_off = simulation_event(&run, TDMF_GUARD_LIFT_OFF);
    const tdmf_event *graze_end = simulation_event(&run, TDMF_GUARD_GRAZE_TO_FLIGHT);
    assert_true(lift_off->after.contact == TDMF_CONTACT_GRAZE && lift_off->after.ground.height == 0.0);
    assert_true(graze_end->before.ground.height == 0.0 && graze_end->after.ground.height == -0.05);
    assert_close(last_apex_of(&run.motion).com_height,
                 tdmf_center_of_mass(&run.model, run.motion.state).y + 0.05, 1e-15);
    assert_false(waits(&run));
}

/* A step up under a stance: the foot leaves from below it, and passes it on its way up. */
TEST(a_foot_below_a_new_step_passes_it_on_its_way_up) {
    static const double step = 0.03;
    simulation run = run_at_apex(0.0, 0.0);
    assert_int_equal(simulation_advance(&run, 12.5), TDMF_ARRIVED);
    set_line(&run, step, 0.0);
    simulation_stride(&run);
    const tdmf_event *graze_end = simulation_event(&run, TDMF_GUARD_GRAZE_TO_FLIGHT);
    const tdmf_event *passed = simulation_event(&run, TDMF_GUARD_NEW_GROUND);
    assert_true(graze_end->after.ground.height == 0.0);
    assert_close(passed->state[TDMF_FOOT_Y], step, 1e-11);
    assert_true(passed->state[TDMF_FOOT_VY] > 0.0 && passed->time > graze_end->time);
    assert_true(passed->before.ground.height == 0.0 && passed->after.ground.height == step);
    simulation_stride(&run);
    assert_close(simulation_event(&run, TDMF_GUARD_TOUCHDOWN)->state[TDMF_FOOT_Y], step, 1e-11);
}

/* However coarse the steps, it is not below the line that is in force, on which it would land as it rises. */
TEST(a_foot_that_passes_a_new_step_has_passed_it_at_any_tolerance) {
    for (int k = 0; k < 60; ++k) {
        simulation run = run_at_apex(0.0, 0.0);
        assert_int_equal(simulation_advance(&run, 12.5), TDMF_ARRIVED);
        run.solver.relative_tolerance = pow(10.0, -2.0 - 0.1 * k);
        set_line(&run, 0.03, 0.0);
        assert_int_equal(simulation_advance(&run, 25.0), TDMF_ARRIVED);
        const tdmf_event *passed = simulation_event(&run, TDMF_GUARD_NEW_GROUND);
        assert_non_null(passed);
        assert_true(passed->state[TDMF_FOOT_Y] > 0.03 - 2e-12);
        assert_close(passed->state[TDMF_FOOT_Y], 0.03, 1e-2 * run.solver.relative_tolerance + 2e-12);
        assert_int_equal(passed->after.contact, TDMF_CONTACT_FLIGHT);
    }
}

TEST(a_line_far_below_takes_no_digits_from_a_foot_in_flight) {
    simulation run = run_at_apex(0.0, 0.0);
    const double energy = simulation_energy(&run);
    const double height = tdmf_center_of_mass(&run.model, run.motion.state).y;
    set_line(&run, -1e8, 0.01);
    assert_false(waits(&run));
    assert_close(simulation_energy(&run), energy, 1e-15);
    assert_int_equal(simulation_advance(&run, 10.0), TDMF_ARRIVED);
    assert_close(simulation_ledger_error(&run), 0.0, 1e-13);
    assert_close(tdmf_center_of_mass(&run.model, run.motion.state).y,
                 height - 0.5 * run.model.parameters.gravity * 100.0, 1e-13);
}

/* Never above it, the foot lands on the old ground, fall and section included. */
TEST(a_foot_that_stays_below_a_new_step_runs_on_the_old_ground) {
    simulation high = run_at_apex(0.0, 0.0), plain = run_at_apex(0.0, 0.0);
    set_line(&high, 100.0, 0.3);
    for (int i = 0; i < 3; ++i) {
        simulation_stride(&high);
        simulation_stride(&plain);
        assert_true(waits(&high));
        assert_true(fabs(last_apex_of(&high.motion).com_height - last_apex_of(&plain.motion).com_height) <
                    1e-11);
        assert_int_equal(high.motion.state[TDMF_EVENT_COUNT], plain.motion.state[TDMF_EVENT_COUNT]);
    }
}

TEST(the_last_line_set_replaces_one_that_waits) {
    simulation run = run_at_apex(0.0, 0.0);
    const double events = run.motion.state[TDMF_EVENT_COUNT];
    set_line(&run, 50.0, 0.1);
    assert_true(waits(&run));
    set_line(&run, 60.0, -0.1);
    assert_true(waits(&run));
    set_line(&run, 0.0, 0.0);
    assert_false(waits(&run));
    assert_int_equal(run.motion.state[TDMF_EVENT_COUNT], events);
    set_line(&run, 50.0, 0.1);
    set_line(&run, 0.01, 0.01);
    assert_false(waits(&run));
    assert_int_equal(run.motion.state[TDMF_EVENT_COUNT], events + 1);
}

/* The next apex is that of a runner that is lower by the step. */
TEST(a_step_set_at_an_apex_shifts_its_height_by_its_own_and_no_more) {
    static const double step = 0.02;
    simulation stepped = run_at_apex(0.0, 0.0), lower = run_at_apex(0.0, 0.0);
    double section[TDMF_SECTION_COUNT];
    set_line(&stepped, step, 0.0);
    simulation_stride(&stepped);
    memcpy(section, &reference_gaits[DEFAULT_GAIT].apex, sizeof section);
    section[TDMF_SECTION_COM_HEIGHT] -= step;
    const tdmf_return next = return_map(&lower.solver, SYSTEM_OF(&lower), section, 1e9, false, NULL, 0);
    double reached[TDMF_SECTION_COUNT];
    read_apex(&stepped.motion, reached);
    assert_all_close(reached, next.apex, TDMF_SECTION_COUNT, 1e-11, 0.0);
    assert_close(last_stride_of(&stepped.motion).rise,
                 next.apex[0] + step - reference_gaits[DEFAULT_GAIT].apex.com_height, 1e-11);
}

/* A foot within 1e-12 l0 of a line is not above it yet, however it moves. */
TEST(a_new_line_is_in_force_below_the_foot) {
    static const double beside = 0.9e-12, apart = 2e-12;
    static const struct {
        double height, rate;
        bool in_force;
    } cases[] = {{-beside, 1.0, false}, {-beside, 0.0, false}, {-beside, -1.0, false}, {beside, -1.0, false},
                 {beside, 1.0, false},  {apart, -1.0, true},   {-apart, 1.0, false}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        runner runner = scene_in_flight(TDMF_PHASE_PLACE, -0.1);
        runner.motion.state[TDMF_FOOT_VY] = 0.01 * cases[i].rate;
        runner.inputs.ground.height = runner.motion.state[TDMF_FOOT_Y] - cases[i].height;
        runner.motion.time = 0.0;
        const tdmf_resolution taken = tdmf_resolve(SYSTEM_OF(&runner), &runner.motion);
        assert_false(taken.unresolved);
        assert_true((runner.motion.mode.ground.height != 0.0) == cases[i].in_force);
    }
}

/* ---- start --------------------------------------------------------------------------------------------- */

static runner standing_on(double height, double slope) {
    runner runner = runner_default(0.6);
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.inputs.ground.height = height;
    runner.inputs.ground.slope = slope;
    runner.motion.state[TDMF_FOOT_X] = 2.0;
    runner.motion.state[TDMF_FOOT_Y] = height + 2.0 * tan(slope);
    runner.motion.state[TDMF_LEG_LENGTH] = 0.95;
    return runner;
}

TEST(a_start_beside_the_ground_is_one_on_it) {
    static const double off[] = {0.0, 0.9e-12, -0.9e-12};
    for (int i = 0; i < 3; ++i) {
        runner runner = standing_on(0.4, 0.1);
        runner.motion.state[TDMF_FOOT_Y] += off[i];
        runner.motion.state[TDMF_FOOT_VY] = off[(i + 1) % 3];
        runner_start(&runner);
        const tdmf_point foot = tdmf_foot_over_ground(&runner.motion.mode.ground, runner.motion.state);
        assert_true(tdmf_is_loaded(&runner.motion.mode));
        assert_close(foot.y, 0.0, 4.0 * DBL_EPSILON);
        assert_close(foot.vy, 0.0, DBL_EPSILON * 1e-12);
        assert_int_equal(runner.motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR], 0);
    }
}

TEST(a_start_below_the_ground_is_refused) {
    runner runner = standing_on(0.4, 0.1);
    runner.motion.state[TDMF_FOOT_Y] -= 2e-12;
    runner.motion.time = 0.0;
    const tdmf_refusal foot = tdmf_start(SYSTEM_OF(&runner), &runner.motion);
    assert_string_equal(foot.variable, "foot.y");
    assert_close(foot.minimum, 0.4 + 2.0 * tan(0.1), 1e-15);
    runner.motion.state[TDMF_FOOT_Y] += 0.1;
    runner.motion.state[TDMF_LEG_ANGLE] = 2.0;
    const tdmf_refusal body = tdmf_start(SYSTEM_OF(&runner), &runner.motion);
    assert_string_equal(body.variable, "body.y");
}

/* ---- what does not depend on where the ground is ------------------------------------------------------- */

/* Up with the ground, or along it: the pivot of a line is no place on it. */
TEST(a_runner_that_is_moved_with_its_ground_runs_alike) {
    static const double slopes[] = {-0.07, 0.0, 0.02};
    static const double shifts[][2] = {{0.0, 0.7}, {40.0, 0.0}, {-3.0, 10.0}};
    int compared = 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            simulation here = run_at_apex(0.0, slopes[i]), there = run_at_apex(0.0, slopes[i]);
            there.motion.state[TDMF_FOOT_X] += shifts[k][0];
            there.motion.state[TDMF_FOOT_Y] += shifts[k][1];
            there.inputs.ground.height = shifts[k][1] - shifts[k][0] * tan(slopes[i]);
            simulation_start(&there);
            for (int n = 0; n < 3; ++n, ++compared) {
                simulation_stride(&here);
                simulation_stride(&there);
                assert_same_stride(last_stride_of(&here.motion), last_stride_of(&there.motion), 1e-9);
                assert_close(last_apex_of(&here.motion).com_height, last_apex_of(&there.motion).com_height,
                             1e-9);
            }
        }
    }
    assert_int_equal(compared, 27);
}

/* ---- random runs --------------------------------------------------------------------------------------- */

/* The runner is that of Table 1 with all numbers off, over a slope, and starts off its gait's apex. */
static bool begin_random(random_source *source, simulation *run) {
    tdmf_parameters p = tdmf_default_parameters();
    double section[TDMF_SECTION_COUNT];
    p.foot.mass = random_magnitude(source, 0.02, 0.5);
    p.leg.damping = random_magnitude(source, 0.03, 1.0);
    p.gravity *= random_magnitude(source, 0.7, 3.0);
    p.hip.stance_torque = random_uniform(source, -0.1, 0.3);
    p.hip.touchdown_angle += random_uniform(source, -0.4, 0.2);
    p.hip.kp = random_magnitude(source, 0.03, 1.0);
    p.hip.kd = random_magnitude(source, 0.03, 1.0);
    p.hip.liftoff_angle_factor = random_uniform(source, 0.5, 1.5);
    p.hip.swing_clamp = random_truth(*source);
    *run = run_at_apex(random_uniform(source, -1.0, 1.0), random_uniform(source, -0.3, 0.2));
    run->inputs.ground.friction = random_magnitude(source, 0.05, 5.0);
    run->model = accepted_model(&p);
    memcpy(section, &reference_gaits[DEFAULT_GAIT].apex, sizeof section);
    section[TDMF_SECTION_COM_HEIGHT] += random_uniform(source, -0.2, 0.2);
    section[TDMF_SECTION_COM_SPEED] *= random_uniform(source, 0.3, 1.3);
    tdmf_section_state(SYSTEM_OF(run), section, run->motion.state);
    run->motion.time = 0.0;
    return tdmf_start(SYSTEM_OF(run), &run->motion).variable == NULL;
}

/* The guard that has fired is at zero, and none is below it: what the series find is what the model says. */
static void assert_no_guard_is_missed(const simulation *run, const tdmf_event *event) {
    double guards[TDMF_GUARD_COUNT];
    tdmf_guards(SYSTEM_OF(run), &event->before, event->state, guards);
    assert_close(guards[event->guard], 0.0, 1e-9);
    for (int g = 0; g < TDMF_GUARD_COUNT; ++g) {
        assert_true(g == TDMF_GUARD_FORCE_PEAK || g == TDMF_GUARD_VERTICAL_FORCE_PEAK || guards[g] > -1e-9);
    }
}

TEST(every_event_on_a_slope_is_where_its_guard_is_zero) {
    enum { RUNS = 600 };
    int seen[TDMF_GUARD_COUNT] = {0}, apexes_in_graze = 0;
    for (uint64_t seed = 0; seed < RUNS; ++seed) {
        random_source source = {seed};
        simulation run;
        if (!begin_random(&source, &run)) {
            continue;
        }
        simulation_advance(&run, 60.0);
        for (int i = 0; i < run.log.count && i < TDMF_EVENT_CAPACITY; ++i) {
            const tdmf_event *event = &run.log.events[i];
            assert_no_guard_is_missed(&run, event);
            ++seen[event->guard];
            apexes_in_graze += event->guard == TDMF_GUARD_APEX && event->before.contact == TDMF_CONTACT_GRAZE;
        }
    }
    assert_true(seen[TDMF_GUARD_TOUCHDOWN] > 300 && seen[TDMF_GUARD_APEX] > 300);
    assert_true(seen[TDMF_GUARD_MID_STANCE] > 300 && seen[TDMF_GUARD_GRAZE_TO_FLIGHT] > 300);
    assert_true(seen[TDMF_GUARD_BODY_DOWN] > 20 && seen[TDMF_GUARD_SLIP_VELOCITY_ZERO] > 300);
    assert_true(apexes_in_graze > 5);
}

/* Places up there are rounded to more than the margins of guards, which must not keep a foot at its line from
 * touching down. */
TEST(a_runner_on_a_slope_far_up_or_down_runs_on) {
    static const double heights[] = {9e10, -9e10, 3e9, -3e9, 1e8, -1e8, 7e4};
    static const double length = 1e-3, slope = 5e-3;
    enum { STRIDES = 50 };
    for (size_t i = 0; i < COUNT_OF(heights); ++i) {
        simulation near = run_of_length(length, 0.0, slope);
        simulation far = run_of_length(length, heights[i] * length, slope);
        const double rounding = DBL_EPSILON * fabs(heights[i]) * far.model.scales.speed;
        for (int count = 1; count <= STRIDES; ++count) {
            simulation_stride(&near);
            simulation_stride(&far);
            assert_int_equal(last_stride_of(&far.motion).word_code, last_stride_of(&near.motion).word_code);
            assert_close(last_stride_of(&far.motion).speed, last_stride_of(&near.motion).speed,
                         1e2 * rounding);
        }
    }
}
