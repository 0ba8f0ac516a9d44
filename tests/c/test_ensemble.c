/* The ensemble engine: a runner's end is the same, bit for bit, by every instruction set, whoever its
 * neighbours are and however many threads there are; and it is the native solver's end. */
#include "compare.h"
#include "crowd.h"
#include "reference_gaits.h"
#include "references.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

enum { RUNNERS = sample_of(1500) };

static const double tight = 1e-11;

/* ---- crowds -------------------------------------------------------------------------------------------- */

static void scale_randomly(random_source *source, double *value, double max_factor) {
    *value *= random_magnitude(source, 1.0 / max_factor, max_factor);
}

/* Starts lie around a gait's apex, some of them below the ground. */
static void place_near_the_gait(random_source *source, crowd *crowd, int i) {
    tdmf_parameters p = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    double start[TDMF_SECTION_COUNT];
    double *const varied[] = {&p.body.mass,         &p.foot.mass, &p.leg.damping, &p.gravity,
                              &p.hip.stance_torque, &p.hip.kp,    &p.hip.kd,      &p.hip.touchdown_angle};
    for (size_t k = 0; k < COUNT_OF(varied); ++k) {
        scale_randomly(source, varied[k], 1.2);
    }
    p.hip.retraction_rate = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.02, 0.02);
    p.ground.static_friction_ratio = random_chance(source, 0.5) ? 1.0 : random_uniform(source, 1.0, 1.5);
    p.hip.swing_clamp = random_truth(*source);
    inputs.ground.friction = random_magnitude(source, 0.02, 10.0);
    inputs.hip.external_torque = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.01, 0.01);
    memcpy(start, &reference_gaits[DEFAULT_GAIT].apex, sizeof start);
    for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
        start[k] += random_uniform(source, -0.4, 0.4) * (k == TDMF_SECTION_LEG_LENGTH ? 0.1 : 1.0);
    }
    place_runner(crowd, i, &p, &inputs, start);
}

/* Anything: most of these fall, by every way there is. */
static void place_anywhere(random_source *source, crowd *crowd, int i) {
    const runner anybody = scene_random(source, TDMF_CONTACT_FLIGHT);
    const tdmf_point com = tdmf_center_of_mass(&anybody.model, anybody.motion.state);
    const double section[TDMF_SECTION_COUNT] = {com.y,
                                                com.vx,
                                                anybody.motion.state[TDMF_LEG_LENGTH],
                                                2.0 * anybody.motion.state[TDMF_LEG_ANGLE],
                                                anybody.motion.state[TDMF_LEG_LENGTH_RATE],
                                                anybody.motion.state[TDMF_LEG_ANGLE_RATE]};
    place_runner(crowd, i, &anybody.model.parameters, &anybody.inputs, section);
}

typedef void put_runner(random_source *source, crowd *crowd, int i);

/* Runners that graze while they retract, past the clamp's kink or past an apex: one in thousands does. */
static const uint64_t rare[] = {20264029, 20264524, 20265831, 20264639, 20266581, 20267947};
enum { RARE = COUNT_OF(rare) };

static crowd *random_crowd(put_runner *put, int max_strides) {
    crowd *crowd = make_crowd(RUNNERS, max_strides, tight);
    for (int i = 0; i < RUNNERS; ++i) {
        random_source source = {i < RARE ? rare[i] : 20261121 + (uint64_t)i};
        put(&source, crowd, i);
    }
    return crowd;
}

/* ---- runners of every kind ----------------------------------------------------------------------------- */

enum { OTHERS = 40, KINDS_OF_OTHERS = 5 };
enum {
    SPECIAL = 1 + FURTHER_GAITS + REFERENCE_GAITS + 2 * FREE_STRIDES + EXTENDED_STRIDES + PATCH_RUNS +
              KINDS_OF_OTHERS * OTHERS
};

/* Pushed, extended and thrusting runners on slopes; legs that have wound, that whirl, that pass upright in
 * graze under the widest cone; and runners that are too stiff for the solver. */
