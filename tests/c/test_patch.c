/* A patch of ground with a friction of its own: runs of an independent program word by word, derivatives
 * with the foot's place as a seventh coordinate, feet at rest on a border, and what is refused. */
#include "compare.h"
#include "crowd.h"
#include "differentiate.h"
#include "references.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

static simulation begin(const patch_run *run) {
    const tdmf_parameters parameters = parameters_of_patch_run(run);
    const tdmf_inputs inputs = inputs_of_patch_run(run);
    return simulation_from(&parameters, &inputs, run->start, 1e-13);
}

static void assert_section(const simulation *at, const double expected[TDMF_SECTION_COUNT], double foot_x,
                           double tolerance) {
    double section[TDMF_SECTION_COUNT];
    tdmf_section_of_state(&at->model, &at->motion.mode.ground, at->motion.state, section);
    assert_all_close(section, expected, TDMF_SECTION_COUNT, tolerance, 0.0);
    assert_close(at->motion.state[TDMF_FOOT_X], foot_x, tolerance * fmax(1.0, fabs(foot_x)));
}

/* ---- runs ---------------------------------------------------------------------------------------------- */

static int count_crossings(const tdmf_event_log *log, const patch_run *run) {
    int crossings = 0;
    for (int i = 0; i < log->count; ++i) {
        if (log->events[i].guard == TDMF_GUARD_PATCH_BORDER) {
            assert_true(crossings < run->crossings);
            assert_close(log->events[i].time, run->crossing_times[crossings], 1e-9);
            ++crossings;
        }
    }
    return crossings;
}

static void assert_falls(const patch_run *run, simulation *at) {
    assert_int_equal(simulation_advance(at, 1e9), TDMF_FELL);
    assert_close(at->motion.time, run->fall_time, 1e-7);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        assert_close(at->motion.state[TDMF_FOOT_X + i], run->fall_state[i],
                     1e-7 * fmax(1.0, fabs(run->fall_state[i])));
    }
}

TEST(the_native_solver_makes_each_run_word_by_word) {
    int crossings = 0, falls = 0;
    for (int i = 0; i < PATCH_RUNS; ++i) {
        const patch_run *run = &patch_runs[i];
        simulation at = begin(run);
        int its_crossings = 0;
        for (int k = 0; k < run->strides; ++k) {
            simulation_stride(&at);
            assert_string_equal(last_stride_of(&at.motion).word, run->words[k]);
            if (its_crossings == 0) {
                its_crossings = count_crossings(&at.log, run);
            }
            if (k == 0 && run->first_foot_x != 0.0) {
                assert_section(&at, run->first_apex, run->first_foot_x, 1e-9);
            }
        }
        /* The run that falls is unstable: what is lost of its digits grows with its strides. */
        assert_section(&at, run->end_apex, run->end_foot_x, run->fall_time > 0.0 ? 1e-7 : 1e-9);
        if (run->end_time > 0.0) {
            assert_close(at.motion.time, run->end_time, 1e-9);
        }
        if (run->last.period > 0.0) {
            const tdmf_stride stride = last_stride_of(&at.motion);
            assert_close(stride.period, run->last.period, 1e-9);
            assert_close(stride.speed, run->last.speed, 1e-9);
            assert_close(stride.cost_of_transport, run->last.cost_of_transport, 1e-9);
            assert_close(stride.slip_distance, run->last.slip_distance, 1e-9);
        }
        if (run->fall_time > 0.0) {
            assert_falls(run, &at);
            ++falls;
        }
        crossings += its_crossings;
    }
    assert_int_equal(falls, 1);
    assert_int_equal(crossings, 11);
}

/* This ends past the last apex and before the next touchdown. */
TEST(cvode_makes_each_run) {
    for (int i = 0; i < PATCH_RUNS && tdmf_cvode_is_available(); ++i) {
        const patch_run *run = &patch_runs[i];
        if (run->fall_time == 0.0) {
            simulation at = begin(run);
            double section[TDMF_SECTION_COUNT];
            assert_int_equal(simulation_advance_by(tdmf_cvode_advance, &at, run->end_time + 1.0),
                             TDMF_ARRIVED);
            read_apex(&at.motion, section);
            assert_int_equal(at.motion.state[TDMF_STRIDE_COUNT], run->strides);
            assert_string_equal(last_stride_of(&at.motion).word, run->words[run->strides - 1]);
            assert_all_close(section, run->end_apex, TDMF_SECTION_COUNT, 1e-8, 0.0);
            assert_relatively_close(last_apex_of(&at.motion).time, run->end_time, 1e-9);
        }
    }
}

