/* Observed quantities over a step: the integral of a positive part, the largest value, and their variations.
 * Written over `real`; the lanes in which a quantity may change its sign, or turn, are treated one by one.
 *
 * The integral varies by the variation where the quantity is positive, and the largest value by that at its
 * time. Both also change with the time of an event that ends the step: by their rates there.
 */
#ifndef TDMF_KERNEL_OBSERVED_H
#define TDMF_KERNEL_OBSERVED_H

#include "page_step.h"

/* The part of an integral over a step that grows, and the pieces where it does. All polynomials are scaled to
 * the step; the integral is 0 at its start. Its rate changes its sign where one of the factors does; where
 * the values of a factor are smaller than `least`, its sign does not matter. */
double tdmf_integral_where_positive(const double *integral, int order, const double (*factors)[TERMS],
                                    int factor_count, double least, positive_pieces *pieces);

/* The integral of a polynomial over pieces of a step. */
double tdmf_integral_over(const double *g, int order, const positive_pieces *pieces);

/* The largest value of a polynomial that is scaled to the step; at least `largest`. If it is larger, `share`
 * receives its time. At the beginning of the step it has to be larger by `rounding`: there it may be the one
 * that is known. */
double tdmf_largest_in_step(const double *g, int order, double rounding, double largest, double *share);

static const double part_tolerance = 0.01; /* tolerance of a positive integral, relative to that of a step */

static inline bool is_largest(const page_step *step, int watch) {
    return step->watches[watch].part == TDMF_LARGEST;
}

static inline real scale_of_observed(const page_step *step, int watch) {
    return step->units[step->motion->moving_count + watch];
}

/* True if the sign of a quantity is the sign of a product of series. */
static inline bool has_factors(const page_step *step, int watch) {
    return step->motion->factors[2 * watch] >= 0;
}

static inline interval bounds_of_observed(const page_step *step, int watch) {
    const bool is_bounded = step->motion->bounds && !has_factors(step, watch);
    return is_bounded ? step->bounds[step->guard_count + watch] : unbounded();
}

/* Lanes in which a polynomial may change its sign in the step. */
static inline mask may_change_sign(const page_step *step, const real *g) {
    const mask changes = mask_not(real_abs(g[0]) > largest_change(g, step->power, step->order - 1));
    if (!any(changes)) {
        return changes;
    }
    const interval range = interval_of_series(g, step->power, step->order);
    return changes & mask_not((range.low > 0.0) | (range.high < 0.0));
}

/* Finds the lanes in which the factors of a quantity may change their sign. */
static inline mask find_changes(page_step *step, int watch) {
    observed_part *of = &step->observed[watch];
    const int *factors = step->motion->factors + 2 * watch;
    for (int i = 0; i < 2; ++i) {
        of->changes[i] = factors[i] >= 0 ? may_change_sign(step, step->s[factors[i]]) : mask_of(false);
    }
    return of->changes[0] | of->changes[1];
}

/* Lanes in which an observed quantity may have an effect that is not known without its polynomial. The rate
 * of a state has none while its sign is known. */
static inline mask needs_polynomial(page_step *step, int watch, real value) {
    const interval bounds = bounds_of_observed(step, watch);
    if (is_largest(step, watch)) {
        return mask_not(bounds.high <= value);
    }
    if (has_factors(step, watch)) {
        return find_changes(step, watch);
    }
    const mask may_be_positive = mask_not(bounds.high <= 0.0);
    return step->motion->integrals[watch] < 0 ? may_be_positive
                                              : may_be_positive & mask_not(bounds.low >= 0.0);
}

static inline const real *expanded(page_step *step, int watch) {
    observed_part *of = &step->observed[watch];
    if (!of->is_expanded) {
        step->motion->polynomials[step->guard_count + watch](step->c, step->s[0], step->order, of->g);
        of->is_expanded = true;
    }
    return of->g;
}

/* Ends the step where the series of an observed quantity can be trusted no further. `value` is that of its
 * state. */
static inline void trust_observed(page_step *step, int watch, real value, mask lanes) {
    const int state = step->motion->integrals[watch], last = step->order - 1;
    lanes &= needs_polynomial(step, watch, value);
    if (!any(lanes)) {
        return;
    }
    const real allowed = guard_tolerance * step->tolerance * scale_of_observed(step, watch);
    if (is_largest(step, watch)) {
        trust(step, expanded(step, watch), allowed, lanes);
    } else if (state < 0) {
        trust(step, expanded(step, watch), allowed / step->size, lanes);
    } else { /* the rate of a state */
        const real *c = step->s[state];
        trust_terms(step, (double)last * c[last], (double)(last + 1) * c[last + 1], allowed / step->size,
                    lanes);
    }
}

