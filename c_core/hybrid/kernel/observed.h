/* Observed quantities over a step: the integral of a positive part, the largest value. Written over `real`;
 * the lanes in which a quantity changes its sign, or turns, are treated one by one.
 */
#ifndef TDMF_KERNEL_OBSERVED_H
#define TDMF_KERNEL_OBSERVED_H

#include "page_step.h"

/* The integral over a step where a polynomial is positive, by pieces of one sign. `g` is scaled to the step,
 * `integral` is not. */
double tdmf_integral_of_pieces(const double *g, const double *integral, int order, double size);

/* The largest value of a polynomial that is scaled to the step and turns within it; at least `largest`. */
double tdmf_largest_of_pieces(const double *g, int order, double largest);

static const double part_tolerance = 0.01; /* of a positive integral, relative to that of a step */

static inline void copy_lane(const real *x, int count, int lane, double *own) {
    for (int k = 0; k < count; ++k) {
        own[k] = lane_of(&x[k], lane);
    }
}

/* The integral over the step where g is positive. The polynomial is not searched for changes of sign if its
 * integral is below `least`. */
static inline real positive_integral(const page_step *step, const real *g, real least, mask lanes) {
    const int order = step->order;
    const real tail = largest_change(g, step->power, order - 1), size = step->power[1];
    const mask none = g[0] + tail <= 0.0;
    lanes &= mask_not(none);
    if (!any(lanes)) {
        return broadcast(0.0);
    }
    real integral[TERMS];
    integral[0] = integral[order + 1] = broadcast(0.0);
    for (int k = 0; k < order; ++k) {
        integral[k + 1] = g[k] * series_reciprocal[k + 1];
    }
    real sum = select(none, broadcast(0.0), real_max(broadcast(0.0), sum_of(integral, step->power, order)));
    lanes &= mask_not((g[0] >= tail) | (size * (g[0] + tail) < least));
    if (any(lanes)) {
        const interval range = interval_of_series(g, step->power, order);
        lanes &=
            mask_not((range.low >= 0.0) | (range.high <= 0.0) | (size * (range.high - range.low) < least));
    }
    if (any(lanes)) {
        real scaled[TERMS];
        double own[TERMS], own_integral[TERMS];
        scale_to_step(step, 1.0, g, scaled);
        for (int lane = 0; lane < LANES; ++lane) {
            if (has_lane(&lanes, lane)) {
                copy_lane(scaled, order, lane, own);
                copy_lane(integral, order + 1, lane, own_integral);
                set_lane(&sum, lane, tdmf_integral_of_pieces(own, own_integral, order, lane_of(&size, lane)));
            }
        }
    }
    return sum;
}

/* The largest value is that at an end, or where the rate changes its sign. */
static inline real largest_value(const page_step *step, const real *g, real largest, mask lanes) {
    const int order = step->order;
    lanes &= mask_not(g[0] + largest_change(g, step->power, order - 1) <= largest);
    if (!any(lanes)) {
        return largest;
    }
    real scaled[TERMS], rates = broadcast(0.0), end = broadcast(0.0);
    scale_to_step(step, 1.0, g, scaled);
    for (int k = 1; k < order; ++k) {
        rates += real_abs((double)k * scaled[k]);
        end += scaled[k];
    }
    real found = real_max(largest, real_max(scaled[0], scaled[0] + end));
    found = select(lanes, found, largest);
    lanes &= mask_not(rates <= 2.0 * real_abs(scaled[1])); /* else the rate keeps its sign */
    for (int lane = 0; lane < LANES; ++lane) {
        if (has_lane(&lanes, lane)) {
            double own[TERMS];
            copy_lane(scaled, order, lane, own);
            set_lane(&found, lane, tdmf_largest_of_pieces(own, order, lane_of(&found, lane)));
        }
    }
    return found;
}

/* The value of an observed quantity after a step whose powers are set. */
static inline real observed_value(const page_step *step, int watch, tdmf_part part, real value, real scale,
                                  mask lanes) {
    real g[TERMS];
    step->motion->polynomials[step->guard_count + watch](step->c, step->s[0], step->order, g);
    if (part == TDMF_LARGEST) {
        return largest_value(step, g, value, lanes);
    }
    const real least = part_tolerance * step->tolerance * scale;
    return select(lanes, value + positive_integral(step, g, least, lanes), value);
}

#endif
