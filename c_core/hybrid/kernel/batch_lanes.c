/* Runs side by side. This file is compiled once for each instruction set; TDMF_LANES is the number of lanes.
 *
 * A runner stays in a lane of its mode's batch until an event takes it elsewhere. So all lanes of a step
 * follow one formula, each with a step size of its own, and whoever waits takes the place of whoever leaves.
 * Events are taken one runner at a time, by the functions that the driver calls. The driver itself makes the
 * steps where too few runners are in the same mode, and where coefficients overflow.
 */
#include "batch.h"
#include "observed.h"
#include "run_state.h"
#include "threads.h"

#include <stdlib.h>
#include <string.h>

enum {
    UNDER_WAY = TDMF_RUNS_OF_A_LANE * LANES,
    FEWEST = 2, /* runners for which a step in lanes pays */
    NOBODY = -1
};

typedef struct {
    run_state state;
    int64_t number; /* of its run */
    int next;       /* in a list of runners that wait */
} runner;

/* The runners of a mode. */
typedef struct {
    page_step step;
    mask live, moved, stops, is_shifted; /* moved: time has passed since the mode began */
    real time, time_rest, until, steps, last_step, next_sample;
    real *x, *rates;      /* of the states that change */
    real *dx, *d, *shift; /* by seed: variations of these states and of the constants */
    int runner_in[LANES]; /* or NOBODY */
    int count, waiting, waiting_count;
    bool was_filled; /* since then, no lane computes with nothing */
} lane_batch;

typedef struct {
    const tdmf_model_kind *model;
    const tdmf_motion_kind *motions;
    tdmf_batch_share *share;
    tdmf_batch_work *work;
    lane_batch *batches;
    real (*s)[TERMS], (*t)[TERMS]; /* series, and their variations for one seed */
    observed_part *observed;
    real *x_within, *dx_within; /* states that change, at a time within a step, and their variations */
    real *after, *d_after;      /* those after a step; `d_after` is by seed */
    int mode_of_series;
    runner *runners;
    mode_start at; /* of one runner */
    tdmf_driver *driver;
    int order, seed_count;
    tdmf_observation observes;
} lane_pool;

static tdmf_page_run *run_of(const lane_pool *w, int index) {
    return w->runners[index].state.r;
}

/* ---- in and out of lanes ------------------------------------------------------------------------------- */

static void wait_for_lane(lane_pool *w, int index) {
    lane_batch *b = &w->batches[run_of(w, index)->mode];
    w->runners[index].next = b->waiting;
    b->waiting = index;
    ++b->waiting_count;
}

static int take_waiting(lane_pool *w, lane_batch *b) {
    const int index = b->waiting;
    b->waiting = w->runners[index].next;
    --b->waiting_count;
    return index;
}

/* Gives a runner the next run. False where there is none. */
static bool take_next_run(lane_pool *w, int index) {
    w->runners[index].number = tdmf_next_run(w->share);
    return w->runners[index].number >= 0;
}

static void begin_run(lane_pool *w, int index) {
    runner *of = &w->runners[index];
    tdmf_begin_run(&of->state, w->model, &w->share->batch->runs[of->number], of->state.scales);
}

/* Stores the guards of a run that ends where a mode begins. */
static tdmf_run_outcome conclude(lane_pool *w, int index, tdmf_run_outcome outcome) {
    tdmf_begin_mode(&w->runners[index].state, &w->at);
    tdmf_keep_guards(&w->runners[index].state, &w->at);
    return outcome;
}

/* Begins a run that has stopped or ended anew, or the next one. False where there is none. */
static bool begin_again(lane_pool *w, int index, tdmf_continuation next) {
    if (next == TDMF_IS_OVER && !take_next_run(w, index)) {
        return false;
    }
    begin_run(w, index);
    return true;
}

/* Goes on with a runner whose mode begins, or concludes its run and takes the next. */
static void go_on(lane_pool *w, int index, tdmf_run_outcome outcome) {
    for (;;) {
        const run_state *state = &w->runners[index].state;
        const bool ends = w->model->modes[state->r->mode].ends;
        if (outcome == TDMF_RUN_GOES_ON && (ends || state->r->steps >= state->last_step)) {
            if (ends) {
                tdmf_sample_here(w->model, state->r);
            }
            outcome = conclude(w, index, ends ? TDMF_RUN_ENDED : TDMF_RUN_TOO_MANY_STEPS);
        }
        if (outcome == TDMF_RUN_GOES_ON) {
            wait_for_lane(w, index);
            return;
        }
        if (!begin_again(w, index,
                         tdmf_go_on_from(w->share->batch, w->runners[index].number, outcome, w->at.c))) {
            return;
        }
        outcome = TDMF_RUN_GOES_ON;
    }
}

