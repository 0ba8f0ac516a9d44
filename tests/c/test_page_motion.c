/* A motion on the runner's page: what is read of it is written back, a run that is saved in the middle of a
 * stride goes on as one that is not, and the core's series come to the same motion. */
#include "compare.h"
#include "page_solver.h"
#include "scene.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

enum { RUNS = 400 / TDMF_SAMPLE_DIVISOR, PIECES = 5 };
static const tdmf_inputs held = {0};

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    tdmf_motion motion;
} case_of_run;

/* A random runner with everything on, at its start. */
static case_of_run random_case(random_source *source) {
    case_of_run it;
    tdmf_parameters parameters = tdmf_default_parameters();
    it.inputs = tdmf_default_inputs();
    it.inputs.ground.friction = random_uniform(source, 0.05, 1.2);
    parameters.hip.swing_clamp = random_chance(source, 0.5);
    if (random_chance(source, 0.6)) {
        parameters.leg.thrust = random_uniform(source, 0.0, 0.03);
        parameters.hip.retraction_rate = random_uniform(source, 0.0, 0.01);
        parameters.ground.static_friction_ratio = random_uniform(source, 1.0, 1.5);
        parameters.ground.stribeck_velocity = random_chance(source, 0.5) ? 0.2 : 0.0;
        parameters.ground.patch_begin = random_uniform(source, 5.0, 10.0);
        parameters.ground.patch_end = parameters.ground.patch_begin + random_uniform(source, 0.0, 8.0);
        it.inputs.ground.slope = random_uniform(source, -0.05, 0.05);
        it.inputs.leg.extension = random_uniform(source, -0.02, 0.02);
        it.inputs.body.external_fx = random_chance(source, 0.4) ? 5e-4 : 0.0;
    }
    memset(&it.motion, 0, sizeof it.motion);
    tdmf_default_state(it.motion.state);
    it.motion.state[TDMF_FOOT_Y] += random_uniform(source, 0.3, 0.6);
    it.motion.state[TDMF_LEG_ANGLE] += random_uniform(source, -0.2, 0.2);
    it.motion.state[TDMF_FOOT_VY] += random_chance(source, 0.3) ? random_uniform(source, -0.1, 0.1) : 0.0;
    assert_null(tdmf_model_create(&it.model, &parameters).variable);
    return it;
}

static tdmf_outcome go_on(const case_of_run *it, double until, tdmf_motion *motion) {
    const tdmf_system system = {&it->model, &it->inputs};
    const tdmf_page_point point = tdmf_page_of_motion(system, &held, motion);
    tdmf_solver solver = tdmf_solver_default();
    tdmf_page_solver s;
    solver.relative_tolerance = 1e-13;
    tdmf_begin_page_solver(&s, &solver, system, &point, tdmf_suits_plain_page(&point));
    const tdmf_outcome outcome = tdmf_run_page_solver(&s, until - motion->time, -1);
    tdmf_end_runner_run(&s.run, &s.point);
    tdmf_motion_of_page(system, &s.point, s.last_mode, motion);
    return outcome;
}

static tdmf_outcome go_on_by_the_core(const case_of_run *it, double until, tdmf_motion *motion) {
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = 1e-13;
    return tdmf_native_advance(&solver, (tdmf_system){&it->model, &it->inputs}, &held, until, motion);
}

static void assert_same_state(const tdmf_motion *a, const tdmf_motion *b, double tolerance) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        assert_close(a->state[i], b->state[i], tolerance * (1.0 + fabs(a->state[i])));
    }
}

static void assert_same_mode(const tdmf_mode *a, const tdmf_mode *b) {
    assert_int_equal(a->contact, b->contact);
    assert_int_equal(a->phase, b->phase);
    assert_int_equal(a->zone, b->zone);
    assert_int_equal(a->clamp_closed, b->clamp_closed);
    assert_int_equal(a->fallen, b->fallen);
    assert_true(tdmf_slip_sign(a) == tdmf_slip_sign(b));
    assert_close(a->liftoff_angle, b->liftoff_angle, 1e-9);
    assert_close(a->rest_length, b->rest_length, 1e-12);
    assert_close(a->ground.height, b->ground.height, 0.0);
    assert_close(a->ground.slope, b->ground.slope, 0.0);
}

