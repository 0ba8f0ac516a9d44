/* Derived from the page ClassicSlip: edit the page, not this. */
#include "classic_slip.h"

/* ---- start_of_run */

/* Start of a run. */
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

/* The foot is not above the ground at the apex, or the runner does not move forward. */
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

/* ---- flight_down */

/* The mass is ballistic. The leg turns after the apex, on the way down. */
typedef struct {
    real y_[TERMS], time[TERMS], x_[TERMS], vy[TERMS], angle[TERMS];
} flight_down_series;

/* All coefficients. */
static void expand_flight_down(const real *constants, int order, real *expanded) {
    const flight_down_constants *c = (const void *)constants;
    flight_down_series *s = (void *)expanded;
    s->time[1] = broadcast(1.0);
    s->x_[1] = c->vx;
    s->vy[1] = c->minus_gravity;
    s->angle[1] = c->minus_retraction_rate;
    for (int k = 0; k < order; ++k) {
        s->y_[k + 1] = s->vy[k] * series_reciprocal[k + 1];
    }
}

/* First variation of the series. */
static void vary_flight_down(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const flight_down_constants *d = (const void *)d_constants;
    flight_down_series *t = (void *)varied;
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        t->y_[k + 1] = t->vy[k] * series_reciprocal[k + 1];
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->x_[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->vx));
        t->vy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->minus_gravity));
        t->angle[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->minus_retraction_rate));
    }
}

/* touchdown: The foot reaches the ground. It slides at once outside the friction cone. */
static void guard_flight_down_touchdown(const real *constants, const real *series, int order, real *g) {
    const flight_down_constants *c = (const void *)constants;
    const flight_down_series *s = (const void *)series;
    real own_cos_of_angle[TERMS], own_sin_of_angle[TERMS];
    for (int k = 0; k < order; ++k) {
        sine_and_cosine_of(k, s->angle, own_sin_of_angle, own_cos_of_angle);
        g[k] = s->y_[k] - c->free_length * own_cos_of_angle[k]
            - c->sin_of_slope_over_cos_of_slope * (s->x_[k] + c->free_length * own_sin_of_angle[k]);
    }
}

