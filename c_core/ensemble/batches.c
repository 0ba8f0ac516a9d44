/* Steps runners side by side. This file is compiled once for each instruction set, with TDMF_RUN_BATCHES the
 * name of its one function and TDMF_LANES the number of lanes.
 *
 * A runner stays in a lane of the batch for its kind of motion until an event takes it elsewhere: so all
 * lanes of a step follow one formula without switches, each with a step size of its own, and whoever waits
 * takes the place of whoever leaves. What is discrete is left to the automaton, one runner at a time. */
#include "batches.h"

#include "lane_step.h"

#include <stdlib.h>
#include <string.h>

/* Runners under way at once: enough that a full batch is waiting somewhere, few enough for the cache. Most
 * ensembles have the clamp in all runners or in none, so one of the common batches stays empty. */
enum { RUNNERS_OF_A_KIND = 5 * LANES, RUNNERS = (COMMON_BATCHES - 1) * RUNNERS_OF_A_KIND };

enum { EMPTY = -1 };

typedef union {
    flying_member flying;
    standing_member standing;
    real fields[MEMBER_FIELDS];
} batch_members;

/* What a runner that waits takes along into a lane. */
typedef struct {
    double fields[MEMBER_FIELDS];
    int count; /* 0 where its mode has yet to be opened */
} waiting_member;

typedef struct {
    batch_members members;
    mask live;
    int runner_in[LANES]; /* or EMPTY */
    int count;
    int fields; /* of a member; those of one kind of motion have the same */
    int waiting[RUNNERS];
    int waiting_count;
} batch;

typedef struct {
    batch batches[BATCH_COUNT];
    int rare_count; /* runners in batches that are not common */
    union {
        flight_series flight;
        ground_series ground;
    } series;
    tdmf_runner runners[RUNNERS];
    waiting_member members[RUNNERS];
    const tdmf_ensemble *ensemble;
    tdmf_starts *starts;
    tdmf_ensemble_end *ends;
    tdmf_ensemble_work work;
    series_orders orders;
    double tolerance;
    batch_members before; /* a step, where strides are noted */
} integration;

static void wait_in(integration *integration, int index) {
    const batch_kind kind = tdmf_runner_batch(&integration->runners[index]);
    batch *batch = &integration->batches[kind];
    batch->waiting[batch->waiting_count++] = index;
    integration->rare_count += kind >= COMMON_BATCHES;
}

/* Puts the next start that runs in a runner's place. */
static void begin_another(integration *integration, int index) {
    const tdmf_ensemble *ensemble = integration->ensemble;
    for (int64_t next = tdmf_next_start(integration->starts); next >= 0;
         next = tdmf_next_start(integration->starts)) {
        if (tdmf_runner_begin(&integration->runners[index], ensemble, next, &integration->ends[next])) {
            wait_in(integration, index);
            return;
        }
    }
}

static void write_lane(batch_members *members, int lane, const double *fields, int count) {
    for (int field = 0; field < count; ++field) {
        members->fields[field][lane] = fields[field];
    }
}

static void read_lane(const batch_members *members, int lane, double *fields, int count) {
    for (int field = 0; field < count; ++field) {
        fields[field] = members->fields[field][lane];
    }
}

static void enter_lane(integration *integration, batch *batch, int lane, int index) {
    waiting_member *member = &integration->members[index];
    if (member->count == 0) {
        member->count = tdmf_runner_load(&integration->runners[index], member->fields);
    }
    batch->fields = member->count;
    write_lane(&batch->members, lane, member->fields, member->count);
    member->count = 0;
    batch->runner_in[lane] = index;
    batch->live[lane] = -1;
    ++batch->count;
}

