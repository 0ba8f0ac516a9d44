/* Runs that are in one mode, side by side: their steps, samples and variations. The driver has one lane, and
 * batches have several. They share this text, so that all widths give equal bits.
 *
 * A lane holds the numbers of a run that change in its mode. They return to the run where it leaves the lane.
 */
#ifndef TDMF_KERNEL_PAGE_LANES_H
#define TDMF_KERNEL_PAGE_LANES_H

#include "observed.h"

/* Data that all modes share: numbers of the runs, and arrays in the caller's memory. */
typedef struct {
    const tdmf_model_kind *model;
    double tolerance;
    int order, seed_count;
    tdmf_observation observes;
    real (*s)[TERMS], (*t)[TERMS]; /* series, and their variations for one seed */
    observed_part observed[TDMF_WATCH_LIMIT];
    real *x_within, *dx_within; /* states that change, at a time within a step, and their variations */
    real *after, *d_after;      /* those after a step; `d_after` is by seed */
    const tdmf_mode_kind *mode_of_series;
    tdmf_seed_lanes two_seeds; /* without memory, one seed is varied after the other */
    bool two_seeds_are_filled; /* they hold the constants and the series of the step */
} lane_room;

typedef struct {
    lane_room *room;
    const tdmf_mode_kind *mode;
    page_step step;
    mask live, moved, stops, is_shifted; /* moved: time has passed since the mode began */
    real time, time_rest, until, steps, last_step, next_sample, longest;
    real *x, *rates;      /* states that change, and their rates */
    real *dx, *d, *shift; /* indexed by seed: variations of these states and of the constants */
    int d_stride;         /* distance from seed to seed in `d` */
    run_state *runs[LANES];
} page_lanes;

/* Lanes that a step ends in, by what ends it: coefficients overflow, no step has a finite result, the run
 * stops or arrives, an event is taken (`shifts`: variations are moved onto its guard), the step limit is
 * reached. All others go on. */
typedef struct {
    mask goes, overflows, fails, stops, arrives, takes, shifts, is_late;
} lane_ends;

/* ---- memory -------------------------------------------------------------------------------------------- */

/* The largest number of series of moving states in any mode. Variations have no other series. */
static inline size_t most_moving(const tdmf_model_kind *model) {
    int most = 0;
    for (int mode = 0; mode < model->mode_count; ++mode) {
        const tdmf_motion_kind *m = model->modes[mode].motion;
        most = m->moving_count + m->extra_count > most ? m->moving_count + m->extra_count : most;
    }
    return (size_t)most;
}

/* Upper bound on the number of states that change in a mode. */
static inline size_t most_changing(const tdmf_model_kind *model) {
    return most_moving(model) + TDMF_WATCH_LIMIT;
}

static inline size_t reals_of_room(const tdmf_model_kind *model, int seed_count) {
    return ((size_t)model->series_count + most_moving(model)) * TERMS +
           (3 + (size_t)seed_count) * most_changing(model);
}

/* Places the arrays of a room. Returns the memory behind them. */
static inline real *place_room(lane_room *room, real *memory) {
    const size_t changing = most_changing(room->model);
    room->s = (void *)memory;
    room->t = room->s + room->model->series_count;
    room->x_within = (real *)(room->t + most_moving(room->model));
    room->dx_within = room->x_within + changing;
    room->after = room->dx_within + changing;
    room->d_after = room->after + changing;
    room->mode_of_series = NULL;
    return room->d_after + (size_t)room->seed_count * changing;
}

/* Numbers that the lanes of a mode need. The driver, which has one lane, reads constants and their variations
 * from the mode's start. */
static inline size_t reals_of_mode(const tdmf_mode_kind *mode, int seed_count, tdmf_observation observes) {
    const tdmf_motion_kind *m = mode->motion;
    const size_t changing = (size_t)m->moving_count + (size_t)tdmf_observed_count(mode, observes);
    const size_t constants = LANES > 1 ? (size_t)m->constant_count : 0, seeds = (size_t)seed_count;
    return 3 * changing + constants + seeds * (changing + constants + 1);
}

