/* Derived from c_core/equations/flight.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_FLIGHT_SERIES_H
#define TDMF_DERIVED_FLIGHT_SERIES_H

#include "series_products.h"

/* What the motions depend on, and its rates where it changes in time. */
typedef struct {
    real inverse_reduced_mass;
    real stiffness;
    real damping;
    real gain;
    real rate_gain;
    real target;
    real torque;
    real rest_length;
    real push_x;
    real push_y;
    real torque_rate;
    real rest_length_rate;
    real push_x_rate;
    real push_y_rate;
} flight_coefficients;

/* Series of the states and of what is made of them, up to the order or one less. */
typedef struct {
    real square[SERIES_TERMS];
    real angle_rate[SERIES_TERMS];
    real rate_square[SERIES_TERMS];
    real speed_square[SERIES_TERMS];
    real length_rate[SERIES_TERMS];
    real length[SERIES_TERMS];
    real momentum[SERIES_TERMS];
    real angle[SERIES_TERMS];
    real push_moment[SERIES_TERMS];
    real sine[SERIES_TERMS];
    real cosine[SERIES_TERMS];
    real push_across[SERIES_TERMS];
} flight_series;

/* The first variations of some. */
typedef struct {
    real torque[SERIES_TERMS];
    real power[SERIES_TERMS];
    real length_rate[SERIES_TERMS];
    real length[SERIES_TERMS];
    real momentum[SERIES_TERMS];
    real angle[SERIES_TERMS];
    real square[SERIES_TERMS];
    real angle_rate[SERIES_TERMS];
    real rate_square[SERIES_TERMS];
    real cosine[SERIES_TERMS];
    real sine[SERIES_TERMS];
    real push_across[SERIES_TERMS];
} flight_variation;

/* What a motion starts with. */
typedef struct {
    real length;
    real angle;
    real length_rate;
    real angle_rate;
} flight_start;

/* The states, by a leg. */
static inline void tdmf_begin_flight(const flight_start *start, flight_series *written) {
    written->length[0] = start->length;
    written->angle[0] = start->angle;
    written->length_rate[0] = start->length_rate;
    written->momentum[0] = start->length * start->length * start->angle_rate;
}

/* Its change. */
static inline void tdmf_vary_begin_flight(const flight_start *start, const flight_start *d_start,
                                          flight_variation *written) {
    written->length[0] = d_start->length;
    written->angle[0] = d_start->angle;
    written->length_rate[0] = d_start->length_rate;
    written->momentum[0] = 2.0 * (start->length * d_start->length) * start->angle_rate +
                           start->length * start->length * d_start->angle_rate;
}

/* The highest rate at which leg, servo or what hangs in a push springs back or comes to rest. */
static inline real tdmf_fastest_flight(const flight_coefficients *c, real length, bool pushed) {
    if (pushed) {
        const real inverse_length = 1.0 / length;
        const real by_square = c->inverse_reduced_mass * inverse_length * inverse_length;
        const real stiffness = real_max(real_max(c->inverse_reduced_mass * c->stiffness, by_square * c->gain),
                                        (real_abs(c->push_x) + real_abs(c->push_y)) * inverse_length);
        return real_max(real_sqrt(stiffness),
                        real_max(c->inverse_reduced_mass * c->damping, by_square * c->rate_gain));
    }
    const real inverse_length = 1.0 / length;
    const real by_square = c->inverse_reduced_mass * inverse_length * inverse_length;
    const real stiffness = real_max(c->inverse_reduced_mass * c->stiffness, by_square * c->gain);
    return real_max(real_sqrt(stiffness),
                    real_max(c->inverse_reduced_mass * c->damping, by_square * c->rate_gain));
}

/* What drifts, some time later. */
static inline void tdmf_drift_flight(const flight_coefficients *c, real elapsed,
                                     flight_coefficients *written) {
    written->torque = c->torque + elapsed * c->torque_rate;
}

/* What is divided by. */
typedef struct {
    real inverse_square;
} flight_factors;

/* Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half. */
typedef struct {
    real square;
    real angle_rate;
    real rate_square;
    real length_times_rate_square;
    real speed_square;
} flight_sums;