static void place_other(random_source *source, crowd *crowd, int number, int kind) {
    static const double frictions[] = {1e3, 3e3, 1e4, 1e5, 3e5, 1e6};
    tdmf_parameters p = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    double at[TDMF_SECTION_COUNT];
    memcpy(at, &reference_gaits[DEFAULT_GAIT].apex, sizeof at);
    switch (kind) {
    case 0:
        p.leg.thrust = random_uniform(source, 0.0, 0.05);
        inputs.leg.extension = random_uniform(source, -0.02, 0.02);
        inputs.control.stance_torque = random_uniform(source, -0.1, 0.1);
        inputs.body.external_fx = random_uniform(source, -1e-3, 1e-3);
        inputs.body.external_fy = random_uniform(source, -5e-3, 5e-3);
        inputs.ground.slope = random_uniform(source, -0.1, 0.05);
        break;
    case 1:
        p.hip.kp = p.hip.kd = 1e-6;
        at[TDMF_SECTION_LEG_ANGLE] = floor(random_uniform(source, -158.0, 158.0)) * 6.283185307179586;
        at[TDMF_SECTION_LEG_ANGLE] += random_uniform(source, -0.75, 0.75);
        at[TDMF_SECTION_LEG_ANGLE_RATE] = random_uniform(source, -100.0, 100.0);
        break;
    case 2:
        at[TDMF_SECTION_COM_HEIGHT] = random_uniform(source, 150.0, 300.0);
        at[TDMF_SECTION_LEG_LENGTH] = random_uniform(source, 30.0, 100.0);
        at[TDMF_SECTION_LEG_ANGLE_RATE] = random_uniform(source, -3.4, 3.4);
        break;
    case 3:
        inputs.ground.friction = frictions[number % 6];
        at[TDMF_SECTION_COM_HEIGHT] += 0.001 * number;
        break;
    default:
        p.hip.kd = number % 2 ? 2.5e13 : p.hip.kd;
        p.foot.mass = number % 2 ? p.foot.mass : 1e-12;
    }
    place_runner(crowd, number, &p, &inputs, at);
}

/* A runner with a light foot that is pushed over a slope and passes upright in graze. */
static void place_one_that_passes_upright(crowd *crowd, int number) {
    static const double apex[TDMF_SECTION_COUNT] = {1.3, 0.1, 1.0, -0.29, 0.0, 0.0};
    tdmf_parameters p = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    p.gravity = 0.0046;
    p.ground.static_friction_ratio = 1.6;
    p.foot.mass = 0.02;
    p.leg.damping = 0.16;
    p.leg.thrust = 0.2;
    p.hip.stance_torque = 0.25;
    p.hip.touchdown_angle = 0.9;
    p.hip.kp = 0.028;
    p.hip.kd = 0.19;
    p.hip.liftoff_angle_factor = 1.0;
    inputs.ground.friction = 1.1;
    inputs.ground.slope = 0.04;
    inputs.body.external_fx = 0.001;
    inputs.body.external_fy = 0.0004;
    place_runner(crowd, number, &p, &inputs, apex);
}

