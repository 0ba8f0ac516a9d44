/* The hip's control law, (11) and (12) of the paper with three corrections (see pages/hip.py). */
#ifndef TDMF_SLIP_HIP_H
#define TDMF_SLIP_HIP_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Gives the total torque on the hip, N.m: the law of the present mode plus the external torque; in graze the
 * torque that holds the foot at the ground; not a number where contact or phase are none. */
TDMF_API double tdmf_hip_torque(tdmf_system system, const tdmf_mode *mode,
                                const double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