/* Adds the terms with coefficient i of one factor and j of the other; of what is known ahead, of j + 1. */
KERNEL void add_flight_sums(const flight_series *s, int i, int j, flight_sums *sum) {
    sum->square += s->length[i] * s->length[j];
    sum->angle_rate += s->angle_rate[i] * s->square[j];
    sum->angle_rate += s->square[i] * s->angle_rate[j];
    sum->rate_square += s->angle_rate[i] * s->angle_rate[j];
    sum->length_times_rate_square += s->length[i] * s->rate_square[j];
    sum->length_times_rate_square += s->rate_square[i] * s->length[j];
    sum->speed_square += s->length_rate[i] * s->length_rate[j];
}

/* Sets the sums of coefficients 2 i and 2 i + 1 to the terms in the middle. */
KERNEL void begin_flight_sums(const flight_series *s, int i, flight_sums *sum, flight_sums *next) {
    sum->square = 0.5 * (s->length[i] * s->length[i]);
    next->square = broadcast(0.0);
    sum->angle_rate = (s->angle_rate[i] * s->square[i]);
    next->angle_rate = broadcast(0.0);
    sum->rate_square = 0.5 * (s->angle_rate[i] * s->angle_rate[i]);
    next->rate_square = broadcast(0.0);
    sum->length_times_rate_square = (s->length[i] * s->rate_square[i]);
    next->length_times_rate_square = broadcast(0.0);
    sum->speed_square = 0.5 * (s->length_rate[i] * s->length_rate[i]);
    next->speed_square = broadcast(0.0);
    (void)next;
}

/* vdot = r w^2 + M F_s, Ldot = M tau, w = L/r^2, and what the push on the body adds. From coefficient k of
 * the states to the next. */
KERNEL void expand_flight_on(const flight_coefficients *c, const flight_factors *by, int k,
                             const flight_sums *sum, flight_series *s) {
    integrate(s->length, k, s->length_rate[k]);
    /* square = length * length */
    s->square[k] = square_of(k, sum->square, s->length);
    /* angle_rate = momentum / square */
    s->angle_rate[k] =
        quotient_of(k, sum->angle_rate, s->momentum[k], s->angle_rate, s->square, by->inverse_square);
    /* rate_square = angle_rate * angle_rate */
    s->rate_square[k] = square_of(k, sum->rate_square, s->angle_rate);
    /* length_times_rate_square = length * rate_square */
    const real length_times_rate_square =
        product_of(k, sum->length_times_rate_square, s->length, s->rate_square);
    /* axial_force = stiffness * (rest_length - length) - damping * length_rate */
    const real axial_force = with_constant(k, -(c->stiffness * s->length[k]) - c->damping * s->length_rate[k],
                                           c->stiffness * c->rest_length);
    /* torque = gain * (target - angle) - rate_gain * angle_rate + torque */
    const real torque = with_drift(k, -(c->gain * s->angle[k]) - c->rate_gain * s->angle_rate[k],
                                   c->gain * c->target + c->torque, c->torque_rate);
    /* speed_square = length_rate * length_rate */
    s->speed_square[k] = square_of(k, sum->speed_square, s->length_rate);
    integrate(s->length_rate, k, length_times_rate_square + c->inverse_reduced_mass * axial_force);
    integrate(s->angle, k, s->angle_rate[k]);
    integrate(s->momentum, k, c->inverse_reduced_mass * torque);
}

/* From coefficient 0 of the states up to `order`; an odd order gets one coefficient more. */
KERNEL void expand_flight(const flight_coefficients *given, int order, flight_series *s) {
    const flight_coefficients copy = *given, *c = &copy;
    static const flight_sums none = {0};
    flight_sums sum = none, next = none;
    s->square[0] = s->length[0] * s->length[0];
    const flight_factors factors = {
        .inverse_square = 1.0 / s->square[0],
    };
    const flight_factors *by = &factors;
    expand_flight_on(c, by, 0, &sum, s);
    begin_flight_sums(s, 0, &sum, &next);
    expand_flight_on(c, by, 1, &next, s);
    for (int k = 2; k < order; k += 2) {
        begin_flight_sums(s, k / 2, &sum, &next);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_flight_sums(s, i, j, &next);
            add_flight_sums(s, i - 1, j, &sum);
        }
        expand_flight_on(c, by, k, &sum, s);
        add_flight_sums(s, 1, k, &next);
        expand_flight_on(c, by, k + 1, &next, s);
    }
}

