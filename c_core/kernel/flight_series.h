/* Flight: the centre of mass is exactly ballistic, so only the leg is expanded, and gravity drops out of its
 * equations with every sine and cosine. With M = 1/m + 1/m_f, v = rdot, w = thetadot and L = r^2 w,
 *
 *     vdot = r w^2 + M (k (l - r) - c v),      Ldot = M tau,      w = L/r^2,
 *     tau = G (theta_target - theta) - D w + tau_1 + tau_2 t.
 *
 * A force on the body, which gives it the acceleration p, does not drop out: vdot gains u.p, Ldot gains r t.p
 * with u = (-sin, cos) along the leg and t = (-cos, -sin) across it, by (sin)' = w cos and (cos)' = -w sin.
 */
#ifndef TDMF_KERNEL_FLIGHT_SERIES_H
#define TDMF_KERNEL_FLIGHT_SERIES_H

#include "series_products.h"

typedef struct {
    real length[SERIES_TERMS];       /* r */
    real length_rate[SERIES_TERMS];  /* v */
    real angle[SERIES_TERMS];        /* theta */
    real momentum[SERIES_TERMS];     /* L */
    real angle_rate[SERIES_TERMS];   /* w, up to order - 1, as all that follows */
    real square[SERIES_TERMS];       /* r^2 */
    real rate_square[SERIES_TERMS];  /* w^2 */
    real speed_square[SERIES_TERMS]; /* v^2 */
    /* Where there is a force on the body. */
    real sine[SERIES_TERMS], cosine[SERIES_TERMS];             /* of theta, up to order */
    real push_across[SERIES_TERMS], push_moment[SERIES_TERMS]; /* t.p, r t.p */
} flight_series;

/* What the series depend on, besides their first coefficients. */
typedef struct {
    real mobility;  /* M */
    real stiffness; /* M k */
    real damping;   /* M c */
    real rest_length;
    real gain, rate_gain; /* M G, M D */
    real target;
    real torque, torque_rate; /* M tau_1, M tau_2 */
} flight_coefficients;

/* What most runners do without: a force on the body, by the acceleration p that it gives it, and ramps. */
typedef struct {
    real push_x, push_y;
    real push_x_rate, push_y_rate, rest_length_rate;
} flight_forcing;

/* The inner terms of coefficient k of r r, w w, v v (half of them), r^2 w and r w^2: those without
 * coefficient 0 of a factor, because the other's coefficient k is what the recurrence is about to find. They
 * are summed from the middle outwards, two at a time, so that the newest coefficients, which have just been
 * found, are needed last. */
typedef struct {
    real length_length, rate_rate, speed_speed, square_rate, length_rate_square;
} flight_sums;

static inline flight_sums no_flight_terms(void) {
    const real zero = real_of(0.0);
    const flight_sums none = {zero, zero, zero, zero, zero};
    return none;
}

/* Adds the terms with coefficient i of one factor and j of the other. */
KERNEL void add_flight_terms(const flight_series *f, int i, int j, flight_sums *sum) {
    sum->length_length += f->length[i] * f->length[j];
    sum->rate_rate += f->angle_rate[i] * f->angle_rate[j];
    sum->speed_speed += f->length_rate[i] * f->length_rate[j];
    sum->square_rate += f->square[j] * f->angle_rate[i];
    sum->square_rate += f->square[i] * f->angle_rate[j];
    sum->length_rate_square += f->length[i] * f->rate_square[j];
    sum->length_rate_square += f->length[j] * f->rate_square[i];
}

/* The terms with coefficient i of both factors. */
KERNEL flight_sums flight_squares(const flight_series *f, int i) {
    const flight_sums sum = {
        .length_length = 0.5 * (f->length[i] * f->length[i]),
        .rate_rate = 0.5 * (f->angle_rate[i] * f->angle_rate[i]),
        .speed_speed = 0.5 * (f->length_rate[i] * f->length_rate[i]),
        .square_rate = f->square[i] * f->angle_rate[i],
        .length_rate_square = f->length[i] * f->rate_square[i],
    };
    return sum;
}

/* Coefficient k of t.p and r t.p. Returns that of u.p and of what else the forcing adds to vdot. */
KERNEL real expand_forcing(const flight_coefficients *a, const flight_forcing *p, int k, flight_series *f) {
    if (k > 0) {
        f->sine[k] = product(f->angle_rate, f->cosine, k - 1) * series_reciprocal[k];
        f->cosine[k] = -product(f->angle_rate, f->sine, k - 1) * series_reciprocal[k];
    }
    real along = p->push_y * f->cosine[k] - p->push_x * f->sine[k];
    f->push_across[k] = -(p->push_x * f->cosine[k] + p->push_y * f->sine[k]);
    if (INPUTS_RAMP && k > 0) {
        along += p->push_y_rate * f->cosine[k - 1] - p->push_x_rate * f->sine[k - 1];
        f->push_across[k] -= p->push_x_rate * f->cosine[k - 1] + p->push_y_rate * f->sine[k - 1];
    }
    f->push_moment[k] = product(f->length, f->push_across, k);
    return INPUTS_RAMP && k == 1 ? along + a->stiffness * p->rest_length_rate : along;
}

