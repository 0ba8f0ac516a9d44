/* Runs of a page in an ensemble are iterates of its return map, bit for bit, also under a law. */
#include "compare.h"
#include "crowd.h"

#include <limits.h>
#include <math.h>
#include <string.h>

enum { RUNNERS = 11, STRIDES = 6, PARAMETERS = 32, STATES = 64, NOTED = 2, EVENTS = 4 };

/* The classic SLIP: a point of its section is a height and an energy. */
typedef struct {
    const tdmf_page *page;
    int section, angle; /* numbers of the section and of the touchdown angle */
    double parameters[PARAMETERS], states[STATES];
    double starts[RUNNERS][TDMF_POINT_LIMIT];
    tdmf_ensemble_end ends[RUNNERS];
    tdmf_ensemble_stride strides[RUNNERS][STRIDES];
    tdmf_ensemble_checkpoint checkpoints[RUNNERS];
    int noted[NOTED]; /* the coordinates */
    double values[RUNNERS][STRIDES][NOTED];
    unsigned char events[RUNNERS][STRIDES][EVENTS];
    tdmf_ensemble_notes notes;
    double nominal, low, high, gain[1][TDMF_POINT_LIMIT], gaits[1][TDMF_POINT_LIMIT];
    tdmf_affine_law law;
    tdmf_ensemble_case scenario;
    tdmf_ensemble ensemble;
} hoppers;

static int number_of(const tdmf_page *page, tdmf_page_item kind, const char *name) {
    int number = 0;
    while (strcmp(tdmf_page_name(page, kind, number), name) != 0) {
        ++number;
    }
    return number;
}

/* Some of the heights are those of runners that fall or do not start. No runner settles on the gait, but each
 * apex is compared with it. */
static void prepare(hoppers *h) {
    memset(h, 0, sizeof *h);
    h->page = tdmf_page_named("classic_slip");
    h->section = number_of(h->page, TDMF_PAGE_SECTION, "at_apex");
    h->angle = number_of(h->page, TDMF_PAGE_PARAMETER, "touchdown_angle");
    tdmf_page_defaults(h->page, h->parameters, h->states);
    h->parameters[h->angle] = 0.78;
    h->parameters[number_of(h->page, TDMF_PAGE_PARAMETER, "friction")] = 1e9;
    for (int i = 0; i < RUNNERS; ++i) {
        h->starts[i][0] = 0.6 + 0.14 * i;
        h->starts[i][1] = 6000.0;
    }
    h->noted[0] = number_of(h->page, TDMF_PAGE_STATE, "apex_height");
    h->noted[1] = number_of(h->page, TDMF_PAGE_STATE, "apex_energy");
    h->notes = (tdmf_ensemble_notes){NOTED, h->noted, &h->values[0][0][0], EVENTS, &h->events[0][0][0]};
    h->nominal = 0.78;
    h->low = 0.7;
    h->high = 0.9;
    h->gain[0][0] = 0.02;
    h->law = (tdmf_affine_law){.count = 1,
                               .settings = &h->angle,
                               .apex = {1.7, 6000.0},
                               .nominal = &h->nominal,
                               .gain = (const double(*)[TDMF_POINT_LIMIT])h->gain,
                               .low = &h->low,
                               .high = &h->high,
                               .noise = {0.01},
                               .seed = 3};
    h->scenario = (tdmf_ensemble_case){.parameters = h->parameters,
                                       .states = h->states,
                                       .rules = {.gaits = (const double(*)[TDMF_POINT_LIMIT])h->gaits,
                                                 .gait_count = 1,
                                                 .max_strides = STRIDES,
                                                 .law = &h->law}};
    h->ensemble = (tdmf_ensemble){.page = h->page,
                                  .section = h->section,
                                  .notes = &h->notes,
                                  .cases = &h->scenario,
                                  .case_count = 1,
                                  .starts = (const double(*)[TDMF_POINT_LIMIT])h->starts,
                                  .count = RUNNERS,
                                  .relative_tolerance = 1e-11,
                                  .threads = 2,
                                  .strides = &h->strides[0][0],
                                  .stride_count = STRIDES,
                                  .checkpoints = h->checkpoints};
}

static void run(hoppers *h) {
    assert_int_equal(tdmf_run_ensemble(&h->ensemble, h->ends, NULL).code, TDMF_ACCEPTED);
}