/* What is divided by. */
typedef struct {
    real inverse_square;
} pushed_flight_factors;

/* Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half. */
typedef struct {
    real square;
    real angle_rate;
    real rate_square;
    real length_times_rate_square;
    real push_moment;
    real speed_square;
} pushed_flight_sums;

/* Adds the terms with coefficient i of one factor and j of the other; of what is known ahead, of j + 1. */
KERNEL void add_pushed_flight_sums(const flight_series *s, int i, int j, pushed_flight_sums *sum) {
    sum->square += s->length[i] * s->length[j];
    sum->angle_rate += s->angle_rate[i] * s->square[j];
    sum->angle_rate += s->square[i] * s->angle_rate[j];
    sum->rate_square += s->angle_rate[i] * s->angle_rate[j];
    sum->length_times_rate_square += s->length[i] * s->rate_square[j];
    sum->length_times_rate_square += s->rate_square[i] * s->length[j];
    sum->push_moment += s->length[i] * s->push_across[j];
    sum->push_moment += s->push_across[i] * s->length[j];
    sum->speed_square += s->length_rate[i] * s->length_rate[j];
}

/* Sets the sums of coefficients 2 i and 2 i + 1 to the terms in the middle. */
KERNEL void begin_pushed_flight_sums(const flight_series *s, int i, pushed_flight_sums *sum,
                                     pushed_flight_sums *next) {
    sum->square = 0.5 * (s->length[i] * s->length[i]);
    next->square = broadcast(0.0);
    sum->angle_rate = (s->angle_rate[i] * s->square[i]);
    next->angle_rate = broadcast(0.0);
    sum->rate_square = 0.5 * (s->angle_rate[i] * s->angle_rate[i]);
    next->rate_square = broadcast(0.0);
    sum->length_times_rate_square = (s->length[i] * s->rate_square[i]);
    next->length_times_rate_square = broadcast(0.0);
    sum->push_moment = (s->length[i] * s->push_across[i]);
    next->push_moment = broadcast(0.0);
    sum->speed_square = 0.5 * (s->length_rate[i] * s->length_rate[i]);
    next->speed_square = broadcast(0.0);
    (void)next;
}

/* vdot = r w^2 + M F_s, Ldot = M tau, w = L/r^2, and what the push on the body adds. From coefficient k of
 * the states to the next. */
KERNEL void expand_pushed_flight_on(const flight_coefficients *c, const pushed_flight_factors *by, int k,
                                    const pushed_flight_sums *sum, flight_series *s) {
    integrate(s->length, k, s->length_rate[k]);
    /* square = length * length */
    s->square[k] = square_of(k, sum->square, s->length);
    /* angle_rate = momentum / square */
    s->angle_rate[k] =
        quotient_of(k, sum->angle_rate, s->momentum[k], s->angle_rate, s->square, by->inverse_square);
    /* rate_square = angle_rate * angle_rate */
    s->rate_square[k] = square_of(k, sum->rate_square, s->angle_rate);
    /* length_times_rate_square = length * rate_square */
    const real length_times_rate_square =
        product_of(k, sum->length_times_rate_square, s->length, s->rate_square);
    /* axial_force = stiffness * (rest_length - length) - damping * length_rate */
    const real axial_force = with_ramp(k, -(c->stiffness * s->length[k]) - c->damping * s->length_rate[k],
                                       c->stiffness * c->rest_length, c->stiffness * c->rest_length_rate);
    /* cosine = cos(angle) */
    sine_and_cosine_term(k, s->angle, s->angle_rate, s->sine, s->cosine);
    /* push_y_times_cosine = push_y * cosine */
    const real push_y_times_cosine = ramp_times(k, c->push_y, c->push_y_rate, s->cosine);
    /* sine = sin(angle) */
    /* push_x_times_sine = push_x * sine */
    const real push_x_times_sine = ramp_times(k, c->push_x, c->push_x_rate, s->sine);
    /* push_along = push_y_times_cosine - push_x_times_sine */
    const real push_along = push_y_times_cosine - push_x_times_sine;
    /* torque = gain * (target - angle) - rate_gain * angle_rate + torque */
    const real torque = with_drift(k, -(c->gain * s->angle[k]) - c->rate_gain * s->angle_rate[k],
                                   c->gain * c->target + c->torque, c->torque_rate);
    /* push_x_times_cosine = push_x * cosine */
    const real push_x_times_cosine = ramp_times(k, c->push_x, c->push_x_rate, s->cosine);
    /* push_y_times_sine = push_y * sine */
    const real push_y_times_sine = ramp_times(k, c->push_y, c->push_y_rate, s->sine);
    /* push_across = -(push_x_times_cosine + push_y_times_sine) */
    s->push_across[k] = -push_x_times_cosine - push_y_times_sine;
    /* push_moment = length * push_across */
    s->push_moment[k] = product_of(k, sum->push_moment, s->length, s->push_across);
    /* speed_square = length_rate * length_rate */
    s->speed_square[k] = square_of(k, sum->speed_square, s->length_rate);
    integrate(s->length_rate, k,
              length_times_rate_square + c->inverse_reduced_mass * axial_force + push_along);
    integrate(s->angle, k, s->angle_rate[k]);
    integrate(s->momentum, k, c->inverse_reduced_mass * torque + s->push_moment[k]);
}

