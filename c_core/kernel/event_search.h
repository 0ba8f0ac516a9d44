/* The first event in a step. Guards are polynomials in time: what a guard is made of has been expanded with
 * the motion, so that a guard is a sum of series, as exact as the step, and no event is missed, however
 * short.
 *
 * A polynomial on [0, 1] is a mean, with weights that are not negative, of its partial sums:
 *
 *     p(t) = sum of (c_0 + ... + c_k) (t^k - t^(k + 1)), k < n, and (c_0 + ... + c_n) t^n.
 *
 * So most guards are seen to stay above zero by the least of their partial sums. What remains is searched, in
 * every lane the guard that it has reason to. */
#ifndef TDMF_KERNEL_EVENT_SEARCH_H
#define TDMF_KERNEL_EVENT_SEARCH_H

#include "first_root.h"
#include "margins.h"
#include "mode_constants.h"
#include "powers.h"

/* What ends a step: an event at the zero of this guard; a kink of a law, which is no event; or, with the
 * guard added, an event whose guard has no zero to be told from its floor. */
enum { KINK = TDMF_GUARD_COUNT, AT_FLOOR };

/* What has been found ends the step, or tells how far it may be used. */
typedef struct {
    real size; /* of the step; all other times here are shares of it */
    int order;
    mask live;
    real beyond_margin; /* in a guard's scale: where it is known to be due, since its zero */
    real power[SERIES_TERMS];
    real time;
    integer end; /* a guard, KINK, or AT_FLOOR and a guard */
    /* The guard that a lane has yet to search, as a polynomial. */
    mask pending;
    integer pending_guard;
    real c[SERIES_TERMS];
    real floor;
} event_search;

/* A guard as a sum of c[k] t^k: factor * series[k], but for coefficient 0, which is `start`. */
typedef struct {
    const real *series;
    real factor, start;
    int order;
} guard_series;

/* Begins the search of a step whose size and powers are set. */
static inline void begin_search(event_search *search, int order, mask live, real beyond_margin) {
    search->order = order;
    search->live = live;
    search->beyond_margin = beyond_margin;
    search->time = broadcast(INFINITY);
    search->end = integer_of(KINK);
    search->pending = mask_of(false);
    search->pending_guard = integer_of(KINK);
}

/* Notes what lanes have found that ends their step sooner. */
static inline void record_end(event_search *search, mask lanes, real time, integer end) {
    const mask sooner =
        lanes & ((time < search->time) | ((time == search->time) & (search->end == integer_of(KINK))));
    search->time = select(sooner, time, search->time);
    search->end = select_integer(sooner, end, search->end);
}

/* Finds the first root of the guards that are pending. An event takes place at its guard's zero, once it is
 * known to be due; a kink is passed by its floor. */
static inline void search_pending(event_search *search) {
    if (!any(search->pending)) {
        return;
    }
    const real to = real_min(broadcast(1.0), search->time);
    const root found =
        first_root(search->c, search->order, search->floor, broadcast(0.0), to, search->pending);
    const mask is_event = found.is_root & (search->pending_guard != integer_of(KINK));
    const mask has_zero = found.zero < found.time;
    const integer guard = select_integer(has_zero, search->pending_guard, search->pending_guard + AT_FLOOR);
    record_end(search, search->pending, select(is_event, found.zero, found.time),
               select_integer(is_event, guard, integer_of(KINK)));
    search->pending = mask_of(false);
}

/* The guard of an event that ends a step, and the one whose zero the step has come to, if any. */
static inline tdmf_guard guard_of_end(int end) {
    return (tdmf_guard)(end > KINK ? end - AT_FLOOR : end);
}

static inline tdmf_guard guard_at_zero(int end) {
    return end < KINK ? (tdmf_guard)end : TDMF_GUARD_COUNT;
}

/* Least of a guard's partial sums. */
static inline real min_partial_sum(const event_search *search, const guard_series *g) {
    const real *c = g->series, *power = search->power;
    real sum = g->start;
    real minimum = sum;
    int k = 1;
    for (; k < g->order; k += 2) {
        const real before = sum + g->factor * c[k] * power[k];
        sum = before + g->factor * c[k + 1] * power[k + 1];
        minimum = real_min(real_min(minimum, before), sum);
    }
    if (k == g->order) {
        minimum = real_min(minimum, sum + g->factor * c[k] * power[k]);
    }
    return minimum;
}

/* Within the step a series differs by no more than this from its first coefficient. */
static inline real largest_deviation(const event_search *search, const real *c, int order) {
    const real *power = search->power;
    real sum = broadcast(0.0);
    real maximum = broadcast(0.0);
    int k = 1;
    for (; k < order; k += 2) {
        const real before = sum + c[k] * power[k];
        sum = before + c[k + 1] * power[k + 1];
        maximum = real_max(real_max(maximum, real_abs(before)), real_abs(sum));
    }
    if (k == order) {
        maximum = real_max(maximum, real_abs(sum + c[k] * power[k]));
    }
    return maximum;
}

/* Lanes in which a polynomial stays above its floor: seen from the start of the step, or over the chord from
 * start to end, from which it sags by no more than its curvature allows. */
static inline mask stays_above(const real *c, int order, real floor) {
    const expansion start = expansion_at_start(c, order);
    const real above = start.value - floor;
    const real lowest = start.curvature - 2.0 * sum_of_tail(c, order);
    const real highest =
        real_max(start.curvature + bound_of_derivative(c, second_derivative, order), broadcast(0.0));
    real change = c[order];
    for (int k = order - 1; k > 0; --k) {
        change += c[k];
    }
    return stays_positive(above, start.slope, lowest, broadcast(1.0)) |
           stays_positive(above, change - 0.5 * highest, highest, broadcast(1.0));
}

/* Has lanes search a guard. */
static inline void take_pending(event_search *search, int guard, mask lanes, const real *c, real floor) {
    const bool takes_all = !any(search->pending);
    for (int k = 0; k <= search->order; ++k) {
        search->c[k] = takes_all ? c[k] : select(lanes, c[k], search->c[k]);
    }
    search->floor = takes_all ? floor : select(lanes, floor, search->floor);
    search->pending_guard = select_integer(lanes, integer_of(guard), search->pending_guard);
    search->pending |= lanes;
}

/* Has lanes search a guard unless it is seen to stay above its floor. */
static inline void search_closer(event_search *search, int guard, mask near, const guard_series *g,
                                 real floor) {
    real c[SERIES_TERMS];
    c[0] = g->start;
    for (int k = 1; k <= g->order; ++k) {
        c[k] = g->factor * g->series[k] * search->power[k];
    }
    near &= mask_not(stays_above(c, g->order, floor));
    if (!any(near)) {
        return;
    }
    if (any(near & search->pending)) {
        search_pending(search);
    }
    for (int k = g->order + 1; k <= search->order; ++k) {
        c[k] = broadcast(0.0);
    }
    take_pending(search, guard, near, c, floor);
}

/* The first root of a guard, in the lanes that watch it: where it is down to `floor`, which is below zero. */
static inline void watch(event_search *search, int guard, mask watching, const guard_series *g, real floor) {
    const mask near = watching & search->live & mask_not(min_partial_sum(search, g) > 0.0);
    if (any(near)) {
        search_closer(search, guard, near, g, floor);
    }
}

/* The same of a guard that is a series of the motion times a factor, but for its start. */
static inline void watch_series(event_search *search, int guard, mask watching, const real *series,
                                real factor, real start, int order, real floor) {
    const guard_series g = {series, factor, start, order};
    if (any(watching)) {
        watch(search, guard, watching, &g, floor);
    }
}

#endif
