/* Derived from the page Runner: edit the page, not this. */
#include "runner.h"

/* ---- start_of_run */

/* Start of a run, in the world's states. */
typedef struct {
    real extension[TERMS], external_fx[TERMS], external_fy[TERMS], friction[TERMS], external_torque[TERMS],
        time[TERMS];
} start_of_run_series;

/* All coefficients. */
static void expand_start_of_run(const real *constants, int order, real *expanded) {
    const start_of_run_constants *c = (const void *)constants;
    start_of_run_series *s = (void *)expanded;
    (void)order;
    s->extension[1] = c->extension_rate;
    s->external_fx[1] = c->external_fx_rate;
    s->external_fy[1] = c->external_fy_rate;
    s->friction[1] = c->friction_rate;
    s->external_torque[1] = c->external_torque_rate;
    s->time[1] = broadcast(1.0);
}

/* First variation of the series. */
static void vary_start_of_run(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const start_of_run_constants *d = (const void *)d_constants;
    start_of_run_series *t = (void *)varied;
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        t->extension[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->extension_rate));
        t->external_fx[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fx_rate));
        t->external_fy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fy_rate));
        t->friction[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->friction_rate));
        t->external_torque[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_torque_rate));
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
    }
}

/* passes_end: The foot is above the next segment. */
static void guard_start_of_run_passes_end(const real *constants, const real *series, int order, real *g) {
    const start_of_run_constants *c = (const void *)constants;
    (void)series;
    for (int k = 0; k < order; ++k) {
        g[k] = constant_of(k, c->segment_end_minus_seen_x);
    }
}

/* passes_begin: The foot is above the segment before. */
static void guard_start_of_run_passes_begin(const real *constants, const real *series, int order, real *g) {
    const start_of_run_constants *c = (const void *)constants;
    (void)series;
    for (int k = 0; k < order; ++k) {
        g[k] = constant_of(k, c->seen_x_minus_segment_begin);
    }
}

/* begins: An impact if the foot is on the ground and does not rise, else flight. An apex opens a stride. */
static void guard_start_of_run_begins(const real *constants, const real *series, int order, real *g) {
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        g[k] = constant_of(k, broadcast(-1.0));
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_start_of_run(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const start_of_run_constants *c = (const void *)constants;
    (void)series, (void)power, (void)order, (void)watched;
    const interval span_0 = interval_at(c->segment_end_minus_seen_x, c->segment_end_minus_seen_x);
    bounds[0] = span_0;
    const interval span_1 = interval_at(c->seen_x_minus_segment_begin, c->seen_x_minus_segment_begin);
    bounds[1] = span_1;
    const interval span_2 = interval_at(broadcast(-1.0), broadcast(-1.0));
    bounds[2] = span_2;
}

/* ---- slip_constant */

/* m_f vdot = p - s mu f_n, where p is the push of the leg and s the direction of slip. */
typedef struct {
    real x_[TERMS], y_[TERMS], vx[TERMS], vy[TERMS], foot_x[TERMS], foot_vx[TERMS], leg_work[TERMS],
        external_work[TERMS], damper_loss[TERMS], friction_loss[TERMS], work[TERMS], extension[TERMS],
        external_fx[TERMS], external_fy[TERMS], friction[TERMS], external_torque[TERMS], time[TERMS],
        seen_angle[TERMS], x__times_x_[TERMS], y__times_y_[TERMS], square[TERMS], length[TERMS],
        length_rate[TERMS], axial[TERMS], axial_times_x_[TERMS], turning[TERMS], turning_times_y_[TERMS],
        axial_times_y_[TERMS], turning_times_x_[TERMS], normal[TERMS], friction_force[TERMS],
        foot_vx_plus_vx[TERMS], sum_times_foot_vx_plus_vx[TERMS], sum_times_vy[TERMS],
        length_rate_times_length_rate[TERMS], friction_force_times_foot_vx[TERMS], x__times_vy[TERMS],
        y__times_vx[TERMS], angle_rate[TERMS], power_of_hip[TERMS];
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
    /* axial = (c->stiffness * (c->free_length + extension + c->thrusting_times_longer_or_by_0 - length) -
     * c->damping * length_rate) / length */
    s->axial[k] = quotient_of(k, part_of(sum->axial, odd), with_constant(k, c->stiffness * (s->extension[k]
        - s->length[k]) - c->damping * s->length_rate[k], c->stiffness * (c->free_length
        + c->thrusting_times_longer_or_by_0)), s->axial, s->length, by->inverse_length);
    /* axial_times_x_ = axial * x_ */
    s->axial_times_x_[k] = product_of(k, part_of(sum->axial_times_x_, odd), s->axial, s->x_);
    /* turning = (external_torque - c->product_2) / square */
    s->turning[k] = quotient_of(k, part_of(sum->turning, odd), with_constant(k, s->external_torque[k],
        -c->product_2), s->turning, s->square, by->inverse_square);
    /* turning_times_y_ = turning * y_ */
    s->turning_times_y_[k] = product_of(k, part_of(sum->turning_times_y_, odd), s->turning, s->y_);
    /* axial_times_y_ = axial * y_ */
    s->axial_times_y_[k] = product_of(k, part_of(sum->axial_times_y_, odd), s->axial, s->y_);
    /* turning_times_x_ = turning * x_ */
    s->turning_times_x_[k] = product_of(k, part_of(sum->turning_times_x_, odd), s->turning, s->x_);
    /* normal = axial_times_y_ + turning_times_x_ + c->foot_mass_times_gravity_times_cosine */
    s->normal[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k],
        c->foot_mass_times_gravity_times_cosine);
    /* friction_force = c->way * (c->is_own_times_own + c->by_1_minus_is_own * friction) * normal */
    s->friction_force[k] = drift_times(k, with_constant(0, c->way * (c->by_1_minus_is_own * s->friction[0]),
        c->way * c->is_own_times_own), with_constant(1, c->way * (c->by_1_minus_is_own * s->friction[1]),
        c->way * c->is_own_times_own), s->normal);
    /* foot_vx_plus_vx = foot_vx + vx */
    s->foot_vx_plus_vx[k] = s->foot_vx[k] + s->vx[k];
    /* sum_times_foot_vx_plus_vx = (c->cosine * external_fx + c->sine * external_fy) * foot_vx_plus_vx */
    s->sum_times_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
        + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
        s->foot_vx_plus_vx);
    /* sum_times_vy = (c->cosine * external_fy - c->sine * external_fx) * vy */
    s->sum_times_vy[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
        c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], s->vy);
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
    /* power_of_hip = (external_torque - c->product_2) * angle_rate */
    s->power_of_hip[k] = drift_times(k, with_constant(0, s->external_torque[0], -c->product_2),
        with_constant(1, s->external_torque[1], -c->product_2), s->angle_rate);
    s->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_x_[k]
        - s->turning_times_y_[k] + (c->cosine * s->external_fx[k] + c->sine * s->external_fy[k]))
        - c->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k]) - s->friction_force[k]),
        c->inverse_foot_mass * c->foot_mass_times_gravity_times_sine - c->gravity_times_sine));
    s->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_y_[k]
        + s->turning_times_x_[k] + (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k])),
        -c->gravity_times_cosine));
    s->foot_vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k]) - s->friction_force[k]),
        -(c->inverse_foot_mass * c->foot_mass_times_gravity_times_sine)));
    s->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->stiffness_times_extension_rate * (s->extension[k] - s->length[k]),
        c->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)));
    s->external_work[k + 1] = series_reciprocal[k + 1] * (s->sum_times_foot_vx_plus_vx[k]
        + s->sum_times_vy[k]);
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->friction_loss[k + 1] = series_reciprocal[k + 1] * (s->friction_force_times_foot_vx[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (s->power_of_hip[k]);
    s->seen_angle[k + 1] = series_reciprocal[k + 1] * (s->angle_rate[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_slip_constant(const real *constants, int order, real *series) {
    const slip_constant_constants copy = *(const slip_constant_constants *)(const void *)constants,
        *c = &copy;
    slip_constant_series *s = (void *)series;
    static const slip_constant_sums none;
    slip_constant_sums sum = none;
    s->extension[1] = c->extension_rate;
    s->external_fx[1] = c->external_fx_rate;
    s->external_fy[1] = c->external_fy_rate;
    s->friction[1] = c->friction_rate;
    s->external_torque[1] = c->external_torque_rate;
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
        sum_times_normal[TERMS], d_axial_times_y_[TERMS], axial_times_y__2[TERMS], d_turning_times_x_[TERMS],
        turning_times_x__2[TERMS], way_times_friction_along_times_d_normal[TERMS],
        sum_plus_sum_times_foot_vx_plus_vx[TERMS], sum_times_d_foot_vx_plus_vx[TERMS],
        sum_minus_sum_times_vy[TERMS], sum_times_vy_2[TERMS], length_rate_times_d_length_rate[TERMS],
        d_friction_force_times_foot_vx[TERMS], friction_force_times_foot_vx_2[TERMS],
        d_stance_torque_times_angle_rate[TERMS], x__times_vy_2[TERMS], x__times_vy_3[TERMS],
        y__times_vx_2[TERMS], y__times_vx_3[TERMS], angle_rate_times_d_square[TERMS], d_angle_rate[TERMS],
        stance_torque_times_d_angle_rate[TERMS], d_square[TERMS], sum_2[TERMS], d_normal[TERMS],
        sum_plus_sum[TERMS], d_foot_vx_plus_vx[TERMS], sum_minus_sum[TERMS], d_friction_force[TERMS],
        d_stance_torque[TERMS];
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
        d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * d_length_rate[k]) - axial_times_d_length[k], d->stiffness * (c->free_length
            + c->thrusting_times_longer_or_by_0) + c->stiffness * (d->free_length
            + d->thrusting_times_longer_or_by_0)) - product_so_far(d_axial, s->length, k)) / s->length[0];
        d_axial_times_x_[k] = product(d_axial, s->x_, k);
        axial_times_x__2[k] = product(s->axial, t->x_, k);
        d_stance_torque[k] = with_constant(k, t->external_torque[k], -d->product_2);
        turning_times_d_square[k] = product(s->turning, d_square, k);
        d_turning[k] = (d_stance_torque[k] - turning_times_d_square[k] - product_so_far(d_turning, s->square,
            k)) / s->square[0];
        d_turning_times_y_[k] = product(d_turning, s->y_, k);
        turning_times_y__2[k] = product(s->turning, t->y_, k);
        sum_plus_sum[k] = d->cosine * s->external_fx[k] + c->cosine * t->external_fx[k]
            + (d->sine * s->external_fy[k] + c->sine * t->external_fy[k]);
        sum_2[k] = with_constant(k, d->way * (c->by_1_minus_is_own * s->friction[k])
            + c->way * (d->by_1_minus_is_own * s->friction[k] + c->by_1_minus_is_own * t->friction[k]),
            d->way * c->is_own_times_own + c->way * d->is_own_times_own);
        sum_times_normal[k] = product(sum_2, s->normal, k);
        d_axial_times_y_[k] = product(d_axial, s->y_, k);
        axial_times_y__2[k] = product(s->axial, t->y_, k);
        d_turning_times_x_[k] = product(d_turning, s->x_, k);
        turning_times_x__2[k] = product(s->turning, t->x_, k);
        d_normal[k] = with_constant(k, d_axial_times_y_[k] + axial_times_y__2[k] + (d_turning_times_x_[k]
            + turning_times_x__2[k]), d->foot_mass_times_gravity_times_cosine);
        way_times_friction_along_times_d_normal[k] = drift_times(k, with_constant(0,
            c->way * (c->by_1_minus_is_own * s->friction[0]), c->way * c->is_own_times_own), with_constant(1,
            c->way * (c->by_1_minus_is_own * s->friction[1]), c->way * c->is_own_times_own), d_normal);
        d_friction_force[k] = sum_times_normal[k] + way_times_friction_along_times_d_normal[k];
        sum_minus_sum[k] = d->cosine * s->external_fy[k] + c->cosine * t->external_fy[k]
            - (d->sine * s->external_fx[k] + c->sine * t->external_fx[k]);
        sum_plus_sum_times_foot_vx_plus_vx[k] = product(sum_plus_sum, s->foot_vx_plus_vx, k);
        d_foot_vx_plus_vx[k] = t->foot_vx[k] + t->vx[k];
        sum_times_d_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
            + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
            d_foot_vx_plus_vx);
        sum_minus_sum_times_vy[k] = product(sum_minus_sum, s->vy, k);
        sum_times_vy_2[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
            c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], t->vy);
        length_rate_times_d_length_rate[k] = product(s->length_rate, d_length_rate, k);
        d_friction_force_times_foot_vx[k] = product(d_friction_force, s->foot_vx, k);
        friction_force_times_foot_vx_2[k] = product(s->friction_force, t->foot_vx, k);
        d_stance_torque_times_angle_rate[k] = product(d_stance_torque, s->angle_rate, k);
        x__times_vy_2[k] = product(t->x_, s->vy, k);
        x__times_vy_3[k] = product(s->x_, t->vy, k);
        y__times_vx_2[k] = product(t->y_, s->vx, k);
        y__times_vx_3[k] = product(s->y_, t->vx, k);
        angle_rate_times_d_square[k] = product(s->angle_rate, d_square, k);
        d_angle_rate[k] = (x__times_vy_2[k] + x__times_vy_3[k] - (y__times_vx_2[k] + y__times_vx_3[k])
            - angle_rate_times_d_square[k] - product_so_far(d_angle_rate, s->square, k)) / s->square[0];
        stance_torque_times_d_angle_rate[k] = drift_times(k, with_constant(0, s->external_torque[0],
            -c->product_2), with_constant(1, s->external_torque[1], -c->product_2), d_angle_rate);
        t->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_x_[k] - s->turning_times_y_[k]
            + (c->cosine * s->external_fx[k] + c->sine * s->external_fy[k]))
            + c->inverse_body_mass * (d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k]) + sum_plus_sum[k]) - (d->inverse_foot_mass * (-(s->axial_times_x_[k]
            - s->turning_times_y_[k]) - s->friction_force[k])
            + c->inverse_foot_mass * (-(d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k])) - d_friction_force[k])), -d->gravity_times_sine
            - (-(d->inverse_foot_mass * c->foot_mass_times_gravity_times_sine)
            - c->inverse_foot_mass * d->foot_mass_times_gravity_times_sine)));
        t->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_y_[k] + s->turning_times_x_[k]
            + (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k]))
            + c->inverse_body_mass * (d_axial_times_y_[k] + axial_times_y__2[k] + (d_turning_times_x_[k]
            + turning_times_x__2[k]) + sum_minus_sum[k]), -d->gravity_times_cosine));
        t->foot_vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k]) - s->friction_force[k])
            + c->inverse_foot_mass * (-(d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k])) - d_friction_force[k]),
            -(d->inverse_foot_mass * c->foot_mass_times_gravity_times_sine)
            - c->inverse_foot_mass * d->foot_mass_times_gravity_times_sine));
        t->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->stiffness_times_extension_rate * (s->extension[k] - s->length[k])
            + c->stiffness_times_extension_rate * (t->extension[k] - d_length[k]),
            d->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness_times_extension_rate * (d->free_length + d->thrusting_times_longer_or_by_0)));
        t->external_work[k + 1] = series_reciprocal[k + 1] * (sum_plus_sum_times_foot_vx_plus_vx[k]
            + sum_times_d_foot_vx_plus_vx[k] + (sum_minus_sum_times_vy[k] + sum_times_vy_2[k]));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_d_length_rate[k]));
        t->friction_loss[k + 1] = series_reciprocal[k + 1] * (d_friction_force_times_foot_vx[k]
            + friction_force_times_foot_vx_2[k]);
        t->work[k + 1] = series_reciprocal[k + 1] * (d_stance_torque_times_angle_rate[k]
            + stance_torque_times_d_angle_rate[k]);
        t->extension[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->extension_rate));
        t->external_fx[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fx_rate));
        t->external_fy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fy_rate));
        t->friction[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->friction_rate));
        t->external_torque[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_torque_rate));
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

/* First variation of vertical_force_on_foot. */
static void d_observed_slip_constant_vertical_force_on_foot(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    const slip_constant_constants *d = (const void *)d_constants;
    const slip_constant_series *t = (const void *)d_series;
    real own_x__times_x__2[TERMS], own_y__times_y__2[TERMS], own_d_length[TERMS], own_d_length_rate[TERMS],
        own_axial_times_d_length[TERMS], own_d_axial[TERMS], own_d_axial_times_y_[TERMS],
        own_axial_times_y__2[TERMS], own_turning_times_d_square[TERMS], own_d_turning[TERMS],
        own_d_turning_times_x_[TERMS], own_turning_times_x__2[TERMS], own_sum_times_normal[TERMS],
        own_way_times_friction_along_times_d_normal[TERMS], own_d_square[TERMS], own_sum_2[TERMS],
        own_d_normal[TERMS];
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
        own_d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - own_d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * own_d_length_rate[k]) - own_axial_times_d_length[k],
            d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, t->external_torque[k] - own_turning_times_d_square[k],
            -d->product_2) - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        own_d_normal[k] = with_constant(k, own_d_axial_times_y_[k] + own_axial_times_y__2[k]
            + (own_d_turning_times_x_[k] + own_turning_times_x__2[k]),
            d->foot_mass_times_gravity_times_cosine);
        own_sum_2[k] = with_constant(k, d->way * (c->by_1_minus_is_own * s->friction[k])
            + c->way * (d->by_1_minus_is_own * s->friction[k] + c->by_1_minus_is_own * t->friction[k]),
            d->way * c->is_own_times_own + c->way * d->is_own_times_own);
        own_sum_times_normal[k] = product(own_sum_2, s->normal, k);
        own_way_times_friction_along_times_d_normal[k] = drift_times(k, with_constant(0,
            c->way * (c->by_1_minus_is_own * s->friction[0]), c->way * c->is_own_times_own), with_constant(1,
            c->way * (c->by_1_minus_is_own * s->friction[1]), c->way * c->is_own_times_own), own_d_normal);
        dg[k] = d->cosine * s->normal[k] + c->cosine * own_d_normal[k] - (d->sine * s->friction_force[k]
            + c->sine * (own_sum_times_normal[k] + own_way_times_friction_along_times_d_normal[k]));
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
        own_d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - own_d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * own_d_length_rate[k]) - own_axial_times_d_length[k],
            d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, t->external_torque[k] - own_turning_times_d_square[k],
            -d->product_2) - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        dg[k] = with_constant(k, own_d_axial_times_y_[k] + own_axial_times_y__2[k]
            + (own_d_turning_times_x_[k] + own_turning_times_x__2[k]),
            d->foot_mass_times_gravity_times_cosine);
    }
}

/* First variation of slip_velocity. */
static void d_observed_slip_constant_slip_velocity(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    const slip_constant_constants *d = (const void *)d_constants;
    const slip_constant_series *t = (const void *)d_series;
    for (int k = 0; k < order; ++k) {
        dg[k] = d->way * s->foot_vx[k] + c->way * t->foot_vx[k];
    }
}

/* First variation of square_of_torque. */
static void d_observed_slip_constant_square_of_torque(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    const slip_constant_constants *d = (const void *)d_constants;
    const slip_constant_series *t = (const void *)d_series;
    real own_stance_torque_times_d_stance_torque[TERMS], own_d_stance_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_d_stance_torque[k] = with_constant(k, t->external_torque[k], -d->product_2);
        own_stance_torque_times_d_stance_torque[k] = drift_times(k, with_constant(0, s->external_torque[0],
            -c->product_2), with_constant(1, s->external_torque[1], -c->product_2), own_d_stance_torque);
        dg[k] = 2.0 * own_stance_torque_times_d_stance_torque[k];
    }
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static void guard_slip_constant_ramp_ends(const real *constants, const real *series, int order, real *g) {
    const slip_constant_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->friction[k];
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

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. A thrust of 0 is not
 * counted. */
static void guard_slip_constant_greatest_compression(const real *constants, const real *series, int order,
    real *g) {
    const slip_constant_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = -s->length_rate[k];
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

/* lift_off: The normal force ends: flight if the flight law lifts the foot, too, else graze. A foot that is
 * hardly lifted grazes, too: the guard of its flight decides by its rate. Not so below an upright leg, whose
 * torque does not act along the normal. */
static void guard_slip_constant_lift_off(const real *constants, const real *series, int order, real *g) {
    const slip_constant_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->normal[k];
    }
}

/* enters_layer: Slip is slow enough for friction to depend on the speed. */
static void guard_slip_constant_enters_layer(const real *constants, const real *series, int order, real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, c->inverse_stribeck_velocity_or_by_1 * (c->way * s->foot_vx[k]),
            broadcast(-60.0));
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

/* crosses_border: The foot slips onto the next segment, whose line waits until the foot lifts off. */
static void guard_slip_constant_crosses_border(const real *constants, const real *series, int order,
    real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(c->way * (c->cosine * s->foot_x[k])),
            c->way * c->segment_end_or_segment_begin);
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

/* vertical_force_on_foot: Vertical force of the ground on a sticking or slipping foot. */
static void guard_slip_constant_vertical_force_on_foot(const real *constants, const real *series, int order,
    real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->cosine * s->normal[k] - c->sine * s->friction_force[k];
    }
}

/* force_on_foot: Normal force of a sticking or slipping foot. */
static void guard_slip_constant_force_on_foot(const real *constants, const real *series, int order, real *g) {
    const slip_constant_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->normal[k];
    }
}

/* slip_velocity: Speed at which the foot slips. */
static void guard_slip_constant_slip_velocity(const real *constants, const real *series, int order, real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->way * s->foot_vx[k];
    }
}

