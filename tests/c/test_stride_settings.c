/* Settings that change at apices: given for each stride or by an affine law, with limits and noise, each
 * runner strides as the native solver does that is set so by hand; and what is noted of each stride. */
#include "compare.h"
#include "crowd.h"
#include "random.h"
#include "ranges.h"
#include "reference_gaits.h"
#include "sample.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

enum { RUNNERS = TDMF_SAMPLE_DIVISOR == 1 ? 60 : 20, STRIDES = 8, SETTINGS = 3 };

static const char *const names[SETTINGS] = {"hip.touchdown_angle", "hip.stance_torque", "ground.friction"};
static const double nominal[SETTINGS] = {0.7, 0.2, 0.6};
static const double gain[SETTINGS][TDMF_POINT_LIMIT] = {
    {0.3, 0.1, 0.02, 0.01, 0.03, -0.02}, {0.02, -0.02, 0.01, 0.0, 0.0, 0.01}, {1.0, 0.5, 0.0, 0.2, 0.0, 0.0}};
static const double low[SETTINGS] = {0.693, 0.1985, 0.57};
static const double high[SETTINGS] = {0.707, 0.2015, 0.63};
static const uint64_t seed = 20261122;

/* Settings that act at the apex itself: on the ground that is in force, and on the work of the leg. */
static const char *const at_once[SETTINGS] = {"ground.height", "leg.extension", "ground.slope"};
static const double at_once_low[SETTINGS] = {-0.3, -0.02, -1e-3};
static const double at_once_high[SETTINGS] = {0.3, 0.02, 1e-3};

/* A crowd of one case, and the settings that it may be given. */
typedef struct {
    crowd *crowd;
    tdmf_ensemble *ensemble;
    tdmf_ensemble_case *scenario;
    bool acts_at_once; /* the given settings act at the apex */
    int settings[SETTINGS];
    tdmf_affine_law law;
    double values[RUNNERS][STRIDES][SETTINGS];
    tdmf_given_settings given;
} population;

static population *gather(double roughness) {
    population *population = allocate(1, sizeof *population);
    random_source source = {3};
    population->crowd = make_crowd(RUNNERS, STRIDES, 1e-11);
    note_strides(population->crowd, STRIDES);
    population->ensemble = &population->crowd->ensemble;
    population->scenario = share_case(population->crowd);
    population->scenario->rules.roughness = roughness;
    population->scenario->rules.seed = seed;
    for (int i = 0; i < SETTINGS; ++i) {
        population->settings[i] = tdmf_setting_of(names[i]);
    }
    population->law = (tdmf_affine_law){.count = SETTINGS,
                                        .settings = population->settings,
                                        .nominal = nominal,
                                        .gain = gain,
                                        .low = low,
                                        .high = high,
                                        .noise = {0.02, 0.02, 0.0, 0.05, 0.0, 0.01},
                                        .seed = seed};
    memcpy(population->law.apex, &reference_gaits[DEFAULT_GAIT].apex,
           sizeof reference_gaits[DEFAULT_GAIT].apex);
    for (int i = 0; i < RUNNERS; ++i) {
        for (int j = 0; j < TDMF_SECTION_COUNT; ++j) {
            population->crowd->starts[i][j] += random_uniform(&source, -0.05, 0.05);
        }
        for (int k = 0; k < STRIDES * SETTINGS; ++k) {
            population->values[i][k / SETTINGS][k % SETTINGS] =
                random_uniform(&source, low[k % SETTINGS], high[k % SETTINGS]);
        }
    }
    population->given =
        (tdmf_given_settings){SETTINGS, population->settings, 0, STRIDES, &population->values[0][0][0]};
    return population;
}

static const tdmf_ensemble_stride *noted(const population *population, int number, int stride) {
    return &population->crowd->strides[number * STRIDES + stride];
}

static void give_what_acts_at_once(population *population) {
    random_source source = {5};
    population->acts_at_once = true;
    population->ensemble->given = &population->given;
    for (int k = 0; k < SETTINGS; ++k) {
        population->settings[k] = tdmf_setting_of(at_once[k]);
        for (int i = 0; i < RUNNERS * STRIDES; ++i) {
            population->values[i / STRIDES][i % STRIDES][k] =
                random_uniform(&source, at_once_low[k], at_once_high[k]);
        }
    }
}

