/* A patch of ground with a friction of its own: runs of an independent program word by word, derivatives
 * with the foot's place as a seventh coordinate, feet at rest on a border, and what is refused. */
#include "compare.h"
#include "patch_runs.h"
#include "scene.h"
#include "simulation.h"

#include "tdmf_slip/cvode.h"
#include "tdmf_slip/ensemble.h"
#include "tdmf_slip/orbit.h"
#include "tdmf_slip/reduced_map.h"

#include <float.h>
#include <math.h>
#include <string.h>

static tdmf_model model_of(const patch_run *run) {
    const tdmf_parameters parameters = parameters_of_patch_run(run);
    const tdmf_model model = accepted_model(&parameters);
    return model;
}

static tdmf_motion motion_at_start(const patch_run *run, tdmf_system system) {
    tdmf_motion motion = {.time = 0.0};
    tdmf_section_state(system, run->start, motion.state);
    assert_null(tdmf_start(system, &motion).variable);
    return motion;
}

static void assert_apex(const double apex[TDMF_SECTION_COUNT], const double expected[TDMF_SECTION_COUNT],
                        double tolerance) {
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        assert_close(apex[i], expected[i], tolerance);
    }
}

static void assert_section(const tdmf_model *model, const tdmf_motion *motion,
                           const double expected[TDMF_SECTION_COUNT], double foot_x, double tolerance) {
    double section[TDMF_SECTION_COUNT];
    tdmf_section_of_state(model, &motion->mode.ground, motion->state, section);
    assert_apex(section, expected, tolerance);
    assert_close(motion->state[TDMF_FOOT_X], foot_x, tolerance * fmax(1.0, fabs(foot_x)));
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

static void assert_falls(const patch_run *run, tdmf_system system, tdmf_solver *solver, tdmf_motion *motion) {
    assert_int_equal(tdmf_native_stride(solver, system, DBL_MAX, motion).outcome, TDMF_FELL);
    assert_close(motion->time, run->fall_time, 1e-7);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        assert_close(motion->state[i], run->fall_state[i], 1e-7 * fmax(1.0, fabs(run->fall_state[i])));
    }
}

TEST(the_native_solver_makes_each_run_word_by_word) {
    int crossings = 0, falls = 0;
    for (int i = 0; i < PATCH_RUNS; ++i) {
        const patch_run *run = &patch_runs[i];
        const tdmf_model model = model_of(run);
        const tdmf_inputs inputs = inputs_of_patch_run(run);
        tdmf_motion motion = motion_at_start(run, (tdmf_system){&model, &inputs});
        tdmf_event_log log = {0};
        tdmf_solver solver = solver_to(1e-13);
        int its_crossings = 0;
        for (int k = 0; k < run->strides; ++k) {
            solver.log = &log;
            log.count = 0;
            assert_true(tdmf_native_stride(&solver, (tdmf_system){&model, &inputs}, DBL_MAX, &motion).closed);
            assert_string_equal(motion.record.stride.word, run->words[k]);
            if (its_crossings == 0) {
                its_crossings = count_crossings(&log, run);
            }
            if (k == 0 && run->first_foot_x != 0.0) {
                assert_section(&model, &motion, run->first_apex, run->first_foot_x, 1e-9);
            }
        }
        /* The run that falls is unstable: what is lost of its digits grows with its strides. */
        assert_section(&model, &motion, run->end_apex, run->end_foot_x, run->fall_time > 0.0 ? 1e-7 : 1e-9);
        if (run->end_time > 0.0) {
            assert_close(motion.time, run->end_time, 1e-9);
        }
        if (run->last.period > 0.0) {
            const tdmf_stride *stride = &motion.record.stride;
            assert_close(stride->period, run->last.period, 1e-9);
            assert_close(stride->speed, run->last.speed, 1e-9);
            assert_close(stride->cost_of_transport, run->last.cost_of_transport, 1e-9);
            assert_close(stride->slip_distance, run->last.slip_distance, 1e-9);
        }
        if (run->fall_time > 0.0) {
            solver.log = NULL;
            assert_falls(run, (tdmf_system){&model, &inputs}, &solver, &motion);
            ++falls;
        }
        crossings += its_crossings;
    }
    assert_int_equal(falls, 1);
    assert_int_equal(crossings, 11);
}

