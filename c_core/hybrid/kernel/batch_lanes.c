/* Runs side by side. This file is compiled once for each instruction set; TDMF_LANES is the number of lanes.
 *
 * A runner stays in a lane of its mode's batch until an event takes it elsewhere. So all lanes of a step
 * follow one formula, each with a step size of its own, and whoever waits takes the place of whoever leaves.
 * Events are taken one runner at a time, by the functions that the driver calls. The driver itself makes the
 * steps where too few runners are in the same mode, and where coefficients overflow.
 */
#include "batch.h"
#include "page_lanes.h"
#include "threads.h"

#include <stdlib.h>

enum {
    UNDER_WAY = TDMF_RUNS_OF_A_LANE * LANES,
    FEWEST = 2, /* runners for which a step in lanes pays */
    NOBODY = -1
};

typedef struct runner {
    run_state state;     /* first: page_lanes.h knows a runner by it */
    int64_t number;      /* number of its run */
    struct runner *next; /* next in a list of runners that wait */
} runner;

/* The runners of a mode. */
typedef struct {
    page_lanes lanes;
    int count, waiting_count;
    runner *waiting;
    bool was_filled; /* since then, no lane computes with nothing */
} lane_batch;

typedef struct {
    const tdmf_model_kind *model;
    const tdmf_motion_kind *motions;
    tdmf_batch_share *share;
    tdmf_batch_work *work;
    lane_room *room;
    lane_batch *batches;
    runner *runners;
    mode_start at; /* mode start of one runner */
    tdmf_driver *driver;
} lane_pool;

static runner *runner_in(const lane_batch *b, int lane) {
    return (runner *)(void *)b->lanes.runs[lane];
}

static double until_of(const lane_pool *w, const runner *of) {
    return w->share->batch->until[of->number];
}

/* ---- in and out of lanes ------------------------------------------------------------------------------- */

static void wait_for_lane(lane_pool *w, runner *of) {
    lane_batch *b = &w->batches[of->state.r->mode];
    of->next = b->waiting;
    b->waiting = of;
    ++b->waiting_count;
}

static runner *take_waiting(lane_batch *b) {
    runner *of = b->waiting;
    b->waiting = of->next;
    --b->waiting_count;
    return of;
}

/* Gives a runner the next run. False where there is none. */
static bool take_next_run(lane_pool *w, runner *of) {
    of->number = tdmf_next_run(w->share);
    return of->number >= 0;
}

static void begin_run(lane_pool *w, runner *of) {
    tdmf_begin_run(&of->state, w->model, &w->share->batch->runs[of->number], of->state.scales);
}

/* Stores the guards of a run that ends where a mode begins. */
static tdmf_run_outcome conclude(lane_pool *w, runner *of, tdmf_run_outcome outcome) {
    tdmf_begin_mode(&of->state, &w->at);
    tdmf_keep_guards(&of->state, &w->at);
    return outcome;
}

/* Begins a run that has stopped or ended anew, or the next one. False where there is none. */
static bool begin_again(lane_pool *w, runner *of, tdmf_continuation next) {
    if (next == TDMF_IS_OVER && !take_next_run(w, of)) {
        return false;
    }
    begin_run(w, of);
    return true;
}

/* Goes on with a runner whose mode begins, or concludes its run and takes the next. */
static void go_on(lane_pool *w, runner *of, tdmf_run_outcome outcome) {
    for (;;) {
        const run_state *state = &of->state;
        const bool ends = w->model->modes[state->r->mode].ends;
        if (outcome == TDMF_RUN_GOES_ON && (ends || state->r->steps >= state->last_step)) {
            if (ends) {
                tdmf_sample_here(w->model, state->r);
            }
            outcome = conclude(w, of, ends ? TDMF_RUN_ENDED : TDMF_RUN_TOO_MANY_STEPS);
        }
        if (outcome == TDMF_RUN_GOES_ON) {
            wait_for_lane(w, of);
            return;
        }
        if (!begin_again(w, of, tdmf_go_on_from(w->share->batch, of->number, outcome, w->at.c))) {
            return;
        }
        outcome = TDMF_RUN_GOES_ON;
    }
}

