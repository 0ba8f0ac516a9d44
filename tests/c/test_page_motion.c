/* A motion on the runner's page: what is read of it is written back, and a run that is cut goes on as one
 * that is not. */
#include "compare.h"
#include "page_solver.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

enum { RUNS = 400 / TDMF_SAMPLE_DIVISOR, CHANGES = 7 };
typedef enum { WHOLE, CUT_AT_TIMES, CUT_AT_EVENTS, CUT_AT_STEPS, WAYS } way_to_run;

/* Inputs from a time on. */
typedef struct {
    double time;
    tdmf_inputs inputs, rates;
} change;

/* A runner at its start, and what its inputs do. */
typedef struct {
    tdmf_model model;
    change changes[CHANGES + 1]; /* the run ends at the time of the last one */
    tdmf_motion motion;
} case_of_run;

static double chosen(random_source *source, double probability, double otherwise, double least, double most) {
    return random_chance(source, probability) ? random_uniform(source, least, most) : otherwise;
}

/* Sets a new line of the ground, which may wait to take effect. */
static void change_ground(random_source *source, tdmf_inputs *inputs, bool is_sloped) {
    inputs->ground.height = chosen(source, 0.7, inputs->ground.height, -0.3, 0.6);
    inputs->ground.slope = is_sloped ? chosen(source, 0.4, inputs->ground.slope, -0.1, 0.1) : 0.0;
}

static void change_others(random_source *source, change *at) {
    tdmf_inputs *inputs = &at->inputs, *rates = &at->rates;
    inputs->body.external_fx = chosen(source, 0.3, 0.0, -5e-3, 5e-3);
    inputs->body.external_fy = chosen(source, 0.3, 0.0, -0.02, 0.02);
    inputs->leg.extension = chosen(source, 0.3, inputs->leg.extension, -0.02, 0.02);
    inputs->control.thrust = chosen(source, 0.2, inputs->control.thrust, -0.01, 0.02);
    if (random_chance(source, 0.4)) {
        rates->body.external_fx = chosen(source, 0.5, 0.0, -1e-3, 1e-3);
        rates->body.external_fy = chosen(source, 0.5, 0.0, -4e-3, 4e-3);
        rates->leg.extension = chosen(source, 0.5, 0.0, -1e-3, 1e-3);
        rates->ground.friction = chosen(source, 0.5, 0.0, -0.1, 0.1);
        rates->hip.external_torque = chosen(source, 0.5, 0.0, -1e-3, 1e-3);
    }
}

static void choose_changes(random_source *source, case_of_run *it, bool has_everything) {
    for (int i = 1; i <= CHANGES; ++i) {
        change *at = &it->changes[i];
        *at = it->changes[i - 1];
        at->time += random_uniform(source, 0.0, 9.0);
        memset(&at->rates, 0, sizeof at->rates);
        change_ground(source, &at->inputs, has_everything);
        if (has_everything) {
            change_others(source, at);
        }
    }
}

/* A random runner, mostly with everything on. */
static case_of_run random_case(random_source *source) {
    case_of_run it;
    tdmf_parameters parameters = tdmf_default_parameters();
    memset(&it, 0, sizeof it);
    tdmf_inputs *inputs = &it.changes[0].inputs;
    *inputs = tdmf_default_inputs();
    inputs->ground.friction = random_uniform(source, 0.05, 1.2);
    parameters.hip.swing_clamp = random_chance(source, 0.5);
    const bool has_everything = random_chance(source, 0.6);
    if (has_everything) {
        parameters.leg.thrust = random_uniform(source, 0.0, 0.03);
        parameters.hip.retraction_rate = random_uniform(source, 0.0, 0.01);
        parameters.ground.static_friction_ratio = random_uniform(source, 1.0, 1.5);
        parameters.ground.stribeck_velocity = random_chance(source, 0.5) ? 0.2 : 0.0;
        parameters.ground.patch_begin = random_uniform(source, 5.0, 10.0);
        parameters.ground.patch_end = parameters.ground.patch_begin + random_uniform(source, 0.0, 8.0);
        inputs->ground.slope = random_uniform(source, -0.05, 0.05);
        inputs->leg.extension = random_uniform(source, -0.02, 0.02);
        inputs->body.external_fx = random_chance(source, 0.4) ? 5e-4 : 0.0;
    }
    choose_changes(source, &it, has_everything);
    tdmf_default_state(it.motion.state);
    it.motion.state[TDMF_FOOT_Y] += random_uniform(source, 0.3, 0.6);
    it.motion.state[TDMF_LEG_ANGLE] += random_uniform(source, -0.2, 0.2);
    it.motion.state[TDMF_FOOT_VY] += random_chance(source, 0.3) ? random_uniform(source, -0.1, 0.1) : 0.0;
    it.model = accepted_model(&parameters);
    return it;
}

/* Calls the solver once more. True if the run has reached `until` or its end. */
static bool go_on(const case_of_run *it, const change *at, double until, tdmf_solver *solver,
                  tdmf_motion *motion) {
    const tdmf_inputs inputs = tdmf_inputs_after(&at->inputs, &at->rates, motion->time - at->time);
    const tdmf_outcome outcome =
        tdmf_native_advance(solver, (tdmf_system){&it->model, &inputs}, &at->rates, until, motion);
    assert_true(outcome == TDMF_ARRIVED || outcome == TDMF_FELL || outcome == TDMF_TOO_MANY_EVENTS ||
                outcome == TDMF_TOO_MANY_STEPS);
    return outcome == TDMF_FELL || motion->time == until;
}

static void assert_is_written_back(const case_of_run *it, const change *at, const tdmf_motion *motion);