/* ---- the same by hand --------------------------------------------------------------------------------- */

/* The law as its formula says. */
static void follow_law(const population *population, int number, int stride,
                       const double apex[TDMF_SECTION_COUNT], double values[SETTINGS]) {
    const tdmf_affine_law *law = &population->law;
    for (int i = 0; i < SETTINGS; ++i) {
        values[i] = nominal[i];
        for (int j = 0; j < TDMF_SECTION_COUNT; ++j) {
            const double noise =
                law->noise[j] * tdmf_sensor_noise(seed, (uint64_t)number, (uint32_t)stride, j);
            values[i] += gain[i][j] * (apex[j] + noise - law->apex[j]);
        }
        values[i] = values[i] < low[i] ? low[i] : values[i] > high[i] ? high[i] : values[i];
    }
}

static void set_by_hand(const population *population, tdmf_parameters *parameters, tdmf_inputs *inputs,
                        const double values[SETTINGS]) {
    if (population->acts_at_once) {
        inputs->ground.height = values[0];
        inputs->leg.extension = values[1];
        inputs->ground.slope = values[2];
        return;
    }
    parameters->hip.touchdown_angle = values[0];
    parameters->hip.stance_torque = values[1];
    inputs->ground.friction = values[2];
}

/* The settings of a runner's strides, as they are set by hand. */
typedef struct {
    const population *population;
    double values[STRIDES][SETTINGS];
    strides_by_hand strides;
} hand;

static void set_stride(void *context, int number, int stride, const double apex[TDMF_SECTION_COUNT],
                       tdmf_parameters *parameters, tdmf_inputs *inputs) {
    hand *hand = context;
    const population *population = hand->population;
    double *values = hand->values[stride];
    if (population->scenario->rules.law) {
        follow_law(population, number, stride, apex, values);
    } else {
        const tdmf_given_settings *given = &population->given;
        const int after = stride - given->first, row = after < 0                ? 0
                                                       : after < given->strides ? after
                                                                                : given->strides - 1;
        memcpy(values, &given->values[(number * given->strides + row) * SETTINGS], SETTINGS * sizeof *values);
    }
    set_by_hand(population, parameters, inputs, values);
}

static void run_in_all_lanes(population *population) {
    hand *hands = allocate(RUNNERS, sizeof *hands);
    int closed = 0;
    for (int i = 0; i < RUNNERS; ++i) {
        hands[i].population = population;
        stride_by_hand(population->crowd, i, set_stride, &hands[i], &hands[i].strides);
        closed += hands[i].strides.closed;
    }
    assert_true(closed > RUNNERS * population->scenario->rules.max_strides / 2);
    FOR_INSTRUCTIONS(set) {
        run_crowd(population->crowd, set);
        for (int i = 0; i < RUNNERS; ++i) {
            assert_strides_by_hand(population->crowd, i, &hands[i].strides);
            for (int k = 0; k < hands[i].strides.begun && population->scenario->rules.law; ++k) {
                assert_all_close(noted(population, i, k)->set, hands[i].values[k], SETTINGS, 1e-7, 0.0);
            }
        }
    }
}

TEST(given_settings_are_those_of_the_strides) {
    population *population = gather(0.0);
    population->ensemble->given = &population->given;
    run_in_all_lanes(population);
}

/* The first row holds before the first stride that is given, the last row after the last one. */
TEST(strides_are_made_with_the_rows_that_are_theirs) {
    for (int first = 0; first <= 3; ++first) {
        population *population = gather(0.0);
        population->ensemble->given = &population->given;
        population->given.first = first;
        population->given.strides = 2;
        run_in_all_lanes(population);
    }
}

TEST(ground_and_leg_change_at_the_apex_itself) {
    population *population = gather(0.0);
    give_what_acts_at_once(population);
    run_in_all_lanes(population);
}

TEST(a_runner_below_its_ground_for_a_whole_stride_has_fallen) {
    population *population = gather(0.0);
    give_what_acts_at_once(population);
    for (int i = 0; i < RUNNERS * STRIDES; ++i) {
        const double values[SETTINGS] = {i % STRIDES == 0 ? 0.0 : 2.0, 0.0, 0.0};
        memcpy(population->values[i / STRIDES][i % STRIDES], values, sizeof values);
    }
    run_crowd(population->crowd, population->ensemble->instructions);
    for (int i = 0; i < RUNNERS; ++i) {
        assert_int_equal(population->crowd->ends[i].fate, TDMF_FATE_FELL);
        assert_int_equal(population->crowd->ends[i].strides, 2);
        assert_int_equal(noted(population, i, 1)->began, 1);
        assert_int_equal(noted(population, i, 2)->began, 0);
    }
}