/* Prepares lanes for a mode, whose motion is one of their width. */
static inline void open_lanes(page_lanes *b, lane_room *room, const tdmf_mode_kind *mode,
                              const tdmf_motion_kind *motion, real *memory) {
    page_step *step = &b->step;
    b->room = room;
    b->mode = mode;
    step->motion = motion;
    step->kinds = mode->guards;
    step->watches = mode->watches;
    step->guard_count = mode->guard_count;
    step->observed_count = tdmf_observed_count(mode, room->observes);
    step->tolerance = room->tolerance;
    step->s = room->s;
    step->observed = room->observed;
    step->watched = (((uint64_t)1 << step->observed_count) - 1) << step->guard_count;
    const int count = changing_count(step);
    for (int i = 0; i < step->observed_count; ++i) {
        int first = 0;
        while (step->watches[first].into != step->watches[i].into) {
            ++first;
        }
        step->places[i] = motion->moving_count + first;
    }
    step->units = memory;
    b->x = step->units + count;
    b->rates = b->x + count;
    b->dx = b->rates + count;
    b->shift = b->dx + room->seed_count * count;
    step->c = b->shift + room->seed_count;
    b->d = step->c + motion->constant_count;
    b->d_stride = motion->constant_count;
}

/* ---- in and out ---------------------------------------------------------------------------------------- */

