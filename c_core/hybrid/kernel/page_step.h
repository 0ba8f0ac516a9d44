/* A step of a mode over `real`, of one runner or of a runner in each lane: how long it may be, which event
 * ends it, and the values at its end. All widths give equal bits.
 */
#ifndef TDMF_KERNEL_PAGE_STEP_H
#define TDMF_KERNEL_PAGE_STEP_H

#include "driver.h"
#include "first_root.h"
#include "run_state.h"
#include "step_size.h"

static const double margin = 1e-12;         /* of a guard, relative to its scale */
static const double late_margin = 1e-9;     /* of the guard of an event that was just taken */
static const double most_time_scales = 3.0; /* of a law in a step */
static const double divisor_change = 0.75;  /* of a divisor within a step, relative to it */
static const double guard_tolerance = 10.0; /* of a guard's series, relative to that of a step */

enum { NO_EVENT = -1 };

/* A guard of the mode, from where the mode begins. */
typedef struct {
    mask is_watched, was_taken; /* was_taken: its event led to this mode, in this instant */
    real scale, late;           /* late: how far the guard may be below zero */
} guard_watch;

typedef struct {
    const tdmf_motion_kind *motion;
    const tdmf_guard_kind *kinds;
    int guard_count;
    double tolerance;
    /* Written where the mode begins. */
    mask begins;
    real *c;          /* constants */
    real (*s)[TERMS]; /* series */
    real *units;      /* scales of the moving states */
    guard_watch guards[TDMF_GUARD_LIMIT];
    /* Written by each step. */
    int order;         /* of the series */
    real power[TERMS]; /* powers of the step size */
    real size, end;    /* step size, and the share of it at which the step ends */
    integer first;     /* guard whose event ends the step, or is due at once; NO_EVENT */
    mask is_due;       /* at once */
} page_step;

/* ---- lanes --------------------------------------------------------------------------------------------- */

#ifndef TDMF_LANES
enum { LANES = 1 };
#endif

static inline bool has_lane(mask lanes, int lane) {
#ifdef TDMF_LANES
    return lanes[lane] != 0;
#else
    return lanes && lane == 0;
#endif
}

static inline double lane_of(const real *x, int lane) {
    double number;
    memcpy(&number, (const char *)x + (size_t)lane * sizeof number, sizeof number);
    return number;
}

static inline void set_lane(real *x, int lane, double number) {
    memcpy((char *)x + (size_t)lane * sizeof number, &number, sizeof number);
}

static inline void set_mask(mask *lanes, int lane, bool selected) {
#ifdef TDMF_LANES
    (*lanes)[lane] = selected ? -1 : 0;
#else
    (void)lane;
    *lanes = selected;
#endif
}

/* Loads what does not change within the mode, but for the constants, into a lane. */
static inline void load_mode(page_step *step, int lane, const mode_start *at, const double *scales) {
    set_mask(&step->begins, lane, true);
    for (int i = 0; i < step->guard_count; ++i) {
        guard_watch *watch = &step->guards[i];
        set_mask(&watch->is_watched, lane, at->guards[i].is_watched);
        set_mask(&watch->was_taken, lane, at->guards[i].was_taken);
        set_lane(&watch->scale, lane, at->guards[i].scale);
        set_lane(&watch->late, lane, 0.0);
    }
    for (int i = 0; i < step->motion->moving_count; ++i) {
        set_lane(&step->units[i], lane, scales[step->motion->moving[i]]);
    }
}

/* Clears the series of states that are polynomials in time: a ramp has no other coefficients. */
static inline void clear_polynomials(page_step *step) {
    const tdmf_motion_kind *m = step->motion;
    for (int i = 0; i < m->moving_count + m->extra_count; ++i) {
        if (m->degrees[i] < SERIES_ORDER_LIMIT) {
            memset(step->s[i], 0, sizeof step->s[i]);
        }
    }
}

/* ---- its size ------------------------------------------------------------------------------------------ */