static void assert_same_record(const tdmf_record *a, const tdmf_record *b) {
    assert_int_equal(a->event_count, b->event_count);
    assert_int_equal(a->stride.count, b->stride.count);
    assert_string_equal(a->stride.word, b->stride.word);
    assert_string_equal(a->progress.open.word, b->progress.open.word);
    assert_int_equal(a->progress.open.touchdowns, b->progress.open.touchdowns);
    assert_close(a->stride.period, b->stride.period, 1e-8);
    assert_close(a->stride.length, b->stride.length, 1e-8);
    assert_close(a->stride.stance_time, b->stride.stance_time, 1e-8);
    assert_close(a->stride.slip_distance, b->stride.slip_distance, 1e-8);
    assert_close(a->stride.peak_force, b->stride.peak_force, 1e-8);
    assert_close(a->stride.positive_work, b->stride.positive_work, 1e-8);
    assert_close(a->progress.open.peak_vertical_force, b->progress.open.peak_vertical_force, 1e-8);
    assert_close(a->apex.time, b->apex.time, 1e-8);
    assert_close(a->apex.com_height, b->apex.com_height, 1e-8);
    assert_close(a->last_event_time, b->last_event_time, 1e-8);
}

/* On the plain page, too, if that suits the runner. */
static void assert_is_written_back(const case_of_run *it, const tdmf_motion *motion) {
    const tdmf_system system = {&it->model, &it->inputs};
    tdmf_page_point point = tdmf_page_of_motion(system, &held, motion);
    for (int is_plain = 0; is_plain <= tdmf_suits_plain_page(&point); ++is_plain) {
        tdmf_motion written = *motion;
        tdmf_page_point taken = point;
        tdmf_runner_run run;
        tdmf_begin_runner_run(&run, &point, is_plain);
        tdmf_end_runner_run(&run, &taken);
        tdmf_motion_of_page(system, &taken, point.mode, &written);
        assert_same_state(motion, &written, 1e-14);
        assert_same_mode(&motion->mode, &written.mode);
        assert_same_record(&motion->record, &written.record);
        assert_close(motion->record.progress.open.contact_start_x,
                     written.record.progress.open.contact_start_x, 1e-12);
        assert_true(motion->time == written.time);
    }
}

static void test_a_run_goes_as_in_the_core_also_if_it_is_saved(void **state) {
    (void)state;
    random_source source = {47};
    int strides = 0;
    for (int i = 0; i < RUNS; ++i) {
        case_of_run it = random_case(&source);
        const double end = 40.0;
        double time = 0.0;
        if (tdmf_start((tdmf_system){&it.model, &it.inputs}, &it.motion).variable) {
            continue;
        }
        tdmf_motion whole = it.motion, saved = it.motion, by_core = it.motion;
        const tdmf_outcome outcome = go_on(&it, end, &whole);
        for (int piece = 0; piece < PIECES; ++piece) {
            time = piece == PIECES - 1 ? end : time + random_uniform(&source, 0.0, end / PIECES);
            const tdmf_outcome ended = go_on(&it, time, &saved);
            assert_true(piece < PIECES - 1 || ended == outcome);
            assert_is_written_back(&it, &saved);
        }
        assert_same_state(&whole, &saved, 1e-8);
        assert_same_mode(&whole.mode, &saved.mode);
        assert_same_record(&whole.record, &saved.record);
        assert_int_equal(go_on_by_the_core(&it, end, &by_core), outcome);
        assert_same_state(&whole, &by_core, 1e-8);
        assert_same_mode(&whole.mode, &by_core.mode);
        strides += whole.record.stride.count;
    }
    assert_true(strides > RUNS / 2);
}