/* A leg that is damped as much pushes most when the foot comes down and stays there. */
TEST(a_force_that_is_largest_at_touchdown_is_noted) {
    population *population = gather(0.0);
    tdmf_parameters parameters = population->crowd->models[0].parameters;
    parameters.leg.damping = 2.0;
    population->crowd->models[0] = accepted_model(&parameters);
    population->ensemble->given = &population->given;
    population->scenario->rules.max_strides = 1;
    for (int i = 0; i < RUNNERS; ++i) {
        population->values[i][0][2] = 10.0; /* the friction */
    }
    run_in_all_lanes(population);
}

TEST(the_law_sees_the_height_above_the_ground_before_it_steps) {
    population *population = gather(0.1);
    population->scenario->rules.law = &population->law;
    run_in_all_lanes(population);
}

TEST(no_setting_is_beyond_its_limits_and_some_are_at_them) {
    population *population = gather(0.1);
    int inside = 0, lowest = 0, highest = 0;
    population->scenario->rules.law = &population->law;
    run_crowd(population->crowd, population->ensemble->instructions);
    for (int i = 0; i < RUNNERS; ++i) {
        for (int stride = 0; stride < population->crowd->ends[i].strides; ++stride) {
            for (int k = 0; k < SETTINGS; ++k) {
                const double value = noted(population, i, stride)->set[k];
                lowest += value == low[k];
                highest += value == high[k];
                inside += value > low[k] && value < high[k];
                assert_true(value >= low[k] && value <= high[k]);
            }
        }
    }
    assert_true(inside > RUNNERS);
    assert_true(lowest > RUNNERS);
    assert_true(highest > RUNNERS);
}

/* ---- bit for bit -------------------------------------------------------------------------------------- */

TEST(strides_depend_on_neither_threads_nor_neighbours) {
    enum { FIRST = 7, PART = RUNNERS / 2 + 1 };
    population *all = gather(0.1), *part = gather(0.1);
    all->scenario->rules.law = &all->law;
    part->scenario->rules.law = &part->law;
    part->ensemble->threads = 2;
    part->ensemble->first_number = FIRST;
    part->ensemble->starts += FIRST;
    part->ensemble->count = PART;
    FOR_INSTRUCTIONS(set) {
        run_crowd(all->crowd, set);
        run_crowd(part->crowd, set);
        assert_memory_equal(part->crowd->ends, &all->crowd->ends[FIRST], PART * sizeof *part->crowd->ends);
        assert_memory_equal(part->crowd->strides, noted(all, FIRST, 0),
                            PART * STRIDES * sizeof *part->crowd->strides);
    }
}

static void assert_going_on_is_the_same(population *whole, population *parts) {
    FOR_INSTRUCTIONS(set) {
        run_crowd(whole->crowd, set);
        for (int stride = 0; stride < STRIDES; ++stride) {
            parts->scenario->rules.max_strides = stride + 1;
            parts->ensemble->goes_on = stride > 0;
            run_crowd(parts->crowd, set);
        }
        assert_memory_equal(parts->crowd->ends, whole->crowd->ends, RUNNERS * sizeof *parts->crowd->ends);
        assert_memory_equal(parts->crowd->strides, whole->crowd->strides,
                            RUNNERS * STRIDES * sizeof *parts->crowd->strides);
    }
}

TEST(going_on_stride_by_stride_is_the_same_as_in_one_call) {
    population *whole = gather(0.1), *parts = gather(0.1);
    whole->scenario->rules.law = &whole->law;
    parts->scenario->rules.law = &parts->law;
    assert_going_on_is_the_same(whole, parts);
}