/* Feet and patches are shifted alike. */
TEST(an_ensemble_makes_each_run_wherever_it_is) {
    for (double shift = 0.0; shift > -50.0; shift -= 40.0) {
        crowd *crowd = make_crowd(PATCH_RUNS, 0, 1e-13);
        double foot_x[PATCH_RUNS];
        for (int i = 0; i < PATCH_RUNS; ++i) {
            const tdmf_inputs inputs = inputs_of_patch_run(&patch_runs[i]);
            tdmf_parameters parameters = parameters_of_patch_run(&patch_runs[i]);
            parameters.ground.patch_begin += shift;
            parameters.ground.patch_end += shift;
            foot_x[i] = shift;
            place_runner(crowd, i, &parameters, &inputs, patch_runs[i].start);
            crowd->cases[i].rules.max_strides = patch_runs[i].strides + (patch_runs[i].fall_time > 0.0);
        }
        crowd->ensemble.foot_x = shift == 0.0 ? NULL : foot_x;
        run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
        for (int i = 0; i < PATCH_RUNS; ++i) {
            const patch_run *run = &patch_runs[i];
            const tdmf_ensemble_end *end = &crowd->ends[i];
            const bool falls = run->fall_time > 0.0;
            assert_int_equal(end->fate, falls ? TDMF_FATE_FELL : TDMF_FATE_UNDECIDED);
            assert_int_equal(end->strides, run->strides);
            assert_all_close(end->apex, run->end_apex, TDMF_SECTION_COUNT, falls ? 1e-7 : 1e-9, 0.0);
            assert_close(end->foot_x - shift, run->end_foot_x, falls ? 1e-6 : 1e-9 * fabs(run->end_foot_x));
        }
    }
}

/* ---- derivatives --------------------------------------------------------------------------------------- */

enum { FOOT_X = TDMF_SECTION_COUNT, COORDINATES, BORDERS = 3, SEEDS = COORDINATES + BORDERS };

typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double at[COORDINATES];
} scene_of_stride;

/* A coordinate, or begin, end or friction of the patch. */
static double *coordinate_of(scene_of_stride *scene, int k) {
    double *const of_patch[BORDERS] = {&scene->parameters.ground.patch_begin,
                                       &scene->parameters.ground.patch_end,
                                       &scene->parameters.ground.patch_friction};
    return k < COORDINATES ? &scene->at[k] : of_patch[k - COORDINATES];
}

static tdmf_return stride_at(const scene_of_stride *scene, const tdmf_seed *seed) {
    tdmf_solver solver = solver_to(1e-14);
    const tdmf_model model = accepted_model(&scene->parameters);
    const tdmf_stride_request request = {.solver = &solver,
                                         .system = {&model, &scene->inputs},
                                         .apex = scene->at,
                                         .foot_x = &scene->at[FOOT_X],
                                         .derivatives = true,
                                         .seeds = seed,
                                         .seed_count = seed != NULL};
    tdmf_return stride;
    tdmf_run_stride(&request, &stride);
    assert_int_equal(stride.outcome, TDMF_RETURN_CLOSED);
    return stride;
}

static void exact_variation(const scene_of_stride *scene, int k, double variation[COORDINATES]) {
    scene_of_stride moved = {.at = {0.0}};
    *coordinate_of(&moved, k) = 1.0;
    const tdmf_seed seed = {.parameters = moved.parameters};
    const tdmf_return stride = stride_at(scene, k < COORDINATES ? NULL : &seed);
    const tdmf_stride_variation *along = &stride.variations[k < FOOT_X ? k : FOOT_X];
    memcpy(variation, along->apex, sizeof along->apex);
    variation[FOOT_X] = along->foot_x;
}

typedef struct {
    scene_of_stride scene;
    int coordinate;
} coordinate_line;

