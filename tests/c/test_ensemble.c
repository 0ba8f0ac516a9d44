/* The ensemble engine: a runner's end is the same, bit for bit, by every instruction set, whoever its
 * neighbours are and however many threads there are. */
#include "compare.h"
#include "reference_gaits.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNNERS = sample_of(1500) };

static const double tight = 1e-11;

/* Models, inputs and starts, each runner with a case of its own. */
typedef struct {
    tdmf_model models[RUNNERS];
    tdmf_ensemble_case cases[RUNNERS];
    int case_of[RUNNERS];
    double starts[RUNNERS][TDMF_SECTION_COUNT];
    tdmf_ensemble ensemble;
} population;

static void scale_randomly(random_source *source, double *value, double max_factor) {
    *value *= random_magnitude(source, 1.0 / max_factor, max_factor);
}

static void vary_case(random_source *source, tdmf_model *model, tdmf_ensemble_case *its_case) {
    tdmf_parameters p = tdmf_default_parameters();
    double *const varied[] = {&p.body.mass,         &p.foot.mass, &p.leg.damping, &p.gravity,
                              &p.hip.stance_torque, &p.hip.kp,    &p.hip.kd,      &p.hip.touchdown_angle};
    for (size_t i = 0; i < sizeof varied / sizeof varied[0]; ++i) {
        scale_randomly(source, varied[i], 1.2);
    }
    p.hip.retraction_rate = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.02, 0.02);
    p.ground.static_friction_ratio = random_chance(source, 0.5) ? 1.0 : random_uniform(source, 1.0, 1.5);
    p.hip.swing_clamp = random_truth(*source);
    assert_null(tdmf_model_create(model, &p).variable);
    its_case->inputs.ground.friction = random_magnitude(source, 0.02, 10.0);
    its_case->inputs.hip.external_torque =
        random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.01, 0.01);
}

/* Starts lie around a gait's apex, some of them below the ground. */
static void start_near_the_gait(random_source *source, tdmf_model *model, tdmf_ensemble_case *its_case,
                                double start[TDMF_SECTION_COUNT]) {
    vary_case(source, model, its_case);
    memcpy(start, &reference_gaits[DEFAULT_GAIT].apex, TDMF_SECTION_COUNT * sizeof *start);
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        start[i] += random_uniform(source, -0.4, 0.4) * (i == TDMF_SECTION_LEG_LENGTH ? 0.1 : 1.0);
    }
}

/* Anything: most of these fall, by every way there is. */
static void start_anywhere(random_source *source, tdmf_model *model, tdmf_ensemble_case *its_case,
                           double start[TDMF_SECTION_COUNT]) {
    const runner anybody = scene_random(source, TDMF_CONTACT_FLIGHT);
    const tdmf_point com = tdmf_center_of_mass(&anybody.model, anybody.motion.state);
    const double section[TDMF_SECTION_COUNT] = {com.y,
                                                com.vx,
                                                anybody.motion.state[TDMF_LEG_LENGTH],
                                                2.0 * anybody.motion.state[TDMF_LEG_ANGLE],
                                                anybody.motion.state[TDMF_LEG_LENGTH_RATE],
                                                anybody.motion.state[TDMF_LEG_ANGLE_RATE]};
    *model = anybody.model;
    its_case->inputs = anybody.inputs;
    memcpy(start, section, sizeof section);
}

typedef void put_runner(random_source *, tdmf_model *, tdmf_ensemble_case *, double[TDMF_SECTION_COUNT]);

/* Runners that graze while they retract, past the clamp's kink or past an apex: one in thousands does. */
static const uint64_t seldom[] = {20264029, 20264524, 20265831, 20264639, 20266581, 20267947};

static uint64_t seed_of(int runner) {
    const size_t number = (size_t)runner;
    return number < sizeof seldom / sizeof seldom[0] ? seldom[number] : 20261121 + number;
}

static population *make_population(put_runner *put, int max_strides) {
    population *population = calloc(1, sizeof *population);
    assert_non_null(population);
    for (int i = 0; i < RUNNERS; ++i) {
        random_source source = {seed_of(i)};
        population->case_of[i] = RUNNERS - 1 - i;
        tdmf_ensemble_case *its_case = &population->cases[population->case_of[i]];
        tdmf_model *model = &population->models[i];
        put(&source, model, its_case, population->starts[i]);
        its_case->model = model;
        its_case->rules.max_strides = max_strides;
    }
    population->ensemble.cases = population->cases;
    population->ensemble.case_count = RUNNERS;
    population->ensemble.case_of = population->case_of;
    population->ensemble.starts = (const double(*)[TDMF_SECTION_COUNT])population->starts;
    population->ensemble.count = RUNNERS;
    population->ensemble.relative_tolerance = tight;
    population->ensemble.threads = 1;
    return population;
}

