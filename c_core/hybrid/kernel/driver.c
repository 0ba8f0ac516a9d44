/* Runs a page: Taylor steps, the first event of any guard, chains of events in zero time, saltation.
 *
 * A step is as long as its series can be trusted. Each guard is a polynomial in the step, and the first root
 * of any ends it. A guard that is below zero where a mode begins is due at once, in the page's order.
 *
 * With guard g, reset R and rates f- and f+ before and after, a variation dx passes an event by
 *
 *     dt = -(g_x dx + g_p dp)/(g_x f-),      dx+ = R_x (dx + f- dt) + R_p dp - f+ dt,
 *
 * and resets that follow in zero time, which inequalities decide, shift with the first one. A step is in
 * page_step.h and observed.h, where a mode begins and events are in run_state.h.
 */
#include "driver.h"

#include "observed.h"
#include "run_state.h"

#include <stdio.h>

/* `state` and `at` are those of the run at hand. */
struct tdmf_driver {
    run_state *state;
    mode_start *at;
    page_step step;
    observed_part observed[TDMF_WATCH_LIMIT];
    double (*t)[TERMS];    /* variations of the moving series along a seed */
    tdmf_seed_lanes lanes; /* their memory is NULL where one seed is varied after the other */
    bool fills_lanes;      /* they hold the constants and the series of the step */
    const tdmf_mode_kind *mode;
    bool is_limited;     /* the step, by the time scale of the mode */
    bool is_after_event; /* the step begins at an event, whose time varies by `shift` */
};

typedef tdmf_driver work;

static double *seed_dx(const work *w, int seed) {
    return w->state->r->dx + seed * w->state->model->state_count;
}

/* ---- the step ------------------------------------------------------------------------------------------ */

static void load(work *w) {
    w->mode = &w->state->model->modes[w->state->r->mode];
    w->step.motion = w->mode->motion;
    w->step.kinds = w->mode->guards;
    w->step.watches = w->mode->watches;
    w->step.guard_count = w->mode->guard_count;
    w->step.observed_count = tdmf_observed_count(w->mode, w->state->r->observes);
    w->step.tolerance = w->state->r->tolerance;
    w->step.c = w->at->c;
    w->step.watched = 0;
    load_mode(&w->step, 0, w->at, w->state->scales);
    clear_polynomials(&w->step);
}

/* Expands the series and chooses a step that can be trusted. Where coefficients overflow, the series has
 * fewer terms. False where no step has a finite result. */
static bool begin_step(work *w, double left) {
    const tdmf_motion_kind *m = w->step.motion;
    series_remainder remainder;
    for (int i = 0; i < m->moving_count; ++i) {
        w->step.s[i][0] = w->state->r->x[m->moving[i]];
    }
    w->step.order = w->state->r->order;
    w->fills_lanes = false;
    m->expand(w->step.c, w->step.order, w->step.s[0]);
    while (!judge_series(&w->step, &remainder)) {
        w->step.order -= 2;
        if (!tdmf_is_order(w->step.order)) {
            return false;
        }
    }
    const double longest = tdmf_longest_step_of_law(w->mode, w->state->r->p, w->state->r->x);
    choose_size(&w->step, &remainder, longest, left);
    w->state->reach = w->step.reach;
    w->is_limited = w->step.reach == longest;
    return w->step.size >= 0.0;
}

/* ---- going on ------------------------------------------------------------------------------------------ */

static void trust_all_observed(work *w) {
    for (int i = 0; i < w->step.observed_count; ++i) {
        trust_observed(&w->step, i, w->state->r->x[w->mode->watches[i].into], true);
    }
}

/* Goes on with the states of observed quantities. */
static void observe_all(work *w, double *x) {
    for (int i = 0; i < w->step.observed_count; ++i) {
        double *value = &x[w->mode->watches[i].into];
        *value = observe(&w->step, i, *value, w->step.power[1] > 0.0);
    }
}

/* Goes on with the moving states from the beginning of the step to the time whose powers are set. */
static void advance_states(const work *w, double *x) {
    const tdmf_motion_kind *m = w->step.motion;
    for (int i = 0; i < m->moving_count; ++i) {
        x[m->moving[i]] = value_at_end(&w->step, i);
    }
}

static const double *seed_d(const work *w, int seed) {
    return w->at->d + seed * w->state->model->constant_count;
}