static crowd *special_crowd(void) {
    crowd *crowd = make_crowd(SPECIAL, 1, 1e-12);
    random_source source = {31};
    int n = 0;
    place_one_that_passes_upright(crowd, n++);
    for (int i = 0; i < FURTHER_GAITS; ++i) {
        const tdmf_parameters p = parameters_of_further_gait(&further_gaits[i]);
        const tdmf_inputs inputs = inputs_of_further_gait(&further_gaits[i]);
        place_runner(crowd, n++, &p, &inputs, (const double *)&further_gaits[i].gait.apex);
    }
    for (int i = 0; i < REFERENCE_GAITS; ++i) {
        const tdmf_model model = table_1(reference_gaits[i].swing_clamp);
        const tdmf_inputs inputs = inputs_at_friction(reference_gaits[i].friction);
        place_runner(crowd, n++, &model.parameters, &inputs, (const double *)&reference_gaits[i].apex);
    }
    for (int i = 0; i < 2 * FREE_STRIDES; ++i) {
        const free_stride *stride = &free_strides[i / 2];
        const tdmf_model model = model_of_free_stride(stride, i % 2 == 1);
        const tdmf_inputs inputs = inputs_at_friction(stride->friction);
        place_runner(crowd, n++, &model.parameters, &inputs, stride->start);
    }
    for (int i = 0; i < EXTENDED_STRIDES; ++i) {
        const tdmf_parameters p = parameters_of_stride(&extended_strides[i]);
        const tdmf_inputs inputs = inputs_at_friction(extended_strides[i].friction);
        place_runner(crowd, n++, &p, &inputs, extended_strides[i].start);
    }
    for (int i = 0; i < PATCH_RUNS; ++i) {
        const tdmf_parameters p = parameters_of_patch_run(&patch_runs[i]);
        const tdmf_inputs inputs = inputs_of_patch_run(&patch_runs[i]);
        place_runner(crowd, n++, &p, &inputs, patch_runs[i].start);
    }
    for (int i = 0; i < KINDS_OF_OTHERS * OTHERS; ++i) {
        place_other(&source, crowd, n++, i / OTHERS);
    }
    assert_int_equal(n, SPECIAL);
    return crowd;
}

/* Runners that stride, fall, and are given up. */
TEST(each_runner_ends_as_by_the_native_solver) {
    static tdmf_ensemble_stride strides[SPECIAL];
    crowd *crowd = special_crowd();
    int closed = 0, fell = 0, unsolved = 0;
    crowd->ensemble.strides = strides;
    crowd->ensemble.stride_count = 1;
    run_crowd(crowd, TDMF_ONE_BY_ONE);
    for (int i = 0; i < SPECIAL; ++i) {
        const tdmf_fate fate = (tdmf_fate)crowd->ends[i].fate;
        simulation alone = simulation_from(&crowd->models[i].parameters, &crowd->cases[i].inputs,
                                           crowd->starts[i], crowd->ensemble.relative_tolerance);
        const tdmf_stride_outcome outcome =
            tdmf_native_stride(&alone.solver, SYSTEM_OF(&alone), 1e6, &alone.motion);
        assert_int_equal(crowd->ends[i].strides, outcome.closed);
        assert_true((fate == TDMF_FATE_FELL) == (outcome.outcome == TDMF_FELL));
        assert_true((fate == TDMF_FATE_UNSOLVED) == (outcome.outcome == TDMF_TOO_STIFF));
        if (outcome.closed) {
            double apex[TDMF_SECTION_COUNT];
            read_apex(&alone.motion, apex);
            assert_same_stride(strides[i].stride, last_stride_of(&alone.motion), 1e-9);
            assert_all_close(strides[i].apex, apex, TDMF_SECTION_COUNT, 1e-9, 1e-9);
        }
        closed += outcome.closed;
        fell += fate == TDMF_FATE_FELL;
        unsolved += fate == TDMF_FATE_UNSOLVED;
    }
    assert_true(closed > SPECIAL / 2 && fell >= 3);
    assert_int_equal(unsolved, OTHERS);
}

/* ---- instruction sets ---------------------------------------------------------------------------------- */

/* Every instruction set ends every runner as one by one, bit for bit. */
static void assert_agreement(crowd *crowd) {
    tdmf_ensemble_end *alone = ends_of(crowd, TDMF_ONE_BY_ONE);
    int compared = 0;
    FOR_INSTRUCTIONS(set) {
        ++compared;
        run_crowd(crowd, set);
        assert_memory_equal(crowd->ends, alone, (size_t)crowd->count * sizeof *alone);
    }
    assert_true(compared >= 2);
}

TEST(runners_near_the_gait_end_alike_by_every_instruction_set) {
    assert_agreement(random_crowd(place_near_the_gait, 3));
}

TEST(any_runner_ends_alike_by_every_instruction_set) {
    assert_agreement(random_crowd(place_anywhere, 2));
}

TEST(runners_of_every_kind_end_alike_by_every_instruction_set) {
    assert_agreement(special_crowd());
}