/* Drawn heights that a foot passes, and walls that it trips over. */
TEST(on_a_terrain_too) {
    static const double walls[] = {0.0, 1.0, 1.0, 1.0};
    population *both[2] = {gather(0.1), gather(0.1)};
    for (int trips = 0; trips < 2; ++trips) {
        for (int i = 0; i < 2; ++i) {
            tdmf_ensemble_rules *rules = &both[i]->scenario->rules;
            const tdmf_terrain drawn = {.length = 3.0}, given = {20.0, walls, COUNT_OF(walls)};
            rules->terrain = trips ? given : drawn;
            rules->roughness = trips ? 0.0 : 0.1;
            rules->trips = trips;
            rules->law = &both[i]->law;
            rules->max_strides = STRIDES;
        }
        both[0]->ensemble->goes_on = both[1]->ensemble->goes_on = false;
        assert_going_on_is_the_same(both[0], both[1]);
    }
}

static void go_on(population *population, int max_strides) {
    population->ensemble->goes_on = true;
    population->scenario->rules.max_strides = max_strides;
    run_crowd(population->crowd, TDMF_BEST_INSTRUCTIONS);
}

TEST(a_run_that_has_made_its_strides_makes_no_more) {
    population *population = gather(0.0);
    population->scenario->rules.max_strides = 2;
    const tdmf_ensemble_end *before = ends_of(population->crowd, TDMF_BEST_INSTRUCTIONS);
    go_on(population, 2);
    assert_memory_equal(population->crowd->ends, before, RUNNERS * sizeof *before);
    assert_true(population->crowd->checkpoints[0].stands);
    go_on(population, 3);
    assert_int_equal(population->crowd->ends[0].strides, 3);
}

/* It drops onto a leg that is put upright, or from the second apex on onto one that is almost level. */
TEST(a_fallen_runner_has_no_checkpoint) {
    for (int row = 0; row < 2; ++row) {
        population *population = gather(0.0);
        crowd *crowd = population->crowd;
        population->ensemble->given = &population->given;
        population->given.strides = 2;
        population->scenario->rules.max_strides = 1;
        population->values[0][row][0] = row == 0 ? 0.2 : 1.5;
        memcpy(crowd->starts[0], &reference_gaits[DEFAULT_GAIT].apex, sizeof reference_gaits->apex);
        crowd->starts[0][TDMF_SECTION_COM_SPEED] *= row;
        crowd->checkpoints[0].stands = true; /* an earlier run may have left it set */
        run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
        assert_true(crowd->checkpoints[1].stands && crowd->checkpoints[0].stands == (row == 1));
        go_on(population, STRIDES);
        assert_int_equal(crowd->ends[0].fate, TDMF_FATE_FELL);
        assert_false(crowd->checkpoints[0].stands);
    }
}

/* The plain page has fewer modes than a checkpoint may name: a runner of another mode goes on without it. */
TEST(a_run_goes_on_in_any_mode) {
    int mode = 0;
    for (bool is_taken = true; is_taken; ++mode) {
        population *population = gather(0.0);
        const tdmf_ensemble_end *ends = population->crowd->ends;
        population->scenario->rules.max_strides = 1;
        run_crowd(population->crowd, TDMF_BEST_INSTRUCTIONS);
        population->crowd->checkpoints[0].mode = mode;
        population->ensemble->goes_on = true;
        population->scenario->rules.max_strides = 2;
        is_taken = tdmf_run_ensemble(population->ensemble, population->crowd->ends, NULL).variable == NULL;
        assert_int_equal(ends[1].strides, is_taken ? 2 : 1);
    }
    assert_true(mode > 7);
}

/* ---- the reduced map ---------------------------------------------------------------------------------- */

/* Each stride begins at the last apex, above the ground and with the leg where the settings have them.
 * Returns the strides that closed. */