TEST(cvode_makes_each_run) {
    for (int i = 0; i < PATCH_RUNS && tdmf_cvode_is_available(); ++i) {
        const patch_run *run = &patch_runs[i];
        if (run->fall_time > 0.0) {
            continue;
        }
        const tdmf_model model = model_of(run);
        const tdmf_inputs inputs = inputs_of_patch_run(run);
        tdmf_motion motion = motion_at_start(run, (tdmf_system){&model, &inputs});
        tdmf_solver solver = solver_to(1e-13);
        /* This ends past the last apex and before the next touchdown. */
        assert_int_equal(
            tdmf_cvode_advance(&solver, (tdmf_system){&model, &inputs}, NULL, run->end_time + 1.0, &motion),
            TDMF_ARRIVED);
        const tdmf_apex *apex = &motion.record.apex;
        assert_int_equal(motion.record.stride.count, run->strides);
        assert_string_equal(motion.record.stride.word, run->words[run->strides - 1]);
        const double section[TDMF_SECTION_COUNT] = {apex->com_height,      apex->com_speed,
                                                    apex->leg_length,      apex->leg_angle,
                                                    apex->leg_length_rate, apex->leg_angle_rate};
        assert_apex(section, run->end_apex, 1e-8);
        assert_relatively_close(apex->time, run->end_time, 1e-9);
    }
}

/* Feet and patches are shifted alike. */
static void assert_lanes_make_each_run(tdmf_instructions instructions, double shift) {
    tdmf_model models[PATCH_RUNS];
    tdmf_ensemble_case cases[PATCH_RUNS];
    int case_of[PATCH_RUNS];
    double starts[PATCH_RUNS][TDMF_SECTION_COUNT], foot_x[PATCH_RUNS];
    tdmf_ensemble_end ends[PATCH_RUNS];
    for (int i = 0; i < PATCH_RUNS; ++i) {
        const patch_run *run = &patch_runs[i];
        tdmf_parameters parameters = parameters_of_patch_run(run);
        parameters.ground.patch_begin += shift;
        parameters.ground.patch_end += shift;
        models[i] = accepted_model(&parameters);
        const tdmf_ensemble_case its_case = {
            &models[i], inputs_of_patch_run(run), {.max_strides = run->strides + (run->fall_time > 0.0)}};
        cases[i] = its_case;
        case_of[i] = i;
        foot_x[i] = shift;
        memcpy(starts[i], run->start, sizeof starts[i]);
    }
    const tdmf_ensemble ensemble = {.cases = cases,
                                    .case_count = PATCH_RUNS,
                                    .case_of = case_of,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])starts,
                                    .foot_x = shift == 0.0 ? NULL : foot_x,
                                    .count = PATCH_RUNS,
                                    .relative_tolerance = 1e-13,
                                    .threads = 1,
                                    .instructions = instructions};
    assert_true(tdmf_run_ensemble(&ensemble, ends, NULL));
    for (int i = 0; i < PATCH_RUNS; ++i) {
        const patch_run *run = &patch_runs[i];
        const bool falls = run->fall_time > 0.0;
        assert_int_equal(ends[i].fate, falls ? TDMF_FATE_FELL : TDMF_FATE_UNDECIDED);
        assert_int_equal(ends[i].strides, run->strides);
        assert_apex(ends[i].apex, run->end_apex, falls ? 1e-7 : 1e-9);
        assert_close(ends[i].foot_x - shift, run->end_foot_x, falls ? 1e-6 : 1e-9 * fabs(run->end_foot_x));
    }
}

TEST(lanes_make_each_run_wherever_it_is) {
    int sets = 0;
    for (int i = TDMF_ONE_BY_ONE; i <= TDMF_AVX512; ++i) {
        if (tdmf_has_instructions((tdmf_instructions)i)) {
            assert_lanes_make_each_run((tdmf_instructions)i, 0.0);
            assert_lanes_make_each_run((tdmf_instructions)i, -40.0);
            ++sets;
        }
    }
    assert_true(sets >= 2);
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
    const tdmf_return stride =
        tdmf_return_map_at(&solver, (tdmf_system){&model, &scene->inputs}, scene->at[FOOT_X], scene->at, 1e3,
                           true, seed, seed != NULL);
    assert_int_equal(stride.outcome, TDMF_RETURN_CLOSED);
    return stride;
}

static void write_end(const tdmf_return *stride, double end[COORDINATES]) {
    memcpy(end, stride->apex, sizeof stride->apex);
    end[FOOT_X] = stride->foot_x;
}

