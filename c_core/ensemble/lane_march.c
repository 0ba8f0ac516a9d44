/* Steps runners side by side. This file is compiled once for each instruction set, with TDMF_LANE_MARCH the
 * name of its one function and TDMF_LANES the number of lanes.
 *
 * A runner stays in a lane of the crew for its kind of motion until an event takes it elsewhere: so all lanes
 * of a step follow one formula without switches, each with a step size of its own, and whoever waits takes
 * the place of whoever leaves. What is discrete is left to the automaton, one runner at a time. */
#include "lane_march.h"

#include "lane_step.h"

#include <stdlib.h>
#include <string.h>

/* Runners under way at once: enough that a full crew is waiting somewhere, few enough for the cache. */
enum { CREWMATES = 5 * LANES, RUNNERS = CREW_COUNT * CREWMATES };

enum { NOBODY = -1 };

typedef union {
    flying_member flying;
    standing_member standing;
    real fields[MEMBER_FIELDS];
} crew_members;

typedef struct {
    crew_members members;
    choice live;
    int aboard[LANES]; /* or NOBODY */
    int count;
    int waiting[RUNNERS];
    int waiting_count;
} crew;

typedef struct {
    crew crews[CREW_COUNT];
    union {
        flight_series flight;
        ground_series ground;
    } series;
    tdmf_runner runners[RUNNERS];
    const tdmf_ensemble *ensemble;
    tdmf_starts *starts;
    tdmf_ensemble_end *ends;
    tdmf_ensemble_work work;
    int order;
    double tolerance;
} march;

static void wait_in(march *march, int index) {
    crew *crew = &march->crews[tdmf_runner_crew(&march->runners[index])];
    crew->waiting[crew->waiting_count++] = index;
}

/* Puts the next start that runs in a runner's place. */
static void begin_another(march *march, int index) {
    const tdmf_ensemble *ensemble = march->ensemble;
    for (int64_t next = tdmf_next_start(march->starts); next >= 0; next = tdmf_next_start(march->starts)) {
        const int number = ensemble->case_of ? ensemble->case_of[next] : 0;
        if (tdmf_runner_begin(&march->runners[index], &ensemble->cases[number], ensemble->starts[next],
                              &march->ends[next])) {
            wait_in(march, index);
            return;
        }
    }
}

static void write_lane(crew_members *members, int lane, const double *fields, int count) {
    for (int field = 0; field < count; ++field) {
        members->fields[field][lane] = fields[field];
    }
}

static void read_lane(const crew_members *members, int lane, double *fields, int count) {
    for (int field = 0; field < count; ++field) {
        fields[field] = members->fields[field][lane];
    }
}

/* Fills empty lanes. One that stays empty doubles another, so that no lane computes with nothing. */
static void man(march *march, crew *crew) {
    double fields[MEMBER_FIELDS];
    for (int lane = 0; lane < LANES; ++lane) {
        if (crew->aboard[lane] == NOBODY && crew->waiting_count > 0) {
            crew->aboard[lane] = crew->waiting[--crew->waiting_count];
            const int count = tdmf_runner_board(&march->runners[crew->aboard[lane]], fields);
            write_lane(&crew->members, lane, fields, count);
            crew->live[lane] = -1;
            ++crew->count;
        }
    }
    if (crew->count == LANES) {
        return;
    }
    int somebody = 0;
    while (crew->aboard[somebody] == NOBODY) {
        ++somebody;
    }
    read_lane(&crew->members, somebody, fields, MEMBER_FIELDS);
    for (int lane = 0; lane < LANES; ++lane) {
        if (crew->aboard[lane] == NOBODY) {
            write_lane(&crew->members, lane, fields, MEMBER_FIELDS);
        }
    }
}

