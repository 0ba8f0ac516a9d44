/* Calls that make no sense, with a contact, a phase, a number of elements or a pointer that there is not, are
 * refused and touch nothing; and buffers that may be the same give what others give. */
#include "compare.h"
#include "crowd.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static const double long_enough = 1e3;

/* A run that stands at the apex of the default gait. */
static simulation standing_at_apex(void) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_inputs inputs = tdmf_default_inputs();
    return simulation_from(&parameters, &inputs, (const double *)&reference_gaits[DEFAULT_GAIT].apex,
                           tdmf_solver_default().relative_tolerance);
}

/* A copy of its section. */
static void copy_apex(double section[TDMF_SECTION_COUNT]) {
    memcpy(section, &reference_gaits[DEFAULT_GAIT].apex, TDMF_SECTION_COUNT * sizeof *section);
}

/* ---- contact and phase -------------------------------------------------------------------------------- */

static const int no_contacts[] = {0, -1, 6, 77, INT_MAX, INT_MIN};
static const int no_phases[] = {0, -1, 5, 40, INT_MAX, INT_MIN};
enum { NO_MODES = 6 };

static tdmf_mode no_mode(const tdmf_mode *mode, int which) {
    tdmf_mode changed = *mode;
    if (which < NO_MODES) {
        changed.contact = (tdmf_contact_mode)no_contacts[which];
    } else {
        changed.phase = (tdmf_hip_phase)no_phases[which - NO_MODES];
    }
    return changed;
}

typedef tdmf_outcome run(simulation *at);

static tdmf_outcome advance(simulation *s) {
    return tdmf_native_advance(&s->solver, SYSTEM_OF(s), NULL, 10.0, &s->motion);
}

static tdmf_outcome stride(simulation *s) {
    return tdmf_native_stride(&s->solver, SYSTEM_OF(s), long_enough, &s->motion).outcome;
}

static tdmf_outcome by_cvode(simulation *s) {
    return tdmf_cvode_advance(&s->solver, SYSTEM_OF(s), NULL, 10.0, &s->motion);
}

static run *const runs[] = {advance, stride, by_cvode};
enum { RUNS = COUNT_OF(runs) };

static void assert_refused(run *run, simulation *at) {
    const tdmf_motion before = at->motion;
    assert_int_equal(run(at), TDMF_REFUSED);
    assert_memory_equal(&at->motion, &before, sizeof before);
    assert_int_equal(at->solver.steps, 0);
}

TEST(no_solver_runs_in_a_mode_that_there_is_not_or_from_a_number_that_is_not_finite) {
    const double not_finite[] = {NAN, INFINITY, -INFINITY};
    const int count = tdmf_cvode_is_available() ? RUNS : RUNS - 1;
    for (int i = 0; i < count; ++i) {
        simulation sound = standing_at_apex();
        assert_int_not_equal(runs[i](&sound), TDMF_REFUSED);
        for (int which = 0; which < 2 * NO_MODES; ++which) {
            simulation at = standing_at_apex();
            at.motion.mode = no_mode(&at.motion.mode, which);
            assert_refused(runs[i], &at);
        }
        for (int which = 0; which < 3 * TDMF_STATE_COUNT; ++which) {
            simulation at = standing_at_apex();
            at.motion.state[which / 3] = not_finite[which % 3];
            assert_refused(runs[i], &at);
        }
        for (int which = 0; which < 3 * 8; ++which) {
            simulation at = standing_at_apex();
            double *const numbers[] = {&at.motion.time,
                                       &at.motion.begun,
                                       &at.motion.clock_rest,
                                       &at.motion.mode.rest_length,
                                       &at.motion.mode.ground.height,
                                       &at.motion.mode.ground.slope,
                                       &at.motion.mode.ground.sine,
                                       &at.motion.mode.ground.cosine};
            *numbers[which / 3] = not_finite[which % 3];
            assert_refused(runs[i], &at);
        }
    }
}

