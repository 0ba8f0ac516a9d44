/* Runs a page: Taylor steps, the first event of any guard, chains of events in zero time, saltation.
 *
 * A step is as long as its series can be trusted. Each guard is a polynomial in the step, and the first root
 * of any ends it. A guard that is below zero where a mode begins is due at once, in the page's order.
 *
 * With guard g, reset R and rates f- and f+ before and after, a variation dx passes an event by
 *
 *     dt = -(g_x dx + g_p dp)/(g_x f-),      dx+ = R_x (dx + f- dt) + R_p dp - f+ dt,
 *
 * and resets that follow in zero time, which inequalities decide, shift with the first one.
 */
#include "driver.h"

#include "step_size.h"

#include <stdlib.h>

enum {
    PIECE_LIMIT = 32, /* pieces of a step in which an observed quantity keeps its sign */
    LEAST_ORDER = 4
};

static const double margin = 1e-12;         /* of a guard, relative to its scale */
static const double late_margin = 1e-9;     /* of the guard of an event that was just taken */
static const double most_time_scales = 3.0; /* of a law in a step */
static const double divisor_change = 0.75;  /* of a divisor within a step, relative to it */
static const double guard_tolerance = 10.0; /* of a guard's series, relative to that of a step */
static const double part_tolerance = 0.01;  /* of a positive integral, relative to that of a step */
static const double sign_margin = 1e-7;     /* of an observed quantity, relative to its largest coefficient */

/* The state of a run between steps; its arrays lie in one piece of memory. */
typedef struct {
    const tdmf_model_kind *model;
    const tdmf_mode_kind *mode;
    const tdmf_motion_kind *motion;
    tdmf_page_run *r;
    real *c, *d;                   /* constants of the mode, and their variations for each seed */
    real (*s)[TERMS], (*t)[TERMS]; /* series, and their variation for one seed */
    real *room, *rates, *none;     /* arrays of states; `none` holds zeros for parameters that do not vary */
    real *scales, *event_scales;
    real *taken_at, *late;        /* by event: when it was last taken, how far its guard may be below zero */
    int order;                    /* of the series in this step */
    real power[TERMS];            /* powers of the step size */
    real size, end;               /* step size, and the share of it at which the step ends */
    const tdmf_guard_kind *first; /* event at that end; NULL: none */
    int chain;                    /* events in zero time so far */
    bool begins, is_shifted;      /* the mode has just begun; variations are on the guard of the last event */
    bool is_watched[TDMF_GUARD_LIMIT];
} work;

static real *seed_dx(const work *w, int seed) {
    return w->r->dx + seed * w->model->state_count;
}

static const real *seed_dp(const work *w, int seed) {
    return w->r->dp + seed * w->model->parameter_count;
}

/* ---- the step ------------------------------------------------------------------------------------------ */

static void open_mode(work *w) {
    tdmf_page_run *r = w->r;
    w->mode = &w->model->modes[r->mode];
    w->motion = w->mode->motion;
    w->begins = true;
    w->mode->open(r->p, r->x, w->c);
    for (int i = 0; i < w->mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &w->mode->guards[i];
        w->is_watched[i] = !kind->is_watched || kind->is_watched(r->p, r->x) != 0.0;
    }
    for (int i = 0; i < w->motion->moving_count + w->motion->extra_count; ++i) {
        if (w->motion->degrees[i] < SERIES_ORDER_LIMIT) {
            memset(w->s[i], 0, sizeof w->s[i]); /* a ramp has no other coefficients */
        }
    }
    for (int seed = 0; seed < r->seed_count; ++seed) {
        w->mode->vary_open(r->p, r->x, seed_dp(w, seed), seed_dx(w, seed),
                           w->d + seed * w->model->constant_count);
    }
}

static void expand(work *w) {
    for (int i = 0; i < w->motion->moving_count; ++i) {
        w->s[i][0] = w->r->x[w->motion->moving[i]];
    }
    w->order = w->r->order;
    w->motion->expand(w->c, w->order, w->s[0]);
}

/* The size for which the series of the mode have a truncation error within the tolerance. Where coefficients
 * overflow, the series has fewer terms. */