static tdmf_ensemble_end *run(const tdmf_ensemble *ensemble, tdmf_ensemble_work *work) {
    tdmf_ensemble_end *ends = calloc((size_t)ensemble->count, sizeof *ends);
    assert_non_null(ends);
    assert_true(tdmf_run_ensemble(ensemble, ends, work));
    return ends;
}

/* ---- instruction sets ---------------------------------------------------------------------------------- */

/* How many there are here; the best is always one of those that follow it. */
static int instruction_sets(int first) {
    int count = 0;
    for (int set = first; set <= (int)tdmf_best_instructions(); ++set) {
        count += tdmf_has_instructions((tdmf_instructions)set);
    }
    return count;
}

/* Every instruction set ends every runner as one by one, bit for bit, and follows all of them. */
static void assert_agreement(population *population) {
    int sets = 0;
    population->ensemble.instructions = TDMF_ONE_BY_ONE;
    tdmf_ensemble_end *alone = run(&population->ensemble, NULL);
    for (int i = 0; i < RUNNERS; ++i) {
        assert_int_not_equal(alone[i].fate, TDMF_FATE_UNSOLVED);
    }
    for (int set = TDMF_TWO_LANES; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
        if (!tdmf_has_instructions((tdmf_instructions)set)) {
            print_message("not here: %s\n", tdmf_instructions_name((tdmf_instructions)set));
            continue;
        }
        population->ensemble.instructions = (tdmf_instructions)set;
        tdmf_ensemble_end *lanes = run(&population->ensemble, NULL);
        assert_memory_equal(lanes, alone, RUNNERS * sizeof *lanes);
        ++sets;
        free(lanes);
    }
    assert_int_equal(sets, instruction_sets(TDMF_TWO_LANES));
    free(alone);
    free(population);
}

TEST(runners_near_the_gait_end_alike_by_every_instruction_set) {
    assert_agreement(make_population(start_near_the_gait, 3));
}

TEST(any_runner_ends_alike_by_every_instruction_set) {
    assert_agreement(make_population(start_anywhere, 2));
}

/* Every third runner has a thrust and needs the whole page, the others the plain one. */
TEST(runners_of_both_pages_are_put_apart) {
    population *population = make_population(start_near_the_gait, 3);
    for (int i = 0; i < RUNNERS; ++i) {
        tdmf_parameters p = tdmf_default_parameters();
        p.leg.thrust = i % 3 == 0 ? 1e-4 : 0.0;
        population->models[i] = accepted_model(&p);
    }
    tdmf_ensemble_end *together = run(&population->ensemble, NULL);
    tdmf_ensemble one = population->ensemble;
    one.count = 1;
    for (int i = 0; i < RUNNERS; i += 11) {
        one.starts = &population->ensemble.starts[i];
        one.case_of = &population->case_of[i];
        tdmf_ensemble_end *alone = run(&one, NULL);
        assert_memory_equal(alone, &together[i], sizeof *alone);
        assert_true(alone->strides == 0 || (alone->leg_work != 0.0) == (i % 3 == 0));
        free(alone);
    }
    free(together);
    free(population);
}

/* ---- neighbours and threads --------------------------------------------------------------------------- */

TEST(threads_do_not_matter) {
    population *population = make_population(start_near_the_gait, 4);
    tdmf_ensemble_end *alone = run(&population->ensemble, NULL);
    for (int threads = 2; threads <= 7; threads += 5) {
        population->ensemble.threads = threads;
        tdmf_ensemble_end *shared = run(&population->ensemble, NULL);
        assert_memory_equal(shared, alone, RUNNERS * sizeof *alone);
        free(shared);
    }
    free(alone);
    free(population);
}

TEST(neighbours_do_not_matter) {
    population *population = make_population(start_near_the_gait, 4);
    tdmf_ensemble_end *together = run(&population->ensemble, NULL);
    tdmf_ensemble one = population->ensemble;
    one.count = 1;
    for (int i = 0; i < RUNNERS; i += 7) {
        one.starts = &population->ensemble.starts[i];
        one.case_of = &population->case_of[i];
        tdmf_ensemble_end *alone = run(&one, NULL);
        assert_memory_equal(alone, &together[i], sizeof *alone);
        free(alone);
    }
    free(together);
    free(population);
}

/* ---- what becomes of runners -------------------------------------------------------------------------- */