static void fill_lanes(lane_pool *w, lane_batch *b) {
    for (int lane = 0; lane < LANES && b->waiting_count > 0; ++lane) {
        if (runner_in(b, lane)) {
            continue;
        }
        runner *of = take_waiting(b);
        end_lanes();
        tdmf_begin_mode(&of->state, &w->at);
        for (int other = b->was_filled ? lane : LANES - 1; other >= lane; --other) {
            load_run(&b->lanes, other, &of->state, &w->at, until_of(w, of));
            b->lanes.runs[other] = other == lane ? &of->state : NULL;
        }
        b->was_filled = true;
        set_mask(&b->lanes.live, lane, true);
        ++b->count;
    }
}

/* Copies the numbers of a lane to its runner, and those of its guards to `at`. */
static void unload(lane_pool *w, const lane_batch *b, int lane) {
    w->work->steps += (int64_t)(lane_of(&b->lanes.steps, lane) - (double)b->lanes.runs[lane]->r->steps);
    unload_run(&b->lanes, lane);
    keep_guards(&b->lanes, lane, &w->at);
    end_lanes();
}

static void empty_lane(lane_batch *b, int lane) {
    b->lanes.runs[lane] = NULL;
    set_mask(&b->lanes.live, lane, false);
    --b->count;
}

/* Takes a runner out of its lane. */
static runner *leave_lane(lane_pool *w, lane_batch *b, int lane) {
    runner *of = runner_in(b, lane);
    unload(w, b, lane);
    empty_lane(b, lane);
    return of;
}

/* ---- one by one ---------------------------------------------------------------------------------------- */

/* Runs a runner by the driver up to its next event. `at` already holds its mode. */
static void drive(lane_pool *w, runner *of) {
    const long before = of->state.r->steps;
    const tdmf_run_outcome outcome = tdmf_drive_to_event(w->driver, &of->state, &w->at, until_of(w, of));
    w->work->single_steps += of->state.r->steps - before;
    go_on(w, of, outcome);
}

/* Takes a runner out of its lane, in the middle of its mode. */
static void drive_out_of_lane(lane_pool *w, lane_batch *b, int lane) {
    unload_mode(&b->lanes, lane, &w->at);
    drive(w, leave_lane(w, b, lane));
}

static void drive_one(lane_pool *w, lane_batch *b) {
    if (b->waiting_count > 0) {
        runner *of = take_waiting(b);
        tdmf_begin_mode(&of->state, &w->at);
        drive(w, of);
        return;
    }
    int lane = 0;
    while (!runner_in(b, lane)) {
        ++lane;
    }
    drive_out_of_lane(w, b, lane);
}

/* ---- steps in lanes ------------------------------------------------------------------------------------ */

/* True if a run that has stopped goes on in its lane, because neither the run nor its step changes. Otherwise
 * the run leaves the lane. */
static bool go_on_in_lane(lane_pool *w, lane_batch *b, int lane) {
    runner *of = runner_in(b, lane);
    const double *until = &w->share->batch->until[of->number];
    const double reach = lane_of(&b->lanes.step.reach, lane), before = *until;
    unload(w, b, lane);
    tdmf_keep_guards(&of->state, &w->at);
    const tdmf_continuation next = tdmf_go_on_from(w->share->batch, of->number, TDMF_RUN_STOPPED, w->at.c);
    const tdmf_page_run *r = of->state.r;
    const double nearer = *until < before ? *until : before;
    if (next == TDMF_GOES_ON_UNCHANGED && r->step_limit > 0 && nearer - r->time - r->time_rest > reach) {
        tdmf_begin_call(&of->state);
        set_lane(&b->lanes.until, lane, *until);
        set_lane(&b->lanes.last_step, lane, (double)of->state.last_step);
        set_mask(&b->lanes.stops, lane, false);
        return true;
    }
    empty_lane(b, lane);
    if (begin_again(w, of, next)) {
        go_on(w, of, TDMF_RUN_GOES_ON);
    }
    return false;
}