/* From coefficient k of length, length rate, angle and momentum to the next ones, k > 0. Where there is no
 * forcing, p is NULL. */
KERNEL void expand_flight_on(const flight_coefficients *a, const flight_forcing *p, real inverse_square,
                             int k, const flight_sums *sum, flight_series *f) {
    const double divide = series_reciprocal[k + 1];
    const real r0 = f->length[0], v0 = f->length_rate[0], w0 = f->angle_rate[0];
    const real r = f->length[k], v = f->length_rate[k], theta = f->angle[k];
    const real square = 2.0 * (sum->length_length + r0 * r);
    const real w = (f->momentum[k] - sum->square_rate - w0 * square) * inverse_square;
    const real rate_square = 2.0 * (sum->rate_rate + w0 * w);
    const real leg = sum->length_rate_square + f->rate_square[0] * r - a->stiffness * r - a->damping * v;
    f->square[k] = square;
    f->angle_rate[k] = w;
    f->rate_square[k] = rate_square;
    f->speed_square[k] = 2.0 * (sum->speed_speed + v0 * v);
    f->length[k + 1] = v * divide;
    f->length_rate[k + 1] = (leg + r0 * rate_square) * divide;
    f->angle[k + 1] = w * divide;
    f->momentum[k + 1] = -(a->gain * theta + a->rate_gain * w) * divide;
    if (p != NULL) {
        f->length_rate[k + 1] += expand_forcing(a, p, k, f) * divide;
        f->momentum[k + 1] += f->push_moment[k] * divide;
    }
}

/* From coefficient k, even, two further: of the terms of both, most share a factor that is loaded once. */
KERNEL void expand_flight_by_two(const flight_coefficients *a, const flight_forcing *p, real inverse_square,
                                 int k, flight_series *f) {
    flight_sums sum = flight_squares(f, k / 2), next = no_flight_terms();
    for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {
        add_flight_terms(f, i, j, &next);
        add_flight_terms(f, i - 1, j, &sum);
    }
    expand_flight_on(a, p, inverse_square, k, &sum, f);
    add_flight_terms(f, 1, k, &next);
    expand_flight_on(a, p, inverse_square, k + 1, &next, f);
}

/* From length, angle, length rate and angle rate. An odd order gets one coefficient more. */
KERNEL void expand_flight(const flight_coefficients *coefficients, const flight_forcing *p,
                          const real start[4], int order, flight_series *f) {
    const flight_coefficients a = *coefficients;
    const flight_sums none = no_flight_terms();
    const real r = start[0], theta = start[1], v = start[2], w = start[3];
    const real square = r * r;
    const real inverse_square = 1.0 / square;
    f->length[0] = r;
    f->angle[0] = theta;
    f->length_rate[0] = v;
    f->angle_rate[0] = w;
    f->momentum[0] = square * w;
    f->square[0] = square;
    f->rate_square[0] = w * w;
    f->speed_square[0] = v * v;
    f->length[1] = v;
    f->length_rate[1] = r * f->rate_square[0] + a.stiffness * (a.rest_length - r) - a.damping * v;
    f->angle[1] = w;
    f->momentum[1] = a.gain * (a.target - theta) - a.rate_gain * w + a.torque;
    if (p != NULL) {
        sine_and_cosine(theta, &f->sine[0], &f->cosine[0]);
        f->length_rate[1] += expand_forcing(&a, p, 0, f);
        f->momentum[1] += f->push_moment[0];
    }
    expand_flight_on(&a, p, inverse_square, 1, &none, f);
    f->momentum[2] += 0.5 * a.torque_rate;
    for (int k = 2; k < order; k += 2) {
        expand_flight_by_two(&a, p, inverse_square, k, f);
    }
}

/* How far series of an order may be trusted, whatever their coefficients. Where the leg comes to rest terms
 * grow up to the one whose index is rate times time, however little is left to decay: in a longer step the
 * last ones do not tell what is left out. */
static inline real longest_flight_step(const flight_coefficients *a, const flight_forcing *p, real length,
                                       int order) {
    const real inverse_length = 1.0 / length;
    const real inverse_square = inverse_length * inverse_length;
    real stiffness = larger(a->stiffness, a->gain * inverse_square);
    if (p != NULL) { /* a pendulum under the push */
        stiffness = larger(stiffness, (real_abs(p->push_x) + real_abs(p->push_y)) * inverse_length);
    }
    const real springs_back = real_sqrt(stiffness);
    const real comes_to_rest = larger(a->damping, a->rate_gain * inverse_square);
    return (double)order / larger(springs_back, comes_to_rest);
}