static void ends_on_line(long double t, const void *context, double ends[]) {
    coordinate_line moved = *(const coordinate_line *)context;
    *coordinate_of(&moved.scene, moved.coordinate) += (double)t;
    const tdmf_return stride = stride_at(&moved.scene, NULL);
    memcpy(ends, stride.apex, sizeof stride.apex);
    ends[FOOT_X] = stride.foot_x;
}

TEST(each_stride_is_differentiated_by_foot_x_and_patch) {
    int compared = 0, moved_by_foot_x = 0, moved_by_patch = 0;
    for (int i = 0; i < PATCH_RUNS; ++i) {
        const patch_run *run = &patch_runs[i];
        scene_of_stride scene = {parameters_of_patch_run(run), inputs_of_patch_run(run), {0.0}};
        memcpy(scene.at, run->start, sizeof run->start);
        if (run->begin == run->end || run->stribeck_velocity == 1e-4) {
            continue;
        }
        for (int k = 0; k < SEEDS; ++k) {
            double exact[COORDINATES], expected[COORDINATES], size = 1.0;
            exact_variation(&scene, k, exact);
            const coordinate_line line = {scene, k};
            const long double step = i == 2 && k < 2 ? 1e-6L : 1e-5L; /* the third is near an edge */
            derivatives_at_zero(ends_on_line, &line, step, COORDINATES, expected);
            for (int c = 0; c < COORDINATES; ++c) {
                size = fmax(size, fabs(exact[c]));
            }
            for (int c = 0; c < COORDINATES; ++c) {
                assert_close(exact[c], expected[c], 1e-7 * size);
                ++compared;
            }
            moved_by_foot_x += k == FOOT_X && fabs(exact[0]) > 1e-6;
            moved_by_patch += k > FOOT_X && fabs(exact[0]) > 1e-6;
        }
    }
    assert_int_equal(compared, 7 * SEEDS * COORDINATES);
    assert_true(moved_by_foot_x >= 4 && moved_by_patch >= 8);
}

/* A stride that crosses no border is shifted with its start. */
TEST(without_a_crossing_foot_x_is_carried_along) {
    scene_of_stride scene = {tdmf_default_parameters(), tdmf_default_inputs(), {0.0}};
    double by_foot_x[COORDINATES];
    memcpy(scene.at, patch_runs[0].start, sizeof patch_runs[0].start);
    scene.inputs.ground.friction = 0.6;
    scene.parameters.ground.patch_begin = 5.0;
    scene.parameters.ground.patch_end = 9.0;
    exact_variation(&scene, FOOT_X, by_foot_x);
    for (int c = 0; c < FOOT_X; ++c) {
        assert_close(by_foot_x[c], 0.0, 1e-12);
    }
    assert_close(by_foot_x[FOOT_X], 1.0, 1e-13);
}

/* ---- at rest on a border ------------------------------------------------------------------------------- */

/* A still foot at x = 0, or one that slips there, on a leg that leans and turns. */
static simulation stand(double begin, double end, double patch_friction, double friction,
                        const double state[TDMF_STATE_COUNT]) {
    simulation at = {.inputs = tdmf_default_inputs(), .solver = solver_to(1e-12)};
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.ground.patch_begin = begin;
    parameters.ground.patch_end = end;
    parameters.ground.patch_friction = patch_friction;
    parameters.hip.stance_torque = 0.0;
    at.model = accepted_model(&parameters);
    at.inputs.ground.friction = friction;
    memcpy(at.motion.state, state, sizeof at.motion.state);
    simulation_start(&at);
    return at;
}

/* A foot on a border is held by the friction of the side that it is pushed to, as on ground that has no
 * other: it slips onto the slippery patch and sticks on the ground beside it; at once, or when its leg has
 * tipped over far enough. */
