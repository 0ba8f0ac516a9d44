/* Work of a leg whose extension is changed from outside, by an importer's solver that integrates the motion
 * and does not tell how fast its inputs change. */
#ifndef TDMF_SLIP_EXTENSION_H
#define TDMF_SLIP_EXTENSION_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The leg at an instant. */
typedef struct {
    double time;        /* s */
    double length;      /* r, m */
    double length_rate; /* m/s */
} tdmf_leg_sample;

/* Takes the leg of a state at `time`, s. */
TDMF_API tdmf_leg_sample tdmf_leg_sample_of(double time, const double state[TDMF_STATE_COUNT]);

/* The leg's work, J, while its rest length went from that of mode->rest_length, at `before`, to the one in
 * force, at `after`, without an event between; sets mode->rest_length. The result is of fourth order in
 * the time between where the rest length changed linearly, of second order elsewhere, and exact where no time
 * passed. */
TDMF_API double tdmf_account_for_extension(tdmf_system system, const tdmf_leg_sample *before,
                                           const tdmf_leg_sample *after, tdmf_mode *mode);

#ifdef __cplusplus
}
#endif
#endif
