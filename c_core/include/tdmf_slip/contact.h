/* Ground forces of a sticking, slipping or absent contact. */
#ifndef TDMF_SLIP_CONTACT_H
#define TDMF_SLIP_CONTACT_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A force of the ground on the foot. */
typedef struct {
    double tangential, normal; /* N, of the ground on the foot, along the line and away from it */
} tdmf_ground_force;

/* The force the ground would have to apply to hold the foot still under a total hip torque, N.m, whatever
 * the mode (10). */
TDMF_API tdmf_ground_force tdmf_sticking_force(tdmf_system system, const tdmf_mode *mode, double torque,
                                               const double state[TDMF_STATE_COUNT]);

/* The force in the present mode: (10) in stick, f_t = -mu sgn(v_t) f_n in slip, zero in flight and graze. */
TDMF_API tdmf_ground_force tdmf_contact_force(tdmf_system system, const tdmf_mode *mode,
                                              const double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