/* Expands the variations of a seed and, where there are lanes, of the next one. Returns how many. */
static int vary(work *w, int seed) {
    const tdmf_motion_kind *m = w->step.motion;
    const tdmf_page_run *r = w->state->r;
    const double *dx = seed_dx(w, seed);
    if (w->lanes.memory && seed + 1 < r->seed_count) {
        const tdmf_seed_kind *seeds = w->state->model->seeds;
        const double *const d[2] = {seed_d(w, seed), seed_d(w, seed + 1)};
        const double *const both[2] = {dx, seed_dx(w, seed + 1)};
        if (!w->fills_lanes) {
            seeds->fill(seeds->motions, r->mode, &w->lanes, w->step.c, w->step.s, w->step.order);
            w->fills_lanes = true;
        }
        seeds->vary(seeds->motions, r->mode, &w->lanes, d, both, w->step.order);
        return 2;
    }
    for (int i = 0; i < m->moving_count; ++i) {
        w->t[i][0] = dx[m->moving[i]];
    }
    m->vary(w->step.c, w->step.s[0], seed_d(w, seed), w->step.order, w->t[0]);
    return 1;
}

/* Reads the variations of the first or second of so many seeds that were expanded. */
static void read_variation(const work *w, int number, int count) {
    const tdmf_seed_kind *seeds = w->state->model->seeds;
    if (count > 1) {
        seeds->read(seeds->motions, w->state->r->mode, &w->lanes, number, w->step.order, w->t);
    }
}

/* Goes on with the variations of a seed. */
static void advance_variation(const work *w, int seed, double *dx) {
    const tdmf_motion_kind *m = w->step.motion;
    const double *d = seed_d(w, seed);
    const double shift = w->is_after_event ? w->state->r->shift[seed] : 0.0;
    for (int i = 0; i < w->step.observed_count; ++i) {
        double *varied = &dx[w->mode->watches[i].into];
        *varied = observed_variation(&w->step, i, d, w->t, shift, *varied);
    }
    for (int i = 0; i < m->moving_count; ++i) {
        dx[m->moving[i]] = sum_of(w->t[i], w->step.power, w->step.order);
    }
}

/* ---- samples ------------------------------------------------------------------------------------------- */

/* Writes the states at a time within the step, whose powers it sets. */
static void states_within(work *w, double elapsed, double *x) {
    set_power_pairs(w->step.power, elapsed, w->step.order);
    memcpy(x, w->state->r->x, (size_t)w->state->model->state_count * sizeof *x);
    observe_all(w, x);
    advance_states(w, x);
}

/* Makes the samples within a step that lasts for `elapsed`, before the run is advanced. */
static void sample_within(work *w, double elapsed) {
    tdmf_page_run *r = w->state->r;
    const tdmf_model_kind *model = w->state->model;
    double *x = w->at->room, *dx = w->at->rates;
    const int first = r->sampled;
    while (tdmf_next_sample(r) - r->time < elapsed) {
        states_within(w, tdmf_next_sample(r) - r->time, x);
        tdmf_write_sample(model, r, r->sampled++, x);
    }
    for (int seed = 0, count = 0; seed < r->seed_count && r->d_samples && r->sampled > first; seed += count) {
        count = vary(w, seed);
        for (int i = 0; i < count * (r->sampled - first); ++i) {
            const int sample = first + i / count, own = i % count;
            read_variation(w, own, count);
            states_within(w, r->sample_times[sample] - r->time, x);
            memcpy(dx, seed_dx(w, seed + own), (size_t)model->state_count * sizeof *dx);
            advance_variation(w, seed + own, dx);
            tdmf_vary_sample(model, r, sample, seed + own, x, dx);
        }
    }
    if (r->sampled > first) {
        set_power_pairs(w->step.power, elapsed, w->step.order);
    }
}

/* ---- its end ------------------------------------------------------------------------------------------- */

/* Finds what is observed up to the end of the step, and the variations there. False where these cannot be
 * trusted so far: then the step is shorter. */
static bool find_variations(work *w) {
    tdmf_page_run *r = w->state->r;
    const int states = w->state->model->state_count;
    for (int i = 0; i < w->step.observed_count; ++i) {
        const int into = w->mode->watches[i].into;
        w->at->after[into] = r->x[into];
    }
    observe_all(w, w->at->after);
    for (int seed = 0, count = 0; seed < r->seed_count; seed += count) {
        count = vary(w, seed);
        for (int own = 0; own < count; ++own) {
            double *dx = w->at->d_after + (seed + own) * states;
            read_variation(w, own, count);
            if (trust_variation(&w->step, w->t, true)) {
                return false;
            }
            memcpy(dx, seed_dx(w, seed + own), (size_t)states * sizeof *dx);
            advance_variation(w, seed + own, dx);
        }
    }
    return true;
}