static inline void scaled_lane(const page_step *step, const real *g, int terms, int lane, double *own) {
    for (int k = 0; k < terms; ++k) {
        own[k] = lane_of(&g[k], lane) * lane_of(&step->power[k], lane);
    }
}

/* Writes the integral of a polynomial, but for coefficient 0. */
static inline void integrate_polynomial(const real *g, int terms, real *integral) {
    for (int k = 0; k < terms; ++k) {
        integral[k + 1] = g[k] * series_reciprocal[k + 1];
    }
}

/* Lanes in which the sign of an observed quantity is not known. */
static inline mask has_unknown_sign(page_step *step, int watch, mask lanes) {
    const observed_part *of = &step->observed[watch];
    if (has_factors(step, watch)) {
        return lanes & (of->changes[0] | of->changes[1]);
    }
    lanes &= mask_not(bounds_of_observed(step, watch).low >= 0.0);
    if (!any(lanes)) {
        return lanes;
    }
    const interval range = interval_of_series(expanded(step, watch), step->power, step->order);
    return lanes & mask_not((range.low >= 0.0) | (range.high <= 0.0));
}

/* The integral in a lane where the quantity is positive in pieces of the step. */
static inline double integral_in_lane(page_step *step, int watch, const real *integral, double least,
                                      int lane) {
    observed_part *of = &step->observed[watch];
    const int *factors = step->motion->factors + 2 * watch;
    const bool is_product = has_factors(step, watch);
    double own[TERMS], of_factors[2][TERMS];
    int count = 0;
    scaled_lane(step, integral, step->order + 1, lane, own);
    own[0] = 0.0;
    if (!is_product) {
        scaled_lane(step, expanded(step, watch), step->order, lane, of_factors[count++]);
    }
    for (int i = 0; i < 2; ++i) {
        if (is_product && has_lane(&of->changes[i], lane)) {
            scaled_lane(step, step->s[factors[i]], step->order, lane, of_factors[count++]);
        }
    }
    return tdmf_integral_where_positive(own, step->order, (const double(*)[TERMS])of_factors, count,
                                        is_product ? 0.0 : least, &of->pieces[lane]);
}

/* The integral over the step where the quantity is positive. */
static inline real positive_integral(page_step *step, int watch, mask lanes) {
    observed_part *of = &step->observed[watch];
    const real least = part_tolerance * step->tolerance * scale_of_observed(step, watch);
    const int state = step->motion->integrals[watch];
    real own[TERMS];
    lanes &= mask_not(bounds_of_observed(step, watch).high <= 0.0);
    if (!any(lanes)) {
        return broadcast(0.0);
    }
    if (state < 0) {
        integrate_polynomial(expanded(step, watch), step->order, own);
    }
    const real *integral = state >= 0 ? step->s[state] : own;
    const real whole = change_of(integral, step->power, step->order);
    real sum = select(lanes, real_max(broadcast(0.0), whole), broadcast(0.0));
    of->is_positive = lanes & (whole > 0.0);
    lanes = has_unknown_sign(step, watch, lanes);
    if (any(lanes)) {
        lanes &= mask_not(largest_change(integral, step->power, step->order) < least);
    }
    of->is_positive &= mask_not(lanes);
    of->has_pieces = lanes;
    for (int lane = 0; lane < LANES; ++lane) {
        if (has_lane(&lanes, lane)) {
            const double most = lane_of(&least, lane) / lane_of(&step->power[1], lane);
            set_lane(&sum, lane, integral_in_lane(step, watch, integral, most, lane));
        }
    }
    return sum;
}

/* The largest value is that at an end, or where the rate changes its sign. */
static inline real largest_value(page_step *step, int watch, real largest, mask lanes) {
    observed_part *of = &step->observed[watch];
    const int order = step->order;
    const real band = zero_margin * scale_of_observed(step, watch);
    lanes &= mask_not(bounds_of_observed(step, watch).high <= largest);
    if (!any(lanes)) {
        return largest;
    }
    const real *g = expanded(step, watch);
    lanes &= mask_not(g[0] + largest_change(g, step->power, order - 1) <= largest);
    for (int lane = 0; lane < LANES; ++lane) {
        if (has_lane(&lanes, lane)) {
            double own[TERMS], share = lane_of(&of->share, lane);
            const double rounding = lane_of(&band, lane);
            scaled_lane(step, g, order, lane, own);
            set_lane(&largest, lane,
                     tdmf_largest_in_step(own, order, rounding, lane_of(&largest, lane), &share));
            set_lane(&of->share, lane, share);
        }
    }
    return largest;
}