/* falls: The mass reaches the ground. */
static void guard_flight_down_falls(const real *constants, const real *series, int order, real *g) {
    const flight_down_constants *c = (const void *)constants;
    const flight_down_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = s->y_[k] - c->sin_of_slope_over_cos_of_slope * s->x_[k];
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_flight_down(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const flight_down_constants *c = (const void *)constants;
    const flight_down_series *s = (const void *)series;
    (void)order, (void)watched;
    const interval span_0 = interval_of_series(s->angle, power, 2);
    const interval span_1 = interval_of_series(s->y_, power, 3);
    const interval span_2 = interval_at(c->free_length, c->free_length);
    const interval span_3 = interval_of_turn(s->angle[0], span_0, false);
    const interval span_4 = interval_product(span_2, span_3);
    const interval span_5 = interval_difference(span_1, span_4);
    const interval span_6 = interval_at(c->sin_of_slope_over_cos_of_slope, c->sin_of_slope_over_cos_of_slope);
    const interval span_7 = interval_of_series(s->x_, power, 2);
    const interval span_8 = interval_of_turn(s->angle[0], span_0, true);
    const interval span_9 = interval_product(span_2, span_8);
    const interval span_10 = interval_sum(span_7, span_9);
    const interval span_11 = interval_product(span_6, span_10);
    const interval span_12 = interval_difference(span_5, span_11);
    bounds[0] = span_12;
    const interval span_13 = interval_product(span_6, span_7);
    const interval span_14 = interval_difference(span_1, span_13);
    bounds[1] = span_14;
}

/* ---- fallen */

/* The mass has reached the ground, or leaves it downward. */
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

/* ---- slides */

/* The leg is outside the friction cone: the foot slides out forward, and the mass falls. */
typedef struct {
    real none[TERMS];
} slides_series;

/* All coefficients. */
static void expand_slides(const real *constants, int order, real *expanded) {
    (void)constants, (void)order, (void)expanded;
}

/* First variation of the series. */
static void vary_slides(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    (void)constants, (void)series, (void)d_constants, (void)order, (void)varied;
}

/* ---- stance */

/* The foot stands, and the leg pushes with k (l0 - r) (1). */
typedef struct {
    real x_[TERMS], y_[TERMS], vx[TERMS], vy[TERMS], time[TERMS], x_2[TERMS], x_times_x[TERMS], y_2[TERMS],
        y_times_y[TERMS], length[TERMS], push[TERMS], push_times_x[TERMS], push_times_y[TERMS];
} stance_series;

typedef struct {
    pair x_times_x, y_times_y, length, push, push_times_x, push_times_y;
} stance_sums;

typedef struct {
    real inverse_length;
} stance_factors;

/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_stance_sums(const stance_series *s, int i, int j, stance_sums *sum) {
    add_products(&sum->x_times_x, s->x_2 + i - 1, s->x_2[j]);
    add_products(&sum->y_times_y, s->y_2 + i - 1, s->y_2[j]);
    add_products(&sum->length, s->length + i - 1, s->length[j]);
    add_both_products(&sum->push, s->push, s->length, i, j);
    add_both_products(&sum->push_times_x, s->push, s->x_2, i, j);
    add_both_products(&sum->push_times_y, s->push, s->y_2, i, j);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_stance_sums(const stance_series *s, int i, stance_sums *sum) {
    sum->x_times_x = middle_of_square(s->x_2, i);
    sum->y_times_y = middle_of_square(s->y_2, i);
    sum->length = middle_of_square(s->length, i);
    sum->push = middle_of_product(s->push, s->length, i);
    sum->push_times_x = middle_of_product(s->push, s->x_2, i);
    sum->push_times_y = middle_of_product(s->push, s->y_2, i);
}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_stance(const stance_constants *c, const stance_factors *by, int k, const stance_sums *sum,
    int odd, stance_series *s) {
    s->x_[k + 1] = s->vx[k] * series_reciprocal[k + 1];
    s->y_[k + 1] = s->vy[k] * series_reciprocal[k + 1];
    /* x_2 = x_ - c->foot_x */
    s->x_2[k] = with_constant(k, s->x_[k], -c->foot_x);
    /* x_times_x = x_2 * x_2 */
    s->x_times_x[k] = square_of(k, part_of(sum->x_times_x, odd), s->x_2);
    /* y_2 = y_ - c->foot_y */
    s->y_2[k] = with_constant(k, s->y_[k], -c->foot_y);
    /* y_times_y = y_2 * y_2 */
    s->y_times_y[k] = square_of(k, part_of(sum->y_times_y, odd), s->y_2);
    /* length = real_sqrt(x_times_x + y_times_y) */
    s->length[k] = root_of(k, part_of(sum->length, odd), s->x_times_x[k] + s->y_times_y[k], s->length,
        by->inverse_length);
    /* push = c->stiffness_over_mass * (c->free_length - length) / length */
    s->push[k] = quotient_of(k, part_of(sum->push, odd), with_constant(k,
        -(c->stiffness_over_mass * s->length[k]), c->stiffness_over_mass * c->free_length), s->push,
        s->length, by->inverse_length);
    /* push_times_x = push * x_2 */
    s->push_times_x[k] = product_of(k, part_of(sum->push_times_x, odd), s->push, s->x_2);
    /* push_times_y = push * y_2 */
    s->push_times_y[k] = product_of(k, part_of(sum->push_times_y, odd), s->push, s->y_2);
    s->vx[k + 1] = series_reciprocal[k + 1] * (s->push_times_x[k]);
    s->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, s->push_times_y[k], -c->gravity));
}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_stance(const real *constants, int order, real *series) {
    const stance_constants copy = *(const stance_constants *)(const void *)constants, *c = &copy;
    stance_series *s = (void *)series;
    static const stance_sums none;
    stance_sums sum = none;
    s->time[1] = broadcast(1.0);
    s->x_2[0] = s->x_[0] - c->foot_x;
    s->x_times_x[0] = s->x_2[0] * s->x_2[0];
    s->y_2[0] = s->y_[0] - c->foot_y;
    s->y_times_y[0] = s->y_2[0] * s->y_2[0];
    s->length[0] = real_sqrt(s->x_times_x[0] + s->y_times_y[0]);
    const stance_factors factors = {1.0 / s->length[0]}, *by = &factors;
    step_stance(c, by, 0, &sum, 0, s);
    begin_stance_sums(s, 0, &sum);
    step_stance(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {
        begin_stance_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
            add_stance_sums(s, i, j, &sum);
        }
        step_stance(c, by, k, &sum, 0, s);
        add_stance_sums(s, 1, k, &sum);
        step_stance(c, by, k + 1, &sum, 1, s);
    }
}