TEST(contact_and_phase_have_to_go_together) {
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        for (int phase = TDMF_PHASE_DRIVE; phase <= TDMF_PHASE_PLACE; ++phase) {
            simulation at = standing_at_apex();
            at.motion.mode.contact = (tdmf_contact_mode)contact;
            at.motion.mode.phase = (tdmf_hip_phase)phase;
            const bool of_stance = phase == TDMF_PHASE_DRIVE || phase == TDMF_PHASE_COAST;
            if (of_stance != tdmf_is_loaded(&at.motion.mode)) {
                assert_refused(advance, &at);
            } else {
                assert_int_not_equal(advance(&at), TDMF_REFUSED);
            }
        }
    }
}

TEST(the_automaton_takes_nothing_in_a_mode_that_there_is_not) {
    const simulation s = standing_at_apex();
    for (int which = 0; which < 2 * NO_MODES; ++which) {
        const tdmf_mode mode = no_mode(&s.motion.mode, which);
        tdmf_motion motion = s.motion;
        double guards[TDMF_GUARD_COUNT], derivatives[TDMF_STATE_COUNT];
        motion.mode = mode;
        motion.time = 1.0;
        const tdmf_motion before = motion;
        assert_true(tdmf_resolve(SYSTEM_OF(&s), &motion).unresolved);
        assert_memory_equal(&motion, &before, sizeof before);
        assert_int_equal(tdmf_first_due(SYSTEM_OF(&s), &mode, motion.state), TDMF_GUARD_COUNT);
        tdmf_guards(SYSTEM_OF(&s), &mode, motion.state, guards);
        for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
            assert_true(isnan(guards[i]));
        }
        tdmf_derivatives(SYSTEM_OF(&s), &mode, motion.state, derivatives);
        assert_true(isnan(derivatives[TDMF_LEG_ANGLE_RATE]) && isnan(derivatives[TDMF_LEG_LENGTH_RATE]));
        assert_true(isnan(outputs_of(SYSTEM_OF(&s), &motion).hip.torque));
    }
}

TEST(outputs_of_states_without_sense_have_no_word_and_no_count_below_zero) {
    static const double senseless[] = {INFINITY, -INFINITY, NAN};
    for (size_t i = 0; i < COUNT_OF(senseless); ++i) {
        simulation s = standing_at_apex();
        s.motion.state[TDMF_STRIDE_WORD_SO_FAR] = s.motion.state[TDMF_STRIDE_WORD] = senseless[i];
        s.motion.state[TDMF_STRIDE_COUNT] = s.motion.state[TDMF_EVENT_COUNT] = senseless[i];
        const tdmf_outputs outputs = outputs_of(SYSTEM_OF(&s), &s.motion);
        assert_true(strlen(outputs.open_word) <= 1 && strlen(outputs.stride.word) <= 1);
        assert_true(outputs.stride.count >= 0 && outputs.event.count >= 0);
    }
}

/* ---- counts and pointers ------------------------------------------------------------------------------ */

TEST(solvers_refuse_null) {
    solver_call *const solvers[] = {tdmf_native_advance, tdmf_cvode_advance};
    const simulation s = standing_at_apex();
    tdmf_solver solver = s.solver;
    tdmf_motion motion = s.motion;
    for (int i = 0; i < 2 * 4; ++i) {
        const tdmf_system system = {i / 2 == 1 ? NULL : &s.model, i / 2 == 2 ? NULL : &s.inputs};
        assert_int_equal(
            solvers[i % 2](i / 2 == 0 ? NULL : &solver, system, NULL, 1.0, i / 2 == 3 ? NULL : &motion),
            TDMF_REFUSED);
    }
    assert_int_equal(tdmf_native_stride(&solver, SYSTEM_OF(&s), 1.0, NULL).outcome, TDMF_REFUSED);
    assert_memory_equal(&motion, &s.motion, sizeof motion);
}

TEST(a_log_begins_at_none) {
    simulation s = standing_at_apex();
    double apex[TDMF_SECTION_COUNT];
    copy_apex(apex);
    tdmf_event_log log;
    memset(&log, 0, sizeof log);
    s.solver.log = &log;
    log.count = -5;
    assert_refused(stride, &s);
    assert_int_equal(reduced_map(&s.solver, SYSTEM_OF(&s), apex, long_enough, false, NULL, 0).outcome,
                     TDMF_RETURN_REFUSED);
    assert_int_equal(log.count, -5);
    log.count = INT_MAX;
    assert_int_equal(stride(&s), TDMF_ARRIVED);
    assert_int_equal(log.count, INT_MAX);
}