static double mechanical_energy(const tdmf_model *model, const double apex[TDMF_SECTION_COUNT]) {
    double state[TDMF_STATE_COUNT];
    const tdmf_inputs inputs = tdmf_default_inputs();
    const tdmf_mode mode = {.contact = TDMF_CONTACT_FLIGHT};
    tdmf_section_state((tdmf_system){model, &inputs}, apex, state);
    return tdmf_mechanical_energy((tdmf_system){model, &inputs}, &mode, state).total;
}

TEST(energy_is_accounted_for) {
    population *population = make_population(start_near_the_gait, 20);
    tdmf_ensemble_end *ends = run(&population->ensemble, NULL);
    for (int i = 0; i < RUNNERS; ++i) {
        const tdmf_model *model = &population->models[i];
        const tdmf_ensemble_end *end = &ends[i];
        if (end->strides > 0) {
            const double change =
                mechanical_energy(model, end->apex) - mechanical_energy(model, population->starts[i]);
            assert_close(change, end->work - end->damper_loss - end->friction_loss - end->impact_loss, 1e-8);
        }
    }
    free(ends);
    free(population);
}

/* Friction 0.6: the reference gait attracts what starts near it, what starts low falls, what starts below the
 * ground does not start. What is no gait, being no number, attracts nothing. */
TEST(runners_settle_fall_or_do_not_start) {
    double gaits[2][TDMF_SECTION_COUNT], starts[4][TDMF_SECTION_COUNT];
    const tdmf_model model = table_1(false);
    for (int i = 0; i < 4; ++i) {
        memcpy(starts[i], &reference_gaits[DEFAULT_GAIT].apex, sizeof starts[i]);
    }
    for (int i = 0; i < 2; ++i) {
        memcpy(gaits[i], &reference_gaits[DEFAULT_GAIT].apex, sizeof gaits[i]);
    }
    gaits[0][TDMF_SECTION_LEG_ANGLE_RATE] = NAN;
    starts[1][TDMF_SECTION_COM_HEIGHT] += 0.05;
    starts[2][TDMF_SECTION_LEG_ANGLE] = -1.2;
    starts[2][TDMF_SECTION_COM_HEIGHT] = 0.4;
    starts[3][TDMF_SECTION_COM_HEIGHT] = 0.1;
    const tdmf_ensemble_case its_case = {&model,
                                         tdmf_default_inputs(),
                                         {.gaits = (const double(*)[TDMF_SECTION_COUNT])gaits,
                                          .gait_count = 2,
                                          .distance = 1e-3,
                                          .max_strides = 400}};
    tdmf_ensemble ensemble = {.cases = &its_case,
                              .case_count = 1,
                              .starts = (const double(*)[TDMF_SECTION_COUNT])starts,
                              .count = 4,
                              .relative_tolerance = 1e-9,
                              .threads = 7};
    int sets = 0;
    for (int set = 0; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
        ensemble.instructions = (tdmf_instructions)set;
        if (!tdmf_has_instructions(ensemble.instructions)) {
            continue;
        }
        tdmf_ensemble_end *ends = run(&ensemble, NULL);
        assert_int_equal(ends[0].fate, TDMF_FATE_SETTLED);
        assert_int_equal(ends[0].strides, 1);
        assert_int_equal(ends[0].gait, 1);
        assert_int_equal(ends[1].fate, TDMF_FATE_SETTLED);
        assert_true(ends[1].strides > 1);
        assert_int_equal(ends[2].fate, TDMF_FATE_FELL);
        assert_int_equal(ends[2].gait, -1);
        assert_int_equal(ends[3].fate, TDMF_FATE_NO_START);
        free(ends);
        ++sets;
    }
    assert_int_equal(sets, instruction_sets(TDMF_BEST_INSTRUCTIONS));
    assert_true(sets >= 2);
}

/* A runner's fate from an upright apex, by every instruction set. */
static void assert_fate(const tdmf_parameters *parameters, tdmf_fate fate) {
    const tdmf_model model = accepted_model(parameters);
    const double start[1][TDMF_SECTION_COUNT] = {{1.0, 0.0, 1.0, 0.0, 0.0, 0.0}};
    const tdmf_ensemble_case its_case = {&model, tdmf_default_inputs(), {.max_strides = 10}};
    tdmf_ensemble ensemble = {.cases = &its_case,
                              .case_count = 1,
                              .starts = start,
                              .count = 1,
                              .relative_tolerance = 1e-9,
                              .threads = 7};
    for (int set = 0; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
        ensemble.instructions = (tdmf_instructions)set;
        if (tdmf_has_instructions(ensemble.instructions)) {
            tdmf_ensemble_end *ends = run(&ensemble, NULL);
            assert_int_equal(ends[0].fate, fate);
            assert_int_equal(ends[0].gait, -1);
            free(ends);
        }
    }
}

