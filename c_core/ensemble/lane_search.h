/* The first root of a guard in each lane. As in first_root.c, a root is marched up to from below and never
 * passed; here each lane marches on a polynomial of its own, the guard that it has reason to look at.
 *
 * At the start of a step the coefficients are at hand, and with T = sum |c_k| h^k, k >= 3, and d <= D <= h
 *
 *     p(d) >= p(0) + p'(0) d + (p''(0) - 2 T D/h^3) d^2/2,
 *
 * which is the bound of the march with 6 T/h^3 in place of the third derivative's, and several times tighter.
 */
#ifndef TDMF_ENSEMBLE_LANE_SEARCH_H
#define TDMF_ENSEMBLE_LANE_SEARCH_H

#include "lane_series.h"
#include "tdmf_slip/automaton.h"

/* Next to a multiple root a march is slow, and rounding may stall it. */
enum { MARCH_LIMIT = 200 };

/* Share of the floor within which a polynomial counts as having come down to it. */
static const double close_enough = 0.25;

/* How many times further than what is known to be safe the next look goes, and how many looks there are. */
static const double look_ahead = 3.0;
enum { LOOKS = 2 };

/* A guard as a sum of c[k] t^k: factor * series[k], but for coefficient 0. Due where it is down to `floor`,
 * which is below zero. */
typedef struct {
    const real *series;
    real factor, start;
    int order;
} guard_series;

typedef struct {
    real size; /* of the step */
    int order;
    choice live;
    real due_below; /* in a guard's scale */
    real power[SERIES_TERMS], second[SERIES_TERMS],
        third[SERIES_TERMS]; /* of t^k and its derivatives at the end */
    /* The guard that a lane looks at, if any. */
    choice looking;
    real c[SERIES_TERMS];
    real bound, bound_at_start; /* of the third derivative, and of what stands for it at the start */
    real floor;
    bits guard;
    /* What has been found: a guard that is due where `is_root`, else how far none is. */
    real time;
    choice is_root;
    bits first;
} lane_search;

/* k (k - 1). */
static const double second_derivative[SERIES_TERMS] = {0,   0,   2,   6,   12,  20,  30,  42,  56,  72,
                                                       90,  110, 132, 156, 182, 210, 240, 272, 306, 342,
                                                       380, 420, 462, 506, 552, 600, 650, 702, 756, 812};

/* k (k - 1) (k - 2). */
static const double third_derivative[SERIES_TERMS] = {
    0,    0,    0,    6,    24,   60,   120,  210,  336,   504,   720,   990,   1320,  1716,  2184,
    2730, 3360, 4080, 4896, 5814, 6840, 7980, 9240, 10626, 12144, 13800, 15600, 17550, 19656, 21924};

/* By halves, because each product waits for its factors. */
static inline void set_powers(real power[SERIES_TERMS], real t, int order) {
    power[0] = real_of(1.0);
    power[1] = t;
    for (int k = 2; k <= order; ++k) {
        power[k] = power[k / 2] * power[k - k / 2];
    }
}

static inline void search_within(lane_search *search, real size, int order, choice live, real due_below) {
    search->size = size;
    search->order = order;
    search->live = live;
    search->due_below = due_below;
    set_powers(search->power, size, order);
    for (int k = 3; k <= order; ++k) {
        search->second[k] = second_derivative[k] * search->power[k - 2];
        search->third[k] = third_derivative[k] * search->power[k - 3];
    }
    for (int k = 0; k <= order; ++k) {
        search->c[k] = real_of(0.0);
    }
    search->looking = bits_of(0);
    search->bound = real_of(0.0);
    search->bound_at_start = real_of(0.0);
    search->floor = real_of(-1.0);
    search->guard = bits_of(0);
    search->time = real_of(INFINITY);
    search->is_root = bits_of(0);
    search->first = bits_of(0);
}

/* The sum of weights[k] |c[k]| from `first` on. */
static inline real weighted_sum(const real *c, const real *weights, int first, int order) {
    real even = real_of(0.0), odd = real_of(0.0);
    int k = first;
    for (; k + 1 <= order; k += 2) {
        even += weights[k] * real_abs(c[k]);
        odd += weights[k + 1] * real_abs(c[k + 1]);
    }
    if (k <= order) {
        even += weights[k] * real_abs(c[k]);
    }
    return even + odd;
}

/* Within the step a series differs by no more than this from its first coefficient. */
static inline real spread_of(const lane_search *search, const real *c, int order) {
    return weighted_sum(c, search->power, 1, order);
}

/* value + slope d + curvature d^2/2 is positive for all d up to `left`. */
static inline choice stays_positive(real value, real slope, real curvature, real left) {
    const choice at_end = value + left * (slope + 0.5 * curvature * left) > 0.0;
    return at_end & ((curvature <= 0.0) | (slope >= 0.0) | (-slope >= curvature * left) |
                     (slope * slope < 2.0 * curvature * value));
}

/* The first positive root of a parabola that has one, written without cancellation. */
static inline real root_of_parabola(real value, real slope, real curvature) {
    const real discriminant = real_sqrt(larger(real_of(0.0), slope * slope - 2.0 * curvature * value));
    const choice falls = slope < 0.0;
    return pick(falls, 2.0 * value, -(slope + discriminant)) / pick(falls, discriminant - slope, curvature);
}

