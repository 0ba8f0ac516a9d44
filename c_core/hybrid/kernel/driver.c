/* Runs a page: Taylor steps, the first event of any guard, chains of events in zero time, saltation.
 *
 * A step is as long as its series can be trusted. Each guard is a polynomial in the step, and the first root
 * of any ends it. A guard that is below zero where a mode begins is due at once, in the page's order.
 *
 * With guard g, reset R and rates f- and f+ before and after, a variation dx passes an event by
 *
 *     dt = -(g_x dx + g_p dp)/(g_x f-),      dx+ = R_x (dx + f- dt) + R_p dp - f+ dt,
 *
 * and resets that follow in zero time, which inequalities decide, shift with the first one. The step itself
 * is in page_step.h and observed.h.
 */
#include "driver.h"

#include "observed.h"

#include <stdlib.h>

enum { LEAST_ORDER = 4 };

/* The state of a run between steps; its arrays lie in one piece of memory. */
typedef struct {
    const tdmf_model_kind *model;
    const tdmf_mode_kind *mode;
    tdmf_page_run *r;
    page_step step;
    double (*t)[TERMS];          /* variation of the series for one seed */
    double *d;                   /* variations of the constants of the mode, for each seed */
    double *room, *rates, *none; /* arrays of states; `none` holds zeros for parameters that do not vary */
    double *scales, *event_scales;
    double *taken_at; /* by event: when it was last taken */
    int chain;        /* events in zero time so far */
    bool is_shifted;  /* variations are on the guard of the last event */
} work;

static double *seed_dx(const work *w, int seed) {
    return w->r->dx + seed * w->model->state_count;
}

static const double *seed_dp(const work *w, int seed) {
    return w->r->dp + seed * w->model->parameter_count;
}

/* ---- the step ------------------------------------------------------------------------------------------ */

/* Begins a mode: its constants and their variations, and which guards are watched. */
static void open_mode(work *w) {
    const tdmf_page_run *r = w->r;
    const tdmf_mode_kind *mode = w->mode = &w->model->modes[r->mode];
    const tdmf_motion_kind *m = w->step.motion = mode->motion;
    w->step.begins = true;
    w->step.kinds = mode->guards;
    w->step.guard_count = mode->guard_count;
    mode->open(r->p, r->x, w->step.c);
    for (int i = 0; i < mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        const guard_watch watch = {
            .is_watched = !kind->is_watched || kind->is_watched(r->p, r->x) != 0.0,
            .was_taken = w->taken_at[kind->event] == r->time,
            .scale = w->event_scales[kind->event],
        };
        w->step.guards[i] = watch;
    }
    for (int i = 0; i < m->moving_count; ++i) {
        w->step.units[i] = w->scales[m->moving[i]];
    }
    for (int i = 0; i < m->moving_count + m->extra_count; ++i) {
        if (m->degrees[i] < SERIES_ORDER_LIMIT) {
            memset(w->step.s[i], 0, sizeof w->step.s[i]); /* a ramp has no other coefficients */
        }
    }
    for (int seed = 0; seed < r->seed_count; ++seed) {
        mode->vary_open(r->p, r->x, seed_dp(w, seed), seed_dx(w, seed),
                        w->d + seed * w->model->constant_count);
    }
}

/* Expands the series and chooses a step that can be trusted. Where coefficients overflow, the series has
 * fewer terms. False where no step has a finite result. */
static bool begin_step(work *w, double longest) {
    const tdmf_motion_kind *m = w->step.motion;
    series_remainder remainder;
    for (int i = 0; i < m->moving_count; ++i) {
        w->step.s[i][0] = w->r->x[m->moving[i]];
    }
    w->step.order = w->r->order;
    m->expand(w->step.c, w->step.order, w->step.s[0]);
    while (!judge_series(&w->step, &remainder)) {
        w->step.order -= 2;
        if (w->step.order < LEAST_ORDER) {
            return false;
        }
    }
    if (w->mode->time_scale) {
        longest = real_min(longest, most_time_scales * w->mode->time_scale(w->r->p, w->r->x));
    }
    choose_size(&w->step, &remainder, longest);
    return w->step.size >= 0.0;
}

/* ---- going on ------------------------------------------------------------------------------------------ */

static void observe(work *w) {
    for (int i = 0; i < w->mode->watch_count; ++i) {
        const tdmf_watch_kind *kind = &w->mode->watches[i];
        double *value = &w->r->x[kind->into];
        *value = observed_value(&w->step, i, kind->part, *value, w->scales[kind->into], true);
    }
}

