/* Values of series and of their integrals at a time in a step. */
#ifndef TDMF_KERNEL_STEP_SUMS_H
#define TDMF_KERNEL_STEP_SUMS_H

#include "powers.h"

/* Powers of a time, and what they integrate to. */
typedef struct {
    real power[SERIES_TERMS], integral[SERIES_TERMS];
} elapsed_time;

/* `power` are those of the size of the step. */
static inline void set_elapsed(elapsed_time *elapsed, const real *power, real size, real t, int order) {
    if (any(not(t == size))) {
        set_powers(elapsed->power, t, order);
    } else {
        for (int k = 0; k <= order; ++k) {
            elapsed->power[k] = power[k];
        }
    }
    for (int k = 0; k <= order; ++k) {
        elapsed->integral[k] = t * elapsed->power[k] * series_reciprocal[k + 1];
    }
}

/* The sum of c[k] weights[k] from k = `first` on, smallest terms first. */
static inline real weighted_sum(const real *c, const real *weights, int first, int order) {
    real sum = c[order] * weights[order];
    for (int k = order - 1; k >= first; --k) {
        sum += c[k] * weights[k];
    }
    return sum;
}

static inline real value_at(const real *c, const elapsed_time *elapsed, int order) {
    return weighted_sum(c, elapsed->power, 0, order);
}

static inline real integral_to(const real *c, const elapsed_time *elapsed, int order) {
    return weighted_sum(c, elapsed->integral, 0, order);
}

#endif
