/* Derived from the page PlainReducedRunner: edit the page, not this. */
#include "plain_reduced_runner.h"

/* ---- start_of_run */

/* Start of a run, in the world's states. */
typedef struct {
    real time[TERMS];
} start_of_run_series;

/* All coefficients. */
static void expand_start_of_run(const real *constants, int order, real *expanded) {
    start_of_run_series *s = (void *)expanded;
    (void)constants, (void)order;
    s->time[1] = broadcast(1.0);
}

/* First variation of the series. */
static void vary_start_of_run(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    start_of_run_series *t = (void *)varied;
    (void)constants, (void)series, (void)d_constants;
    for (int k = 0; k < order; ++k) {
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
    }
}

/* begins: Every run begins at an apex, with the foot above the ground. */
static void guard_start_of_run_begins(const real *constants, const real *series, int order, real *g) {
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        g[k] = constant_of(k, broadcast(-1.0));
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_start_of_run(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    (void)constants, (void)series, (void)power, (void)order, (void)watched;
    const interval span_0 = interval_at(broadcast(-1.0), broadcast(-1.0));
    bounds[0] = span_0;
}

/* ---- no_start */

/* The foot is not above the ground at the apex. */
typedef struct {
    real none[TERMS];
} no_start_series;

/* All coefficients. */
static void expand_no_start(const real *constants, int order, real *expanded) {
    (void)constants, (void)order, (void)expanded;
}

/* First variation of the series. */
static void vary_no_start(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    (void)constants, (void)series, (void)d_constants, (void)order, (void)varied;
}

/* ---- flight */

/* The centre of mass is ballistic. The leg turns after the apex. */
typedef struct {
    real com_y[TERMS], time[TERMS], com_x[TERMS], com_vy[TERMS], placing[TERMS], angle[TERMS];
} flight_series;

/* All coefficients. */
static void expand_flight(const real *constants, int order, real *expanded) {
    const flight_constants *c = (const void *)constants;
    flight_series *s = (void *)expanded;
    s->time[1] = broadcast(1.0);
    s->com_x[1] = c->com_vx;
    s->com_vy[1] = c->minus_gravity;
    s->placing[1] = c->is_placing;
    s->angle[1] = c->is_placing_times_rate;
    for (int k = 0; k < order; ++k) {
        s->com_y[k + 1] = s->com_vy[k] * series_reciprocal[k + 1];
    }
}

/* First variation of the series. */
static void vary_flight(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const flight_constants *d = (const void *)d_constants;
    flight_series *t = (void *)varied;
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        t->com_y[k + 1] = t->com_vy[k] * series_reciprocal[k + 1];
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->com_x[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->com_vx));
        t->com_vy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->minus_gravity));
        t->placing[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->is_placing));
        t->angle[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->is_placing_times_rate));
    }
}

/* First variation of power_of_hip. */
static void d_observed_flight_power_of_hip(const real *constants, const real *series, const real *d_constants,
    const real *d_series, int order, real *dg) {
    (void)constants, (void)series, (void)d_constants, (void)d_series;
    for (int k = 0; k < order; ++k) {
        dg[k] = broadcast(0.0);
    }
}

/* falls: The body reaches the ground. */
static void guard_flight_falls(const real *constants, const real *series, int order, real *g) {
    const flight_constants *c = (const void *)constants;
    const flight_series *s = (const void *)series;
    real own_cos_of_angle[TERMS], own_sin_of_angle[TERMS];
    for (int k = 0; k < order; ++k) {
        sine_and_cosine_of(k, s->angle, own_sin_of_angle, own_cos_of_angle);
        g[k] = s->com_y[k] + c->by_1_minus_share_times_length * own_cos_of_angle[k];
    }
}

/* apex: A stride closes, and the leg is placed anew. */
static void guard_flight_apex(const real *constants, const real *series, int order, real *g) {
    const flight_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->com_y[k + 1];
    }
}

/* touchdown: The foot reaches the ground. */
static void guard_flight_touchdown(const real *constants, const real *series, int order, real *g) {
    const flight_constants *c = (const void *)constants;
    const flight_series *s = (const void *)series;
    real own_cos_of_angle[TERMS], own_sin_of_angle[TERMS];
    for (int k = 0; k < order; ++k) {
        sine_and_cosine_of(k, s->angle, own_sin_of_angle, own_cos_of_angle);
        g[k] = s->com_y[k] - c->share_times_length * own_cos_of_angle[k];
    }
}

