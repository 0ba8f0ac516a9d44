/* Derived from c_core/equations/ground.py by equations/derive: edit that. */
#ifndef TDMF_DERIVED_GRAZE_SERIES_H
#define TDMF_DERIVED_GRAZE_SERIES_H

#include "ground_series.h"

/* Factors that all coefficients have, and what is divided by. */
typedef struct {
    real inverse_length;
    real inverse_x;
    real inverse_square;
} graze_factors;

/* Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half. */
typedef struct {
    real x_times_x;
    real y_times_y;
    real length;
} graze_position_sums;

/* Adds the terms with coefficient i of one factor and j of the other. */
KERNEL void add_graze_position_sums(const ground_series *s, int i, int j, graze_position_sums *sum) {
    sum->x_times_x += s->x[i] * s->x[j];
    sum->y_times_y += s->y[i] * s->y[j];
    sum->length += s->length[i] * s->length[j];
}

/* Sets them to the terms with coefficient i of both factors. */
KERNEL void begin_graze_position_sums(const ground_series *s, int i, graze_position_sums *sum) {
    sum->x_times_x = 0.5 * (s->x[i] * s->x[i]);
    sum->y_times_y = 0.5 * (s->y[i] * s->y[i]);
    sum->length = 0.5 * (s->length[i] * s->length[i]);
}

/* Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half. */
typedef struct {
    real axial;
    real axial_times_x;
    real axial_y;
    real turning;
    real turning_times_y;
    real torque;
    real y_times_foot_acceleration;
    real power;
    real speed_square;
    real angle_rate;
} graze_sums;

/* Adds the terms with coefficient i of one factor and j of the other. */
KERNEL void add_graze_sums(const ground_series *s, int i, int j, graze_sums *sum) {
    sum->axial += s->axial[i] * s->length[j];
    sum->axial += s->axial[j] * s->length[i];
    sum->axial_times_x += s->axial[i] * s->x[j];
    sum->axial_times_x += s->axial[j] * s->x[i];
    sum->axial_y += s->axial[i] * s->y[j];
    sum->axial_y += s->axial[j] * s->y[i];
    sum->turning += s->turning[i] * s->x[j];
    sum->turning += s->turning[j] * s->x[i];
    sum->turning_times_y += s->turning[i] * s->y[j];
    sum->turning_times_y += s->turning[j] * s->y[i];
    sum->torque += s->turning[i] * s->square[j];
    sum->torque += s->turning[j] * s->square[i];
    sum->y_times_foot_acceleration += s->y[i] * s->foot_acceleration[j];
    sum->y_times_foot_acceleration += s->y[j] * s->foot_acceleration[i];
    sum->power += s->turning[i] * s->moment[j];
    sum->power += s->turning[j] * s->moment[i];
    sum->speed_square += s->length_rate[i] * s->length_rate[j];
    sum->angle_rate += s->angle_rate[i] * s->square[j];
    sum->angle_rate += s->angle_rate[j] * s->square[i];
}

/* Sets them to the terms with coefficient i of both factors. */
KERNEL void begin_graze_sums(const ground_series *s, int i, graze_sums *sum) {
    sum->axial = s->axial[i] * s->length[i];
    sum->axial_times_x = s->axial[i] * s->x[i];
    sum->axial_y = s->axial[i] * s->y[i];
    sum->turning = s->turning[i] * s->x[i];
    sum->turning_times_y = s->turning[i] * s->y[i];
    sum->torque = s->turning[i] * s->square[i];
    sum->y_times_foot_acceleration = s->y[i] * s->foot_acceleration[i];
    sum->power = s->turning[i] * s->moment[i];
    sum->speed_square = 0.5 * (s->length_rate[i] * s->length_rate[i]);
    sum->angle_rate = s->angle_rate[i] * s->square[i];
}
/* Xdot = U, Ydot = V; m Udot = leg - m g_x - m udot, m Vdot = leg - m g_y; m_f udot = foot. `turns` is
 * whether a torque turns the leg, as it does in graze. From coefficient k of the states to the next. */
