/* Step size from the last two coefficients of the series. The truncation error at the end of such a step is
 * as small as the tolerance. */
#ifndef TDMF_KERNEL_STEP_SIZE_H
#define TDMF_KERNEL_STEP_SIZE_H

#include "pairs.h"
#include "powers.h"

/* The last two coefficients, summed over the coordinates in their units, so that one that is not a number
 * shows.
 */
typedef struct {
    real last, last_but_one;
} series_remainder;

static inline void add_to_remainder(series_remainder *remainder, const real *c, int order, real unit) {
    const real allowed = 1.0 / real_max(unit, real_abs(c[0]));
    remainder->last += real_abs(c[order]) * allowed;
    remainder->last_but_one += real_abs(c[order - 1]) * allowed;
}

/* The time at which neither of the last two terms is larger than the tolerance. */
static inline real size_of_remainder(const series_remainder *remainder, int order, real tolerance) {
    return real_min(rough_root(tolerance / remainder->last, order),
                    rough_root(tolerance / remainder->last_but_one, order - 1));
}

/* Sum of |c[k]| power[k] from k = 1 on: within a complex time of that size a series differs by no more from
 * its first coefficient. */
static inline real largest_change(const real *c, const real *power, int order) {
    pair first = pair_of(broadcast(0.0), broadcast(0.0)), second = first;
    int k = 1;
    for (; k + 3 <= order; k += 4) {
        add_magnitudes(&first, c + k, power + k);
        add_magnitudes(&second, c + k + 2, power + k + 2);
    }
    real sum = part_of(first, 0);
    for (; k <= order; ++k) {
        sum += power[k] * real_abs(c[k]);
    }
    return (sum + part_of(first, 1)) + (part_of(second, 0) + part_of(second, 1));
}

#endif