/* From coefficient 0 of the states up to `order`; an odd order gets one coefficient more. */
KERNEL void expand_pushed_flight(const flight_coefficients *given, int order, flight_series *s) {
    const flight_coefficients copy = *given, *c = &copy;
    static const pushed_flight_sums none = {0};
    pushed_flight_sums sum = none, next = none;
    s->square[0] = s->length[0] * s->length[0];
    const pushed_flight_factors factors = {
        .inverse_square = 1.0 / s->square[0],
    };
    const pushed_flight_factors *by = &factors;
    expand_pushed_flight_on(c, by, 0, &sum, s);
    begin_pushed_flight_sums(s, 0, &sum, &next);
    expand_pushed_flight_on(c, by, 1, &next, s);
    for (int k = 2; k < order; k += 2) {
        begin_pushed_flight_sums(s, k / 2, &sum, &next);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_pushed_flight_sums(s, i, j, &next);
            add_pushed_flight_sums(s, i - 1, j, &sum);
        }
        expand_pushed_flight_on(c, by, k, &sum, s);
        add_pushed_flight_sums(s, 1, k, &next);
        expand_pushed_flight_on(c, by, k + 1, &next, s);
    }
}

/* The same differentiated, from coefficient 0 of the states of t; coefficients vary by d. */
static inline void vary_flight(const flight_coefficients *c, const flight_series *s,
                               const flight_coefficients *d, int order, flight_variation *t) {
    real torque[SERIES_TERMS];
    for (int k = 0; k < order; ++k) {
        integrate(t->length, k, t->length_rate[k]);
        t->square[k] = 2.0 * product(s->length, t->length, k);
        t->angle_rate[k] = (t->momentum[k] - product(s->angle_rate, t->square, k) -
                            product_so_far(t->angle_rate, s->square, k)) /
                           s->square[0];
        t->rate_square[k] = 2.0 * product(s->angle_rate, t->angle_rate, k);
        const real d_length_times_rate_square =
            product(t->length, s->rate_square, k) + product(s->length, t->rate_square, k);
        const real axial_force =
            with_constant(k, -(c->stiffness * s->length[k]) - c->damping * s->length_rate[k],
                          c->stiffness * c->rest_length);
        const real d_axial_force =
            with_constant(k,
                          -(d->stiffness * s->length[k]) - c->stiffness * t->length[k] -
                              d->damping * s->length_rate[k] - c->damping * t->length_rate[k],
                          d->stiffness * c->rest_length + c->stiffness * d->rest_length);
        torque[k] = with_drift(k, -(c->gain * s->angle[k]) - c->rate_gain * s->angle_rate[k],
                               c->gain * c->target + c->torque, c->torque_rate);
        t->torque[k] = with_drift(k,
                                  -(d->gain * s->angle[k]) - c->gain * t->angle[k] -
                                      d->rate_gain * s->angle_rate[k] - c->rate_gain * t->angle_rate[k],
                                  d->gain * c->target + c->gain * d->target + d->torque, d->torque_rate);
        t->power[k] = product(t->torque, s->angle_rate, k) + product(torque, t->angle_rate, k);
        integrate(t->length_rate, k,
                  d_length_times_rate_square + d->inverse_reduced_mass * axial_force +
                      c->inverse_reduced_mass * d_axial_force);
        integrate(t->angle, k, t->angle_rate[k]);
        integrate(t->momentum, k,
                  d->inverse_reduced_mass * torque[k] + c->inverse_reduced_mass * t->torque[k]);
    }
}