/* square_of_torque: Square of the total hip torque. */
static void guard_slip_constant_square_of_torque(const real *constants, const real *series, int order,
    real *g) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    real own_stance_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_stance_torque[k] = with_constant(k, s->external_torque[k], -c->product_2);
        g[k] = drift_times(k, own_stance_torque[0], own_stance_torque[1], own_stance_torque);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_slip_constant(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const slip_constant_constants *c = (const void *)constants;
    const slip_constant_series *s = (const void *)series;
    const interval span_0 = interval_of_series(s->y_, power, order);
    bounds[1] = span_0;
    const interval span_1 = interval_of_series(s->length, power, order);
    const interval span_2 = interval_at(c->least_length, c->least_length);
    const interval span_3 = interval_difference(span_1, span_2);
    bounds[2] = span_3;
    const interval span_4 = interval_of_series(s->normal, power, order);
    bounds[5] = span_4;
    const interval span_5 = interval_at(c->way, c->way);
    const interval span_6 = interval_of_series(s->foot_vx, power, order);
    const interval span_7 = interval_product(span_5, span_6);
    bounds[7] = span_7;
    if (watched >> 0 & 1) {
        const interval span_8 = interval_of_series(s->friction, power, 2);
        bounds[0] = span_8;
    }
    if (watched >> 3 & 1) {
        const interval span_8 = interval_of_series(s->length_rate, power, order);
        const interval span_9 = interval_at(-span_8.high, -span_8.low);
        bounds[3] = span_9;
    }
    if (watched >> 4 & 1) {
        const interval span_8 = interval_of_series(s->seen_angle, power, order);
        const interval span_9 = interval_at(c->winding, c->winding);
        const interval span_10 = interval_sum(span_8, span_9);
        bounds[4] = span_10;
    }
    if (watched >> 6 & 1) {
        const interval span_8 = interval_at(c->inverse_stribeck_velocity_or_by_1,
            c->inverse_stribeck_velocity_or_by_1);
        const interval span_9 = interval_product(span_8, span_7);
        const interval span_10 = interval_at(broadcast(60.0), broadcast(60.0));
        const interval span_11 = interval_difference(span_9, span_10);
        bounds[6] = span_11;
    }
    if (watched >> 8 & 1) {
        const interval span_8 = interval_at(c->segment_end_or_segment_begin, c->segment_end_or_segment_begin);
        const interval span_9 = interval_at(c->cosine, c->cosine);
        const interval span_10 = interval_of_series(s->foot_x, power, order);
        const interval span_11 = interval_product(span_9, span_10);
        const interval span_12 = interval_difference(span_8, span_11);
        const interval span_13 = interval_product(span_5, span_12);
        bounds[8] = span_13;
    }
    if (watched >> 10 & 1) {
        const interval span_8 = interval_at(c->cosine, c->cosine);
        const interval span_9 = interval_product(span_8, span_4);
        const interval span_10 = interval_at(c->sine, c->sine);
        const interval span_11 = interval_of_series(s->friction_force, power, order);
        const interval span_12 = interval_product(span_10, span_11);
        const interval span_13 = interval_difference(span_9, span_12);
        bounds[10] = span_13;
    }
    if (watched >> 11 & 1) {
        bounds[11] = span_4;
    }
    if (watched >> 12 & 1) {
        bounds[12] = span_7;
    }
    if (watched >> 13 & 1) {
        const interval span_8 = interval_of_series(s->external_torque, power, 2);
        const interval span_9 = interval_at(c->product_2, c->product_2);
        const interval span_10 = interval_difference(span_8, span_9);
        const interval span_11 = interval_square(span_10);
        bounds[13] = span_11;
    }
}

/* ---- stick */

/* The foot is at rest. */
typedef struct {
    real x_[TERMS], y_[TERMS], vx[TERMS], vy[TERMS], leg_work[TERMS], external_work[TERMS],
        damper_loss[TERMS], work[TERMS], extension[TERMS], external_fx[TERMS], external_fy[TERMS],
        friction[TERMS], external_torque[TERMS], time[TERMS], foot_x[TERMS], seen_angle[TERMS],
        x__times_x_[TERMS], y__times_y_[TERMS], square[TERMS], length[TERMS], length_rate[TERMS],
        axial[TERMS], axial_times_x_[TERMS], turning[TERMS], turning_times_y_[TERMS], axial_times_y_[TERMS],
        turning_times_x_[TERMS], foot_vx_plus_vx[TERMS], sum_times_foot_vx_plus_vx[TERMS],
        sum_times_vy[TERMS], length_rate_times_length_rate[TERMS], x__times_vy[TERMS], y__times_vx[TERMS],
        angle_rate[TERMS], power_of_hip[TERMS];
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
    /* axial = (c->stiffness * (c->free_length + extension + c->thrusting_times_longer_or_by_0 - length) -
     * c->damping * length_rate) / length */
    s->axial[k] = quotient_of(k, part_of(sum->axial, odd), with_constant(k, c->stiffness * (s->extension[k]
        - s->length[k]) - c->damping * s->length_rate[k], c->stiffness * (c->free_length
        + c->thrusting_times_longer_or_by_0)), s->axial, s->length, by->inverse_length);
    /* axial_times_x_ = axial * x_ */
    s->axial_times_x_[k] = product_of(k, part_of(sum->axial_times_x_, odd), s->axial, s->x_);
    /* turning = (external_torque - c->product_2) / square */
    s->turning[k] = quotient_of(k, part_of(sum->turning, odd), with_constant(k, s->external_torque[k],
        -c->product_2), s->turning, s->square, by->inverse_square);
    /* turning_times_y_ = turning * y_ */
    s->turning_times_y_[k] = product_of(k, part_of(sum->turning_times_y_, odd), s->turning, s->y_);
    /* axial_times_y_ = axial * y_ */
    s->axial_times_y_[k] = product_of(k, part_of(sum->axial_times_y_, odd), s->axial, s->y_);
    /* turning_times_x_ = turning * x_ */
    s->turning_times_x_[k] = product_of(k, part_of(sum->turning_times_x_, odd), s->turning, s->x_);
    /* foot_vx_plus_vx = c->foot_vx + vx */
    s->foot_vx_plus_vx[k] = with_constant(k, s->vx[k], c->foot_vx);
    /* sum_times_foot_vx_plus_vx = (c->cosine * external_fx + c->sine * external_fy) * foot_vx_plus_vx */
    s->sum_times_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
        + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
        s->foot_vx_plus_vx);
    /* sum_times_vy = (c->cosine * external_fy - c->sine * external_fx) * vy */
    s->sum_times_vy[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
        c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], s->vy);
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
    /* power_of_hip = (external_torque - c->product_2) * angle_rate */
    s->power_of_hip[k] = drift_times(k, with_constant(0, s->external_torque[0], -c->product_2),
        with_constant(1, s->external_torque[1], -c->product_2), s->angle_rate);
    s->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_x_[k]
        - s->turning_times_y_[k] + (c->cosine * s->external_fx[k] + c->sine * s->external_fy[k])),
        -c->gravity_times_sine));
    s->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_y_[k]
        + s->turning_times_x_[k] + (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k])),
        -c->gravity_times_cosine));
    s->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->stiffness_times_extension_rate * (s->extension[k] - s->length[k]),
        c->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)));
    s->external_work[k + 1] = series_reciprocal[k + 1] * (s->sum_times_foot_vx_plus_vx[k]
        + s->sum_times_vy[k]);
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (s->power_of_hip[k]);
    s->seen_angle[k + 1] = series_reciprocal[k + 1] * (s->angle_rate[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_stick(const real *constants, int order, real *series) {
    const stick_constants copy = *(const stick_constants *)(const void *)constants, *c = &copy;
    stick_series *s = (void *)series;
    static const stick_sums none;
    stick_sums sum = none;
    s->extension[1] = c->extension_rate;
    s->external_fx[1] = c->external_fx_rate;
    s->external_fy[1] = c->external_fy_rate;
    s->friction[1] = c->friction_rate;
    s->external_torque[1] = c->external_torque_rate;
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
        turning_times_x__2[TERMS], sum_plus_sum_times_foot_vx_plus_vx[TERMS],
        sum_times_d_foot_vx_plus_vx[TERMS], sum_minus_sum_times_vy[TERMS], sum_times_vy_2[TERMS],
        length_rate_times_d_length_rate[TERMS], d_stance_torque_times_angle_rate[TERMS], x__times_vy_2[TERMS],
        x__times_vy_3[TERMS], y__times_vx_2[TERMS], y__times_vx_3[TERMS], angle_rate_times_d_square[TERMS],
        d_angle_rate[TERMS], stance_torque_times_d_angle_rate[TERMS], d_square[TERMS], sum_plus_sum[TERMS],
        d_foot_vx_plus_vx[TERMS], sum_minus_sum[TERMS], d_stance_torque[TERMS];
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
        d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * d_length_rate[k]) - axial_times_d_length[k], d->stiffness * (c->free_length
            + c->thrusting_times_longer_or_by_0) + c->stiffness * (d->free_length
            + d->thrusting_times_longer_or_by_0)) - product_so_far(d_axial, s->length, k)) / s->length[0];
        d_axial_times_x_[k] = product(d_axial, s->x_, k);
        axial_times_x__2[k] = product(s->axial, t->x_, k);
        d_stance_torque[k] = with_constant(k, t->external_torque[k], -d->product_2);
        turning_times_d_square[k] = product(s->turning, d_square, k);
        d_turning[k] = (d_stance_torque[k] - turning_times_d_square[k] - product_so_far(d_turning, s->square,
            k)) / s->square[0];
        d_turning_times_y_[k] = product(d_turning, s->y_, k);
        turning_times_y__2[k] = product(s->turning, t->y_, k);
        sum_plus_sum[k] = d->cosine * s->external_fx[k] + c->cosine * t->external_fx[k]
            + (d->sine * s->external_fy[k] + c->sine * t->external_fy[k]);
        d_axial_times_y_[k] = product(d_axial, s->y_, k);
        axial_times_y__2[k] = product(s->axial, t->y_, k);
        d_turning_times_x_[k] = product(d_turning, s->x_, k);
        turning_times_x__2[k] = product(s->turning, t->x_, k);
        sum_minus_sum[k] = d->cosine * s->external_fy[k] + c->cosine * t->external_fy[k]
            - (d->sine * s->external_fx[k] + c->sine * t->external_fx[k]);
        sum_plus_sum_times_foot_vx_plus_vx[k] = product(sum_plus_sum, s->foot_vx_plus_vx, k);
        d_foot_vx_plus_vx[k] = with_constant(k, t->vx[k], d->foot_vx);
        sum_times_d_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
            + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
            d_foot_vx_plus_vx);
        sum_minus_sum_times_vy[k] = product(sum_minus_sum, s->vy, k);
        sum_times_vy_2[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
            c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], t->vy);
        length_rate_times_d_length_rate[k] = product(s->length_rate, d_length_rate, k);
        d_stance_torque_times_angle_rate[k] = product(d_stance_torque, s->angle_rate, k);
        x__times_vy_2[k] = product(t->x_, s->vy, k);
        x__times_vy_3[k] = product(s->x_, t->vy, k);
        y__times_vx_2[k] = product(t->y_, s->vx, k);
        y__times_vx_3[k] = product(s->y_, t->vx, k);
        angle_rate_times_d_square[k] = product(s->angle_rate, d_square, k);
        d_angle_rate[k] = (x__times_vy_2[k] + x__times_vy_3[k] - (y__times_vx_2[k] + y__times_vx_3[k])
            - angle_rate_times_d_square[k] - product_so_far(d_angle_rate, s->square, k)) / s->square[0];
        stance_torque_times_d_angle_rate[k] = drift_times(k, with_constant(0, s->external_torque[0],
            -c->product_2), with_constant(1, s->external_torque[1], -c->product_2), d_angle_rate);
        t->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_x_[k] - s->turning_times_y_[k]
            + (c->cosine * s->external_fx[k] + c->sine * s->external_fy[k]))
            + c->inverse_body_mass * (d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k]) + sum_plus_sum[k]), -d->gravity_times_sine));
        t->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_y_[k] + s->turning_times_x_[k]
            + (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k]))
            + c->inverse_body_mass * (d_axial_times_y_[k] + axial_times_y__2[k] + (d_turning_times_x_[k]
            + turning_times_x__2[k]) + sum_minus_sum[k]), -d->gravity_times_cosine));
        t->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->stiffness_times_extension_rate * (s->extension[k] - s->length[k])
            + c->stiffness_times_extension_rate * (t->extension[k] - d_length[k]),
            d->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness_times_extension_rate * (d->free_length + d->thrusting_times_longer_or_by_0)));
        t->external_work[k + 1] = series_reciprocal[k + 1] * (sum_plus_sum_times_foot_vx_plus_vx[k]
            + sum_times_d_foot_vx_plus_vx[k] + (sum_minus_sum_times_vy[k] + sum_times_vy_2[k]));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_d_length_rate[k]));
        t->work[k + 1] = series_reciprocal[k + 1] * (d_stance_torque_times_angle_rate[k]
            + stance_torque_times_d_angle_rate[k]);
        t->extension[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->extension_rate));
        t->external_fx[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fx_rate));
        t->external_fy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fy_rate));
        t->friction[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->friction_rate));
        t->external_torque[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_torque_rate));
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

/* First variation of vertical_force_on_foot. */
static void d_observed_stick_vertical_force_on_foot(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    const stick_constants *d = (const void *)d_constants;
    const stick_series *t = (const void *)d_series;
    real own_x__times_x__2[TERMS], own_y__times_y__2[TERMS], own_d_length[TERMS], own_d_length_rate[TERMS],
        own_axial_times_d_length[TERMS], own_d_axial[TERMS], own_d_axial_times_x_[TERMS],
        own_axial_times_x__2[TERMS], own_turning_times_d_square[TERMS], own_d_turning[TERMS],
        own_d_turning_times_y_[TERMS], own_turning_times_y__2[TERMS], own_d_axial_times_y_[TERMS],
        own_axial_times_y__2[TERMS], own_d_turning_times_x_[TERMS], own_turning_times_x__2[TERMS],
        own_d_square[TERMS];
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
        own_d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - own_d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * own_d_length_rate[k]) - own_axial_times_d_length[k],
            d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_x_[k] = product(own_d_axial, s->x_, k);
        own_axial_times_x__2[k] = product(s->axial, t->x_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, t->external_torque[k] - own_turning_times_d_square[k],
            -d->product_2) - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_y_[k] = product(own_d_turning, s->y_, k);
        own_turning_times_y__2[k] = product(s->turning, t->y_, k);
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        dg[k] = with_constant(k, d->sine * (s->axial_times_x_[k] - s->turning_times_y_[k])
            + c->sine * (own_d_axial_times_x_[k] + own_axial_times_x__2[k] - (own_d_turning_times_y_[k]
            + own_turning_times_y__2[k])) + (d->cosine * (s->axial_times_y_[k] + s->turning_times_x_[k])
            + c->cosine * (own_d_axial_times_y_[k] + own_axial_times_y__2[k] + (own_d_turning_times_x_[k]
            + own_turning_times_x__2[k]))), d->sine * c->foot_mass_times_gravity_times_sine
            + c->sine * d->foot_mass_times_gravity_times_sine
            + (d->cosine * c->foot_mass_times_gravity_times_cosine
            + c->cosine * d->foot_mass_times_gravity_times_cosine));
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
        own_d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - own_d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * own_d_length_rate[k]) - own_axial_times_d_length[k],
            d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, t->external_torque[k] - own_turning_times_d_square[k],
            -d->product_2) - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        dg[k] = with_constant(k, own_d_axial_times_y_[k] + own_axial_times_y__2[k]
            + (own_d_turning_times_x_[k] + own_turning_times_x__2[k]),
            d->foot_mass_times_gravity_times_cosine);
    }
}

/* First variation of square_of_torque. */
static void d_observed_stick_square_of_torque(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    const stick_constants *d = (const void *)d_constants;
    const stick_series *t = (const void *)d_series;
    real own_stance_torque_times_d_stance_torque[TERMS], own_d_stance_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_d_stance_torque[k] = with_constant(k, t->external_torque[k], -d->product_2);
        own_stance_torque_times_d_stance_torque[k] = drift_times(k, with_constant(0, s->external_torque[0],
            -c->product_2), with_constant(1, s->external_torque[1], -c->product_2), own_d_stance_torque);
        dg[k] = 2.0 * own_stance_torque_times_d_stance_torque[k];
    }
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static void guard_stick_ramp_ends(const real *constants, const real *series, int order, real *g) {
    const stick_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->friction[k];
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

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. A thrust of 0 is not
 * counted. */
static void guard_stick_greatest_compression(const real *constants, const real *series, int order, real *g) {
    const stick_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = -s->length_rate[k];
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

/* lift_off: The normal force ends: flight if the flight law lifts the foot, too, else graze. A foot that is
 * hardly lifted grazes, too: the guard of its flight decides by its rate. Not so below an upright leg, whose
 * torque does not act along the normal. */
static void guard_stick_lift_off(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k],
            c->foot_mass_times_gravity_times_cosine);
    }
}

/* slips_forward: The push of the leg exceeds static friction, and the foot slips forward. */
static void guard_stick_slips_forward(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    real own_cone[TERMS], own_normal[TERMS];
    for (int k = 0; k < order; ++k) {
        own_normal[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k],
            c->foot_mass_times_gravity_times_cosine);
        own_cone[k] = drift_times(k, with_constant(0,
            c->static_ratio * (c->by_1_minus_is_own * s->friction[0]),
            c->static_ratio * c->is_own_times_friction_ahead), with_constant(1,
            c->static_ratio * (c->by_1_minus_is_own * s->friction[1]),
            c->static_ratio * c->is_own_times_friction_ahead), own_normal);
        g[k] = with_constant(k, own_cone[k] + (s->axial_times_x_[k] - s->turning_times_y_[k]),
            c->foot_mass_times_gravity_times_sine);
    }
}

/* slips_backward: The push of the leg exceeds static friction, and the foot slips backward. */
static void guard_stick_slips_backward(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    real own_static_ratio_times_sum_times_normal[TERMS], own_normal[TERMS];
    for (int k = 0; k < order; ++k) {
        own_normal[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k],
            c->foot_mass_times_gravity_times_cosine);
        own_static_ratio_times_sum_times_normal[k] = drift_times(k, with_constant(0,
            c->static_ratio * (c->by_1_minus_by_0_or_by_1 * s->friction[0]),
            c->static_ratio * c->by_0_or_by_1_times_friction_behind), with_constant(1,
            c->static_ratio * (c->by_1_minus_by_0_or_by_1 * s->friction[1]),
            c->static_ratio * c->by_0_or_by_1_times_friction_behind), own_normal);
        g[k] = with_constant(k, own_static_ratio_times_sum_times_normal[k] - (s->axial_times_x_[k]
            - s->turning_times_y_[k]), -c->foot_mass_times_gravity_times_sine);
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

/* vertical_force_on_foot: Vertical force of the ground on a sticking or slipping foot. */
static void guard_stick_vertical_force_on_foot(const real *constants, const real *series, int order,
    real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, c->sine * (s->axial_times_x_[k] - s->turning_times_y_[k])
            + c->cosine * (s->axial_times_y_[k] + s->turning_times_x_[k]),
            c->sine * c->foot_mass_times_gravity_times_sine
            + c->cosine * c->foot_mass_times_gravity_times_cosine);
    }
}

/* force_on_foot: Normal force of a sticking or slipping foot. */
static void guard_stick_force_on_foot(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k],
            c->foot_mass_times_gravity_times_cosine);
    }
}

/* square_of_torque: Square of the total hip torque. */
static void guard_stick_square_of_torque(const real *constants, const real *series, int order, real *g) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    real own_stance_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_stance_torque[k] = with_constant(k, s->external_torque[k], -c->product_2);
        g[k] = drift_times(k, own_stance_torque[0], own_stance_torque[1], own_stance_torque);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_stick(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const stick_constants *c = (const void *)constants;
    const stick_series *s = (const void *)series;
    const interval span_0 = interval_of_series(s->y_, power, order);
    bounds[1] = span_0;
    const interval span_1 = interval_of_series(s->length, power, order);
    const interval span_2 = interval_at(c->least_length, c->least_length);
    const interval span_3 = interval_difference(span_1, span_2);
    bounds[2] = span_3;
    const interval span_4 = interval_of_series(s->axial_times_y_, power, order);
    const interval span_5 = interval_of_series(s->turning_times_x_, power, order);
    const interval span_6 = interval_sum(span_4, span_5);
    const interval span_7 = interval_at(c->foot_mass_times_gravity_times_cosine,
        c->foot_mass_times_gravity_times_cosine);
    const interval span_8 = interval_sum(span_6, span_7);
    bounds[5] = span_8;
    const interval span_9 = interval_at(c->static_ratio, c->static_ratio);
    const interval span_10 = interval_at(c->is_own_times_friction_ahead, c->is_own_times_friction_ahead);
    const interval span_11 = interval_at(c->by_1_minus_is_own, c->by_1_minus_is_own);
    const interval span_12 = interval_of_series(s->friction, power, 2);
    const interval span_13 = interval_product(span_11, span_12);
    const interval span_14 = interval_sum(span_10, span_13);
    const interval span_15 = interval_product(span_9, span_14);
    const interval span_16 = interval_product(span_15, span_8);
    const interval span_17 = interval_of_series(s->axial_times_x_, power, order);
    const interval span_18 = interval_of_series(s->turning_times_y_, power, order);
    const interval span_19 = interval_difference(span_17, span_18);
    const interval span_20 = interval_at(c->foot_mass_times_gravity_times_sine,
        c->foot_mass_times_gravity_times_sine);
    const interval span_21 = interval_sum(span_19, span_20);
    const interval span_22 = interval_sum(span_16, span_21);
    bounds[6] = span_22;
    const interval span_23 = interval_at(c->by_0_or_by_1_times_friction_behind,
        c->by_0_or_by_1_times_friction_behind);
    const interval span_24 = interval_at(c->by_1_minus_by_0_or_by_1, c->by_1_minus_by_0_or_by_1);
    const interval span_25 = interval_product(span_24, span_12);
    const interval span_26 = interval_sum(span_23, span_25);
    const interval span_27 = interval_product(span_9, span_26);
    const interval span_28 = interval_product(span_27, span_8);
    const interval span_29 = interval_difference(span_28, span_21);
    bounds[7] = span_29;
    if (watched >> 0 & 1) {
        bounds[0] = span_12;
    }
    if (watched >> 3 & 1) {
        const interval span_30 = interval_of_series(s->length_rate, power, order);
        const interval span_31 = interval_at(-span_30.high, -span_30.low);
        bounds[3] = span_31;
    }
    if (watched >> 4 & 1) {
        const interval span_30 = interval_of_series(s->seen_angle, power, order);
        const interval span_31 = interval_at(c->winding, c->winding);
        const interval span_32 = interval_sum(span_30, span_31);
        bounds[4] = span_32;
    }
    if (watched >> 9 & 1) {
        const interval span_30 = interval_at(c->sine, c->sine);
        const interval span_31 = interval_product(span_30, span_21);
        const interval span_32 = interval_at(c->cosine, c->cosine);
        const interval span_33 = interval_product(span_32, span_8);
        const interval span_34 = interval_sum(span_31, span_33);
        bounds[9] = span_34;
    }
    if (watched >> 10 & 1) {
        bounds[10] = span_8;
    }
    if (watched >> 11 & 1) {
        const interval span_30 = interval_of_series(s->external_torque, power, 2);
        const interval span_31 = interval_at(c->product_2, c->product_2);
        const interval span_32 = interval_difference(span_30, span_31);
        const interval span_33 = interval_square(span_32);
        bounds[11] = span_33;
    }
}