/* Sums up the last terms of the series that control the size. Returns whether the coefficients are finite. */
static inline mask judge_series(const page_step *step, series_remainder *remainder) {
    const tdmf_motion_kind *m = step->motion;
    real left_out = broadcast(0.0);
    remainder->last = remainder->last_but_one = broadcast(0.0);
    for (int i = 0; i < m->judged_count; ++i) {
        const int j = m->judged[i];
        const real unit = j < m->moving_count ? step->units[j] : broadcast(1.0);
        add_to_remainder(remainder, step->s[j], step->order - 1, unit);
        left_out += real_abs(step->s[j][step->order]);
    }
    return is_finite(remainder->last + remainder->last_but_one + left_out);
}

/* Chooses a step that can be trusted, and in which no divisor comes near zero. */
static inline void choose_size(page_step *step, const series_remainder *remainder, real longest) {
    const tdmf_motion_kind *m = step->motion;
    const int order = step->order;
    step->size = real_min(size_of_remainder(remainder, order - 1, broadcast(step->tolerance)), longest);
    set_powers(step->power, step->size, order);
    for (int i = 0; i < m->divisor_count; ++i) {
        const real *d = step->s[m->divisors[i]], most = divisor_change * real_abs(d[0]);
        const real change = largest_change(d, step->power, order - 1);
        const mask is_long = change > most;
        if (any(is_long)) {
            step->size = select(is_long, step->size * (most / change), step->size);
            set_powers(step->power, step->size, order);
        }
    }
}

/* ---- its first event ----------------------------------------------------------------------------------- */

/* Scales a polynomial, or its negative, to the step. */
static inline void scale_to_step(const page_step *step, double sign, const real *g, real *scaled) {
    for (int k = 0; k < step->order; ++k) {
        scaled[k] = g[k] * (sign * step->power[k]);
    }
}

static inline void end_without_event(page_step *step, real share, mask lanes) {
    lanes &= share < step->end;
    step->end = select(lanes, share, step->end);
    step->first = select_integer(lanes, integer_of(NO_EVENT), step->first);
}

/* Ends the step where a guard's own series can be trusted no further: a leg that spins steadily has states of
 * few terms, and a sine in its guard. */
static inline void trust_guard(page_step *step, const real *g, real scale, mask lanes) {
    const int order = step->order;
    const real allowed = guard_tolerance * step->tolerance * real_max(scale, real_abs(g[0]));
    const series_remainder remainder = {real_abs(g[order - 1]) * step->power[order - 1],
                                        real_abs(g[order - 2]) * step->power[order - 2]};
    lanes &= (remainder.last > allowed) | (remainder.last_but_one > allowed);
    if (any(lanes)) {
        end_without_event(step, size_of_remainder(&remainder, order - 1, allowed), lanes);
    }
}

/* Ends the step where a guard that has to cross zero rises above it: the guard is watched from there on. */
static inline void end_where_it_rises(page_step *step, const real *g, real floor, mask lanes) {
    real negative[TERMS];
    scale_to_step(step, -1.0, g, negative);
    const real to = real_min(broadcast(1.0), step->end);
    const root found = first_root(negative, step->order - 1, 2.0 * floor, broadcast(0.0), to, lanes);
    end_without_event(step, found.time, lanes);
}