static void write_variation(const tdmf_stride_variation *variation, double end[COORDINATES]) {
    memcpy(end, variation->apex, sizeof variation->apex);
    end[FOOT_X] = variation->foot_x;
}

static void exact_variation(const scene_of_stride *scene, int k, double variation[COORDINATES]) {
    scene_of_stride moved = {.at = {0.0}};
    *coordinate_of(&moved, k) = 1.0;
    const tdmf_seed seed = {.parameters = moved.parameters};
    const tdmf_return stride = stride_at(scene, k < COORDINATES ? NULL : &seed);
    write_variation(&stride.variations[k < FOOT_X ? k : FOOT_X], variation);
}

/* The differences are of eighth order. */
static void difference(const scene_of_stride *scene, int k, double step, double variation[COORDINATES]) {
    static const double weights[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
    memset(variation, 0, COORDINATES * sizeof *variation);
    for (int i = 0; i < 8; ++i) {
        const int far = i / 2 + 1;
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        scene_of_stride moved = *scene;
        double end[COORDINATES];
        *coordinate_of(&moved, k) += sign * far * step;
        const tdmf_return stride = stride_at(&moved, NULL);
        write_end(&stride, end);
        for (int c = 0; c < COORDINATES; ++c) {
            variation[c] += sign * weights[far - 1] * end[c] / step;
        }
    }
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
            difference(&scene, k, i == 2 && k < 2 ? 1e-6 : 1e-5, expected); /* the third is near an edge */
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

/* Where no border is crossed, the stride goes with its place. */
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

typedef struct {
    double begin, end, angle;
    tdmf_contact_mode mode;
    double state[TDMF_MECHANICAL_COUNT]; /* after 0.2 */
} stand;

static const stand stands[] = {
    {0.0,
     5.0,
     -0.5,
     TDMF_CONTACT_STICK,
     {0.0, 0.0, 0.9017944261195923, -0.5001063652364338, 0.0, 0.0, 0.017765865632805102,
      -0.0010619319215578998}},
    {0.0,
     5.0,
     0.5,
     TDMF_CONTACT_SLIP_POSITIVE,
     {0.0074813661377107115, 0.0, 0.905345586245614, 0.5073604543164006, 0.07294391399884824, 0.0,
      0.05226370038347332, 0.07139200740322711}},
    {-5.0,
     0.0,
     -0.5,
     TDMF_CONTACT_SLIP_NEGATIVE,
     {-0.0074813661377107115, 0.0, 0.905345586245614, -0.5073604543164006, -0.07294391399884824, 0.0,
      0.05226370038347332, -0.07139200740322711}},
    {-5.0,
     0.0,
     0.5,
     TDMF_CONTACT_STICK,
     {0.0, 0.0, 0.9017944261195923, 0.5001063652364338, 0.0, 0.0, 0.017765865632805102,
      0.0010619319215578998}},
};

TEST(a_foot_at_rest_on_a_border_slips_where_it_is_held_less) {
    for (size_t i = 0; i < 2 * sizeof stands / sizeof *stands; ++i) {
        const stand *stand = &stands[i / 2];
        tdmf_parameters parameters = tdmf_default_parameters();
        tdmf_inputs inputs = tdmf_default_inputs();
        tdmf_motion motion = {.state = {[TDMF_LEG_LENGTH] = 0.9, [TDMF_LEG_ANGLE] = stand->angle}};
        tdmf_solver solver = tdmf_solver_default();
        parameters.ground.patch_begin = stand->begin;
        parameters.ground.patch_end = stand->end;
        parameters.hip.stance_torque = 0.0;
        inputs.ground.friction = 0.6;
        const tdmf_model model = accepted_model(&parameters);
        motion.time = 0.0;
        assert_null(tdmf_start((tdmf_system){&model, &inputs}, &motion).variable);
        assert_int_equal(motion.mode.contact, stand->mode);
        if (i % 2 == 0) {
            assert_int_equal(tdmf_native_advance(&solver, (tdmf_system){&model, &inputs}, NULL, 0.2, &motion),
                             TDMF_ARRIVED);
        } else if (tdmf_cvode_is_available()) {
            solver.relative_tolerance = 1e-12;
            assert_int_equal(tdmf_cvode_advance(&solver, (tdmf_system){&model, &inputs}, NULL, 0.2, &motion),
                             TDMF_ARRIVED);
        } else {
            continue;
        }
        for (int k = 0; k < TDMF_MECHANICAL_COUNT; ++k) {
            assert_close(motion.state[k], stand->state[k], i % 2 == 0 ? 1e-11 : 1e-9);
        }
    }
}

/* A foot at rest at x = 0 whose leg tips over to the side `push`, so that it slips there in time. */
static tdmf_motion tip_over(double begin, double end, double friction, double push, double angle) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_motion motion = {
        .state = {
            [TDMF_LEG_LENGTH] = 0.9, [TDMF_LEG_ANGLE] = push * angle, [TDMF_LEG_ANGLE_RATE] = push * 0.3}};
    tdmf_solver solver = tdmf_solver_default();
    parameters.ground.patch_begin = begin;
    parameters.ground.patch_end = end;
    parameters.ground.patch_friction = 0.1;
    parameters.hip.stance_torque = 0.0;
    inputs.ground.friction = friction;
    const tdmf_model model = accepted_model(&parameters);
    const tdmf_system system = {&model, &inputs};
    assert_null(tdmf_start(system, &motion).variable);
    assert_int_equal(motion.mode.contact, TDMF_CONTACT_STICK);
    assert_int_equal(tdmf_native_advance(&solver, system, NULL, 0.5, &motion), TDMF_ARRIVED);
    assert_int_equal(motion.mode.contact,
                     push > 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_SLIP_NEGATIVE);
    return motion;
}

/* It is held by the friction of the side to which it slips, as on ground that has no other. */
TEST(a_foot_on_a_border_holds_on_by_the_friction_of_the_side_it_is_pushed_to) {
    for (int side = -1; side <= 1; side += 2) {
        const double begin = side > 0 ? 0.0 : -5.0, end = begin + 5.0;
        for (int k = 0; k < 2; ++k) {
            const bool into_patch = k == 1;
            const double push = into_patch ? side : -side;
            const double angle = into_patch ? 0.02 : 0.5;
            const tdmf_motion on_border = tip_over(begin, end, 0.6, push, angle);
            const tdmf_motion alone = tip_over(0.0, 0.0, into_patch ? 0.1 : 0.6, push, angle);
            for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
                assert_close(on_border.state[i], alone.state[i], 1e-11);
            }
        }
    }
}