/* power_of_hip: Power of the total hip torque. */
static void guard_flight_power_of_hip(const real *constants, const real *series, int order, real *g) {
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        g[k] = broadcast(0.0);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_flight(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const flight_constants *c = (const void *)constants;
    const flight_series *s = (const void *)series;
    (void)order;
    if (watched >> 0 & 1) {
        const interval span_0 = interval_of_series(s->angle, power, 2);
        const interval span_1 = interval_of_series(s->com_y, power, 3);
        const interval span_2 = interval_at(c->by_1_minus_share_times_length,
            c->by_1_minus_share_times_length);
        const interval span_3 = interval_of_turn(s->angle[0], span_0, false);
        const interval span_4 = interval_product(span_2, span_3);
        const interval span_5 = interval_sum(span_1, span_4);
        bounds[0] = span_5;
    }
    if (watched >> 1 & 1) {
        const interval span_0 = interval_of_rate(s->com_y, power, 2);
        bounds[1] = span_0;
    }
    if (watched >> 2 & 1) {
        const interval span_0 = interval_of_series(s->angle, power, 2);
        const interval span_1 = interval_of_series(s->com_y, power, 3);
        const interval span_2 = interval_at(c->share_times_length, c->share_times_length);
        const interval span_3 = interval_of_turn(s->angle[0], span_0, false);
        const interval span_4 = interval_product(span_2, span_3);
        const interval span_5 = interval_difference(span_1, span_4);
        bounds[2] = span_5;
    }
    if (watched >> 3 & 1) {
        const interval span_0 = interval_at(broadcast(0.0), broadcast(0.0));
        bounds[3] = span_0;
    }
}

/* ---- fallen */

/* The run is over. */
typedef struct {
    real none[TERMS];
} fallen_series;

/* All coefficients. */
static void expand_fallen(const real *constants, int order, real *expanded) {
    (void)constants, (void)order, (void)expanded;
}

/* First variation of the series. */
static void vary_fallen(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    (void)constants, (void)series, (void)d_constants, (void)order, (void)varied;
}

/* ---- slip_constant */

/* m_f vdot = p - s mu f_n, where p is the push of the leg and s the direction of slip. */
typedef struct {
    real x_[TERMS], y_[TERMS], vx[TERMS], vy[TERMS], foot_x[TERMS], foot_vx[TERMS], damper_loss[TERMS],
        friction_loss[TERMS], work[TERMS], time[TERMS], seen_angle[TERMS], x__times_x_[TERMS],
        y__times_y_[TERMS], square[TERMS], length[TERMS], length_rate[TERMS], axial[TERMS],
        axial_times_x_[TERMS], turning[TERMS], turning_times_y_[TERMS], axial_times_y_[TERMS],
        turning_times_x_[TERMS], friction_force[TERMS], length_rate_times_length_rate[TERMS],
        friction_force_times_foot_vx[TERMS], x__times_vy[TERMS], y__times_vx[TERMS], angle_rate[TERMS];
} slip_constant_series;

typedef struct {
    pair x__times_x_, y__times_y_, length, axial, axial_times_x_, turning, turning_times_y_, axial_times_y_,
        turning_times_x_, length_rate_times_length_rate, friction_force_times_foot_vx, x__times_vy,
        y__times_vx, angle_rate;
} slip_constant_sums;

typedef struct {
    real inverse_length, inverse_square;
} slip_constant_factors;

/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_slip_constant_sums(const slip_constant_series *s, int i, int j, slip_constant_sums *sum) {
    add_products(&sum->x__times_x_, s->x_ + i - 1, s->x_[j + 1]);
    add_products(&sum->y__times_y_, s->y_ + i - 1, s->y_[j + 1]);
    add_products(&sum->length, s->length + i - 1, s->length[j + 1]);
    add_both_products(&sum->axial, s->axial, s->length, i, j);
    add_both_products(&sum->axial_times_x_, s->axial, s->x_, i, j);
    add_both_products(&sum->turning, s->turning, s->square, i, j);
    add_both_products(&sum->turning_times_y_, s->turning, s->y_, i, j);
    add_both_products(&sum->axial_times_y_, s->axial, s->y_, i, j);
    add_both_products(&sum->turning_times_x_, s->turning, s->x_, i, j);
    add_products(&sum->length_rate_times_length_rate, s->length_rate + i - 1, s->length_rate[j]);
    add_both_products(&sum->friction_force_times_foot_vx, s->friction_force, s->foot_vx, i, j);
    add_both_products(&sum->x__times_vy, s->x_, s->vy, i, j);
    add_both_products(&sum->y__times_vx, s->y_, s->vx, i, j);
    add_both_products(&sum->angle_rate, s->angle_rate, s->square, i, j);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_slip_constant_sums(const slip_constant_series *s, int i, slip_constant_sums *sum) {
    sum->x__times_x_ = next_middle_of_square(s->x_, i);
    sum->y__times_y_ = next_middle_of_square(s->y_, i);
    sum->length = next_middle_of_square(s->length, i);
    sum->axial = middle_of_product(s->axial, s->length, i);
    sum->axial_times_x_ = middle_of_product(s->axial, s->x_, i);
    sum->turning = middle_of_product(s->turning, s->square, i);
    sum->turning_times_y_ = middle_of_product(s->turning, s->y_, i);
    sum->axial_times_y_ = middle_of_product(s->axial, s->y_, i);
    sum->turning_times_x_ = middle_of_product(s->turning, s->x_, i);
    sum->length_rate_times_length_rate = middle_of_square(s->length_rate, i);
    sum->friction_force_times_foot_vx = middle_of_product(s->friction_force, s->foot_vx, i);
    sum->x__times_vy = middle_of_product(s->x_, s->vy, i);
    sum->y__times_vx = middle_of_product(s->y_, s->vx, i);
    sum->angle_rate = middle_of_product(s->angle_rate, s->square, i);
}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_slip_constant(const slip_constant_constants *c, const slip_constant_factors *by, int k,
    const slip_constant_sums *sum, int odd, slip_constant_series *s) {
    s->x_[k + 1] = s->vx[k] * series_reciprocal[k + 1];
    s->y_[k + 1] = s->vy[k] * series_reciprocal[k + 1];
    s->foot_x[k + 1] = s->foot_vx[k] * series_reciprocal[k + 1];
    /* x__times_x_ = x_ * x_ */
    s->x__times_x_[k + 1] = square_of(k + 1, part_of(sum->x__times_x_, odd), s->x_);
    /* y__times_y_ = y_ * y_ */
    s->y__times_y_[k + 1] = square_of(k + 1, part_of(sum->y__times_y_, odd), s->y_);
    /* square = x__times_x_ + y__times_y_ */
    s->square[k + 1] = s->x__times_x_[k + 1] + s->y__times_y_[k + 1];
    /* length = real_sqrt(square) */
    s->length[k + 1] = root_of(k + 1, part_of(sum->length, odd), s->square[k + 1], s->length,
        by->inverse_length);
    /* length_rate = real_rate(length) */
    s->length_rate[k] = (double)(k + 1) * s->length[k + 1];
    /* axial = (c->stiffness * (c->free_length - length) - c->damping * length_rate) / length */
    s->axial[k] = quotient_of(k, part_of(sum->axial, odd), with_constant(k, -(c->stiffness * s->length[k])
        - c->damping * s->length_rate[k], c->stiffness * c->free_length), s->axial, s->length,
        by->inverse_length);
    /* axial_times_x_ = axial * x_ */
    s->axial_times_x_[k] = product_of(k, part_of(sum->axial_times_x_, odd), s->axial, s->x_);
    /* turning = c->stance_torque / square */
    s->turning[k] = quotient_of(k, part_of(sum->turning, odd), constant_of(k, c->stance_torque), s->turning,
        s->square, by->inverse_square);
    /* turning_times_y_ = turning * y_ */
    s->turning_times_y_[k] = product_of(k, part_of(sum->turning_times_y_, odd), s->turning, s->y_);
    /* axial_times_y_ = axial * y_ */
    s->axial_times_y_[k] = product_of(k, part_of(sum->axial_times_y_, odd), s->axial, s->y_);
    /* turning_times_x_ = turning * x_ */
    s->turning_times_x_[k] = product_of(k, part_of(sum->turning_times_x_, odd), s->turning, s->x_);
    /* friction_force = c->way_times_friction * (axial_times_y_ + turning_times_x_ +
     * c->foot_mass_times_gravity) */
    s->friction_force[k] = with_constant(k, c->way_times_friction * (s->axial_times_y_[k]
        + s->turning_times_x_[k]), c->way_times_friction * c->foot_mass_times_gravity);
    /* length_rate_times_length_rate = length_rate * length_rate */
    s->length_rate_times_length_rate[k] = square_of(k, part_of(sum->length_rate_times_length_rate, odd),
        s->length_rate);
    /* friction_force_times_foot_vx = friction_force * foot_vx */
    s->friction_force_times_foot_vx[k] = product_of(k, part_of(sum->friction_force_times_foot_vx, odd),
        s->friction_force, s->foot_vx);
    /* x__times_vy = x_ * vy */
    s->x__times_vy[k] = product_of(k, part_of(sum->x__times_vy, odd), s->x_, s->vy);
    /* y__times_vx = y_ * vx */
    s->y__times_vx[k] = product_of(k, part_of(sum->y__times_vx, odd), s->y_, s->vx);
    /* angle_rate = (x__times_vy - y__times_vx) / square */
    s->angle_rate[k] = quotient_of(k, part_of(sum->angle_rate, odd), s->x__times_vy[k] - s->y__times_vx[k],
        s->angle_rate, s->square, by->inverse_square);
    s->vx[k + 1] = series_reciprocal[k + 1] * (c->inverse_body_mass * (s->axial_times_x_[k]
        - s->turning_times_y_[k]) - c->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k])
        - s->friction_force[k]));
    s->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_y_[k]
        + s->turning_times_x_[k]), -c->gravity));
    s->foot_vx[k + 1] = series_reciprocal[k + 1] * (c->inverse_foot_mass * (-(s->axial_times_x_[k]
        - s->turning_times_y_[k]) - s->friction_force[k]));
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->friction_loss[k + 1] = series_reciprocal[k + 1] * (s->friction_force_times_foot_vx[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (c->stance_torque * s->angle_rate[k]);
    s->seen_angle[k + 1] = series_reciprocal[k + 1] * (s->angle_rate[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_slip_constant(const real *constants, int order, real *series) {
    const slip_constant_constants copy = *(const slip_constant_constants *)(const void *)constants,
        *c = &copy;
    slip_constant_series *s = (void *)series;
    static const slip_constant_sums none;
    slip_constant_sums sum = none;
    s->time[1] = broadcast(1.0);
    s->seen_angle[0] = real_atan2(-s->x_[0], s->y_[0]);
    s->x__times_x_[0] = s->x_[0] * s->x_[0];
    s->y__times_y_[0] = s->y_[0] * s->y_[0];
    s->square[0] = s->x__times_x_[0] + s->y__times_y_[0];
    s->length[0] = real_sqrt(s->square[0]);
    const slip_constant_factors factors = {1.0 / s->length[0], 1.0 / s->square[0]}, *by = &factors;
    step_slip_constant(c, by, 0, &sum, 0, s);
    begin_slip_constant_sums(s, 0, &sum);
    step_slip_constant(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {
        begin_slip_constant_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_slip_constant_sums(s, i, j, &sum);
        }
        step_slip_constant(c, by, k, &sum, 0, s);
        add_slip_constant_sums(s, 1, k, &sum);
        step_slip_constant(c, by, k + 1, &sum, 1, s);
    }
}

/* First variation of the series. */
static void vary_slip_constant(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    const slip_constant_constants *d = (const void *)d_constants;
    slip_constant_series *t = (void *)varied;
    real x__times_x__2[TERMS], y__times_y__2[TERMS], d_length[TERMS], d_length_rate[TERMS],
        axial_times_d_length[TERMS], d_axial[TERMS], d_axial_times_x_[TERMS], axial_times_x__2[TERMS],
        turning_times_d_square[TERMS], d_turning[TERMS], d_turning_times_y_[TERMS], turning_times_y__2[TERMS],
        d_axial_times_y_[TERMS], axial_times_y__2[TERMS], d_turning_times_x_[TERMS],
        turning_times_x__2[TERMS], length_rate_times_d_length_rate[TERMS],
        d_friction_force_times_foot_vx[TERMS], friction_force_times_foot_vx_2[TERMS], x__times_vy_2[TERMS],
        x__times_vy_3[TERMS], y__times_vx_2[TERMS], y__times_vx_3[TERMS], angle_rate_times_d_square[TERMS],
        d_angle_rate[TERMS], d_square[TERMS], d_friction_force[TERMS];
    t->seen_angle[0] = (s->x_[0] * t->y_[0] - s->y_[0] * t->x_[0]) / s->square[0];
    x__times_x__2[0] = product(s->x_, t->x_, 0);
    y__times_y__2[0] = product(s->y_, t->y_, 0);
    d_square[0] = 2.0 * x__times_x__2[0] + 2.0 * y__times_y__2[0];
    d_length[0] = (0.5 * d_square[0]) / s->length[0];
    for (int k = 0; k < order; ++k) {
        t->x_[k + 1] = t->vx[k] * series_reciprocal[k + 1];
        t->y_[k + 1] = t->vy[k] * series_reciprocal[k + 1];
        t->foot_x[k + 1] = t->foot_vx[k] * series_reciprocal[k + 1];
        x__times_x__2[k + 1] = product(s->x_, t->x_, k + 1);
        y__times_y__2[k + 1] = product(s->y_, t->y_, k + 1);
        d_square[k + 1] = 2.0 * x__times_x__2[k + 1] + 2.0 * y__times_y__2[k + 1];
        d_length[k + 1] = (0.5 * d_square[k + 1] - product_so_far(d_length, s->length, k + 1)) / s->length[0];
        d_length_rate[k] = (double)(k + 1) * d_length[k + 1];
        axial_times_d_length[k] = product(s->axial, d_length, k);
        d_axial[k] = (with_constant(k, -(d->stiffness * s->length[k]) - c->stiffness * d_length[k]
            - (d->damping * s->length_rate[k] + c->damping * d_length_rate[k]) - axial_times_d_length[k],
            d->stiffness * c->free_length + c->stiffness * d->free_length) - product_so_far(d_axial,
            s->length, k)) / s->length[0];
        d_axial_times_x_[k] = product(d_axial, s->x_, k);
        axial_times_x__2[k] = product(s->axial, t->x_, k);
        turning_times_d_square[k] = product(s->turning, d_square, k);
        d_turning[k] = (with_constant(k, -turning_times_d_square[k], d->stance_torque)
            - product_so_far(d_turning, s->square, k)) / s->square[0];
        d_turning_times_y_[k] = product(d_turning, s->y_, k);
        turning_times_y__2[k] = product(s->turning, t->y_, k);
        d_axial_times_y_[k] = product(d_axial, s->y_, k);
        axial_times_y__2[k] = product(s->axial, t->y_, k);
        d_turning_times_x_[k] = product(d_turning, s->x_, k);
        turning_times_x__2[k] = product(s->turning, t->x_, k);
        d_friction_force[k] = with_constant(k, d->way_times_friction * (s->axial_times_y_[k]
            + s->turning_times_x_[k]) + c->way_times_friction * (d_axial_times_y_[k] + axial_times_y__2[k]
            + (d_turning_times_x_[k] + turning_times_x__2[k])),
            d->way_times_friction * c->foot_mass_times_gravity
            + c->way_times_friction * d->foot_mass_times_gravity);
        length_rate_times_d_length_rate[k] = product(s->length_rate, d_length_rate, k);
        d_friction_force_times_foot_vx[k] = product(d_friction_force, s->foot_vx, k);
        friction_force_times_foot_vx_2[k] = product(s->friction_force, t->foot_vx, k);
        x__times_vy_2[k] = product(t->x_, s->vy, k);
        x__times_vy_3[k] = product(s->x_, t->vy, k);
        y__times_vx_2[k] = product(t->y_, s->vx, k);
        y__times_vx_3[k] = product(s->y_, t->vx, k);
        angle_rate_times_d_square[k] = product(s->angle_rate, d_square, k);
        d_angle_rate[k] = (x__times_vy_2[k] + x__times_vy_3[k] - (y__times_vx_2[k] + y__times_vx_3[k])
            - angle_rate_times_d_square[k] - product_so_far(d_angle_rate, s->square, k)) / s->square[0];
        t->vx[k + 1] = series_reciprocal[k + 1] * (d->inverse_body_mass * (s->axial_times_x_[k]
            - s->turning_times_y_[k]) + c->inverse_body_mass * (d_axial_times_x_[k] + axial_times_x__2[k]
            - (d_turning_times_y_[k] + turning_times_y__2[k]))
            - (d->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k])
            - s->friction_force[k]) + c->inverse_foot_mass * (-(d_axial_times_x_[k] + axial_times_x__2[k]
            - (d_turning_times_y_[k] + turning_times_y__2[k])) - d_friction_force[k])));
        t->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_y_[k] + s->turning_times_x_[k])
            + c->inverse_body_mass * (d_axial_times_y_[k] + axial_times_y__2[k] + (d_turning_times_x_[k]
            + turning_times_x__2[k])), -d->gravity));
        t->foot_vx[k + 1] = series_reciprocal[k + 1] * (d->inverse_foot_mass * (-(s->axial_times_x_[k]
            - s->turning_times_y_[k]) - s->friction_force[k])
            + c->inverse_foot_mass * (-(d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k])) - d_friction_force[k]));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_d_length_rate[k]));
        t->friction_loss[k + 1] = series_reciprocal[k + 1] * (d_friction_force_times_foot_vx[k]
            + friction_force_times_foot_vx_2[k]);
        t->work[k + 1] = series_reciprocal[k + 1] * (d->stance_torque * s->angle_rate[k]
            + c->stance_torque * d_angle_rate[k]);
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->seen_angle[k + 1] = series_reciprocal[k + 1] * (d_angle_rate[k]);
    }
}