static void load_runner(lane_pool *w, lane_batch *b, int lane, const run_state *state, double until) {
    const tdmf_page_run *r = state->r;
    const tdmf_motion_kind *m = b->step.motion;
    const int count = changing_count(&b->step), constant_count = m->constant_count;
    load_mode(&b->step, lane, &w->at, state->scales);
    for (int i = 0; i < constant_count; ++i) {
        set_lane(&b->step.c[i], lane, w->at.c[i]);
    }
    for (int i = 0; i < m->moving_count; ++i) {
        set_lane(&b->x[i], lane, r->x[m->moving[i]]);
    }
    for (int i = m->moving_count; i < count; ++i) {
        set_lane(&b->x[i], lane, r->x[changing_state(&b->step, i)]);
    }
    for (int seed = 0; seed < w->seed_count; ++seed) {
        const double *dx = r->dx + seed * w->model->state_count,
                     *d = w->at.d + seed * w->model->constant_count;
        set_lane(&b->shift[seed], lane, r->shift[seed]);
        for (int i = 0; i < count; ++i) {
            set_lane(&b->dx[seed * count + i], lane, dx[changing_state(&b->step, i)]);
        }
        for (int i = 0; i < m->constant_count; ++i) {
            set_lane(&b->d[seed * m->constant_count + i], lane, d[i]);
        }
    }
    set_mask(&b->moved, lane, false);
    set_mask(&b->stops, lane, state->stops);
    set_mask(&b->is_shifted, lane, r->is_shifted);
    set_lane(&b->time, lane, r->time);
    set_lane(&b->time_rest, lane, r->time_rest);
    set_lane(&b->until, lane, until);
    set_lane(&b->steps, lane, (double)r->steps);
    set_lane(&b->last_step, lane, (double)state->last_step);
    set_lane(&b->next_sample, lane, tdmf_next_sample(r));
}

static void fill_lanes(lane_pool *w, lane_batch *b) {
    for (int lane = 0; lane < LANES && b->waiting_count > 0; ++lane) {
        if (b->runner_in[lane] != NOBODY) {
            continue;
        }
        const int index = take_waiting(w, b);
        const runner *of = &w->runners[index];
        const double until = w->share->batch->until[of->number];
        tdmf_begin_mode(&of->state, &w->at);
        for (int other = b->was_filled ? lane : LANES - 1; other >= lane; --other) {
            load_runner(w, b, other, &of->state, until);
        }
        b->was_filled = true;
        b->runner_in[lane] = index;
        set_mask(&b->live, lane, true);
        ++b->count;
    }
}

/* Copies the changing states of a lane, or their variations along a seed, to those of its runner. */
static void unload_states(const lane_batch *b, int lane, const real *changing, double *x) {
    const page_step *step = &b->step;
    const int moving_count = step->motion->moving_count;
    for (int i = 0; i < moving_count; ++i) {
        x[step->motion->moving[i]] = lane_of(&changing[i], lane);
    }
    for (int i = 0; i < step->observed_count; ++i) {
        const real *state = &changing[changing_place(step, moving_count + i)];
        x[step->watches[i].into] = lane_of(state, lane);
    }
}

/* Copies the numbers of a lane to its runner, and those of its guards to `at`. */
static void unload_runner(lane_pool *w, const lane_batch *b, int lane) {
    const int count = changing_count(&b->step);
    tdmf_page_run *r = run_of(w, b->runner_in[lane]);
    unload_states(b, lane, b->x, r->x);
    for (int seed = 0; seed < w->seed_count; ++seed) {
        unload_states(b, lane, b->dx + seed * count, r->dx + seed * w->model->state_count);
    }
    w->work->steps += (int64_t)(lane_of(&b->steps, lane) - (double)r->steps);
    r->time = lane_of(&b->time, lane);
    r->time_rest = lane_of(&b->time_rest, lane);
    r->steps = (long)lane_of(&b->steps, lane);
    r->is_shifted = has_lane(&b->is_shifted, lane);
    if (has_lane(&b->moved, lane)) {
        r->chain = 0;
        r->taken = 0;
    }
    keep_guards(&b->step, lane, &w->at);
}