KERNEL void expand_graze_on(const ground_coefficients *c, const graze_factors *by, int k,
                            const graze_position_sums *position, const graze_sums *sum, ground_series *s) {
    const double divide = series_reciprocal[k + 1];
    s->x[k + 1] = s->vx[k] * divide;
    s->y[k + 1] = s->vy[k] * divide;
    /* x_times_x = x * x */
    const real x_times_x = square_of(k + 1, position->x_times_x, s->x);
    /* y_times_y = y * y */
    const real y_times_y = square_of(k + 1, position->y_times_y, s->y);
    /* square = x_times_x + y_times_y */
    s->square[k + 1] = x_times_x + y_times_y;
    /* length = sqrt(square) */
    s->length[k + 1] = root_of(k + 1, position->length, s->square[k + 1], s->length, by->inverse_length);
    /* length_rate = rate of length */
    s->length_rate[k] = (double)(k + 1) * s->length[k + 1];
    /* axial = (stiffness * (rest_length - length) - damping * length_rate) / length */
    s->axial[k] = quotient_of(k, sum->axial,
                              with_ramp(k, -c->stiffness * s->length[k] - c->damping * s->length_rate[k],
                                        c->stiffness * c->rest_length, c->stiffness * c->rest_length_rate),
                              s->axial, s->length, by->inverse_length);
    /* axial_times_x = axial * x */
    const real axial_times_x = product_of(k, sum->axial_times_x, s->axial, s->x);
    /* axial_y = axial * y */
    s->axial_y[k] = product_of(k, sum->axial_y, s->axial, s->y);
    /* turning = -(axial_y + foot_weight_y) / x */
    s->turning[k] = quotient_of(k, sum->turning, with_constant(k, -s->axial_y[k], -c->foot_weight_y),
                                s->turning, s->x, by->inverse_x);
    /* turning_times_y = turning * y */
    const real turning_times_y = product_of(k, sum->turning_times_y, s->turning, s->y);
    /* along = axial_times_x - turning_times_y */
    s->along[k] = axial_times_x - turning_times_y;
    /* tangential = along + foot_weight_x */
    const real tangential = with_constant(k, s->along[k], c->foot_weight_x);
    /* tangential_push = -tangential */
    s->tangential_push[k] = -tangential;
    /* foot_acceleration = inverse_foot_mass * tangential_push */
    s->foot_acceleration[k] = c->inverse_foot_mass * s->tangential_push[k];
    /* torque = turning * square */
    s->torque[k] = product_of(k, sum->torque, s->turning, s->square);
    /* gravity_y_times_x = gravity_y * x */
    const real gravity_y_times_x = ramp_times(k, c->gravity_y, c->gravity_y_rate, s->x);
    /* gravity_x_times_y = gravity_x * y */
    const real gravity_x_times_y = ramp_times(k, c->gravity_x, c->gravity_x_rate, s->y);
    /* y_times_foot_acceleration = y * foot_acceleration */
    const real y_times_foot_acceleration =
        product_of(k, sum->y_times_foot_acceleration, s->y, s->foot_acceleration);
    /* power = turning * moment */
    s->power[k] = product_of(k, sum->power, s->turning, s->moment);
    /* speed_square = length_rate * length_rate */
    s->speed_square[k] = square_of(k, sum->speed_square, s->length_rate);
    /* angle_rate = moment / square */
    s->angle_rate[k] =
        quotient_of(k, sum->angle_rate, s->moment[k], s->angle_rate, s->square, by->inverse_square);
    s->normal_force[k] = real_of(0.0);
    s->vx[k + 1] = with_ramp(k, c->inverse_body_mass * s->along[k] - s->foot_acceleration[k], -c->gravity_x,
                             -c->gravity_x_rate) *
                   divide;
    s->vy[k + 1] =
        ramp_of(k, -c->foot_weight_y * c->inverse_body_mass - c->gravity_y, -c->gravity_y_rate) * divide;
    s->foot_vx[k + 1] = s->foot_acceleration[k] * divide;
    s->moment[k + 1] = (c->inverse_body_mass * s->torque[k] - gravity_y_times_x + gravity_x_times_y +
                        y_times_foot_acceleration) *
                       divide;
}

/* From coefficient k, even, two further. */
KERNEL void expand_graze_by_two(const ground_coefficients *c, const graze_factors *by, int k,
                                ground_series *s) {
    const int middle = k / 2;
    static const graze_position_sums no_position = {0};
    graze_position_sums position = no_position, next_position = no_position;
    static const graze_sums no_sum = {0};
    graze_sums sum = no_sum, next_sum = no_sum;
    begin_graze_position_sums(s, middle + 1, &next_position);
    add_graze_position_sums(s, middle, middle + 1, &position);
    for (int i = middle, j = middle + 2; i > 1; --i, ++j) {
        add_graze_position_sums(s, i, j, &next_position);
        add_graze_position_sums(s, i - 1, j, &position);
    }
    begin_graze_sums(s, middle, &sum);
    for (int i = middle, j = middle + 1; i > 1; --i, ++j) {
        add_graze_sums(s, i, j, &next_sum);
        add_graze_sums(s, i - 1, j, &sum);
    }
    expand_graze_on(c, by, k, &position, &sum, s);
    add_graze_position_sums(s, 1, k + 1, &next_position);
    add_graze_sums(s, 1, k, &next_sum);
    expand_graze_on(c, by, k + 1, &next_position, &next_sum, s);
}