/* It closes no stride; the engine gives it up instead of waiting. A drive ends where the leg is upright, so
 * that it tips nobody over who lands so. */
TEST(a_runner_that_sinks_into_a_stand_is_undecided) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.damping = 2.0;
    parameters.hip.touchdown_angle = 0.0;
    assert_fate(&parameters, TDMF_FATE_UNDECIDED);
    parameters.hip.stance_torque = 0.0;
    assert_fate(&parameters, TDMF_FATE_UNDECIDED);
    parameters.hip.touchdown_angle = 0.3;
    assert_fate(&parameters, TDMF_FATE_FELL);
}

/* The hip's servo is so stiff that no step changes the time. */
TEST(what_the_solver_does_not_get_through_is_no_fall) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.foot.mass = 1e-12;
    parameters.hip.kp = parameters.hip.kd = 1e18;
    assert_fate(&parameters, TDMF_FATE_UNSOLVED);
}

/* The gait at friction 0.6 takes more steps a stride than a fortieth of these limits, so that it runs out. */
TEST(strides_of_a_runner_share_their_steps) {
    double starts[1][TDMF_SECTION_COUNT];
    const tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_model model = accepted_model(&parameters);
    const tdmf_ensemble_case its_case = {&model, tdmf_default_inputs(), {.max_strides = 400}};
    memcpy(starts[0], &reference_gaits[DEFAULT_GAIT].apex, sizeof starts[0]);
    tdmf_ensemble ensemble = {.cases = &its_case,
                              .case_count = 1,
                              .starts = (const double(*)[TDMF_SECTION_COUNT])starts,
                              .count = 1,
                              .relative_tolerance = 1e-11,
                              .threads = 1};
    for (int set = TDMF_ONE_BY_ONE; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
        ensemble.instructions = (tdmf_instructions)set;
        for (long limit = 200; tdmf_has_instructions(ensemble.instructions) && limit <= 800; limit *= 2) {
            tdmf_ensemble_work work;
            ensemble.step_limit = limit;
            tdmf_ensemble_end *ends = run(&ensemble, &work);
            assert_int_equal(ends[0].fate, TDMF_FATE_UNSOLVED);
            assert_true(ends[0].strides > 1 && ends[0].strides < 400);
            assert_true(work.steps <= limit + (ends[0].strides + 1) * limit / TDMF_STEP_SHARE);
            free(ends);
        }
        ensemble.step_limit = 0;
        if (tdmf_has_instructions(ensemble.instructions)) {
            tdmf_ensemble_end *ends = run(&ensemble, NULL);
            assert_int_equal(ends[0].strides, 400);
            free(ends);
        }
    }
}

TEST(work_is_counted) {
    population *population = make_population(start_near_the_gait, 5);
    tdmf_ensemble_work work;
    long strides = 0, fallen = 0, closed_none = 0;
    population->ensemble.threads = 2;
    tdmf_ensemble_end *ends = run(&population->ensemble, &work);
    for (int i = 0; i < RUNNERS; ++i) {
        strides += ends[i].strides;
        fallen += ends[i].fate == TDMF_FATE_FELL;
        closed_none += ends[i].strides == 0;
    }
    /* The crowd is mixed: what the other tests say of it, they say of falls as well. */
    assert_true(fallen > RUNNERS / 20 && fallen < RUNNERS / 2 && closed_none > 0);
    assert_int_equal(work.strides, strides);
    assert_true(work.events > 4 * strides && work.steps > work.events);
    assert_true(work.lane_steps >= work.steps && work.evaluations > 8 * work.steps);
    free(ends);
    free(population);
}

/* Events of the word +0-0+: touchdown, two slips that end and two that begin, mid-stance, lift-off, the end
 * of graze, and the apex; with the clamp, its release too. Even at this tolerance each event is met once,
 * where a series has found it. */