static void empty_lane(lane_batch *b, int lane) {
    b->runner_in[lane] = NOBODY;
    set_mask(&b->live, lane, false);
    --b->count;
}

/* Takes a runner out of its lane. */
static int leave_lane(lane_pool *w, lane_batch *b, int lane) {
    const int index = b->runner_in[lane];
    unload_runner(w, b, lane);
    empty_lane(b, lane);
    return index;
}

/* ---- one by one ---------------------------------------------------------------------------------------- */

/* Runs a runner by the driver up to its next event. `at` already holds its mode. */
static void drive(lane_pool *w, int index) {
    runner *of = &w->runners[index];
    const long before = of->state.r->steps;
    const double until = w->share->batch->until[of->number];
    const tdmf_run_outcome outcome = tdmf_drive_to_event(w->driver, &of->state, &w->at, until);
    w->work->single_steps += of->state.r->steps - before;
    go_on(w, index, outcome);
}

/* Takes a runner out of its lane, in the middle of its mode. */
static void drive_out_of_lane(lane_pool *w, lane_batch *b, int lane) {
    const tdmf_motion_kind *m = b->step.motion;
    unload_mode(&b->step, lane, &w->at);
    for (int i = 0; i < m->constant_count; ++i) {
        w->at.c[i] = lane_of(&b->step.c[i], lane);
    }
    for (int seed = 0; seed < w->seed_count; ++seed) {
        for (int i = 0; i < m->constant_count; ++i) {
            w->at.d[seed * w->model->constant_count + i] = lane_of(&b->d[seed * m->constant_count + i], lane);
        }
    }
    drive(w, leave_lane(w, b, lane));
}

static void drive_one(lane_pool *w, lane_batch *b) {
    if (b->waiting_count > 0) {
        const int index = take_waiting(w, b);
        tdmf_begin_mode(&w->runners[index].state, &w->at);
        drive(w, index);
        return;
    }
    int lane = 0;
    while (b->runner_in[lane] == NOBODY) {
        ++lane;
    }
    drive_out_of_lane(w, b, lane);
}

/* ---- steps in lanes ------------------------------------------------------------------------------------ */

/* The longest step that a law allows whose series does not show it. */
static real longest_step(const lane_pool *w, const lane_batch *b, const tdmf_mode_kind *mode) {
    const tdmf_motion_kind *m = b->step.motion;
    real longest = broadcast(INFINITY);
    for (int lane = 0; lane < LANES && mode->time_scale; ++lane) {
        if (has_lane(&b->live, lane)) {
            const tdmf_page_run *r = run_of(w, b->runner_in[lane]);
            for (int i = 0; i < m->moving_count; ++i) {
                r->x[m->moving[i]] = lane_of(&b->x[i], lane);
            }
            set_lane(&longest, lane, tdmf_longest_step_of_law(mode, r->p, r->x));
        }
    }
    return longest;
}

static void count_limited(const lane_pool *w, const lane_batch *b, mask lanes) {
    for (int lane = 0; lane < LANES; ++lane) {
        if (has_lane(&lanes, lane)) {
            ++run_of(w, b->runner_in[lane])->limited_steps;
        }
    }
}

/* Moves variations from the guard of the last event back to a fixed time. */
static void shift_back(const lane_pool *w, lane_batch *b, mask lanes) {
    const int count = w->seed_count > 0 && any(lanes) ? changing_count(&b->step) : 0;
    for (int i = 0; i < count; ++i) {
        const real rate = rate_after_event(&b->step, i, lanes);
        for (int seed = 0; seed < w->seed_count; ++seed) {
            real *dx = &b->dx[seed * count + changing_place(&b->step, i)];
            *dx = select(lanes, *dx - rate * b->shift[seed], *dx);
        }
    }
    b->is_shifted &= mask_not(lanes);
}

/* ---- variations ---------------------------------------------------------------------------------------- */

/* Expands the variations of a seed. */
static void expand_variation(const lane_pool *w, const lane_batch *b, int seed) {
    const tdmf_motion_kind *m = b->step.motion;
    const real *dx = &b->dx[seed * changing_count(&b->step)];
    for (int i = 0; i < m->moving_count; ++i) {
        w->t[i][0] = dx[i];
    }
    m->vary(b->step.c, w->s[0], &b->d[seed * m->constant_count], b->step.order, w->t[0]);
}

/* Goes on with the variations that were expanded. `after_event`: lanes whose step begins at an event, whose
 * time varies. */
