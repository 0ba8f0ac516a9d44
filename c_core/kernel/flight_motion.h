/* Motion in flight with a push on the body or without, and how far its series may be trusted. */
#ifndef TDMF_KERNEL_FLIGHT_MOTION_H
#define TDMF_KERNEL_FLIGHT_MOTION_H

#include "flight_series.h"

static inline void expand_flight_by_case(const flight_coefficients *c, const flight_start *start, int order,
                                         bool pushed, flight_series *f) {
    tdmf_begin_flight(start, f);
    if (pushed) {
        expand_pushed_flight(c, order, f);
    } else {
        expand_flight(c, order, f);
    }
}

/* The first variation, of what the motion starts with by `d_start` and of the coefficients by `d`. */
static inline void vary_flight_by_case(const flight_coefficients *c, const flight_start *start,
                                       const flight_series *f, const flight_coefficients *d,
                                       const flight_start *d_start, int order, bool pushed,
                                       flight_variation *t) {
    tdmf_vary_begin_flight(start, d_start, t);
    if (pushed) {
        vary_pushed_flight(c, f, d, order, t);
    } else {
        vary_flight(c, f, d, order, t);
    }
}

/* How far series of an order may be trusted, whatever their coefficients. Where the leg comes to rest terms
 * grow up to the one whose index is rate times time, however little is left to decay: in a longer step the
 * last ones do not tell what is left out. */
static inline real longest_flight_step(const flight_coefficients *c, real length, int order, bool pushed) {
    return (double)order / tdmf_fastest_flight(c, length, pushed);
}

#endif