/* First variation of power_of_hip. */
static void d_observed_slip_constant_power_of_hip(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_constant_series *t = (const void *)d_series;
    (void)constants, (void)series, (void)d_constants;
    for (int k = 0; k < order; ++k) {
        dg[k] = (double)(k + 1) * t->work[k + 1];
    }
}

/* First variation of force_on_foot. */
static void d_observed_slip_constant_force_on_foot(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    const slip_constant_constants *d = (const void *)d_constants;
    const slip_constant_series *t = (const void *)d_series;
    real own_x__times_x__2[TERMS], own_y__times_y__2[TERMS], own_d_length[TERMS], own_d_length_rate[TERMS],
        own_axial_times_d_length[TERMS], own_d_axial[TERMS], own_d_axial_times_y_[TERMS],
        own_axial_times_y__2[TERMS], own_turning_times_d_square[TERMS], own_d_turning[TERMS],
        own_d_turning_times_x_[TERMS], own_turning_times_x__2[TERMS], own_d_square[TERMS];
    own_x__times_x__2[0] = product(s->x_, t->x_, 0);
    own_y__times_y__2[0] = product(s->y_, t->y_, 0);
    own_d_square[0] = 2.0 * own_x__times_x__2[0] + 2.0 * own_y__times_y__2[0];
    own_d_length[0] = (0.5 * own_d_square[0]) / s->length[0];
    for (int k = 0; k < order; ++k) {
        own_x__times_x__2[k + 1] = product(s->x_, t->x_, k + 1);
        own_y__times_y__2[k + 1] = product(s->y_, t->y_, k + 1);
        own_d_square[k + 1] = 2.0 * own_x__times_x__2[k + 1] + 2.0 * own_y__times_y__2[k + 1];
        own_d_length[k + 1] = (0.5 * own_d_square[k + 1] - product_so_far(own_d_length, s->length, k
            + 1)) / s->length[0];
        own_d_length_rate[k] = (double)(k + 1) * own_d_length[k + 1];
        own_axial_times_d_length[k] = product(s->axial, own_d_length, k);
        own_d_axial[k] = (with_constant(k, -(d->stiffness * s->length[k]) - c->stiffness * own_d_length[k]
            - (d->damping * s->length_rate[k] + c->damping * own_d_length_rate[k])
            - own_axial_times_d_length[k], d->stiffness * c->free_length + c->stiffness * d->free_length)
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, -own_turning_times_d_square[k], d->stance_torque)
            - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        dg[k] = with_constant(k, own_d_axial_times_y_[k] + own_axial_times_y__2[k]
            + (own_d_turning_times_x_[k] + own_turning_times_x__2[k]), d->foot_mass_times_gravity);
    }
}