/* First variation of the series. */
static void vary_stance(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    const stance_constants *d = (const void *)d_constants;
    stance_series *t = (void *)varied;
    real x_2_times_d_x_2[TERMS], y_2_times_d_y_2[TERMS], d_length[TERMS], push_times_d_length[TERMS],
        d_push[TERMS], d_push_times_x_2[TERMS], push_times_d_x_2[TERMS], d_push_times_y_2[TERMS],
        push_times_d_y_2[TERMS], d_x_2[TERMS], d_y_2[TERMS];
    for (int k = 0; k < order; ++k) {
        t->x_[k + 1] = t->vx[k] * series_reciprocal[k + 1];
        t->y_[k + 1] = t->vy[k] * series_reciprocal[k + 1];
        d_x_2[k] = with_constant(k, t->x_[k], -d->foot_x);
        x_2_times_d_x_2[k] = product(s->x_2, d_x_2, k);
        d_y_2[k] = with_constant(k, t->y_[k], -d->foot_y);
        y_2_times_d_y_2[k] = product(s->y_2, d_y_2, k);
        d_length[k] = (0.5 * (2.0 * x_2_times_d_x_2[k] + 2.0 * y_2_times_d_y_2[k]) - product_so_far(d_length,
            s->length, k)) / s->length[0];
        push_times_d_length[k] = product(s->push, d_length, k);
        d_push[k] = (with_constant(k, -(d->stiffness_over_mass * s->length[k])
            - c->stiffness_over_mass * d_length[k] - push_times_d_length[k],
            d->stiffness_over_mass * c->free_length + c->stiffness_over_mass * d->free_length)
            - product_so_far(d_push, s->length, k)) / s->length[0];
        d_push_times_x_2[k] = product(d_push, s->x_2, k);
        push_times_d_x_2[k] = product(s->push, d_x_2, k);
        d_push_times_y_2[k] = product(d_push, s->y_2, k);
        push_times_d_y_2[k] = product(s->push, d_y_2, k);
        t->vx[k + 1] = series_reciprocal[k + 1] * (d_push_times_x_2[k] + push_times_d_x_2[k]);
        t->vy[k + 1] = series_reciprocal[k + 1] * (with_constant(k, d_push_times_y_2[k] + push_times_d_y_2[k],
            -d->gravity));
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
    }
}

