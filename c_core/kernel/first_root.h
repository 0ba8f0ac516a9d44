/* The first root of a polynomial on [0, 1], none missed: in every lane that of a polynomial of its own.
 *
 * From t on, up to t + D, with the third derivative bounded by C = sum k (k - 1) (k - 2) |c_k|,
 *
 *     p(t + d) >= p(t) + p'(t) d + (p''(t) - C D/3) d^2/2,
 *
 * so no root lies before the first positive root of the right-hand side. Going there again and again comes up
 * to the first root from below and never beyond it, as fast as Newton's method does; a polynomial that only
 * comes near zero is passed. From t = 0 the coefficients themselves serve: what they add up to from k = 3 on,
 * sum |c_k| d^k, is at most d^3 sum |c_k|, which has the place of C d^3/6 and is several times smaller. */
#ifndef TDMF_KERNEL_FIRST_ROOT_H
#define TDMF_KERNEL_FIRST_ROOT_H

#include "series.h"
#include "width.h"

/* Next to a multiple root convergence is slow, and rounding may stall it. */
enum { ROOT_ITERATION_LIMIT = 200 };

/* Share of the floor within which a polynomial counts as having come down to it. */
static const double close_enough = 0.25;

/* How many times further than what is known to be safe is tried next. */
static const double trial_factor = 5.0;

/* k, k (k - 1) and k (k - 1) (k - 2). */
static const double first_derivative[SERIES_TERMS] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                                      10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
                                                      20, 21, 22, 23, 24, 25, 26, 27, 28, 29};
static const double second_derivative[SERIES_TERMS] = {0,   0,   2,   6,   12,  20,  30,  42,  56,  72,
                                                       90,  110, 132, 156, 182, 210, 240, 272, 306, 342,
                                                       380, 420, 462, 506, 552, 600, 650, 702, 756, 812};
static const double third_derivative[SERIES_TERMS] = {
    0,    0,    0,    6,    24,   60,   120,  210,  336,   504,   720,   990,   1320,  1716,  2184,
    2730, 3360, 4080, 4896, 5814, 6840, 7980, 9240, 10626, 12144, 13800, 15600, 17550, 19656, 21924};

/* What a search has found: the time of a root, or how far there is none. And the time before it from which a
 * polynomial falls from zero down to its floor; that of the root where it is not seen to. */
typedef struct {
    real time;
    mask is_root;
    real zero;
} root;

/* A polynomial's value and derivatives. */
typedef struct {
    real value, slope, curvature;
} expansion;

/* Even and odd powers apart, each a polynomial of t^2: one sum would wait for each of its terms. */
static inline expansion expansion_at(const real *c, int order, real t) {
    const real square = t * t;
    real even = broadcast(0.0), even_slope = broadcast(0.0), even_curvature = broadcast(0.0);
    real odd = broadcast(0.0), odd_slope = broadcast(0.0), odd_curvature = broadcast(0.0);
    int k = order;
    if (k % 2 == 0) {
        even = c[k--];
    }
    for (; k > 0; k -= 2) {
        even_curvature = even_curvature * square + even_slope;
        odd_curvature = odd_curvature * square + odd_slope;
        even_slope = even_slope * square + even;
        odd_slope = odd_slope * square + odd;
        even = even * square + c[k - 1];
        odd = odd * square + c[k];
    }
    const expansion at = {
        even + t * odd,
        2.0 * t * even_slope + (odd + 2.0 * square * odd_slope),
        2.0 * even_slope + 8.0 * square * even_curvature +
            t * (6.0 * odd_slope + 8.0 * square * odd_curvature),
    };
    return at;
}

static inline expansion expansion_at_start(const real *c, int order) {
    const expansion at = {c[0], order > 0 ? c[1] : broadcast(0.0), order > 1 ? 2.0 * c[2] : broadcast(0.0)};
    return at;
}

/* Sums from k = 3 on: of |c[k]|, which bounds a series at its start, and of what bounds a derivative on [0,
 * 1]. */
static inline real sum_of_tail(const real *c, int order) {
    real even = broadcast(0.0), odd = broadcast(0.0);
    int k = 3;
    for (; k < order; k += 2) {
        odd += real_abs(c[k]);
        even += real_abs(c[k + 1]);
    }
    if (k == order) {
        odd += real_abs(c[k]);
    }
    return even + odd;
}

static inline real bound_of_derivative(const real *c, const double weights[SERIES_TERMS], int order) {
    real even = broadcast(0.0), odd = broadcast(0.0);
    int k = 3;
    for (; k < order; k += 2) {
        odd += weights[k] * real_abs(c[k]);
        even += weights[k + 1] * real_abs(c[k + 1]);
    }
    if (k == order) {
        odd += weights[k] * real_abs(c[k]);
    }
    return even + odd;
}