TEST(a_foot_on_a_border_is_held_by_the_friction_of_the_side_it_is_pushed_to) {
    int slipped = 0;
    for (int i = 0; i < 16; ++i) {
        const double side = i & 1 ? 1.0 : -1.0, push = i & 2 ? side : -side; /* into the patch, or off it */
        const bool tips_over = (i & 4) != 0, by_cvode = (i & 8) != 0;
        const double begin = side > 0.0 ? 0.0 : -5.0, patch_friction = tips_over ? 0.1 : 0.0;
        const double angle = push * (tips_over && push == side ? 0.02 : 0.5);
        const double state[TDMF_STATE_COUNT] = {[TDMF_LEG_LENGTH] = 0.9,
                                                [TDMF_LEG_ANGLE] = angle,
                                                [TDMF_LEG_ANGLE_RATE] = tips_over ? push * 0.3 : 0.0};
        solver_call *const advance = by_cvode ? tdmf_cvode_advance : tdmf_native_advance;
        simulation on_border = stand(begin, begin + 5.0, patch_friction, 0.6, state);
        simulation alone = stand(0.0, 0.0, 0.0, push == side ? patch_friction : 0.6, state);
        if (by_cvode && !tdmf_cvode_is_available()) {
            continue;
        }
        assert_int_equal(on_border.motion.mode.contact, alone.motion.mode.contact);
        assert_int_equal(simulation_advance_by(advance, &on_border, tips_over ? 0.5 : 0.2), TDMF_ARRIVED);
        assert_int_equal(simulation_advance_by(advance, &alone, tips_over ? 0.5 : 0.2), TDMF_ARRIVED);
        assert_int_equal(on_border.motion.mode.contact, alone.motion.mode.contact);
        assert_all_close(&on_border.motion.state[TDMF_FOOT_X], &alone.motion.state[TDMF_FOOT_X],
                         TDMF_MECHANICAL_COUNT, by_cvode ? 1e-9 : 1e-11, 0.0);
        slipped += on_border.motion.mode.contact != TDMF_CONTACT_STICK;
    }
    assert_true(slipped >= 6);
}

/* ---- a border that is met as the slip ends ------------------------------------------------------------- */

enum { SHIFTS = 13 };
static const double shifts[SHIFTS] = {-1e-5, -1e-7, -1e-9, -1e-11, -1e-13, -1e-15, 0.0,
                                      1e-15, 1e-13, 1e-11, 1e-9,   1e-7,   1e-5};
static const double slip_ends_by = 0.2;

/* Simulates a foot that slips forward and comes to rest, on friction 1 with a slippery patch from `border`
 * on. The leg leans by an angle and pushes the foot on or back. */
static simulation slip_to_a_border(double angle, double border, bool by_cvode) {
    static const double speed = 0.02, length = 0.9;
    const double state[TDMF_STATE_COUNT] = {[TDMF_FOOT_VX] = speed,
                                            [TDMF_LEG_LENGTH] = length,
                                            [TDMF_LEG_ANGLE] = angle,
                                            [TDMF_LEG_LENGTH_RATE] = speed * sin(angle),
                                            [TDMF_LEG_ANGLE_RATE] = speed * cos(angle) / length};
    simulation at = stand(border, 5.0, 0.0, 1.0, state);
    assert_int_equal(at.motion.mode.contact, TDMF_CONTACT_SLIP_POSITIVE);
    assert_int_equal(
        simulation_advance_by(by_cvode ? tdmf_cvode_advance : tdmf_native_advance, &at, slip_ends_by),
        TDMF_ARRIVED);
    assert_close(simulation_ledger_error(&at), 0.0, 1e-11);
    assert_true(at.motion.state[TDMF_EVENT_COUNT] < 10);
    return at;
}

/* Pushed back, it is held by the ground that it comes from, or slips back to it: the border makes the less of
 * a difference the later it is met. */
TEST(a_foot_that_is_pushed_back_ends_where_it_would_without_the_border) {
    int compared = 0;
    for (int by_cvode = 0; by_cvode <= (int)tdmf_cvode_is_available(); ++by_cvode) {
        const simulation without = slip_to_a_border(-0.5, 4.0, by_cvode);
        assert_int_equal(without.motion.mode.contact, TDMF_CONTACT_STICK);
        for (int i = 0; i < SHIFTS; ++i) {
            const double border = without.motion.state[TDMF_FOOT_X] + shifts[i];
            const simulation at = slip_to_a_border(-0.5, border, by_cvode);
            assert_int_equal(at.motion.mode.contact, TDMF_CONTACT_STICK);
            assert_all_close(&at.motion.state[TDMF_FOOT_X], &without.motion.state[TDMF_FOOT_X],
                             TDMF_MECHANICAL_COUNT, 1e-10 + 20.0 * fmax(0.0, -shifts[i]), 0.0);
            ++compared;
        }
    }
    assert_int_equal(compared, SHIFTS * (1 + tdmf_cvode_is_available()));
}