/* falls: The body reaches the ground. */
static void guard_slip_constant_falls(const real *constants, const real *series, int order, real *g) {
    const slip_constant_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->y_[k];
    }
}

/* collapses: The leg is shorter than leg.min_length. */
static void guard_slip_constant_collapses(const real *constants, const real *series, int order, real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->length[k], -c->least_length);
    }
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static void guard_slip_constant_mid_stance(const real *constants, const real *series, int order, real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->seen_angle[k], c->winding);
    }
}

/* lift_off: The centre of mass flies to the next apex. */
static void guard_slip_constant_lift_off(const real *constants, const real *series, int order, real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k], c->foot_mass_times_gravity);
    }
}

/* comes_to_rest: The slip velocity reaches 0: the foot sticks, or slips the other way. */
static void guard_slip_constant_comes_to_rest(const real *constants, const real *series, int order, real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->way * s->foot_vx[k];
    }
}

/* power_of_hip: Power of the total hip torque. */
static void guard_slip_constant_power_of_hip(const real *constants, const real *series, int order, real *g) {
    const slip_constant_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->work[k + 1];
    }
}

/* force_on_foot: Normal force of a sticking or slipping foot. */
static void guard_slip_constant_force_on_foot(const real *constants, const real *series, int order, real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k], c->foot_mass_times_gravity);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_slip_constant(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    const interval span_0 = interval_of_series(s->y_, power, order);
    bounds[0] = span_0;
    const interval span_1 = interval_of_series(s->length, power, order);
    const interval span_2 = interval_at(c->least_length, c->least_length);
    const interval span_3 = interval_difference(span_1, span_2);
    bounds[1] = span_3;
    const interval span_4 = interval_of_series(s->axial_times_y_, power, order);
    const interval span_5 = interval_of_series(s->turning_times_x_, power, order);
    const interval span_6 = interval_sum(span_4, span_5);
    const interval span_7 = interval_at(c->foot_mass_times_gravity, c->foot_mass_times_gravity);
    const interval span_8 = interval_sum(span_6, span_7);
    bounds[3] = span_8;
    const interval span_9 = interval_at(c->way, c->way);
    const interval span_10 = interval_of_series(s->foot_vx, power, order);
    const interval span_11 = interval_product(span_9, span_10);
    bounds[4] = span_11;
    if (watched >> 2 & 1) {
        const interval span_12 = interval_of_series(s->seen_angle, power, order);
        const interval span_13 = interval_at(c->winding, c->winding);
        const interval span_14 = interval_sum(span_12, span_13);
        bounds[2] = span_14;
    }
    if (watched >> 6 & 1) {
        bounds[6] = span_8;
    }
}

/* ---- stick */

/* The foot is at rest. */
typedef struct {
    real x_[TERMS], y_[TERMS], vx[TERMS], vy[TERMS], damper_loss[TERMS], work[TERMS], time[TERMS],
        foot_x[TERMS], seen_angle[TERMS], x__times_x_[TERMS], y__times_y_[TERMS], square[TERMS],
        length[TERMS], length_rate[TERMS], axial[TERMS], axial_times_x_[TERMS], turning[TERMS],
        turning_times_y_[TERMS], axial_times_y_[TERMS], turning_times_x_[TERMS],
        length_rate_times_length_rate[TERMS], x__times_vy[TERMS], y__times_vx[TERMS], angle_rate[TERMS];
} stick_series;