/* ---- flight_calm */

/* The centre of mass is ballistic; the leg obeys rddot = r w^2 + M F_s and d(r^2 w)/dt = M tau. */
typedef struct {
    real length[TERMS], angle[TERMS], length_rate[TERMS], com_y[TERMS], momentum[TERMS], leg_work[TERMS],
        damper_loss[TERMS], work[TERMS], extension[TERMS], external_fx[TERMS], external_fy[TERMS],
        friction[TERMS], external_torque[TERMS], time[TERMS], com_x[TERMS], com_vy[TERMS], placing[TERMS],
        square[TERMS], rate[TERMS], rate_times_rate[TERMS], length_times_rate_times_rate[TERMS],
        swing_torque[TERMS], length_rate_times_length_rate[TERMS], power_of_hip[TERMS];
} flight_calm_series;

typedef struct {
    pair square, rate, rate_times_rate, length_times_rate_times_rate, length_rate_times_length_rate,
        power_of_hip;
} flight_calm_sums;

typedef struct {
    real inverse_square;
} flight_calm_factors;

/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_flight_calm_sums(const flight_calm_series *s, int i, int j, flight_calm_sums *sum) {
    add_products(&sum->square, s->length + i - 1, s->length[j]);
    add_both_products(&sum->rate, s->rate, s->square, i, j);
    add_products(&sum->rate_times_rate, s->rate + i - 1, s->rate[j]);
    add_both_products(&sum->length_times_rate_times_rate, s->length, s->rate_times_rate, i, j);
    add_products(&sum->length_rate_times_length_rate, s->length_rate + i - 1, s->length_rate[j]);
    add_both_products(&sum->power_of_hip, s->swing_torque, s->rate, i, j);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_flight_calm_sums(const flight_calm_series *s, int i, flight_calm_sums *sum) {
    sum->square = middle_of_square(s->length, i);
    sum->rate = middle_of_product(s->rate, s->square, i);
    sum->rate_times_rate = middle_of_square(s->rate, i);
    sum->length_times_rate_times_rate = middle_of_product(s->length, s->rate_times_rate, i);
    sum->length_rate_times_length_rate = middle_of_square(s->length_rate, i);
    sum->power_of_hip = middle_of_product(s->swing_torque, s->rate, i);
}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_flight_calm(const flight_calm_constants *c, const flight_calm_factors *by, int k,
    const flight_calm_sums *sum, int odd, flight_calm_series *s) {
    s->length[k + 1] = s->length_rate[k] * series_reciprocal[k + 1];
    s->com_y[k + 1] = s->com_vy[k] * series_reciprocal[k + 1];
    /* square = length * length */
    s->square[k] = square_of(k, part_of(sum->square, odd), s->length);
    /* rate = momentum / square */
    s->rate[k] = quotient_of(k, part_of(sum->rate, odd), s->momentum[k], s->rate, s->square,
        by->inverse_square);
    /* rate_times_rate = rate * rate */
    s->rate_times_rate[k] = square_of(k, part_of(sum->rate_times_rate, odd), s->rate);
    /* length_times_rate_times_rate = length * rate_times_rate */
    s->length_times_rate_times_rate[k] = product_of(k, part_of(sum->length_times_rate_times_rate, odd),
        s->length, s->rate_times_rate);
    /* swing_torque = external_torque + (-(c->share_times_kp * (angle - (c->first - c->turn * placing))) -
     * c->share_times_kd * (rate + c->turn)) */
    s->swing_torque[k] = with_constant(k, s->external_torque[k] + (-(c->share_times_kp * (s->angle[k]
        + c->turn * s->placing[k])) - c->share_times_kd * s->rate[k]), c->share_times_kp * c->first
        - c->share_times_kd * c->turn);
    /* length_rate_times_length_rate = length_rate * length_rate */
    s->length_rate_times_length_rate[k] = square_of(k, part_of(sum->length_rate_times_length_rate, odd),
        s->length_rate);
    /* power_of_hip = swing_torque * rate */
    s->power_of_hip[k] = product_of(k, part_of(sum->power_of_hip, odd), s->swing_torque, s->rate);
    s->angle[k + 1] = series_reciprocal[k + 1] * (s->rate[k]);
    s->length_rate[k + 1] = series_reciprocal[k + 1] * (with_constant(k, s->length_times_rate_times_rate[k]
        + c->mobility * (c->stiffness * (s->extension[k] - s->length[k]) - c->damping * s->length_rate[k]),
        c->mobility * (c->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0))));
    s->momentum[k + 1] = series_reciprocal[k + 1] * (c->mobility * s->swing_torque[k]);
    s->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->stiffness_times_extension_rate * (s->extension[k] - s->length[k]),
        c->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)));
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (s->power_of_hip[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_flight_calm(const real *constants, int order, real *series) {
    const flight_calm_constants copy = *(const flight_calm_constants *)(const void *)constants, *c = &copy;
    flight_calm_series *s = (void *)series;
    static const flight_calm_sums none;
    flight_calm_sums sum = none;
    s->extension[1] = c->extension_rate;
    s->external_fx[1] = c->external_fx_rate;
    s->external_fy[1] = c->external_fy_rate;
    s->friction[1] = c->friction_rate;
    s->external_torque[1] = c->external_torque_rate;
    s->time[1] = broadcast(1.0);
    s->com_x[1] = c->com_vx;
    s->com_vy[1] = c->minus_gravity;
    s->placing[1] = c->is_placing;
    s->square[0] = s->length[0] * s->length[0];
    const flight_calm_factors factors = {1.0 / s->square[0]}, *by = &factors;
    step_flight_calm(c, by, 0, &sum, 0, s);
    begin_flight_calm_sums(s, 0, &sum);
    step_flight_calm(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {
        begin_flight_calm_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_flight_calm_sums(s, i, j, &sum);
        }
        step_flight_calm(c, by, k, &sum, 0, s);
        add_flight_calm_sums(s, 1, k, &sum);
        step_flight_calm(c, by, k + 1, &sum, 1, s);
    }
}

/* First variation of the series. */
static void vary_flight_calm(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    const flight_calm_constants *d = (const void *)d_constants;
    flight_calm_series *t = (void *)varied;
    real length_times_length[TERMS], rate_times_d_square[TERMS], d_rate[TERMS],
        length_times_rate_times_rate_2[TERMS], rate_times_d_rate[TERMS],
        length_times_d_rate_times_rate[TERMS], length_rate_times_length_rate_2[TERMS],
        d_swing_torque_times_rate[TERMS], swing_torque_times_d_rate[TERMS], d_square[TERMS],
        d_rate_times_rate[TERMS], d_swing_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        t->length[k + 1] = t->length_rate[k] * series_reciprocal[k + 1];
        t->com_y[k + 1] = t->com_vy[k] * series_reciprocal[k + 1];
        length_times_length[k] = product(s->length, t->length, k);
        d_square[k] = 2.0 * length_times_length[k];
        rate_times_d_square[k] = product(s->rate, d_square, k);
        d_rate[k] = (t->momentum[k] - rate_times_d_square[k] - product_so_far(d_rate, s->square,
            k)) / s->square[0];
        length_times_rate_times_rate_2[k] = product(t->length, s->rate_times_rate, k);
        rate_times_d_rate[k] = product(s->rate, d_rate, k);
        d_rate_times_rate[k] = 2.0 * rate_times_d_rate[k];
        length_times_d_rate_times_rate[k] = product(s->length, d_rate_times_rate, k);
        d_swing_torque[k] = with_constant(k, t->external_torque[k] + (-(d->share_times_kp * (s->angle[k]
            + c->turn * s->placing[k]) + c->share_times_kp * (t->angle[k] + (d->turn * s->placing[k]
            + c->turn * t->placing[k]))) - (d->share_times_kd * s->rate[k] + c->share_times_kd * d_rate[k])),
            -(-(d->share_times_kp * c->first) - c->share_times_kp * d->first) - (d->share_times_kd * c->turn
            + c->share_times_kd * d->turn));
        length_rate_times_length_rate_2[k] = product(s->length_rate, t->length_rate, k);
        d_swing_torque_times_rate[k] = product(d_swing_torque, s->rate, k);
        swing_torque_times_d_rate[k] = product(s->swing_torque, d_rate, k);
        t->angle[k + 1] = series_reciprocal[k + 1] * (d_rate[k]);
        t->length_rate[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            length_times_rate_times_rate_2[k] + length_times_d_rate_times_rate[k]
            + (d->mobility * (c->stiffness * (s->extension[k] - s->length[k])
            - c->damping * s->length_rate[k]) + c->mobility * (d->stiffness * (s->extension[k]
            - s->length[k]) + c->stiffness * (t->extension[k] - t->length[k])
            - (d->damping * s->length_rate[k] + c->damping * t->length_rate[k]))),
            d->mobility * (c->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0))
            + c->mobility * (d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))));
        t->momentum[k + 1] = series_reciprocal[k + 1] * (d->mobility * s->swing_torque[k]
            + c->mobility * d_swing_torque[k]);
        t->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->stiffness_times_extension_rate * (s->extension[k] - s->length[k])
            + c->stiffness_times_extension_rate * (t->extension[k] - t->length[k]),
            d->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness_times_extension_rate * (d->free_length + d->thrusting_times_longer_or_by_0)));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_length_rate_2[k]));
        t->work[k + 1] = series_reciprocal[k + 1] * (d_swing_torque_times_rate[k]
            + swing_torque_times_d_rate[k]);
        t->extension[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->extension_rate));
        t->external_fx[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fx_rate));
        t->external_fy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fy_rate));
        t->friction[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->friction_rate));
        t->external_torque[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_torque_rate));
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->com_x[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->com_vx));
        t->com_vy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->minus_gravity));
        t->placing[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->is_placing));
    }
}

/* First variation of power_of_hip. */
static void d_observed_flight_calm_power_of_hip(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const flight_calm_series *t = (const void *)d_series;
    (void)constants, (void)series, (void)d_constants;
    for (int k = 0; k < order; ++k) {
        dg[k] = (double)(k + 1) * t->work[k + 1];
    }
}

/* First variation of height_of_foot. */
static void d_observed_flight_calm_height_of_foot(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    const flight_calm_constants *d = (const void *)d_constants;
    const flight_calm_series *t = (const void *)d_series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_times_cos_of_angle_minus_slope[TERMS],
        own_product_2[TERMS], own_sin_of_angle_minus_slope[TERMS], own_product_3[TERMS],
        own_product_times_product_3[TERMS], own_angle_minus_slope[TERMS], own_product_4[TERMS],
        own_product_plus_product[TERMS], own_angle_minus_slope_2[TERMS];
    for (int k = 0; k < order; ++k) {
        own_product_4[k] = c->body_mass_over_body_mass_plus_foot_mass * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_times_cos_of_angle_minus_slope[k] = product(own_product_4, own_cos_of_angle_minus_slope,
            k);
        own_product_plus_product[k] = d->body_mass_over_body_mass_plus_foot_mass * s->length[k]
            + c->body_mass_over_body_mass_plus_foot_mass * t->length[k];
        own_product_2[k] = product(own_product_plus_product, own_cos_of_angle_minus_slope, k);
        own_angle_minus_slope_2[k] = with_constant(k, t->angle[k], -d->slope);
        own_product_3[k] = product(own_sin_of_angle_minus_slope, own_angle_minus_slope_2, k);
        own_product_times_product_3[k] = product(own_product_4, own_product_3, k);
        dg[k] = with_constant(k, d->inverse_cos_of_slope * (c->cos_of_slope * s->com_y[k]
            - c->sin_of_slope * s->com_x[k] - own_product_times_cos_of_angle_minus_slope[k])
            + c->inverse_cos_of_slope * (d->cos_of_slope * s->com_y[k] + c->cos_of_slope * t->com_y[k]
            - (d->sin_of_slope * s->com_x[k] + c->sin_of_slope * t->com_x[k]) - (own_product_2[k]
            - own_product_times_product_3[k])), c->inverse_cos_of_slope * (-(d->cos_of_slope * c->height)
            - c->cos_of_slope * d->height) - d->inverse_cos_of_slope * (c->cos_of_slope * c->height));
    }
}

/* First variation of square_of_torque. */
static void d_observed_flight_calm_square_of_torque(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    const flight_calm_constants *d = (const void *)d_constants;
    const flight_calm_series *t = (const void *)d_series;
    real own_length_times_length[TERMS], own_rate_times_d_square[TERMS], own_d_rate[TERMS],
        own_swing_torque_times_d_swing_torque[TERMS], own_d_square[TERMS], own_d_swing_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_length_times_length[k] = product(s->length, t->length, k);
        own_d_square[k] = 2.0 * own_length_times_length[k];
        own_rate_times_d_square[k] = product(s->rate, own_d_square, k);
        own_d_rate[k] = (t->momentum[k] - own_rate_times_d_square[k] - product_so_far(own_d_rate, s->square,
            k)) / s->square[0];
        own_d_swing_torque[k] = with_constant(k, t->external_torque[k] + (-(d->share_times_kp * (s->angle[k]
            + c->turn * s->placing[k]) + c->share_times_kp * (t->angle[k] + (d->turn * s->placing[k]
            + c->turn * t->placing[k]))) - (d->share_times_kd * s->rate[k]
            + c->share_times_kd * own_d_rate[k])), -(-(d->share_times_kp * c->first)
            - c->share_times_kp * d->first) - (d->share_times_kd * c->turn + c->share_times_kd * d->turn));
        own_swing_torque_times_d_swing_torque[k] = product(s->swing_torque, own_d_swing_torque, k);
        dg[k] = 2.0 * own_swing_torque_times_d_swing_torque[k];
    }
}

/* passes_end: The foot is above the next segment. */
static void guard_flight_calm_passes_end(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    real own_sine[TERMS], own_length_times_sine[TERMS], own_cosine[TERMS];
    for (int k = 0; k < order; ++k) {
        sine_and_cosine_by_rate(k, s->angle, s->rate, own_sine, own_cosine);
        own_length_times_sine[k] = product(s->length, own_sine, k);
        g[k] = with_constant(k, -(s->com_x[k]
            + c->body_mass_over_body_mass_plus_foot_mass * own_length_times_sine[k]), c->segment_end);
    }
}

/* passes_begin: The foot is above the segment before. */
static void guard_flight_calm_passes_begin(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    real own_sine[TERMS], own_length_times_sine[TERMS], own_cosine[TERMS];
    for (int k = 0; k < order; ++k) {
        sine_and_cosine_by_rate(k, s->angle, s->rate, own_sine, own_cosine);
        own_length_times_sine[k] = product(s->length, own_sine, k);
        g[k] = with_constant(k, s->com_x[k]
            + c->body_mass_over_body_mass_plus_foot_mass * own_length_times_sine[k], -c->segment_begin);
    }
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static void guard_flight_calm_ramp_ends(const real *constants, const real *series, int order, real *g) {
    const flight_calm_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->friction[k];
    }
}

/* wind_rises: An external force acts, so flight is no longer ballistic. */
static void guard_flight_calm_wind_rises(const real *constants, const real *series, int order, real *g) {
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        g[k] = constant_of(k, broadcast(-1.0));
    }
}

/* new_ground: The foot is above the pending ground line, which comes into force. */
static void guard_flight_calm_new_ground(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    real own_cos_of_angle_minus_set_slope[TERMS], own_product_2[TERMS],
        own_sin_of_angle_minus_set_slope[TERMS], own_angle_minus_set_slope[TERMS], own_product_4[TERMS];
    for (int k = 0; k < order; ++k) {
        own_product_4[k] = c->body_mass_over_body_mass_plus_foot_mass * s->length[k];
        own_angle_minus_set_slope[k] = with_constant(k, s->angle[k], -c->set_slope);
        sine_and_cosine_of(k, own_angle_minus_set_slope, own_sin_of_angle_minus_set_slope,
            own_cos_of_angle_minus_set_slope);
        own_product_2[k] = product(own_product_4, own_cos_of_angle_minus_set_slope, k);
        g[k] = with_constant(k, -(c->cos_of_set_slope * s->com_y[k] - c->sin_of_set_slope * s->com_x[k]
            - own_product_2[k]), c->cos_of_set_slope * c->set_height);
    }
}

/* falls: The body reaches the ground. */
static void guard_flight_calm_falls(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_2[TERMS], own_sin_of_angle_minus_slope[TERMS],
        own_angle_minus_slope[TERMS], own_sum_2_times_length[TERMS];
    for (int k = 0; k < order; ++k) {
        own_sum_2_times_length[k] = c->sum_2 * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_2[k] = product(own_sum_2_times_length, own_cos_of_angle_minus_slope, k);
        g[k] = with_constant(k, c->cos_of_slope * s->com_y[k] - c->sin_of_slope * s->com_x[k]
            + own_product_2[k], -(c->cos_of_slope * c->height));
    }
}

/* collapses: The leg is shorter than leg.min_length. */
static void guard_flight_calm_collapses(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->length[k], -c->least_length);
    }
}

/* apex: A stride closes and place begins. An external force can cause further apices in place. */
static void guard_flight_calm_apex(const real *constants, const real *series, int order, real *g) {
    const flight_calm_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->com_y[k + 1];
    }
}

/* touchdown: The foot reaches the ground. Where the lift of the flight law vanishes, shorter and shorter
 * hops follow each other. After one of no time the foot grazes, until the flight law has ceased to lift it
 * and lifts it again. */
static void guard_flight_calm_touchdown(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_times_cos_of_angle_minus_slope[TERMS],
        own_sin_of_angle_minus_slope[TERMS], own_angle_minus_slope[TERMS], own_product_4[TERMS];
    for (int k = 0; k < order; ++k) {
        own_product_4[k] = c->body_mass_over_body_mass_plus_foot_mass * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_times_cos_of_angle_minus_slope[k] = product(own_product_4, own_cos_of_angle_minus_slope,
            k);
        g[k] = with_constant(k, c->cos_of_slope * s->com_y[k] - c->sin_of_slope * s->com_x[k]
            - own_product_times_cos_of_angle_minus_slope[k], -(c->cos_of_slope * c->height));
    }
}

/* clamp: The clamp of the hip torque closes: it holds the retracting torque at 0. */
static void guard_flight_calm_clamp(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(c->kp * s->angle[k]) - c->kd * s->rate[k],
            c->kp * c->liftoff_factor_times_liftoff_angle);
    }
}

/* release: The clamp of the hip torque opens: it releases the retracting torque. */
static void guard_flight_calm_release(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(-(c->kp * s->angle[k]) - c->kd * s->rate[k]),
            -(c->kp * c->liftoff_factor_times_liftoff_angle));
    }
}

/* power_of_hip: Power of the total hip torque. */
static void guard_flight_calm_power_of_hip(const real *constants, const real *series, int order, real *g) {
    const flight_calm_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->work[k + 1];
    }
}

/* height_of_foot: Height of the foot above the ground vertically below. */
static void guard_flight_calm_height_of_foot(const real *constants, const real *series, int order, real *g) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_times_cos_of_angle_minus_slope[TERMS],
        own_sin_of_angle_minus_slope[TERMS], own_angle_minus_slope[TERMS], own_product_4[TERMS];
    for (int k = 0; k < order; ++k) {
        own_product_4[k] = c->body_mass_over_body_mass_plus_foot_mass * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_times_cos_of_angle_minus_slope[k] = product(own_product_4, own_cos_of_angle_minus_slope,
            k);
        g[k] = with_constant(k, c->inverse_cos_of_slope * (c->cos_of_slope * s->com_y[k]
            - c->sin_of_slope * s->com_x[k] - own_product_times_cos_of_angle_minus_slope[k]),
            -(c->inverse_cos_of_slope * (c->cos_of_slope * c->height)));
    }
}