/* Iterates the return map. Returns how many strides close. */
static int iterate(hoppers *h, int runner, tdmf_page_outcome *last) {
    double point[TDMF_POINT_LIMIT], states[STATES], parameters[PARAMETERS];
    tdmf_page_event rows[EVENTS];
    memcpy(point, h->starts[runner], sizeof point);
    for (int stride = 0; stride < STRIDES; ++stride) {
        memcpy(parameters, h->parameters, sizeof parameters);
        if (h->scenario.rules.law) {
            tdmf_affine_settings(&h->law, point, (uint64_t)runner, (uint32_t)stride, &parameters[h->angle]);
            assert_true(h->strides[runner][stride].set[0] == parameters[h->angle]);
        }
        const tdmf_page_map map = {.page = h->page,
                                   .section = h->section,
                                   .parameters = parameters,
                                   .states = h->states,
                                   .tolerance = h->ensemble.relative_tolerance,
                                   .longest = 1e4,
                                   .event_room = EVENTS,
                                   .events = rows};
        const tdmf_page_end end = tdmf_page_stride(&map, point, states, NULL);
        *last = end.outcome;
        if (end.outcome != TDMF_PAGE_CROSSED) {
            return stride;
        }
        for (int i = 0; i < NOTED; ++i) {
            point[i] = states[h->noted[i]];
            assert_true(h->values[runner][stride][i] == point[i]);
            assert_true(h->strides[runner][stride].apex[i] == point[i]);
        }
        assert_true(h->strides[runner][stride].stride.period == end.time);
        for (int i = 0; i < EVENTS && i < end.event_count; ++i) {
            assert_int_equal(h->events[runner][stride][i], rows[i].event + 1);
        }
    }
    return STRIDES;
}

static void assert_iterates(hoppers *h) {
    int closed = 0, fell = 0;
    for (int i = 0; i < RUNNERS; ++i) {
        tdmf_page_outcome last;
        const int strides = iterate(h, i, &last);
        assert_int_equal(h->ends[i].strides, strides);
        assert_int_equal(h->ends[i].fate == TDMF_FATE_FELL, last == TDMF_PAGE_ENDED);
        assert_int_equal(h->ends[i].fate == TDMF_FATE_UNDECIDED, last == TDMF_PAGE_CROSSED);
        closed += strides;
        fell += last == TDMF_PAGE_ENDED;
    }
    assert_true(closed > 2 * STRIDES && fell > 0 && fell < RUNNERS);
}

TEST(runs_of_a_page_are_iterates_of_its_return_map) {
    static hoppers h;
    for (int follows = 0; follows < 2; ++follows) {
        prepare(&h);
        h.scenario.rules.law = follows ? &h.law : NULL;
        run(&h);
        assert_iterates(&h);
    }
}

/* The pages of this library have no motions in lanes, which only the runner needs. */
TEST(instructions_without_lanes_of_the_page_are_refused) {
    static hoppers h;
    FOR_INSTRUCTIONS(set) {
        prepare(&h);
        h.ensemble.instructions = set;
        const tdmf_refusal refusal = tdmf_run_ensemble(&h.ensemble, h.ends, NULL);
        assert_int_equal(refusal.code == TDMF_ACCEPTED, set == TDMF_ONE_BY_ONE);
        assert_true(refusal.code == TDMF_ACCEPTED || strcmp(refusal.variable, "instructions") == 0);
    }
}

TEST(runs_of_a_page_take_any_step_limit) {
    static hoppers h;
    prepare(&h);
    h.ensemble.step_limit = LONG_MAX;
    run(&h);
    assert_iterates(&h);
}

/* Rows of points are wider than the section. */
TEST(numbers_behind_the_coordinates_have_no_effect) {
    static hoppers h;
    static tdmf_ensemble_end first[RUNNERS];
    for (int is_filled = 0; is_filled < 2; ++is_filled) {
        prepare(&h);
        for (int i = 0; is_filled && i < RUNNERS; ++i) {
            for (int k = NOTED; k < TDMF_POINT_LIMIT; ++k) {
                h.starts[i][k] = NAN;
            }
        }
        run(&h);
        if (!is_filled) {
            memcpy(first, h.ends, sizeof first);
        }
        assert_memory_equal(h.ends, first, sizeof first);
    }
}