/* The same differentiated, from coefficient 0 of the states of t; coefficients vary by d. */
static inline void vary_pushed_flight(const flight_coefficients *c, const flight_series *s,
                                      const flight_coefficients *d, int order, flight_variation *t) {
    real torque[SERIES_TERMS];
    for (int k = 0; k < order; ++k) {
        integrate(t->length, k, t->length_rate[k]);
        t->square[k] = 2.0 * product(s->length, t->length, k);
        t->angle_rate[k] = (t->momentum[k] - product(s->angle_rate, t->square, k) -
                            product_so_far(t->angle_rate, s->square, k)) /
                           s->square[0];
        t->rate_square[k] = 2.0 * product(s->angle_rate, t->angle_rate, k);
        const real d_length_times_rate_square =
            product(t->length, s->rate_square, k) + product(s->length, t->rate_square, k);
        const real axial_force = with_ramp(k, -(c->stiffness * s->length[k]) - c->damping * s->length_rate[k],
                                           c->stiffness * c->rest_length, c->stiffness * c->rest_length_rate);
        const real d_axial_force =
            with_ramp(k,
                      -(d->stiffness * s->length[k]) - c->stiffness * t->length[k] -
                          d->damping * s->length_rate[k] - c->damping * t->length_rate[k],
                      d->stiffness * c->rest_length + c->stiffness * d->rest_length,
                      d->stiffness * c->rest_length_rate + c->stiffness * d->rest_length_rate);
        t->cosine[k] = -product(s->sine, t->angle, k);
        const real d_push_y_times_cosine = ramp_times(k, d->push_y, d->push_y_rate, s->cosine) +
                                           ramp_times(k, c->push_y, c->push_y_rate, t->cosine);
        t->sine[k] = product(s->cosine, t->angle, k);
        const real d_push_x_times_sine = ramp_times(k, d->push_x, d->push_x_rate, s->sine) +
                                         ramp_times(k, c->push_x, c->push_x_rate, t->sine);
        const real d_push_along = d_push_y_times_cosine - d_push_x_times_sine;
        torque[k] = with_drift(k, -(c->gain * s->angle[k]) - c->rate_gain * s->angle_rate[k],
                               c->gain * c->target + c->torque, c->torque_rate);
        t->torque[k] = with_drift(k,
                                  -(d->gain * s->angle[k]) - c->gain * t->angle[k] -
                                      d->rate_gain * s->angle_rate[k] - c->rate_gain * t->angle_rate[k],
                                  d->gain * c->target + c->gain * d->target + d->torque, d->torque_rate);
        const real d_push_x_times_cosine = ramp_times(k, d->push_x, d->push_x_rate, s->cosine) +
                                           ramp_times(k, c->push_x, c->push_x_rate, t->cosine);
        const real d_push_y_times_sine = ramp_times(k, d->push_y, d->push_y_rate, s->sine) +
                                         ramp_times(k, c->push_y, c->push_y_rate, t->sine);
        t->push_across[k] = -d_push_x_times_cosine - d_push_y_times_sine;
        const real d_push_moment =
            product(t->length, s->push_across, k) + product(s->length, t->push_across, k);
        t->power[k] = product(t->torque, s->angle_rate, k) + product(torque, t->angle_rate, k);
        integrate(t->length_rate, k,
                  d_length_times_rate_square + d->inverse_reduced_mass * axial_force +
                      c->inverse_reduced_mass * d_axial_force + d_push_along);
        integrate(t->angle, k, t->angle_rate[k]);
        integrate(t->momentum, k,
                  d->inverse_reduced_mass * torque[k] + c->inverse_reduced_mass * t->torque[k] +
                      d_push_moment);
    }
}

#endif