/* ---- neighbours and threads --------------------------------------------------------------------------- */

/* Every third runner has a thrust and needs the whole page, the others the plain one. */
TEST(neighbours_and_threads_do_not_matter) {
    crowd *crowd = random_crowd(place_near_the_gait, 4);
    for (int i = 0; i < RUNNERS; i += 3) {
        tdmf_parameters p = crowd->models[i].parameters;
        p.leg.thrust = 1e-4;
        crowd->models[i] = accepted_model(&p);
    }
    const tdmf_ensemble_end *together = assert_independent_runners(crowd, 7);
    for (int i = 0; i < RUNNERS; ++i) {
        assert_true(together[i].strides == 0 || (together[i].leg_work != 0.0) == (i % 3 == 0));
    }
}

/* ---- what becomes of runners -------------------------------------------------------------------------- */

static double mechanical_energy(const tdmf_model *model, const double apex[TDMF_SECTION_COUNT]) {
    tdmf_motion motion = {.mode = {.contact = TDMF_CONTACT_FLIGHT}};
    const tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_section_state((tdmf_system){model, &inputs}, apex, motion.state);
    return outputs_of((tdmf_system){model, &inputs}, &motion).energy.total;
}

TEST(energy_is_accounted_for_and_work_is_counted) {
    crowd *crowd = random_crowd(place_near_the_gait, 20);
    tdmf_ensemble_work work;
    long strides = 0, fallen = 0, closed_none = 0;
    crowd->ensemble.threads = 2;
    assert_null(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, &work).variable);
    for (int i = 0; i < RUNNERS; ++i) {
        const tdmf_ensemble_end *end = &crowd->ends[i];
        strides += end->strides;
        fallen += end->fate == TDMF_FATE_FELL;
        closed_none += end->strides == 0;
        if (end->strides > 0) {
            const double change = mechanical_energy(&crowd->models[i], end->apex) -
                                  mechanical_energy(&crowd->models[i], crowd->starts[i]);
            assert_close(change, end->work - end->damper_loss - end->friction_loss - end->impact_loss, 1e-8);
        }
    }
    /* The crowd is mixed: what other tests say of it, they say of falls as well. */
    assert_true(fallen > RUNNERS / 20 && fallen < 2 * RUNNERS / 3 && closed_none > 0);
    assert_int_equal(work.strides, strides);
    assert_true(work.events > 4 * strides && work.steps > work.events);
    assert_true(work.lane_steps >= work.steps && work.evaluations > 8 * work.steps);
}

/* Friction 0.6: runners that start near the reference gait settle on it, runners that start low fall, and
 * runners below the ground do not start. A gait of NaN attracts no runner. */
TEST(runners_settle_fall_or_do_not_start) {
    double gaits[2][TDMF_POINT_LIMIT] = {{0.0}};
    crowd *crowd = make_crowd(4, 400, 1e-9);
    for (int i = 0; i < 2; ++i) {
        memcpy(gaits[i], &reference_gaits[DEFAULT_GAIT].apex, sizeof reference_gaits[DEFAULT_GAIT].apex);
    }
    gaits[0][TDMF_SECTION_LEG_ANGLE_RATE] = NAN;
    for (int i = 0; i < 4; ++i) {
        crowd->cases[i].rules.gaits = (const double(*)[TDMF_POINT_LIMIT])gaits;
        crowd->cases[i].rules.gait_count = 2;
        crowd->cases[i].rules.distance = 1e-3;
    }
    crowd->starts[1][TDMF_SECTION_COM_HEIGHT] += 0.05;
    crowd->starts[2][TDMF_SECTION_LEG_ANGLE] = -1.2;
    crowd->starts[2][TDMF_SECTION_COM_HEIGHT] = 0.4;
    crowd->starts[3][TDMF_SECTION_COM_HEIGHT] = 0.1;
    crowd->ensemble.threads = 7;
    FOR_INSTRUCTIONS(set) {
        const tdmf_ensemble_end *ends = crowd->ends;
        run_crowd(crowd, set);
        assert_int_equal(ends[0].fate, TDMF_FATE_SETTLED);
        assert_int_equal(ends[0].strides, 1);
        assert_int_equal(ends[0].gait, 1);
        assert_int_equal(ends[1].fate, TDMF_FATE_SETTLED);
        assert_true(ends[1].strides > 1);
        assert_int_equal(ends[2].fate, TDMF_FATE_FELL);
        assert_int_equal(ends[2].gait, -1);
        assert_int_equal(ends[3].fate, TDMF_FATE_NO_START);
    }
}