/* ---- a border that is met as the slip ends ------------------------------------------------------------- */

enum { SHIFTS = 13 };
static const double shifts[SHIFTS] = {-1e-5, -1e-7, -1e-9, -1e-11, -1e-13, -1e-15, 0.0,
                                      1e-15, 1e-13, 1e-11, 1e-9,   1e-7,   1e-5};
static const double slip_ends_by = 0.2;

/* A foot that slips forward and comes to rest, its leg leaning by an angle, which pushes it on or back. */
static tdmf_motion motion_that_slips(double angle) {
    tdmf_motion motion = {
        .state = {[TDMF_FOOT_VX] = 0.02, [TDMF_LEG_LENGTH] = 0.9, [TDMF_LEG_ANGLE] = angle}};
    const double unit[2] = {sin(angle), cos(angle)};
    motion.state[TDMF_LEG_LENGTH_RATE] = motion.state[TDMF_FOOT_VX] * unit[0];
    motion.state[TDMF_LEG_ANGLE_RATE] = motion.state[TDMF_FOOT_VX] * unit[1] / 0.9;
    return motion;
}

static double energy_and_losses(tdmf_system system, const tdmf_motion *motion) {
    const double *state = motion->state;
    return tdmf_mechanical_energy(system, &motion->mode, state).total + state[TDMF_ENERGY_DAMPER_LOSS] +
           state[TDMF_ENERGY_FRICTION_LOSS];
}

/* Where it is then, on ground of friction 1 with a slippery patch from `border` on. */
static tdmf_motion slip_to_a_border(double angle, double border, bool by_cvode) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_motion motion = motion_that_slips(angle);
    tdmf_solver solver = solver_to(1e-12);
    parameters.ground.patch_begin = border;
    parameters.ground.patch_end = 5.0;
    parameters.hip.stance_torque = 0.0;
    inputs.ground.friction = 1.0;
    const tdmf_model model = accepted_model(&parameters);
    const tdmf_system system = {&model, &inputs};
    assert_null(tdmf_start(system, &motion).variable);
    assert_int_equal(motion.mode.contact, TDMF_CONTACT_SLIP_POSITIVE);
    const double before = energy_and_losses(system, &motion);
    assert_int_equal(
        (by_cvode ? tdmf_cvode_advance : tdmf_native_advance)(&solver, system, NULL, slip_ends_by, &motion),
        TDMF_ARRIVED);
    assert_close(energy_and_losses(system, &motion), before, 1e-11);
    assert_true(motion.record.event_count < 10);
    return motion;
}