static void advance_variation(const lane_pool *w, const lane_batch *b, int seed, mask goes, mask after_event,
                              real *dx) {
    const page_step *step = &b->step;
    const tdmf_motion_kind *m = step->motion;
    const real shift = select(after_event, b->shift[seed], broadcast(0.0));
    for (int i = 0; i < step->observed_count; ++i) {
        real *varied = &dx[changing_place(step, m->moving_count + i)];
        *varied = observed_variation(step, i, &b->d[seed * m->constant_count], w->t, shift, *varied);
    }
    for (int i = 0; i < m->moving_count; ++i) {
        dx[i] = select(goes, sum_of(w->t[i], step->power, step->order), dx[i]);
    }
}

/* ---- samples ------------------------------------------------------------------------------------------- */

/* Makes the samples that are due at the beginning of a step. */
static void sample_here(const lane_pool *w, lane_batch *b, mask lanes) {
    const int count = changing_count(&b->step);
    lanes &= b->next_sample <= b->time;
    for (int lane = 0; lane < LANES && any(lanes); ++lane) {
        if (has_lane(&lanes, lane)) {
            tdmf_page_run *r = run_of(w, b->runner_in[lane]);
            r->time = lane_of(&b->time, lane);
            unload_states(b, lane, b->x, r->x);
            for (int seed = 0; seed < w->seed_count; ++seed) {
                unload_states(b, lane, b->dx + seed * count, r->dx + seed * w->model->state_count);
            }
            tdmf_sample_here(w->model, r);
            set_lane(&b->next_sample, lane, tdmf_next_sample(r));
        }
    }
}

/* Writes the states of what is observed up to the time whose powers are set. */
static void observe_all(lane_batch *b, real elapsed, mask lanes, real *x) {
    page_step *step = &b->step;
    const int moving_count = step->motion->moving_count;
    if (step->observed_count > 0) {
        memcpy(x + moving_count, b->x + moving_count, (size_t)step->observed_count * sizeof *x);
    }
    for (int i = 0; i < step->observed_count; ++i) {
        real *value = &x[changing_place(step, moving_count + i)];
        *value = observe(step, i, *value, lanes & (elapsed > 0.0));
    }
}

/* Finds the changing states at times within the step, which it sets the powers of. */
static void states_within(const lane_pool *w, lane_batch *b, real elapsed, mask lanes) {
    page_step *step = &b->step;
    const int moving_count = step->motion->moving_count;
    set_power_pairs(step->power, elapsed, step->order);
    observe_all(b, elapsed, lanes, w->x_within);
    for (int i = 0; i < moving_count; ++i) {
        w->x_within[i] = value_at_end(step, i);
    }
}

/* Copies a sampled lane's states to its runner's, which the end of the step overwrites. */
static tdmf_page_run *sampled_run(const lane_pool *w, const lane_batch *b, int lane) {
    tdmf_page_run *r = run_of(w, b->runner_in[lane]);
    unload_states(b, lane, w->x_within, r->x);
    return r;
}

/* The variations along a seed of the samples that a step has made since the first ones. */
static void vary_samples(const lane_pool *w, lane_batch *b, int seed, const int first[LANES], mask lanes,
                         mask after_event) {
    const int count = changing_count(&b->step);
    for (int more = 0; any(lanes); ++more) {
        real elapsed = broadcast(0.0);
        for (int lane = 0; lane < LANES; ++lane) {
            const tdmf_page_run *r = has_lane(&lanes, lane) ? run_of(w, b->runner_in[lane]) : NULL;
            if (r && first[lane] + more < r->sampled && r->d_samples) {
                const double time = r->sample_times[first[lane] + more];
                set_lane(&elapsed, lane, time - lane_of(&b->time, lane));
            } else {
                set_mask(&lanes, lane, false);
            }
        }
        states_within(w, b, elapsed, lanes);
        memcpy(w->dx_within, b->dx + seed * count, (size_t)count * sizeof *w->dx_within);
        advance_variation(w, b, seed, lanes, after_event, w->dx_within);
        for (int lane = 0; lane < LANES; ++lane) {
            if (has_lane(&lanes, lane)) {
                tdmf_page_run *r = sampled_run(w, b, lane);
                double *dx = r->dx + seed * w->model->state_count;
                unload_states(b, lane, w->dx_within, dx);
                tdmf_vary_sample(w->model, r, first[lane] + more, seed, r->x, dx);
            }
        }
    }
}