typedef struct {
    pair x__times_x_, y__times_y_, length, axial, axial_times_x_, turning, turning_times_y_, axial_times_y_,
        turning_times_x_, length_rate_times_length_rate, x__times_vy, y__times_vx, angle_rate;
} stick_sums;

typedef struct {
    real inverse_length, inverse_square;
} stick_factors;

/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_stick_sums(const stick_series *s, int i, int j, stick_sums *sum) {
    add_products(&sum->x__times_x_, s->x_ + i - 1, s->x_[j + 1]);
    add_products(&sum->y__times_y_, s->y_ + i - 1, s->y_[j + 1]);
    add_products(&sum->length, s->length + i - 1, s->length[j + 1]);
    add_both_products(&sum->axial, s->axial, s->length, i, j);
    add_both_products(&sum->axial_times_x_, s->axial, s->x_, i, j);
    add_both_products(&sum->turning, s->turning, s->square, i, j);
    add_both_products(&sum->turning_times_y_, s->turning, s->y_, i, j);
    add_both_products(&sum->axial_times_y_, s->axial, s->y_, i, j);
    add_both_products(&sum->turning_times_x_, s->turning, s->x_, i, j);
    add_products(&sum->length_rate_times_length_rate, s->length_rate + i - 1, s->length_rate[j]);
    add_both_products(&sum->x__times_vy, s->x_, s->vy, i, j);
    add_both_products(&sum->y__times_vx, s->y_, s->vx, i, j);
    add_both_products(&sum->angle_rate, s->angle_rate, s->square, i, j);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_stick_sums(const stick_series *s, int i, stick_sums *sum) {
    sum->x__times_x_ = next_middle_of_square(s->x_, i);
    sum->y__times_y_ = next_middle_of_square(s->y_, i);
    sum->length = next_middle_of_square(s->length, i);
    sum->axial = middle_of_product(s->axial, s->length, i);
    sum->axial_times_x_ = middle_of_product(s->axial, s->x_, i);
    sum->turning = middle_of_product(s->turning, s->square, i);
    sum->turning_times_y_ = middle_of_product(s->turning, s->y_, i);
    sum->axial_times_y_ = middle_of_product(s->axial, s->y_, i);
    sum->turning_times_x_ = middle_of_product(s->turning, s->x_, i);
    sum->length_rate_times_length_rate = middle_of_square(s->length_rate, i);
    sum->x__times_vy = middle_of_product(s->x_, s->vy, i);
    sum->y__times_vx = middle_of_product(s->y_, s->vx, i);
    sum->angle_rate = middle_of_product(s->angle_rate, s->square, i);
}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_stick(const stick_constants *c, const stick_factors *by, int k, const stick_sums *sum,
    int odd, stick_series *s) {
    s->x_[k + 1] = s->vx[k] * series_reciprocal[k + 1];
    s->y_[k + 1] = s->vy[k] * series_reciprocal[k + 1];
    /* x__times_x_ = x_ * x_ */
    s->x__times_x_[k + 1] = square_of(k + 1, part_of(sum->x__times_x_, odd), s->x_);
    /* y__times_y_ = y_ * y_ */
    s->y__times_y_[k + 1] = square_of(k + 1, part_of(sum->y__times_y_, odd), s->y_);
    /* square = x__times_x_ + y__times_y_ */
    s->square[k + 1] = s->x__times_x_[k + 1] + s->y__times_y_[k + 1];
    /* length = real_sqrt(square) */
    s->length[k + 1] = root_of(k + 1, part_of(sum->length, odd), s->square[k + 1], s->length,
        by->inverse_length);
    /* length_rate = real_rate(length) */
    s->length_rate[k] = (double)(k + 1) * s->length[k + 1];
    /* axial = (c->stiffness * (c->free_length - length) - c->damping * length_rate) / length */
    s->axial[k] = quotient_of(k, part_of(sum->axial, odd), with_constant(k, -(c->stiffness * s->length[k])
        - c->damping * s->length_rate[k], c->stiffness * c->free_length), s->axial, s->length,
        by->inverse_length);
    /* axial_times_x_ = axial * x_ */
    s->axial_times_x_[k] = product_of(k, part_of(sum->axial_times_x_, odd), s->axial, s->x_);
    /* turning = c->stance_torque / square */
    s->turning[k] = quotient_of(k, part_of(sum->turning, odd), constant_of(k, c->stance_torque), s->turning,
        s->square, by->inverse_square);
    /* turning_times_y_ = turning * y_ */
    s->turning_times_y_[k] = product_of(k, part_of(sum->turning_times_y_, odd), s->turning, s->y_);
    /* axial_times_y_ = axial * y_ */
    s->axial_times_y_[k] = product_of(k, part_of(sum->axial_times_y_, odd), s->axial, s->y_);
    /* turning_times_x_ = turning * x_ */
    s->turning_times_x_[k] = product_of(k, part_of(sum->turning_times_x_, odd), s->turning, s->x_);
    /* length_rate_times_length_rate = length_rate * length_rate */
    s->length_rate_times_length_rate[k] = square_of(k, part_of(sum->length_rate_times_length_rate, odd),
        s->length_rate);
    /* x__times_vy = x_ * vy */
    s->x__times_vy[k] = product_of(k, part_of(sum->x__times_vy, odd), s->x_, s->vy);
    /* y__times_vx = y_ * vx */
    s->y__times_vx[k] = product_of(k, part_of(sum->y__times_vx, odd), s->y_, s->vx);
    /* angle_rate = (x__times_vy - y__times_vx) / square */
    s->angle_rate[k] = quotient_of(k, part_of(sum->angle_rate, odd), s->x__times_vy[k] - s->y__times_vx[k],
        s->angle_rate, s->square, by->inverse_square);
    s->vx[k + 1] = series_reciprocal[k + 1] * (c->inverse_body_mass * (s->axial_times_x_[k]
        - s->turning_times_y_[k]));
    s->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_y_[k]
        + s->turning_times_x_[k]), -c->gravity));
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (c->stance_torque * s->angle_rate[k]);
    s->seen_angle[k + 1] = series_reciprocal[k + 1] * (s->angle_rate[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_stick(const real *constants, int order, real *series) {
    const stick_constants copy = *(const stick_constants *)(const void *)constants, *c = &copy;
    stick_series *s = (void *)series;
    static const stick_sums none;
    stick_sums sum = none;
    s->time[1] = broadcast(1.0);
    s->foot_x[1] = c->foot_vx;
    s->seen_angle[0] = real_atan2(-s->x_[0], s->y_[0]);
    s->x__times_x_[0] = s->x_[0] * s->x_[0];
    s->y__times_y_[0] = s->y_[0] * s->y_[0];
    s->square[0] = s->x__times_x_[0] + s->y__times_y_[0];
    s->length[0] = real_sqrt(s->square[0]);
    const stick_factors factors = {1.0 / s->length[0], 1.0 / s->square[0]}, *by = &factors;
    step_stick(c, by, 0, &sum, 0, s);
    begin_stick_sums(s, 0, &sum);
    step_stick(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {
        begin_stick_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_stick_sums(s, i, j, &sum);
        }
        step_stick(c, by, k, &sum, 0, s);
        add_stick_sums(s, 1, k, &sum);
        step_stick(c, by, k + 1, &sum, 1, s);
    }
}

/* First variation of the series. */
static void vary_stick(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    const stick_constants *d = (const void *)d_constants;
    stick_series *t = (void *)varied;
    real x__times_x__2[TERMS], y__times_y__2[TERMS], d_length[TERMS], d_length_rate[TERMS],
        axial_times_d_length[TERMS], d_axial[TERMS], d_axial_times_x_[TERMS], axial_times_x__2[TERMS],
        turning_times_d_square[TERMS], d_turning[TERMS], d_turning_times_y_[TERMS], turning_times_y__2[TERMS],
        d_axial_times_y_[TERMS], axial_times_y__2[TERMS], d_turning_times_x_[TERMS],
        turning_times_x__2[TERMS], length_rate_times_d_length_rate[TERMS], x__times_vy_2[TERMS],
        x__times_vy_3[TERMS], y__times_vx_2[TERMS], y__times_vx_3[TERMS], angle_rate_times_d_square[TERMS],
        d_angle_rate[TERMS], d_square[TERMS];
    t->seen_angle[0] = (s->x_[0] * t->y_[0] - s->y_[0] * t->x_[0]) / s->square[0];
    x__times_x__2[0] = product(s->x_, t->x_, 0);
    y__times_y__2[0] = product(s->y_, t->y_, 0);
    d_square[0] = 2.0 * x__times_x__2[0] + 2.0 * y__times_y__2[0];
    d_length[0] = (0.5 * d_square[0]) / s->length[0];
    for (int k = 0; k < order; ++k) {
        t->x_[k + 1] = t->vx[k] * series_reciprocal[k + 1];
        t->y_[k + 1] = t->vy[k] * series_reciprocal[k + 1];
        x__times_x__2[k + 1] = product(s->x_, t->x_, k + 1);
        y__times_y__2[k + 1] = product(s->y_, t->y_, k + 1);
        d_square[k + 1] = 2.0 * x__times_x__2[k + 1] + 2.0 * y__times_y__2[k + 1];
        d_length[k + 1] = (0.5 * d_square[k + 1] - product_so_far(d_length, s->length, k + 1)) / s->length[0];
        d_length_rate[k] = (double)(k + 1) * d_length[k + 1];
        axial_times_d_length[k] = product(s->axial, d_length, k);
        d_axial[k] = (with_constant(k, -(d->stiffness * s->length[k]) - c->stiffness * d_length[k]
            - (d->damping * s->length_rate[k] + c->damping * d_length_rate[k]) - axial_times_d_length[k],
            d->stiffness * c->free_length + c->stiffness * d->free_length) - product_so_far(d_axial,
            s->length, k)) / s->length[0];
        d_axial_times_x_[k] = product(d_axial, s->x_, k);
        axial_times_x__2[k] = product(s->axial, t->x_, k);
        turning_times_d_square[k] = product(s->turning, d_square, k);
        d_turning[k] = (with_constant(k, -turning_times_d_square[k], d->stance_torque)
            - product_so_far(d_turning, s->square, k)) / s->square[0];
        d_turning_times_y_[k] = product(d_turning, s->y_, k);
        turning_times_y__2[k] = product(s->turning, t->y_, k);
        d_axial_times_y_[k] = product(d_axial, s->y_, k);
        axial_times_y__2[k] = product(s->axial, t->y_, k);
        d_turning_times_x_[k] = product(d_turning, s->x_, k);
        turning_times_x__2[k] = product(s->turning, t->x_, k);
        length_rate_times_d_length_rate[k] = product(s->length_rate, d_length_rate, k);
        x__times_vy_2[k] = product(t->x_, s->vy, k);
        x__times_vy_3[k] = product(s->x_, t->vy, k);
        y__times_vx_2[k] = product(t->y_, s->vx, k);
        y__times_vx_3[k] = product(s->y_, t->vx, k);
        angle_rate_times_d_square[k] = product(s->angle_rate, d_square, k);
        d_angle_rate[k] = (x__times_vy_2[k] + x__times_vy_3[k] - (y__times_vx_2[k] + y__times_vx_3[k])
            - angle_rate_times_d_square[k] - product_so_far(d_angle_rate, s->square, k)) / s->square[0];
        t->vx[k + 1] = series_reciprocal[k + 1] * (d->inverse_body_mass * (s->axial_times_x_[k]
            - s->turning_times_y_[k]) + c->inverse_body_mass * (d_axial_times_x_[k] + axial_times_x__2[k]
            - (d_turning_times_y_[k] + turning_times_y__2[k])));
        t->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_y_[k] + s->turning_times_x_[k])
            + c->inverse_body_mass * (d_axial_times_y_[k] + axial_times_y__2[k] + (d_turning_times_x_[k]
            + turning_times_x__2[k])), -d->gravity));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_d_length_rate[k]));
        t->work[k + 1] = series_reciprocal[k + 1] * (d->stance_torque * s->angle_rate[k]
            + c->stance_torque * d_angle_rate[k]);
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->foot_x[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->foot_vx));
        t->seen_angle[k + 1] = series_reciprocal[k + 1] * (d_angle_rate[k]);
    }
}

