/* The recurrences of flight_series.h and ground_series.h, differentiated line by line. d_ stands for the
 * variation of what follows. */
#include "tangent_series.h"

/* Coefficient k of a product. */
static double product(const double *a, const double *b, int k) {
    double sum = 0.0;
    for (int i = 0; i <= k; ++i) {
        sum += a[i] * b[k - i];
    }
    return sum;
}

/* The same without the last coefficient of a: what a division still has to find. */
static double product_so_far(const double *a, const double *b, int k) {
    double sum = 0.0;
    for (int i = 0; i < k; ++i) {
        sum += a[i] * b[k - i];
    }
    return sum;
}

/* Coefficient k of the variation of a product. */
static double varied_product(const double *a, const double *d_a, const double *b, const double *d_b, int k) {
    return product(d_a, b, k) + product(a, d_b, k);
}

/* Coefficient k of d_q, where q b = p: from d_p, and d_q up to k - 1. */
static double varied_quotient(const double *q, const double *d_q, const double *b, const double *d_b,
                              double d_p, int k) {
    return (d_p - product(q, d_b, k) - product_so_far(d_q, b, k)) / b[0];
}

/* One product's factors out of a table of many. */
static void take(const double (*table)[FLIGHT_PRODUCTS], int lane, int order, double *series) {
    for (int k = 0; k < order; ++k) {
        series[k] = table[k][lane];
    }
}

static void take_free(const double (*table)[FREE_PRODUCTS], int lane, int order, double *series) {
    for (int k = 0; k < order; ++k) {
        series[k] = table[k][lane];
    }
}

void tdmf_expand_flight_tangent(const tdmf_step *step, const flight_coefficients *change,
                                const tdmf_coordinates *start, flight_tangent *t) {
    const flight_series *f = &step->series.flight;
    const flight_coefficients c = tdmf_step_flight_coefficients(step->chart);
    const tdmf_model *model = step->chart->model;
    const double mobility = model->inverse_body_mass + model->inverse_foot_mass;
    const int order = step->order;
    double square[SERIES_TERMS], across[SERIES_TERMS], torque[SERIES_TERMS];
    double d_square[SERIES_TERMS], d_across[SERIES_TERMS], d_torque[SERIES_TERMS];
    take(f->factors.left, FLIGHT_SQUARE_RATE, order, square);
    take(f->factors.left, FLIGHT_ACROSS_RATE, order, across);
    t->length[0] = start->length;
    t->length_rate[0] = start->length_rate;
    t->angle[0] = start->angle;
    t->angle_rate[0] = start->angle_rate;
    t->momentum[0] = 2.0 * f->length[0] * start->length * f->angle_rate[0] + square[0] * start->angle_rate;
    for (int k = 0; k < order; ++k) {
        const double divide = series_reciprocal[k + 1];
        d_square[k] = 2.0 * product(f->length, t->length, k);
        if (k > 0) {
            t->angle_rate[k] =
                varied_quotient(f->angle_rate, t->angle_rate, square, d_square, t->momentum[k], k);
        }
        d_across[k] = varied_product(f->length, t->length, f->angle_rate, t->angle_rate, k);
        const double d_centrifugal = varied_product(across, d_across, f->angle_rate, t->angle_rate, k);
        double d_force = d_centrifugal - c.stiffness * t->length[k] - change->stiffness * f->length[k] -
                         c.damping * t->length_rate[k] - change->damping * f->length_rate[k];
        double d_push = -c.gain * t->angle[k] - change->gain * f->angle[k] - c.rate_gain * t->angle_rate[k] -
                        change->rate_gain * f->angle_rate[k];
        if (k == 0) {
            d_force += c.stiffness * change->free_length + change->stiffness * c.free_length;
            d_push += c.gain * change->target + change->gain * c.target + change->torque;
        } else if (k == 1) {
            d_push += change->torque_rate;
        }
        /* The torque is the push over the mobility M, whose change is in the push already. */
        torque[k] = (double)(k + 1) * f->momentum[k + 1] / mobility;
        d_torque[k] = (d_push - change->mobility * torque[k]) / mobility;
        t->power[k] = varied_product(torque, d_torque, f->angle_rate, t->angle_rate, k);
        t->length[k + 1] = t->length_rate[k] * divide;
        t->length_rate[k + 1] = d_force * divide;
        t->angle[k + 1] = t->angle_rate[k] * divide;
        t->momentum[k + 1] = d_push * divide;
    }
}

/* Factors of the step's products, and their variations under way. */
typedef struct {
    double rate[SERIES_TERMS], axial[SERIES_TERMS], turning[SERIES_TERMS], friction[SERIES_TERMS],
        moment[SERIES_TERMS], torque[SERIES_TERMS];
} leg_factors;