/* Asserts that every map and search refuses a request that makes no sense. */
static void assert_maps_refuse(tdmf_solver *solver, tdmf_system system, double *section, int seed_count) {
    assert_int_equal(return_map(solver, system, section, long_enough, true, NULL, seed_count).outcome,
                     TDMF_RETURN_REFUSED);
    assert_int_equal(reduced_map(solver, system, section, long_enough, true, NULL, seed_count).outcome,
                     TDMF_RETURN_REFUSED);
    assert_int_equal(find_orbit(TDMF_RETURN_MAP, solver, system, section, NULL, seed_count).outcome,
                     TDMF_ORBIT_NO_START);
    assert_int_equal(find_orbit(TDMF_REDUCED_MAP, solver, system, section, NULL, seed_count).outcome,
                     TDMF_ORBIT_NO_START);
}

TEST(maps_refuse_null) {
    simulation s = standing_at_apex();
    double apex[TDMF_SECTION_COUNT];
    copy_apex(apex);
    const int counts[] = {1, INT_MAX, -1};
    for (int i = 0; i < 3; ++i) {
        assert_maps_refuse(&s.solver, SYSTEM_OF(&s), apex, counts[i]);
    }
    for (int missing = 0; missing < 4; ++missing) {
        tdmf_solver *solver = missing == 0 ? NULL : &s.solver;
        const tdmf_system system = {missing == 1 ? NULL : &s.model, missing == 2 ? NULL : &s.inputs};
        double *section = missing == 3 ? NULL : apex;
        assert_maps_refuse(solver, system, section, 0);
        assert_int_equal(settle(TDMF_RETURN_MAP, solver, system, 3, section), 0);
        assert_int_equal(settle(TDMF_REDUCED_MAP, solver, system, 3, section), 0);
    }
    assert_int_equal(settle(TDMF_RETURN_MAP, &s.solver, SYSTEM_OF(&s), -3, apex), 0);
    assert_int_equal(settle(TDMF_REDUCED_MAP, &s.solver, SYSTEM_OF(&s), -3, apex), 0);
    assert_int_equal(s.solver.steps, 0);
}

TEST(refusals_name_what_is_null) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    simulation s = standing_at_apex();
    char text[64];
    assert_string_equal(tdmf_model_create(NULL, &parameters).variable, "model");
    assert_string_equal(tdmf_model_create(&s.model, NULL).variable, "parameters");
    const tdmf_refusal refusal = tdmf_check_inputs(NULL);
    assert_refusal_text(refusal, "inputs is refused: it is NULL");
    assert_null(tdmf_refusal_text(&refusal, NULL, sizeof text));
    assert_string_equal(tdmf_start((tdmf_system){NULL, &s.inputs}, &s.motion).variable, "model");
    assert_string_equal(tdmf_start((tdmf_system){&s.model, NULL}, &s.motion).variable, "inputs");
    assert_string_equal(tdmf_start(SYSTEM_OF(&s), NULL).variable, "motion");
    assert_int_equal(tdmf_setting_of(NULL), -1);
}

enum { RUNNERS = 3, STRIDES = 2 };