/* square_of_torque: Square of the total hip torque. */
static void guard_flight_calm_square_of_torque(const real *constants, const real *series, int order,
    real *g) {
    const flight_calm_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = product(s->swing_torque, s->swing_torque, k);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_flight_calm(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const flight_calm_constants *c = (const void *)constants;
    const flight_calm_series *s = (const void *)series;
    const interval span_0 = interval_at(c->cos_of_slope, c->cos_of_slope);
    const interval span_1 = interval_of_series(s->com_y, power, 3);
    const interval span_2 = interval_at(c->height, c->height);
    const interval span_3 = interval_difference(span_1, span_2);
    const interval span_4 = interval_product(span_0, span_3);
    const interval span_5 = interval_at(c->sin_of_slope, c->sin_of_slope);
    const interval span_6 = interval_of_series(s->com_x, power, 2);
    const interval span_7 = interval_product(span_5, span_6);
    const interval span_8 = interval_difference(span_4, span_7);
    const interval span_9 = interval_at(c->sum_2, c->sum_2);
    const interval span_10 = interval_of_series(s->length, power, order);
    const interval span_11 = interval_product(span_9, span_10);
    const interval span_12 = interval_at(broadcast(-1.0), broadcast(1.0));
    const interval span_13 = interval_product(span_11, span_12);
    const interval span_14 = interval_sum(span_8, span_13);
    bounds[5] = span_14;
    const interval span_15 = interval_at(c->least_length, c->least_length);
    const interval span_16 = interval_difference(span_10, span_15);
    bounds[6] = span_16;
    const interval span_17 = interval_at(c->body_mass_over_body_mass_plus_foot_mass,
        c->body_mass_over_body_mass_plus_foot_mass);
    const interval span_18 = interval_product(span_17, span_10);
    const interval span_19 = interval_product(span_18, span_12);
    const interval span_20 = interval_difference(span_8, span_19);
    bounds[8] = span_20;
    if (watched >> 0 & 1) {
        const interval span_21 = interval_of_series(s->angle, power, order);
        const interval span_22 = interval_at(c->segment_end, c->segment_end);
        const interval span_23 = interval_of_turn(s->angle[0], span_21, true);
        const interval span_24 = interval_product(span_10, span_23);
        const interval span_25 = interval_product(span_17, span_24);
        const interval span_26 = interval_sum(span_6, span_25);
        const interval span_27 = interval_difference(span_22, span_26);
        bounds[0] = span_27;
    }
    if (watched >> 1 & 1) {
        const interval span_21 = interval_of_series(s->angle, power, order);
        const interval span_22 = interval_of_turn(s->angle[0], span_21, true);
        const interval span_23 = interval_product(span_10, span_22);
        const interval span_24 = interval_product(span_17, span_23);
        const interval span_25 = interval_sum(span_6, span_24);
        const interval span_26 = interval_at(c->segment_begin, c->segment_begin);
        const interval span_27 = interval_difference(span_25, span_26);
        bounds[1] = span_27;
    }
    if (watched >> 2 & 1) {
        const interval span_21 = interval_of_series(s->friction, power, 2);
        bounds[2] = span_21;
    }
    if (watched >> 3 & 1) {
        const interval span_21 = interval_at(broadcast(-1.0), broadcast(-1.0));
        bounds[3] = span_21;
    }
    if (watched >> 4 & 1) {
        const interval span_21 = interval_at(c->cos_of_set_slope, c->cos_of_set_slope);
        const interval span_22 = interval_at(c->set_height, c->set_height);
        const interval span_23 = interval_difference(span_1, span_22);
        const interval span_24 = interval_product(span_21, span_23);
        const interval span_25 = interval_at(c->sin_of_set_slope, c->sin_of_set_slope);
        const interval span_26 = interval_product(span_25, span_6);
        const interval span_27 = interval_difference(span_24, span_26);
        const interval span_28 = interval_at(broadcast(-1.0), broadcast(1.0));
        const interval span_29 = interval_product(span_18, span_28);
        const interval span_30 = interval_difference(span_27, span_29);
        const interval span_31 = interval_at(-span_30.high, -span_30.low);
        bounds[4] = span_31;
    }
    if (watched >> 7 & 1) {
        const interval span_21 = interval_of_rate(s->com_y, power, 2);
        bounds[7] = span_21;
    }
    if (watched >> 9 & 1) {
        const interval span_21 = interval_at(c->kp, c->kp);
        const interval span_22 = interval_of_series(s->angle, power, order);
        const interval span_23 = interval_at(c->liftoff_factor_times_liftoff_angle,
            c->liftoff_factor_times_liftoff_angle);
        const interval span_24 = interval_difference(span_22, span_23);
        const interval span_25 = interval_product(span_21, span_24);
        const interval span_26 = interval_at(-span_25.high, -span_25.low);
        const interval span_27 = interval_at(c->kd, c->kd);
        const interval span_28 = interval_of_series(s->rate, power, order);
        const interval span_29 = interval_product(span_27, span_28);
        const interval span_30 = interval_difference(span_26, span_29);
        bounds[9] = span_30;
    }
    if (watched >> 10 & 1) {
        const interval span_21 = interval_at(c->kp, c->kp);
        const interval span_22 = interval_of_series(s->angle, power, order);
        const interval span_23 = interval_at(c->liftoff_factor_times_liftoff_angle,
            c->liftoff_factor_times_liftoff_angle);
        const interval span_24 = interval_difference(span_22, span_23);
        const interval span_25 = interval_product(span_21, span_24);
        const interval span_26 = interval_at(-span_25.high, -span_25.low);
        const interval span_27 = interval_at(c->kd, c->kd);
        const interval span_28 = interval_of_series(s->rate, power, order);
        const interval span_29 = interval_product(span_27, span_28);
        const interval span_30 = interval_difference(span_26, span_29);
        const interval span_31 = interval_at(-span_30.high, -span_30.low);
        bounds[10] = span_31;
    }
    if (watched >> 12 & 1) {
        const interval span_21 = interval_at(c->inverse_cos_of_slope, c->inverse_cos_of_slope);
        const interval span_22 = interval_product(span_21, span_20);
        bounds[12] = span_22;
    }
    if (watched >> 13 & 1) {
        const interval span_21 = interval_of_series(s->swing_torque, power, order);
        const interval span_22 = interval_square(span_21);
        bounds[13] = span_22;
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

/* ---- graze */

/* The foot touches the ground without force, under the torque tau_eq between both hip laws. */
typedef struct {
    real x_[TERMS], y_[TERMS], vx[TERMS], vy[TERMS], foot_x[TERMS], foot_vx[TERMS], leg_work[TERMS],
        external_work[TERMS], damper_loss[TERMS], work[TERMS], extension[TERMS], external_fx[TERMS],
        external_fy[TERMS], friction[TERMS], external_torque[TERMS], time[TERMS], placing[TERMS],
        seen_angle[TERMS], x__times_x_[TERMS], y__times_y_[TERMS], square[TERMS], length[TERMS],
        length_rate[TERMS], axial[TERMS], axial_times_x_[TERMS], axial_times_y_[TERMS],
        axial_times_y__plus_off_over_x_[TERMS], product_2[TERMS], foot_vx_plus_vx[TERMS],
        sum_times_foot_vx_plus_vx[TERMS], sum_times_vy[TERMS], length_rate_times_length_rate[TERMS],
        product_3[TERMS], x__times_vy[TERMS], y__times_vx[TERMS], angle_rate[TERMS],
        product_3_times_angle_rate[TERMS];
} graze_series;

typedef struct {
    pair x__times_x_, y__times_y_, length, axial, axial_times_x_, axial_times_y_,
        axial_times_y__plus_off_over_x_, product_2, length_rate_times_length_rate, product_3, x__times_vy,
        y__times_vx, angle_rate, product_3_times_angle_rate;
} graze_sums;

typedef struct {
    real inverse_length, inverse_x_, inverse_square;
} graze_factors;

/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_graze_sums(const graze_series *s, int i, int j, graze_sums *sum) {
    add_products(&sum->x__times_x_, s->x_ + i - 1, s->x_[j + 1]);
    add_products(&sum->y__times_y_, s->y_ + i - 1, s->y_[j + 1]);
    add_products(&sum->length, s->length + i - 1, s->length[j + 1]);
    add_both_products(&sum->axial, s->axial, s->length, i, j);
    add_both_products(&sum->axial_times_x_, s->axial, s->x_, i, j);
    add_both_products(&sum->axial_times_y_, s->axial, s->y_, i, j);
    add_both_products(&sum->axial_times_y__plus_off_over_x_, s->axial_times_y__plus_off_over_x_, s->x_, i, j);
    add_both_products(&sum->product_2, s->axial_times_y__plus_off_over_x_, s->y_, i, j);
    add_products(&sum->length_rate_times_length_rate, s->length_rate + i - 1, s->length_rate[j]);
    add_both_products(&sum->product_3, s->axial_times_y__plus_off_over_x_, s->square, i, j);
    add_both_products(&sum->x__times_vy, s->x_, s->vy, i, j);
    add_both_products(&sum->y__times_vx, s->y_, s->vx, i, j);
    add_both_products(&sum->angle_rate, s->angle_rate, s->square, i, j);
    add_both_products(&sum->product_3_times_angle_rate, s->product_3, s->angle_rate, i, j);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_graze_sums(const graze_series *s, int i, graze_sums *sum) {
    sum->x__times_x_ = next_middle_of_square(s->x_, i);
    sum->y__times_y_ = next_middle_of_square(s->y_, i);
    sum->length = next_middle_of_square(s->length, i);
    sum->axial = middle_of_product(s->axial, s->length, i);
    sum->axial_times_x_ = middle_of_product(s->axial, s->x_, i);
    sum->axial_times_y_ = middle_of_product(s->axial, s->y_, i);
    sum->axial_times_y__plus_off_over_x_ = middle_of_product(s->axial_times_y__plus_off_over_x_, s->x_, i);
    sum->product_2 = middle_of_product(s->axial_times_y__plus_off_over_x_, s->y_, i);
    sum->length_rate_times_length_rate = middle_of_square(s->length_rate, i);
    sum->product_3 = middle_of_product(s->axial_times_y__plus_off_over_x_, s->square, i);
    sum->x__times_vy = middle_of_product(s->x_, s->vy, i);
    sum->y__times_vx = middle_of_product(s->y_, s->vx, i);
    sum->angle_rate = middle_of_product(s->angle_rate, s->square, i);
    sum->product_3_times_angle_rate = middle_of_product(s->product_3, s->angle_rate, i);
}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_graze(const graze_constants *c, const graze_factors *by, int k, const graze_sums *sum,
    int odd, graze_series *s) {
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
    /* axial = (c->stiffness * (c->free_length + extension + c->thrusting_times_longer_or_by_0 - length) -
     * c->damping * length_rate) / length */
    s->axial[k] = quotient_of(k, part_of(sum->axial, odd), with_constant(k, c->stiffness * (s->extension[k]
        - s->length[k]) - c->damping * s->length_rate[k], c->stiffness * (c->free_length
        + c->thrusting_times_longer_or_by_0)), s->axial, s->length, by->inverse_length);
    /* axial_times_x_ = axial * x_ */
    s->axial_times_x_[k] = product_of(k, part_of(sum->axial_times_x_, odd), s->axial, s->x_);
    /* axial_times_y_ = axial * y_ */
    s->axial_times_y_[k] = product_of(k, part_of(sum->axial_times_y_, odd), s->axial, s->y_);
    /* axial_times_y__plus_off_over_x_ = (axial_times_y_ + c->off) / x_ */
    s->axial_times_y__plus_off_over_x_[k] = quotient_of(k, part_of(sum->axial_times_y__plus_off_over_x_, odd),
        with_constant(k, s->axial_times_y_[k], c->off), s->axial_times_y__plus_off_over_x_, s->x_,
        by->inverse_x_);
    /* product_2 = axial_times_y__plus_off_over_x_ * y_ */
    s->product_2[k] = product_of(k, part_of(sum->product_2, odd), s->axial_times_y__plus_off_over_x_, s->y_);
    /* foot_vx_plus_vx = foot_vx + vx */
    s->foot_vx_plus_vx[k] = s->foot_vx[k] + s->vx[k];
    /* sum_times_foot_vx_plus_vx = (c->cosine * external_fx + c->sine * external_fy) * foot_vx_plus_vx */
    s->sum_times_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
        + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
        s->foot_vx_plus_vx);
    /* sum_times_vy = (c->cosine * external_fy - c->sine * external_fx) * vy */
    s->sum_times_vy[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
        c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], s->vy);
    /* length_rate_times_length_rate = length_rate * length_rate */
    s->length_rate_times_length_rate[k] = square_of(k, part_of(sum->length_rate_times_length_rate, odd),
        s->length_rate);
    /* product_3 = axial_times_y__plus_off_over_x_ * square */
    s->product_3[k] = product_of(k, part_of(sum->product_3, odd), s->axial_times_y__plus_off_over_x_,
        s->square);
    /* x__times_vy = x_ * vy */
    s->x__times_vy[k] = product_of(k, part_of(sum->x__times_vy, odd), s->x_, s->vy);
    /* y__times_vx = y_ * vx */
    s->y__times_vx[k] = product_of(k, part_of(sum->y__times_vx, odd), s->y_, s->vx);
    /* angle_rate = (x__times_vy - y__times_vx) / square */
    s->angle_rate[k] = quotient_of(k, part_of(sum->angle_rate, odd), s->x__times_vy[k] - s->y__times_vx[k],
        s->angle_rate, s->square, by->inverse_square);
    /* product_3_times_angle_rate = product_3 * angle_rate */
    s->product_3_times_angle_rate[k] = product_of(k, part_of(sum->product_3_times_angle_rate, odd),
        s->product_3, s->angle_rate);
    s->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_x_[k]
        + s->product_2[k] + (c->cosine * s->external_fx[k] + c->sine * s->external_fy[k]))
        + c->inverse_foot_mass * (s->axial_times_x_[k] + s->product_2[k]), c->inverse_foot_mass * c->along
        - c->gravity_times_sine));
    s->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->inverse_body_mass * (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k]),
        -(c->inverse_body_mass * c->off) - c->gravity_times_cosine));
    s->foot_vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        -(c->inverse_foot_mass * (s->axial_times_x_[k] + s->product_2[k])),
        -(c->inverse_foot_mass * c->along)));
    s->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->stiffness_times_extension_rate * (s->extension[k] - s->length[k]),
        c->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)));
    s->external_work[k + 1] = series_reciprocal[k + 1] * (s->sum_times_foot_vx_plus_vx[k]
        + s->sum_times_vy[k]);
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (-s->product_3_times_angle_rate[k]);
    s->seen_angle[k + 1] = series_reciprocal[k + 1] * (s->angle_rate[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_graze(const real *constants, int order, real *series) {
    const graze_constants copy = *(const graze_constants *)(const void *)constants, *c = &copy;
    graze_series *s = (void *)series;
    static const graze_sums none;
    graze_sums sum = none;
    s->extension[1] = c->extension_rate;
    s->external_fx[1] = c->external_fx_rate;
    s->external_fy[1] = c->external_fy_rate;
    s->friction[1] = c->friction_rate;
    s->external_torque[1] = c->external_torque_rate;
    s->time[1] = broadcast(1.0);
    s->placing[1] = c->is_placing;
    s->seen_angle[0] = real_atan2(-s->x_[0], s->y_[0]);
    s->x__times_x_[0] = s->x_[0] * s->x_[0];
    s->y__times_y_[0] = s->y_[0] * s->y_[0];
    s->square[0] = s->x__times_x_[0] + s->y__times_y_[0];
    s->length[0] = real_sqrt(s->square[0]);
    const graze_factors factors = {1.0 / s->length[0], 1.0 / s->x_[0], 1.0 / s->square[0]}, *by = &factors;
    step_graze(c, by, 0, &sum, 0, s);
    begin_graze_sums(s, 0, &sum);
    step_graze(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {
        begin_graze_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_graze_sums(s, i, j, &sum);
        }
        step_graze(c, by, k, &sum, 0, s);
        add_graze_sums(s, 1, k, &sum);
        step_graze(c, by, k + 1, &sum, 1, s);
    }
}

/* First variation of the series. */
static void vary_graze(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    const graze_constants *d = (const void *)d_constants;
    graze_series *t = (void *)varied;
    real x__times_x__2[TERMS], y__times_y__2[TERMS], d_length[TERMS], d_length_rate[TERMS],
        axial_times_d_length[TERMS], d_axial[TERMS], d_axial_times_x_[TERMS], axial_times_x__2[TERMS],
        d_axial_times_y_[TERMS], axial_times_y__2[TERMS], product_4[TERMS],
        d_axial_times_y__plus_off_over_x_[TERMS], product_5[TERMS], product_6[TERMS],
        sum_plus_sum_times_foot_vx_plus_vx[TERMS], sum_times_d_foot_vx_plus_vx[TERMS],
        sum_minus_sum_times_vy[TERMS], sum_times_vy_2[TERMS], length_rate_times_d_length_rate[TERMS],
        product_7[TERMS], product_8[TERMS], d_product_3_times_angle_rate[TERMS], x__times_vy_2[TERMS],
        x__times_vy_3[TERMS], y__times_vx_2[TERMS], y__times_vx_3[TERMS], angle_rate_times_d_square[TERMS],
        d_angle_rate[TERMS], product_3_times_d_angle_rate[TERMS], sum_plus_sum[TERMS],
        d_foot_vx_plus_vx[TERMS], sum_minus_sum[TERMS], d_square[TERMS], d_product_3[TERMS];
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
        d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * d_length_rate[k]) - axial_times_d_length[k], d->stiffness * (c->free_length
            + c->thrusting_times_longer_or_by_0) + c->stiffness * (d->free_length
            + d->thrusting_times_longer_or_by_0)) - product_so_far(d_axial, s->length, k)) / s->length[0];
        d_axial_times_x_[k] = product(d_axial, s->x_, k);
        axial_times_x__2[k] = product(s->axial, t->x_, k);
        d_axial_times_y_[k] = product(d_axial, s->y_, k);
        axial_times_y__2[k] = product(s->axial, t->y_, k);
        product_4[k] = product(s->axial_times_y__plus_off_over_x_, t->x_, k);
        d_axial_times_y__plus_off_over_x_[k] = (with_constant(k, d_axial_times_y_[k] + axial_times_y__2[k]
            - product_4[k], d->off) - product_so_far(d_axial_times_y__plus_off_over_x_, s->x_, k)) / s->x_[0];
        product_5[k] = product(d_axial_times_y__plus_off_over_x_, s->y_, k);
        product_6[k] = product(s->axial_times_y__plus_off_over_x_, t->y_, k);
        sum_plus_sum[k] = d->cosine * s->external_fx[k] + c->cosine * t->external_fx[k]
            + (d->sine * s->external_fy[k] + c->sine * t->external_fy[k]);
        sum_minus_sum[k] = d->cosine * s->external_fy[k] + c->cosine * t->external_fy[k]
            - (d->sine * s->external_fx[k] + c->sine * t->external_fx[k]);
        sum_plus_sum_times_foot_vx_plus_vx[k] = product(sum_plus_sum, s->foot_vx_plus_vx, k);
        d_foot_vx_plus_vx[k] = t->foot_vx[k] + t->vx[k];
        sum_times_d_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
            + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
            d_foot_vx_plus_vx);
        sum_minus_sum_times_vy[k] = product(sum_minus_sum, s->vy, k);
        sum_times_vy_2[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
            c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], t->vy);
        length_rate_times_d_length_rate[k] = product(s->length_rate, d_length_rate, k);
        product_7[k] = product(d_axial_times_y__plus_off_over_x_, s->square, k);
        product_8[k] = product(s->axial_times_y__plus_off_over_x_, d_square, k);
        d_product_3[k] = product_7[k] + product_8[k];
        d_product_3_times_angle_rate[k] = product(d_product_3, s->angle_rate, k);
        x__times_vy_2[k] = product(t->x_, s->vy, k);
        x__times_vy_3[k] = product(s->x_, t->vy, k);
        y__times_vx_2[k] = product(t->y_, s->vx, k);
        y__times_vx_3[k] = product(s->y_, t->vx, k);
        angle_rate_times_d_square[k] = product(s->angle_rate, d_square, k);
        d_angle_rate[k] = (x__times_vy_2[k] + x__times_vy_3[k] - (y__times_vx_2[k] + y__times_vx_3[k])
            - angle_rate_times_d_square[k] - product_so_far(d_angle_rate, s->square, k)) / s->square[0];
        product_3_times_d_angle_rate[k] = product(s->product_3, d_angle_rate, k);
        t->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_x_[k] + s->product_2[k] + (c->cosine * s->external_fx[k]
            + c->sine * s->external_fy[k])) + c->inverse_body_mass * (d_axial_times_x_[k]
            + axial_times_x__2[k] + (product_5[k] + product_6[k]) + sum_plus_sum[k])
            + (d->inverse_foot_mass * (s->axial_times_x_[k] + s->product_2[k])
            + c->inverse_foot_mass * (d_axial_times_x_[k] + axial_times_x__2[k] + (product_5[k]
            + product_6[k]))), d->inverse_foot_mass * c->along + c->inverse_foot_mass * d->along
            - d->gravity_times_sine));
        t->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k])
            + c->inverse_body_mass * sum_minus_sum[k], -(d->inverse_body_mass * c->off)
            - c->inverse_body_mass * d->off - d->gravity_times_cosine));
        t->foot_vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            -(d->inverse_foot_mass * (s->axial_times_x_[k] + s->product_2[k])
            + c->inverse_foot_mass * (d_axial_times_x_[k] + axial_times_x__2[k] + (product_5[k]
            + product_6[k]))), -(d->inverse_foot_mass * c->along + c->inverse_foot_mass * d->along)));
        t->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->stiffness_times_extension_rate * (s->extension[k] - s->length[k])
            + c->stiffness_times_extension_rate * (t->extension[k] - d_length[k]),
            d->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness_times_extension_rate * (d->free_length + d->thrusting_times_longer_or_by_0)));
        t->external_work[k + 1] = series_reciprocal[k + 1] * (sum_plus_sum_times_foot_vx_plus_vx[k]
            + sum_times_d_foot_vx_plus_vx[k] + (sum_minus_sum_times_vy[k] + sum_times_vy_2[k]));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_d_length_rate[k]));
        t->work[k + 1] = series_reciprocal[k + 1] * (-(d_product_3_times_angle_rate[k]
            + product_3_times_d_angle_rate[k]));
        t->extension[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->extension_rate));
        t->external_fx[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fx_rate));
        t->external_fy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fy_rate));
        t->friction[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->friction_rate));
        t->external_torque[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_torque_rate));
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->placing[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->is_placing));
        t->seen_angle[k + 1] = series_reciprocal[k + 1] * (d_angle_rate[k]);
    }
}

/* First variation of power_of_hip. */
static void d_observed_graze_power_of_hip(const real *constants, const real *series, const real *d_constants,
    const real *d_series, int order, real *dg) {
    const graze_series *t = (const void *)d_series;
    (void)constants, (void)series, (void)d_constants;
    for (int k = 0; k < order; ++k) {
        dg[k] = (double)(k + 1) * t->work[k + 1];
    }
}

/* First variation of square_of_torque. */
static void d_observed_graze_square_of_torque(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    const graze_constants *d = (const void *)d_constants;
    const graze_series *t = (const void *)d_series;
    real own_x__times_x__2[TERMS], own_y__times_y__2[TERMS], own_d_length[TERMS], own_d_length_rate[TERMS],
        own_axial_times_d_length[TERMS], own_d_axial[TERMS], own_d_axial_times_y_[TERMS],
        own_axial_times_y__2[TERMS], own_product_4[TERMS], own_d_axial_times_y__plus_off_over_x_[TERMS],
        own_product_7[TERMS], own_product_8[TERMS], own_product_3_times_d_product_3[TERMS],
        own_d_square[TERMS], own_d_product_3[TERMS];
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
        own_d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - own_d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * own_d_length_rate[k]) - own_axial_times_d_length[k],
            d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_product_4[k] = product(s->axial_times_y__plus_off_over_x_, t->x_, k);
        own_d_axial_times_y__plus_off_over_x_[k] = (with_constant(k, own_d_axial_times_y_[k]
            + own_axial_times_y__2[k] - own_product_4[k], d->off)
            - product_so_far(own_d_axial_times_y__plus_off_over_x_, s->x_, k)) / s->x_[0];
        own_product_7[k] = product(own_d_axial_times_y__plus_off_over_x_, s->square, k);
        own_product_8[k] = product(s->axial_times_y__plus_off_over_x_, own_d_square, k);
        own_d_product_3[k] = own_product_7[k] + own_product_8[k];
        own_product_3_times_d_product_3[k] = product(s->product_3, own_d_product_3, k);
        dg[k] = 2.0 * own_product_3_times_d_product_3[k];
    }
}

/* passes_end: The foot is above the next segment. */
static void guard_graze_passes_end(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(c->cosine * s->foot_x[k]), c->segment_end);
    }
}