/* Makes the samples within steps that last for `elapsed`, before the runs are advanced. */
static void sample_within(const lane_pool *w, lane_batch *b, real elapsed, mask goes, mask after_event) {
    const mask sampled = goes & (b->next_sample - b->time < elapsed);
    int first[LANES] = {0};
    if (!any(sampled)) {
        return;
    }
    for (int lane = 0; lane < LANES; ++lane) {
        first[lane] = has_lane(&sampled, lane) ? run_of(w, b->runner_in[lane])->sampled : 0;
    }
    for (mask lanes = sampled; any(lanes); lanes &= b->next_sample - b->time < elapsed) {
        states_within(w, b, b->next_sample - b->time, lanes);
        for (int lane = 0; lane < LANES; ++lane) {
            if (has_lane(&lanes, lane)) {
                tdmf_page_run *r = sampled_run(w, b, lane);
                tdmf_write_sample(w->model, r, r->sampled++, r->x);
                set_lane(&b->next_sample, lane, tdmf_next_sample(r));
            }
        }
    }
    for (int seed = 0; seed < w->seed_count; ++seed) {
        expand_variation(w, b, seed);
        vary_samples(w, b, seed, first, sampled, after_event);
    }
    set_power_pairs(b->step.power, elapsed, b->step.order);
}

/* ---- the end of a step --------------------------------------------------------------------------------- */

/* Adds to the time and keeps the rounding error, as tdmf_pass_time does. */
static void pass_time(lane_batch *b, real elapsed, real left, mask goes) {
    const page_step *step = &b->step;
    const real more = elapsed + b->time_rest, time = b->time + more, rest = more - (time - b->time);
    const mask arrives = goes & (step->end > 1.0) & (step->size == left);
    b->moved |= goes & (time > b->time);
    b->time = select(arrives, b->until, select(goes, time, b->time));
    b->time_rest = select(arrives, broadcast(0.0), select(goes, rest, b->time_rest));
    b->steps += select(goes, broadcast(1.0), broadcast(0.0));
}

/* Finds what is observed up to the end of the step, and the variations there. False where these cannot be
 * trusted so far: then the step is shorter. */
static bool find_variations(const lane_pool *w, lane_batch *b, real elapsed, mask goes, mask after_event) {
    page_step *step = &b->step;
    const int count = changing_count(step);
    observe_all(b, elapsed, goes, w->after);
    for (int seed = 0; seed < w->seed_count; ++seed) {
        expand_variation(w, b, seed);
        if (any(trust_variation(step, w->t, goes))) {
            return false;
        }
        memcpy(w->d_after + seed * count, b->dx + seed * count, (size_t)count * sizeof *b->dx);
        advance_variation(w, b, seed, goes, after_event, w->d_after + seed * count);
    }
    return true;
}

static void advance(const lane_pool *w, lane_batch *b, real left, mask goes, mask after_event) {
    page_step *step = &b->step;
    const int moving_count = step->motion->moving_count, count = changing_count(step);
    real elapsed;
    for (int i = 0; i < step->observed_count; ++i) {
        trust_observed(step, i, b->x[changing_place(step, moving_count + i)], goes);
    }
    do {
        elapsed = end_step(step);
    } while (!find_variations(w, b, elapsed, goes, after_event));
    sample_within(w, b, elapsed, goes, after_event);
    for (int i = 0; i < moving_count; ++i) {
        b->x[i] = select(goes, value_at_end(step, i), b->x[i]);
    }
    for (int i = moving_count; i < count; ++i) {
        b->x[i] = w->after[i];
    }
    if (w->seed_count > 0) {
        memcpy(b->dx, w->d_after, (size_t)(w->seed_count * count) * sizeof *b->dx);
    }
    pass_time(b, elapsed, left, goes);
    step->begins &= mask_not(goes);
}

/* Finds the rates of lanes at their event. */
static void find_rates(lane_batch *b, mask lanes) {
    page_step *step = &b->step;
    set_power_pairs(step->power, select(step->is_due, broadcast(0.0), step->power[1]), step->order);
    for (int i = 0; i < changing_count(step); ++i) {
        b->rates[i] = rate_before_event(step, i, b->x[changing_place(step, i)], lanes);
    }
}

