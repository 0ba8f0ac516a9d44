/* Observed quantities over a step: the integral of a positive part, the largest value. Written over `real`;
 * the lanes in which a quantity may change its sign, or turn, are treated one by one.
 */
#ifndef TDMF_KERNEL_OBSERVED_H
#define TDMF_KERNEL_OBSERVED_H

#include "page_step.h"

/* The integral over a step where a polynomial g, scaled to the step, is positive. Where its values are
 * smaller than `least`, its sign does not matter. */
double tdmf_integral_where_positive(const double *g, int order, double least);

/* The largest value of a polynomial that is scaled to the step; at least `largest`. */
double tdmf_largest_in_step(const double *g, int order, double largest);

static const double part_tolerance = 0.01; /* of a positive integral, relative to that of a step */

static inline interval bounds_of_observed(const page_step *step, int watch) {
    return step->motion->bounds ? step->bounds[step->guard_count + watch] : unbounded();
}

/* Lanes in which an observed quantity may have an effect that is not known without its polynomial. The rate
 * of a state has none while its sign is known. */
static inline mask needs_polynomial(const page_step *step, int watch, tdmf_part part, real value) {
    const interval bounds = bounds_of_observed(step, watch);
    if (part == TDMF_LARGEST) {
        return mask_not(bounds.high <= value);
    }
    const mask may_be_positive = mask_not(bounds.high <= 0.0);
    return step->motion->integrals[watch] < 0 ? may_be_positive
                                              : may_be_positive & mask_not(bounds.low >= 0.0);
}

static inline const real *expanded(page_step *step, int watch) {
    if (!step->is_expanded[watch]) {
        step->motion->polynomials[step->guard_count + watch](step->c, step->s[0], step->order,
                                                             step->observed[watch]);
        step->is_expanded[watch] = true;
    }
    return step->observed[watch];
}

/* Ends the step where the series of an observed quantity can be trusted no further. `value` is that of its
 * state, `scale` the scale of the state. */
static inline void trust_observed(page_step *step, int watch, tdmf_part part, real value, real scale,
                                  mask lanes) {
    lanes &= needs_polynomial(step, watch, part, value);
    if (any(lanes)) {
        const real allowed = guard_tolerance * step->tolerance * scale;
        trust(step, expanded(step, watch), part == TDMF_LARGEST ? allowed : allowed / step->size, lanes);
    }
}

static inline void scaled_lane(const page_step *step, const real *g, int lane, double *own) {
    for (int k = 0; k < step->order; ++k) {
        own[k] = lane_of(&g[k], lane) * lane_of(&step->power[k], lane);
    }
}

/* The integral over the step where the quantity is positive. */
static inline real positive_integral(page_step *step, int watch, real least, mask lanes) {
    const int order = step->order, state = step->motion->integrals[watch];
    const interval bounds = bounds_of_observed(step, watch);
    lanes &= mask_not(bounds.high <= 0.0);
    if (!any(lanes)) {
        return broadcast(0.0);
    }
    real whole;
    const real *g = NULL;
    if (state >= 0) {
        whole = change_of(step->s[state], step->power, order);
    } else {
        real integral[TERMS];
        g = expanded(step, watch);
        for (int k = 0; k < order; ++k) {
            integral[k + 1] = g[k] * series_reciprocal[k + 1];
        }
        whole = change_of(integral, step->power, order);
    }
    real sum = select(lanes, real_max(broadcast(0.0), whole), broadcast(0.0));
    lanes &= mask_not(bounds.low >= 0.0);
    if (!any(lanes)) {
        return sum;
    }
    g = expanded(step, watch);
    const real size = step->power[1];
    const interval range = interval_of_series(g, step->power, order);
    lanes &= mask_not((range.low >= 0.0) | (range.high <= 0.0) | (size * (range.high - range.low) < least));
    for (int lane = 0; lane < LANES; ++lane) {
        if (has_lane(&lanes, lane)) {
            double own[TERMS];
            const double length = lane_of(&size, lane);
            scaled_lane(step, g, lane, own);
            set_lane(&sum, lane,
                     length * tdmf_integral_where_positive(own, order, lane_of(&least, lane) / length));
        }
    }
    return sum;
}

/* The largest value is that at an end, or where the rate changes its sign. */
static inline real largest_value(page_step *step, int watch, real largest, mask lanes) {
    const int order = step->order;
    lanes &= mask_not(bounds_of_observed(step, watch).high <= largest);
    if (!any(lanes)) {
        return largest;
    }
    const real *g = expanded(step, watch);
    lanes &= mask_not(g[0] + largest_change(g, step->power, order - 1) <= largest);
    for (int lane = 0; lane < LANES; ++lane) {
        if (has_lane(&lanes, lane)) {
            double own[TERMS];
            scaled_lane(step, g, lane, own);
            set_lane(&largest, lane, tdmf_largest_in_step(own, order, lane_of(&largest, lane)));
        }
    }
    return largest;
}

/* The value of the state of an observed quantity after a step whose powers are set. */
static inline real observed_value(page_step *step, int watch, tdmf_part part, real value, real scale,
                                  mask lanes) {
    if (part == TDMF_LARGEST) {
        return largest_value(step, watch, value, lanes);
    }
    const real least = part_tolerance * step->tolerance * scale;
    return value + positive_integral(step, watch, least, lanes);
}

#endif