/* First variation of power_of_hip. */
static void d_observed_stick_power_of_hip(const real *constants, const real *series, const real *d_constants,
    const real *d_series, int order, real *dg) {
    const stick_series *t = (const void *)d_series;
    (void)constants, (void)series, (void)d_constants;
    for (int k = 0; k < order; ++k) {
        dg[k] = (double)(k + 1) * t->work[k + 1];
    }
}

/* First variation of force_on_foot. */
static void d_observed_stick_force_on_foot(const real *constants, const real *series, const real *d_constants,
    const real *d_series, int order, real *dg) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    const stick_constants *d = (const void *)d_constants;
    const stick_series *t = (const void *)d_series;
    real own_x__times_x__2[TERMS], own_y__times_y__2[TERMS], own_d_length[TERMS], own_d_length_rate[TERMS],
        own_axial_times_d_length[TERMS], own_d_axial[TERMS], own_d_axial_times_y_[TERMS],
        own_axial_times_y__2[TERMS], own_turning_times_d_square[TERMS], own_d_turning[TERMS],
        own_d_turning_times_x_[TERMS], own_turning_times_x__2[TERMS], own_d_square[TERMS];
    own_x__times_x__2[0] = product(s->x_, t->x_, 0);
    own_y__times_y__2[0] = product(s->y_, t->y_, 0);
    own_d_square[0] = 2.0 * own_x__times_x__2[0] + 2.0 * own_y__times_y__2[0];
    own_d_length[0] = (0.5 * own_d_square[0]) / s->length[0];
    for (int k = 0; k < order; ++k) {
        own_x__times_x__2[k + 1] = product(s->x_, t->x_, k + 1);
        own_y__times_y__2[k + 1] = product(s->y_, t->y_, k + 1);
        own_d_square[k + 1] = 2.0 * own_x__times_x__2[k + 1] + 2.0 * own_y__times_y__2[k + 1];
        own_d_length[k + 1] = (0.5 * own_d_square[k + 1] - product_so_far(own_d_length, s->length, k
            + 1)) / s->length[0];
        own_d_length_rate[k] = (double)(k + 1) * own_d_length[k + 1];
        own_axial_times_d_length[k] = product(s->axial, own_d_length, k);
        own_d_axial[k] = (with_constant(k, -(d->stiffness * s->length[k]) - c->stiffness * own_d_length[k]
            - (d->damping * s->length_rate[k] + c->damping * own_d_length_rate[k])
            - own_axial_times_d_length[k], d->stiffness * c->free_length + c->stiffness * d->free_length)
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, -own_turning_times_d_square[k], d->stance_torque)
            - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        dg[k] = with_constant(k, own_d_axial_times_y_[k] + own_axial_times_y__2[k]
            + (own_d_turning_times_x_[k] + own_turning_times_x__2[k]), d->foot_mass_times_gravity);
    }
}

