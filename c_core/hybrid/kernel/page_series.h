/* Recursions and interval arithmetic for derived motions, beside series_products.h. Written over `real`,
 * which is one number or several lanes. */
#ifndef TDMF_KERNEL_PAGE_SERIES_H
#define TDMF_KERNEL_PAGE_SERIES_H

#include "pairs.h"
#include "powers.h"
#include "series_products.h"

enum { TERMS = SERIES_TERMS };

/* ---- functions of numbers ------------------------------------------------------------------------------ */

#ifdef TDMF_LANES
static inline real in_each_lane(double function(double), real x) {
    for (int lane = 0; lane < LANES; ++lane) {
        x[lane] = function(x[lane]);
    }
    return x;
}

#define real_sin(x)   in_each_lane(sin, x)
#define real_cos(x)   in_each_lane(cos, x)
#define real_log(x)   in_each_lane(log, x)
#define real_expm1(x) in_each_lane(expm1, x)
#define real_log1p(x) in_each_lane(log1p, x)

static inline void portable_sine_and_cosine(real x, real *sine, real *cosine) {
    sine_and_cosine(x, sine, cosine);
}
#else
#include "trigonometry.h"

#define real_sin   sin
#define real_cos   cos
#define real_log   log
#define real_expm1 expm1
#define real_log1p log1p

/* The bits are those of lane_math.h. */
static inline void portable_sine_and_cosine(real x, real *sine, real *cosine) {
    if (!(fabs(x) < farthest_angle)) {
        *sine = sin(x);
        *cosine = cos(x);
        return;
    }
    const real quarters = nearest_quarters(x), rest = without_quarters(x, quarters);
    const int64_t quadrant = (int64_t)quarters;
    const real s = sine_near_zero(rest), c = cosine_near_zero(rest);
    const real own = quadrant & 1 ? c : s, other = quadrant & 1 ? s : c;
    *sine = quadrant & 2 ? -own : own;
    *cosine = (quadrant + 1) & 2 ? -other : other;
}
#endif

/* ---- coefficients of functions ------------------------------------------------------------------------- */

/* Coefficient k of q, where q q = p. */
static inline real own_root_of(int k, real p, const real *q) {
    real inner = broadcast(0.0);
    for (int i = 1; i < k; ++i) {
        inner += q[i] * q[k - i];
    }
    return k == 0 ? real_sqrt(p) : 0.5 * (p - inner) / q[0];
}

/* Coefficient k of the logarithm l of a, by a l' = a'. */
static inline real log_of(int k, const real *a, const real *l) {
    real inner = broadcast(0.0);
    for (int i = 1; i < k; ++i) {
        inner += (double)i * l[i] * a[k - i];
    }
    return k == 0 ? real_log(a[0]) : (a[k] - inner * series_reciprocal[k]) / a[0];
}

/* Coefficient k of the sine and cosine of a, by k sine[k] = sum of i a[i] cosine[k - i]. */
static inline void sine_and_cosine_of(int k, const real *a, real *sine, real *cosine) {
    real with_cosine = broadcast(0.0), with_sine = broadcast(0.0);
    if (k == 0) {
        portable_sine_and_cosine(a[0], &sine[0], &cosine[0]);
        return;
    }
    for (int i = k; i > 0; --i) {
        const real rate = (double)i * a[i];
        with_cosine += rate * cosine[k - i];
        with_sine += rate * sine[k - i];
    }
    sine[k] = with_cosine * series_reciprocal[k];
    cosine[k] = -with_sine * series_reciprocal[k];
}

/* Those of an angle whose rate has a series. Two sums for each: one would wait for each of its terms. */
static inline void sine_and_cosine_by_rate(int k, const real *a, const real *rate, real *sine, real *cosine) {
    real of_cosine[2] = {broadcast(0.0), broadcast(0.0)}, of_sine[2] = {broadcast(0.0), broadcast(0.0)};
    int i = 0;
    if (k == 0) {
        portable_sine_and_cosine(a[0], &sine[0], &cosine[0]);
        return;
    }
    for (; i + 1 < k; i += 2) {
        of_cosine[0] += rate[i] * cosine[k - 1 - i];
        of_sine[0] += rate[i] * sine[k - 1 - i];
        of_cosine[1] += rate[i + 1] * cosine[k - 2 - i];
        of_sine[1] += rate[i + 1] * sine[k - 2 - i];
    }
    if (i < k) {
        of_cosine[0] += rate[i] * cosine[0];
        of_sine[0] += rate[i] * sine[0];
    }
    sine[k] = (of_cosine[0] + of_cosine[1]) * series_reciprocal[k];
    cosine[k] = -(of_sine[0] + of_sine[1]) * series_reciprocal[k];
}

/* ---- intervals: bounds of guards and observed quantities in a step, found before they are expanded ------
 */

typedef struct {
    real low, high;
} interval;

static inline interval interval_at(real low, real high) {
    const interval at = {low, high};
    return at;
}

static inline interval unbounded(void) {
    return interval_at(broadcast(-INFINITY), broadcast(INFINITY));
}

/* A polynomial on [0, 1] is a mean of its partial sums. */
static inline interval interval_of_series(const real *c, const real *power, int order) {
    interval of = {c[0], c[0]};
    real sum = c[0];
    for (int k = 1; k < order; ++k) {
        sum += c[k] * power[k];
        of.low = real_min(of.low, sum);
        of.high = real_max(of.high, sum);
    }
    return of;
}

/* The rate of a quantity, by its series. */
static inline interval interval_of_rate(const real *c, const real *power, int order) {
    interval of = {c[1], c[1]};
    real sum = c[1];
    for (int k = 1; k < order; ++k) {
        sum += (double)(k + 1) * c[k + 1] * power[k];
        of.low = real_min(of.low, sum);
        of.high = real_max(of.high, sum);
    }
    return of;
}

/* The sine or cosine of an angle that turns by at most `turn`: a function f with slope f' at the start
 * changes by at most turn |f'| + turn^2/2. */
static inline interval interval_of_turn(real angle, interval of, bool is_sine) {
    const real turn = real_max(of.high - angle, angle - of.low);
    real sine, cosine;
    portable_sine_and_cosine(angle, &sine, &cosine);
    const real value = is_sine ? sine : cosine, slope = is_sine ? cosine : sine;
    const real change = turn * (real_abs(slope) + 0.5 * turn);
    return interval_at(real_max(value - change, broadcast(-1.0)), real_min(value + change, broadcast(1.0)));
}

static inline interval interval_sum(interval a, interval b) {
    return interval_at(a.low + b.low, a.high + b.high);
}

static inline interval interval_difference(interval a, interval b) {
    return interval_at(a.low - b.high, a.high - b.low);
}

static inline interval interval_square(interval a) {
    const real of_low = a.low * a.low, of_high = a.high * a.high;
    const mask has_zero = mask_not((a.low > 0.0) | (a.high < 0.0));
    return interval_at(select(has_zero, broadcast(0.0), real_min(of_low, of_high)),
                       real_max(of_low, of_high));
}

static inline interval interval_product(interval a, interval b) {
    const real ll = a.low * b.low, lh = a.low * b.high, hl = a.high * b.low, hh = a.high * b.high;
    return interval_at(real_min(real_min(ll, lh), real_min(hl, hh)),
                       real_max(real_max(ll, lh), real_max(hl, hh)));
}

#endif