static real size_of_series(work *w) {
    const tdmf_motion_kind *m = w->motion;
    for (;; w->order -= 2) {
        series_remainder remainder = {0.0, 0.0};
        real left_out = 0.0;
        for (int i = 0; i < m->judged_count; ++i) {
            const int j = m->judged[i];
            const real unit = j < m->moving_count ? w->scales[m->moving[j]] : 1.0;
            add_to_remainder(&remainder, w->s[j], w->order - 1, unit);
            left_out += real_abs(w->s[j][w->order]);
        }
        if (is_finite(remainder.last + remainder.last_but_one + left_out)) {
            return size_of_remainder(&remainder, w->order - 1, w->r->tolerance);
        }
        if (w->order <= LEAST_ORDER) {
            return NAN;
        }
    }
}

/* Chooses a step that can be trusted, and in which no divisor comes near zero. */
static void choose_size(work *w, real longest) {
    const tdmf_motion_kind *m = w->motion;
    const real trusted = size_of_series(w);
    if (w->mode->time_scale) {
        longest = real_min(longest, most_time_scales * w->mode->time_scale(w->r->p, w->r->x));
    }
    w->size = isnan(trusted) ? NAN : real_min(trusted, longest);
    set_powers(w->power, w->size, w->order);
    for (int i = 0; i < m->divisor_count; ++i) {
        const real *d = w->s[m->divisors[i]], most = divisor_change * real_abs(d[0]);
        const real change = largest_change(d, w->power, w->order - 1);
        if (change > most) {
            w->size *= most / change;
            set_powers(w->power, w->size, w->order);
        }
    }
}

static real sum_of(const real *c, const real *power, int order) {
    pair sum = pair_of(0.0, 0.0);
    int k = 1;
    for (; k < order; k += 2) {
        add_terms(&sum, c + k, power + k);
    }
    const real rest = k == order ? part_of(sum, 0) + c[k] * power[k] : part_of(sum, 0);
    return c[0] + (rest + part_of(sum, 1));
}

/* ---- observed quantities ------------------------------------------------------------------------------- */

/* Scales a polynomial, or its negative, to the step. */
static void scale_to_step(const work *w, real sign, real *g) {
    for (int k = 0; k < w->order; ++k) {
        g[k] *= sign * w->power[k];
    }
}

/* The end of a piece of [from, 1] in which a polynomial, scaled to the step, keeps its sign. */
static real end_of_sign(const real *g, int degree, real from) {
    real largest = 0.0;
    for (int k = 0; k <= degree; ++k) {
        largest = real_max(largest, real_abs(g[k]));
    }
    const root found = first_sign_change(g, degree, sign_margin * largest, from, 1.0, true);
    return found.is_root && found.time < 1.0 ? found.time : 1.0;
}

/* The integral over the step where g is positive. The polynomial is not searched for changes of sign if its
 * integral is below `least`. */
static real positive_integral(const work *w, real *g, real least) {
    const real tail = largest_change(g, w->power, w->order - 1), size = w->power[1];
    if (g[0] + tail <= 0.0) {
        return 0.0;
    }
    real integral[TERMS], power[TERMS];
    integral[0] = integral[w->order + 1] = 0.0;
    for (int k = 0; k < w->order; ++k) {
        integral[k + 1] = g[k] * series_reciprocal[k + 1];
    }
    const real whole = real_max(0.0, sum_of(integral, w->power, w->order));
    if (g[0] >= tail || size * (g[0] + tail) < least) {
        return whole;
    }
    const interval range = interval_of_series(g, w->power, w->order);
    if (range.low >= 0.0 || range.high <= 0.0 || size * (range.high - range.low) < least) {
        return whole;
    }
    scale_to_step(w, 1.0, g);
    real sum = 0.0, from = 0.0, before = 0.0;
    for (int pieces = 0; pieces < PIECE_LIMIT && from < 1.0; ++pieces) {
        from = end_of_sign(g, w->order - 1, from);
        set_powers(power, from * size, w->order);
        const real after = sum_of(integral, power, w->order);
        sum += real_max(0.0, after - before);
        before = after;
    }
    return sum;
}

/* The largest value is that at an end, or where the rate changes its sign. */
static real largest_value(const work *w, real *g, real largest) {
    if (g[0] + largest_change(g, w->power, w->order - 1) <= largest) {
        return largest;
    }
    real rate[TERMS], power[TERMS];
    real rates = 0.0, end = 0.0, from = 0.0;
    scale_to_step(w, 1.0, g);
    for (int k = 1; k < w->order; ++k) {
        rate[k - 1] = k * g[k];
        rates += real_abs(rate[k - 1]);
        end += g[k];
    }
    largest = real_max(largest, real_max(g[0], g[0] + end));
    if (rates <= 2.0 * real_abs(rate[0])) { /* the rate keeps its sign */
        return largest;
    }
    for (int pieces = 0; pieces < PIECE_LIMIT && from < 1.0; ++pieces) {
        from = end_of_sign(rate, w->order - 2, from);
        set_powers(power, from, w->order);
        largest = real_max(largest, sum_of(g, power, w->order - 1));
    }
    return largest;
}