/* Pushed on, it rests before the border, or slips on from it. At the border itself it is one or the other. */
TEST(a_foot_that_is_pushed_on_rests_before_the_border_or_slips_on) {
    int rested = 0, slipped = 0;
    for (int by_cvode = 0; by_cvode <= (int)tdmf_cvode_is_available(); ++by_cvode) {
        const simulation without = slip_to_a_border(0.5, 4.0, by_cvode);
        const double rest = without.motion.state[TDMF_FOOT_X];
        const double gone = slip_to_a_border(0.5, rest - 1e-10, by_cvode).motion.state[TDMF_FOOT_X] - rest;
        assert_int_equal(without.motion.mode.contact, TDMF_CONTACT_STICK);
        assert_true(gone > 2e-3);
        for (int i = 0; i < SHIFTS; ++i) {
            const simulation at = slip_to_a_border(0.5, rest + shifts[i], by_cvode);
            const double way = at.motion.state[TDMF_FOOT_X] - rest;
            if (at.motion.mode.contact == TDMF_CONTACT_STICK) {
                assert_true(shifts[i] > -1e-10);
                assert_close(way, 0.0, 1e-10);
                ++rested;
            } else {
                assert_int_equal(at.motion.mode.contact, TDMF_CONTACT_SLIP_POSITIVE);
                assert_true(shifts[i] < 1e-10);
                assert_close(way, gone, 0.3 * sqrt(fabs(shifts[i])) + 1e-5);
                ++slipped;
            }
        }
    }
    assert_true(rested >= 3 && slipped >= 3);
}

/* ---- no border ------------------------------------------------------------------------------------------
 */

/* However far a light foot is thrown, on either side of the patch, it meets no further border. */
TEST(a_foot_that_slips_far_beyond_a_patch_meets_no_border) {
    static const double places[] = {1e11, -1e11, 3e12, -3e12, 1e15, -1e15};
    for (size_t i = 0; i < COUNT_OF(places); ++i) {
        const double way = places[i] > 0.0 ? 1.0 : -1.0, speed = way * 0.3;
        const double state[TDMF_STATE_COUNT] = {[TDMF_FOOT_Y] = 1e-3,
                                                [TDMF_FOOT_VX] = speed,
                                                [TDMF_FOOT_VY] = -0.1,
                                                [TDMF_LEG_LENGTH] = 0.9,
                                                [TDMF_LEG_ANGLE] = -0.1 * way};
        simulation at = stand(0.0, 5.0, 0.1, 0.2, state);
        at.motion.state[TDMF_FOOT_X] = places[i];
        for (int part = 1; part <= 20; ++part) {
            assert_int_equal(simulation_advance(&at, 0.5 * part), TDMF_ARRIVED);
            assert_null(simulation_event(&at, TDMF_GUARD_PATCH_BORDER));
        }
        assert_true(at.motion.state[TDMF_STRIDE_TOUCHDOWNS_SO_FAR] > 0);
        assert_true(at.motion.state[TDMF_EVENT_COUNT] < 20);
    }
}

/* ---- what is refused ----------------------------------------------------------------------------------- */

TEST(a_patch_that_ends_before_it_begins_is_refused_by_name) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_model model;
    parameters.ground.patch_begin = 2.0;
    parameters.ground.patch_end = 1.0;
    const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    assert_refusal_text(refusal,
                        "ground.patch_end = 1 m is refused: allowed from 2 to 1e+09 m (ground.patch_begin)");
}

/* A patch is at a place, which these maps have not. */
TEST(maps_without_foot_x_refuse_a_patch) {
    const patch_run *run = &patch_runs[0];
    simulation at = begin(run);
    const tdmf_system system = SYSTEM_OF(&at);
    assert_int_equal(return_map(&at.solver, system, run->start, 1e3, false, NULL, 0).outcome,
                     TDMF_RETURN_REFUSED);
    assert_int_equal(find_orbit(TDMF_RETURN_MAP, &at.solver, system, run->start, NULL, 0).outcome,
                     TDMF_ORBIT_NO_START);
    assert_int_equal(reduced_map(&at.solver, system, run->start, 1e3, false, NULL, 0).outcome,
                     TDMF_RETURN_REFUSED);
}