TEST(runs_of_a_page_go_on_from_where_they_stand) {
    static hoppers h;
    prepare(&h);
    h.scenario.rules.max_strides = 2;
    run(&h);
    h.scenario.rules.max_strides = STRIDES;
    h.ensemble.goes_on = true;
    run(&h);
    assert_iterates(&h);
}

TEST(runs_settle_at_a_fixed_point_of_the_page) {
    static hoppers h;
    prepare(&h);
    double gait[1][TDMF_POINT_LIMIT] = {{h.starts[3][0], h.starts[3][1]}};
    h.scenario.rules.law = NULL;
    h.scenario.rules.gaits = (const double(*)[TDMF_POINT_LIMIT])gait;
    h.scenario.rules.gait_count = 1;
    h.scenario.rules.distance = 1e9;
    run(&h);
    for (int i = 0; i < RUNNERS; ++i) {
        assert_int_equal(h.ends[i].fate == TDMF_FATE_SETTLED, h.ends[i].strides == 1);
    }
}

TEST(checkpoints_of_another_model_or_section_are_refused) {
    static hoppers h;
    tdmf_ensemble_checkpoint *last = &h.checkpoints[0];
    int *const parts[] = {&last->parameter_count, &last->state_count, &last->mode_count,
                          &last->event_count,     &last->section,     &last->mode};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; ++i) {
        prepare(&h);
        memcpy(h.starts[0], h.starts[RUNNERS - 2], sizeof h.starts[0]); /* it does not fall */
        run(&h);
        assert_true(last->stands);
        h.ensemble.goes_on = true;
        run(&h);
        ++*parts[i];
        const tdmf_refusal refusal = tdmf_run_ensemble(&h.ensemble, h.ends, NULL);
        assert_int_equal(refusal.code, TDMF_EXCLUDED);
        assert_int_equal(refusal.index, 0);
    }
}

#define REFUSED(change)                                                                                      \
    do {                                                                                                     \
        prepare(&h);                                                                                         \
        change;                                                                                              \
        assert_true(tdmf_run_ensemble(&h.ensemble, h.ends, NULL).code != TDMF_ACCEPTED);                     \
    } while (0)

TEST(requests_that_a_page_cannot_meet_are_refused) {
    static hoppers h;
    const double foot[RUNNERS] = {0.0};
    int unknown = PARAMETERS + STATES;
    REFUSED(h.ensemble.section = -1);
    REFUSED(h.ensemble.count = INT64_MAX);
    REFUSED(h.ensemble.section = 99);
    REFUSED(h.ensemble.foot_x = foot);
    REFUSED(h.scenario.parameters = NULL);
    REFUSED(h.scenario.states = NULL);
    REFUSED(h.scenario.rules.roughness = 0.1);
    REFUSED(h.scenario.rules.friction_spread = 0.1);
    REFUSED(h.scenario.rules.terrain.length = 1.0);
    REFUSED(h.notes.states = NULL);
    REFUSED(h.notes.values = NULL);
    REFUSED(h.notes.events = NULL);
    REFUSED(h.noted[1] = -1);
    REFUSED(h.ensemble.strides = NULL);
    REFUSED(h.law.settings = &unknown);
    REFUSED(h.law.noise[2] = 0.1);
    REFUSED(h.high = NAN);
}

/* ---- strides on the plain page ------------------------------------------------------------------------- */

enum { SECTION = 6, SEEDS = 1, ROWS = SECTION + SEEDS, ALL_STATES = 128, MOST_EVENTS = 20 };

/* Strides of a page of the package near its gait. */
typedef struct {
    const tdmf_page *page;
    double parameters[PARAMETERS], states[ALL_STATES], along[PARAMETERS];
    double points[RUNNERS][SECTION];
    double made[RUNNERS][ALL_STATES], varied[RUNNERS][ROWS][ALL_STATES];
    tdmf_page_event events[RUNNERS][MOST_EVENTS];
    tdmf_page_end ends[RUNNERS];
    tdmf_page_map map;
} neighbours;

