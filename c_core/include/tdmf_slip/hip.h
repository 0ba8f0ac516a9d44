/* The hip's control law, (11) and (12) of the paper with three corrections (see hip.c). */
#ifndef TDMF_SLIP_HIP_H
#define TDMF_SLIP_HIP_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Torque of the stance law (11), N.m: -tau0 while mid-stance is to come, then 0. */
double tdmf_hip_stance_law(const tdmf_model *model, const tdmf_mode *mode);

/* Argument of the clamp in (12), N.m: what the retract law would apply without the clamp. */
double tdmf_hip_retract_argument(const tdmf_model *model, const tdmf_mode *mode,
                                 const double state[TDMF_STATE_COUNT]);

/* Torque of the flight law (12), N.m: retract with its clamp at 0, or place, as the phase says. */
double tdmf_hip_flight_law(const tdmf_model *model, const tdmf_mode *mode,
                           const double state[TDMF_STATE_COUNT]);

/* Total torque on the hip, N.m: the law of the present mode plus the external torque; in graze the torque
 * that holds the foot at the ground. */
double tdmf_hip_torque(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                       const double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
