/* Values of series and of their integrals at a time. */
#ifndef TDMF_KERNEL_SERIES_SUMS_H
#define TDMF_KERNEL_SERIES_SUMS_H

#include "series.h"

/* Gives the sum of c[k] t^k, k = 0 to order. */
static inline double series_at(const double *c, int order, double t) {
    double value = c[order];
    for (int k = order - 1; k >= 0; --k) {
        value = value * t + c[k];
    }
    return value;
}

/* Gives the integral of the sum of c[k] t^k from 0 to t. */
static inline double series_integral(const double *c, int order, double t) {
    double value = c[order] * series_reciprocal[order + 1];
    for (int k = order - 1; k >= 0; --k) {
        value = value * t + c[k] * series_reciprocal[k + 1];
    }
    return value * t;
}

#endif