/* value + slope d + curvature d^2/2 is positive for all d up to `left`. */
static inline mask stays_positive(real value, real slope, real curvature, real left) {
    const mask at_end = value + left * (slope + 0.5 * curvature * left) > 0.0;
    return at_end & ((curvature <= 0.0) | (slope >= 0.0) | (-slope >= curvature * left) |
                     (slope * slope < 2.0 * curvature * value));
}

/* The first positive root of a parabola that has one, written without cancellation. */
static inline real root_of_parabola(real value, real slope, real curvature) {
    const real discriminant = real_sqrt(real_max(broadcast(0.0), slope * slope - 2.0 * curvature * value));
    const mask falls = slope < 0.0;
    return select(falls, 2.0 * value, -(slope + discriminant)) /
           select(falls, discriminant - slope, curvature);
}

/* How far from a point no root lies. The shorter the interval that the bound must hold for, the further it
 * reaches within it. */
static inline real safe_distance(const expansion *at, real bound, real left, mask searching) {
    const real lowest = at->curvature - bound * left * (1.0 / 3.0);
    const mask none = stays_positive(at->value, at->slope, lowest, left);
    if (!any(searching & mask_not(none))) {
        return broadcast(INFINITY);
    }
    real safe = root_of_parabola(at->value, at->slope, lowest);
    mask tries = searching & mask_not(none) & (safe > 0.0);
    for (;;) {
        const real near = trial_factor * safe;
        tries &= near < left;
        if (!any(tries)) {
            return select(none, broadcast(INFINITY), safe);
        }
        const real nearby = at->curvature - bound * near * (1.0 / 3.0);
        const mask passes = tries & stays_positive(at->value, at->slope, nearby, near);
        const real further = real_max(safe, root_of_parabola(at->value, at->slope, nearby));
        safe = select(passes, near, select(tries, further, safe));
        tries = passes;
    }
}

/* Next to its floor a polynomial that crosses it is a straight line, from well above zero on: else it began
 * about there, or only touches, and zero is not to be told from the floor. */
static inline real zero_before(const expansion *at, real time, real from) {
    const real since = at->value / at->slope;
    const real above = (1.0 + close_enough) * since;
    const mask is_line = (at->slope < 0.0) & (time - above >= from) &
                         (real_abs(at->curvature) * above <= close_enough * real_abs(at->slope));
    return select(is_line, time - since, time);
}

/* The first t in [from, to], in the lanes that search, at which a polynomial is no larger than `floor`, which
 * is below zero. Without one, time is infinity, or less than `to` where the search took too long: there is no
 * root before. `from` is not negative, and in all lanes zero or in none; `to` is no larger than 1. */
static inline root first_root(const real *c, int order, real floor, real from, real to, mask searching) {
    const bool from_start = !any(from > 0.0);
    const real down = close_enough * real_abs(floor);
    expansion at = from_start ? expansion_at_start(c, order) : expansion_at(c, order, from);
    real bound = from_start ? 6.0 * sum_of_tail(c, order) : bound_of_derivative(c, third_derivative, order);
    root found = {from, mask_of(false), from};
    for (int i = 0; i < ROOT_ITERATION_LIMIT; ++i) {
        const expansion above = {at.value - floor, at.slope, at.curvature};
        const mask due = searching & mask_not(above.value > down);
        found.is_root |= due;
        searching &= mask_not(due);
        if (!any(searching)) {
            break;
        }
        const real next = found.time + safe_distance(&above, bound, to - found.time, searching);
        const mask past_end = searching & (next > to);
        found.time = select(past_end, broadcast(INFINITY), select(searching, next, found.time));
        searching &= mask_not(past_end);
        if (!any(searching)) {
            break;
        }
        if (i == 0 && from_start) {
            bound = bound_of_derivative(c, third_derivative, order);
        }
        at = expansion_at(c, order, found.time);
    }
    found.zero = zero_before(&at, found.time, from);
    return found;
}

/* The first t in (from, to] at which a polynomial changes its sign; values up to `zero` count as zero. */
static inline root first_sign_change(const real *c, int order, real zero, real from, real to,
                                     mask searching) {
    real above[SERIES_TERMS];
    const expansion at = expansion_at(c, order, from);
    const real leading = select(real_abs(at.value) > zero, at.value, at.slope);
    const real sign = select(leading < 0.0, broadcast(-1.0), broadcast(1.0));
    for (int k = 0; k <= order; ++k) {
        above[k] = sign * c[k];
    }
    return first_root(above, order, -2.0 * zero, from, to, searching);
}

#endif