TEST(refusals_say_what_and_where) {
    simulation s = standing_at_apex();
    double apex[TDMF_SECTION_COUNT];
    copy_apex(apex);
    tdmf_seed seed = {.parameters = {.gravity = 0.0}};
    tdmf_stride_request request = {.solver = &s.solver, .system = SYSTEM_OF(&s), .apex = apex};
    tdmf_return made;
    tdmf_native_advance(&s.solver, SYSTEM_OF(&s), NULL, s.motion.time - 1.0, &s.motion);
    assert_refusal_text(s.solver.refusal, "until = -1 s is refused: allowed from 0 to inf s");
    s.motion.state[TDMF_LEG_ANGLE] = INFINITY;
    tdmf_native_advance(&s.solver, SYSTEM_OF(&s), NULL, 1.0, &s.motion);
    assert_string_equal(s.solver.refusal.variable, "motion.state[]");
    assert_int_equal(s.solver.refusal.index, TDMF_LEG_ANGLE);
    request.seeds = &seed;
    request.seed_count = 3;
    tdmf_run_stride(&request, &made);
    assert_refusal_text(made.refusal, "seed_count = 3 is refused: allowed from 0 to 2");
    request.seed_count = 0;
    request.map = TDMF_REDUCED_MAP;
    request.foot_x = apex;
    tdmf_run_stride(&request, &made);
    assert_int_equal(made.refusal.code, TDMF_EXCLUDED);
    assert_refusal_text(made.refusal, "foot_x is refused: the reduced map has no place of the foot");
    apex[TDMF_SECTION_COM_HEIGHT] = -3.0;
    request.map = TDMF_RETURN_MAP;
    request.foot_x = NULL;
    tdmf_run_stride(&request, &made);
    assert_int_equal(made.outcome, TDMF_RETURN_NO_START);
    assert_string_equal(made.refusal.variable, "foot.y");
    s.solver.relative_tolerance = 1.0;
    tdmf_run_stride(&request, &made);
    assert_refusal_text(made.refusal,
                        "solver.relative_tolerance = 1 is refused: allowed from 0 to 1 (both excluded)");

    crowd *crowd = make_crowd(RUNNERS, STRIDES, 1e-9);
    crowd->case_of[1] = -7;
    assert_refusal_text(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL),
                        "case_of[1] = -7 is refused: allowed from 0 to 2");
    crowd->case_of[1] = 1;
    crowd->ensemble.instructions = TDMF_INSTRUCTIONS_COUNT;
    assert_refusal_text(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL),
                        "instructions: this processor or this build does not have them");
    crowd->ensemble.instructions = TDMF_BEST_INSTRUCTIONS;
    crowd->cases[2].rules.roughness = -0.5;
    assert_refusal_text(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL),
                        "cases[2].rules.roughness = -0.5 is refused: allowed from 0 to 1.79769313e+308");
}

static void pages_take_all_seeds(void) {
    enum { SEEDS = 8, ROOM = 100 };
    const tdmf_page *page = tdmf_page_named("reduced_runner");
    double p[ROOM], x[ROOM], end[ROOM], varied[ROOM * (SEEDS + 2)], along[ROOM * SEEDS] = {0.0};
    const double point[] = {1.4, 1.05};
    tdmf_page_defaults(page, p, x);
    const tdmf_page_map map = {page, 0, p, x, 1e-12, 1e6, SEEDS, along, NULL, 0, 0, NULL, false};
    assert_null(tdmf_page_name(page, TDMF_PAGE_STATE, ROOM));
    assert_int_equal(tdmf_page_stride(&map, point, end, varied).outcome, TDMF_PAGE_CROSSED);
}