/* Fills empty lanes. One that stays empty doubles another, so that no lane computes with nothing. */
static void fill_lanes(integration *integration, batch *batch) {
    double fields[MEMBER_FIELDS];
    for (int lane = 0; lane < LANES; ++lane) {
        if (batch->runner_in[lane] == EMPTY && batch->waiting_count > 0) {
            enter_lane(integration, batch, lane, batch->waiting[--batch->waiting_count]);
        }
    }
    if (batch->count == LANES) {
        return;
    }
    int occupied = 0;
    while (batch->runner_in[occupied] == EMPTY) {
        ++occupied;
    }
    read_lane(&batch->members, occupied, fields, batch->fields);
    for (int lane = 0; lane < LANES; ++lane) {
        if (batch->runner_in[lane] == EMPTY) {
            write_lane(&batch->members, lane, fields, batch->fields);
        }
    }
}

/* Pushed runners are rare, so they share one kernel that branches on the case. */
static lane_outcome step_forced(flying_member *m, mask live, batch_kind kind, int order, double tolerance,
                                flight_series *f) {
    const bool clamped = kind == BATCH_CLAMPED_FORCED || kind == BATCH_CLAMPED_FORCED_AND_WAIT;
    const flight_case is = {
        .rising = clamped || kind == BATCH_RISE_FORCED || kind == BATCH_RISE_FORCED_AND_WAIT,
        .clamped = clamped,
        .awaits_ground = kind >= BATCH_PLACE_FORCED_AND_WAIT,
        .forced = true,
    };
    return step_flying(m, live, is, order, tolerance, f);
}

/* So do those that meet the border of a patch. */
static lane_outcome step_at_border(standing_member *m, mask live, batch_kind kind, int order,
                                   double tolerance, ground_series *g) {
    const ground_case is = {
        .slips = kind != BATCH_STICK_ON_BORDER,
        .has_torque = true,
        .falls = kind == BATCH_FALLING_SLIP_TO_BORDER,
        .meets_border = true,
    };
    return step_standing(m, live, is, order, tolerance, g);
}

static bool in_flight(batch_kind kind) {
    return kind < BATCH_STICK || (kind >= BATCH_PLACE_AND_WAIT && kind <= BATCH_CLAMPED_FORCED_AND_WAIT);
}

static int order_of(const integration *integration, batch_kind kind) {
    return in_flight(kind) ? integration->orders.flight : integration->orders.ground;
}

static lane_outcome step_batch(integration *integration, batch_kind kind) {
    batch *batch = &integration->batches[kind];
    const int order = order_of(integration, kind);
    const double tolerance = integration->tolerance;
    const ground_case sticks = {.has_torque = true}, sticks_and_coasts = {.has_torque = false};
    const ground_case slips = {.slips = true, .has_torque = true}, slips_and_coasts = {.slips = true};
    const ground_case slips_and_falls = {.slips = true, .has_torque = true, .falls = true};
    const ground_case grazes = {.grazes = true, .has_torque = true};
    const flight_case falls = {.rising = false}, rises = {.rising = true};
    const flight_case clamped = {.rising = true, .clamped = true};
    const flight_case waits = {.awaits_ground = true};
    const flight_case rises_and_waits = {.rising = true, .awaits_ground = true};
    const flight_case clamped_and_waits = {.rising = true, .clamped = true, .awaits_ground = true};
    flight_series *flight = &integration->series.flight;
    ground_series *ground = &integration->series.ground;
    switch (kind) {
    case BATCH_PLACE:
        return step_flying(&batch->members.flying, batch->live, falls, order, tolerance, flight);
    case BATCH_RISE:
        return step_flying(&batch->members.flying, batch->live, rises, order, tolerance, flight);
    case BATCH_CLAMPED:
        return step_flying(&batch->members.flying, batch->live, clamped, order, tolerance, flight);
    case BATCH_PLACE_AND_WAIT:
        return step_flying(&batch->members.flying, batch->live, waits, order, tolerance, flight);
    case BATCH_RISE_AND_WAIT:
        return step_flying(&batch->members.flying, batch->live, rises_and_waits, order, tolerance, flight);
    case BATCH_CLAMPED_AND_WAIT:
        return step_flying(&batch->members.flying, batch->live, clamped_and_waits, order, tolerance, flight);
    case BATCH_PLACE_FORCED:
    case BATCH_RISE_FORCED:
    case BATCH_CLAMPED_FORCED:
    case BATCH_PLACE_FORCED_AND_WAIT:
    case BATCH_RISE_FORCED_AND_WAIT:
    case BATCH_CLAMPED_FORCED_AND_WAIT:
        return step_forced(&batch->members.flying, batch->live, kind, order, tolerance, flight);
    case BATCH_STICK:
        return step_standing(&batch->members.standing, batch->live, sticks, order, tolerance, ground);
    case BATCH_STICK_AND_COAST:
        return step_standing(&batch->members.standing, batch->live, sticks_and_coasts, order, tolerance,
                             ground);
    case BATCH_SLIP:
        return step_standing(&batch->members.standing, batch->live, slips, order, tolerance, ground);
    case BATCH_SLIP_AND_COAST:
        return step_standing(&batch->members.standing, batch->live, slips_and_coasts, order, tolerance,
                             ground);
    case BATCH_FALLING_SLIP:
        return step_standing(&batch->members.standing, batch->live, slips_and_falls, order, tolerance,
                             ground);
    case BATCH_SLIP_TO_BORDER:
    case BATCH_FALLING_SLIP_TO_BORDER:
    case BATCH_STICK_ON_BORDER:
        return step_at_border(&batch->members.standing, batch->live, kind, order, tolerance, ground);
    default:
        return step_standing(&batch->members.standing, batch->live, grazes, order, tolerance, ground);
    }
}