/* First variation of tilt_ahead. */
static void d_observed_stance_tilt_ahead(const real *constants, const real *series, const real *d_constants,
    const real *d_series, int order, real *dg) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    const stance_constants *d = (const void *)d_constants;
    const stance_series *t = (const void *)d_series;
    real own_tilt_ahead[TERMS], own_x_2_times_d_x_2[TERMS], own_y_2_times_d_y_2[TERMS], own_d_length[TERMS],
        own_tilt_ahead_times_d_length[TERMS], own_d_x_2[TERMS], own_d_y_2[TERMS];
    for (int k = 0; k < order; ++k) {
        own_d_x_2[k] = with_constant(k, t->x_[k], -d->foot_x);
        own_d_y_2[k] = with_constant(k, t->y_[k], -d->foot_y);
        own_tilt_ahead[k] = (c->cos_of_slope * s->x_2[k] + c->sin_of_slope * s->y_2[k]
            - product_so_far(own_tilt_ahead, s->length, k)) / s->length[0];
        own_x_2_times_d_x_2[k] = product(s->x_2, own_d_x_2, k);
        own_y_2_times_d_y_2[k] = product(s->y_2, own_d_y_2, k);
        own_d_length[k] = (0.5 * (2.0 * own_x_2_times_d_x_2[k] + 2.0 * own_y_2_times_d_y_2[k])
            - product_so_far(own_d_length, s->length, k)) / s->length[0];
        own_tilt_ahead_times_d_length[k] = product(own_tilt_ahead, own_d_length, k);
        dg[k] = (d->cos_of_slope * s->x_2[k] + c->cos_of_slope * own_d_x_2[k] + (d->sin_of_slope * s->y_2[k]
            + c->sin_of_slope * own_d_y_2[k]) - own_tilt_ahead_times_d_length[k] - product_so_far(dg,
            s->length, k)) / s->length[0];
    }
}

/* First variation of tilt_behind. */
static void d_observed_stance_tilt_behind(const real *constants, const real *series, const real *d_constants,
    const real *d_series, int order, real *dg) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    const stance_constants *d = (const void *)d_constants;
    const stance_series *t = (const void *)d_series;
    real own_tilt_ahead[TERMS], own_x_2_times_d_x_2[TERMS], own_y_2_times_d_y_2[TERMS], own_d_length[TERMS],
        own_tilt_ahead_times_d_length[TERMS], own_d_tilt_ahead[TERMS], own_d_x_2[TERMS], own_d_y_2[TERMS];
    for (int k = 0; k < order; ++k) {
        own_d_x_2[k] = with_constant(k, t->x_[k], -d->foot_x);
        own_d_y_2[k] = with_constant(k, t->y_[k], -d->foot_y);
        own_tilt_ahead[k] = (c->cos_of_slope * s->x_2[k] + c->sin_of_slope * s->y_2[k]
            - product_so_far(own_tilt_ahead, s->length, k)) / s->length[0];
        own_x_2_times_d_x_2[k] = product(s->x_2, own_d_x_2, k);
        own_y_2_times_d_y_2[k] = product(s->y_2, own_d_y_2, k);
        own_d_length[k] = (0.5 * (2.0 * own_x_2_times_d_x_2[k] + 2.0 * own_y_2_times_d_y_2[k])
            - product_so_far(own_d_length, s->length, k)) / s->length[0];
        own_tilt_ahead_times_d_length[k] = product(own_tilt_ahead, own_d_length, k);
        own_d_tilt_ahead[k] = (d->cos_of_slope * s->x_2[k] + c->cos_of_slope * own_d_x_2[k]
            + (d->sin_of_slope * s->y_2[k] + c->sin_of_slope * own_d_y_2[k])
            - own_tilt_ahead_times_d_length[k] - product_so_far(own_d_tilt_ahead, s->length,
            k)) / s->length[0];
        dg[k] = -own_d_tilt_ahead[k];
    }
}

/* take_off: The spring is relaxed. */
static void guard_stance_take_off(const real *constants, const real *series, int order, real *g) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = with_constant(k, -s->x_times_x[k] - s->y_times_y[k], c->free_length_times_free_length);
    }
}

/* leaves_cone: The leg reaches theta = -arctan mu: the energy left in the spring is lost. */
static void guard_stance_leaves_cone(const real *constants, const real *series, int order, real *g) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->inverse_by_1_plus_friction * (c->friction * (c->cos_of_slope * s->y_2[k]
            - c->sin_of_slope * s->x_2[k]) - (c->cos_of_slope * s->x_2[k] + c->sin_of_slope * s->y_2[k]));
    }
}

