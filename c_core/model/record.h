/* How the automaton keeps its record: called at every change, before and after it. */
#ifndef TDMF_MODEL_RECORD_H
#define TDMF_MODEL_RECORD_H

#include "tdmf_slip/motion.h"
#include "tdmf_slip/parameters.h"

/* The time of a motion, as fine as the solver knows it. Set by a caller, it may be elsewhere than where the
 * solver left off. */
tdmf_instant tdmf_instant_of(const tdmf_motion *motion);

void tdmf_record_start(tdmf_motion *motion);

void tdmf_record_event(tdmf_motion *motion);

void tdmf_record_impact(tdmf_record *record, double loss);

/* The contact mode that the motion is in is over; another begins now. */
void tdmf_record_contact_change(tdmf_motion *motion, tdmf_contact_mode entered);

/* A ground force that was met, across the ground and vertically; the stride keeps the largest of each. */
void tdmf_record_force(tdmf_record *record, double normal, double vertical);

/* An apex in flight: latches the section, closes the stride under way if it began at an apex, opens the next.
 */
void tdmf_record_apex(tdmf_motion *motion, const tdmf_model *model);

#endif
