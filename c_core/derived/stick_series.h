/* Derived from c_core/equations/ground.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_STICK_SERIES_H
#define TDMF_DERIVED_STICK_SERIES_H

#include "ground_series.h"

/* What is divided by. */
typedef struct {
    real inverse_length;
} stick_factors;

/* Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half. */
typedef struct {
    real x_times_x;
    real y_times_y;
    real length;
    real axial;
    real along;
    real off;
    real speed_square;
} stick_sums;

/* Adds the terms with coefficient i of one factor and j of the other; of what is known ahead, of j + 1. */
KERNEL void add_stick_sums(const ground_series *s, int i, int j, stick_sums *sum) {
    sum->x_times_x += s->x[i] * s->x[j + 1];
    sum->y_times_y += s->y[i] * s->y[j + 1];
    sum->length += s->length[i] * s->length[j + 1];
    sum->axial += s->axial[i] * s->length[j];
    sum->axial += s->length[i] * s->axial[j];
    sum->along += s->axial[i] * s->x[j];
    sum->along += s->x[i] * s->axial[j];
    sum->off += s->axial[i] * s->y[j];
    sum->off += s->y[i] * s->axial[j];
    sum->speed_square += s->length_rate[i] * s->length_rate[j];
}

/* Sets the sums of coefficients 2 i and 2 i + 1 to the terms in the middle. */
KERNEL void begin_stick_sums(const ground_series *s, int i, stick_sums *sum, stick_sums *next) {
    sum->x_times_x = s->x[i] * s->x[i + 1];
    next->x_times_x = 0.5 * (s->x[i + 1] * s->x[i + 1]);
    sum->y_times_y = s->y[i] * s->y[i + 1];
    next->y_times_y = 0.5 * (s->y[i + 1] * s->y[i + 1]);
    sum->length = s->length[i] * s->length[i + 1];
    next->length = 0.5 * (s->length[i + 1] * s->length[i + 1]);
    sum->axial = (s->axial[i] * s->length[i]);
    next->axial = broadcast(0.0);
    sum->along = (s->axial[i] * s->x[i]);
    next->along = broadcast(0.0);
    sum->off = (s->axial[i] * s->y[i]);
    next->off = broadcast(0.0);
    sum->speed_square = 0.5 * (s->length_rate[i] * s->length_rate[i]);
    next->speed_square = broadcast(0.0);
}

/* Xdot = U, Ydot = V; m Udot = leg - m g_x - m udot, m Vdot = leg - m g_y; m_f udot = foot.
 *
 * `has_torque` is whether a torque turns the leg, as it does in graze, `falls` whether friction falls with
 * speed. From coefficient k of the states to the next. */
KERNEL void expand_stick_on(const ground_coefficients *c, const stick_factors *by, int k,
                            const stick_sums *sum, ground_series *s) {
    integrate(s->x, k, s->vx[k]);
    integrate(s->y, k, s->vy[k]);
    /* x_times_x = x * x */
    const real x_times_x = square_of(k + 1, sum->x_times_x, s->x);
    /* y_times_y = y * y */
    const real y_times_y = square_of(k + 1, sum->y_times_y, s->y);
    /* square = x_times_x + y_times_y */
    s->square[k + 1] = x_times_x + y_times_y;
    /* length = sqrt(square) */
    s->length[k + 1] = root_of(k + 1, sum->length, s->square[k + 1], s->length, by->inverse_length);
    /* length_rate = rate(length) */
    s->length_rate[k] = (double)(k + 1) * s->length[k + 1];
    /* axial = (stiffness * (rest_length - length) - damping * length_rate) / length */
    s->axial[k] = quotient_of(k, sum->axial,
                              with_ramp(k, -(c->stiffness * s->length[k]) - c->damping * s->length_rate[k],
                                        c->stiffness * c->rest_length, c->stiffness * c->rest_length_rate),
                              s->axial, s->length, by->inverse_length);
    /* along = axial * x */
    s->along[k] = product_of(k, sum->along, s->axial, s->x);
    /* off = axial * y */
    s->off[k] = product_of(k, sum->off, s->axial, s->y);
    /* gravity_x_times_y = gravity_x * y */
    const real gravity_x_times_y = ramp_times(k, c->gravity_x, c->gravity_x_rate, s->y);
    /* gravity_y_times_x = gravity_y * x */
    const real gravity_y_times_x = ramp_times(k, c->gravity_y, c->gravity_y_rate, s->x);
    /* normal_force = off + foot_weight_y */
    s->normal_force[k] = with_constant(k, s->off[k], c->foot_weight_y);
    /* tangential = along + foot_weight_x */
    const real tangential = with_constant(k, s->along[k], c->foot_weight_x);
    /* tangential_push = -tangential */
    s->tangential_push[k] = -tangential;
    /* speed_square = length_rate * length_rate */
    s->speed_square[k] = square_of(k, sum->speed_square, s->length_rate);
    s->torque[k] = broadcast(0.0);
    s->power[k] = broadcast(0.0);
    s->turning[k] = broadcast(0.0);
    integrate(s->vx, k, with_ramp(k, c->inverse_body_mass * s->along[k], -c->gravity_x, -c->gravity_x_rate));
    integrate(s->vy, k, with_ramp(k, c->inverse_body_mass * s->off[k], -c->gravity_y, -c->gravity_y_rate));
    integrate(s->foot_vx, k, broadcast(0.0));
    integrate(s->moment, k, gravity_x_times_y - gravity_y_times_x);
}