/* Advances the run to the end of the step. */
static void advance(work *w) {
    tdmf_page_run *r = w->state->r;
    double elapsed;
    trust_all_observed(w);
    do {
        elapsed = end_step(&w->step);
    } while (!find_variations(w));
    sample_within(w, elapsed);
    for (int i = 0; i < w->step.observed_count; ++i) {
        const int into = w->mode->watches[i].into;
        r->x[into] = w->at->after[into];
    }
    advance_states(w, r->x);
    if (r->seed_count > 0) {
        const size_t variations = (size_t)r->seed_count * (size_t)w->state->model->state_count;
        memcpy(r->dx, w->at->d_after, variations * sizeof *r->dx);
    }
    tdmf_pass_time(r, elapsed);
    ++r->steps;
    r->limited_steps += w->is_limited;
    w->step.begins = false;
}

/* Moves the variations onto the guard of an event at the end of the step. */
static void shift_to_event(work *w, const tdmf_guard_kind *kind) {
    memset(w->at->rates, 0, (size_t)w->state->model->state_count * sizeof *w->at->rates);
    for (int i = 0; i < changing_count(&w->step); ++i) {
        const int of = changing_state(&w->step, i);
        w->at->rates[of] += rate_before_event(&w->step, i, w->state->r->x[of], true);
    }
    tdmf_shift_to_event(w->state, kind, w->at);
}

/* Moves the variations back to a fixed time, along the rates after the event. */
static void shift_back(work *w) {
    for (int i = 0; i < changing_count(&w->step); ++i) {
        const int of = changing_state(&w->step, i);
        const double rate = rate_after_event(&w->step, i, true);
        for (int seed = 0; seed < w->state->r->seed_count; ++seed) {
            seed_dx(w, seed)[of] -= rate * w->state->r->shift[seed];
        }
    }
    w->state->r->is_shifted = false;
}

/* Raises largest values to those of an instant after an event. */
static void observe_instant(work *w) {
    tdmf_page_run *r = w->state->r;
    for (int i = 0; i < w->step.observed_count; ++i) {
        const int into = w->mode->watches[i].into;
        const double now = is_largest(&w->step, i) ? expanded(&w->step, i)[0] : r->x[into];
        const bool is_raised = now > r->x[into] + zero_margin * scale_of_observed(&w->step, i);
        w->step.observed[i].share = is_raised ? 0.0 : -1.0;
        for (int seed = 0; seed < r->seed_count && is_raised; ++seed) {
            double *varied = &seed_dx(w, seed)[into];
            read_variation(w, 0, vary(w, seed));
            *varied = observed_variation(&w->step, i, seed_d(w, seed), w->t, r->shift[seed], *varied);
        }
        r->x[into] = real_max(now, r->x[into]);
    }
}

/* ---- the run ------------------------------------------------------------------------------------------- */

void tdmf_leave_guard(tdmf_driver *w, run_state *state, mode_start *at) {
    w->state = state;
    w->at = at;
    load(w);
    if (state->r->is_shifted && begin_step(w, 0.0)) {
        search_events(&w->step, true);
        shift_back(w);
        observe_instant(w);
    }
}

