/* Powers and roots. */
#ifndef TDMF_KERNEL_POWERS_H
#define TDMF_KERNEL_POWERS_H

#include "series.h"
#include "width.h"

#include <float.h>

/* Powers are made by halves, because each product waits for its factors; there is one more than asked for
 * where `order` is even. */
static inline void set_powers(real power[SERIES_TERMS], real t, int order) {
    power[0] = broadcast(1.0);
    power[1] = t;
    for (int half = 1; 2 * half <= order; ++half) {
        power[2 * half] = power[half] * power[half];
        power[2 * half + 1] = power[half] * power[half + 1];
    }
}

static inline real power_of(real x, int n) {
    real power = broadcast(1.0);
    for (; n > 0; n >>= 1, x *= x) {
        if (n & 1) {
            power *= x;
        }
    }
    return power;
}

/* x^(1/n) within four per cent, the same on every platform, for x >= 0; infinity where x is no finite double.
 * A number's bits, read as an integer, are nearly its logarithm. */
static inline real rough_root(real x, int n) {
    const double zero = 1072693248.0; /* the high half of 1.0 */
    const real logarithm = high_half(x) - zero;
    const real root = 0.97 * with_high_half(zero + logarithm * (1.0 / n));
    return select(x <= DBL_MAX, root, broadcast(INFINITY));
}

#endif