/* Takes the event of a runner. `shifts`: its variations are moved onto the guard. */
static void take_event(lane_pool *w, lane_batch *b, int lane, bool shifts) {
    const tdmf_mode_kind *mode = &w->model->modes[run_of(w, b->runner_in[lane])->mode];
    const tdmf_guard_kind *kind = &mode->guards[(int)b->step.first[lane]];
    const int index = leave_lane(w, b, lane);
    run_state *state = &w->runners[index].state;
    if (shifts) {
        memset(w->at.rates, 0, (size_t)w->model->state_count * sizeof *w->at.rates);
        for (int i = 0; i < changing_count(&b->step); ++i) {
            w->at.rates[changing_state(&b->step, i)] += lane_of(&b->rates[i], lane);
        }
        tdmf_shift_to_event(state, kind, &w->at);
    }
    const bool may_go_on = tdmf_take_event(state, kind, &w->at);
    go_on(w, index, may_go_on ? TDMF_RUN_GOES_ON : conclude(w, index, tdmf_limit_reached(state)));
}

/* Lanes that a step ends in, by what ends it: coefficients overflow, no step has a finite result, the run
 * stops or arrives, an event is taken (`shifts`: variations are moved onto its guard), the step limit is
 * reached. */
typedef struct {
    mask overflows, fails, arrives, takes, shifts, is_late;
} lane_ends;

/* Expands the series of all lanes. */
static void expand_lanes(lane_pool *w, lane_batch *b, int number) {
    page_step *step = &b->step;
    step->order = w->order;
    if (w->mode_of_series != number) {
        w->mode_of_series = number;
        clear_polynomials(step);
    }
    for (int i = 0; i < step->motion->moving_count; ++i) {
        w->s[i][0] = b->x[i];
    }
    step->motion->expand(step->c, w->order, w->s[0]);
}

/* Whether a run that has stopped goes on in its lane, because neither the run changes nor its step. If not,
 * it leaves the lane. */