/* Goes on in a mode up to the next event, and takes it. */
static tdmf_run_outcome to_event(work *w, double until) {
    tdmf_page_run *r = w->state->r;
    if (w->mode->ends) {
        tdmf_sample_here(w->state->model, r);
        return TDMF_RUN_ENDED;
    }
    while (r->steps < w->state->last_step) {
        const double left = until - r->time - r->time_rest;
        if (!begin_step(w, real_max(left, 0.0))) {
            return TDMF_RUN_NO_PROGRESS;
        }
        search_events(&w->step, true);
        const bool is_due = w->step.is_due;
        if (!is_due) {
            if (w->state->stops) {
                return TDMF_RUN_STOPPED;
            }
            w->is_after_event = r->is_shifted;
            if (r->is_shifted) {
                shift_back(w);
            }
            tdmf_sample_here(w->state->model, r);
            if (!(left > 0.0)) {
                return TDMF_RUN_ARRIVED;
            }
            advance(w);
            if (w->step.end > 1.0 && w->step.size == left) {
                r->time = until;
                r->time_rest = 0.0;
            }
            const bool reaches = w->step.end <= 1.0 && w->step.first != NO_EVENT;
            if (looks_again(&w->step, reaches) || !reaches) {
                continue;
            }
        }
        const tdmf_guard_kind *kind = &w->mode->guards[w->step.first];
        if (r->seed_count > 0 && (is_due ? w->step.is_reached : !r->is_shifted)) {
            if (r->is_shifted) {
                shift_back(w);
            }
            set_power_pairs(w->step.power, is_due ? 0.0 : w->step.power[1], w->step.order);
            shift_to_event(w, kind);
        }
        keep_guards(&w->step, 0, w->at);
        const bool may_go_on = tdmf_take_event(w->state, kind, w->at);
        tdmf_begin_mode(w->state, w->at);
        return may_go_on ? TDMF_RUN_GOES_ON : tdmf_limit_reached(w->state);
    }
    return TDMF_RUN_TOO_MANY_STEPS;
}

/* Numbers of memory that hold a driver. */
static const size_t driver_size = (sizeof(tdmf_driver) + sizeof(double) - 1) / sizeof(double);

/* The largest number of series of moving states in any mode. Variations have no other series. */
static size_t most_moving(const tdmf_model_kind *model) {
    int most = 0;
    for (int mode = 0; mode < model->mode_count; ++mode) {
        const tdmf_motion_kind *m = model->modes[mode].motion;
        most = m->moving_count + m->extra_count > most ? m->moving_count + m->extra_count : most;
    }
    return (size_t)most;
}

/* Numbers for the constants and series of two lanes, which are aligned, and for their variations. */
static size_t size_of_seed_lanes(const tdmf_model_kind *model, int seed_count) {
    const size_t constants = (size_t)model->constant_count,
                 series = (size_t)model->series_count + most_moving(model);
    return model->seeds && seed_count > 1 ? 2 * (1 + 2 * constants + series * TERMS) : 0;
}

size_t tdmf_size_of_driver(const tdmf_model_kind *model, int seed_count) {
    const size_t series = (size_t)model->series_count + most_moving(model);
    return driver_size + series * TERMS + (size_t)model->state_count + TDMF_WATCH_LIMIT +
           size_of_seed_lanes(model, seed_count);
}

tdmf_driver *tdmf_place_driver(const tdmf_model_kind *model, int seed_count, double *memory) {
    tdmf_driver *driver = (void *)memory;
    driver->step.s = (void *)(memory + driver_size);
    driver->t = driver->step.s + model->series_count;
    driver->step.units = (double *)(driver->t + most_moving(model));
    driver->step.observed = driver->observed;
    double *next = driver->step.units + model->state_count + TDMF_WATCH_LIMIT;
    driver->lanes.memory = size_of_seed_lanes(model, seed_count) > 0 ? next : NULL;
    driver->lanes.series_count = model->series_count;
    driver->lanes.constant_count = model->constant_count;
    return driver;
}

tdmf_run_outcome tdmf_drive_to_event(tdmf_driver *w, run_state *state, mode_start *at, double until) {
    const long events = state->r->events;
    w->state = state;
    w->at = at;
    load(w);
    const tdmf_run_outcome outcome = to_event(w, until);
    if (state->r->events == events) {
        keep_guards(&w->step, 0, at);
    }
    if (outcome != TDMF_RUN_GOES_ON) {
        tdmf_keep_guards(state, at);
    }
    return outcome;
}

size_t tdmf_run_memory_size(const tdmf_model_kind *model, int seed_count) {
    return tdmf_size_of_mode_start(model, seed_count) + tdmf_size_of_run_state(model) +
           tdmf_size_of_driver(model, seed_count);
}

tdmf_driver *tdmf_begin_in_memory(run_state *state, mode_start *at, const tdmf_model_kind *model,
                                  tdmf_page_run *r) {
    double *of_state = r->memory + tdmf_size_of_mode_start(model, r->seed_count);
    tdmf_place_mode_start(at, model, r->seed_count, r->memory);
    tdmf_begin_run(state, model, r, of_state);
    tdmf_begin_mode(state, at);
    return tdmf_place_driver(model, r->seed_count, of_state + tdmf_size_of_run_state(model));
}