/* Updates the observed quantities over a step whose powers are set. */
static void observe(work *w) {
    for (int i = 0; i < w->mode->watch_count; ++i) {
        const tdmf_watch_kind *kind = &w->mode->watches[i];
        real g[TERMS], *value = &w->r->x[kind->into];
        w->motion->polynomials[w->mode->guard_count + i](w->c, w->s[0], w->order, g);
        if (kind->part == TDMF_LARGEST) {
            *value = largest_value(w, g, *value);
        } else {
            const real least = part_tolerance * w->r->tolerance * w->scales[kind->into];
            *value += positive_integral(w, g, least);
        }
    }
}

/* ---- going on ------------------------------------------------------------------------------------------ */

static void advance_variations(work *w) {
    const tdmf_motion_kind *m = w->motion;
    for (int seed = 0; seed < w->r->seed_count; ++seed) {
        real *dx = seed_dx(w, seed);
        for (int i = 0; i < m->moving_count; ++i) {
            w->t[i][0] = dx[m->moving[i]];
        }
        m->vary(w->c, w->s[0], w->d + seed * w->model->constant_count, w->order, w->t[0]);
        for (int i = 0; i < m->moving_count; ++i) {
            dx[m->moving[i]] = sum_of(w->t[i], w->power, w->order);
        }
    }
}

/* Advances the run within the step. */
static void advance(work *w, real elapsed) {
    const tdmf_motion_kind *m = w->motion;
    const int order = w->order;
    if (elapsed != w->size) {
        set_powers(w->power, elapsed, order);
    }
    advance_variations(w);
    if (w->r->observes) {
        observe(w);
    }
    for (int i = 0; i < m->moving_count; ++i) {
        w->r->x[m->moving[i]] = sum_of(w->s[i], w->power, m->degrees[i] < order ? m->degrees[i] : order);
    }
    if (elapsed > 0.0) {
        w->chain = 0;
    }
    w->r->time += elapsed;
    ++w->r->steps;
    w->begins = false;
}

/* ---- events -------------------------------------------------------------------------------------------- */

static void end_without_event(work *w, real share) {
    if (share < w->end) {
        w->end = share;
        w->first = NULL;
    }
}

/* Ends the step where a guard's own series can be trusted no further: a leg that spins steadily has states of
 * few terms, and a sine in its guard. */
static void trust_guard(work *w, const real *g, real scale) {
    const int order = w->order;
    const real allowed = guard_tolerance * w->r->tolerance * real_max(scale, real_abs(g[0]));
    const series_remainder remainder = {real_abs(g[order - 1]) * w->power[order - 1],
                                        real_abs(g[order - 2]) * w->power[order - 2]};
    if (remainder.last > allowed || remainder.last_but_one > allowed) {
        end_without_event(w, size_of_remainder(&remainder, order - 1, allowed));
    }
}

/* Ends the step where a guard that has to cross zero rises above it: the guard is watched from there on. */
static void end_where_it_rises(work *w, real *g, real floor) {
    scale_to_step(w, -1.0, g);
    const root found = first_root(g, w->order - 1, 2.0 * floor, 0.0, real_min(1.0, w->end), true);
    end_without_event(w, found.time);
}

/* Ends the step at the first root of a guard, whose polynomial is g. */
static void search_guard(work *w, const tdmf_guard_kind *kind, real *g, real floor) {
    trust_guard(w, g, w->event_scales[kind->event]);
    if (kind->is_crossing && g[0] <= -floor) {
        if (g[0] + largest_change(g, w->power, w->order - 1) > -2.0 * floor) {
            end_where_it_rises(w, g, floor);
        }
        return;
    }
    if (g[0] > largest_change(g, w->power, w->order - 1) ||
        interval_of_series(g, w->power, w->order).low > 0.0) {
        return;
    }
    scale_to_step(w, 1.0, g);
    const root found = first_root(g, w->order - 1, floor, 0.0, real_min(1.0, w->end), true);
    if (found.zero < w->end && (found.is_root || found.time < 1.0)) {
        w->end = found.zero;
        w->first = found.is_root ? kind : NULL;
    }
}

