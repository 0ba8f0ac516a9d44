/* Results of one instant: outputs by value, positions, modes, and an impact. */
#ifndef TDMF_TESTS_AT_INSTANT_H
#define TDMF_TESTS_AT_INSTANT_H

#include "contact_mode.h"
#include "kinematics.h"
#include "system_of.h"
#include "tdmf_slip/tdmf_slip.h"

/* The last stride and the last apex of a motion, and the time of its last event. */
tdmf_stride last_stride_of(const tdmf_motion *motion);
tdmf_apex last_apex_of(const tdmf_motion *motion);
double last_event_of(const tdmf_motion *motion);

/* Outputs of a motion, or of a structure that has a model, inputs and a motion, by a pointer to it. */
tdmf_outputs outputs_of(tdmf_system system, const tdmf_motion *motion);
#define OUTPUTS_OF(structure) outputs_of(SYSTEM_OF(structure), &(structure)->motion)

/* Applies the impact map (4)-(6) of the page to a state whose foot moves into the ground, and no other event.
 * Returns the energy lost, J. */
double impact_on(tdmf_system system, const tdmf_ground_line *ground, double state[TDMF_STATE_COUNT]);

#endif