/* slides_out: The leg turns back and leaves the friction cone. */
static void guard_stance_slides_out(const real *constants, const real *series, int order, real *g) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->inverse_by_1_plus_friction * (c->friction * (c->cos_of_slope * s->y_2[k]
            - c->sin_of_slope * s->x_2[k]) + (c->cos_of_slope * s->x_2[k] + c->sin_of_slope * s->y_2[k]));
    }
}

/* collapses: The mass reaches the ground in stance. */
static void guard_stance_collapses(const real *constants, const real *series, int order, real *g) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = c->cos_of_slope * s->y_2[k] - c->sin_of_slope * s->x_2[k];
    }
}

/* tilt_ahead: Sine of the leg's angle while the mass is ahead of the foot. */
static void guard_stance_tilt_ahead(const real *constants, const real *series, int order, real *g) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = (c->cos_of_slope * s->x_2[k] + c->sin_of_slope * s->y_2[k] - product_so_far(g, s->length,
            k)) / s->length[0];
    }
}

/* tilt_behind: Sine of the leg's angle while the mass is behind the foot. */
static void guard_stance_tilt_behind(const real *constants, const real *series, int order, real *g) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    real own_tilt_ahead[TERMS];
    for (int k = 0; k < order; ++k) {
        own_tilt_ahead[k] = (c->cos_of_slope * s->x_2[k] + c->sin_of_slope * s->y_2[k]
            - product_so_far(own_tilt_ahead, s->length, k)) / s->length[0];
        g[k] = -own_tilt_ahead[k];
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_stance(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const stance_constants *c = (const void *)constants;
    const stance_series *s = (const void *)series;
    (void)watched;
    const interval span_0 = interval_at(c->free_length_times_free_length, c->free_length_times_free_length);
    const interval span_1 = interval_of_series(s->x_times_x, power, order);
    const interval span_2 = interval_difference(span_0, span_1);
    const interval span_3 = interval_of_series(s->y_times_y, power, order);
    const interval span_4 = interval_difference(span_2, span_3);
    bounds[0] = span_4;
    const interval span_5 = interval_at(c->inverse_by_1_plus_friction, c->inverse_by_1_plus_friction);
    const interval span_6 = interval_at(c->friction, c->friction);
    const interval span_7 = interval_at(c->cos_of_slope, c->cos_of_slope);
    const interval span_8 = interval_of_series(s->y_2, power, order);
    const interval span_9 = interval_product(span_7, span_8);
    const interval span_10 = interval_at(c->sin_of_slope, c->sin_of_slope);
    const interval span_11 = interval_of_series(s->x_2, power, order);
    const interval span_12 = interval_product(span_10, span_11);
    const interval span_13 = interval_difference(span_9, span_12);
    const interval span_14 = interval_product(span_6, span_13);
    const interval span_15 = interval_product(span_7, span_11);
    const interval span_16 = interval_product(span_10, span_8);
    const interval span_17 = interval_sum(span_15, span_16);
    const interval span_18 = interval_difference(span_14, span_17);
    const interval span_19 = interval_product(span_5, span_18);
    bounds[1] = span_19;
    const interval span_20 = interval_sum(span_14, span_17);
    const interval span_21 = interval_product(span_5, span_20);
    bounds[2] = span_21;
    bounds[3] = span_13;
    bounds[4] = unbounded();
    bounds[5] = unbounded();
}

/* ---- flight_up */

/* The mass is ballistic. The leg turns after the apex, on the way down. */
typedef struct {
    real y_[TERMS], time[TERMS], x_[TERMS], vy[TERMS];
} flight_up_series;

/* All coefficients. */
static void expand_flight_up(const real *constants, int order, real *expanded) {
    const flight_up_constants *c = (const void *)constants;
    flight_up_series *s = (void *)expanded;
    s->time[1] = broadcast(1.0);
    s->x_[1] = c->vx;
    s->vy[1] = c->minus_gravity;
    for (int k = 0; k < order; ++k) {
        s->y_[k + 1] = s->vy[k] * series_reciprocal[k + 1];
    }
}

/* First variation of the series. */
static void vary_flight_up(const real *constants, const real *series, const real *d_constants, int order,
    real *varied) {
    const flight_up_constants *d = (const void *)d_constants;
    flight_up_series *t = (void *)varied;
    (void)constants, (void)series;
    for (int k = 0; k < order; ++k) {
        t->y_[k + 1] = t->vy[k] * series_reciprocal[k + 1];
        t->time[k + 1] = series_reciprocal[k + 1] * (broadcast(0.0));
        t->x_[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->vx));
        t->vy[k + 1] = series_reciprocal[k + 1] * (constant_of(k, d->minus_gravity));
    }
}