TEST(pages_refuse_null_and_numbers_out_of_range) {
    enum { SIZE = 64 };
    double p[SIZE], x[SIZE], end[SIZE], point[] = {1.03, 6000.0};
    const tdmf_page *page = tdmf_page_named("classic_slip");
    assert_non_null(page);
    assert_null(tdmf_page_named(NULL));
    assert_null(tdmf_page_named("no such page"));
    assert_string_equal(tdmf_page_name(tdmf_page_named("reduced_runner"), TDMF_PAGE_SECTION, 0), "at_apex");
    assert_null(tdmf_page_name(NULL, TDMF_PAGE_STATE, 0));
    assert_null(tdmf_page_name(page, TDMF_PAGE_STATE, -1));
    assert_null(tdmf_page_name(page, TDMF_PAGE_STATE, SIZE));
    assert_null(tdmf_page_name(page, (tdmf_page_item)-1, 0));
    tdmf_page_defaults(NULL, p, x);
    tdmf_page_defaults(page, NULL, NULL);
    tdmf_page_range(NULL, 0, p, x);
    tdmf_page_range(page, -1, p, x);
    tdmf_page_range(page, 0, NULL, NULL);
    tdmf_page_defaults(page, p, x);
    const tdmf_page_map sound = {page, 1, p, x, 1e-14, 1e6, 0, NULL, NULL, 0, 0, NULL, false};
    assert_string_equal(tdmf_page_name(page, TDMF_PAGE_SECTION, sound.section), "at_apex");
    assert_string_equal(tdmf_page_name(page, TDMF_PAGE_PARAMETER, 0), "mass");
    assert_int_equal(tdmf_page_stride(&sound, point, end, NULL).outcome, TDMF_PAGE_CROSSED);
    assert_int_equal(tdmf_page_stride(NULL, point, end, NULL).outcome, TDMF_PAGE_REFUSED);
    pages_take_all_seeds();
    assert_int_equal(tdmf_page_stride(&sound, NULL, end, NULL).outcome, TDMF_PAGE_REFUSED);
    assert_int_equal(tdmf_page_stride(&sound, point, NULL, NULL).outcome, TDMF_PAGE_REFUSED);
    assert_false(tdmf_page_fixed_point(NULL, point));
    assert_false(tdmf_page_fixed_point(&sound, NULL));
    tdmf_page_map refused[] = {sound, sound, sound, sound, sound, sound, sound,
                               sound, sound, sound, sound, sound, sound, sound};
    refused[0].page = NULL;
    refused[1].section = 2;
    refused[2].section = -1;
    refused[3].parameters = NULL;
    refused[4].states = NULL;
    refused[5].tolerance = NAN;
    refused[6].tolerance = 0.0;
    refused[7].longest = INFINITY;
    refused[8].longest = -1.0;
    refused[9].seed_count = 1;
    refused[10].seed_count = -1;
    refused[11].seed_count = SIZE;
    refused[12].step_limit = -1;
    refused[13].event_room = -1;
    static const char *const names[] = {
        "page",    "section", "section",      "parameters", "states",     "tolerance",  "tolerance",
        "longest", "longest", "d_parameters", "seed_count", "seed_count", "step_limit", "event_room"};
    assert_null(tdmf_page_check(&sound, point).variable);
    for (size_t i = 0; i < COUNT_OF(refused); ++i) {
        assert_string_equal(tdmf_page_check(&refused[i], point).variable, names[i]);
        assert_int_equal(tdmf_page_stride(&refused[i], point, end, NULL).outcome, TDMF_PAGE_REFUSED);
        assert_false(tdmf_page_fixed_point(&refused[i], point));
        assert_false(tdmf_page_place(&refused[i], point, end));
        assert_int_equal(tdmf_page_begin(&refused[i], end, NULL, NULL).outcome, TDMF_PAGE_REFUSED);
    }
    assert_false(tdmf_page_place(&sound, point, NULL));
    assert_int_equal(tdmf_page_begin(&sound, NULL, NULL, NULL).outcome, TDMF_PAGE_REFUSED);
    const tdmf_page_samples nothing = {.count = 1};
    assert_int_equal(tdmf_page_begin(&sound, end, &nothing, NULL).outcome, TDMF_PAGE_REFUSED);
    static const double no_times[][2] = {{NAN, 1.0}, {0.0, NAN}, {0.0, INFINITY}, {-1.0, 0.0}, {1.0, 0.5}};
    for (size_t i = 0; i < COUNT_OF(no_times); ++i) {
        double rows[2 * SIZE], outputs[2 * SIZE];
        int modes[2], sampled = 2;
        const tdmf_page_samples samples = {
            .count = 2, .times = no_times[i], .states = rows, .outputs = outputs, .modes = modes};
        assert_int_equal(tdmf_page_begin(&sound, end, &samples, &sampled).outcome, TDMF_PAGE_REFUSED);
        assert_int_equal(sampled, 0);
    }
    tdmf_page_scales(NULL, p, x);
    tdmf_page_scales(page, NULL, x);
    const double numbers[] = {NAN, INFINITY, -1.0};
    for (size_t i = 0; i < COUNT_OF(numbers); ++i) {
        tdmf_page_defaults(page, p, x);
        p[0] = numbers[i];
        assert_int_equal(tdmf_page_stride(&sound, point, end, NULL).outcome, TDMF_PAGE_REFUSED);
        assert_string_equal(tdmf_page_check(&sound, point).variable, "mass");
    }
    tdmf_page_defaults(page, p, x);
    point[0] = NAN;
    assert_int_equal(tdmf_page_stride(&sound, point, end, NULL).outcome, TDMF_PAGE_REFUSED);
    assert_string_equal(tdmf_page_check(&sound, point).variable, "point[]");
    point[0] = 1.03;
    x[0] = NAN;
    assert_int_equal(tdmf_page_stride(&sound, point, end, NULL).outcome, TDMF_PAGE_REFUSED);
}