TEST(each_event_is_met_once) {
    enum { EVENTS = 9, STRIDES = 7 };
    int sets = 0;
    for (int clamp = 0; clamp < 2; ++clamp) {
        const tdmf_model model = table_1(clamp == 1);
        const tdmf_ensemble_case its_case = {&model, tdmf_default_inputs(), {.max_strides = STRIDES}};
        double starts[1][TDMF_SECTION_COUNT];
        memcpy(starts[0], &reference_gaits[clamp ? CLAMPED_GAIT : DEFAULT_GAIT].apex, sizeof starts[0]);
        tdmf_ensemble ensemble = {.cases = &its_case,
                                  .case_count = 1,
                                  .starts = (const double(*)[TDMF_SECTION_COUNT])starts,
                                  .count = 1,
                                  .relative_tolerance = 1e-8,
                                  .threads = 1};
        for (int set = TDMF_TWO_LANES; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
            tdmf_ensemble_work work;
            ensemble.instructions = (tdmf_instructions)set;
            if (tdmf_has_instructions(ensemble.instructions)) {
                free(run(&ensemble, &work));
                assert_int_equal(work.events, (EVENTS + clamp) * STRIDES);
                ++sets;
            }
        }
    }
    assert_int_equal(sets, 2 * instruction_sets(TDMF_TWO_LANES));
}

TEST(unsound_ensembles_are_refused) {
    population *population = make_population(start_near_the_gait, 1);
    tdmf_ensemble_end end = {.strides = 77};
    const double tolerances[] = {0.0, -1.0, 1.0, NAN, INFINITY};
    for (size_t i = 0; i < sizeof tolerances / sizeof tolerances[0]; ++i) {
        tdmf_ensemble bad = population->ensemble;
        bad.relative_tolerance = tolerances[i];
        assert_false(tdmf_run_ensemble(&bad, &end, NULL));
    }
    tdmf_ensemble bad = population->ensemble;
    bad.threads = 0;
    assert_false(tdmf_run_ensemble(&bad, &end, NULL));
    static const int no_cases[] = {-1, RUNNERS};
    for (size_t i = 0; i < sizeof no_cases / sizeof no_cases[0]; ++i) {
        population->case_of[RUNNERS - 1] = no_cases[i];
        assert_false(tdmf_run_ensemble(&population->ensemble, &end, NULL));
    }
    bad = population->ensemble;
    bad.instructions = TDMF_INSTRUCTIONS_COUNT;
    assert_false(tdmf_run_ensemble(&bad, &end, NULL));
    assert_int_equal(end.strides, 77);
    assert_true(tdmf_has_instructions(tdmf_best_instructions()));
    assert_true(tdmf_has_instructions(TDMF_ONE_BY_ONE));
    free(population);
}

/* ---- strides --------------------------------------------------------------------------------------------
 */

static void assert_equal_strides(const tdmf_return *made, const tdmf_return *alone, int variations) {
    assert_int_equal(made->outcome, alone->outcome);
    assert_memory_equal(made->apex, alone->apex, sizeof alone->apex);
    assert_memory_equal(&made->measures, &alone->measures, sizeof alone->measures);
    assert_memory_equal(made->variations, alone->variations, (size_t)variations * sizeof *alone->variations);
    assert_string_equal(made->stride.word, alone->stride.word);
}

/* Whichever of them close, fall or take no start. */
static void strides_in_lanes_are_those_made_alone(put_runner *put) {
    enum { ALL = TDMF_SECTION_COUNT + 1 };
    population *population = make_population(put, 1);
    tdmf_system *systems = calloc(RUNNERS, sizeof *systems);
    double *until = calloc(RUNNERS, sizeof *until);
    tdmf_return *made = calloc(RUNNERS, sizeof *made);
    const tdmf_seed seed = {.inputs = {.ground = {.friction = 1.0}}};
    tdmf_solver solver = tdmf_solver_default();
    int closed = 0;
    for (int i = 0; i < RUNNERS; ++i) {
        const tdmf_ensemble_case *its_case = &population->cases[population->case_of[i]];
        const tdmf_system system = {its_case->model, &its_case->inputs};
        systems[i] = system;
        until[i] = 1e4 * its_case->model->scales.time;
    }
    const tdmf_stride_batch batch = {
        systems, population->ensemble.starts, until, RUNNERS, true, true, &seed, 1, 2};
    assert_true(tdmf_run_strides(&solver, &batch, made));
    for (int i = 0; i < RUNNERS; ++i) {
        const tdmf_return alone =
            tdmf_measured_return_map(&solver, systems[i], population->starts[i], until[i], true, &seed, 1);
        assert_equal_strides(&made[i], &alone, ALL);
        closed += alone.outcome == TDMF_RETURN_CLOSED;
    }
    assert_true(closed > RUNNERS / 20 && closed < RUNNERS);
    free(systems);
    free(until);
    free(made);
    free(population);
}

TEST(strides_near_the_gait_are_those_made_alone) {
    strides_in_lanes_are_those_made_alone(start_near_the_gait);
}

TEST(any_strides_are_those_made_alone) {
    strides_in_lanes_are_those_made_alone(start_anywhere);
}