/* Takes the event of a lane. False where the run of its runner has ended. */
static bool take_event(integration *integration, const batch *batch, int lane, tdmf_guard reached) {
    const int index = batch->runner_in[lane];
    tdmf_runner *runner = &integration->runners[index];
    waiting_member *member = &integration->members[index];
    if (tdmf_runner_may_change_law(runner, reached)) {
        read_lane(&batch->members, lane, member->fields, batch->fields);
        if (tdmf_runner_change_law(runner, member->fields, reached)) {
            member->count = batch->fields;
            return true;
        }
    }
    read_lane(&batch->members, lane, member->fields, CHANGING_FIELDS);
    return tdmf_runner_take_event(runner, member->fields, reached);
}

static void empty_lane(integration *integration, batch_kind kind, int lane, const lane_outcome *outcome) {
    batch *batch = &integration->batches[kind];
    const int index = batch->runner_in[lane];
    tdmf_runner *runner = &integration->runners[index];
    bool goes_on = false;
    if (outcome->at_event[lane]) {
        const int strides = runner->end->strides;
        goes_on = take_event(integration, batch, lane, guard_at_zero((int)outcome->event[lane]));
        integration->work.strides += runner->end->strides - strides;
        ++integration->work.events;
    } else {
        tdmf_runner_give_up(runner, outcome->late[lane] ? TDMF_FATE_UNDECIDED : TDMF_FATE_UNSOLVED);
    }
    batch->runner_in[lane] = EMPTY;
    batch->live[lane] = 0;
    --batch->count;
    integration->rare_count -= kind >= COMMON_BATCHES;
    if (goes_on) {
        wait_in(integration, index);
    } else {
        begin_another(integration, index);
    }
}

/* The series of one lane that are looked at, in the order in which they are noted. */
static void read_series(const integration *integration, batch_kind kind, int lane,
                        double to[TDMF_RECORDED_SERIES][SERIES_TERMS]) {
    const flight_series *f = &integration->series.flight;
    const ground_series *g = &integration->series.ground;
    const bool slips = kind == BATCH_SLIP || kind == BATCH_SLIP_AND_COAST ||
                       (kind >= BATCH_FALLING_SLIP && kind < BATCH_STICK_ON_BORDER);
    const real *const of_flight[] = {f->momentum, f->angle, f->rate_square, f->push_moment};
    const real *const of_ground[] = {g->normal_force, slips ? g->friction_force : g->tangential_push,
                                     g->moment, g->torque, g->power};
    const int count =
        in_flight(kind) ? sizeof of_flight / sizeof *of_flight : sizeof of_ground / sizeof *of_ground;
    for (int series = 0; series < count; ++series) {
        const real *from = in_flight(kind) ? of_flight[series] : of_ground[series];
        for (int k = 0; k <= order_of(integration, kind); ++k) {
            to[series][k] = from[k][lane];
        }
    }
}