/* The first variation of a motion in flight. */
typedef struct {
    real length[SERIES_TERMS], length_rate[SERIES_TERMS], angle[SERIES_TERMS], momentum[SERIES_TERMS];
    real angle_rate[SERIES_TERMS], square[SERIES_TERMS], rate_square[SERIES_TERMS];
    real torque[SERIES_TERMS], power[SERIES_TERMS]; /* tau, tau w */
    real sine[SERIES_TERMS], cosine[SERIES_TERMS];
    real push_across[SERIES_TERMS], push_moment[SERIES_TERMS];
} flight_variation;

/* expand_forcing, differentiated: `d` is the variation of the coefficients, `d_p` that of the forcing. */
static inline real vary_forcing(const flight_coefficients *a, const flight_forcing *p, const flight_series *f,
                                const flight_coefficients *d, const flight_forcing *d_p, int k,
                                flight_variation *t) {
    t->sine[k] = product(f->cosine, t->angle, k);
    t->cosine[k] = -product(f->sine, t->angle, k);
    real along = p->push_y * t->cosine[k] - p->push_x * t->sine[k] + d_p->push_y * f->cosine[k] -
                 d_p->push_x * f->sine[k];
    real across = p->push_x * t->cosine[k] + p->push_y * t->sine[k] + d_p->push_x * f->cosine[k] +
                  d_p->push_y * f->sine[k];
    if (k > 0) {
        along += p->push_y_rate * t->cosine[k - 1] - p->push_x_rate * t->sine[k - 1] +
                 d_p->push_y_rate * f->cosine[k - 1] - d_p->push_x_rate * f->sine[k - 1];
        across += p->push_x_rate * t->cosine[k - 1] + p->push_y_rate * t->sine[k - 1] +
                  d_p->push_x_rate * f->cosine[k - 1] + d_p->push_y_rate * f->sine[k - 1];
    }
    t->push_across[k] = -across;
    t->push_moment[k] = vary_product(f->length, t->length, f->push_across, t->push_across, k);
    return k == 1 ? along + a->stiffness * d_p->rest_length_rate + d->stiffness * p->rest_length_rate : along;
}

/* The recurrence of expand_flight, differentiated: `d` is the variation of the coefficients, `d_p` that of
 * the forcing, if there is one, and `start` that of length, angle, length rate and angle rate. */
static inline void vary_flight(const flight_coefficients *a, const flight_forcing *p, const flight_series *f,
                               const flight_coefficients *d, const flight_forcing *d_p, const real start[4],
                               int order, flight_variation *t) {
    real torque[SERIES_TERMS];
    t->length[0] = start[0];
    t->angle[0] = start[1];
    t->length_rate[0] = start[2];
    t->angle_rate[0] = start[3];
    t->momentum[0] = 2.0 * f->length[0] * start[0] * f->angle_rate[0] + f->square[0] * start[3];
    for (int k = 0; k < order; ++k) {
        const double divide = series_reciprocal[k + 1];
        t->square[k] = 2.0 * product(f->length, t->length, k);
        if (k > 0) {
            t->angle_rate[k] =
                vary_quotient(f->angle_rate, t->angle_rate, f->square, t->square, t->momentum[k], k);
        }
        t->rate_square[k] = 2.0 * product(f->angle_rate, t->angle_rate, k);
        real d_acceleration = vary_product(f->length, t->length, f->rate_square, t->rate_square, k) -
                              a->stiffness * t->length[k] - d->stiffness * f->length[k] -
                              a->damping * t->length_rate[k] - d->damping * f->length_rate[k];
        real d_momentum_rate = -a->gain * t->angle[k] - d->gain * f->angle[k] -
                               a->rate_gain * t->angle_rate[k] - d->rate_gain * f->angle_rate[k];
        if (k == 0) {
            d_acceleration += a->stiffness * d->rest_length + d->stiffness * a->rest_length;
            d_momentum_rate += a->gain * d->target + d->gain * a->target + d->torque;
        } else if (k == 1) {
            d_momentum_rate += d->torque_rate;
        }
        torque[k] = (double)(k + 1) * f->momentum[k + 1];
        if (p != NULL) {
            torque[k] -= f->push_moment[k];
        }
        torque[k] /= a->mobility;
        t->torque[k] = (d_momentum_rate - d->mobility * torque[k]) / a->mobility;
        t->power[k] = vary_product(torque, t->torque, f->angle_rate, t->angle_rate, k);
        if (p != NULL) {
            d_acceleration += vary_forcing(a, p, f, d, d_p, k, t);
            d_momentum_rate += t->push_moment[k];
        }
        t->length[k + 1] = t->length_rate[k] * divide;
        t->length_rate[k + 1] = d_acceleration * divide;
        t->angle[k + 1] = t->angle_rate[k] * divide;
        t->momentum[k + 1] = d_momentum_rate * divide;
    }
}

#endif