/* passes_begin: The foot is above the segment before. */
static void guard_graze_passes_begin(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, c->cosine * s->foot_x[k], -c->segment_begin);
    }
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static void guard_graze_ramp_ends(const real *constants, const real *series, int order, real *g) {
    const graze_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->friction[k];
    }
}

/* falls: The body reaches the ground. */
static void guard_graze_falls(const real *constants, const real *series, int order, real *g) {
    const graze_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->y_[k];
    }
}

/* collapses: The leg is shorter than leg.min_length. */
static void guard_graze_collapses(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->length[k], -c->least_length);
    }
}

/* apex_in_graze: Place begins. No stride closes, because the foot is on the ground. */
static void guard_graze_apex_in_graze(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->sine * (s->foot_vx[k] + c->share * s->vx[k]) + c->cosine * (c->share * s->vy[k]);
    }
}

/* clamp: The clamp of the hip torque closes: it holds the retracting torque at 0. */
static void guard_graze_clamp(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(c->kp * s->seen_angle[k]) - c->kd * s->angle_rate[k],
            -(c->kp * (c->winding - c->liftoff_factor_times_liftoff_angle)));
    }
}

/* release: The clamp of the hip torque opens: it releases the retracting torque. */
static void guard_graze_release(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(-(c->kp * s->seen_angle[k]) - c->kd * s->angle_rate[k]),
            c->kp * (c->winding - c->liftoff_factor_times_liftoff_angle));
    }
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static void guard_graze_mid_stance(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->seen_angle[k], c->winding);
    }
}

/* graze_to_contact: The stance law presses the foot on the ground again. */
static void guard_graze_graze_to_contact(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    real own_turning[TERMS], own_turning_times_x_[TERMS];
    for (int k = 0; k < order; ++k) {
        own_turning[k] = (with_constant(k, s->external_torque[k], -c->product_2) - product_so_far(own_turning,
            s->square, k)) / s->square[0];
        own_turning_times_x_[k] = product(own_turning, s->x_, k);
        g[k] = with_constant(k, -(s->axial_times_y_[k] + own_turning_times_x_[k]), -c->off);
    }
}

/* graze_to_flight: The flight law lifts the foot. */
static void guard_graze_graze_to_flight(const real *constants, const real *series, int order, real *g) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    real own_swing_torque_over_square[TERMS], own_swing_torque_over_square_times_x_[TERMS];
    for (int k = 0; k < order; ++k) {
        own_swing_torque_over_square[k] = (with_constant(k, s->external_torque[k]
            + (-(c->by_1_or_by_0_times_kp * (s->seen_angle[k] + c->turn * s->placing[k]))
            - c->by_1_or_by_0_times_kd * s->angle_rate[k]), -(c->by_1_or_by_0_times_kp * (c->winding
            - c->first)) - c->by_1_or_by_0_times_kd * c->turn) - product_so_far(own_swing_torque_over_square,
            s->square, k)) / s->square[0];
        own_swing_torque_over_square_times_x_[k] = product(own_swing_torque_over_square, s->x_, k);
        g[k] = with_constant(k, s->axial_times_y_[k] + own_swing_torque_over_square_times_x_[k], c->off);
    }
}

/* power_of_hip: Power of the total hip torque. */
static void guard_graze_power_of_hip(const real *constants, const real *series, int order, real *g) {
    const graze_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->work[k + 1];
    }
}

/* square_of_torque: Square of the total hip torque. */
static void guard_graze_square_of_torque(const real *constants, const real *series, int order, real *g) {
    const graze_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = product(s->product_3, s->product_3, k);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_graze(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const graze_constants *c = (const void *)constants;
    const graze_series *s = (const void *)series;
    const interval span_0 = interval_of_series(s->y_, power, 4);
    bounds[3] = span_0;
    const interval span_1 = interval_of_series(s->length, power, order);
    const interval span_2 = interval_at(c->least_length, c->least_length);
    const interval span_3 = interval_difference(span_1, span_2);
    bounds[4] = span_3;
    bounds[9] = unbounded();
    bounds[10] = unbounded();
    if (watched >> 0 & 1) {
        const interval span_4 = interval_at(c->segment_end, c->segment_end);
        const interval span_5 = interval_at(c->cosine, c->cosine);
        const interval span_6 = interval_of_series(s->foot_x, power, order);
        const interval span_7 = interval_product(span_5, span_6);
        const interval span_8 = interval_difference(span_4, span_7);
        bounds[0] = span_8;
    }
    if (watched >> 1 & 1) {
        const interval span_4 = interval_at(c->cosine, c->cosine);
        const interval span_5 = interval_of_series(s->foot_x, power, order);
        const interval span_6 = interval_product(span_4, span_5);
        const interval span_7 = interval_at(c->segment_begin, c->segment_begin);
        const interval span_8 = interval_difference(span_6, span_7);
        bounds[1] = span_8;
    }
    if (watched >> 2 & 1) {
        const interval span_4 = interval_of_series(s->friction, power, 2);
        bounds[2] = span_4;
    }
    if (watched >> 5 & 1) {
        const interval span_4 = interval_at(c->sine, c->sine);
        const interval span_5 = interval_of_series(s->foot_vx, power, order);
        const interval span_6 = interval_at(c->share, c->share);
        const interval span_7 = interval_of_series(s->vx, power, order);
        const interval span_8 = interval_product(span_6, span_7);
        const interval span_9 = interval_sum(span_5, span_8);
        const interval span_10 = interval_product(span_4, span_9);
        const interval span_11 = interval_at(c->cosine, c->cosine);
        const interval span_12 = interval_of_series(s->vy, power, 3);
        const interval span_13 = interval_product(span_6, span_12);
        const interval span_14 = interval_product(span_11, span_13);
        const interval span_15 = interval_sum(span_10, span_14);
        bounds[5] = span_15;
    }
    if (watched >> 6 & 1) {
        const interval span_4 = interval_at(c->kp, c->kp);
        const interval span_5 = interval_of_series(s->seen_angle, power, order);
        const interval span_6 = interval_at(c->winding, c->winding);
        const interval span_7 = interval_sum(span_5, span_6);
        const interval span_8 = interval_at(c->liftoff_factor_times_liftoff_angle,
            c->liftoff_factor_times_liftoff_angle);
        const interval span_9 = interval_difference(span_7, span_8);
        const interval span_10 = interval_product(span_4, span_9);
        const interval span_11 = interval_at(-span_10.high, -span_10.low);
        const interval span_12 = interval_at(c->kd, c->kd);
        const interval span_13 = interval_of_series(s->angle_rate, power, order);
        const interval span_14 = interval_product(span_12, span_13);
        const interval span_15 = interval_difference(span_11, span_14);
        bounds[6] = span_15;
    }
    if (watched >> 7 & 1) {
        const interval span_4 = interval_at(c->kp, c->kp);
        const interval span_5 = interval_of_series(s->seen_angle, power, order);
        const interval span_6 = interval_at(c->winding, c->winding);
        const interval span_7 = interval_sum(span_5, span_6);
        const interval span_8 = interval_at(c->liftoff_factor_times_liftoff_angle,
            c->liftoff_factor_times_liftoff_angle);
        const interval span_9 = interval_difference(span_7, span_8);
        const interval span_10 = interval_product(span_4, span_9);
        const interval span_11 = interval_at(-span_10.high, -span_10.low);
        const interval span_12 = interval_at(c->kd, c->kd);
        const interval span_13 = interval_of_series(s->angle_rate, power, order);
        const interval span_14 = interval_product(span_12, span_13);
        const interval span_15 = interval_difference(span_11, span_14);
        const interval span_16 = interval_at(-span_15.high, -span_15.low);
        bounds[7] = span_16;
    }
    if (watched >> 8 & 1) {
        const interval span_4 = interval_of_series(s->seen_angle, power, order);
        const interval span_5 = interval_at(c->winding, c->winding);
        const interval span_6 = interval_sum(span_4, span_5);
        bounds[8] = span_6;
    }
    if (watched >> 12 & 1) {
        const interval span_4 = interval_of_series(s->product_3, power, order);
        const interval span_5 = interval_square(span_4);
        bounds[12] = span_5;
    }
}

/* ---- slip_falling */

/* m_f vdot = p - s mu f_n, where p is the push of the leg and s the direction of slip. */
typedef struct {
    real x_[TERMS], y_[TERMS], vx[TERMS], vy[TERMS], foot_x[TERMS], foot_vx[TERMS], leg_work[TERMS],
        external_work[TERMS], damper_loss[TERMS], friction_loss[TERMS], work[TERMS], extension[TERMS],
        external_fx[TERMS], external_fy[TERMS], friction[TERMS], external_torque[TERMS], time[TERMS],
        seen_angle[TERMS], x__times_x_[TERMS], y__times_y_[TERMS], square[TERMS], length[TERMS],
        length_rate[TERMS], axial[TERMS], axial_times_x_[TERMS], turning[TERMS], turning_times_y_[TERMS],
        minus_product[TERMS], fading[TERMS], sum_2[TERMS], slip_friction[TERMS],
        way_times_slip_friction[TERMS], axial_times_y_[TERMS], turning_times_x_[TERMS], normal[TERMS],
        friction_force[TERMS], foot_vx_plus_vx[TERMS], sum_times_foot_vx_plus_vx[TERMS], sum_times_vy[TERMS],
        length_rate_times_length_rate[TERMS], friction_force_times_foot_vx[TERMS], x__times_vy[TERMS],
        y__times_vx[TERMS], angle_rate[TERMS], power_of_hip[TERMS];
} slip_falling_series;

typedef struct {
    pair x__times_x_, y__times_y_, length, axial, axial_times_x_, turning, turning_times_y_, axial_times_y_,
        turning_times_x_, friction_force, length_rate_times_length_rate, friction_force_times_foot_vx,
        x__times_vy, y__times_vx, angle_rate;
} slip_falling_sums;

typedef struct {
    real inverse_length, inverse_square;
} slip_falling_factors;

/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_slip_falling_sums(const slip_falling_series *s, int i, int j, slip_falling_sums *sum) {
    add_products(&sum->x__times_x_, s->x_ + i - 1, s->x_[j + 1]);
    add_products(&sum->y__times_y_, s->y_ + i - 1, s->y_[j + 1]);
    add_products(&sum->length, s->length + i - 1, s->length[j + 1]);
    add_both_products(&sum->axial, s->axial, s->length, i, j);
    add_both_products(&sum->axial_times_x_, s->axial, s->x_, i, j);
    add_both_products(&sum->turning, s->turning, s->square, i, j);
    add_both_products(&sum->turning_times_y_, s->turning, s->y_, i, j);
    add_both_products(&sum->axial_times_y_, s->axial, s->y_, i, j);
    add_both_products(&sum->turning_times_x_, s->turning, s->x_, i, j);
    add_both_products(&sum->friction_force, s->way_times_slip_friction, s->normal, i, j);
    add_products(&sum->length_rate_times_length_rate, s->length_rate + i - 1, s->length_rate[j]);
    add_both_products(&sum->friction_force_times_foot_vx, s->friction_force, s->foot_vx, i, j);
    add_both_products(&sum->x__times_vy, s->x_, s->vy, i, j);
    add_both_products(&sum->y__times_vx, s->y_, s->vx, i, j);
    add_both_products(&sum->angle_rate, s->angle_rate, s->square, i, j);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_slip_falling_sums(const slip_falling_series *s, int i, slip_falling_sums *sum) {
    sum->x__times_x_ = next_middle_of_square(s->x_, i);
    sum->y__times_y_ = next_middle_of_square(s->y_, i);
    sum->length = next_middle_of_square(s->length, i);
    sum->axial = middle_of_product(s->axial, s->length, i);
    sum->axial_times_x_ = middle_of_product(s->axial, s->x_, i);
    sum->turning = middle_of_product(s->turning, s->square, i);
    sum->turning_times_y_ = middle_of_product(s->turning, s->y_, i);
    sum->axial_times_y_ = middle_of_product(s->axial, s->y_, i);
    sum->turning_times_x_ = middle_of_product(s->turning, s->x_, i);
    sum->friction_force = middle_of_product(s->way_times_slip_friction, s->normal, i);
    sum->length_rate_times_length_rate = middle_of_square(s->length_rate, i);
    sum->friction_force_times_foot_vx = middle_of_product(s->friction_force, s->foot_vx, i);
    sum->x__times_vy = middle_of_product(s->x_, s->vy, i);
    sum->y__times_vx = middle_of_product(s->y_, s->vx, i);
    sum->angle_rate = middle_of_product(s->angle_rate, s->square, i);
}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_slip_falling(const slip_falling_constants *c, const slip_falling_factors *by, int k,
    const slip_falling_sums *sum, int odd, slip_falling_series *s) {
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
    /* axial = (c->stiffness * (c->free_length + extension + c->thrusting_times_longer_or_by_0 - length) -
     * c->damping * length_rate) / length */
    s->axial[k] = quotient_of(k, part_of(sum->axial, odd), with_constant(k, c->stiffness * (s->extension[k]
        - s->length[k]) - c->damping * s->length_rate[k], c->stiffness * (c->free_length
        + c->thrusting_times_longer_or_by_0)), s->axial, s->length, by->inverse_length);
    /* axial_times_x_ = axial * x_ */
    s->axial_times_x_[k] = product_of(k, part_of(sum->axial_times_x_, odd), s->axial, s->x_);
    /* turning = (external_torque - c->product_2) / square */
    s->turning[k] = quotient_of(k, part_of(sum->turning, odd), with_constant(k, s->external_torque[k],
        -c->product_2), s->turning, s->square, by->inverse_square);
    /* turning_times_y_ = turning * y_ */
    s->turning_times_y_[k] = product_of(k, part_of(sum->turning_times_y_, odd), s->turning, s->y_);
    /* minus_product = -(c->inverse_stribeck_velocity * (c->way * foot_vx)) */
    s->minus_product[k] = -(c->inverse_stribeck_velocity * (c->way * s->foot_vx[k]));
    /* fading = real_exp(minus_product) */
    s->fading[k] = exp_of(k, s->minus_product, s->fading);
    /* sum_2 = 1.0 + c->static_ratio_minus_by_1 * fading */
    s->sum_2[k] = with_constant(k, c->static_ratio_minus_by_1 * s->fading[k], broadcast(1.0));
    /* slip_friction = (c->is_own_times_own + c->by_1_minus_is_own * friction) * sum_2 */
    s->slip_friction[k] = drift_times(k, with_constant(0, c->by_1_minus_is_own * s->friction[0],
        c->is_own_times_own), with_constant(1, c->by_1_minus_is_own * s->friction[1], c->is_own_times_own),
        s->sum_2);
    /* way_times_slip_friction = c->way * slip_friction */
    s->way_times_slip_friction[k] = c->way * s->slip_friction[k];
    /* axial_times_y_ = axial * y_ */
    s->axial_times_y_[k] = product_of(k, part_of(sum->axial_times_y_, odd), s->axial, s->y_);
    /* turning_times_x_ = turning * x_ */
    s->turning_times_x_[k] = product_of(k, part_of(sum->turning_times_x_, odd), s->turning, s->x_);
    /* normal = axial_times_y_ + turning_times_x_ + c->foot_mass_times_gravity_times_cosine */
    s->normal[k] = with_constant(k, s->axial_times_y_[k] + s->turning_times_x_[k],
        c->foot_mass_times_gravity_times_cosine);
    /* friction_force = way_times_slip_friction * normal */
    s->friction_force[k] = product_of(k, part_of(sum->friction_force, odd), s->way_times_slip_friction,
        s->normal);
    /* foot_vx_plus_vx = foot_vx + vx */
    s->foot_vx_plus_vx[k] = s->foot_vx[k] + s->vx[k];
    /* sum_times_foot_vx_plus_vx = (c->cosine * external_fx + c->sine * external_fy) * foot_vx_plus_vx */
    s->sum_times_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
        + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
        s->foot_vx_plus_vx);
    /* sum_times_vy = (c->cosine * external_fy - c->sine * external_fx) * vy */
    s->sum_times_vy[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
        c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], s->vy);
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
    /* power_of_hip = (external_torque - c->product_2) * angle_rate */
    s->power_of_hip[k] = drift_times(k, with_constant(0, s->external_torque[0], -c->product_2),
        with_constant(1, s->external_torque[1], -c->product_2), s->angle_rate);
    s->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_x_[k]
        - s->turning_times_y_[k] + (c->cosine * s->external_fx[k] + c->sine * s->external_fy[k]))
        - c->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k]) - s->friction_force[k]),
        c->inverse_foot_mass * c->foot_mass_times_gravity_times_sine - c->gravity_times_sine));
    s->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_body_mass * (s->axial_times_y_[k]
        + s->turning_times_x_[k] + (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k])),
        -c->gravity_times_cosine));
    s->foot_vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k]) - s->friction_force[k]),
        -(c->inverse_foot_mass * c->foot_mass_times_gravity_times_sine)));
    s->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->stiffness_times_extension_rate * (s->extension[k] - s->length[k]),
        c->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)));
    s->external_work[k + 1] = series_reciprocal[k + 1] * (s->sum_times_foot_vx_plus_vx[k]
        + s->sum_times_vy[k]);
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->friction_loss[k + 1] = series_reciprocal[k + 1] * (s->friction_force_times_foot_vx[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (s->power_of_hip[k]);
    s->seen_angle[k + 1] = series_reciprocal[k + 1] * (s->angle_rate[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_slip_falling(const real *constants, int order, real *series) {
    const slip_falling_constants copy = *(const slip_falling_constants *)(const void *)constants, *c = &copy;
    slip_falling_series *s = (void *)series;
    static const slip_falling_sums none;
    slip_falling_sums sum = none;
    s->extension[1] = c->extension_rate;
    s->external_fx[1] = c->external_fx_rate;
    s->external_fy[1] = c->external_fy_rate;
    s->friction[1] = c->friction_rate;
    s->external_torque[1] = c->external_torque_rate;
    s->time[1] = broadcast(1.0);
    s->seen_angle[0] = real_atan2(-s->x_[0], s->y_[0]);
    s->x__times_x_[0] = s->x_[0] * s->x_[0];
    s->y__times_y_[0] = s->y_[0] * s->y_[0];
    s->square[0] = s->x__times_x_[0] + s->y__times_y_[0];
    s->length[0] = real_sqrt(s->square[0]);
    const slip_falling_factors factors = {1.0 / s->length[0], 1.0 / s->square[0]}, *by = &factors;
    step_slip_falling(c, by, 0, &sum, 0, s);
    begin_slip_falling_sums(s, 0, &sum);
    step_slip_falling(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {
        begin_slip_falling_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_slip_falling_sums(s, i, j, &sum);
        }
        step_slip_falling(c, by, k, &sum, 0, s);
        add_slip_falling_sums(s, 1, k, &sum);
        step_slip_falling(c, by, k + 1, &sum, 1, s);
    }
}

/* First variation of the series. */
static void vary_slip_falling(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    const slip_falling_constants *d = (const void *)d_constants;
    slip_falling_series *t = (void *)varied;
    real x__times_x__2[TERMS], y__times_y__2[TERMS], d_length[TERMS], d_length_rate[TERMS],
        axial_times_d_length[TERMS], d_axial[TERMS], d_axial_times_x_[TERMS], axial_times_x__2[TERMS],
        turning_times_d_square[TERMS], d_turning[TERMS], d_turning_times_y_[TERMS], turning_times_y__2[TERMS],
        d_friction_along_times_sum_2[TERMS], fading_times_product_plus_product[TERMS],
        friction_along_times_d_sum_2[TERMS], d_way_times_slip_friction_times_normal[TERMS],
        d_axial_times_y_[TERMS], axial_times_y__2[TERMS], d_turning_times_x_[TERMS],
        turning_times_x__2[TERMS], way_times_slip_friction_times_d_normal[TERMS],
        sum_plus_sum_times_foot_vx_plus_vx[TERMS], sum_times_d_foot_vx_plus_vx[TERMS],
        sum_minus_sum_times_vy[TERMS], sum_times_vy_2[TERMS], length_rate_times_d_length_rate[TERMS],
        d_friction_force_times_foot_vx[TERMS], friction_force_times_foot_vx_2[TERMS],
        d_stance_torque_times_angle_rate[TERMS], x__times_vy_2[TERMS], x__times_vy_3[TERMS],
        y__times_vx_2[TERMS], y__times_vx_3[TERMS], angle_rate_times_d_square[TERMS], d_angle_rate[TERMS],
        stance_torque_times_d_angle_rate[TERMS], d_square[TERMS], d_friction_along[TERMS],
        product_plus_product[TERMS], d_sum_2[TERMS], d_way_times_slip_friction[TERMS], d_normal[TERMS],
        sum_plus_sum[TERMS], d_foot_vx_plus_vx[TERMS], sum_minus_sum[TERMS], d_friction_force[TERMS],
        d_stance_torque[TERMS];
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
        d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * d_length_rate[k]) - axial_times_d_length[k], d->stiffness * (c->free_length
            + c->thrusting_times_longer_or_by_0) + c->stiffness * (d->free_length
            + d->thrusting_times_longer_or_by_0)) - product_so_far(d_axial, s->length, k)) / s->length[0];
        d_axial_times_x_[k] = product(d_axial, s->x_, k);
        axial_times_x__2[k] = product(s->axial, t->x_, k);
        d_stance_torque[k] = with_constant(k, t->external_torque[k], -d->product_2);
        turning_times_d_square[k] = product(s->turning, d_square, k);
        d_turning[k] = (d_stance_torque[k] - turning_times_d_square[k] - product_so_far(d_turning, s->square,
            k)) / s->square[0];
        d_turning_times_y_[k] = product(d_turning, s->y_, k);
        turning_times_y__2[k] = product(s->turning, t->y_, k);
        sum_plus_sum[k] = d->cosine * s->external_fx[k] + c->cosine * t->external_fx[k]
            + (d->sine * s->external_fy[k] + c->sine * t->external_fy[k]);
        d_friction_along[k] = with_constant(k, d->by_1_minus_is_own * s->friction[k]
            + c->by_1_minus_is_own * t->friction[k], d->is_own_times_own);
        d_friction_along_times_sum_2[k] = product(d_friction_along, s->sum_2, k);
        product_plus_product[k] = d->inverse_stribeck_velocity * (c->way * s->foot_vx[k])
            + c->inverse_stribeck_velocity * (d->way * s->foot_vx[k] + c->way * t->foot_vx[k]);
        fading_times_product_plus_product[k] = product(s->fading, product_plus_product, k);
        d_sum_2[k] = d->static_ratio_minus_by_1 * s->fading[k]
            - c->static_ratio_minus_by_1 * fading_times_product_plus_product[k];
        friction_along_times_d_sum_2[k] = drift_times(k, with_constant(0,
            c->by_1_minus_is_own * s->friction[0], c->is_own_times_own), with_constant(1,
            c->by_1_minus_is_own * s->friction[1], c->is_own_times_own), d_sum_2);
        d_way_times_slip_friction[k] = d->way * s->slip_friction[k]
            + c->way * (d_friction_along_times_sum_2[k] + friction_along_times_d_sum_2[k]);
        d_way_times_slip_friction_times_normal[k] = product(d_way_times_slip_friction, s->normal, k);
        d_axial_times_y_[k] = product(d_axial, s->y_, k);
        axial_times_y__2[k] = product(s->axial, t->y_, k);
        d_turning_times_x_[k] = product(d_turning, s->x_, k);
        turning_times_x__2[k] = product(s->turning, t->x_, k);
        d_normal[k] = with_constant(k, d_axial_times_y_[k] + axial_times_y__2[k] + (d_turning_times_x_[k]
            + turning_times_x__2[k]), d->foot_mass_times_gravity_times_cosine);
        way_times_slip_friction_times_d_normal[k] = product(s->way_times_slip_friction, d_normal, k);
        d_friction_force[k] = d_way_times_slip_friction_times_normal[k]
            + way_times_slip_friction_times_d_normal[k];
        sum_minus_sum[k] = d->cosine * s->external_fy[k] + c->cosine * t->external_fy[k]
            - (d->sine * s->external_fx[k] + c->sine * t->external_fx[k]);
        sum_plus_sum_times_foot_vx_plus_vx[k] = product(sum_plus_sum, s->foot_vx_plus_vx, k);
        d_foot_vx_plus_vx[k] = t->foot_vx[k] + t->vx[k];
        sum_times_d_foot_vx_plus_vx[k] = drift_times(k, c->cosine * s->external_fx[0]
            + c->sine * s->external_fy[0], c->cosine * s->external_fx[1] + c->sine * s->external_fy[1],
            d_foot_vx_plus_vx);
        sum_minus_sum_times_vy[k] = product(sum_minus_sum, s->vy, k);
        sum_times_vy_2[k] = drift_times(k, c->cosine * s->external_fy[0] - c->sine * s->external_fx[0],
            c->cosine * s->external_fy[1] - c->sine * s->external_fx[1], t->vy);
        length_rate_times_d_length_rate[k] = product(s->length_rate, d_length_rate, k);
        d_friction_force_times_foot_vx[k] = product(d_friction_force, s->foot_vx, k);
        friction_force_times_foot_vx_2[k] = product(s->friction_force, t->foot_vx, k);
        d_stance_torque_times_angle_rate[k] = product(d_stance_torque, s->angle_rate, k);
        x__times_vy_2[k] = product(t->x_, s->vy, k);
        x__times_vy_3[k] = product(s->x_, t->vy, k);
        y__times_vx_2[k] = product(t->y_, s->vx, k);
        y__times_vx_3[k] = product(s->y_, t->vx, k);
        angle_rate_times_d_square[k] = product(s->angle_rate, d_square, k);
        d_angle_rate[k] = (x__times_vy_2[k] + x__times_vy_3[k] - (y__times_vx_2[k] + y__times_vx_3[k])
            - angle_rate_times_d_square[k] - product_so_far(d_angle_rate, s->square, k)) / s->square[0];
        stance_torque_times_d_angle_rate[k] = drift_times(k, with_constant(0, s->external_torque[0],
            -c->product_2), with_constant(1, s->external_torque[1], -c->product_2), d_angle_rate);
        t->vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_x_[k] - s->turning_times_y_[k]
            + (c->cosine * s->external_fx[k] + c->sine * s->external_fy[k]))
            + c->inverse_body_mass * (d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k]) + sum_plus_sum[k]) - (d->inverse_foot_mass * (-(s->axial_times_x_[k]
            - s->turning_times_y_[k]) - s->friction_force[k])
            + c->inverse_foot_mass * (-(d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k])) - d_friction_force[k])), -d->gravity_times_sine
            - (-(d->inverse_foot_mass * c->foot_mass_times_gravity_times_sine)
            - c->inverse_foot_mass * d->foot_mass_times_gravity_times_sine)));
        t->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_body_mass * (s->axial_times_y_[k] + s->turning_times_x_[k]
            + (c->cosine * s->external_fy[k] - c->sine * s->external_fx[k]))
            + c->inverse_body_mass * (d_axial_times_y_[k] + axial_times_y__2[k] + (d_turning_times_x_[k]
            + turning_times_x__2[k]) + sum_minus_sum[k]), -d->gravity_times_cosine));
        t->foot_vx[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_foot_mass * (-(s->axial_times_x_[k] - s->turning_times_y_[k]) - s->friction_force[k])
            + c->inverse_foot_mass * (-(d_axial_times_x_[k] + axial_times_x__2[k] - (d_turning_times_y_[k]
            + turning_times_y__2[k])) - d_friction_force[k]),
            -(d->inverse_foot_mass * c->foot_mass_times_gravity_times_sine)
            - c->inverse_foot_mass * d->foot_mass_times_gravity_times_sine));
        t->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->stiffness_times_extension_rate * (s->extension[k] - s->length[k])
            + c->stiffness_times_extension_rate * (t->extension[k] - d_length[k]),
            d->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness_times_extension_rate * (d->free_length + d->thrusting_times_longer_or_by_0)));
        t->external_work[k + 1] = series_reciprocal[k + 1] * (sum_plus_sum_times_foot_vx_plus_vx[k]
            + sum_times_d_foot_vx_plus_vx[k] + (sum_minus_sum_times_vy[k] + sum_times_vy_2[k]));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_d_length_rate[k]));
        t->friction_loss[k + 1] = series_reciprocal[k + 1] * (d_friction_force_times_foot_vx[k]
            + friction_force_times_foot_vx_2[k]);
        t->work[k + 1] = series_reciprocal[k + 1] * (d_stance_torque_times_angle_rate[k]
            + stance_torque_times_d_angle_rate[k]);
        t->extension[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->extension_rate));
        t->external_fx[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fx_rate));
        t->external_fy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fy_rate));
        t->friction[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->friction_rate));
        t->external_torque[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_torque_rate));
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->seen_angle[k + 1] = series_reciprocal[k + 1] * (d_angle_rate[k]);
    }
}