/* The lanes in which runs that have stopped go on. */
static mask go_on_in_lanes(lane_pool *w, lane_batch *b, mask stops) {
    const unsigned stopped = movemask(stops);
    mask goes = mask_of(false);
    end_lanes();
    for (int lane = 0; stopped >> lane != 0; ++lane) {
        if (stopped >> lane & 1) {
            set_mask(&goes, lane, go_on_in_lane(w, b, lane));
        }
    }
    return goes;
}

/* Takes a runner out of the lane in which a step has ended. */
static void end_in_lane(lane_pool *w, lane_batch *b, int lane, const lane_ends *ends) {
    if (has_lane(&ends->overflows, lane)) {
        drive_out_of_lane(w, b, lane);
        return;
    }
    tdmf_run_outcome outcome = has_lane(&ends->fails, lane)     ? TDMF_RUN_NO_PROGRESS
                               : has_lane(&ends->arrives, lane) ? TDMF_RUN_ARRIVED
                                                                : TDMF_RUN_TOO_MANY_STEPS;
    runner *of = leave_lane(w, b, lane);
    if (has_lane(&ends->takes, lane)) {
        const bool may_go_on = take_event(&b->lanes, lane, ends, &of->state, &w->at);
        outcome = may_go_on ? TDMF_RUN_GOES_ON : conclude(w, of, tdmf_limit_reached(&of->state));
    } else {
        tdmf_keep_guards(&of->state, &w->at);
    }
    go_on(w, of, outcome);
}

/* Makes a step in the lanes of a mode. */
static void step_once(lane_pool *w, lane_batch *b) {
    w->work->lane_steps += LANES;
    lane_ends ends = begin_step(&b->lanes);
    if (any(ends.stops)) {
        ends.goes |= go_on_in_lanes(w, b, ends.stops);
    }
    finish_step(&b->lanes, &ends);
    const unsigned leaving = movemask(ends.overflows | ends.fails | ends.takes | ends.arrives | ends.is_late);
    if (leaving != 0) {
        end_lanes();
    }
    for (int lane = 0; leaving >> lane != 0; ++lane) {
        if (leaving >> lane & 1) {
            end_in_lane(w, b, lane, &ends);
        }
    }
}

/* Makes steps in the lanes of a mode until a runner leaves its lane. Until then no mode has more runners. */
static void step_lanes(lane_pool *w, lane_batch *b) {
    fill_lanes(w, b);
    const int count = b->count;
    do {
        step_once(w, b);
    } while (b->count == count && !tdmf_is_raised(w->share->batch->cancel));
}

/* ---- all ----------------------------------------------------------------------------------------------- */

/* The batch with most runners; NULL: all runs have ended. */
static lane_batch *fullest(const lane_pool *w) {
    lane_batch *best = NULL;
    int most = 0;
    for (int number = 0; number < w->model->mode_count; ++number) {
        lane_batch *b = &w->batches[number];
        if (b->count + b->waiting_count > most) {
            best = b;
            most = b->count + b->waiting_count;
        }
    }
    return best;
}

/* Leaves all runners where they are. */
static void cancel(lane_pool *w) {
    for (int number = 0; number < w->model->mode_count; ++number) {
        lane_batch *b = &w->batches[number];
        for (int lane = 0; lane < LANES; ++lane) {
            if (runner_in(b, lane)) {
                runner *of = leave_lane(w, b, lane);
                w->share->batch->outcomes[of->number] = TDMF_RUN_CANCELLED;
                tdmf_keep_guards(&of->state, &w->at);
            }
        }
        while (b->waiting_count > 0) {
            w->share->batch->outcomes[take_waiting(b)->number] = TDMF_RUN_CANCELLED;
        }
    }
}