/* falls: The body reaches the ground. */
static void guard_stick_falls(const real *constants, const real *series, int order, real *g) {
    const stick_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->y_[k];
    }
}

/* collapses: The leg is shorter than leg.min_length. */
static void guard_stick_collapses(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->length[k], -c->least_length);
    }
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static void guard_stick_mid_stance(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->seen_angle[k], c->winding);
    }
}

/* lift_off: The centre of mass flies to the next apex. */
static void guard_stick_lift_off(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k], c->foot_mass_times_gravity);
    }
}

/* slips_forward: The push of the leg exceeds static friction, and the foot slips forward. */
static void guard_stick_slips_forward(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, c->friction * (s->axial_times_y_[k] + s->turning_times_x_[k])
            + (s->axial_times_x_[k] - s->turning_times_y_[k]), c->friction * c->foot_mass_times_gravity);
    }
}

/* slips_backward: The push of the leg exceeds static friction, and the foot slips backward. */
static void guard_stick_slips_backward(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, c->friction * (s->axial_times_y_[k] + s->turning_times_x_[k])
            - (s->axial_times_x_[k] - s->turning_times_y_[k]), c->friction * c->foot_mass_times_gravity);
    }
}

/* power_of_hip: Power of the total hip torque. */
static void guard_stick_power_of_hip(const real *constants, const real *series, int order, real *g) {
    const stick_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->work[k + 1];
    }
}

/* force_on_foot: Normal force of a sticking or slipping foot. */
static void guard_stick_force_on_foot(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k], c->foot_mass_times_gravity);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_stick(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    const interval span_0 = interval_of_series(s->y_, power, order);
    bounds[0] = span_0;
    const interval span_1 = interval_of_series(s->length, power, order);
    const interval span_2 = interval_at(c->least_length, c->least_length);
    const interval span_3 = interval_difference(span_1, span_2);
    bounds[1] = span_3;
    const interval span_4 = interval_of_series(s->axial_times_y_, power, order);
    const interval span_5 = interval_of_series(s->turning_times_x_, power, order);
    const interval span_6 = interval_sum(span_4, span_5);
    const interval span_7 = interval_at(c->foot_mass_times_gravity, c->foot_mass_times_gravity);
    const interval span_8 = interval_sum(span_6, span_7);
    bounds[3] = span_8;
    const interval span_9 = interval_at(c->friction, c->friction);
    const interval span_10 = interval_product(span_9, span_8);
    const interval span_11 = interval_of_series(s->axial_times_x_, power, order);
    const interval span_12 = interval_of_series(s->turning_times_y_, power, order);
    const interval span_13 = interval_difference(span_11, span_12);
    const interval span_14 = interval_sum(span_10, span_13);
    bounds[4] = span_14;
    const interval span_15 = interval_difference(span_10, span_13);
    bounds[5] = span_15;
    if (watched >> 2 & 1) {
        const interval span_16 = interval_of_series(s->seen_angle, power, order);
        const interval span_17 = interval_at(c->winding, c->winding);
        const interval span_18 = interval_sum(span_16, span_17);
        bounds[2] = span_18;
    }
    if (watched >> 7 & 1) {
        bounds[7] = span_8;
    }
}

/* ---- no_stance */

/* The impact leaves no load on the foot. */
typedef struct {
    real none[TERMS];
} no_stance_series;

/* All coefficients. */
static void expand_no_stance(const real *constants, int order, real *expanded) {
    (void)constants, (void)order, (void)expanded;
}

/* First variation of the series. */
static void vary_no_stance(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    (void)constants, (void)series, (void)d_constants, (void)order, (void)varied;
}

/* ---- no_apex */

/* The centre of mass does not rise at lift-off, or nothing pulls it down. */
typedef struct {
    real none[TERMS];
} no_apex_series;

/* All coefficients. */
static void expand_no_apex(const real *constants, int order, real *expanded) {
    (void)constants, (void)order, (void)expanded;
}

/* First variation of the series. */
static void vary_no_apex(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    (void)constants, (void)series, (void)d_constants, (void)order, (void)varied;
}

static const tdmf_polynomial polynomials_start_of_run[] = {guard_start_of_run_begins};
static const tdmf_vary_polynomial vary_observed_start_of_run[] = {NULL};
static const int moving_start_of_run[] = {0}, degrees_start_of_run[] = {1}, judged_start_of_run[] = {0},
    divided_start_of_run[] = {0}, divisors_start_of_run[] = {0}, integrals_start_of_run[] = {0},
    factors_start_of_run[] = {0};
static const tdmf_polynomial polynomials_no_start[] = {NULL};
static const tdmf_vary_polynomial vary_observed_no_start[] = {NULL};
static const int moving_no_start[] = {0}, degrees_no_start[] = {0}, judged_no_start[] = {0},
    divided_no_start[] = {0}, divisors_no_start[] = {0}, integrals_no_start[] = {0}, factors_no_start[] = {0};
static const tdmf_polynomial polynomials_flight[] = {guard_flight_falls, guard_flight_apex,
    guard_flight_touchdown, guard_flight_power_of_hip};
static const tdmf_vary_polynomial vary_observed_flight[] = {d_observed_flight_power_of_hip};
static const int moving_flight[] = {50, 0, 49, 52, 70, 44}, degrees_flight[] = {2, 1, 1, 1, 1, 1},
    judged_flight[] = {0}, divided_flight[] = {0}, divisors_flight[] = {0}, integrals_flight[] = {-1},
    factors_flight[] = {-1, -1};
static const tdmf_polynomial polynomials_fallen[] = {NULL};
static const tdmf_vary_polynomial vary_observed_fallen[] = {NULL};
static const int moving_fallen[] = {0}, degrees_fallen[] = {0}, judged_fallen[] = {0}, divided_fallen[] = {0},
    divisors_fallen[] = {0}, integrals_fallen[] = {0}, factors_fallen[] = {0};
