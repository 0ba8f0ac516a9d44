/* Instants finer than a double can tell: where time counts the seconds of an epoch, a double is good to 2e-7
 * s. */
#ifndef TDMF_SLIP_INSTANT_H
#define TDMF_SLIP_INSTANT_H

#include "tdmf_slip/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A time as the unevaluated sum of two doubles. */
typedef struct {
    double time; /* s */
    double rest; /* s, what rounding has left out of `time` */
} tdmf_instant;

/* The instant `elapsed`, s, after another. */
TDMF_API tdmf_instant tdmf_instant_after(tdmf_instant from, double elapsed);

/* s, negative where `to` is before `from`. */
TDMF_API double tdmf_time_between(tdmf_instant from, tdmf_instant to);

#ifdef __cplusplus
}
#endif
#endif
