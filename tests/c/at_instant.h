/* Results of one instant: outputs by value, positions, modes, and an impact. */
#ifndef TDMF_TESTS_AT_INSTANT_H
#define TDMF_TESTS_AT_INSTANT_H

#include "contact_mode.h"
#include "kinematics.h"
#include "tdmf_slip/tdmf_slip.h"

/* The outputs of a motion, and those of a mode and a state. */
tdmf_outputs outputs_of(tdmf_system system, const tdmf_motion *motion);
tdmf_outputs outputs_at(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]);

/* Applies the impact map (4)-(6) of the page to a state whose foot moves into the ground, and no other event.
 * Returns the energy lost, J. */
double impact_on(tdmf_system system, const tdmf_ground_line *ground, double state[TDMF_STATE_COUNT]);

#endif
