/* Coefficients of products and quotients of series, and of their variations: d_ stands for the variation of
 * what follows. `real` has been defined. */
#ifndef TDMF_KERNEL_SERIES_PRODUCTS_H
#define TDMF_KERNEL_SERIES_PRODUCTS_H

#include "series.h"
#include "width.h"

/* Coefficient k of a b. */
static inline real product(const real *a, const real *b, int k) {
    real sum = real_of(0.0);
    for (int i = 0; i <= k; ++i) {
        sum += a[i] * b[k - i];
    }
    return sum;
}

/* The same without the last coefficient of a: what a division still has to find. */
static inline real product_so_far(const real *a, const real *b, int k) {
    real sum = real_of(0.0);
    for (int i = 0; i < k; ++i) {
        sum += a[i] * b[k - i];
    }
    return sum;
}

static inline real vary_product(const real *a, const real *d_a, const real *b, const real *d_b, int k) {
    return product(d_a, b, k) + product(a, d_b, k);
}

/* Of q, where q b = p: from d_p, and d_q up to k - 1. */
static inline real vary_quotient(const real *q, const real *d_q, const real *b, const real *d_b, real d_p,
                                 int k) {
    return (d_p - product(q, d_b, k) - product_so_far(d_q, b, k)) / b[0];
}

#endif