/* Variation of coefficient k of what the leg pushes with and turns at. */
static void vary_leg(const tdmf_step *step, const ground_coefficients *c, const ground_coefficients *change,
                     const leg_factors *factors, int k, ground_tangent *t, leg_factors *d) {
    const ground_series *g = &step->series.ground;
    const double first = k == 0 ? 1.0 : 0.0;
    const bool grazes = step->chart->contact == TDMF_CONTACT_GRAZE;
    const double d_push = -c->stiffness * t->length[k] - change->stiffness * g->length[k] -
                          c->damping * d->rate[k] - change->damping * factors->rate[k] +
                          first * (c->stiffness * change->free_length + change->stiffness * c->free_length);
    d->axial[k] = varied_quotient(factors->axial, d->axial, g->length, t->length, d_push, k);
    t->axial_y[k] = varied_product(factors->axial, d->axial, g->y, t->y, k);
    const double d_axial_x = varied_product(factors->axial, d->axial, g->x, t->x, k);
    if (grazes) {
        const double d_lift = -t->axial_y[k] - first * change->foot_weight;
        d->turning[k] = varied_quotient(factors->turning, d->turning, g->x, t->x, d_lift, k);
        d->torque[k] = varied_product(factors->turning, d->turning, g->square, t->square, k);
    } else {
        d->torque[k] = k == 0 ? change->torque : k == 1 ? change->torque_rate : 0.0;
        d->turning[k] = varied_quotient(factors->turning, d->turning, g->square, t->square, d->torque[k], k);
    }
    const double d_turning_x = varied_product(factors->turning, d->turning, g->x, t->x, k);
    const double d_turning_y = varied_product(factors->turning, d->turning, g->y, t->y, k);
    t->normal_force[k] = grazes ? 0.0 : t->axial_y[k] + d_turning_x + first * change->foot_weight;
    t->leg_force_x[k] = d_turning_y - d_axial_x;
    d->moment[k] = varied_product(g->x, t->x, g->vy, t->vy, k) - varied_product(g->y, t->y, g->vx, t->vx, k);
    t->angle_rate[k] = varied_quotient(g->angle_rate, t->angle_rate, g->square, t->square, d->moment[k], k);
    t->power[k] = varied_product(factors->torque, d->torque, g->angle_rate, t->angle_rate, k);
}

/* Variation of the foot's acceleration, coefficient k. */
static double vary_foot(const tdmf_step *step, const ground_coefficients *c,
                        const ground_coefficients *change, const leg_factors *factors, int k,
                        const ground_tangent *t) {
    const ground_series *g = &step->series.ground;
    if (step->chart->contact == TDMF_CONTACT_STICK) {
        return 0.0;
    }
    double d_friction = c->friction * t->normal_force[k] + change->friction * g->normal_force[k];
    double friction = factors->friction[k];
    if (step->chart->contact == TDMF_CONTACT_GRAZE) {
        d_friction = 0.0;
        friction = 0.0;
    }
    return (t->leg_force_x[k] - d_friction) * c->inverse_foot_mass +
           (g->leg_force_x[k] - friction) * change->inverse_foot_mass;
}

void tdmf_expand_ground_tangent(const tdmf_step *step, const ground_coefficients *change,
                                const tdmf_coordinates *start, ground_tangent *t) {
    const ground_series *g = &step->series.ground;
    const ground_coefficients c = tdmf_step_ground_coefficients(step->chart);
    const int order = step->order;
    const bool sticks = step->chart->contact == TDMF_CONTACT_STICK;
    const bool grazes = step->chart->contact == TDMF_CONTACT_GRAZE;
    leg_factors factors, d;
    take_free(g->factors.left, SPEED_SPEED, order, factors.rate);
    take_free(g->factors.right, X_AXIAL, order, factors.axial);
    take_free(g->factors.right, X_TURNING, order, factors.turning);
    if (!sticks) {
        take_free(g->factors.left, LOSS, order, factors.friction);
    }
    for (int k = 0; k < order; ++k) {
        factors.torque[k] = g->torque[k];
    }
    t->x[0] = start->x;
    t->y[0] = start->y;
    t->foot_vx[0] = start->foot_vx;
    t->vx[0] = start->vx - start->foot_vx;
    t->vy[0] = start->vy;
    t->square[0] = 2.0 * (g->x[0] * start->x + g->y[0] * start->y);
    t->length[0] = 0.5 * t->square[0] / g->length[0];
    for (int k = 0; k < order; ++k) {
        const double divide = series_reciprocal[k + 1];
        const double first = k == 0 ? 1.0 : 0.0;
        t->x[k + 1] = t->vx[k] * divide;
        t->y[k + 1] = t->vy[k] * divide;
        t->square[k + 1] = 2.0 * (product(g->x, t->x, k + 1) + product(g->y, t->y, k + 1));
        t->length[k + 1] =
            (0.5 * t->square[k + 1] - product_so_far(t->length, g->length, k + 1)) / g->length[0];
        d.rate[k] = (double)(k + 1) * t->length[k + 1];
        vary_leg(step, &c, change, &factors, k, t, &d);
        const double d_acceleration = vary_foot(step, &c, change, &factors, k, t);
        /* What lifts the body is the ground force less the foot's weight; in graze, minus that weight. */
        const double lift = (grazes ? 0.0 : g->normal_force[k]) - first * c.foot_weight;
        const double d_lift = t->normal_force[k] - first * change->foot_weight;
        t->foot_vx[k + 1] = d_acceleration * divide;
        t->vx[k + 1] = -(t->leg_force_x[k] * c.inverse_body_mass +
                         g->leg_force_x[k] * change->inverse_body_mass + d_acceleration) *
                       divide;
        t->vy[k + 1] =
            (d_lift * c.inverse_body_mass + lift * change->inverse_body_mass - first * change->gravity) *
            divide;
    }
}
