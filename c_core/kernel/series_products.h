/* Coefficients of products, quotients and functions of series. `real` has been defined. */
#ifndef TDMF_KERNEL_SERIES_PRODUCTS_H
#define TDMF_KERNEL_SERIES_PRODUCTS_H

#include "series.h"
#include "width.h"

/* ---- coefficient k of what is constant but for a ramp, alone or beside what moves ---------------------- */

/* A ramp is there where inputs ramp, a drift always. */

KERNEL real constant_of(int k, real value) {
    return k == 0 ? value : broadcast(0.0);
}

KERNEL real ramp_of(int k, real value, real rate) {
    return k == 0 ? value : INPUTS_RAMP && k == 1 ? rate : broadcast(0.0);
}

KERNEL real drift_of(int k, real value, real rate) {
    return k == 0 ? value : k == 1 ? rate : broadcast(0.0);
}

KERNEL real with_constant(int k, real moving, real value) {
    return k == 0 ? moving + value : moving;
}

KERNEL real with_ramp(int k, real moving, real value, real rate) {
    return k == 0 ? moving + value : INPUTS_RAMP && k == 1 ? moving + rate : moving;
}

KERNEL real with_drift(int k, real moving, real value, real rate) {
    return k == 0 ? moving + value : k == 1 ? moving + rate : moving;
}

KERNEL real drift_times(int k, real value, real rate, const real *a) {
    return k > 0 ? value * a[k] + rate * a[k - 1] : value * a[k];
}

KERNEL real ramp_times(int k, real value, real rate, const real *a) {
    return INPUTS_RAMP ? drift_times(k, value, rate, a) : value * a[k];
}

/* ---- coefficient k from its inner terms: those without coefficient 0 of a factor, of squares half ------ */

KERNEL real product_of(int k, real inner, const real *a, const real *b) {
    return k == 0 ? a[0] * b[0] : inner + a[k] * b[0] + a[0] * b[k];
}

KERNEL real square_of(int k, real half_inner, const real *a) {
    return k == 0 ? a[0] * a[0] : 2.0 * (half_inner + a[0] * a[k]);
}

/* Gives coefficient k of q, where q b = p; the coefficients up to k - 1 are known. */
KERNEL real quotient_of(int k, real inner, real p, const real *q, const real *b, real inverse_b) {
    return k == 0 ? p * inverse_b : (p - inner - q[0] * b[k]) * inverse_b;
}

/* Gives coefficient k of q, where q q = p; coefficient 0 is known. */
KERNEL real root_of(int k, real half_inner, real p, const real *q, real inverse_q) {
    return k == 0 ? q[0] : (0.5 * p - half_inner) * inverse_q;
}

/* ---- coefficient k of a function of a series, by its rate ---------------------------------------------- */

/* k times coefficient k of the integral of a' b. */
static inline real product_with_rate(const real *a, const real *b, int k) {
    real sum = broadcast(0.0);
    for (int i = 1; i <= k; ++i) {
        sum += (double)i * a[i] * b[k - i];
    }
    return sum;
}

/* Writes coefficient k of sin(a) and cos(a), which follows from those up to k - 1 and the rate of a. The
 * newest of them come last: the sums need not wait for them. */
static inline void sine_and_cosine_term(int k, const real *a, const real *rate, real *sine, real *cosine) {
    real sum_with_cosine = broadcast(0.0), sum_with_sine = broadcast(0.0);
    if (k == 0) {
        sine_and_cosine(a[0], &sine[0], &cosine[0]);
        return;
    }
    for (int i = k - 1; i >= 0; --i) {
        sum_with_cosine += rate[i] * cosine[k - 1 - i];
        sum_with_sine += rate[i] * sine[k - 1 - i];
    }
    sine[k] = sum_with_cosine * series_reciprocal[k];
    cosine[k] = -sum_with_sine * series_reciprocal[k];
}

/* Gives coefficient k of exp(a), which follows from those up to k - 1. */
static inline real exp_of(int k, const real *a, const real *exponential) {
    return k == 0 ? real_exp(a[0]) : product_with_rate(a, exponential, k) * series_reciprocal[k];
}

/* Coefficient k + 1 of what has a rate with that coefficient k. */
KERNEL void integrate(real *series, int k, real rate) {
    series[k + 1] = rate * series_reciprocal[k + 1];
}

/* ---- whole sums --------------------------------------------------------------------------------------- */

/* Coefficient k of a b. */
static inline real product(const real *a, const real *b, int k) {
    real sum = broadcast(0.0);
    for (int i = 0; i <= k; ++i) {
        sum += a[i] * b[k - i];
    }
    return sum;
}

/* All coefficients of a b up to an order. Four sums at once: one would wait for each of its terms. */
static inline void all_products(const real *a, const real *b, int order, real *products) {
    int k = 0;
    for (; k + 3 <= order; k += 4) {
        real sum[4] = {broadcast(0.0), broadcast(0.0), broadcast(0.0), broadcast(0.0)};
        for (int i = 0; i <= k; ++i) {
            for (int next = 0; next < 4; ++next) {
                sum[next] += a[i] * b[k + next - i];
            }
        }
        for (int next = 0; next < 4; ++next) {
            for (int i = k + 1; i <= k + next; ++i) {
                sum[next] += a[i] * b[k + next - i];
            }
            products[k + next] = sum[next];
        }
    }
    for (; k <= order; ++k) {
        products[k] = product(a, b, k);
    }
}

/* Coefficient k of a b without the last coefficient of a: what a division still has to find. */
static inline real product_so_far(const real *a, const real *b, int k) {
    real sum = broadcast(0.0);
    for (int i = 0; i < k; ++i) {
        sum += a[i] * b[k - i];
    }
    return sum;
}

#endif