/* Loads a run whose mode `at` holds into a lane. */
static inline void load_run(page_lanes *b, int lane, run_state *state, const mode_start *at, double until) {
    const tdmf_page_run *r = state->r;
    const tdmf_model_kind *model = state->model;
    page_step *step = &b->step;
    const int count = changing_count(step);
    const int constant_count = LANES > 1 ? step->motion->constant_count : 0;
    set_mask(&step->begins, lane, at->begins);
    step->looks = step->rises = true;
    for (int i = 0; i < step->guard_count; ++i) {
        const guard_start *guard = &at->guards[i];
        step->watched |= (uint64_t)(guard->flags & IS_WATCHED) << i;
        set_flags(&step->guards[i].flags, lane, guard->flags & ~RISES);
        set_lane(&step->guards[i].scale, lane, guard->scale);
    }
    for (int i = 0; i < constant_count; ++i) {
        set_lane(&step->c[i], lane, at->c[i]);
    }
    for (int i = 0; i < count; ++i) {
        const int of = changing_state(step, i);
        set_lane(&step->units[i], lane, state->scales[of]);
        set_lane(&b->x[i], lane, r->x[of]);
    }
    for (int seed = 0; seed < r->seed_count; ++seed) {
        const double *dx = r->dx + seed * model->state_count, *d = at->d + seed * model->constant_count;
        set_lane(&b->shift[seed], lane, r->shift[seed]);
        for (int i = 0; i < count; ++i) {
            set_lane(&b->dx[seed * count + i], lane, dx[changing_state(step, i)]);
        }
        for (int i = 0; i < constant_count; ++i) {
            set_lane(&b->d[seed * b->d_stride + i], lane, d[i]);
        }
    }
    b->runs[lane] = state;
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

/* Copies the changing states of a lane, or their variations along a seed, to those of its run. */
static inline void unload_states(const page_lanes *b, int lane, const real *changing, double *x) {
    const page_step *step = &b->step;
    const int moving_count = step->motion->moving_count;
    for (int i = 0; i < moving_count; ++i) {
        x[step->motion->moving[i]] = lane_of(&changing[i], lane);
    }
    for (int i = 0; i < step->observed_count; ++i) {
        x[step->watches[i].into] = lane_of(&changing[step->places[i]], lane);
    }
}

static inline void unload_all_states(const page_lanes *b, int lane) {
    tdmf_page_run *r = b->runs[lane]->r;
    unload_states(b, lane, b->x, r->x);
    for (int seed = 0; seed < r->seed_count; ++seed) {
        const real *dx = b->dx + seed * changing_count(&b->step);
        unload_states(b, lane, dx, r->dx + seed * b->room->model->state_count);
    }
}

/* Copies the numbers of a lane to its run. */
static inline void unload_run(const page_lanes *b, int lane) {
    tdmf_page_run *r = b->runs[lane]->r;
    unload_all_states(b, lane);
    b->runs[lane]->reach = lane_of(&b->step.reach, lane);
    r->time = lane_of(&b->time, lane);
    r->time_rest = lane_of(&b->time_rest, lane);
    r->steps = (long)lane_of(&b->steps, lane);
    r->is_shifted = has_lane(&b->is_shifted, lane);
    if (has_lane(&b->moved, lane)) {
        r->chain = 0;
        r->taken = 0;
    }
}

/* Copies what a lane has found of its guards. */
static inline void keep_guards(const page_lanes *b, int lane, mode_start *at) {
    for (int i = 0; i < b->step.guard_count; ++i) {
        at->guards[i].flags = flags_of(&b->step.guards[i].flags, lane);
    }
}

/* Copies what load_run has loaded of the mode, but for the flags of its guards, see keep_guards. */
static inline void unload_mode(const page_lanes *b, int lane, mode_start *at) {
    const page_step *step = &b->step;
    const int constant_count = step->motion->constant_count;
    at->begins = has_lane(&step->begins, lane);
    for (int i = 0; i < step->guard_count; ++i) {
        at->guards[i].scale = lane_of(&step->guards[i].scale, lane);
    }
    for (int i = 0; i < constant_count; ++i) {
        at->c[i] = lane_of(&step->c[i], lane);
        for (int seed = 0; seed < b->room->seed_count; ++seed) {
            double *d = at->d + seed * b->room->model->constant_count;
            d[i] = lane_of(&b->d[seed * b->d_stride + i], lane);
        }
    }
}

/* ---- variations ---------------------------------------------------------------------------------------- */

/* Moves variations from the guard of the last event back to a fixed time. */
static inline void shift_back(page_lanes *b, mask lanes) {
    const int seed_count = b->room->seed_count, count = changing_count(&b->step);
    for (int i = 0; i < count && seed_count > 0 && any(lanes); ++i) {
        const real rate = rate_after_event(&b->step, i, lanes);
        for (int seed = 0; seed < seed_count; ++seed) {
            real *dx = &b->dx[seed * count + changing_place(&b->step, i)];
            *dx = select(lanes, *dx - rate * b->shift[seed], *dx);
        }
    }
    b->is_shifted &= mask_not(lanes);
}

/* Expands the variations of a seed and, of one run, of the next seed, too. Returns how many. */
static inline int vary_seeds(const page_lanes *b, int seed) {
    lane_room *room = b->room;
    const page_step *step = &b->step;
    const tdmf_motion_kind *m = step->motion;
    const real *dx = b->dx + seed * changing_count(step), *d = b->d + seed * b->d_stride;
    if (LANES == 1 && room->two_seeds.memory && seed + 1 < room->seed_count) {
        const tdmf_seed_kind *seeds = room->model->seeds;
        const int mode = (int)(b->mode - room->model->modes);
        const void *const both_d[2] = {d, d + b->d_stride};
        const void *const both[2] = {dx, dx + changing_count(step)};
        if (!room->two_seeds_are_filled) {
            seeds->fill(seeds->motions, mode, &room->two_seeds, step->c, step->s, step->order);
            room->two_seeds_are_filled = true;
        }
        seeds->vary(seeds->motions, mode, &room->two_seeds, both_d, both, step->order);
        return 2;
    }
    for (int i = 0; i < m->moving_count; ++i) {
        room->t[i][0] = dx[i];
    }
    m->vary(step->c, step->s[0], d, step->order, room->t[0]);
    return 1;
}

/* Reads the variations of the first or second of so many seeds that were expanded. */
static inline void read_seed(const page_lanes *b, int number, int count) {
    if (count > 1) {
        const tdmf_seed_kind *seeds = b->room->model->seeds;
        const int mode = (int)(b->mode - b->room->model->modes);
        seeds->read(seeds->motions, mode, &b->room->two_seeds, number, b->step.order, b->room->t);
    }
}

/* Goes on with variations that were expanded, from those at the beginning of the step. `after_event`: lanes
 * whose step begins at an event, whose time varies. */
static inline void advance_variation(const page_lanes *b, int seed, mask goes, mask after_event, real *dx) {
    const page_step *step = &b->step;
    const tdmf_motion_kind *m = step->motion;
    const int count = changing_count(step);
    const real *d = b->d + seed * b->d_stride;
    const real shift = select(after_event, b->shift[seed], broadcast(0.0));
    memcpy(dx, b->dx + seed * count, (size_t)count * sizeof *dx);
    for (int i = 0; i < step->observed_count; ++i) {
        real *varied = &dx[step->places[i]];
        *varied = observed_variation(step, i, d, b->room->t, shift, *varied);
    }
    for (int i = 0; i < m->moving_count; ++i) {
        dx[i] = select(goes, sum_of(b->room->t[i], step->power, step->order), dx[i]);
    }
}

/* ---- samples ------------------------------------------------------------------------------------------- */

/* Makes the samples that are due at the beginning of a step. */
static inline void sample_here(page_lanes *b, mask lanes) {
    lanes &= b->next_sample <= b->time;
    for (int lane = 0; lane < LANES && any(lanes); ++lane) {
        if (has_lane(&lanes, lane)) {
            tdmf_page_run *r = b->runs[lane]->r;
            r->time = lane_of(&b->time, lane);
            unload_all_states(b, lane);
            tdmf_sample_here(b->room->model, r);
            set_lane(&b->next_sample, lane, tdmf_next_sample(r));
        }
    }
}

/* Writes the states of what is observed up to the time whose powers are set. */
static inline void observe_all(page_lanes *b, real elapsed, mask lanes, real *x) {
    page_step *step = &b->step;
    const int moving_count = step->motion->moving_count;
    for (int i = moving_count; i < changing_count(step); ++i) {
        x[i] = b->x[i];
    }
    for (int i = 0; i < step->observed_count; ++i) {
        real *value = &x[step->places[i]];
        *value = observe(step, i, *value, lanes & (elapsed > 0.0));
    }
}

/* Finds the changing states at times within the step, which it sets the powers of. */
static inline void find_states_within(page_lanes *b, real elapsed, mask lanes) {
    page_step *step = &b->step;
    set_power_pairs(step->power, elapsed, step->order);
    observe_all(b, elapsed, lanes, b->room->x_within);
    for (int i = 0; i < step->motion->moving_count; ++i) {
        b->room->x_within[i] = value_at_end(step, i);
    }
}

/* Copies a sampled lane's states to its run's, which the end of the step overwrites. */
static inline tdmf_page_run *sampled_run(const page_lanes *b, int lane) {
    tdmf_page_run *r = b->runs[lane]->r;
    unload_states(b, lane, b->room->x_within, r->x);
    return r;
}

/* The variations along a seed of the samples that a step has made since the first ones. */
static inline void vary_samples(page_lanes *b, int seed, const int first[LANES], mask lanes,
                                mask after_event) {
    lane_room *room = b->room;
    for (int more = 0; any(lanes); ++more) {
        real elapsed = broadcast(0.0);
        for (int lane = 0; lane < LANES; ++lane) {
            const tdmf_page_run *r = has_lane(&lanes, lane) ? b->runs[lane]->r : NULL;
            if (r && first[lane] + more < r->sampled && r->d_samples) {
                const double time = r->sample_times[first[lane] + more];
                set_lane(&elapsed, lane, time - lane_of(&b->time, lane));
            } else {
                set_mask(&lanes, lane, false);
            }
        }
        find_states_within(b, elapsed, lanes);
        advance_variation(b, seed, lanes, after_event, room->dx_within);
        for (int lane = 0; lane < LANES; ++lane) {
            if (has_lane(&lanes, lane)) {
                tdmf_page_run *r = sampled_run(b, lane);
                double *dx = r->dx + seed * room->model->state_count;
                unload_states(b, lane, room->dx_within, dx);
                tdmf_vary_sample(room->model, r, first[lane] + more, seed, r->x, dx);
            }
        }
    }
}

/* Makes the samples within steps that last for `elapsed`, before the runs are advanced. */
static inline void sample_within(page_lanes *b, real elapsed, mask goes, mask after_event) {
    const mask sampled = goes & (b->next_sample - b->time < elapsed);
    const int seed_count = b->room->seed_count;
    int first[LANES] = {0};
    if (!any(sampled)) {
        return;
    }
    for (int lane = 0; lane < LANES; ++lane) {
        first[lane] = has_lane(&sampled, lane) ? b->runs[lane]->r->sampled : 0;
    }
    for (mask lanes = sampled; any(lanes); lanes &= b->next_sample - b->time < elapsed) {
        find_states_within(b, b->next_sample - b->time, lanes);
        for (int lane = 0; lane < LANES; ++lane) {
            if (has_lane(&lanes, lane)) {
                tdmf_page_run *r = sampled_run(b, lane);
                tdmf_write_sample(b->room->model, r, r->sampled++, r->x);
                set_lane(&b->next_sample, lane, tdmf_next_sample(r));
            }
        }
    }
    for (int seed = 0, count = 0; seed < seed_count; seed += count) {
        count = vary_seeds(b, seed);
        for (int own = 0; own < count; ++own) {
            read_seed(b, own, count);
            vary_samples(b, seed + own, first, sampled, after_event);
        }
    }
    set_power_pairs(b->step.power, elapsed, b->step.order);
}

/* ---- a step -------------------------------------------------------------------------------------------- */

/* Expands the series of all lanes. Returns the lanes whose coefficients are finite; of one run, with as many
 * terms as are. */
static inline mask expand_lanes(page_lanes *b, series_remainder *remainder) {
    lane_room *room = b->room;
    page_step *step = &b->step;
    step->order = room->order;
    if (room->mode_of_series != b->mode) {
        room->mode_of_series = b->mode;
        clear_polynomials(step);
    }
    for (int i = 0; i < step->motion->moving_count; ++i) {
        step->s[i][0] = b->x[i];
    }
    room->two_seeds_are_filled = false;
    step->motion->expand(step->c, step->order, step->s[0]);
    mask is_finite = judge_series(step, remainder);
    while (LANES == 1 && !any(is_finite) && tdmf_is_order(step->order - 2)) {
        step->order -= 2;
        is_finite = judge_series(step, remainder);
    }
    return is_finite;
}

/* The longest step that a law allows whose series does not show it. */
static inline real longest_step(const page_lanes *b) {
    const tdmf_motion_kind *m = b->step.motion;
    real longest = broadcast(INFINITY);
    for (int lane = 0; lane < LANES && b->mode->time_scale; ++lane) {
        if (has_lane(&b->live, lane)) {
            const tdmf_page_run *r = b->runs[lane]->r;
            for (int i = 0; i < m->moving_count; ++i) {
                r->x[m->moving[i]] = lane_of(&b->x[i], lane);
            }
            set_lane(&longest, lane, tdmf_longest_step_of_law(b->mode, r->p, r->x));
        }
    }
    return longest;
}

/* Expands the series, chooses a step that can be trusted, and finds its first event. */
static inline lane_ends begin_step(page_lanes *b) {
    page_step *step = &b->step;
    lane_ends ends;
    series_remainder remainder;
    ends.overflows = b->live & mask_not(expand_lanes(b, &remainder));
    b->longest = longest_step(b);
    const real left = b->until - b->time - b->time_rest;
    choose_size(step, &remainder, b->longest, real_max(left, broadcast(0.0)));
    ends.fails = b->live & mask_not(ends.overflows | (step->size >= 0.0));
    ends.arrives = ends.takes = ends.shifts = ends.is_late = mask_of(false);
    const mask searched = b->live & mask_not(ends.overflows | ends.fails);
    search_events(step, searched);
    ends.stops = searched & b->stops & mask_not(step->is_due);
    ends.goes = searched & mask_not(step->is_due | ends.stops);
    return ends;
}

/* Adds to the time and keeps the rounding error, as tdmf_pass_time does. */
static inline void pass_time(page_lanes *b, real elapsed, real left, mask goes) {
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
static inline bool find_variations(page_lanes *b, real elapsed, mask goes, mask after_event) {
    lane_room *room = b->room;
    observe_all(b, elapsed, goes, room->after);
    for (int seed = 0, count = 0; seed < room->seed_count; seed += count) {
        count = vary_seeds(b, seed);
        for (int own = 0; own < count; ++own) {
            read_seed(b, own, count);
            if (any(trust_variation(&b->step, room->t, goes))) {
                return false;
            }
            real *dx = room->d_after + (seed + own) * changing_count(&b->step);
            advance_variation(b, seed + own, goes, after_event, dx);
        }
    }
    return true;
}

/* Advances the lanes that go to the end of the step. */
static inline void advance(page_lanes *b, real left, mask goes, mask after_event) {
    lane_room *room = b->room;
    page_step *step = &b->step;
    const int moving_count = step->motion->moving_count, count = changing_count(step);
    real elapsed;
    for (int i = 0; i < step->observed_count; ++i) {
        trust_observed(step, i, b->x[step->places[i]], goes);
    }
    do {
        elapsed = end_step(step);
    } while (!find_variations(b, elapsed, goes, after_event));
    sample_within(b, elapsed, goes, after_event);
    for (int i = 0; i < moving_count; ++i) {
        b->x[i] = select(goes, value_at_end(step, i), b->x[i]);
    }
    for (int i = moving_count; i < count; ++i) {
        b->x[i] = room->after[i];
    }
    if (room->seed_count > 0) {
        memcpy(b->dx, room->d_after, (size_t)(room->seed_count * count) * sizeof *b->dx);
    }
    pass_time(b, elapsed, left, goes);
    step->begins &= mask_not(goes);
}

/* Finds the rates of lanes at their event. */
static inline void find_rates(page_lanes *b, mask lanes) {
    page_step *step = &b->step;
    set_power_pairs(step->power, select(step->is_due, broadcast(0.0), step->power[1]), step->order);
    for (int i = 0; i < changing_count(step); ++i) {
        b->rates[i] = rate_before_event(step, i, b->x[changing_place(step, i)], lanes);
    }
}

/* Makes the step that was begun, in the lanes that go, up to its first event. */
static inline void finish_step(page_lanes *b, lane_ends *ends) {
    page_step *step = &b->step;
    const real left = b->until - b->time - b->time_rest;
    mask goes = ends->goes;
    const mask after_event = goes & b->is_shifted;
    shift_back(b, after_event);
    sample_here(b, goes);
    ends->arrives = goes & mask_not(left > 0.0);
    goes &= mask_not(ends->arrives);
    const mask is_limited = goes & (step->reach == b->longest);
    for (int lane = 0; lane < LANES && b->mode->time_scale; ++lane) {
        if (has_lane(&is_limited, lane)) {
            ++b->runs[lane]->r->limited_steps;
        }
    }
    if (any(goes)) {
        advance(b, left, goes, after_event);
    }
    mask reaches = goes & (step->end <= 1.0) & (step->first != integer_of(NO_EVENT));
    reaches &= mask_not(looks_again(step, reaches));
    ends->is_late = goes & mask_not(reaches) & (b->steps >= b->last_step);
    ends->takes = step->is_due | reaches;
    const mask varies_at_once = step->is_due & step->is_reached;
    shift_back(b, varies_at_once & b->is_shifted);
    ends->shifts = mask_not(b->is_shifted) & (reaches | varies_at_once);
    if (b->room->seed_count > 0 && any(ends->shifts)) {
        find_rates(b, ends->shifts);
    }
}

/* Takes the event in which the step of a lane has ended. The lane's run is unloaded, and `at` has its guards.
 * Returns whether the run may go on. */
static inline bool take_event(const page_lanes *b, int lane, const lane_ends *ends, run_state *state,
                              mode_start *at) {
    const tdmf_guard_kind *kind = &b->mode->guards[flags_of(&b->step.first, lane)];
    if (b->room->seed_count > 0 && has_lane(&ends->shifts, lane)) {
        memset(at->rates, 0, (size_t)state->model->state_count * sizeof *at->rates);
        for (int i = 0; i < changing_count(&b->step); ++i) {
            at->rates[changing_state(&b->step, i)] += lane_of(&b->rates[i], lane);
        }
        tdmf_shift_to_event(state, kind, at);
    }
    return tdmf_take_event(state, kind, at);
}

#endif