/* From coefficient 0 of the states up to `order`; an odd order gets one coefficient more. */
KERNEL void expand_graze(const ground_coefficients *given, int order, ground_series *s) {
    const ground_coefficients copy = *given, *c = &copy;
    static const graze_position_sums no_position = {0};
    static const graze_sums no_sum = {0};
    graze_position_sums position = no_position;
    graze_sums sum = no_sum;
    s->square[0] = s->x[0] * s->x[0] + s->y[0] * s->y[0];
    s->length[0] = real_sqrt(s->square[0]);
    const graze_factors factors = {
        .inverse_length = 1.0 / s->length[0],
        .inverse_x = 1.0 / s->x[0],
        .inverse_square = 1.0 / s->square[0],
    };
    const graze_factors *by = &factors;
    expand_graze_on(c, by, 0, &position, &sum, s);
    begin_graze_position_sums(s, 1, &position);
    expand_graze_on(c, by, 1, &position, &sum, s);
    for (int k = 2; k < order; k += 2) {
        expand_graze_by_two(c, by, k, s);
    }
}

/* The same differentiated, from coefficient 0 of the states of t; coefficients vary by d. */
static inline void vary_graze(const ground_coefficients *c, const ground_series *s,
                              const ground_coefficients *d, int order, ground_variation *t) {
    const real d_x_times_x = 2.0 * product(s->x, t->x, 0);
    const real d_y_times_y = 2.0 * product(s->y, t->y, 0);
    t->square[0] = d_x_times_x + d_y_times_y;
    t->length[0] = vary_root(s->length, t->length, t->square[0], 0);
    for (int k = 0; k < order; ++k) {
        const double divide = series_reciprocal[k + 1];
        t->x[k + 1] = t->vx[k] * divide;
        t->y[k + 1] = t->vy[k] * divide;
        const real d_x_times_x = 2.0 * product(s->x, t->x, k + 1);
        const real d_y_times_y = 2.0 * product(s->y, t->y, k + 1);
        t->square[k + 1] = d_x_times_x + d_y_times_y;
        t->length[k + 1] = vary_root(s->length, t->length, t->square[k + 1], k + 1);
        const real d_length_rate = (double)(k + 1) * t->length[k + 1];
        t->axial[k] =
            vary_quotient(s->axial, t->axial, s->length, t->length,
                          with_ramp(k,
                                    -(d->stiffness * s->length[k] + c->stiffness * t->length[k]) -
                                        (d->damping * s->length_rate[k] + c->damping * d_length_rate),
                                    d->stiffness * c->rest_length + c->stiffness * d->rest_length,
                                    d->stiffness * c->rest_length_rate + c->stiffness * d->rest_length_rate),
                          k);
        const real d_axial_times_x = vary_product(s->axial, t->axial, s->x, t->x, k);
        const real d_axial_y = vary_product(s->axial, t->axial, s->y, t->y, k);
        t->turning[k] = vary_quotient(s->turning, t->turning, s->x, t->x,
                                      with_constant(k, -d_axial_y, -d->foot_weight_y), k);
        const real d_turning_times_y = vary_product(s->turning, t->turning, s->y, t->y, k);
        const real d_along = d_axial_times_x - d_turning_times_y;
        const real d_tangential = with_constant(k, d_along, d->foot_weight_x);
        const real d_tangential_push = -d_tangential;
        t->foot_acceleration[k] =
            d->inverse_foot_mass * s->tangential_push[k] + c->inverse_foot_mass * d_tangential_push;
        const real d_torque = vary_product(s->turning, t->turning, s->square, t->square, k);
        const real d_gravity_y_times_x =
            vary_ramp_times(k, c->gravity_y, c->gravity_y_rate, d->gravity_y, d->gravity_y_rate, s->x, t->x);
        const real d_gravity_x_times_y =
            vary_ramp_times(k, c->gravity_x, c->gravity_x_rate, d->gravity_x, d->gravity_x_rate, s->y, t->y);
        const real d_y_times_foot_acceleration =
            vary_product(s->y, t->y, s->foot_acceleration, t->foot_acceleration, k);
        t->power[k] = vary_product(s->turning, t->turning, s->moment, t->moment, k);
        t->vx[k + 1] = with_ramp(k,
                                 d->inverse_body_mass * s->along[k] + c->inverse_body_mass * d_along -
                                     t->foot_acceleration[k],
                                 -d->gravity_x, -d->gravity_x_rate) *
                       divide;
        t->vy[k + 1] = ramp_of(k,
                               -d->foot_weight_y * c->inverse_body_mass +
                                   -c->foot_weight_y * d->inverse_body_mass - d->gravity_y,
                               -d->gravity_y_rate) *
                       divide;
        t->foot_vx[k + 1] = t->foot_acceleration[k] * divide;
        t->moment[k + 1] = (d->inverse_body_mass * s->torque[k] + c->inverse_body_mass * d_torque -
                            d_gravity_y_times_x + d_gravity_x_times_y + d_y_times_foot_acceleration) *
                           divide;
    }
}

#endif