static void record_steps(integration *integration, batch_kind kind, lane_outcome outcome) {
    const batch *batch = &integration->batches[kind];
    const unsigned stuck = movemask(outcome.stuck);
    double before[MEMBER_FIELDS], after[MEMBER_FIELDS];
    tdmf_lane_step recorded = {.order = order_of(integration, kind), .before = before, .after = after};
    for (int lane = 0; lane < LANES; ++lane) {
        if (batch->runner_in[lane] == EMPTY || (stuck >> lane & 1)) {
            continue;
        }
        recorded.size = outcome.size[lane];
        recorded.end = outcome.end[lane];
        read_lane(&integration->before, lane, before, MEMBER_FIELDS);
        read_lane(&batch->members, lane, after, MEMBER_FIELDS);
        read_series(integration, kind, lane, recorded.series);
        tdmf_runner_record_step(&integration->runners[batch->runner_in[lane]], &recorded);
    }
}

static void step_and_sort(integration *integration, batch_kind kind) {
    batch *batch = &integration->batches[kind];
    fill_lanes(integration, batch);
    integration->work.steps += batch->count;
    integration->work.evaluations += (int64_t)batch->count * order_of(integration, kind);
    integration->work.lane_steps += LANES;
    const bool is_recorded = tdmf_records_strides(integration->ensemble);
    if (is_recorded) {
        integration->before = batch->members;
    }
    const lane_outcome outcome = step_batch(integration, kind);
    for (unsigned limited = movemask(outcome.in_layer); limited != 0; limited >>= 1) {
        integration->work.layer_steps += limited & 1;
    }
    if (is_recorded) {
        record_steps(integration, kind, outcome);
    }
    const unsigned leaving = movemask(outcome.at_event | outcome.late | outcome.stuck);
    for (int lane = 0; leaving >> lane != 0; ++lane) {
        if (leaving >> lane & 1) {
            empty_lane(integration, kind, lane, &outcome);
        }
    }
}

/* The batch that the next step serves most runners of. */
static batch_kind fullest(const integration *integration) {
    const int kinds = integration->rare_count > 0 ? BATCH_COUNT : COMMON_BATCHES;
    batch_kind best = BATCH_PLACE;
    int maximum = -1;
    for (int kind = 0; kind < kinds; ++kind) {
        const batch *batch = &integration->batches[kind];
        if (batch->count + batch->waiting_count > maximum) {
            maximum = batch->count + batch->waiting_count;
            best = (batch_kind)kind;
        }
    }
    return best;
}

static void open_batches(integration *integration) {
    for (int kind = 0; kind < BATCH_COUNT; ++kind) {
        for (int lane = 0; lane < LANES; ++lane) {
            integration->batches[kind].runner_in[lane] = EMPTY;
        }
    }
}

static void run(integration *integration) {
    open_batches(integration);
    for (int index = 0; index < RUNNERS; ++index) {
        begin_another(integration, index);
    }
    for (;;) {
        const batch_kind kind = fullest(integration);
        if (integration->batches[kind].count + integration->batches[kind].waiting_count == 0) {
            return;
        }
        step_and_sort(integration, kind);
    }
}

bool TDMF_RUN_BATCHES(const tdmf_ensemble *ensemble, tdmf_starts *starts, series_orders orders,
                      tdmf_ensemble_end *ends, tdmf_ensemble_work *work) {
    /* C99 has no aligned allocation. */
    const uintptr_t alignment = sizeof(real);
    void *block = calloc(1, sizeof(integration) + alignment);
    if (block == NULL) {
        return false;
    }
    integration *integration = (void *)(((uintptr_t)block + alignment - 1) / alignment * alignment);
    integration->ensemble = ensemble;
    integration->starts = starts;
    integration->ends = ends;
    integration->orders = orders;
    integration->tolerance = ensemble->relative_tolerance;
    run(integration);
    *work = integration->work;
    free(block);
    return true;
}