static void advance_variations(work *w) {
    const tdmf_motion_kind *m = w->step.motion;
    for (int seed = 0; seed < w->r->seed_count; ++seed) {
        double *dx = seed_dx(w, seed);
        for (int i = 0; i < m->moving_count; ++i) {
            w->t[i][0] = dx[m->moving[i]];
        }
        m->vary(w->step.c, w->step.s[0], w->d + seed * w->model->constant_count, w->step.order, w->t[0]);
        for (int i = 0; i < m->moving_count; ++i) {
            dx[m->moving[i]] = sum_of(w->t[i], w->step.power, w->step.order);
        }
    }
}

/* Advances the run to the end of the step. */
static void advance(work *w) {
    const tdmf_motion_kind *m = w->step.motion;
    const double elapsed = end_step(&w->step);
    advance_variations(w);
    if (w->r->observes) {
        observe(w);
    }
    for (int i = 0; i < m->moving_count; ++i) {
        w->r->x[m->moving[i]] = value_at_end(&w->step, i);
    }
    if (elapsed > 0.0) {
        w->chain = 0;
    }
    w->r->time += elapsed;
    ++w->r->steps;
    w->step.begins = false;
}

/* ---- events -------------------------------------------------------------------------------------------- */

/* Moves the variations onto the guard of an event, along the rates before the event. */
static void shift_to_event(work *w, const tdmf_guard_kind *kind) {
    tdmf_page_run *r = w->r;
    const tdmf_motion_kind *m = w->step.motion;
    memset(w->rates, 0, (size_t)w->model->state_count * sizeof *w->rates);
    for (int i = 0; i < m->moving_count; ++i) {
        w->rates[m->moving[i]] = rate_at_end(&w->step, i);
    }
    const double falls = kind->vary_guard(r->p, r->x, w->none, w->rates);
    for (int seed = 0; seed < r->seed_count; ++seed) {
        double *dx = seed_dx(w, seed);
        r->shift[seed] = -kind->vary_guard(r->p, r->x, seed_dp(w, seed), dx) / falls;
        for (int i = 0; i < w->model->state_count; ++i) {
            dx[i] += w->rates[i] * r->shift[seed];
        }
    }
    w->is_shifted = true;
}

/* Moves the variations back to a fixed time, along the rates after the event. */
static void shift_back(work *w) {
    for (int seed = 0; seed < w->r->seed_count; ++seed) {
        for (int i = 0; i < w->step.motion->moving_count; ++i) {
            seed_dx(w, seed)[w->step.motion->moving[i]] -= w->step.s[i][1] * w->r->shift[seed];
        }
    }
    w->is_shifted = false;
}

void tdmf_page_take(const tdmf_model_kind *model, const tdmf_guard_kind *kind, tdmf_page_run *r,
                    double *room) {
    const tdmf_mode_kind *left = &model->modes[r->mode];
    const size_t size = (size_t)model->state_count * sizeof *room;
    const double counted = kind->is_counted ? 1.0 : 0.0;
    for (int part = left->leave ? 0 : 1; part < 2; ++part) { /* `leave`, then the decision */
        for (int seed = 0; seed < r->seed_count; ++seed) {
            const double *dp = r->dp + seed * model->parameter_count;
            double *dx = r->dx + seed * model->state_count;
            memcpy(room, dx, size);
            if (part == 0) {
                left->vary_leave(r->p, r->x, dp, dx, counted, room);
            } else {
                kind->vary_react(r->p, r->x, dp, dx, room);
            }
            memcpy(dx, room, size);
        }
        memcpy(room, r->x, size);
        if (part == 0) {
            left->leave(r->p, r->x, counted, room);
        } else {
            r->mode = kind->react(r->p, r->x, room, kind->next);
        }
        memcpy(r->x, room, size);
    }
}

/* Takes an event and logs it. */
static void take(work *w, const tdmf_guard_kind *kind) {
    tdmf_page_run *r = w->r;
    const int count = w->model->state_count, before = r->mode;
    if (r->log_count < r->log_size && r->log_states) {
        memcpy(r->log_states + r->log_count * count, r->x, (size_t)count * sizeof *r->x);
    }
    tdmf_page_take(w->model, kind, r, w->room);
    if (r->log_count < r->log_size) {
        const tdmf_event_row row = {r->time, kind->event, before, r->mode};
        r->log[r->log_count++] = row;
    }
    ++r->events;
    ++w->chain;
    r->stuck_event = kind->event;
    w->taken_at[kind->event] = r->time;
    open_mode(w);
}

