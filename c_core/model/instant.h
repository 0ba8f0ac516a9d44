/* Instants finer than a double can tell. */
#ifndef TDMF_MODEL_INSTANT_H
#define TDMF_MODEL_INSTANT_H

#include "tdmf_slip/motion.h"

/* The time of a motion, as fine as the solver knows it. Set by a caller, it may be elsewhere than where the
 * solver left off. */
tdmf_instant tdmf_instant_of(const tdmf_motion *motion);

/* The instant `elapsed`, s, after another. */
tdmf_instant tdmf_instant_after(tdmf_instant from, double elapsed);

/* s, negative where `to` is before `from`. */
double tdmf_time_between(tdmf_instant from, tdmf_instant to);

#endif
