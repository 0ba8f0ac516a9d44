/* How far series may be trusted.
 *
 * A step is as long as the last two coefficients allow: were the series cut there, what is left out would be
 * as small as the tolerance, and no longer than coefficients can be trusted to fall from there on. On the
 * ground that is asked of the forces themselves, because events are located on them. */
#ifndef TDMF_KERNEL_STEP_SIZE_H
#define TDMF_KERNEL_STEP_SIZE_H

#include "pairs.h"
#include "powers.h"

/* Share of its length by which a leg may change in a step, in either direction. */
static const double max_length_change = 0.75;

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

/* How far series of an order may be trusted, but no further than `longest`; not a number where they are not
 * finite. */
static inline real trusted_size(const series_remainder *remainder, real longest, int order, real tolerance) {
    const mask known = is_finite(remainder->last + remainder->last_but_one);
    return select(known, real_min(longest, size_of_remainder(remainder, order, tolerance)), broadcast(NAN));
}

/* Where a leg does not turn, its motion is a sum of exponentials, whose coefficients fall sooner than those
 * of their square, the damper's power. `unit` is that of the leg's speed squared. */
static inline real size_for_loss(const real *speed_square, real unit, real size, int order,
                                 double tolerance) {
    series_remainder remainder = {broadcast(0.0), broadcast(0.0)};
    add_to_remainder(&remainder, speed_square, order, unit);
    const mask too_long = remainder.last * power_of(size, order) > tolerance;
    return any(too_long) ? select(too_long, trusted_size(&remainder, size, order, broadcast(tolerance)), size)
                         : size;
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

/* Where the length's coefficients add up to less than itself it has no zero for any complex time in reach:
 * what is divided by it has no pole there, which coefficients might not show, be it ever so weak. Shortens a
 * step for that, sets its powers and returns how much the length may change in it. */
static inline real shorten_without_pole(real *size, real power[SERIES_TERMS], const real *length, int order) {
    set_powers(power, *size, order);
    const real maximum = max_length_change * length[0];
    const real change = largest_change(length, power, order);
    const mask too_long = change > maximum;
    if (!any(too_long)) {
        return change;
    }
    *size = select(too_long, *size * maximum / change, *size);
    set_powers(power, *size, order);
    return select(too_long, maximum, change);
}

#endif
