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
    elapsed->power[0] = broadcast(1.0);
    elapsed->integral[0] = t;
    if (any(mask_not(t == size))) {
        set_powers(elapsed->power, t, order);
    } else {
        for (int k = 1; k <= order; ++k) {
            elapsed->power[k] = power[k];
        }
    }
    for (int k = 1; k <= order; ++k) {
        elapsed->integral[k] = t * elapsed->power[k] * series_reciprocal[k + 1];
    }
}

/* The sum of c[k] weights[k] from k = 1 on. Four sums at once: one would wait for each of its terms. */
static inline real sum_of_rest(const real *c, const real *weights, int order) {
    real sum[4] = {broadcast(0.0), broadcast(0.0), broadcast(0.0), broadcast(0.0)};
    int k = 1;
    for (; k + 3 <= order; k += 4) {
        for (int i = 0; i < 4; ++i) {
            sum[i] += c[k + i] * weights[k + i];
        }
    }
    for (; k <= order; ++k) {
        sum[3] += c[k] * weights[k];
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static inline real change_to(const real *c, const elapsed_time *elapsed, int order) {
    return sum_of_rest(c, elapsed->power, order);
}

static inline real value_at(const real *c, const elapsed_time *elapsed, int order) {
    return c[0] + change_to(c, elapsed, order);
}

static inline real integral_to(const real *c, const elapsed_time *elapsed, int order) {
    return c[0] * elapsed->integral[0] + sum_of_rest(c, elapsed->integral, order);
}

#endif