/* First variation of power_of_hip. */
static void d_observed_slip_falling_power_of_hip(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_falling_series *t = (const void *)d_series;
    (void)constants, (void)series, (void)d_constants;
    for (int k = 0; k < order; ++k) {
        dg[k] = (double)(k + 1) * t->work[k + 1];
    }
}

/* First variation of vertical_force_on_foot. */
static void d_observed_slip_falling_vertical_force_on_foot(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    const slip_falling_constants *d = (const void *)d_constants;
    const slip_falling_series *t = (const void *)d_series;
    real own_x__times_x__2[TERMS], own_y__times_y__2[TERMS], own_d_length[TERMS], own_d_length_rate[TERMS],
        own_axial_times_d_length[TERMS], own_d_axial[TERMS], own_d_axial_times_y_[TERMS],
        own_axial_times_y__2[TERMS], own_turning_times_d_square[TERMS], own_d_turning[TERMS],
        own_d_turning_times_x_[TERMS], own_turning_times_x__2[TERMS], own_d_friction_along_times_sum_2[TERMS],
        own_fading_times_product_plus_product[TERMS], own_friction_along_times_d_sum_2[TERMS],
        own_d_way_times_slip_friction_times_normal[TERMS], own_way_times_slip_friction_times_d_normal[TERMS],
        own_d_square[TERMS], own_d_friction_along[TERMS], own_product_plus_product[TERMS], own_d_sum_2[TERMS],
        own_d_way_times_slip_friction[TERMS], own_d_normal[TERMS];
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
        own_d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - own_d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * own_d_length_rate[k]) - own_axial_times_d_length[k],
            d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, t->external_torque[k] - own_turning_times_d_square[k],
            -d->product_2) - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        own_d_normal[k] = with_constant(k, own_d_axial_times_y_[k] + own_axial_times_y__2[k]
            + (own_d_turning_times_x_[k] + own_turning_times_x__2[k]),
            d->foot_mass_times_gravity_times_cosine);
        own_d_friction_along[k] = with_constant(k, d->by_1_minus_is_own * s->friction[k]
            + c->by_1_minus_is_own * t->friction[k], d->is_own_times_own);
        own_d_friction_along_times_sum_2[k] = product(own_d_friction_along, s->sum_2, k);
        own_product_plus_product[k] = d->inverse_stribeck_velocity * (c->way * s->foot_vx[k])
            + c->inverse_stribeck_velocity * (d->way * s->foot_vx[k] + c->way * t->foot_vx[k]);
        own_fading_times_product_plus_product[k] = product(s->fading, own_product_plus_product, k);
        own_d_sum_2[k] = d->static_ratio_minus_by_1 * s->fading[k]
            - c->static_ratio_minus_by_1 * own_fading_times_product_plus_product[k];
        own_friction_along_times_d_sum_2[k] = drift_times(k, with_constant(0,
            c->by_1_minus_is_own * s->friction[0], c->is_own_times_own), with_constant(1,
            c->by_1_minus_is_own * s->friction[1], c->is_own_times_own), own_d_sum_2);
        own_d_way_times_slip_friction[k] = d->way * s->slip_friction[k]
            + c->way * (own_d_friction_along_times_sum_2[k] + own_friction_along_times_d_sum_2[k]);
        own_d_way_times_slip_friction_times_normal[k] = product(own_d_way_times_slip_friction, s->normal, k);
        own_way_times_slip_friction_times_d_normal[k] = product(s->way_times_slip_friction, own_d_normal, k);
        dg[k] = d->cosine * s->normal[k] + c->cosine * own_d_normal[k] - (d->sine * s->friction_force[k]
            + c->sine * (own_d_way_times_slip_friction_times_normal[k]
            + own_way_times_slip_friction_times_d_normal[k]));
    }
}

/* First variation of force_on_foot. */
static void d_observed_slip_falling_force_on_foot(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    const slip_falling_constants *d = (const void *)d_constants;
    const slip_falling_series *t = (const void *)d_series;
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
        own_d_axial[k] = (with_constant(k, d->stiffness * (s->extension[k] - s->length[k])
            + c->stiffness * (t->extension[k] - own_d_length[k]) - (d->damping * s->length_rate[k]
            + c->damping * own_d_length_rate[k]) - own_axial_times_d_length[k],
            d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))
            - product_so_far(own_d_axial, s->length, k)) / s->length[0];
        own_d_axial_times_y_[k] = product(own_d_axial, s->y_, k);
        own_axial_times_y__2[k] = product(s->axial, t->y_, k);
        own_turning_times_d_square[k] = product(s->turning, own_d_square, k);
        own_d_turning[k] = (with_constant(k, t->external_torque[k] - own_turning_times_d_square[k],
            -d->product_2) - product_so_far(own_d_turning, s->square, k)) / s->square[0];
        own_d_turning_times_x_[k] = product(own_d_turning, s->x_, k);
        own_turning_times_x__2[k] = product(s->turning, t->x_, k);
        dg[k] = with_constant(k, own_d_axial_times_y_[k] + own_axial_times_y__2[k]
            + (own_d_turning_times_x_[k] + own_turning_times_x__2[k]),
            d->foot_mass_times_gravity_times_cosine);
    }
}

/* First variation of slip_velocity. */
static void d_observed_slip_falling_slip_velocity(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    const slip_falling_constants *d = (const void *)d_constants;
    const slip_falling_series *t = (const void *)d_series;
    for (int k = 0; k < order; ++k) {
        dg[k] = d->way * s->foot_vx[k] + c->way * t->foot_vx[k];
    }
}

/* First variation of square_of_torque. */
static void d_observed_slip_falling_square_of_torque(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    const slip_falling_constants *d = (const void *)d_constants;
    const slip_falling_series *t = (const void *)d_series;
    real own_stance_torque_times_d_stance_torque[TERMS], own_d_stance_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_d_stance_torque[k] = with_constant(k, t->external_torque[k], -d->product_2);
        own_stance_torque_times_d_stance_torque[k] = drift_times(k, with_constant(0, s->external_torque[0],
            -c->product_2), with_constant(1, s->external_torque[1], -c->product_2), own_d_stance_torque);
        dg[k] = 2.0 * own_stance_torque_times_d_stance_torque[k];
    }
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static void guard_slip_falling_ramp_ends(const real *constants, const real *series, int order, real *g) {
    const slip_falling_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->friction[k];
    }
}

/* falls: The body reaches the ground. */
static void guard_slip_falling_falls(const real *constants, const real *series, int order, real *g) {
    const slip_falling_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->y_[k];
    }
}

/* collapses: The leg is shorter than leg.min_length. */
static void guard_slip_falling_collapses(const real *constants, const real *series, int order, real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->length[k], -c->least_length);
    }
}

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. A thrust of 0 is not
 * counted. */
static void guard_slip_falling_greatest_compression(const real *constants, const real *series, int order,
    real *g) {
    const slip_falling_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = -s->length_rate[k];
    }
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static void guard_slip_falling_mid_stance(const real *constants, const real *series, int order, real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->seen_angle[k], c->winding);
    }
}

/* lift_off: The normal force ends: flight if the flight law lifts the foot, too, else graze. A foot that is
 * hardly lifted grazes, too: the guard of its flight decides by its rate. Not so below an upright leg, whose
 * torque does not act along the normal. */
static void guard_slip_falling_lift_off(const real *constants, const real *series, int order, real *g) {
    const slip_falling_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->normal[k];
    }
}

/* leaves_layer: Slip is fast enough for friction to be constant. */
static void guard_slip_falling_leaves_layer(const real *constants, const real *series, int order, real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(c->inverse_stribeck_velocity_or_by_1 * (c->way * s->foot_vx[k])),
            broadcast(61.0));
    }
}

/* comes_to_rest: The slip velocity reaches 0: the foot sticks, or slips the other way. */
static void guard_slip_falling_comes_to_rest(const real *constants, const real *series, int order, real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->way * s->foot_vx[k];
    }
}

/* crosses_border: The foot slips onto the next segment, whose line waits until the foot lifts off. */
static void guard_slip_falling_crosses_border(const real *constants, const real *series, int order, real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(c->way * (c->cosine * s->foot_x[k])),
            c->way * c->segment_end_or_segment_begin);
    }
}

/* power_of_hip: Power of the total hip torque. */
static void guard_slip_falling_power_of_hip(const real *constants, const real *series, int order, real *g) {
    const slip_falling_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->work[k + 1];
    }
}

/* vertical_force_on_foot: Vertical force of the ground on a sticking or slipping foot. */
static void guard_slip_falling_vertical_force_on_foot(const real *constants, const real *series, int order,
    real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->cosine * s->normal[k] - c->sine * s->friction_force[k];
    }
}

/* force_on_foot: Normal force of a sticking or slipping foot. */
static void guard_slip_falling_force_on_foot(const real *constants, const real *series, int order, real *g) {
    const slip_falling_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->normal[k];
    }
}

/* slip_velocity: Speed at which the foot slips. */
static void guard_slip_falling_slip_velocity(const real *constants, const real *series, int order, real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->way * s->foot_vx[k];
    }
}

/* square_of_torque: Square of the total hip torque. */
static void guard_slip_falling_square_of_torque(const real *constants, const real *series, int order,
    real *g) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    real own_stance_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_stance_torque[k] = with_constant(k, s->external_torque[k], -c->product_2);
        g[k] = drift_times(k, own_stance_torque[0], own_stance_torque[1], own_stance_torque);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_slip_falling(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const slip_falling_constants *c = (const void *)constants;
    const slip_falling_series *s = (const void *)series;
    const interval span_0 = interval_of_series(s->y_, power, order);
    bounds[1] = span_0;
    const interval span_1 = interval_of_series(s->length, power, order);
    const interval span_2 = interval_at(c->least_length, c->least_length);
    const interval span_3 = interval_difference(span_1, span_2);
    bounds[2] = span_3;
    const interval span_4 = interval_of_series(s->normal, power, order);
    bounds[5] = span_4;
    const interval span_5 = interval_at(broadcast(61.0), broadcast(61.0));
    const interval span_6 = interval_at(c->inverse_stribeck_velocity_or_by_1,
        c->inverse_stribeck_velocity_or_by_1);
    const interval span_7 = interval_at(c->way, c->way);
    const interval span_8 = interval_of_series(s->foot_vx, power, order);
    const interval span_9 = interval_product(span_7, span_8);
    const interval span_10 = interval_product(span_6, span_9);
    const interval span_11 = interval_difference(span_5, span_10);
    bounds[6] = span_11;
    bounds[7] = span_9;
    if (watched >> 0 & 1) {
        const interval span_12 = interval_of_series(s->friction, power, 2);
        bounds[0] = span_12;
    }
    if (watched >> 3 & 1) {
        const interval span_12 = interval_of_series(s->length_rate, power, order);
        const interval span_13 = interval_at(-span_12.high, -span_12.low);
        bounds[3] = span_13;
    }
    if (watched >> 4 & 1) {
        const interval span_12 = interval_of_series(s->seen_angle, power, order);
        const interval span_13 = interval_at(c->winding, c->winding);
        const interval span_14 = interval_sum(span_12, span_13);
        bounds[4] = span_14;
    }
    if (watched >> 8 & 1) {
        const interval span_12 = interval_at(c->segment_end_or_segment_begin,
            c->segment_end_or_segment_begin);
        const interval span_13 = interval_at(c->cosine, c->cosine);
        const interval span_14 = interval_of_series(s->foot_x, power, order);
        const interval span_15 = interval_product(span_13, span_14);
        const interval span_16 = interval_difference(span_12, span_15);
        const interval span_17 = interval_product(span_7, span_16);
        bounds[8] = span_17;
    }
    if (watched >> 10 & 1) {
        const interval span_12 = interval_at(c->cosine, c->cosine);
        const interval span_13 = interval_product(span_12, span_4);
        const interval span_14 = interval_at(c->sine, c->sine);
        const interval span_15 = interval_of_series(s->friction_force, power, order);
        const interval span_16 = interval_product(span_14, span_15);
        const interval span_17 = interval_difference(span_13, span_16);
        bounds[10] = span_17;
    }
    if (watched >> 11 & 1) {
        bounds[11] = span_4;
    }
    if (watched >> 12 & 1) {
        bounds[12] = span_9;
    }
    if (watched >> 13 & 1) {
        const interval span_12 = interval_of_series(s->external_torque, power, 2);
        const interval span_13 = interval_at(c->product_2, c->product_2);
        const interval span_14 = interval_difference(span_12, span_13);
        const interval span_15 = interval_square(span_14);
        bounds[13] = span_15;
    }
}

/* ---- flight_pushed */

/* The centre of mass is ballistic; the leg obeys rddot = r w^2 + M F_s and d(r^2 w)/dt = M tau. */
typedef struct {
    real length[TERMS], angle[TERMS], length_rate[TERMS], com_x[TERMS], com_y[TERMS], com_vx[TERMS],
        com_vy[TERMS], momentum[TERMS], leg_work[TERMS], external_work[TERMS], damper_loss[TERMS],
        work[TERMS], extension[TERMS], external_fx[TERMS], external_fy[TERMS], friction[TERMS],
        external_torque[TERMS], time[TERMS], placing[TERMS], square[TERMS], rate[TERMS],
        rate_times_rate[TERMS], length_times_rate_times_rate[TERMS], cosine[TERMS],
        external_fy_times_cosine[TERMS], sine[TERMS], external_fx_times_sine[TERMS], axial[TERMS],
        swing_torque[TERMS], external_fx_times_cosine[TERMS], external_fy_times_sine[TERMS], sum_2[TERMS],
        length_times_sum[TERMS], external_fx_times_com_vx[TERMS], external_fy_times_com_vy[TERMS],
        length_rate_times_axial[TERMS], rate_times_length_times_sum[TERMS],
        length_rate_times_length_rate[TERMS], power_of_hip[TERMS];
} flight_pushed_series;

typedef struct {
    pair square, rate, rate_times_rate, length_times_rate_times_rate, length_times_sum,
        length_rate_times_axial, rate_times_length_times_sum, length_rate_times_length_rate, power_of_hip;
} flight_pushed_sums;

typedef struct {
    real inverse_square;
} flight_pushed_factors;