/* Pushed back, it is held by the ground that it comes from, or slips back to it: the border makes the less of
 * a difference the later it is met. */
TEST(a_foot_that_is_pushed_back_ends_where_it_would_without_the_border) {
    int compared = 0;
    for (int by_cvode = 0; by_cvode <= (int)tdmf_cvode_is_available(); ++by_cvode) {
        const tdmf_motion without = slip_to_a_border(-0.5, 4.0, by_cvode);
        assert_int_equal(without.mode.contact, TDMF_CONTACT_STICK);
        for (int i = 0; i < SHIFTS; ++i) {
            const double border = without.state[TDMF_FOOT_X] + shifts[i];
            const tdmf_motion motion = slip_to_a_border(-0.5, border, by_cvode);
            assert_int_equal(motion.mode.contact, TDMF_CONTACT_STICK);
            for (int k = 0; k < TDMF_MECHANICAL_COUNT; ++k) {
                assert_close(motion.state[k], without.state[k], 1e-10 + 20.0 * fmax(0.0, -shifts[i]));
            }
            ++compared;
        }
    }
    assert_int_equal(compared, SHIFTS * (1 + tdmf_cvode_is_available()));
}

/* Pushed on, it rests before the border, or slips on from it. At the border itself it is one or the other. */
TEST(a_foot_that_is_pushed_on_rests_before_the_border_or_slips_on) {
    int rested = 0, slipped = 0;
    for (int by_cvode = 0; by_cvode <= (int)tdmf_cvode_is_available(); ++by_cvode) {
        const tdmf_motion without = slip_to_a_border(0.5, 4.0, by_cvode);
        const double rest = without.state[TDMF_FOOT_X];
        const double gone = slip_to_a_border(0.5, rest - 1e-10, by_cvode).state[TDMF_FOOT_X] - rest;
        assert_int_equal(without.mode.contact, TDMF_CONTACT_STICK);
        assert_true(gone > 2e-3);
        for (int i = 0; i < SHIFTS; ++i) {
            const tdmf_motion motion = slip_to_a_border(0.5, rest + shifts[i], by_cvode);
            const double way = motion.state[TDMF_FOOT_X] - rest;
            if (motion.mode.contact == TDMF_CONTACT_STICK) {
                assert_true(shifts[i] > -1e-10);
                assert_close(way, 0.0, 1e-10);
                ++rested;
            } else {
                assert_int_equal(motion.mode.contact, TDMF_CONTACT_SLIP_POSITIVE);
                assert_true(shifts[i] < 1e-10);
                assert_close(way, gone, 0.3 * sqrt(fabs(shifts[i])) + 1e-5);
                ++slipped;
            }
        }
    }
    assert_true(rested >= 3 && slipped >= 3);
}

/* ---- what is refused ----------------------------------------------------------------------------------- */

TEST(a_patch_that_ends_before_it_begins_is_refused_by_name) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_model model;
    char text[256];
    parameters.ground.patch_begin = 2.0;
    parameters.ground.patch_end = 1.0;
    const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    assert_string_equal(tdmf_refusal_text(&refusal, text, sizeof text),
                        "ground.patch_end = 1 m is refused: allowed from 2 to 1e+09 m (ground.patch_begin)");
}

/* A patch is at a place, which these maps have not. */
TEST(maps_without_foot_x_refuse_a_patch) {
    const patch_run *run = &patch_runs[0];
    const tdmf_model model = model_of(run);
    const tdmf_inputs inputs = inputs_of_patch_run(run);
    tdmf_solver solver = tdmf_solver_default();
    assert_int_equal(
        tdmf_return_map(&solver, (tdmf_system){&model, &inputs}, run->start, 1e3, false, NULL, 0).outcome,
        TDMF_RETURN_REFUSED);
    assert_int_equal(tdmf_find_orbit(&solver, (tdmf_system){&model, &inputs}, run->start, NULL, 0).outcome,
                     TDMF_ORBIT_NO_START);
    assert_int_equal(
        tdmf_reduced_map(&solver, (tdmf_system){&model, &inputs}, run->start, 1e3, false, NULL, 0).outcome,
        TDMF_RETURN_REFUSED);
}