/* A runner's fate from an upright apex. It closes no stride in a stand; the engine gives it up instead of
 * waiting. A drive ends where the leg is upright, so that it tips nobody over who lands so. */
TEST(a_runner_that_sinks_into_a_stand_is_undecided) {
    static const double start[TDMF_SECTION_COUNT] = {1.0, 0.0, 1.0, 0.0, 0.0, 0.0};
    static const double torques[] = {0.2, 0.0, 0.0}, angles[] = {0.0, 0.0, 0.3};
    const tdmf_inputs inputs = tdmf_default_inputs();
    crowd *crowd = make_crowd(3, 10, 1e-9);
    for (int i = 0; i < 3; ++i) {
        tdmf_parameters parameters = tdmf_default_parameters();
        parameters.leg.damping = 2.0;
        parameters.hip.stance_torque = torques[i];
        parameters.hip.touchdown_angle = angles[i];
        place_runner(crowd, i, &parameters, &inputs, start);
    }
    FOR_INSTRUCTIONS(set) {
        run_crowd(crowd, set);
        for (int i = 0; i < 3; ++i) {
            assert_int_equal(crowd->ends[i].fate, i < 2 ? TDMF_FATE_UNDECIDED : TDMF_FATE_FELL);
            assert_int_equal(crowd->ends[i].gait, -1);
        }
    }
}

/* The gait at friction 0.6 takes more steps a stride than a fortieth of these limits, so that it runs out. */
TEST(strides_of_a_runner_share_their_steps) {
    crowd *crowd = make_crowd(1, 400, 1e-11);
    const tdmf_ensemble_end *end = crowd->ends;
    FOR_INSTRUCTIONS(set) {
        for (long limit = 200; limit <= 800; limit *= 2) {
            tdmf_ensemble_work work;
            crowd->ensemble.step_limit = limit;
            crowd->ensemble.instructions = set;
            assert_null(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, &work).variable);
            assert_int_equal(end->fate, TDMF_FATE_UNSOLVED);
            assert_true(end->strides > 1 && end->strides < 400);
            assert_true(work.steps <= limit + (end->strides + 1) * limit / TDMF_STEP_SHARE);
        }
        crowd->ensemble.step_limit = 0;
        run_crowd(crowd, set);
        assert_int_equal(end->strides, 400);
    }
}

/* Events of the word +0-0+: touchdown, two slips that end and two that begin, mid-stance, lift-off, the end
 * of graze, and the apex; with the clamp, its release too. Even at this tolerance each event is met once,
 * where a series has found it. */
TEST(each_event_is_met_once) {
    enum { EVENTS = 9, STRIDES = 7 };
    for (int clamp = 0; clamp < 2; ++clamp) {
        FOR_INSTRUCTIONS(set) {
            const tdmf_model model = table_1(clamp == 1);
            const tdmf_inputs inputs = tdmf_default_inputs();
            crowd *crowd = make_crowd(1, STRIDES, 1e-8);
            tdmf_ensemble_work work;
            place_runner(crowd, 0, &model.parameters, &inputs,
                         (const double *)&reference_gaits[clamp ? CLAMPED_GAIT : DEFAULT_GAIT].apex);
            crowd->ensemble.instructions = set;
            assert_null(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, &work).variable);
            assert_int_equal(work.events, (EVENTS + clamp) * STRIDES);
        }
    }
}

