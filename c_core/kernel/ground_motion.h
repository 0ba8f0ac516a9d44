/* Motion on the ground in any case, and how far its series may be trusted. */
#ifndef TDMF_KERNEL_GROUND_MOTION_H
#define TDMF_KERNEL_GROUND_MOTION_H

#include "falling_slip_series.h"
#include "graze_series.h"
#include "slip_series.h"
#include "stick_series.h"

/* Which terms there are. The foot is free unless it sticks; slip and graze exclude each other. Where there is
 * no torque, nothing turns the leg. */
typedef struct {
    bool slips, grazes, has_torque;
    bool falls;        /* in slip, friction with speed */
    bool meets_border; /* of a patch: one that slips has it ahead, one at rest stands on it */
} ground_case;

static inline void expand_ground(const ground_coefficients *c, const ground_start *start, int order,
                                 ground_case is, ground_series *g) {
    tdmf_begin_ground(start, g);
    if (is.grazes) {
        expand_graze(c, order, g);
    } else if (is.slips && is.falls) {
        expand_falling_slip(c, order, g);
    } else if (is.slips && is.has_torque) {
        expand_slip_with_torque(c, order, g);
    } else if (is.slips) {
        expand_slip(c, order, g);
    } else if (is.has_torque) {
        expand_stick_with_torque(c, order, g);
    } else {
        expand_stick(c, order, g);
    }
}

/* The first variation, of what the motion starts with by `d_start` and of the coefficients by `d`. */
static inline void vary_ground(const ground_coefficients *c, const ground_start *start,
                               const ground_series *g, const ground_coefficients *d,
                               const ground_start *d_start, int order, ground_case is, ground_variation *t) {
    const real zero = broadcast(0.0);
    const bool has_torque =
        is.has_torque || any(mask_not(d->torque == zero) | mask_not(d->torque_rate == zero));
    tdmf_vary_begin_ground(start, d_start, t);
    if (is.grazes) {
        vary_graze(c, g, d, order, t);
    } else if (is.slips && is.falls) {
        vary_falling_slip(c, g, d, order, t);
    } else if (is.slips && has_torque) {
        vary_slip_with_torque(c, g, d, order, t);
    } else if (is.slips) {
        vary_slip(c, g, d, order, t);
    } else if (has_torque) {
        vary_stick_with_torque(c, g, d, order, t);
    } else {
        vary_stick(c, g, d, order, t);
    }
}

/* As longest_flight_step. */
static inline real longest_ground_step(const ground_coefficients *c, bool free, int order) {
    return (double)order / tdmf_fastest_ground(c, free);
}

#endif