/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_flight_pushed_sums(const flight_pushed_series *s, int i, int j, flight_pushed_sums *sum) {
    add_products(&sum->square, s->length + i - 1, s->length[j]);
    add_both_products(&sum->rate, s->rate, s->square, i, j);
    add_products(&sum->rate_times_rate, s->rate + i - 1, s->rate[j]);
    add_both_products(&sum->length_times_rate_times_rate, s->length, s->rate_times_rate, i, j);
    add_both_products(&sum->length_times_sum, s->length, s->sum_2, i, j);
    add_both_products(&sum->length_rate_times_axial, s->length_rate, s->axial, i, j);
    add_both_products(&sum->rate_times_length_times_sum, s->rate, s->length_times_sum, i, j);
    add_products(&sum->length_rate_times_length_rate, s->length_rate + i - 1, s->length_rate[j]);
    add_both_products(&sum->power_of_hip, s->swing_torque, s->rate, i, j);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_flight_pushed_sums(const flight_pushed_series *s, int i, flight_pushed_sums *sum) {
    sum->square = middle_of_square(s->length, i);
    sum->rate = middle_of_product(s->rate, s->square, i);
    sum->rate_times_rate = middle_of_square(s->rate, i);
    sum->length_times_rate_times_rate = middle_of_product(s->length, s->rate_times_rate, i);
    sum->length_times_sum = middle_of_product(s->length, s->sum_2, i);
    sum->length_rate_times_axial = middle_of_product(s->length_rate, s->axial, i);
    sum->rate_times_length_times_sum = middle_of_product(s->rate, s->length_times_sum, i);
    sum->length_rate_times_length_rate = middle_of_square(s->length_rate, i);
    sum->power_of_hip = middle_of_product(s->swing_torque, s->rate, i);
}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_flight_pushed(const flight_pushed_constants *c, const flight_pushed_factors *by, int k,
    const flight_pushed_sums *sum, int odd, flight_pushed_series *s) {
    s->length[k + 1] = s->length_rate[k] * series_reciprocal[k + 1];
    s->com_x[k + 1] = s->com_vx[k] * series_reciprocal[k + 1];
    s->com_y[k + 1] = s->com_vy[k] * series_reciprocal[k + 1];
    /* square = length * length */
    s->square[k] = square_of(k, part_of(sum->square, odd), s->length);
    /* rate = momentum / square */
    s->rate[k] = quotient_of(k, part_of(sum->rate, odd), s->momentum[k], s->rate, s->square,
        by->inverse_square);
    /* rate_times_rate = rate * rate */
    s->rate_times_rate[k] = square_of(k, part_of(sum->rate_times_rate, odd), s->rate);
    /* length_times_rate_times_rate = length * rate_times_rate */
    s->length_times_rate_times_rate[k] = product_of(k, part_of(sum->length_times_rate_times_rate, odd),
        s->length, s->rate_times_rate);
    sine_and_cosine_by_rate(k, s->angle, s->rate, s->sine, s->cosine);
    /* external_fy_times_cosine = external_fy * cosine */
    s->external_fy_times_cosine[k] = drift_times(k, s->external_fy[0], s->external_fy[1], s->cosine);
    /* external_fx_times_sine = external_fx * sine */
    s->external_fx_times_sine[k] = drift_times(k, s->external_fx[0], s->external_fx[1], s->sine);
    /* axial = external_fy_times_cosine - external_fx_times_sine */
    s->axial[k] = s->external_fy_times_cosine[k] - s->external_fx_times_sine[k];
    /* swing_torque = external_torque + (-(c->share_times_kp * (angle - (c->first - c->turn * placing))) -
     * c->share_times_kd * (rate + c->turn)) */
    s->swing_torque[k] = with_constant(k, s->external_torque[k] + (-(c->share_times_kp * (s->angle[k]
        + c->turn * s->placing[k])) - c->share_times_kd * s->rate[k]), c->share_times_kp * c->first
        - c->share_times_kd * c->turn);
    /* external_fx_times_cosine = external_fx * cosine */
    s->external_fx_times_cosine[k] = drift_times(k, s->external_fx[0], s->external_fx[1], s->cosine);
    /* external_fy_times_sine = external_fy * sine */
    s->external_fy_times_sine[k] = drift_times(k, s->external_fy[0], s->external_fy[1], s->sine);
    /* sum_2 = external_fx_times_cosine + external_fy_times_sine */
    s->sum_2[k] = s->external_fx_times_cosine[k] + s->external_fy_times_sine[k];
    /* length_times_sum = length * sum_2 */
    s->length_times_sum[k] = product_of(k, part_of(sum->length_times_sum, odd), s->length, s->sum_2);
    /* external_fx_times_com_vx = external_fx * com_vx */
    s->external_fx_times_com_vx[k] = drift_times(k, s->external_fx[0], s->external_fx[1], s->com_vx);
    /* external_fy_times_com_vy = external_fy * com_vy */
    s->external_fy_times_com_vy[k] = drift_times(k, s->external_fy[0], s->external_fy[1], s->com_vy);
    /* length_rate_times_axial = length_rate * axial */
    s->length_rate_times_axial[k] = product_of(k, part_of(sum->length_rate_times_axial, odd), s->length_rate,
        s->axial);
    /* rate_times_length_times_sum = rate * length_times_sum */
    s->rate_times_length_times_sum[k] = product_of(k, part_of(sum->rate_times_length_times_sum, odd), s->rate,
        s->length_times_sum);
    /* length_rate_times_length_rate = length_rate * length_rate */
    s->length_rate_times_length_rate[k] = square_of(k, part_of(sum->length_rate_times_length_rate, odd),
        s->length_rate);
    /* power_of_hip = swing_torque * rate */
    s->power_of_hip[k] = product_of(k, part_of(sum->power_of_hip, odd), s->swing_torque, s->rate);
    s->angle[k + 1] = series_reciprocal[k + 1] * (s->rate[k]);
    s->length_rate[k + 1] = series_reciprocal[k + 1] * (with_constant(k, s->length_times_rate_times_rate[k]
        + c->mobility * (c->stiffness * (s->extension[k] - s->length[k]) - c->damping * s->length_rate[k])
        + c->inverse_body_mass * s->axial[k], c->mobility * (c->stiffness * (c->free_length
        + c->thrusting_times_longer_or_by_0))));
    s->com_vx[k + 1] = series_reciprocal[k + 1] * (c->inverse_total_mass * s->external_fx[k]);
    s->com_vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, c->inverse_total_mass * s->external_fy[k],
        -c->gravity));
    s->momentum[k + 1] = series_reciprocal[k + 1] * (c->mobility * s->swing_torque[k]
        - c->inverse_body_mass * s->length_times_sum[k]);
    s->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
        c->stiffness_times_extension_rate * (s->extension[k] - s->length[k]),
        c->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)));
    s->external_work[k + 1] = series_reciprocal[k + 1] * (s->external_fx_times_com_vx[k]
        + s->external_fy_times_com_vy[k]
        + c->by_1_minus_body_mass_over_total_mass * (s->length_rate_times_axial[k]
        - s->rate_times_length_times_sum[k]));
    s->damper_loss[k + 1] = series_reciprocal[k + 1] * (c->damping * s->length_rate_times_length_rate[k]);
    s->work[k + 1] = series_reciprocal[k + 1] * (s->power_of_hip[k]);
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_flight_pushed(const real *constants, int order, real *series) {
    const flight_pushed_constants copy = *(const flight_pushed_constants *)(const void *)constants,
        *c = &copy;
    flight_pushed_series *s = (void *)series;
    static const flight_pushed_sums none;
    flight_pushed_sums sum = none;
    s->extension[1] = c->extension_rate;
    s->external_fx[1] = c->external_fx_rate;
    s->external_fy[1] = c->external_fy_rate;
    s->friction[1] = c->friction_rate;
    s->external_torque[1] = c->external_torque_rate;
    s->time[1] = broadcast(1.0);
    s->placing[1] = c->is_placing;
    s->square[0] = s->length[0] * s->length[0];
    const flight_pushed_factors factors = {1.0 / s->square[0]}, *by = &factors;
    step_flight_pushed(c, by, 0, &sum, 0, s);
    begin_flight_pushed_sums(s, 0, &sum);
    step_flight_pushed(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {
        begin_flight_pushed_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_flight_pushed_sums(s, i, j, &sum);
        }
        step_flight_pushed(c, by, k, &sum, 0, s);
        add_flight_pushed_sums(s, 1, k, &sum);
        step_flight_pushed(c, by, k + 1, &sum, 1, s);
    }
}

/* First variation of the series. */
static void vary_flight_pushed(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    const flight_pushed_constants *d = (const void *)d_constants;
    flight_pushed_series *t = (void *)varied;
    real length_times_length[TERMS], rate_times_d_square[TERMS], d_rate[TERMS],
        length_times_rate_times_rate_2[TERMS], rate_times_d_rate[TERMS],
        length_times_d_rate_times_rate[TERMS], external_fy_times_cosine_2[TERMS], sine_times_angle[TERMS],
        external_fy_times_sine_times_angle[TERMS], external_fx_times_sine_2[TERMS], d_sine[TERMS],
        external_fx_times_d_sine[TERMS], length_times_sum_2[TERMS], external_fx_times_cosine_2[TERMS],
        external_fx_times_sine_times_angle[TERMS], external_fy_times_sine_2[TERMS],
        external_fy_times_d_sine[TERMS], length_times_d_sum_2[TERMS], external_fx_times_com_vx_2[TERMS],
        external_fx_times_com_vx_3[TERMS], external_fy_times_com_vy_2[TERMS],
        external_fy_times_com_vy_3[TERMS], length_rate_times_axial_2[TERMS], length_rate_times_d_axial[TERMS],
        d_rate_times_length_times_sum[TERMS], rate_times_d_length_times_sum[TERMS],
        length_rate_times_length_rate_2[TERMS], d_swing_torque_times_rate[TERMS],
        swing_torque_times_d_rate[TERMS], d_square[TERMS], d_rate_times_rate[TERMS], d_sum_2[TERMS],
        d_axial[TERMS], d_length_times_sum[TERMS], d_swing_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        t->length[k + 1] = t->length_rate[k] * series_reciprocal[k + 1];
        t->com_x[k + 1] = t->com_vx[k] * series_reciprocal[k + 1];
        t->com_y[k + 1] = t->com_vy[k] * series_reciprocal[k + 1];
        length_times_length[k] = product(s->length, t->length, k);
        d_square[k] = 2.0 * length_times_length[k];
        rate_times_d_square[k] = product(s->rate, d_square, k);
        d_rate[k] = (t->momentum[k] - rate_times_d_square[k] - product_so_far(d_rate, s->square,
            k)) / s->square[0];
        length_times_rate_times_rate_2[k] = product(t->length, s->rate_times_rate, k);
        rate_times_d_rate[k] = product(s->rate, d_rate, k);
        d_rate_times_rate[k] = 2.0 * rate_times_d_rate[k];
        length_times_d_rate_times_rate[k] = product(s->length, d_rate_times_rate, k);
        external_fy_times_cosine_2[k] = product(t->external_fy, s->cosine, k);
        sine_times_angle[k] = product(s->sine, t->angle, k);
        external_fy_times_sine_times_angle[k] = drift_times(k, s->external_fy[0], s->external_fy[1],
            sine_times_angle);
        external_fx_times_sine_2[k] = product(t->external_fx, s->sine, k);
        d_sine[k] = product(s->cosine, t->angle, k);
        external_fx_times_d_sine[k] = drift_times(k, s->external_fx[0], s->external_fx[1], d_sine);
        d_axial[k] = external_fy_times_cosine_2[k] - external_fy_times_sine_times_angle[k]
            - (external_fx_times_sine_2[k] + external_fx_times_d_sine[k]);
        d_swing_torque[k] = with_constant(k, t->external_torque[k] + (-(d->share_times_kp * (s->angle[k]
            + c->turn * s->placing[k]) + c->share_times_kp * (t->angle[k] + (d->turn * s->placing[k]
            + c->turn * t->placing[k]))) - (d->share_times_kd * s->rate[k] + c->share_times_kd * d_rate[k])),
            -(-(d->share_times_kp * c->first) - c->share_times_kp * d->first) - (d->share_times_kd * c->turn
            + c->share_times_kd * d->turn));
        length_times_sum_2[k] = product(t->length, s->sum_2, k);
        external_fx_times_cosine_2[k] = product(t->external_fx, s->cosine, k);
        external_fx_times_sine_times_angle[k] = drift_times(k, s->external_fx[0], s->external_fx[1],
            sine_times_angle);
        external_fy_times_sine_2[k] = product(t->external_fy, s->sine, k);
        external_fy_times_d_sine[k] = drift_times(k, s->external_fy[0], s->external_fy[1], d_sine);
        d_sum_2[k] = external_fx_times_cosine_2[k] - external_fx_times_sine_times_angle[k]
            + (external_fy_times_sine_2[k] + external_fy_times_d_sine[k]);
        length_times_d_sum_2[k] = product(s->length, d_sum_2, k);
        d_length_times_sum[k] = length_times_sum_2[k] + length_times_d_sum_2[k];
        external_fx_times_com_vx_2[k] = product(t->external_fx, s->com_vx, k);
        external_fx_times_com_vx_3[k] = drift_times(k, s->external_fx[0], s->external_fx[1], t->com_vx);
        external_fy_times_com_vy_2[k] = product(t->external_fy, s->com_vy, k);
        external_fy_times_com_vy_3[k] = drift_times(k, s->external_fy[0], s->external_fy[1], t->com_vy);
        length_rate_times_axial_2[k] = product(t->length_rate, s->axial, k);
        length_rate_times_d_axial[k] = product(s->length_rate, d_axial, k);
        d_rate_times_length_times_sum[k] = product(d_rate, s->length_times_sum, k);
        rate_times_d_length_times_sum[k] = product(s->rate, d_length_times_sum, k);
        length_rate_times_length_rate_2[k] = product(s->length_rate, t->length_rate, k);
        d_swing_torque_times_rate[k] = product(d_swing_torque, s->rate, k);
        swing_torque_times_d_rate[k] = product(s->swing_torque, d_rate, k);
        t->angle[k + 1] = series_reciprocal[k + 1] * (d_rate[k]);
        t->length_rate[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            length_times_rate_times_rate_2[k] + length_times_d_rate_times_rate[k]
            + (d->mobility * (c->stiffness * (s->extension[k] - s->length[k])
            - c->damping * s->length_rate[k]) + c->mobility * (d->stiffness * (s->extension[k]
            - s->length[k]) + c->stiffness * (t->extension[k] - t->length[k])
            - (d->damping * s->length_rate[k] + c->damping * t->length_rate[k])))
            + (d->inverse_body_mass * s->axial[k] + c->inverse_body_mass * d_axial[k]),
            d->mobility * (c->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0))
            + c->mobility * (d->stiffness * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness * (d->free_length + d->thrusting_times_longer_or_by_0))));
        t->com_vx[k + 1] = series_reciprocal[k + 1] * (d->inverse_total_mass * s->external_fx[k]
            + c->inverse_total_mass * t->external_fx[k]);
        t->com_vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->inverse_total_mass * s->external_fy[k] + c->inverse_total_mass * t->external_fy[k],
            -d->gravity));
        t->momentum[k + 1] = series_reciprocal[k + 1] * (d->mobility * s->swing_torque[k]
            + c->mobility * d_swing_torque[k] - (d->inverse_body_mass * s->length_times_sum[k]
            + c->inverse_body_mass * d_length_times_sum[k]));
        t->leg_work[k + 1] = series_reciprocal[k + 1] * (with_constant(k,
            d->stiffness_times_extension_rate * (s->extension[k] - s->length[k])
            + c->stiffness_times_extension_rate * (t->extension[k] - t->length[k]),
            d->stiffness_times_extension_rate * (c->free_length + c->thrusting_times_longer_or_by_0)
            + c->stiffness_times_extension_rate * (d->free_length + d->thrusting_times_longer_or_by_0)));
        t->external_work[k + 1] = series_reciprocal[k + 1] * (external_fx_times_com_vx_2[k]
            + external_fx_times_com_vx_3[k] + (external_fy_times_com_vy_2[k]
            + external_fy_times_com_vy_3[k])
            + (d->by_1_minus_body_mass_over_total_mass * (s->length_rate_times_axial[k]
            - s->rate_times_length_times_sum[k])
            + c->by_1_minus_body_mass_over_total_mass * (length_rate_times_axial_2[k]
            + length_rate_times_d_axial[k] - (d_rate_times_length_times_sum[k]
            + rate_times_d_length_times_sum[k]))));
        t->damper_loss[k + 1] = series_reciprocal[k + 1] * (d->damping * s->length_rate_times_length_rate[k]
            + c->damping * (2.0 * length_rate_times_length_rate_2[k]));
        t->work[k + 1] = series_reciprocal[k + 1] * (d_swing_torque_times_rate[k]
            + swing_torque_times_d_rate[k]);
        t->extension[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->extension_rate));
        t->external_fx[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fx_rate));
        t->external_fy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_fy_rate));
        t->friction[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->friction_rate));
        t->external_torque[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->external_torque_rate));
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->placing[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->is_placing));
    }
}

/* First variation of power_of_hip. */
static void d_observed_flight_pushed_power_of_hip(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const flight_pushed_series *t = (const void *)d_series;
    (void)constants, (void)series, (void)d_constants;
    for (int k = 0; k < order; ++k) {
        dg[k] = (double)(k + 1) * t->work[k + 1];
    }
}

/* First variation of height_of_foot. */
static void d_observed_flight_pushed_height_of_foot(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    const flight_pushed_constants *d = (const void *)d_constants;
    const flight_pushed_series *t = (const void *)d_series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_2[TERMS],
        own_sum_times_cos_of_angle_minus_slope[TERMS], own_sin_of_angle_minus_slope[TERMS],
        own_product_3[TERMS], own_product_4[TERMS], own_angle_minus_slope[TERMS],
        own_body_mass_over_total_mass_times_length[TERMS], own_sum_3[TERMS], own_angle_minus_slope_2[TERMS];
    for (int k = 0; k < order; ++k) {
        own_body_mass_over_total_mass_times_length[k] = c->body_mass_over_total_mass * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_2[k] = product(own_body_mass_over_total_mass_times_length, own_cos_of_angle_minus_slope,
            k);
        own_sum_3[k] = d->body_mass_over_total_mass * s->length[k]
            + c->body_mass_over_total_mass * t->length[k];
        own_sum_times_cos_of_angle_minus_slope[k] = product(own_sum_3, own_cos_of_angle_minus_slope, k);
        own_angle_minus_slope_2[k] = with_constant(k, t->angle[k], -d->slope);
        own_product_3[k] = product(own_sin_of_angle_minus_slope, own_angle_minus_slope_2, k);
        own_product_4[k] = product(own_body_mass_over_total_mass_times_length, own_product_3, k);
        dg[k] = with_constant(k, d->inverse_cos_of_slope * (c->cos_of_slope * s->com_y[k]
            - c->sin_of_slope * s->com_x[k] - own_product_2[k])
            + c->inverse_cos_of_slope * (d->cos_of_slope * s->com_y[k] + c->cos_of_slope * t->com_y[k]
            - (d->sin_of_slope * s->com_x[k] + c->sin_of_slope * t->com_x[k])
            - (own_sum_times_cos_of_angle_minus_slope[k] - own_product_4[k])),
            c->inverse_cos_of_slope * (-(d->cos_of_slope * c->height) - c->cos_of_slope * d->height)
            - d->inverse_cos_of_slope * (c->cos_of_slope * c->height));
    }
}

/* First variation of square_of_torque. */
static void d_observed_flight_pushed_square_of_torque(const real *constants, const real *series,
    const real *d_constants, const real *d_series, int order, real *dg) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    const flight_pushed_constants *d = (const void *)d_constants;
    const flight_pushed_series *t = (const void *)d_series;
    real own_length_times_length[TERMS], own_rate_times_d_square[TERMS], own_d_rate[TERMS],
        own_swing_torque_times_d_swing_torque[TERMS], own_d_square[TERMS], own_d_swing_torque[TERMS];
    for (int k = 0; k < order; ++k) {
        own_length_times_length[k] = product(s->length, t->length, k);
        own_d_square[k] = 2.0 * own_length_times_length[k];
        own_rate_times_d_square[k] = product(s->rate, own_d_square, k);
        own_d_rate[k] = (t->momentum[k] - own_rate_times_d_square[k] - product_so_far(own_d_rate, s->square,
            k)) / s->square[0];
        own_d_swing_torque[k] = with_constant(k, t->external_torque[k] + (-(d->share_times_kp * (s->angle[k]
            + c->turn * s->placing[k]) + c->share_times_kp * (t->angle[k] + (d->turn * s->placing[k]
            + c->turn * t->placing[k]))) - (d->share_times_kd * s->rate[k]
            + c->share_times_kd * own_d_rate[k])), -(-(d->share_times_kp * c->first)
            - c->share_times_kp * d->first) - (d->share_times_kd * c->turn + c->share_times_kd * d->turn));
        own_swing_torque_times_d_swing_torque[k] = product(s->swing_torque, own_d_swing_torque, k);
        dg[k] = 2.0 * own_swing_torque_times_d_swing_torque[k];
    }
}

/* passes_end: The foot is above the next segment. */
static void guard_flight_pushed_passes_end(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    real own_length_times_sine[TERMS];
    for (int k = 0; k < order; ++k) {
        own_length_times_sine[k] = product(s->length, s->sine, k);
        g[k] = with_constant(k, -(s->com_x[k] + c->body_mass_over_total_mass * own_length_times_sine[k]),
            c->segment_end);
    }
}

/* passes_begin: The foot is above the segment before. */
static void guard_flight_pushed_passes_begin(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    real own_length_times_sine[TERMS];
    for (int k = 0; k < order; ++k) {
        own_length_times_sine[k] = product(s->length, s->sine, k);
        g[k] = with_constant(k, s->com_x[k] + c->body_mass_over_total_mass * own_length_times_sine[k],
            -c->segment_begin);
    }
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static void guard_flight_pushed_ramp_ends(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = s->friction[k];
    }
}

/* new_ground: The foot is above the pending ground line, which comes into force. */
static void guard_flight_pushed_new_ground(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    real own_cos_of_angle_minus_set_slope[TERMS], own_product_2[TERMS],
        own_sin_of_angle_minus_set_slope[TERMS], own_angle_minus_set_slope[TERMS],
        own_body_mass_over_total_mass_times_length[TERMS];
    for (int k = 0; k < order; ++k) {
        own_body_mass_over_total_mass_times_length[k] = c->body_mass_over_total_mass * s->length[k];
        own_angle_minus_set_slope[k] = with_constant(k, s->angle[k], -c->set_slope);
        sine_and_cosine_of(k, own_angle_minus_set_slope, own_sin_of_angle_minus_set_slope,
            own_cos_of_angle_minus_set_slope);
        own_product_2[k] = product(own_body_mass_over_total_mass_times_length,
            own_cos_of_angle_minus_set_slope, k);
        g[k] = with_constant(k, -(c->cos_of_set_slope * s->com_y[k] - c->sin_of_set_slope * s->com_x[k]
            - own_product_2[k]), c->cos_of_set_slope * c->set_height);
    }
}

/* falls: The body reaches the ground. */
static void guard_flight_pushed_falls(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_times_cos_of_angle_minus_slope[TERMS],
        own_sin_of_angle_minus_slope[TERMS], own_angle_minus_slope[TERMS], own_product_2[TERMS];
    for (int k = 0; k < order; ++k) {
        own_product_2[k] = c->by_1_minus_body_mass_over_total_mass * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_times_cos_of_angle_minus_slope[k] = product(own_product_2, own_cos_of_angle_minus_slope,
            k);
        g[k] = with_constant(k, c->cos_of_slope * s->com_y[k] - c->sin_of_slope * s->com_x[k]
            + own_product_times_cos_of_angle_minus_slope[k], -(c->cos_of_slope * c->height));
    }
}

/* collapses: The leg is shorter than leg.min_length. */
static void guard_flight_pushed_collapses(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, s->length[k], -c->least_length);
    }
}

/* apex: A stride closes and place begins. An external force can cause further apices in place. */
static void guard_flight_pushed_apex(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->com_y[k + 1];
    }
}

/* touchdown: The foot reaches the ground. Where the lift of the flight law vanishes, shorter and shorter
 * hops follow each other. After one of no time the foot grazes, until the flight law has ceased to lift it
 * and lifts it again. */