static tdmf_seed random_seed(random_source *source) {
    tdmf_seed seed;
    memset(&seed, 0, sizeof seed);
    seed.parameters.leg.stiffness = random_uniform(source, -1.0, 1.0);
    seed.parameters.hip.stance_torque = random_uniform(source, -1.0, 1.0);
    seed.inputs.ground.friction = random_uniform(source, -1.0, 1.0);
    seed.parameters.leg.thrust = random_chance(source, 0.5) ? random_uniform(source, -1.0, 1.0) : 0.0;
    return seed;
}

/* The variation of a run to a time, on the page. */
static tdmf_variation vary_on_page(const case_of_run *it, double until, const tdmf_seed *seed,
                                   const tdmf_variation *variation) {
    const tdmf_system system = {&it->model, &it->inputs};
    const tdmf_page_point point = tdmf_page_of_motion(system, &held, &it->motion);
    const bool is_plain = tdmf_suits_plain_page(&point) && tdmf_varies_plain_page(seed);
    const tdmf_page_direction start = tdmf_page_of_variation(&point, it->motion.state, seed, variation);
    tdmf_solver solver = tdmf_solver_default();
    tdmf_page_solver s;
    solver.relative_tolerance = 1e-13;
    tdmf_begin_page_solver(&s, &solver, system, &point, is_plain);
    tdmf_add_direction(&s, &start);
    tdmf_run_page_solver(&s, until - it->motion.time, -1);
    tdmf_end_runner_run(&s.run, &s.point);
    const tdmf_page_direction end = tdmf_direction_at_end(&s, 0);
    return tdmf_variation_of_page(&s.point, &end, false);
}

/* Up to a time before the stride closes. */
static void test_a_variation_is_that_of_the_core(void **state) {
    (void)state;
    random_source source = {48};
    int compared = 0;
    for (int i = 0; i < RUNS; ++i) {
        case_of_run it = random_case(&source);
        const tdmf_system system = {&it.model, &it.inputs};
        const tdmf_seed seed = random_seed(&source);
        const double until = random_uniform(&source, 0.1, 8.0);
        tdmf_variation begin = {.state = {0.0}};
        tdmf_solver solver = tdmf_solver_default();
        solver.relative_tolerance = 1e-13;
        if (tdmf_start(system, &it.motion).variable) {
            continue;
        }
        begin.state[TDMF_LEG_ANGLE] = random_uniform(&source, -1.0, 1.0);
        begin.state[TDMF_FOOT_VX] = random_uniform(&source, -1.0, 1.0);
        tdmf_motion motion = it.motion;
        tdmf_variation by_core = begin;
        const tdmf_stride_outcome ended =
            tdmf_native_stride_varied(&solver, system, until, &motion, &seed, &by_core, 1);
        if (ended.outcome != TDMF_ARRIVED || ended.closed) {
            continue;
        }
        const tdmf_variation on_page = vary_on_page(&it, until, &seed, &begin);
        for (int k = 0; k < TDMF_VARIED_COUNT; ++k) {
            assert_close(on_page.state[k], by_core.state[k], 1e-7 * (1.0 + fabs(by_core.state[k])));
        }
        assert_close(on_page.liftoff_angle, by_core.liftoff_angle, 1e-7);
        ++compared;
    }
    assert_true(compared > RUNS / 4);
}

static void test_a_run_of_any_page_has_the_memory_that_it_needs(void **state) {
    (void)state;
    assert_true(tdmf_run_memory_size(&tdmf_runner_model, TDMF_VARIATION_LIMIT) <= TDMF_PAGE_MEMORY);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_run_of_any_page_has_the_memory_that_it_needs),
                                       cmocka_unit_test(test_a_run_goes_as_in_the_core_also_if_it_is_saved),
                                       cmocka_unit_test(test_a_variation_is_that_of_the_core)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