/* From coefficient 0 of the states up to `order`; an odd order gets one coefficient more. */
KERNEL void expand_stick(const ground_coefficients *given, int order, ground_series *s) {
    const ground_coefficients copy = *given, *c = &copy;
    static const stick_sums none = {0};
    stick_sums sum = none, next = none;
    s->square[0] = s->x[0] * s->x[0] + s->y[0] * s->y[0];
    s->length[0] = real_sqrt(s->square[0]);
    const stick_factors factors = {
        .inverse_length = 1.0 / s->length[0],
    };
    const stick_factors *by = &factors;
    expand_stick_on(c, by, 0, &sum, s);
    begin_stick_sums(s, 0, &sum, &next);
    expand_stick_on(c, by, 1, &next, s);
    for (int k = 2; k < order; k += 2) {
        begin_stick_sums(s, k / 2, &sum, &next);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_stick_sums(s, i, j, &next);
            add_stick_sums(s, i - 1, j, &sum);
        }
        expand_stick_on(c, by, k, &sum, s);
        add_stick_sums(s, 1, k, &next);
        expand_stick_on(c, by, k + 1, &next, s);
    }
}

/* What is divided by. */
typedef struct {
    real inverse_length;
    real inverse_square;
} stick_with_torque_factors;

/* Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half. */
typedef struct {
    real x_times_x;
    real y_times_y;
    real length;
    real axial;
    real axial_times_x;
    real turning;
    real turning_times_y;
    real axial_y;
    real turning_times_x;
    real power;
    real speed_square;
} stick_with_torque_sums;

/* Adds the terms with coefficient i of one factor and j of the other; of what is known ahead, of j + 1. */
KERNEL void add_stick_with_torque_sums(const ground_series *s, int i, int j, stick_with_torque_sums *sum) {
    sum->x_times_x += s->x[i] * s->x[j + 1];
    sum->y_times_y += s->y[i] * s->y[j + 1];
    sum->length += s->length[i] * s->length[j + 1];
    sum->axial += s->axial[i] * s->length[j];
    sum->axial += s->length[i] * s->axial[j];
    sum->axial_times_x += s->axial[i] * s->x[j];
    sum->axial_times_x += s->x[i] * s->axial[j];
    sum->turning += s->turning[i] * s->square[j];
    sum->turning += s->square[i] * s->turning[j];
    sum->turning_times_y += s->turning[i] * s->y[j];
    sum->turning_times_y += s->y[i] * s->turning[j];
    sum->axial_y += s->axial[i] * s->y[j];
    sum->axial_y += s->y[i] * s->axial[j];
    sum->turning_times_x += s->turning[i] * s->x[j];
    sum->turning_times_x += s->x[i] * s->turning[j];
    sum->power += s->turning[i] * s->moment[j];
    sum->power += s->moment[i] * s->turning[j];
    sum->speed_square += s->length_rate[i] * s->length_rate[j];
}