/* falls: The mass reaches the ground. */
static void guard_flight_up_falls(const real *constants, const real *series, int order, real *g) {
    const flight_up_constants *c = (const void *)constants;
    const flight_up_series *s = (const void *)series;
    for (int k = 0; k < order; ++k) {
        g[k] = s->y_[k] - c->sin_of_slope_over_cos_of_slope * s->x_[k];
    }
}

/* apex: The mass rises no more, and the leg is put to its angle. */
static void guard_flight_up_apex(const real *constants, const real *series, int order, real *g) {
    const flight_up_series *s = (const void *)series;
    (void)constants;
    for (int k = 0; k < order; ++k) {
        g[k] = (double)(k + 1) * s->y_[k + 1];
    }
}

/* Bounds of guards and observed quantities; `watched` has a bit for each of them. */
static void bounds_flight_up(const real *constants, const real *series, const real *power, int order,
    uint64_t watched, interval *bounds) {
    const flight_up_constants *c = (const void *)constants;
    const flight_up_series *s = (const void *)series;
    (void)order, (void)watched;
    const interval span_0 = interval_of_series(s->y_, power, 3);
    const interval span_1 = interval_at(c->sin_of_slope_over_cos_of_slope, c->sin_of_slope_over_cos_of_slope);
    const interval span_2 = interval_of_series(s->x_, power, 2);
    const interval span_3 = interval_product(span_1, span_2);
    const interval span_4 = interval_difference(span_0, span_3);
    bounds[0] = span_4;
    const interval span_5 = interval_of_rate(s->y_, power, 2);
    bounds[1] = span_5;
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
static const tdmf_polynomial polynomials_flight_down[] = {guard_flight_down_touchdown,
    guard_flight_down_falls};
static const tdmf_vary_polynomial vary_observed_flight_down[] = {NULL};
static const int moving_flight_down[] = {2, 0, 1, 4, 5}, degrees_flight_down[] = {2, 1, 1, 1, 1},
    judged_flight_down[] = {0}, divided_flight_down[] = {0}, divisors_flight_down[] = {0},
    integrals_flight_down[] = {0}, factors_flight_down[] = {0};
static const tdmf_polynomial polynomials_fallen[] = {NULL};
static const tdmf_vary_polynomial vary_observed_fallen[] = {NULL};
static const int moving_fallen[] = {0}, degrees_fallen[] = {0}, judged_fallen[] = {0}, divided_fallen[] = {0},
    divisors_fallen[] = {0}, integrals_fallen[] = {0}, factors_fallen[] = {0};
static const tdmf_polynomial polynomials_slides[] = {NULL};
static const tdmf_vary_polynomial vary_observed_slides[] = {NULL};
static const int moving_slides[] = {0}, degrees_slides[] = {0}, judged_slides[] = {0}, divided_slides[] = {0},
    divisors_slides[] = {0}, integrals_slides[] = {0}, factors_slides[] = {0};
static const tdmf_polynomial polynomials_stance[] = {guard_stance_take_off, guard_stance_leaves_cone,
    guard_stance_slides_out, guard_stance_collapses, guard_stance_tilt_ahead, guard_stance_tilt_behind};
static const tdmf_vary_polynomial vary_observed_stance[] = {d_observed_stance_tilt_ahead,
    d_observed_stance_tilt_behind};
static const int moving_stance[] = {1, 2, 3, 4, 0}, degrees_stance[] = {99, 99, 99, 99, 1},
    judged_stance[] = {2, 3}, divided_stance[] = {-1, -1}, divisors_stance[] = {9}, integrals_stance[] = {-1,
    -1}, factors_stance[] = {-1, -1, -1, -1};
static const tdmf_polynomial polynomials_flight_up[] = {guard_flight_up_falls, guard_flight_up_apex};
static const tdmf_vary_polynomial vary_observed_flight_up[] = {NULL};
static const int moving_flight_up[] = {2, 0, 1, 4}, degrees_flight_up[] = {2, 1, 1, 1},
    judged_flight_up[] = {0}, divided_flight_up[] = {0}, divisors_flight_up[] = {0},
    integrals_flight_up[] = {0}, factors_flight_up[] = {0};

const tdmf_motion_kind TDMF_OF_WIDTH(tdmf_classic_slip_motions)[] = {
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
    {.moving_count = 5, .extra_count = 0, .series_count = 5, .constant_count = 5, .judged_count = 0,
        .divisor_count = 0, .moving = moving_flight_down, .degrees = degrees_flight_down,
        .judged = judged_flight_down, .divided = divided_flight_down, .divisors = divisors_flight_down,
        .integrals = integrals_flight_down, .factors = factors_flight_down,
        .polynomials = polynomials_flight_down, .vary_observed = vary_observed_flight_down,
        .expand = expand_flight_down, .vary = vary_flight_down, .bounds = bounds_flight_down},
    {.moving_count = 0, .extra_count = 0, .series_count = 0, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_fallen, .degrees = degrees_fallen, .judged = judged_fallen,
        .divided = divided_fallen, .divisors = divisors_fallen, .integrals = integrals_fallen,
        .factors = factors_fallen, .polynomials = polynomials_fallen, .vary_observed = vary_observed_fallen,
        .expand = expand_fallen, .vary = vary_fallen, .bounds = NULL},
    {.moving_count = 0, .extra_count = 0, .series_count = 0, .constant_count = 0, .judged_count = 0,
        .divisor_count = 0, .moving = moving_slides, .degrees = degrees_slides, .judged = judged_slides,
        .divided = divided_slides, .divisors = divisors_slides, .integrals = integrals_slides,
        .factors = factors_slides, .polynomials = polynomials_slides, .vary_observed = vary_observed_slides,
        .expand = expand_slides, .vary = vary_slides, .bounds = NULL},
    {.moving_count = 5, .extra_count = 0, .series_count = 13, .constant_count = 10, .judged_count = 2,
        .divisor_count = 1, .moving = moving_stance, .degrees = degrees_stance, .judged = judged_stance,
        .divided = divided_stance, .divisors = divisors_stance, .integrals = integrals_stance,
        .factors = factors_stance, .polynomials = polynomials_stance, .vary_observed = vary_observed_stance,
        .expand = expand_stance, .vary = vary_stance, .bounds = bounds_stance},
    {.moving_count = 4, .extra_count = 0, .series_count = 4, .constant_count = 3, .judged_count = 0,
        .divisor_count = 0, .moving = moving_flight_up, .degrees = degrees_flight_up,
        .judged = judged_flight_up, .divided = divided_flight_up, .divisors = divisors_flight_up,
        .integrals = integrals_flight_up, .factors = factors_flight_up, .polynomials = polynomials_flight_up,
        .vary_observed = vary_observed_flight_up, .expand = expand_flight_up, .vary = vary_flight_up,
        .bounds = bounds_flight_up},
};

#ifdef TDMF_LANES
const void *TDMF_OF_WIDTH(tdmf_classic_slip_motions_of)(void) {
    return TDMF_OF_WIDTH(tdmf_classic_slip_motions);
}
#endif