static const tdmf_polynomial polynomials_slip_constant[] = {guard_slip_constant_falls,
    guard_slip_constant_collapses, guard_slip_constant_mid_stance, guard_slip_constant_lift_off,
    guard_slip_constant_comes_to_rest, guard_slip_constant_power_of_hip, guard_slip_constant_force_on_foot};
static const tdmf_vary_polynomial vary_observed_slip_constant[] = {d_observed_slip_constant_power_of_hip,
    d_observed_slip_constant_force_on_foot};
static const int moving_slip_constant[] = {54, 55, 56, 57, 58, 59, 61, 64, 72, 0},
    degrees_slip_constant[] = {99, 99, 99, 99, 99, 99, 99, 99, 99, 1, 99}, judged_slip_constant[] = {2, 3, 5,
    6, 7, 8, 10}, divided_slip_constant[] = {-1, -1, -1, -1, -1, -1, -1}, divisors_slip_constant[] = {14, 13},
    integrals_slip_constant[] = {8, -1}, factors_slip_constant[] = {27, -1, -1, -1};
static const tdmf_polynomial polynomials_stick[] = {guard_stick_falls, guard_stick_collapses,
    guard_stick_mid_stance, guard_stick_lift_off, guard_stick_slips_forward, guard_stick_slips_backward,
    guard_stick_power_of_hip, guard_stick_force_on_foot};
static const tdmf_vary_polynomial vary_observed_stick[] = {d_observed_stick_power_of_hip,
    d_observed_stick_force_on_foot};
static const int moving_stick[] = {54, 55, 56, 57, 61, 72, 0, 58}, degrees_stick[] = {99, 99, 99, 99, 99, 99,
    1, 1, 99}, judged_stick[] = {2, 3, 4, 5, 8}, divided_stick[] = {-1, -1, -1, -1, -1},
    divisors_stick[] = {12, 11}, integrals_stick[] = {5, -1}, factors_stick[] = {23, -1, -1, -1};
static const tdmf_polynomial polynomials_no_stance[] = {NULL};
static const tdmf_vary_polynomial vary_observed_no_stance[] = {NULL};
static const int moving_no_stance[] = {0}, degrees_no_stance[] = {0}, judged_no_stance[] = {0},
    divided_no_stance[] = {0}, divisors_no_stance[] = {0}, integrals_no_stance[] = {0},
    factors_no_stance[] = {0};
static const tdmf_polynomial polynomials_no_apex[] = {NULL};
static const tdmf_vary_polynomial vary_observed_no_apex[] = {NULL};
static const int moving_no_apex[] = {0}, degrees_no_apex[] = {0}, judged_no_apex[] = {0},
    divided_no_apex[] = {0}, divisors_no_apex[] = {0}, integrals_no_apex[] = {0}, factors_no_apex[] = {0};

const tdmf_motion_kind TDMF_OF_WIDTH(tdmf_plain_reduced_runner_motions)[] = {
    {.moving_count = 1, .extra_count = 0, .series_count = 1, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_start_of_run, .degrees = degrees_start_of_run,
        .judged = judged_start_of_run, .divided = divided_start_of_run, .divisors = divisors_start_of_run,
        .integrals = integrals_start_of_run, .factors = factors_start_of_run,
        .polynomials = polynomials_start_of_run, .vary_observed = vary_observed_start_of_run,
        .expand = expand_start_of_run, .vary = vary_start_of_run, .bounds = bounds_start_of_run},
    {.moving_count = 0, .extra_count = 0, .series_count = 0, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_no_start, .degrees = degrees_no_start, .judged = judged_no_start,
        .divided = divided_no_start, .divisors = divisors_no_start, .integrals = integrals_no_start,
        .factors = factors_no_start, .polynomials = polynomials_no_start,
        .vary_observed = vary_observed_no_start, .expand = expand_no_start, .vary = vary_no_start,
        .bounds = NULL},
    {.moving_count = 6, .extra_count = 0, .series_count = 6, .constant_count = 6, .judged_count = 0,
        .divisor_count = 0, .moving = moving_flight, .degrees = degrees_flight, .judged = judged_flight,
        .divided = divided_flight, .divisors = divisors_flight, .integrals = integrals_flight,
        .factors = factors_flight, .polynomials = polynomials_flight, .vary_observed = vary_observed_flight,
        .expand = expand_flight, .vary = vary_flight, .bounds = bounds_flight},
    {.moving_count = 0, .extra_count = 0, .series_count = 0, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_fallen, .degrees = degrees_fallen, .judged = judged_fallen,
        .divided = divided_fallen, .divisors = divisors_fallen, .integrals = integrals_fallen,
        .factors = factors_fallen, .polynomials = polynomials_fallen, .vary_observed = vary_observed_fallen,
        .expand = expand_fallen, .vary = vary_fallen, .bounds = NULL},
    {.moving_count = 10, .extra_count = 1, .series_count = 28, .constant_count = 12, .judged_count = 7,
        .divisor_count = 2, .moving = moving_slip_constant, .degrees = degrees_slip_constant,
        .judged = judged_slip_constant, .divided = divided_slip_constant, .divisors = divisors_slip_constant,
        .integrals = integrals_slip_constant, .factors = factors_slip_constant,
        .polynomials = polynomials_slip_constant, .vary_observed = vary_observed_slip_constant,
        .expand = expand_slip_constant, .vary = vary_slip_constant, .bounds = bounds_slip_constant},
    {.moving_count = 8, .extra_count = 1, .series_count = 24, .constant_count = 11, .judged_count = 5,
        .divisor_count = 2, .moving = moving_stick, .degrees = degrees_stick, .judged = judged_stick,
        .divided = divided_stick, .divisors = divisors_stick, .integrals = integrals_stick,
        .factors = factors_stick, .polynomials = polynomials_stick, .vary_observed = vary_observed_stick,
        .expand = expand_stick, .vary = vary_stick, .bounds = bounds_stick},
    {.moving_count = 0, .extra_count = 0, .series_count = 0, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_no_stance, .degrees = degrees_no_stance,
        .judged = judged_no_stance, .divided = divided_no_stance, .divisors = divisors_no_stance,
        .integrals = integrals_no_stance, .factors = factors_no_stance, .polynomials = polynomials_no_stance,
        .vary_observed = vary_observed_no_stance, .expand = expand_no_stance, .vary = vary_no_stance,
        .bounds = NULL},
    {.moving_count = 0, .extra_count = 0, .series_count = 0, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_no_apex, .degrees = degrees_no_apex, .judged = judged_no_apex,
        .divided = divided_no_apex, .divisors = divisors_no_apex, .integrals = integrals_no_apex,
        .factors = factors_no_apex, .polynomials = polynomials_no_apex,
        .vary_observed = vary_observed_no_apex, .expand = expand_no_apex, .vary = vary_no_apex,
        .bounds = NULL},
};

#ifdef TDMF_LANES
const void *TDMF_OF_WIDTH(tdmf_plain_reduced_runner_motions_of)(void) {
    return TDMF_OF_WIDTH(tdmf_plain_reduced_runner_motions);
}
#endif