static void prepare_neighbours(neighbours *n, const char *page, double thrust) {
    static const double gait[SECTION] = {1.418508, 1.062005, 0.999999, -0.546253, 0.0, 0.0};
    const bool is_reduced = strcmp(page, "runner") != 0;
    memset(n, 0, sizeof *n);
    n->page = tdmf_page_named(page);
    tdmf_page_defaults(n->page, n->parameters, n->states);
    n->parameters[number_of(n->page, TDMF_PAGE_PARAMETER, "thrust")] = thrust;
    n->along[number_of(n->page, TDMF_PAGE_PARAMETER, "damping")] = 1.0;
    for (int i = 0; i < RUNNERS; ++i) {
        double *point = is_reduced ? &n->points[0][2 * i] : n->points[i];
        memcpy(point, gait, (is_reduced ? 2 : SECTION) * sizeof *point);
        point[0] -= 0.01 * i;
    }
    n->map = (tdmf_page_map){.page = n->page,
                             .parameters = n->parameters,
                             .states = n->states,
                             .tolerance = 1e-13,
                             .longest = 1e4,
                             .seed_count = SEEDS,
                             .d_parameters = n->along,
                             .event_room = MOST_EVENTS,
                             .events = n->events[0]};
}

static int count_of_states(const tdmf_page *page) {
    int count = 0;
    while (tdmf_page_name(page, TDMF_PAGE_STATE, count)) {
        ++count;
    }
    return count;
}

/* The states are written row by row, as many as the page has. */
static double *row_of(double *rows, int row, const tdmf_page *page) {
    return rows + row * count_of_states(page);
}

static void make_neighbours(neighbours *n) {
    const tdmf_page_batch batch = {.map = &n->map,
                                   .count = RUNNERS,
                                   .points = n->points[0],
                                   .states = n->made[0],
                                   .d_states = n->varied[0][0],
                                   .ends = n->ends,
                                   .threads = 2};
    assert_true(tdmf_page_strides(&batch));
}

/* A thrust too small for any result is not on the plain page. */
static void assert_plain_is_whole(const char *page, int coordinates) {
    static const char *const names[] = {"apex_com_height", "apex_com_speed",      "period",
                                        "work_of_stride",  "peak_vertical_force", "positive_work",
                                        "impact_loss",     "damper_loss",         "slip_distance"};
    static neighbours plain, whole;
    double alone[ALL_STATES], varied[ROWS * ALL_STATES];
    prepare_neighbours(&plain, page, 0.0);
    prepare_neighbours(&whole, page, 1e-200);
    make_neighbours(&plain);
    make_neighbours(&whole);
    const int states = count_of_states(plain.page), rows = coordinates + SEEDS;
    for (int i = 0; i < RUNNERS; ++i) {
        const double *made = row_of(plain.made[0], i, plain.page);
        const double *by = row_of(plain.varied[0][0], rows * i, plain.page);
        assert_int_equal(plain.ends[i].outcome, TDMF_PAGE_CROSSED);
        assert_int_equal(plain.ends[i].mode, whole.ends[i].mode);
        const tdmf_page_event *last = &plain.events[i][plain.ends[i].event_count - 1];
        const tdmf_page_event *of_whole = &whole.events[i][whole.ends[i].event_count - 1];
        assert_int_equal(last->event, number_of(plain.page, TDMF_PAGE_EVENT, "apex"));
        assert_int_equal(last->event, of_whole->event);
        assert_int_equal(last->after, of_whole->after);
        assert_close(last->time, of_whole->time, 1e-11);
        assert_true(whole.ends[i].event_count > plain.ends[i].event_count); /* the greatest compression */
        for (size_t k = 0; k < sizeof names / sizeof *names; ++k) {
            const int state = number_of(plain.page, TDMF_PAGE_STATE, names[k]);
            assert_close(made[state], row_of(whole.made[0], i, plain.page)[state], 1e-11);
            for (int row = 0; row < rows; ++row) {
                assert_close(by[row * states + state],
                             row_of(whole.varied[0][0], rows * i + row, plain.page)[state], 1e-7);
            }
        }
        const tdmf_page_end end =
            tdmf_page_stride(&plain.map, plain.points[0] + coordinates * i, alone, varied);
        assert_int_equal(end.steps, plain.ends[i].steps);
        assert_memory_equal(alone, made, (size_t)states * sizeof *alone);
        assert_memory_equal(varied, by, (size_t)(rows * states) * sizeof *varied);
    }
}

TEST(strides_on_the_plain_page_are_those_on_the_whole_page) {
    assert_plain_is_whole("runner", SECTION);
    assert_plain_is_whole("reduced_runner", TDMF_REDUCED_COUNT);
}