static int stride_by_reduced_map(const population *population, int number) {
    tdmf_solver solver = tdmf_solver_default();
    tdmf_inputs inputs = population->scenario->inputs;
    tdmf_model model = population->crowd->models[0];
    double apex[TDMF_REDUCED_COUNT] = {population->crowd->starts[number][0],
                                       population->crowd->starts[number][1]};
    double x = 0.0;
    solver.relative_tolerance = population->ensemble->relative_tolerance;
    for (int stride = 0; stride < population->crowd->ends[number].strides; ++stride) {
        const tdmf_ensemble_stride *recorded = noted(population, number, stride);
        const double ground_before = inputs.ground.height + x * tan(inputs.ground.slope);
        set_by_hand(population, &model.parameters, &inputs, population->values[number][stride]);
        if (stride > 0) {
            apex[0] += ground_before - (inputs.ground.height + x * tan(inputs.ground.slope));
        }
        const tdmf_return found =
            reduced_map(&solver, (tdmf_system){&model, &inputs}, apex, 1e4, false, NULL, 0);
        assert_int_equal(found.outcome, TDMF_RETURN_CLOSED);
        memcpy(apex, found.apex, sizeof apex);
        x += found.stride.length;
        assert_close(recorded->apex[0], apex[0], 1e-7);
        assert_close(recorded->apex[1], apex[1], 1e-7);
        assert_close(recorded->stride.work, found.stride.work, 1e-7);
        assert_close(recorded->stride.peak_force, found.stride.peak_force, 1e-7);
        assert_close(recorded->stride.peak_vertical_force, found.stride.peak_vertical_force, 1e-7);
        assert_close(recorded->stride.positive_work, found.stride.positive_work, 1e-7);
        assert_close(recorded->liftoff_angle, found.liftoff_angle, 1e-7);
        assert_close(recorded->friction_loss, found.friction_loss, 1e-7);
    }
    return population->crowd->ends[number].strides;
}

TEST(strides_of_the_reduced_map_are_those_of_its_settings) {
    for (int acts_at_once = 0; acts_at_once < 2; ++acts_at_once) {
        population *population = gather(0.0);
        int closed = 0;
        population->ensemble->map = TDMF_REDUCED_MAP;
        population->ensemble->given = &population->given;
        if (acts_at_once) {
            give_what_acts_at_once(population);
        }
        run_crowd(population->crowd, population->ensemble->instructions);
        for (int i = 0; i < RUNNERS; ++i) {
            closed += stride_by_reduced_map(population, i);
        }
        assert_true(closed > RUNNERS * STRIDES / 2);
    }
}

/* ---- noise -------------------------------------------------------------------------------------------- */

/* Independent noise: products of neighbours, and of noise and steps of one seed, have the mean 0. */
TEST(noise_is_normal_and_drawn_by_itself) {
    enum { DRAWS = sample_of(100000) };
    double square = 0.0, by_step = 0.0, by_coordinate = 0.0, by_stride = 0.0;
    for (uint32_t i = 0; i < DRAWS; ++i) {
        const int j = (int)(i % 5);
        const double noise = tdmf_sensor_noise(seed, i, 3 * i, j);
        square += noise * noise;
        by_step += noise * tdmf_ground_step(seed, i, 3 * i);
        by_coordinate += noise * tdmf_sensor_noise(seed, i, 3 * i, j + 1);
        by_stride += noise * tdmf_sensor_noise(seed, i, 3 * i + 1, j);
    }
    assert_close(square / DRAWS, 1.0, 4.0 * sqrt(2.0 / DRAWS));
    assert_close(by_step / DRAWS, 0.0, 4.0 / sqrt(DRAWS));
    assert_close(by_coordinate / DRAWS, 0.0, 4.0 / sqrt(DRAWS));
    assert_close(by_stride / DRAWS, 0.0, 4.0 / sqrt(DRAWS));
}

/* ---- requests ----------------------------------------------------------------------------------------- */

TEST(settings_are_what_may_change_at_events) {
    static const char *const fixed[] = {"leg.stiffness", "gravity", "foot.y", "hip.torque", ""};
    static const char *const some[] = {"hip.stance_torque",      "hip.kp",        "leg.thrust",
                                       "ground.friction",        "ground.height", "hip.external_torque",
                                       "control.touchdown_angle"};
    const char *set[TDMF_SETTING_LIMIT];
    int count = 0;
    for (int i = 0; i < TDMF_PARAMETER_COUNT; ++i) {
        if (tdmf_parameter_ranges[i].at_events) {
            assert_true(count < TDMF_SETTING_LIMIT);
            set[count++] = tdmf_parameter_ranges[i].name;
        }
    }
    for (size_t i = 0; i < TDMF_INPUT_COUNT; ++i) {
        assert_true(count < TDMF_SETTING_LIMIT);
        set[count++] = tdmf_input_ranges[i].name;
    }
    assert_int_equal(count, TDMF_SETTING_LIMIT);
    for (size_t i = 0; i < COUNT_OF(some); ++i) {
        assert_true(tdmf_setting_of(some[i]) >= 0);
    }
    for (int i = 0; i < TDMF_SETTING_LIMIT; ++i) {
        assert_true(tdmf_setting_of(set[i]) >= 0);
        for (int j = 0; j < i; ++j) {
            assert_int_not_equal(tdmf_setting_of(set[i]), tdmf_setting_of(set[j]));
        }
    }
    for (size_t i = 0; i < COUNT_OF(fixed); ++i) {
        assert_int_equal(tdmf_setting_of(fixed[i]), -1);
    }
}

