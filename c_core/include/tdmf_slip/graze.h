/* Graze: the foot rests on the ground without force, between the stance law that lifts it and the flight law
 * that presses it down. See graze.c. */
#ifndef TDMF_SLIP_GRAZE_H
#define TDMF_SLIP_GRAZE_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The total torque that keeps an unloaded foot at the ground, N.m. */
double tdmf_graze_torque(const tdmf_model *model, const double state[TDMF_STATE_COUNT]);

/* How hard each law, external torque included, presses a foot resting at y = vy = 0 on the ground, N;
 * negative where it lifts it. */
double tdmf_stance_press(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                         const double state[TDMF_STATE_COUNT]);
double tdmf_flight_press(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                         const double state[TDMF_STATE_COUNT]);

typedef enum { TDMF_FOOT_LOADED, TDMF_FOOT_LEAVES, TDMF_FOOT_GRAZES } tdmf_foot_fate;

/* What becomes of a foot at y = vy = 0 after an impact or at a start. `off_ground` is the mode it would have
 * without contact: phase and theta_LO of the flight law. */
tdmf_foot_fate tdmf_fate_at_rest(const tdmf_model *model, const tdmf_inputs *inputs,
                                 const tdmf_mode *off_ground, const double state[TDMF_STATE_COUNT]);

/* What becomes of a foot whose contact force has just vanished. */
tdmf_foot_fate tdmf_fate_at_lift_off(const tdmf_model *model, const tdmf_inputs *inputs,
                                     const tdmf_mode *off_ground, const double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