/* ---- the ensemble ------------------------------------------------------------------------------------- */

/* A crowd that follows a law, or is given settings. */
typedef struct {
    crowd *crowd;
    tdmf_ensemble *ensemble;
    tdmf_ensemble_rules *rules;
    tdmf_ensemble_checkpoint checkpoints[RUNNERS];
    tdmf_ensemble_stride strides[RUNNERS];
    int setting;
    double one[1], gain[1][TDMF_POINT_LIMIT];
    tdmf_affine_law law;
    tdmf_given_settings given;
} population;

static void gather(population *p, bool follows_law) {
    memset(p, 0, sizeof *p);
    p->crowd = make_crowd(RUNNERS, STRIDES, 1e-9);
    p->ensemble = &p->crowd->ensemble;
    p->rules = &p->crowd->cases[0].rules;
    p->setting = tdmf_setting_of("ground.friction");
    p->one[0] = 0.6;
    p->law = (tdmf_affine_law){.count = 1,
                               .settings = &p->setting,
                               .nominal = p->one,
                               .gain = (const double(*)[TDMF_POINT_LIMIT])p->gain,
                               .low = p->one,
                               .high = p->one};
    p->given = (tdmf_given_settings){1, &p->setting, 0, 1, NULL};
    p->ensemble->case_of = NULL;
    p->ensemble->case_count = 1;
    p->ensemble->strides = p->strides;
    p->ensemble->stride_count = 1;
    p->ensemble->checkpoints = p->checkpoints;
    p->rules->law = follows_law ? &p->law : NULL;
}

/* A change that makes a request senseless. */
#define CHANGE(name, ...)                                                                                    \
    static void name(population *p) {                                                                        \
        __VA_ARGS__;                                                                                         \
    }
static const double apex_of_none[1][TDMF_POINT_LIMIT];
static const tdmf_ball ball_of_none = {{{0.0}, {0.0, NAN}}};
CHANGE(no_cases, p->ensemble->cases = NULL)
CHANGE(cases_below_zero, p->ensemble->case_count = -1)
CHANGE(no_model, p->crowd->cases[0].model = NULL)
CHANGE(no_starts, p->ensemble->starts = NULL)
CHANGE(runners_below_zero, p->ensemble->count = -1)
CHANGE(gaits_without_array, p->rules->gait_count = INT_MAX)
CHANGE(gaits_below_zero, p->rules->gait_count = -1)
CHANGE(balls_without_numbers, p->rules->gaits = apex_of_none; p->rules->gait_count = 1;
       p->rules->balls = &ball_of_none)
CHANGE(notes_below_zero, p->ensemble->stride_count = -1)
CHANGE(notes_from_below_zero, p->ensemble->first_stride = -1)
CHANGE(goes_on_from_nowhere, p->ensemble->goes_on = true; p->ensemble->checkpoints = NULL)
CHANGE(goes_on_as_another_model, p->ensemble->goes_on = true; p->checkpoints[RUNNERS - 1].stands = true)
CHANGE(given_no_values, p->ensemble->given = &p->given)
CHANGE(given_no_settings, p->given.settings = NULL; p->given.values = p->one; p->ensemble->given = &p->given)
CHANGE(law_without_settings, p->law.settings = NULL)
CHANGE(law_of_too_many, p->law.count = INT_MAX)
CHANGE(law_without_nominal, p->law.nominal = NULL)
CHANGE(law_without_gain, p->law.gain = NULL)
CHANGE(law_without_low, p->law.low = NULL)
CHANGE(law_without_high, p->law.high = NULL)