tdmf_run_outcome tdmf_page_run_to(const tdmf_model_kind *model, tdmf_page_run *r, double until) {
    run_state state;
    mode_start at;
    tdmf_run_outcome outcome;
    if (!tdmf_is_order(r->order)) {
        return TDMF_RUN_BAD_ORDER;
    }
    tdmf_driver *driver = tdmf_begin_in_memory(&state, &at, model, r);
    do {
        outcome = tdmf_drive_to_event(driver, &state, &at, until);
    } while (outcome == TDMF_RUN_GOES_ON);
    return outcome;
}

int tdmf_page_order(double tolerance) {
    const double half = 2.0 - 0.75 * log10(tolerance); /* infinite for 0, and NaN below 0 */
    return half >= 0.5 * SERIES_ORDER_LIMIT ? SERIES_ORDER_LIMIT : half >= 4.0 ? 2 * (int)half : 8;
}

tdmf_page_run tdmf_run_default(const tdmf_model_kind *model, double *p, double *x, double *memory) {
    const double tolerance = 1e-11;
    memcpy(p, model->parameter_defaults, (size_t)model->parameter_count * sizeof *p);
    memcpy(x, model->state_defaults, (size_t)model->state_count * sizeof *x);
    const tdmf_page_run run = {.p = p,
                               .x = x,
                               .memory = memory,
                               .tolerance = tolerance,
                               .order = tdmf_page_order(tolerance),
                               .stop_event = -1,
                               .observes = TDMF_OBSERVE_USUAL,
                               .step_limit = 100000,
                               .event_limit = 100000};
    return run;
}

void tdmf_page_set(const tdmf_model_kind *model, tdmf_page_run *r, bool is_state, int index, double value) {
    const size_t size = (size_t)model->state_count * sizeof(double);
    double *after = r->memory;
    for (int i = 0; i < model->set_count; ++i) {
        const tdmf_set_kind *kind = &model->sets[i];
        if (kind->is_state == is_state && kind->index == index && kind->set[r->mode]) {
            memcpy(after, r->x, size);
            kind->set[r->mode](r->p, r->x, value, after);
            memcpy(r->x, after, size);
        }
    }
    *(is_state ? &r->x[index] : &r->p[index]) = value;
}

/* ---- the message --------------------------------------------------------------------------------------- */

static const char *const endings[] = {
    [TDMF_RUN_ARRIVED] = "The run has arrived",
    [TDMF_RUN_STOPPED] = "The run has stopped at the event asked for",
    [TDMF_RUN_ENDED] = "The run has ended",
    [TDMF_RUN_NO_PROGRESS] = "No step, however short, has a finite result",
    [TDMF_RUN_TOO_MANY_STEPS] = "The run takes more steps than its limit",
    [TDMF_RUN_TOO_STIFF] = "The run is too stiff for this solver; CVODE (solver.method = cvode) follows it,",
    [TDMF_RUN_ENDLESS_CHAIN] = "Events whose guards do not rise above 0 are due again and again",
    [TDMF_RUN_TOO_MANY_EVENTS] = "The run has more events than its limit",
    [TDMF_RUN_NO_MEMORY] = "There is no memory for the run",
    [TDMF_RUN_CANCELLED] = "The run was cancelled",
};

void tdmf_run_message(const tdmf_model_kind *model, const tdmf_page_run *r, tdmf_run_outcome outcome,
                      char *text, size_t size) {
    if (outcome == TDMF_RUN_BAD_ORDER) {
        snprintf(text, size, "The order of the series is %d; it has to be even, from %d to %d", r->order,
                 LEAST_ORDER, SERIES_ORDER_LIMIT);
        return;
    }
    if (outcome == TDMF_RUN_TOO_MANY_SEEDS) {
        snprintf(text, size, "The return map has %d seeds; with its coordinates, at most %d are allowed",
                 r->seed_count, TDMF_VARIED_LIMIT);
        return;
    }
    int length = snprintf(text, size, "%s in the mode `%s` at t = %g", endings[outcome],
                          model->mode_names[r->mode], r->time);
    const char *before = ": ";
    for (int i = 0; i < model->event_count && outcome == TDMF_RUN_ENDLESS_CHAIN; ++i) {
        if ((r->taken >> i & 1) != 0 && length >= 0 && (size_t)length < size) {
            length += snprintf(text + length, size - (size_t)length, "%s`%s`", before, model->event_names[i]);
            before = ", ";
        }
    }
}