/* Sets the sums of coefficients 2 i and 2 i + 1 to the terms in the middle. */
KERNEL void begin_stick_with_torque_sums(const ground_series *s, int i, stick_with_torque_sums *sum,
                                         stick_with_torque_sums *next) {
    sum->x_times_x = s->x[i] * s->x[i + 1];
    next->x_times_x = 0.5 * (s->x[i + 1] * s->x[i + 1]);
    sum->y_times_y = s->y[i] * s->y[i + 1];
    next->y_times_y = 0.5 * (s->y[i + 1] * s->y[i + 1]);
    sum->length = s->length[i] * s->length[i + 1];
    next->length = 0.5 * (s->length[i + 1] * s->length[i + 1]);
    sum->axial = (s->axial[i] * s->length[i]);
    next->axial = broadcast(0.0);
    sum->axial_times_x = (s->axial[i] * s->x[i]);
    next->axial_times_x = broadcast(0.0);
    sum->turning = (s->turning[i] * s->square[i]);
    next->turning = broadcast(0.0);
    sum->turning_times_y = (s->turning[i] * s->y[i]);
    next->turning_times_y = broadcast(0.0);
    sum->axial_y = (s->axial[i] * s->y[i]);
    next->axial_y = broadcast(0.0);
    sum->turning_times_x = (s->turning[i] * s->x[i]);
    next->turning_times_x = broadcast(0.0);
    sum->power = (s->turning[i] * s->moment[i]);
    next->power = broadcast(0.0);
    sum->speed_square = 0.5 * (s->length_rate[i] * s->length_rate[i]);
    next->speed_square = broadcast(0.0);
}

/* Xdot = U, Ydot = V; m Udot = leg - m g_x - m udot, m Vdot = leg - m g_y; m_f udot = foot.
 *
 * `has_torque` is whether a torque turns the leg, as it does in graze, `falls` whether friction falls with
 * speed. From coefficient k of the states to the next. */
KERNEL void expand_stick_with_torque_on(const ground_coefficients *c, const stick_with_torque_factors *by,
                                        int k, const stick_with_torque_sums *sum, ground_series *s) {
    integrate(s->x, k, s->vx[k]);
    integrate(s->y, k, s->vy[k]);
    /* x_times_x = x * x */
    const real x_times_x = square_of(k + 1, sum->x_times_x, s->x);
    /* y_times_y = y * y */
    const real y_times_y = square_of(k + 1, sum->y_times_y, s->y);
    /* square = x_times_x + y_times_y */
    s->square[k + 1] = x_times_x + y_times_y;
    /* length = sqrt(square) */
    s->length[k + 1] = root_of(k + 1, sum->length, s->square[k + 1], s->length, by->inverse_length);
    /* length_rate = rate(length) */
    s->length_rate[k] = (double)(k + 1) * s->length[k + 1];
    /* axial = (stiffness * (rest_length - length) - damping * length_rate) / length */
    s->axial[k] = quotient_of(k, sum->axial,
                              with_ramp(k, -(c->stiffness * s->length[k]) - c->damping * s->length_rate[k],
                                        c->stiffness * c->rest_length, c->stiffness * c->rest_length_rate),
                              s->axial, s->length, by->inverse_length);
    /* axial_times_x = axial * x */
    const real axial_times_x = product_of(k, sum->axial_times_x, s->axial, s->x);
    /* turning = torque / square */
    s->turning[k] = quotient_of(k, sum->turning, ramp_of(k, c->torque, c->torque_rate), s->turning, s->square,
                                by->inverse_square);
    /* turning_times_y = turning * y */
    const real turning_times_y = product_of(k, sum->turning_times_y, s->turning, s->y);
    /* along = axial_times_x - turning_times_y */
    s->along[k] = axial_times_x - turning_times_y;
    /* axial_y = axial * y */
    const real axial_y = product_of(k, sum->axial_y, s->axial, s->y);
    /* turning_times_x = turning * x */
    const real turning_times_x = product_of(k, sum->turning_times_x, s->turning, s->x);
    /* off = axial_y + turning_times_x */
    s->off[k] = axial_y + turning_times_x;
    /* gravity_y_times_x = gravity_y * x */
    const real gravity_y_times_x = ramp_times(k, c->gravity_y, c->gravity_y_rate, s->x);
    /* gravity_x_times_y = gravity_x * y */
    const real gravity_x_times_y = ramp_times(k, c->gravity_x, c->gravity_x_rate, s->y);
    /* normal_force = off + foot_weight_y */
    s->normal_force[k] = with_constant(k, s->off[k], c->foot_weight_y);
    /* tangential = along + foot_weight_x */
    const real tangential = with_constant(k, s->along[k], c->foot_weight_x);
    /* tangential_push = -tangential */
    s->tangential_push[k] = -tangential;
    /* power = turning * moment */
    s->power[k] = product_of(k, sum->power, s->turning, s->moment);
    /* speed_square = length_rate * length_rate */
    s->speed_square[k] = square_of(k, sum->speed_square, s->length_rate);
    s->torque[k] = ramp_of(k, c->torque, c->torque_rate);
    integrate(s->vx, k, with_ramp(k, c->inverse_body_mass * s->along[k], -c->gravity_x, -c->gravity_x_rate));
    integrate(s->vy, k, with_ramp(k, c->inverse_body_mass * s->off[k], -c->gravity_y, -c->gravity_y_rate));
    integrate(s->foot_vx, k, broadcast(0.0));
    integrate(s->moment, k,
              with_ramp(k, gravity_x_times_y - gravity_y_times_x, c->inverse_body_mass * c->torque,
                        c->inverse_body_mass * c->torque_rate));
}

