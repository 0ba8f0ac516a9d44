/* From t on, up to t + D, with the third derivative bounded by C = sum k (k - 1) (k - 2) |c_k| h^(k - 3), h
 * the step,
 *
 *     p(t + d) >= p(t) + p'(t) d + (p''(t) - C D/3) d^2/2,
 *
 * so no root lies before the first positive root of the right-hand side. Going there again and again comes up
 * to the first root from below and never beyond it, as fast as Newton's method does; a polynomial that only
 * comes near zero is passed. From t = 0 the coefficients themselves serve: what they add up to from k = 3 on,
 * sum |c_k| d^k, is at most (d/h)^3 sum |c_k| h^k, which has the place of C d^3/6 and is several times
 * smaller. */
#include "first_root.h"

/* Next to a multiple root a march is slow, and rounding may stall it. */
enum { MARCH_LIMIT = 200 };

/* Share of the floor within which a polynomial counts as having come down to it. */
static const double close_enough = 0.25;

/* How many times further than what is known to be safe the next look goes. */
static const double look_ahead = 3.0;

typedef struct {
    double value, slope, curvature;
} expansion;

void tdmf_reach_to(tdmf_reach *reach, double size, int order) {
    reach->power[0] = 1.0;
    for (int k = 1; k <= order; ++k) {
        reach->power[k] = reach->power[k - 1] * size;
    }
    for (int k = 3; k <= order; ++k) {
        reach->third[k] = (double)(k * (k - 1) * (k - 2)) * reach->power[k - 3];
    }
}

/* Four sums at once: one would wait for each of its terms. */
static inline double weighted_sum(const double *c, const double *weights, int first, int order) {
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    int k = first;
    for (; k + 3 <= order; k += 4) {
        for (int i = 0; i < 4; ++i) {
            sum[i] += weights[k + i] * fabs(c[k + i]);
        }
    }
    for (; k <= order; ++k) {
        sum[0] += weights[k] * fabs(c[k]);
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

double tdmf_spread(const double *c, int order, const tdmf_reach *reach) {
    return weighted_sum(c, reach->power, 1, order);
}

static expansion expand(const tdmf_polynomial *p, double t) {
    expansion at = {p->c[0], p->c[1], 2.0 * p->c[2]};
    if (t == 0.0) {
        return at;
    }
    double power = 1.0;
    double value = 0.0, slope = 0.0, curvature = 0.0;
    for (int k = 3; k <= p->order; ++k) {
        const double rate = (double)k * p->c[k] * power;
        value += p->c[k] * power;
        slope += rate;
        curvature += (double)(k - 1) * rate;
        power *= t;
    }
    at.value += t * (at.slope + t * (0.5 * at.curvature + t * value));
    at.slope += t * (at.curvature + t * slope);
    at.curvature += t * curvature;
    return at;
}

/* value + slope d + curvature d^2/2 is positive for all d up to `left`. */
static bool stays_positive(double value, double slope, double curvature, double left) {
    if (!(value + left * (slope + 0.5 * curvature * left) > 0.0)) {
        return false;
    }
    return curvature <= 0.0 || slope >= 0.0 || -slope >= curvature * left ||
           slope * slope < 2.0 * curvature * value;
}

/* The first positive root of a parabola that has one, written without cancellation. */
static double first_root_of_parabola(double value, double slope, double curvature) {
    const double discriminant = sqrt(fmax(0.0, slope * slope - 2.0 * curvature * value));
    return slope < 0.0 ? 2.0 * value / (discriminant - slope) : -(slope + discriminant) / curvature;
}

/* How far from t no root lies. The shorter the interval that the bound must hold for, the further it reaches
 * within it. */
static double safe_distance(const expansion *at, double bound, double left) {
    const double lowest = at->curvature - bound * left / 3.0;
    if (stays_positive(at->value, at->slope, lowest, left)) {
        return INFINITY;
    }
    double safe = first_root_of_parabola(at->value, at->slope, lowest);
    for (double near = look_ahead * safe; near > 0.0 && near < left; near *= look_ahead) {
        const double nearby = at->curvature - bound * near / 3.0;
        if (!stays_positive(at->value, at->slope, nearby, near)) {
            return fmax(safe, first_root_of_parabola(at->value, at->slope, nearby));
        }
        safe = near;
    }
    return safe;
}

tdmf_root tdmf_first_root(const tdmf_polynomial *p, const tdmf_reach *reach, double sign, double floor,
                          double from, double to) {
    double bound = 0.0;
    tdmf_root root = {from, false};
    for (int i = 0; i < MARCH_LIMIT; ++i) {
        expansion at = expand(p, root.time);
        at.value = sign * at.value - floor;
        at.slope *= sign;
        at.curvature *= sign;
        if (!(at.value > close_enough * fabs(floor))) {
            root.is_root = true;
            return root;
        }
        if (i == 0 && from == 0.0) {
            const double tail = weighted_sum(p->c, reach->power, 3, p->order) / reach->power[3];
            root.time = safe_distance(&at, 6.0 * tail, to);
        } else {
            bound = bound > 0.0 ? bound : weighted_sum(p->c, reach->third, 3, p->order);
            root.time += safe_distance(&at, bound, to - root.time);
        }
        if (root.time > to) {
            root.time = INFINITY;
            return root;
        }
    }
    return root;
}

tdmf_root tdmf_first_sign_change(const tdmf_polynomial *p, const tdmf_reach *reach, double floor, double from,
                                 double to) {
    const expansion at = expand(p, from);
    const double leading = fabs(at.value) > floor ? at.value : at.slope;
    return tdmf_first_root(p, reach, leading < 0.0 ? -1.0 : 1.0, -2.0 * floor, from, to);
}