TEST(unsound_ensembles_are_refused) {
    static const double tolerances[] = {0.0, -1.0, 1.0, NAN, INFINITY};
    static const int no_cases[] = {-1, RUNNERS};
    crowd *crowd = random_crowd(place_near_the_gait, 1);
    for (size_t i = 0; i < COUNT_OF(tolerances); ++i) {
        crowd->ensemble.relative_tolerance = tolerances[i];
        assert_crowd_is_refused(crowd);
    }
    crowd->ensemble.relative_tolerance = tight;
    crowd->ensemble.threads = 0;
    assert_crowd_is_refused(crowd);
    crowd->ensemble.threads = 1;
    crowd->ensemble.instructions = TDMF_INSTRUCTIONS_COUNT;
    assert_crowd_is_refused(crowd);
    crowd->ensemble.instructions = TDMF_BEST_INSTRUCTIONS;
    for (size_t i = 0; i < COUNT_OF(no_cases); ++i) {
        crowd->case_of[RUNNERS - 1] = no_cases[i];
        assert_crowd_is_refused(crowd);
    }
    assert_true(tdmf_has_instructions(TDMF_ONE_BY_ONE));
}

/* ---- strides with derivatives -------------------------------------------------------------------------- */

/* Whichever of them close, fall or take no start: bit for bit. */
static void assert_strides_in_lanes_are_those_made_alone(crowd *crowd, tdmf_apex_map map) {
    const size_t all = map == TDMF_REDUCED_MAP ? TDMF_REDUCED_COUNT + 1 : TDMF_SECTION_COUNT + 1;
    tdmf_system *systems = allocate(RUNNERS, sizeof *systems);
    double *until = allocate(RUNNERS, sizeof *until);
    tdmf_return *made = allocate(RUNNERS, sizeof *made);
    const tdmf_seed seed = {.inputs = {.ground = {.friction = 1.0}}};
    tdmf_solver solver = tdmf_solver_default();
    int closed = 0;
    for (int i = 0; i < RUNNERS; ++i) {
        systems[i] = (tdmf_system){&crowd->models[i], &crowd->cases[i].inputs};
        until[i] = 1e4 * crowd->models[i].scales.time;
    }
    const tdmf_stride_batch batch = {.systems = systems,
                                     .sections = crowd->ensemble.starts,
                                     .until = until,
                                     .count = RUNNERS,
                                     .map = map,
                                     .derivatives = true,
                                     .measures = map == TDMF_RETURN_MAP,
                                     .seeds = &seed,
                                     .seed_count = 1,
                                     .threads = 2};
    assert_int_equal(tdmf_run_strides(&solver, &batch, made).code, TDMF_ACCEPTED);
    for (int i = 0; i < RUNNERS; ++i) {
        const double *start = crowd->starts[i];
        const tdmf_return alone =
            map == TDMF_REDUCED_MAP
                ? reduced_map(&solver, systems[i], start, until[i], true, &seed, 1)
                : measured_return_map(&solver, systems[i], start, until[i], true, &seed, 1);
        assert_int_equal(made[i].outcome, alone.outcome);
        assert_memory_equal(made[i].apex, alone.apex, sizeof alone.apex);
        assert_memory_equal(&made[i].measures, &alone.measures, sizeof alone.measures);
        assert_memory_equal(made[i].variations, alone.variations, all * sizeof *alone.variations);
        assert_string_equal(made[i].stride.word, alone.stride.word);
        closed += alone.outcome == TDMF_RETURN_CLOSED;
    }
    assert_true(closed > RUNNERS / 20 && closed < RUNNERS);
}

TEST(strides_near_the_gait_are_those_made_alone) {
    assert_strides_in_lanes_are_those_made_alone(random_crowd(place_near_the_gait, 1), TDMF_RETURN_MAP);
    assert_strides_in_lanes_are_those_made_alone(random_crowd(place_near_the_gait, 1), TDMF_REDUCED_MAP);
}

TEST(any_strides_are_those_made_alone) {
    assert_strides_in_lanes_are_those_made_alone(random_crowd(place_anywhere, 1), TDMF_RETURN_MAP);
    assert_strides_in_lanes_are_those_made_alone(random_crowd(place_anywhere, 1), TDMF_REDUCED_MAP);
}