/* From coefficient 0 of the states up to `order`; an odd order gets one coefficient more. */
KERNEL void expand_stick_with_torque(const ground_coefficients *given, int order, ground_series *s) {
    const ground_coefficients copy = *given, *c = &copy;
    static const stick_with_torque_sums none = {0};
    stick_with_torque_sums sum = none, next = none;
    s->square[0] = s->x[0] * s->x[0] + s->y[0] * s->y[0];
    s->length[0] = real_sqrt(s->square[0]);
    const stick_with_torque_factors factors = {
        .inverse_length = 1.0 / s->length[0],
        .inverse_square = 1.0 / s->square[0],
    };
    const stick_with_torque_factors *by = &factors;
    expand_stick_with_torque_on(c, by, 0, &sum, s);
    begin_stick_with_torque_sums(s, 0, &sum, &next);
    expand_stick_with_torque_on(c, by, 1, &next, s);
    for (int k = 2; k < order; k += 2) {
        begin_stick_with_torque_sums(s, k / 2, &sum, &next);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_stick_with_torque_sums(s, i, j, &next);
            add_stick_with_torque_sums(s, i - 1, j, &sum);
        }
        expand_stick_with_torque_on(c, by, k, &sum, s);
        add_stick_with_torque_sums(s, 1, k, &next);
        expand_stick_with_torque_on(c, by, k + 1, &next, s);
    }
}

/* The same differentiated, from coefficient 0 of the states of t; coefficients vary by d. */
static inline void vary_stick(const ground_coefficients *c, const ground_series *s,
                              const ground_coefficients *d, int order, ground_variation *t) {
    const real d_x_times_x = 2.0 * product(s->x, t->x, 0);
    const real d_y_times_y = 2.0 * product(s->y, t->y, 0);
    const real d_square = d_x_times_x + d_y_times_y;
    t->length[0] = (0.5 * d_square - product_so_far(t->length, s->length, 0)) / s->length[0];
    for (int k = 0; k < order; ++k) {
        integrate(t->x, k, t->vx[k]);
        integrate(t->y, k, t->vy[k]);
        const real d_x_times_x = 2.0 * product(s->x, t->x, k + 1);
        const real d_y_times_y = 2.0 * product(s->y, t->y, k + 1);
        const real d_square = d_x_times_x + d_y_times_y;
        t->length[k + 1] = (0.5 * d_square - product_so_far(t->length, s->length, k + 1)) / s->length[0];
        const real d_length_rate = (double)(k + 1) * t->length[k + 1];
        t->axial[k] = (with_ramp(k,
                                 -(d->stiffness * s->length[k]) - c->stiffness * t->length[k] -
                                     d->damping * s->length_rate[k] - c->damping * d_length_rate -
                                     product(s->axial, t->length, k),
                                 d->stiffness * c->rest_length + c->stiffness * d->rest_length,
                                 d->stiffness * c->rest_length_rate + c->stiffness * d->rest_length_rate) -
                       product_so_far(t->axial, s->length, k)) /
                      s->length[0];
        const real d_along = product(t->axial, s->x, k) + product(s->axial, t->x, k);
        const real d_off = product(t->axial, s->y, k) + product(s->axial, t->y, k);
        const real d_gravity_x_times_y = ramp_times(k, d->gravity_x, d->gravity_x_rate, s->y) +
                                         ramp_times(k, c->gravity_x, c->gravity_x_rate, t->y);
        const real d_gravity_y_times_x = ramp_times(k, d->gravity_y, d->gravity_y_rate, s->x) +
                                         ramp_times(k, c->gravity_y, c->gravity_y_rate, t->x);
        t->torque[k] = broadcast(0.0);
        t->power[k] = broadcast(0.0);
        t->friction_power[k] = broadcast(0.0);
        integrate(t->vx, k,
                  with_ramp(k, d->inverse_body_mass * s->along[k] + c->inverse_body_mass * d_along,
                            -d->gravity_x, -d->gravity_x_rate));
        integrate(t->vy, k,
                  with_ramp(k, d->inverse_body_mass * s->off[k] + c->inverse_body_mass * d_off, -d->gravity_y,
                            -d->gravity_y_rate));
        integrate(t->foot_vx, k, broadcast(0.0));
        integrate(t->moment, k, d_gravity_x_times_y - d_gravity_y_times_x);
    }
}