/* The value of the state of an observed quantity after a step whose powers are set. `value` is that before
 * the step. */
static inline real observe(page_step *step, int watch, real value, mask lanes) {
    observed_part *of = &step->observed[watch];
    of->is_positive = of->has_pieces = mask_of(false);
    of->share = broadcast(-1.0);
    return is_largest(step, watch) ? largest_value(step, watch, value, lanes)
                                   : value + positive_integral(step, watch, lanes);
}

/* ---- variations ---------------------------------------------------------------------------------------- */

/* Variation of a largest value. A largest value at the beginning of the step also varies with the time of the
 * event there. */
static inline real variation_of_largest(const page_step *step, int watch, const real *dg, real shift,
                                        real varied) {
    const observed_part *of = &step->observed[watch];
    const real here = expansion_at(dg, step->order - 1, of->share * step->power[1]).value;
    const real moved = select(of->share > 0.0, broadcast(0.0), of->g[1] * shift);
    return select(of->share >= 0.0, here + moved, varied);
}

/* The change of a variation where the quantity is positive in pieces of the step. */
static inline void change_in_pieces(const page_step *step, int watch, const real *dg, real *change) {
    const observed_part *of = &step->observed[watch];
    const real size = step->power[1];
    for (int lane = 0; lane < LANES; ++lane) {
        if (has_lane(&of->has_pieces, lane)) {
            double own[TERMS];
            scaled_lane(step, dg, step->order, lane, own);
            set_lane(change, lane,
                     lane_of(&size, lane) * tdmf_integral_over(own, step->order, &of->pieces[lane]));
        }
    }
}

/* The variation of the state of a quantity that `observe` has observed, by variations t of the series. `d`
 * holds those of the constants, `shift` the variation of the time of an event at which the step begins, and
 * `varied` the variation before the step. */
static inline real observed_variation(const page_step *step, int watch, const real *d, real (*t)[TERMS],
                                      real shift, real varied) {
    const tdmf_motion_kind *m = step->motion;
    const observed_part *of = &step->observed[watch];
    const int state = m->integrals[watch];
    const mask lanes = is_largest(step, watch) ? of->share >= 0.0 : of->is_positive | of->has_pieces;
    real dg[TERMS];
    if (!any(lanes)) {
        return varied;
    }
    const bool is_state = !is_largest(step, watch) && state >= 0;
    if (!is_state || any(of->has_pieces)) {
        m->vary_observed[watch](step->c, step->s[0], d, t[0], step->order, dg);
    }
    if (is_largest(step, watch)) {
        return variation_of_largest(step, watch, dg, shift, varied);
    }
    real own[TERMS];
    if (!is_state) {
        integrate_polynomial(dg, step->order, own);
    }
    const real whole = change_of(is_state ? t[state] : own, step->power, step->order);
    real change = select(of->is_positive, whole, broadcast(0.0));
    change_in_pieces(step, watch, dg, &change);
    return varied + change;
}

/* The rate of a state that changes, at the beginning of the step. A largest value has none: either it is an
 * earlier one, or its variation is that at the time of the event. */
static inline real rate_after_event(page_step *step, int i, mask lanes) {
    const int watch = i - step->motion->moving_count;
    if (watch < 0) {
        return step->s[i][1];
    }
    lanes &= mask_not(bounds_of_observed(step, watch).high <= 0.0);
    if (is_largest(step, watch) || !any(lanes)) {
        return broadcast(0.0);
    }
    return select(lanes, real_max(expanded(step, watch)[0], broadcast(0.0)), broadcast(0.0));
}

/* The rate of a state that changes, at the time whose powers are set. A largest value grows if it is the
 * value at that time. */
static inline real rate_before_event(page_step *step, int i, real value, mask lanes) {
    const int watch = i - step->motion->moving_count;
    if (watch < 0) {
        return rate_of(step->s[i], step->power, step->order);
    }
    const bool may_grow = is_largest(step, watch);
    const real least = may_grow ? value - zero_margin * scale_of_observed(step, watch) : broadcast(0.0);
    lanes &= mask_not(bounds_of_observed(step, watch).high <= least);
    if (!any(lanes)) {
        return broadcast(0.0);
    }
    const real *g = expanded(step, watch);
    const real now = sum_of(g, step->power, step->order - 1);
    const real rate = may_grow ? rate_of(g, step->power, step->order - 1) : now;
    return select(lanes & (now > least), real_max(rate, broadcast(0.0)), broadcast(0.0));
}

#endif