/* ---- the run ------------------------------------------------------------------------------------------- */

static tdmf_run_outcome go_on(work *w, double until) {
    tdmf_page_run *r = w->r;
    bool stops = false;
    open_mode(w);
    for (const long limit = r->steps + r->step_limit; r->steps < limit;) {
        if (w->mode->ends) {
            return TDMF_RUN_ENDED;
        }
        if (!begin_step(w, until - r->time)) {
            return TDMF_RUN_NO_PROGRESS;
        }
        search_events(&w->step, true);
        const bool is_due = w->step.is_due;
        if (!is_due) {
            if (stops) {
                return TDMF_RUN_STOPPED;
            }
            if (w->is_shifted) {
                shift_back(w);
            }
            if (r->time >= until) {
                return TDMF_RUN_ARRIVED;
            }
            advance(w);
            if (w->step.end > 1.0 || w->step.first == NO_EVENT) {
                continue;
            }
        }
        const tdmf_guard_kind *due = &w->mode->guards[w->step.first];
        if (!is_due && r->seed_count > 0) {
            shift_to_event(w, due);
        }
        take(w, due);
        stops |= due->event == r->stop_event;
        if (w->chain > TDMF_CHAIN_LIMIT) {
            return TDMF_RUN_ENDLESS_CHAIN;
        }
    }
    return TDMF_RUN_TOO_MANY_STEPS;
}

tdmf_run_outcome tdmf_page_run_to(const tdmf_model_kind *model, tdmf_page_run *r, double until) {
    const int states = model->state_count, series = model->series_count;
    const int size = 2 * series * TERMS + (1 + r->seed_count) * model->constant_count + 4 * states +
                     model->parameter_count + 2 * model->event_count;
    double *memory = calloc((size_t)size, sizeof *memory);
    if (!memory) {
        return TDMF_RUN_NO_MEMORY;
    }
    work w = {.model = model, .r = r, .step = {.tolerance = r->tolerance}};
    w.step.s = (double(*)[TERMS])(void *)memory;
    w.t = w.step.s + series;
    w.step.c = memory + 2 * series * TERMS;
    w.d = w.step.c + model->constant_count;
    w.step.units = w.d + r->seed_count * model->constant_count;
    w.room = w.step.units + states;
    w.rates = w.room + states;
    w.scales = w.rates + states;
    w.event_scales = w.scales + states;
    w.taken_at = w.event_scales + model->event_count;
    w.none = w.taken_at + model->event_count;
    for (int i = 0; i < model->event_count; ++i) {
        w.taken_at[i] = -INFINITY;
    }
    model->scales(r->p, w.scales, w.event_scales);
    const tdmf_run_outcome outcome = go_on(&w, until);
    free(memory);
    return outcome;
}

int tdmf_page_order(double tolerance) {
    const int order = 2 * (int)(2.0 - 0.75 * log10(tolerance));
    return order < 8 ? 8 : order > SERIES_ORDER_LIMIT ? SERIES_ORDER_LIMIT : order;
}

tdmf_page_run tdmf_page_run_default(const tdmf_model_kind *model, double *p, double *x) {
    const double tolerance = 1e-11;
    memcpy(p, model->parameter_defaults, (size_t)model->parameter_count * sizeof *p);
    memcpy(x, model->state_defaults, (size_t)model->state_count * sizeof *x);
    const tdmf_page_run run = {.p = p,
                               .x = x,
                               .tolerance = tolerance,
                               .order = tdmf_page_order(tolerance),
                               .stop_event = -1,
                               .stuck_event = -1,
                               .observes = true,
                               .step_limit = 100000};
    return run;
}

void tdmf_page_set(const tdmf_model_kind *model, tdmf_page_run *r, double *p, bool is_state, int index,
                   double value, double *room) {
    const size_t size = (size_t)model->state_count * sizeof *room;
    for (int i = 0; i < model->set_count; ++i) {
        const tdmf_set_kind *kind = &model->sets[i];
        if (kind->is_state == is_state && kind->index == index && kind->set[r->mode]) {
            memcpy(room, r->x, size);
            kind->set[r->mode](r->p, r->x, value, room);
            memcpy(r->x, room, size);
        }
    }
    *(is_state ? &r->x[index] : &p[index]) = value;
}