static tdmf_motion end_of(const case_of_run *it, random_source *source, way_to_run way) {
    tdmf_motion motion = it->motion;
    for (int i = 0; i < CHANGES && !motion.mode.fallen; ++i) {
        const double end = it->changes[i + 1].time;
        bool is_over = false;
        while (!is_over) {
            tdmf_solver solver = solver_to(1e-13);
            solver.event_limit = way == CUT_AT_EVENTS ? 1 : solver.event_limit;
            solver.step_limit =
                way == CUT_AT_STEPS ? 1 + (long)random_uniform(source, 0.0, 4.0) : solver.step_limit;
            const double piece = way == CUT_AT_TIMES ? random_uniform(source, 0.0, 2.0) : INFINITY;
            const double until = fmin(end, motion.time + piece);
            is_over =
                go_on(it, &it->changes[i], until, &solver, &motion) && (until == end || motion.mode.fallen);
            assert_is_written_back(it, &it->changes[i], &motion);
        }
    }
    return motion;
}

static void assert_same_mode(const tdmf_mode *a, const tdmf_mode *b) {
    assert_int_equal(a->contact, b->contact);
    assert_int_equal(a->phase, b->phase);
    assert_int_equal(a->zone, b->zone);
    assert_int_equal(a->clamp_closed, b->clamp_closed);
    assert_int_equal(a->fallen, b->fallen);
    assert_int_equal(a->thrusts, b->thrusts);
    assert_int_equal(a->rises, b->rises);
    assert_int_equal(a->mid_stance_pending, b->mid_stance_pending);
    assert_true(tdmf_sign_of_slip(a) == tdmf_sign_of_slip(b));
    assert_close(a->rest_length, b->rest_length, 1e-12);
    assert_close(a->ground.height, b->ground.height, 0.0);
    assert_close(a->ground.slope, b->ground.slope, 0.0);
}

static void assert_same_memory(const tdmf_motion *a, const tdmf_motion *b) {
    assert_same_stride(last_stride_of(a), last_stride_of(b), 1e-8);
    assert_close(last_apex_of(a).time, last_apex_of(b).time, 1e-8);
    assert_close(last_event_of(a), last_event_of(b), 1e-8);
}

/* Asserts that the page writes a motion back, and that the plain page does if it suits the runner. */
static void assert_is_written_back(const case_of_run *it, const change *at, const tdmf_motion *motion) {
    const tdmf_inputs inputs = tdmf_inputs_after(&at->inputs, &at->rates, motion->time - at->time);
    const tdmf_system system = {&it->model, &inputs};
    tdmf_page_point point = tdmf_page_of_motion(system, &at->rates, motion);
    for (int is_plain = 0; is_plain <= tdmf_suits_plain_page(&point); ++is_plain) {
        tdmf_motion written = *motion;
        tdmf_page_point taken = point;
        tdmf_runner_run run;
        tdmf_begin_runner_run(&run, &point, is_plain);
        tdmf_end_runner_run(&run, &taken);
        tdmf_motion_of_page(system, &taken, point.mode, &written);
        assert_same_state(motion, &written, 1e-14);
        assert_same_mode(&motion->mode, &written.mode);
        assert_same_memory(motion, &written);
        assert_true(motion->time == written.time);
    }
}

/* No matter where a run is cut, also where new ground waits or a push or a ramp acts. */
TEST(test_a_run_that_is_cut_goes_on_as_one_that_is_not) {
    int strides = 0, falls = 0;
    for (int i = 0; i < RUNS; ++i) {
        random_source source = {(uint64_t)i}; /* no run depends on the number of steps of another one */
        case_of_run it = random_case(&source);
        if (tdmf_start((tdmf_system){&it.model, &it.changes[0].inputs}, &it.motion).variable) {
            continue;
        }
        const tdmf_motion whole = end_of(&it, &source, WHOLE);
        for (way_to_run way = CUT_AT_TIMES; way < WAYS; ++way) {
            const tdmf_motion cut = end_of(&it, &source, way);
            assert_same_state(&whole, &cut, 1e-7);
            assert_same_mode(&whole.mode, &cut.mode);
            assert_same_memory(&whole, &cut);
        }
        strides += (int)whole.state[TDMF_STRIDE_COUNT];
        falls += whole.mode.fallen;
    }
    assert_true(strides > RUNS / 3 && falls > RUNS / 50);
}

/* A thrust that is set later acts at once, no matter how often the leg has been shortened since. */
TEST(test_a_greatest_compression_within_a_call_is_noted) {
    runner standing = runner_default(1.0);
    standing.model.parameters.leg.damping = 0.01;
    standing.model.parameters.hip.stance_torque = 0.0;
    memset(standing.motion.state, 0, sizeof standing.motion.state);
    standing.motion.state[TDMF_LEG_LENGTH] = 0.99;
    standing.motion.state[TDMF_LEG_LENGTH_RATE] = -0.005;
    runner_start(&standing);
    assert_false(standing.motion.mode.thrusts);
    tdmf_solver solver = tdmf_solver_default();
    const double second_compression = 7.0;
    assert_int_equal(
        tdmf_native_advance(&solver, SYSTEM_OF(&standing), NULL, second_compression, &standing.motion),
        TDMF_ARRIVED);
    assert_true(standing.motion.state[TDMF_LEG_LENGTH_RATE] < 0.0);
    assert_int_equal(standing.motion.mode.contact, TDMF_CONTACT_STICK);
    assert_true(standing.motion.mode.thrusts);
}

TEST(test_a_run_of_any_page_has_the_memory_that_it_needs) {
    assert_true(tdmf_run_memory_size(&tdmf_runner_model, TDMF_VARIATION_LIMIT) <= TDMF_PAGE_MEMORY);
}