static void guard_flight_pushed_touchdown(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_2[TERMS], own_sin_of_angle_minus_slope[TERMS],
        own_angle_minus_slope[TERMS], own_body_mass_over_total_mass_times_length[TERMS];
    for (int k = 0; k < order; ++k) {
        own_body_mass_over_total_mass_times_length[k] = c->body_mass_over_total_mass * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_2[k] = product(own_body_mass_over_total_mass_times_length, own_cos_of_angle_minus_slope,
            k);
        g[k] = with_constant(k, c->cos_of_slope * s->com_y[k] - c->sin_of_slope * s->com_x[k]
            - own_product_2[k], -(c->cos_of_slope * c->height));
    }
}

/* clamp: The clamp of the hip torque closes: it holds the retracting torque at 0. */
static void guard_flight_pushed_clamp(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(c->kp * s->angle[k]) - c->kd * s->rate[k],
            c->kp * c->liftoff_factor_times_liftoff_angle);
    }
}

/* release: The clamp of the hip torque opens: it releases the retracting torque. */
static void guard_flight_pushed_release(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -(-(c->kp * s->angle[k]) - c->kd * s->rate[k]),
            -(c->kp * c->liftoff_factor_times_liftoff_angle));
    }
}

/* power_of_hip: Power of the total hip torque. */
static void guard_flight_pushed_power_of_hip(const real *constants, const real *series, int order, real *g) {
    const flight_pushed_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->work[k + 1];
    }
}

/* height_of_foot: Height of the foot above the ground vertically below. */
static void guard_flight_pushed_height_of_foot(const real *constants, const real *series, int order,
    real *g) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    real own_cos_of_angle_minus_slope[TERMS], own_product_2[TERMS], own_sin_of_angle_minus_slope[TERMS],
        own_angle_minus_slope[TERMS], own_body_mass_over_total_mass_times_length[TERMS];
    for (int k = 0; k < order; ++k) {
        own_body_mass_over_total_mass_times_length[k] = c->body_mass_over_total_mass * s->length[k];
        own_angle_minus_slope[k] = with_constant(k, s->angle[k], -c->slope);
        sine_and_cosine_of(k, own_angle_minus_slope, own_sin_of_angle_minus_slope,
            own_cos_of_angle_minus_slope);
        own_product_2[k] = product(own_body_mass_over_total_mass_times_length, own_cos_of_angle_minus_slope,
            k);
        g[k] = with_constant(k, c->inverse_cos_of_slope * (c->cos_of_slope * s->com_y[k]
            - c->sin_of_slope * s->com_x[k] - own_product_2[k]),
            -(c->inverse_cos_of_slope * (c->cos_of_slope * c->height)));
    }
}

/* square_of_torque: Square of the total hip torque. */
static void guard_flight_pushed_square_of_torque(const real *constants, const real *series, int order,
    real *g) {
    const flight_pushed_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = product(s->swing_torque, s->swing_torque, k);
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_flight_pushed(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const flight_pushed_constants *c = (const void *)constants;
    const flight_pushed_series *s = (const void *)series;
    const interval span_0 = interval_at(c->cos_of_slope, c->cos_of_slope);
    const interval span_1 = interval_of_series(s->com_y, power, 4);
    const interval span_2 = interval_at(c->height, c->height);
    const interval span_3 = interval_difference(span_1, span_2);
    const interval span_4 = interval_product(span_0, span_3);
    const interval span_5 = interval_at(c->sin_of_slope, c->sin_of_slope);
    const interval span_6 = interval_of_series(s->com_x, power, 4);
    const interval span_7 = interval_product(span_5, span_6);
    const interval span_8 = interval_difference(span_4, span_7);
    const interval span_9 = interval_at(c->by_1_minus_body_mass_over_total_mass,
        c->by_1_minus_body_mass_over_total_mass);
    const interval span_10 = interval_of_series(s->length, power, order);
    const interval span_11 = interval_product(span_9, span_10);
    const interval span_12 = interval_at(broadcast(-1.0), broadcast(1.0));
    const interval span_13 = interval_product(span_11, span_12);
    const interval span_14 = interval_sum(span_8, span_13);
    bounds[4] = span_14;
    const interval span_15 = interval_at(c->least_length, c->least_length);
    const interval span_16 = interval_difference(span_10, span_15);
    bounds[5] = span_16;
    const interval span_17 = interval_of_rate(s->com_y, power, 3);
    bounds[6] = span_17;
    const interval span_18 = interval_at(c->body_mass_over_total_mass, c->body_mass_over_total_mass);
    const interval span_19 = interval_product(span_18, span_10);
    const interval span_20 = interval_product(span_19, span_12);
    const interval span_21 = interval_difference(span_8, span_20);
    bounds[7] = span_21;
    if (watched >> 0 & 1) {
        const interval span_22 = interval_at(c->segment_end, c->segment_end);
        const interval span_23 = interval_of_series(s->sine, power, order);
        const interval span_24 = interval_product(span_10, span_23);
        const interval span_25 = interval_product(span_18, span_24);
        const interval span_26 = interval_sum(span_6, span_25);
        const interval span_27 = interval_difference(span_22, span_26);
        bounds[0] = span_27;
    }
    if (watched >> 1 & 1) {
        const interval span_22 = interval_of_series(s->sine, power, order);
        const interval span_23 = interval_product(span_10, span_22);
        const interval span_24 = interval_product(span_18, span_23);
        const interval span_25 = interval_sum(span_6, span_24);
        const interval span_26 = interval_at(c->segment_begin, c->segment_begin);
        const interval span_27 = interval_difference(span_25, span_26);
        bounds[1] = span_27;
    }
    if (watched >> 2 & 1) {
        const interval span_22 = interval_of_series(s->friction, power, 2);
        bounds[2] = span_22;
    }
    if (watched >> 3 & 1) {
        const interval span_22 = interval_at(c->cos_of_set_slope, c->cos_of_set_slope);
        const interval span_23 = interval_at(c->set_height, c->set_height);
        const interval span_24 = interval_difference(span_1, span_23);
        const interval span_25 = interval_product(span_22, span_24);
        const interval span_26 = interval_at(c->sin_of_set_slope, c->sin_of_set_slope);
        const interval span_27 = interval_product(span_26, span_6);
        const interval span_28 = interval_difference(span_25, span_27);
        const interval span_29 = interval_at(broadcast(-1.0), broadcast(1.0));
        const interval span_30 = interval_product(span_19, span_29);
        const interval span_31 = interval_difference(span_28, span_30);
        const interval span_32 = interval_at(-span_31.high, -span_31.low);
        bounds[3] = span_32;
    }
    if (watched >> 8 & 1) {
        const interval span_22 = interval_at(c->kp, c->kp);
        const interval span_23 = interval_of_series(s->angle, power, order);
        const interval span_24 = interval_at(c->liftoff_factor_times_liftoff_angle,
            c->liftoff_factor_times_liftoff_angle);
        const interval span_25 = interval_difference(span_23, span_24);
        const interval span_26 = interval_product(span_22, span_25);
        const interval span_27 = interval_at(-span_26.high, -span_26.low);
        const interval span_28 = interval_at(c->kd, c->kd);
        const interval span_29 = interval_of_series(s->rate, power, order);
        const interval span_30 = interval_product(span_28, span_29);
        const interval span_31 = interval_difference(span_27, span_30);
        bounds[8] = span_31;
    }
    if (watched >> 9 & 1) {
        const interval span_22 = interval_at(c->kp, c->kp);
        const interval span_23 = interval_of_series(s->angle, power, order);
        const interval span_24 = interval_at(c->liftoff_factor_times_liftoff_angle,
            c->liftoff_factor_times_liftoff_angle);
        const interval span_25 = interval_difference(span_23, span_24);
        const interval span_26 = interval_product(span_22, span_25);
        const interval span_27 = interval_at(-span_26.high, -span_26.low);
        const interval span_28 = interval_at(c->kd, c->kd);
        const interval span_29 = interval_of_series(s->rate, power, order);
        const interval span_30 = interval_product(span_28, span_29);
        const interval span_31 = interval_difference(span_27, span_30);
        const interval span_32 = interval_at(-span_31.high, -span_31.low);
        bounds[9] = span_32;
    }
    if (watched >> 11 & 1) {
        const interval span_22 = interval_at(c->inverse_cos_of_slope, c->inverse_cos_of_slope);
        const interval span_23 = interval_product(span_22, span_21);
        bounds[11] = span_23;
    }
    if (watched >> 12 & 1) {
        const interval span_22 = interval_of_series(s->swing_torque, power, order);
        const interval span_23 = interval_square(span_22);
        bounds[12] = span_23;
    }
}

static const tdmf_polynomial polynomials_start_of_run[] = {guard_start_of_run_passes_end,
    guard_start_of_run_passes_begin, guard_start_of_run_begins};
static const tdmf_vary_polynomial vary_observed_start_of_run[] = {NULL};
static const int moving_start_of_run[] = {56, 57, 58, 87, 92, 0}, degrees_start_of_run[] = {1, 1, 1, 1, 1, 1},
    judged_start_of_run[] = {0}, divided_start_of_run[] = {0}, divisors_start_of_run[] = {0},
    integrals_start_of_run[] = {0}, factors_start_of_run[] = {0};
static const tdmf_polynomial polynomials_slip_constant[] = {guard_slip_constant_ramp_ends,
    guard_slip_constant_falls, guard_slip_constant_collapses, guard_slip_constant_greatest_compression,
    guard_slip_constant_mid_stance, guard_slip_constant_lift_off, guard_slip_constant_enters_layer,
    guard_slip_constant_comes_to_rest, guard_slip_constant_crosses_border, guard_slip_constant_power_of_hip,
    guard_slip_constant_vertical_force_on_foot, guard_slip_constant_force_on_foot,
    guard_slip_constant_slip_velocity, guard_slip_constant_square_of_torque};
static const tdmf_vary_polynomial vary_observed_slip_constant[] = {d_observed_slip_constant_power_of_hip,
    d_observed_slip_constant_vertical_force_on_foot, d_observed_slip_constant_force_on_foot,
    d_observed_slip_constant_slip_velocity, d_observed_slip_constant_square_of_torque};
static const int moving_slip_constant[] = {72, 73, 74, 75, 76, 77, 80, 82, 83, 89, 103, 56, 57, 58, 87, 92,
    0}, degrees_slip_constant[] = {99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 1, 1, 1, 1, 1, 1, 99},
    judged_slip_constant[] = {2, 3, 5, 6, 7, 8, 9, 10, 17}, divided_slip_constant[] = {-1, -1, -1, -1, -1, -1,
    -1, -1, -1}, divisors_slip_constant[] = {21, 20}, integrals_slip_constant[] = {10, -1, -1, -1, -1},
    factors_slip_constant[] = {39, -1, -1, -1, -1, -1, -1, -1, -1, -1};
static const tdmf_polynomial polynomials_stick[] = {guard_stick_ramp_ends, guard_stick_falls,
    guard_stick_collapses, guard_stick_greatest_compression, guard_stick_mid_stance, guard_stick_lift_off,
    guard_stick_slips_forward, guard_stick_slips_backward, guard_stick_power_of_hip,
    guard_stick_vertical_force_on_foot, guard_stick_force_on_foot, guard_stick_square_of_torque};
static const tdmf_vary_polynomial vary_observed_stick[] = {d_observed_stick_power_of_hip,
    d_observed_stick_vertical_force_on_foot, d_observed_stick_force_on_foot,
    d_observed_stick_square_of_torque};
static const int moving_stick[] = {72, 73, 74, 75, 80, 82, 83, 103, 56, 57, 58, 87, 92, 0, 76},
    degrees_stick[] = {99, 99, 99, 99, 99, 99, 99, 99, 1, 1, 1, 1, 1, 1, 1, 99}, judged_stick[] = {2, 3, 4, 5,
    6, 7, 15}, divided_stick[] = {-1, -1, -1, -1, -1, -1, -1}, divisors_stick[] = {19, 18},
    integrals_stick[] = {7, -1, -1, -1}, factors_stick[] = {34, -1, -1, -1, -1, -1, -1, -1};
static const tdmf_polynomial polynomials_flight_calm[] = {guard_flight_calm_passes_end,
    guard_flight_calm_passes_begin, guard_flight_calm_ramp_ends, guard_flight_calm_wind_rises,
    guard_flight_calm_new_ground, guard_flight_calm_falls, guard_flight_calm_collapses,
    guard_flight_calm_apex, guard_flight_calm_touchdown, guard_flight_calm_clamp, guard_flight_calm_release,
    guard_flight_calm_power_of_hip, guard_flight_calm_height_of_foot, guard_flight_calm_square_of_torque};
static const tdmf_vary_polynomial vary_observed_flight_calm[] = {d_observed_flight_calm_power_of_hip,
    d_observed_flight_calm_height_of_foot, d_observed_flight_calm_square_of_torque};
static const int moving_flight_calm[] = {61, 62, 65, 68, 71, 80, 83, 103, 56, 57, 58, 87, 92, 0, 67, 70, 96},
    degrees_flight_calm[] = {99, 99, 99, 2, 99, 99, 99, 99, 1, 1, 1, 1, 1, 1, 1, 1, 1},
    judged_flight_calm[] = {1, 2, 4, 5, 6, 7}, divided_flight_calm[] = {-1, -1, 0, -1, -1, -1},
    divisors_flight_calm[] = {17}, integrals_flight_calm[] = {7, -1, -1}, factors_flight_calm[] = {21, 18, -1,
    -1, -1, -1};
static const tdmf_polynomial polynomials_fallen[] = {NULL};
static const tdmf_vary_polynomial vary_observed_fallen[] = {NULL};
static const int moving_fallen[] = {0}, degrees_fallen[] = {0}, judged_fallen[] = {0}, divided_fallen[] = {0},
    divisors_fallen[] = {0}, integrals_fallen[] = {0}, factors_fallen[] = {0};
static const tdmf_polynomial polynomials_graze[] = {guard_graze_passes_end, guard_graze_passes_begin,
    guard_graze_ramp_ends, guard_graze_falls, guard_graze_collapses, guard_graze_apex_in_graze,
    guard_graze_clamp, guard_graze_release, guard_graze_mid_stance, guard_graze_graze_to_contact,
    guard_graze_graze_to_flight, guard_graze_power_of_hip, guard_graze_square_of_torque};
static const tdmf_vary_polynomial vary_observed_graze[] = {d_observed_graze_power_of_hip,
    d_observed_graze_square_of_torque};
static const int moving_graze[] = {72, 73, 74, 75, 76, 77, 80, 82, 83, 103, 56, 57, 58, 87, 92, 0, 96},
    degrees_graze[] = {99, 3, 99, 2, 99, 99, 99, 99, 99, 99, 1, 1, 1, 1, 1, 1, 1, 99}, judged_graze[] = {2, 5,
    6, 7, 8, 9, 17}, divided_graze[] = {-1, -1, -1, -1, -1, -1, -1}, divisors_graze[] = {21, 0, 20},
    integrals_graze[] = {9, -1}, factors_graze[] = {32, 35, -1, -1};
static const tdmf_polynomial polynomials_slip_falling[] = {guard_slip_falling_ramp_ends,
    guard_slip_falling_falls, guard_slip_falling_collapses, guard_slip_falling_greatest_compression,
    guard_slip_falling_mid_stance, guard_slip_falling_lift_off, guard_slip_falling_leaves_layer,
    guard_slip_falling_comes_to_rest, guard_slip_falling_crosses_border, guard_slip_falling_power_of_hip,
    guard_slip_falling_vertical_force_on_foot, guard_slip_falling_force_on_foot,
    guard_slip_falling_slip_velocity, guard_slip_falling_square_of_torque};
static const tdmf_vary_polynomial vary_observed_slip_falling[] = {d_observed_slip_falling_power_of_hip,
    d_observed_slip_falling_vertical_force_on_foot, d_observed_slip_falling_force_on_foot,
    d_observed_slip_falling_slip_velocity, d_observed_slip_falling_square_of_torque};
static const int moving_slip_falling[] = {72, 73, 74, 75, 76, 77, 80, 82, 83, 89, 103, 56, 57, 58, 87, 92, 0},
    degrees_slip_falling[] = {99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 1, 1, 1, 1, 1, 1, 99},
    judged_slip_falling[] = {2, 3, 5, 6, 7, 8, 9, 10, 17}, divided_slip_falling[] = {-1, -1, -1, -1, -1, -1,
    -1, -1, -1}, divisors_slip_falling[] = {21, 20}, integrals_slip_falling[] = {10, -1, -1, -1, -1},
    factors_slip_falling[] = {44, -1, -1, -1, -1, -1, -1, -1, -1, -1};
static const tdmf_polynomial polynomials_flight_pushed[] = {guard_flight_pushed_passes_end,
    guard_flight_pushed_passes_begin, guard_flight_pushed_ramp_ends, guard_flight_pushed_new_ground,
    guard_flight_pushed_falls, guard_flight_pushed_collapses, guard_flight_pushed_apex,
    guard_flight_pushed_touchdown, guard_flight_pushed_clamp, guard_flight_pushed_release,
    guard_flight_pushed_power_of_hip, guard_flight_pushed_height_of_foot,
    guard_flight_pushed_square_of_torque};
static const tdmf_vary_polynomial vary_observed_flight_pushed[] = {d_observed_flight_pushed_power_of_hip,
    d_observed_flight_pushed_height_of_foot, d_observed_flight_pushed_square_of_torque};
static const int moving_flight_pushed[] = {61, 62, 65, 67, 68, 69, 70, 71, 80, 82, 83, 103, 56, 57, 58, 87,
    92, 0, 96}, degrees_flight_pushed[] = {99, 99, 99, 3, 3, 2, 2, 99, 99, 99, 99, 99, 1, 1, 1, 1, 1, 1, 1},
    judged_flight_pushed[] = {1, 2, 7, 8, 9, 10, 11}, divided_flight_pushed[] = {-1, -1, 0, -1, -1, -1, -1},
    divisors_flight_pushed[] = {19}, integrals_flight_pushed[] = {11, -1, -1}, factors_flight_pushed[] = {28,
    20, -1, -1, -1, -1};

const tdmf_motion_kind TDMF_OF_WIDTH(tdmf_runner_motions)[] = {
    {.moving_count = 6, .extra_count = 0, .series_count = 6, .constant_count = 7, .judged_count = 0,
        .divisor_count = 0, .moving = moving_start_of_run, .degrees = degrees_start_of_run,
        .judged = judged_start_of_run, .divided = divided_start_of_run, .divisors = divisors_start_of_run,
        .integrals = integrals_start_of_run, .factors = factors_start_of_run,
        .polynomials = polynomials_start_of_run, .vary_observed = vary_observed_start_of_run,
        .expand = expand_start_of_run, .vary = vary_start_of_run, .bounds = bounds_start_of_run},
    {.moving_count = 17, .extra_count = 1, .series_count = 40, .constant_count = 26, .judged_count = 9,
        .divisor_count = 2, .moving = moving_slip_constant, .degrees = degrees_slip_constant,
        .judged = judged_slip_constant, .divided = divided_slip_constant, .divisors = divisors_slip_constant,
        .integrals = integrals_slip_constant, .factors = factors_slip_constant,
        .polynomials = polynomials_slip_constant, .vary_observed = vary_observed_slip_constant,
        .expand = expand_slip_constant, .vary = vary_slip_constant, .bounds = bounds_slip_constant},
    {.moving_count = 15, .extra_count = 1, .series_count = 35, .constant_count = 26, .judged_count = 7,
        .divisor_count = 2, .moving = moving_stick, .degrees = degrees_stick, .judged = judged_stick,
        .divided = divided_stick, .divisors = divisors_stick, .integrals = integrals_stick,
        .factors = factors_stick, .polynomials = polynomials_stick, .vary_observed = vary_observed_stick,
        .expand = expand_stick, .vary = vary_stick, .bounds = bounds_stick},
    {.moving_count = 17, .extra_count = 0, .series_count = 24, .constant_count = 35, .judged_count = 6,
        .divisor_count = 1, .moving = moving_flight_calm, .degrees = degrees_flight_calm,
        .judged = judged_flight_calm, .divided = divided_flight_calm, .divisors = divisors_flight_calm,
        .integrals = integrals_flight_calm, .factors = factors_flight_calm,
        .polynomials = polynomials_flight_calm, .vary_observed = vary_observed_flight_calm,
        .expand = expand_flight_calm, .vary = vary_flight_calm, .bounds = bounds_flight_calm},
    {.moving_count = 0, .extra_count = 0, .series_count = 0, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_fallen, .degrees = degrees_fallen, .judged = judged_fallen,
        .divided = divided_fallen, .divisors = divisors_fallen, .integrals = integrals_fallen,
        .factors = factors_fallen, .polynomials = polynomials_fallen, .vary_observed = vary_observed_fallen,
        .expand = expand_fallen, .vary = vary_fallen, .bounds = NULL},
    {.moving_count = 17, .extra_count = 1, .series_count = 37, .constant_count = 32, .judged_count = 7,
        .divisor_count = 3, .moving = moving_graze, .degrees = degrees_graze, .judged = judged_graze,
        .divided = divided_graze, .divisors = divisors_graze, .integrals = integrals_graze,
        .factors = factors_graze, .polynomials = polynomials_graze, .vary_observed = vary_observed_graze,
        .expand = expand_graze, .vary = vary_graze, .bounds = bounds_graze},
    {.moving_count = 17, .extra_count = 1, .series_count = 45, .constant_count = 28, .judged_count = 9,
        .divisor_count = 2, .moving = moving_slip_falling, .degrees = degrees_slip_falling,
        .judged = judged_slip_falling, .divided = divided_slip_falling, .divisors = divisors_slip_falling,
        .integrals = integrals_slip_falling, .factors = factors_slip_falling,
        .polynomials = polynomials_slip_falling, .vary_observed = vary_observed_slip_falling,
        .expand = expand_slip_falling, .vary = vary_slip_falling, .bounds = bounds_slip_falling},
    {.moving_count = 19, .extra_count = 0, .series_count = 39, .constant_count = 36, .judged_count = 7,
        .divisor_count = 1, .moving = moving_flight_pushed, .degrees = degrees_flight_pushed,
        .judged = judged_flight_pushed, .divided = divided_flight_pushed, .divisors = divisors_flight_pushed,
        .integrals = integrals_flight_pushed, .factors = factors_flight_pushed,
        .polynomials = polynomials_flight_pushed, .vary_observed = vary_observed_flight_pushed,
        .expand = expand_flight_pushed, .vary = vary_flight_pushed, .bounds = bounds_flight_pushed},
};

#ifdef TDMF_LANES
const void *TDMF_OF_WIDTH(tdmf_runner_motions_of)(void) {
    return TDMF_OF_WIDTH(tdmf_runner_motions);
}
#endif