TEST(refuses_laws_that_are_none) {
    static const double none[] = {NAN, INFINITY, -INFINITY, 2e100};
    population *population = gather(0.0);
    tdmf_affine_law law = population->law;
    double numbers[SETTINGS], gains[SETTINGS][TDMF_POINT_LIMIT];
    population->scenario->rules.law = &law;
    run_crowd(population->crowd, population->ensemble->instructions);
    for (size_t i = 0; i < COUNT_OF(none); ++i) {
        memcpy(numbers, nominal, sizeof numbers);
        memcpy(gains, gain, sizeof gains);
        gains[1][2] = none[i];
        law.gain = (const double(*)[TDMF_POINT_LIMIT])gains;
        assert_crowd_is_refused(population->crowd);
        law.gain = gain;
        numbers[2] = none[i];
        law.nominal = numbers;
        assert_crowd_is_refused(population->crowd);
        law.nominal = nominal;
        law.noise[4] = none[i];
        assert_crowd_is_refused(population->crowd);
        law.noise[4] = 0.0;
        law.apex[4] = none[i];
        assert_crowd_is_refused(population->crowd);
        law.apex[4] = 0.0;
    }
    law.noise[4] = -1e-9;
    assert_crowd_is_refused(population->crowd);
    law.noise[4] = 0.0;
    law.low = high;
    law.high = low;
    assert_crowd_is_refused(population->crowd);
    law.low = low;
    memcpy(numbers, high, sizeof numbers);
    numbers[2] = -1e-9; /* a friction */
    law.high = numbers;
    assert_crowd_is_refused(population->crowd);
    law.high = high;
    population->settings[1] = population->settings[0];
    assert_crowd_is_refused(population->crowd);
    population->settings[1] = -1;
    assert_crowd_is_refused(population->crowd);
}

TEST(refuses_settings_that_are_none) {
    population *population = gather(0.0);
    const double angle = population->values[3][2][0];
    population->ensemble->given = &population->given;
    for (int i = 0; i < RUNNERS * STRIDES; ++i) {
        const double value = population->values[i / STRIDES][i % STRIDES][i % SETTINGS];
        population->values[i / STRIDES][i % STRIDES][i % SETTINGS] = NAN;
        assert_crowd_is_refused(population->crowd);
        population->values[i / STRIDES][i % STRIDES][i % SETTINGS] = value;
    }
    population->values[3][2][0] = 1e9;
    assert_crowd_is_refused(population->crowd);
    population->values[3][2][0] = angle;
    run_crowd(population->crowd, population->ensemble->instructions);
    population->scenario->rules.law = &population->law; /* the law sets the same settings */
    assert_crowd_is_refused(population->crowd);
    population->scenario->rules.law = NULL;
    population->ensemble->goes_on = true;
    population->ensemble->checkpoints = NULL; /* no run to go on from */
    assert_crowd_is_refused(population->crowd);
    population->ensemble->goes_on = false;
    population->settings[2] = tdmf_setting_of("ground.height");
    run_crowd(population->crowd, population->ensemble->instructions);
    population->scenario->rules.roughness = 0.1;
    assert_crowd_is_refused(population->crowd);
}

TEST(the_reduced_map_measures_height_and_speed_alone) {
    population *population = gather(0.0);
    double gains[SETTINGS][TDMF_POINT_LIMIT] = {{0.0}};
    population->ensemble->map = TDMF_REDUCED_MAP;
    population->scenario->rules.law = &population->law;
    population->law.gain = (const double(*)[TDMF_POINT_LIMIT])gains;
    memset(&population->law.noise[2], 0, 4 * sizeof *population->law.noise);
    gains[0][1] = 0.1;
    run_crowd(population->crowd, population->ensemble->instructions);
    gains[0][2] = 0.1;
    assert_crowd_is_refused(population->crowd);
    gains[0][2] = 0.0;
    population->law.noise[5] = 0.1;
    assert_crowd_is_refused(population->crowd);
}