/* How far from a point no root lies. */
static inline real safe_distance(real value, real slope, real curvature, real bound, real left) {
    const real lowest = curvature - bound * left * (1.0 / 3.0);
    const choice none = stays_positive(value, slope, lowest, left);
    real safe = root_of_parabola(value, slope, lowest);
    choice looks = ~none;
    for (int look = 0; look < LOOKS; ++look) {
        /* The shorter the interval that the bound must hold for, the further it reaches within it. */
        const real near = look_ahead * safe;
        looks &= near < left;
        if (!any(looks)) {
            break;
        }
        const real nearby = curvature - bound * near * (1.0 / 3.0);
        const choice passes = looks & stays_positive(value, slope, nearby, near);
        const real root = larger(safe, root_of_parabola(value, slope, nearby));
        safe = pick(passes, near, pick(looks, root, safe));
        looks = passes;
    }
    return pick(none, real_of(INFINITY), safe);
}

typedef struct {
    real value, slope, curvature;
} lane_expansion;

static inline lane_expansion expand_at(const lane_search *search, real t) {
    const real *c = search->c;
    real value = real_of(0.0), slope = real_of(0.0), curvature = real_of(0.0);
    for (int k = search->order; k >= 0; --k) {
        curvature = curvature * t + slope;
        slope = slope * t + value;
        value = value * t + c[k];
    }
    const lane_expansion at = {value, slope, 2.0 * curvature};
    return at;
}

/* Notes what lanes have found that ends their step sooner. */
static inline void note_found(lane_search *search, choice lanes, real time, choice is_root, bits guard) {
    const choice sooner =
        lanes & ((time < search->time) | ((time == search->time) & is_root & ~search->is_root));
    search->time = pick(sooner, time, search->time);
    search->is_root = (is_root & sooner) | (search->is_root & ~sooner);
    search->first = (guard & sooner) | (search->first & ~sooner);
}

/* Lets all lanes that look at a guard find its first root. */
static void march_up(lane_search *search) {
    const real to = smaller(search->size, search->time);
    const real down = close_enough * real_abs(search->floor);
    lane_expansion at = {search->c[0], search->c[1], 2.0 * search->c[2]};
    real bound = search->bound_at_start;
    real time = real_of(0.0);
    choice marching = search->looking;
    choice found = bits_of(0);
    for (int i = 0; i < MARCH_LIMIT; ++i) {
        const real value = at.value - search->floor;
        const choice due = marching & ~(value > down);
        found |= due;
        marching &= ~due;
        if (!any(marching)) {
            break;
        }
        const real next = time + safe_distance(value, at.slope, at.curvature, bound, to - time);
        const choice past_end = marching & (next > to);
        time = pick(past_end, real_of(INFINITY), pick(marching, next, time));
        marching &= ~past_end;
        if (!any(marching)) {
            break;
        }
        at = expand_at(search, time);
        bound = search->bound;
    }
    note_found(search, search->looking, time, found, search->guard);
    search->looking = bits_of(0);
}

/* Lanes in which a guard stays above its floor: seen from the start of the step, or over the chord from start
 * to end, from which it sags by no more than its curvature allows. */
static inline choice stays_above(const lane_search *search, const guard_series *g, real above,
                                 real bound_at_start) {
    const real *c = g->series;
    const real size = search->size;
    const real curvature = 2.0 * g->factor * c[2];
    const real lowest = curvature - bound_at_start * size * (1.0 / 3.0);
    const real highest =
        larger(curvature + real_abs(g->factor) * weighted_sum(c, search->second, 3, g->order), real_of(0.0));
    real rise = c[g->order] * search->power[g->order];
    for (int k = g->order - 1; k > 0; --k) {
        rise += c[k] * search->power[k];
    }
    return stays_positive(above, g->factor * c[1], lowest, size) |
           stays_positive(above, g->factor * rise / size - 0.5 * highest * size, highest, size);
}

/* Makes lanes look at a guard. */
static inline void look_at(lane_search *search, tdmf_guard guard, choice lanes, const guard_series *g,
                           real floor, real bound_at_start) {
    const real *c = g->series;
    const real bound = real_abs(g->factor) * weighted_sum(c, search->third, 3, g->order);
    search->c[0] = pick(lanes, g->start, search->c[0]);
    for (int k = 1; k <= g->order; ++k) {
        search->c[k] = pick(lanes, g->factor * c[k], search->c[k]);
    }
    for (int k = g->order + 1; k <= search->order; ++k) {
        search->c[k] = pick(lanes, real_of(0.0), search->c[k]);
    }
    search->bound = pick(lanes, bound, search->bound);
    search->bound_at_start = pick(lanes, bound_at_start, search->bound_at_start);
    search->floor = pick(lanes, floor, search->floor);
    search->guard = (bits_of(guard) & lanes) | (search->guard & ~lanes);
    search->looking |= lanes;
}

/* The first root of a guard, in the lanes that watch it. Most are seen to be out of reach at once. */
static inline void watch(lane_search *search, tdmf_guard guard, choice watching, const guard_series *g,
                         real floor) {
    const real *c = g->series;
    const real *power = search->power;
    const real reach = real_abs(g->factor);
    const real tail = reach * weighted_sum(c, power, 3, g->order);
    const real spread = tail + reach * (real_abs(c[1]) * power[1] + real_abs(c[2]) * power[2]);
    choice near = watching & search->live & ~(g->start > spread);
    if (!any(near)) {
        return;
    }
    const real bound_at_start = 6.0 * tail / power[3];
    near &= ~stays_above(search, g, g->start - floor, bound_at_start);
    if (!any(near)) {
        return;
    }
    if (any(near & search->looking)) {
        march_up(search);
    }
    look_at(search, guard, near, g, floor, bound_at_start);
}

#endif