static void run_pool(lane_pool *w, int under_way) {
    for (int i = 0; i < under_way && take_next_run(w, &w->runners[i]); ++i) {
        begin_run(w, &w->runners[i]);
        go_on(w, &w->runners[i], TDMF_RUN_GOES_ON);
    }
    for (lane_batch *b = fullest(w); b; b = fullest(w)) {
        if (tdmf_is_raised(w->share->batch->cancel)) {
            cancel(w);
        } else if (b->count + b->waiting_count < FEWEST) {
            drive_one(w, b);
        } else {
            step_lanes(w, b);
        }
    }
}

/* ---- memory -------------------------------------------------------------------------------------------- */

static size_t doubles_of_pool(const lane_pool *w, int under_way) {
    const int seed_count = w->share->batch->runs->seed_count;
    return tdmf_size_of_mode_start(w->model, seed_count) + tdmf_size_of_driver(w->model, seed_count) +
           (size_t)under_way * tdmf_size_of_run_state(w->model);
}

static size_t bytes_of_pool(const lane_pool *w, int under_way) {
    const tdmf_page_run *first = w->share->batch->runs;
    size_t reals = 1 + reals_of_room(w->model, first->seed_count); /* one is lost by aligning the rest */
    for (int number = 0; number < w->model->mode_count; ++number) {
        reals += reals_of_mode(&w->model->modes[number], first->seed_count, first->observes);
    }
    return sizeof(lane_room) + (size_t)w->model->mode_count * sizeof(lane_batch) + reals * sizeof(real) +
           doubles_of_pool(w, under_way) * sizeof(double) + (size_t)under_way * sizeof(runner);
}

/* Places the arrays of a pool in memory that is zero; those of reals have to be aligned. */
static void place_pool(lane_pool *w, int under_way, char *memory) {
    const tdmf_model_kind *model = w->model;
    const tdmf_page_run *first = w->share->batch->runs;
    w->room = (void *)(((uintptr_t)memory + sizeof(real) - 1) / sizeof(real) * sizeof(real));
    w->room->model = model;
    w->room->tolerance = first->tolerance;
    w->room->order = first->order;
    w->room->seed_count = first->seed_count;
    w->room->observes = first->observes;
    w->batches = (void *)(w->room + 1);
    real *next = place_room(w->room, (real *)(w->batches + model->mode_count));
    for (int number = 0; number < model->mode_count; ++number) {
        const tdmf_mode_kind *mode = &model->modes[number];
        open_lanes(&w->batches[number].lanes, w->room, mode, &w->motions[number], next);
        next += reals_of_mode(mode, first->seed_count, first->observes);
    }
    double *numbers = (double *)next;
    w->runners = (void *)(numbers + doubles_of_pool(w, under_way));
    tdmf_place_mode_start(&w->at, model, first->seed_count, numbers);
    numbers += tdmf_size_of_mode_start(model, first->seed_count);
    w->driver = tdmf_place_driver(model, first->seed_count, numbers);
    numbers += tdmf_size_of_driver(model, first->seed_count);
    for (int i = 0; i < under_way; ++i) {
        w->runners[i].state.scales = numbers + (size_t)i * tdmf_size_of_run_state(model);
    }
}

bool TDMF_OF_WIDTH(tdmf_run_lanes)(tdmf_batch_share *share, tdmf_batch_work *work) {
    enum { ROW = LANES == 2 ? 0 : LANES == 4 ? 1 : 2 };
    const int64_t each = (share->batch->count + share->threads - 1) / share->threads;
    const int under_way = each < UNDER_WAY ? (int)each : UNDER_WAY;
    lane_pool w = {
        .model = share->model, .motions = share->model->lanes[ROW](), .share = share, .work = work};
    char *memory = calloc(1, bytes_of_pool(&w, under_way));
    if (!memory) {
        return false;
    }
    place_pool(&w, under_way, memory);
    run_pool(&w, under_way);
    free(memory);
    return true;
}