/* Whether the guard of an event that was just taken is below zero by a rounding error. */
static bool is_late(const work *w, int event, real guard) {
    return w->taken_at[event] == w->r->time && guard > -late_margin * w->event_scales[event];
}

/* Searches the step for the first event. Returns an event that is due at once where the mode begins. */
static const tdmf_guard_kind *search(work *w) {
    real low[TDMF_GUARD_LIMIT];
    w->end = INFINITY;
    w->first = NULL;
    if (w->motion->bounds) {
        w->motion->bounds(w->c, w->s[0], w->power, w->order, low);
    }
    for (int i = 0; i < w->mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &w->mode->guards[i];
        if (!w->is_watched[i] || (w->motion->bounds && low[i] > 0.0)) {
            continue;
        }
        real g[TERMS];
        w->motion->polynomials[i](w->c, w->s[0], w->order, g);
        const real floor = -margin * w->event_scales[kind->event];
        real *late = &w->late[kind->event];
        if (g[0] > 0.0) {
            *late = 0.0;
        } else if (w->begins && is_late(w, kind->event, g[0])) {
            *late = 2.0 * g[0];
        } else if (w->begins && !kind->is_crossing && g[0] < 2.0 * floor) {
            return kind;
        }
        search_guard(w, kind, g, floor + *late);
    }
    return NULL;
}

/* Moves the variations onto the guard of an event, along the rates before the event. */
static void shift_to_event(work *w, const tdmf_guard_kind *kind) {
    tdmf_page_run *r = w->r;
    const tdmf_motion_kind *m = w->motion;
    memset(w->rates, 0, (size_t)w->model->state_count * sizeof *w->rates);
    for (int i = 0; i < m->moving_count; ++i) {
        real rate = 0.0;
        for (int k = 1; k <= w->order; ++k) {
            rate += k * w->s[i][k] * w->power[k - 1];
        }
        w->rates[m->moving[i]] = rate;
    }
    const real falls = kind->vary_guard(r->p, r->x, w->none, w->rates);
    for (int seed = 0; seed < r->seed_count; ++seed) {
        real *dx = seed_dx(w, seed);
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
        for (int i = 0; i < w->motion->moving_count; ++i) {
            seed_dx(w, seed)[w->motion->moving[i]] -= w->s[i][1] * w->r->shift[seed];
        }
    }
    w->is_shifted = false;
}

void tdmf_page_take(const tdmf_model_kind *model, const tdmf_guard_kind *kind, tdmf_page_run *r,
                    double *room) {
    const tdmf_mode_kind *left = &model->modes[r->mode];
    const size_t size = (size_t)model->state_count * sizeof *room;
    const real counted = kind->is_counted ? 1.0 : 0.0;
    for (int part = left->leave ? 0 : 1; part < 2; ++part) { /* `leave`, then the decision */
        for (int seed = 0; seed < r->seed_count; ++seed) {
            const real *dp = r->dp + seed * model->parameter_count;
            real *dx = r->dx + seed * model->state_count;
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
        expand(w);
        choose_size(w, until - r->time);
        if (!(w->size >= 0.0)) {
            return TDMF_RUN_NO_PROGRESS;
        }
        const tdmf_guard_kind *due = search(w);
        if (!due) {
            if (stops) {
                return TDMF_RUN_STOPPED;
            }
            if (w->is_shifted) {
                shift_back(w);
            }
            if (r->time >= until) {
                return TDMF_RUN_ARRIVED;
            }
            advance(w, w->end <= 1.0 ? w->end * w->size : w->size);
            if (w->end > 1.0 || !w->first) {
                continue;
            }
            due = w->first;
            if (r->seed_count > 0) {
                shift_to_event(w, due);
            }
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
    const int size = 2 * series * TERMS + (1 + r->seed_count) * model->constant_count + 3 * states +
                     model->parameter_count + 3 * model->event_count;
    real *memory = calloc((size_t)size, sizeof *memory);
    if (!memory) {
        return TDMF_RUN_NO_MEMORY;
    }
    work w = {.model = model, .r = r};
    w.s = (real(*)[TERMS])(void *)memory;
    w.t = w.s + series;
    w.c = memory + 2 * series * TERMS;
    w.d = w.c + model->constant_count;
    w.room = w.d + r->seed_count * model->constant_count;
    w.rates = w.room + states;
    w.scales = w.rates + states;
    w.event_scales = w.scales + states;
    w.taken_at = w.event_scales + model->event_count;
    w.late = w.taken_at + model->event_count;
    w.none = w.late + model->event_count;
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