static bool go_on_in_lane(lane_pool *w, lane_batch *b, int lane) {
    const int index = b->runner_in[lane];
    const runner *of = &w->runners[index];
    const double *until = &w->share->batch->until[of->number];
    const double reach = lane_of(&b->step.reach, lane), before = *until;
    unload_runner(w, b, lane);
    tdmf_keep_guards(&w->runners[index].state, &w->at);
    const tdmf_continuation next = tdmf_go_on_from(w->share->batch, of->number, TDMF_RUN_STOPPED, w->at.c);
    const tdmf_page_run *r = of->state.r;
    const double nearer = *until < before ? *until : before;
    if (next == TDMF_GOES_ON_UNCHANGED && r->step_limit > 0 && nearer - r->time - r->time_rest > reach) {
        tdmf_begin_call(&w->runners[index].state);
        set_lane(&b->until, lane, *until);
        set_lane(&b->last_step, lane, (double)of->state.last_step);
        set_mask(&b->stops, lane, false);
        return true;
    }
    empty_lane(b, lane);
    if (begin_again(w, index, next)) {
        go_on(w, index, TDMF_RUN_GOES_ON);
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

/* Makes a step whose series are expanded, as the driver does. */
static lane_ends make_step(lane_pool *w, lane_batch *b, const tdmf_mode_kind *mode) {
    page_step *step = &b->step;
    lane_ends ends;
    series_remainder remainder;
    ends.overflows = b->live & mask_not(judge_series(step, &remainder));
    real left = b->until - b->time - b->time_rest;
    const real longest = longest_step(w, b, mode);
    choose_size(step, &remainder, longest, real_max(left, broadcast(0.0)));
    ends.fails = b->live & mask_not(ends.overflows | (step->size >= 0.0));
    mask goes = b->live & mask_not(ends.overflows | ends.fails);
    search_events(step, goes);
    const mask stops = goes & b->stops & mask_not(step->is_due);
    goes &= mask_not(step->is_due);
    if (any(stops)) {
        goes &= mask_not(stops) | go_on_in_lanes(w, b, stops);
        left = select(stops, b->until - b->time - b->time_rest, left);
    }
    const mask after_event = goes & b->is_shifted;
    shift_back(w, b, after_event);
    sample_here(w, b, goes);
    ends.arrives = goes & mask_not(left > 0.0);
    goes &= mask_not(ends.arrives);
    if (mode->time_scale) {
        count_limited(w, b, goes & (step->reach == longest));
    }
    advance(w, b, left, goes, after_event);
    mask reaches = goes & (step->end <= 1.0) & (step->first != NO_EVENT);
    reaches &= mask_not(looks_again(step, reaches));
    ends.is_late = goes & mask_not(reaches) & (b->steps >= b->last_step);
    ends.takes = step->is_due | reaches;
    const mask varies_at_once = step->is_due & step->is_reached;
    shift_back(w, b, varies_at_once & b->is_shifted);
    ends.shifts = mask_not(b->is_shifted) & (reaches | varies_at_once);
    if (w->seed_count > 0 && any(ends.shifts)) {
        find_rates(b, ends.shifts);
    }
    return ends;
}

/* Takes a runner out of the lane in which a step has ended. */
static void end_in_lane(lane_pool *w, lane_batch *b, int lane, const lane_ends *ends) {
    if (has_lane(&ends->takes, lane)) {
        take_event(w, b, lane, w->seed_count > 0 && has_lane(&ends->shifts, lane));
    } else if (has_lane(&ends->overflows, lane)) {
        drive_out_of_lane(w, b, lane);
    } else {
        const int index = leave_lane(w, b, lane);
        tdmf_keep_guards(&w->runners[index].state, &w->at);
        go_on(w, index,
              has_lane(&ends->fails, lane)     ? TDMF_RUN_NO_PROGRESS
              : has_lane(&ends->arrives, lane) ? TDMF_RUN_ARRIVED
                                               : TDMF_RUN_TOO_MANY_STEPS);
    }
}

/* Makes a step in the lanes of a mode. */
static void step_once(lane_pool *w, lane_batch *b, int number) {
    w->work->lane_steps += LANES;
    expand_lanes(w, b, number);
    const lane_ends ends = make_step(w, b, &w->model->modes[number]);
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
static void step_lanes(lane_pool *w, int number) {
    lane_batch *b = &w->batches[number];
    fill_lanes(w, b);
    const int count = b->count;
    do {
        step_once(w, b, number);
    } while (b->count == count && !tdmf_is_raised(w->share->batch->cancel));
}

/* ---- all ----------------------------------------------------------------------------------------------- */

/* The mode that most runners are in; NOBODY: all runs have ended. */
static int fullest(const lane_pool *w) {
    int best = NOBODY, most = 0;
    for (int number = 0; number < w->model->mode_count; ++number) {
        const int runners = w->batches[number].count + w->batches[number].waiting_count;
        if (runners > most) {
            best = number;
            most = runners;
        }
    }
    return best;
}

/* Leaves all runners where they are. */
static void cancel(lane_pool *w) {
    for (int number = 0; number < w->model->mode_count; ++number) {
        lane_batch *b = &w->batches[number];
        for (int lane = 0; lane < LANES; ++lane) {
            if (b->runner_in[lane] != NOBODY) {
                w->share->batch->outcomes[w->runners[b->runner_in[lane]].number] = TDMF_RUN_CANCELLED;
                tdmf_keep_guards(&w->runners[leave_lane(w, b, lane)].state, &w->at);
            }
        }
        while (b->waiting_count > 0) {
            w->share->batch->outcomes[w->runners[take_waiting(w, b)].number] = TDMF_RUN_CANCELLED;
        }
    }
}

static size_t reals_of_mode(const lane_pool *w, int number) {
    const tdmf_motion_kind *m = &w->motions[number];
    const int changing = m->moving_count + tdmf_observed_count(&w->model->modes[number], w->observes);
    const size_t by_seed = (size_t)changing + (size_t)m->constant_count + 1;
    return 3 * (size_t)changing + (size_t)m->constant_count + (size_t)w->seed_count * by_seed;
}

static real *place_batch(lane_pool *w, int number, real *next) {
    lane_batch *b = &w->batches[number];
    const tdmf_mode_kind *mode = &w->model->modes[number];
    const tdmf_motion_kind *m = b->step.motion = &w->motions[number];
    b->step.kinds = mode->guards;
    b->step.watches = mode->watches;
    b->step.guard_count = mode->guard_count;
    b->step.observed_count = tdmf_observed_count(mode, w->observes);
    b->step.tolerance = w->share->batch->runs[0].tolerance;
    b->step.s = w->s;
    b->step.observed = w->observed;
    b->step.c = next;
    b->step.units = b->step.c + m->constant_count;
    b->x = b->step.units + changing_count(&b->step);
    b->rates = b->x + changing_count(&b->step);
    b->dx = b->rates + changing_count(&b->step);
    b->d = b->dx + w->seed_count * changing_count(&b->step);
    b->shift = b->d + w->seed_count * m->constant_count;
    b->waiting = NOBODY;
    for (int lane = 0; lane < LANES; ++lane) {
        b->runner_in[lane] = NOBODY;
    }
    return next + reals_of_mode(w, number);
}

static void run_pool(lane_pool *w, int under_way) {
    for (int index = 0; index < under_way && take_next_run(w, index); ++index) {
        begin_run(w, index);
        go_on(w, index, TDMF_RUN_GOES_ON);
    }
    for (int number = fullest(w); number != NOBODY; number = fullest(w)) {
        lane_batch *b = &w->batches[number];
        if (tdmf_is_raised(w->share->batch->cancel)) {
            cancel(w);
        } else if (b->count + b->waiting_count < FEWEST) {
            drive_one(w, b);
        } else {
            step_lanes(w, number);
        }
    }
}

/* At least as many states as change in any mode. */
static size_t most_changing(const tdmf_model_kind *model) {
    return (size_t)model->state_count + TDMF_WATCH_LIMIT;
}

/* Reals of the series and of all modes. */
static size_t reals_of_pool(const lane_pool *w) {
    size_t reals = 2 * (size_t)w->model->series_count * TERMS;
    reals += (3 + (size_t)w->seed_count) * most_changing(w->model);
    for (int number = 0; number < w->model->mode_count; ++number) {
        reals += reals_of_mode(w, number);
    }
    return reals;
}

static size_t doubles_of_pool(const lane_pool *w, int under_way) {
    return tdmf_size_of_mode_start(w->model, w->seed_count) + tdmf_size_of_driver(w->model, w->seed_count) +
           (size_t)under_way * tdmf_size_of_run_state(w->model);
}

static size_t bytes_of_pool(const lane_pool *w, int under_way) {
    return sizeof(real) + (size_t)w->model->mode_count * sizeof(lane_batch) +
           TDMF_WATCH_LIMIT * sizeof(observed_part) + reals_of_pool(w) * sizeof(real) +
           doubles_of_pool(w, under_way) * sizeof(double) + (size_t)under_way * sizeof(runner);
}

/* Places the arrays of a pool in memory that is zero; those of reals have to be aligned. */
static void place_pool(lane_pool *w, int under_way, char *memory) {
    const tdmf_model_kind *model = w->model;
    w->batches = (void *)(((uintptr_t)memory + sizeof(real) - 1) / sizeof(real) * sizeof(real));
    w->observed = (void *)(w->batches + model->mode_count);
    w->s = (void *)(w->observed + TDMF_WATCH_LIMIT);
    w->t = w->s + model->series_count;
    w->x_within = (real *)(w->t + model->series_count);
    w->dx_within = w->x_within + most_changing(model);
    w->after = w->dx_within + most_changing(model);
    w->d_after = w->after + most_changing(model);
    real *next = w->d_after + (size_t)w->seed_count * most_changing(model);
    for (int number = 0; number < model->mode_count; ++number) {
        next = place_batch(w, number, next);
    }
    double *numbers = (double *)next;
    w->runners = (void *)(numbers + doubles_of_pool(w, under_way));
    tdmf_place_mode_start(&w->at, model, w->seed_count, numbers);
    numbers += tdmf_size_of_mode_start(model, w->seed_count);
    w->driver = tdmf_place_driver(model, w->seed_count, numbers);
    numbers += tdmf_size_of_driver(model, w->seed_count);
    for (int index = 0; index < under_way; ++index) {
        w->runners[index].state.scales = numbers + (size_t)index * tdmf_size_of_run_state(model);
    }
}

bool TDMF_OF_WIDTH(tdmf_run_lanes)(tdmf_batch_share *share, tdmf_batch_work *work) {
    enum { ROW = LANES == 2 ? 0 : LANES == 4 ? 1 : 2 };
    const tdmf_page_run *first = share->batch->runs;
    const int64_t each = (share->batch->count + share->threads - 1) / share->threads;
    const int under_way = each < UNDER_WAY ? (int)each : UNDER_WAY;
    lane_pool w = {.model = share->model,
                   .motions = share->model->lanes[ROW](),
                   .share = share,
                   .work = work,
                   .mode_of_series = NOBODY,
                   .order = first->order,
                   .seed_count = first->seed_count,
                   .observes = first->observes};
    char *memory = calloc(1, bytes_of_pool(&w, under_way));
    if (!memory) {
        return false;
    }
    place_pool(&w, under_way, memory);
    run_pool(&w, under_way);
    free(memory);
    return true;
}