static lane_outcome step_crew(march *march, crew_kind kind) {
    crew *crew = &march->crews[kind];
    const int order = march->order;
    const double tolerance = march->tolerance;
    const ground_case sticks = {.turns = true}, sticks_and_coasts = {.turns = false};
    const ground_case slips = {.slips = true, .turns = true}, slips_and_coasts = {.slips = true};
    const ground_case grazes = {.grazes = true, .turns = true};
    flight_series *flight = &march->series.flight;
    ground_series *ground = &march->series.ground;
    switch (kind) {
    case CREW_PLACE:
        return step_flying(&crew->members.flying, crew->live, false, order, tolerance, flight);
    case CREW_RETRACT:
        return step_flying(&crew->members.flying, crew->live, true, order, tolerance, flight);
    case CREW_STICK:
        return step_standing(&crew->members.standing, crew->live, sticks, order, tolerance, ground);
    case CREW_STICK_AND_COAST:
        return step_standing(&crew->members.standing, crew->live, sticks_and_coasts, order, tolerance,
                             ground);
    case CREW_SLIP:
        return step_standing(&crew->members.standing, crew->live, slips, order, tolerance, ground);
    case CREW_SLIP_AND_COAST:
        return step_standing(&crew->members.standing, crew->live, slips_and_coasts, order, tolerance, ground);
    default:
        return step_standing(&crew->members.standing, crew->live, grazes, order, tolerance, ground);
    }
}

static void leave_lane(march *march, crew *crew, int lane, bool at_event, bool late) {
    double fields[CHANGING_FIELDS];
    const int index = crew->aboard[lane];
    tdmf_runner *runner = &march->runners[index];
    bool goes_on = false;
    if (at_event) {
        const int strides = runner->end->strides;
        read_lane(&crew->members, lane, fields, CHANGING_FIELDS);
        goes_on = tdmf_runner_take_event(runner, fields);
        march->work.strides += runner->end->strides - strides;
        ++march->work.events;
    } else {
        tdmf_runner_give_up(runner, late ? TDMF_FATE_UNDECIDED : TDMF_FATE_UNSOLVED);
    }
    crew->aboard[lane] = NOBODY;
    crew->live[lane] = 0;
    --crew->count;
    if (goes_on) {
        wait_in(march, index);
    } else {
        begin_another(march, index);
    }
}

static void step_and_sort(march *march, crew_kind kind) {
    crew *crew = &march->crews[kind];
    man(march, crew);
    march->work.steps += crew->count;
    march->work.places += LANES;
    const lane_outcome outcome = step_crew(march, kind);
    const unsigned events = lanes_of(outcome.at_event);
    const unsigned late = lanes_of(outcome.late);
    const unsigned leaving = events | late | lanes_of(outcome.stuck);
    for (int lane = 0; leaving >> lane != 0; ++lane) {
        if (leaving >> lane & 1) {
            leave_lane(march, crew, lane, events >> lane & 1, late >> lane & 1);
        }
    }
}

/* The crew that the next step serves most runners of. */
static crew_kind fullest(const march *march) {
    crew_kind best = CREW_PLACE;
    int most = -1;
    for (int kind = 0; kind < CREW_COUNT; ++kind) {
        const crew *crew = &march->crews[kind];
        if (crew->count + crew->waiting_count > most) {
            most = crew->count + crew->waiting_count;
            best = (crew_kind)kind;
        }
    }
    return best;
}

static void open_crews(march *march) {
    for (int kind = 0; kind < CREW_COUNT; ++kind) {
        for (int lane = 0; lane < LANES; ++lane) {
            march->crews[kind].aboard[lane] = NOBODY;
        }
    }
}

static void run(march *march) {
    open_crews(march);
    for (int index = 0; index < RUNNERS; ++index) {
        begin_another(march, index);
    }
    for (;;) {
        const crew_kind kind = fullest(march);
        if (march->crews[kind].count + march->crews[kind].waiting_count == 0) {
            return;
        }
        step_and_sort(march, kind);
    }
}

bool TDMF_LANE_MARCH(const tdmf_ensemble *ensemble, tdmf_starts *starts, int order, tdmf_ensemble_end *ends,
                     tdmf_ensemble_work *work) {
    /* C99 has no aligned allocation. */
    const uintptr_t alignment = sizeof(real);
    void *block = calloc(1, sizeof(march) + alignment);
    if (block == NULL) {
        return false;
    }
    march *march = (void *)(((uintptr_t)block + alignment - 1) / alignment * alignment);
    march->ensemble = ensemble;
    march->starts = starts;
    march->ends = ends;
    march->order = order;
    march->tolerance = ensemble->relative_tolerance;
    run(march);
    march->work.evaluations = march->work.steps * order;
    *work = march->work;
    free(block);
    return true;
}