/* Ends the step at the first root of a guard, whose polynomial is g. */
static inline void search_guard(page_step *step, int guard, real *g, real floor, mask lanes) {
    trust_guard(step, g, step->guards[guard].scale, lanes);
    const real change = largest_change(g, step->power, step->order - 1);
    if (step->kinds[guard].is_crossing) {
        const mask below = lanes & (g[0] <= -floor), rises = below & (g[0] + change > -2.0 * floor);
        if (any(rises)) {
            end_where_it_rises(step, g, floor, rises);
        }
        lanes &= mask_not(below);
    }
    lanes &= mask_not(g[0] > change);
    if (any(lanes)) {
        lanes &= mask_not(interval_of_series(g, step->power, step->order).low > 0.0);
    }
    if (!any(lanes)) {
        return;
    }
    scale_to_step(step, 1.0, g, g);
    const real to = real_min(broadcast(1.0), step->end);
    const root found = first_root(g, step->order - 1, floor, broadcast(0.0), to, lanes);
    lanes &= (found.zero < step->end) & (found.is_root | (found.time < 1.0));
    const integer event = select_integer(found.is_root, integer_of(guard), integer_of(NO_EVENT));
    step->end = select(lanes, found.zero, step->end);
    step->first = select_integer(lanes, event, step->first);
}

/* Lanes whose event is due at once, where the mode begins. The guard of an event that was just taken may be
 * below zero by a rounding error. */
static inline mask due_at_once(page_step *step, int guard, real value, real floor, mask lanes) {
    guard_watch *watch = &step->guards[guard];
    const mask above = lanes & (value > 0.0), below = lanes & step->begins & mask_not(value > 0.0);
    const mask is_late = below & watch->was_taken & (value > -late_margin * watch->scale);
    watch->late = select(above, broadcast(0.0), select(is_late, 2.0 * value, watch->late));
    return step->kinds[guard].is_crossing ? mask_of(false)
                                          : below & mask_not(is_late) & (value < 2.0 * floor);
}

/* Searches the step for the first event, or one that is due at once. */
static inline void search_events(page_step *step, mask searching) {
    real low[TDMF_GUARD_LIMIT];
    step->end = broadcast(INFINITY);
    step->first = integer_of(NO_EVENT);
    step->is_due = mask_of(false);
    if (step->motion->bounds) {
        step->motion->bounds(step->c, step->s[0], step->power, step->order, low);
    }
    for (int i = 0; i < step->guard_count && any(searching); ++i) {
        mask lanes = searching & step->guards[i].is_watched;
        if (step->motion->bounds) {
            lanes &= mask_not(low[i] > 0.0);
        }
        if (!any(lanes)) {
            continue;
        }
        real g[TERMS];
        step->motion->polynomials[i](step->c, step->s[0], step->order, g);
        const real floor = -margin * step->guards[i].scale;
        const mask due = due_at_once(step, i, g[0], floor, lanes);
        step->is_due |= due;
        step->first = select_integer(due, integer_of(i), step->first);
        searching &= mask_not(due);
        lanes &= mask_not(due);
        if (any(lanes)) {
            search_guard(step, i, g, floor + step->guards[i].late, lanes);
        }
    }
}

/* ---- its end ------------------------------------------------------------------------------------------- */

/* Sets the powers to those of the end of the step, and returns how long the step lasts. */
static inline real end_step(page_step *step) {
    const real elapsed = select(step->end <= 1.0, step->end * step->size, step->size);
    if (any(mask_not(elapsed == step->size))) {
        set_powers(step->power, elapsed, step->order);
    }
    return elapsed;
}

static inline real sum_of(const real *c, const real *power, int order) {
    pair sum = pair_of(broadcast(0.0), broadcast(0.0));
    int k = 1;
    for (; k < order; k += 2) {
        add_terms(&sum, c + k, power + k);
    }
    const real rest = k == order ? part_of(sum, 0) + c[k] * power[k] : part_of(sum, 0);
    return c[0] + (rest + part_of(sum, 1));
}

/* The value of a moving state. */
static inline real value_at_end(const page_step *step, int i) {
    const int degree = step->motion->degrees[i];
    return sum_of(step->s[i], step->power, degree < step->order ? degree : step->order);
}

/* The rate of a moving state. */
static inline real rate_at_end(const page_step *step, int i) {
    real rate = broadcast(0.0);
    for (int k = 1; k <= step->order; ++k) {
        rate += (double)k * step->s[i][k] * step->power[k - 1];
    }
    return rate;
}

#endif