/* The same differentiated, from coefficient 0 of the states of t; coefficients vary by d. */
static inline void vary_stick_with_torque(const ground_coefficients *c, const ground_series *s,
                                          const ground_coefficients *d, int order, ground_variation *t) {
    const real d_x_times_x = 2.0 * product(s->x, t->x, 0);
    const real d_y_times_y = 2.0 * product(s->y, t->y, 0);
    t->square[0] = d_x_times_x + d_y_times_y;
    t->length[0] = (0.5 * t->square[0] - product_so_far(t->length, s->length, 0)) / s->length[0];
    for (int k = 0; k < order; ++k) {
        integrate(t->x, k, t->vx[k]);
        integrate(t->y, k, t->vy[k]);
        const real d_x_times_x = 2.0 * product(s->x, t->x, k + 1);
        const real d_y_times_y = 2.0 * product(s->y, t->y, k + 1);
        t->square[k + 1] = d_x_times_x + d_y_times_y;
        t->length[k + 1] =
            (0.5 * t->square[k + 1] - product_so_far(t->length, s->length, k + 1)) / s->length[0];
        const real d_length_rate = (double)(k + 1) * t->length[k + 1];
        t->axial[k] = (with_ramp(k,
                                 -(d->stiffness * s->length[k]) - c->stiffness * t->length[k] -
                                     d->damping * s->length_rate[k] - c->damping * d_length_rate -
                                     product(s->axial, t->length, k),
                                 d->stiffness * c->rest_length + c->stiffness * d->rest_length,
                                 d->stiffness * c->rest_length_rate + c->stiffness * d->rest_length_rate) -
                       product_so_far(t->axial, s->length, k)) /
                      s->length[0];
        const real d_axial_times_x = product(t->axial, s->x, k) + product(s->axial, t->x, k);
        t->turning[k] = (with_ramp(k, -product(s->turning, t->square, k), d->torque, d->torque_rate) -
                         product_so_far(t->turning, s->square, k)) /
                        s->square[0];
        const real d_turning_times_y = product(t->turning, s->y, k) + product(s->turning, t->y, k);
        const real d_along = d_axial_times_x - d_turning_times_y;
        const real d_axial_y = product(t->axial, s->y, k) + product(s->axial, t->y, k);
        const real d_turning_times_x = product(t->turning, s->x, k) + product(s->turning, t->x, k);
        const real d_off = d_axial_y + d_turning_times_x;
        const real d_gravity_y_times_x = ramp_times(k, d->gravity_y, d->gravity_y_rate, s->x) +
                                         ramp_times(k, c->gravity_y, c->gravity_y_rate, t->x);
        const real d_gravity_x_times_y = ramp_times(k, d->gravity_x, d->gravity_x_rate, s->y) +
                                         ramp_times(k, c->gravity_x, c->gravity_x_rate, t->y);
        t->power[k] = product(t->turning, s->moment, k) + product(s->turning, t->moment, k);
        t->torque[k] = ramp_of(k, d->torque, d->torque_rate);
        t->friction_power[k] = broadcast(0.0);
        integrate(t->vx, k,
                  with_ramp(k, d->inverse_body_mass * s->along[k] + c->inverse_body_mass * d_along,
                            -d->gravity_x, -d->gravity_x_rate));
        integrate(t->vy, k,
                  with_ramp(k, d->inverse_body_mass * s->off[k] + c->inverse_body_mass * d_off, -d->gravity_y,
                            -d->gravity_y_rate));
        integrate(t->foot_vx, k, broadcast(0.0));
        integrate(t->moment, k,
                  with_ramp(k, d_gravity_x_times_y - d_gravity_y_times_x,
                            d->inverse_body_mass * c->torque + c->inverse_body_mass * d->torque,
                            d->inverse_body_mass * c->torque_rate + c->inverse_body_mass * d->torque_rate));
    }
}

#endif