TEST(ensembles_refuse_counts_without_arrays) {
    static const struct {
        void (*change)(population *);
        const char *refused;
    } changes[] = {{no_cases, "cases"},
                   {cases_below_zero, "case_count"},
                   {no_model, "cases[].model"},
                   {no_starts, "starts"},
                   {runners_below_zero, "count"},
                   {gaits_without_array, "cases[].rules.gaits"},
                   {gaits_below_zero, "cases[].rules.gait_count"},
                   {balls_without_numbers, "cases[].rules.balls.matrix"},
                   {notes_below_zero, "stride_count"},
                   {notes_from_below_zero, "first_stride"},
                   {goes_on_from_nowhere, "checkpoints"},
                   {goes_on_as_another_model, "checkpoints[]"},
                   {given_no_values, "given.values"},
                   {given_no_settings, "given.settings"},
                   {law_without_settings, "cases[].rules.law.settings"},
                   {law_of_too_many, "cases[].rules.law.count"},
                   {law_without_nominal, "cases[].rules.law.nominal"},
                   {law_without_gain, "cases[].rules.law.gain"},
                   {law_without_low, "cases[].rules.law.low"},
                   {law_without_high, "cases[].rules.law.high"}};
    enum { CHANGES = COUNT_OF(changes), OF_LAWS = 6 };
    population population;
    for (int i = 0; i < CHANGES; ++i) {
        gather(&population, i >= CHANGES - OF_LAWS);
        changes[i].change(&population);
        population.crowd->ends[0].strides = 77;
        assert_string_equal(tdmf_run_ensemble(population.ensemble, population.crowd->ends, NULL).variable,
                            changes[i].refused);
        assert_int_equal(population.crowd->ends[0].strides, 77);
    }
    gather(&population, true);
    assert_non_null(tdmf_run_ensemble(NULL, population.crowd->ends, NULL).variable);
    assert_non_null(tdmf_run_ensemble(population.ensemble, NULL, NULL).variable);
    assert_null(tdmf_run_ensemble(population.ensemble, population.crowd->ends, NULL).variable);
    assert_int_equal(population.crowd->ends[RUNNERS - 1].strides, STRIDES);
}

/* INT_MAX threads could not be started, nor their memory be computed. */
TEST(threads_are_no_more_than_runners) {
    tdmf_ensemble_work work;
    crowd *crowd = make_crowd(RUNNERS, STRIDES, 1e-9);
    crowd->ensemble.threads = INT_MAX;
    assert_null(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL).variable);
    crowd->ensemble.count = 0;
    assert_null(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL).variable);
    const tdmf_ensemble nobody = {.relative_tolerance = 1e-9, .threads = 1};
    assert_null(tdmf_run_ensemble(&nobody, NULL, &work).variable);
    assert_int_equal(work.strides, 0);
}

/* ---- buffers that are the same ------------------------------------------------------------------------ */

TEST(in_place_gives_the_same) {
    const simulation s = standing_at_apex();
    double apex[TDMF_SECTION_COUNT];
    copy_apex(apex);
    double apart[TDMF_STATE_COUNT], in_place[TDMF_STATE_COUNT];
    tdmf_section_state(SYSTEM_OF(&s), apex, apart);
    for (int at = 0; at + TDMF_SECTION_COUNT <= TDMF_STATE_COUNT; ++at) {
        memset(in_place, 0, sizeof in_place);
        memcpy(in_place + at, apex, sizeof apex);
        tdmf_section_state(SYSTEM_OF(&s), in_place + at, in_place);
        assert_memory_equal(in_place, apart, sizeof apart);
    }
    tdmf_reduced_state(SYSTEM_OF(&s), apex, apart);
    for (int at = 0; at + TDMF_REDUCED_COUNT <= TDMF_STATE_COUNT; ++at) {
        memset(in_place, 0, sizeof in_place);
        memcpy(in_place + at, apex, TDMF_REDUCED_COUNT * sizeof *in_place);
        tdmf_reduced_state(SYSTEM_OF(&s), in_place + at, in_place);
        assert_memory_equal(in_place, apart, sizeof apart);
    }
    random_source source = {4};
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        const runner anybody = scene_random(&source, (tdmf_contact_mode)contact);
        memcpy(in_place, anybody.motion.state, sizeof in_place);
        tdmf_derivatives(SYSTEM_OF(&anybody), &anybody.motion.mode, anybody.motion.state, apart);
        tdmf_derivatives(SYSTEM_OF(&anybody), &anybody.motion.mode, in_place, in_place);
        assert_memory_equal(in_place, apart, sizeof apart);
    }
}
