/* How the automaton keeps its record: called at every change, before and after it. */
#ifndef TDMF_MODEL_RECORD_H
#define TDMF_MODEL_RECORD_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"
#include "tdmf_slip/stride.h"

/* A time given to the automaton, as fine as the solver knows it. */
tdmf_instant tdmf_record_instant(const tdmf_record *record, double time);

void tdmf_record_start(tdmf_record *record, double time, const double state[TDMF_STATE_COUNT]);

void tdmf_record_event(tdmf_record *record, double time);

void tdmf_record_impact(tdmf_record *record, double loss);

/* The contact mode `left` is over; another begins now. */
void tdmf_record_contact_change(tdmf_record *record, double time, const tdmf_mode *left,
                                tdmf_contact_mode entered, const double state[TDMF_STATE_COUNT]);

/* A ground force that was met, across the ground and vertically; the stride keeps the largest of each. */
void tdmf_record_force(tdmf_record *record, double normal, double vertical);

/* An apex in flight: latches the section, closes the stride under way if it began at an apex, opens the next.
 */
void tdmf_record_apex(tdmf_record *record, const tdmf_model *model, const tdmf_ground_line *ground,
                      double time, const double state[TDMF_STATE_COUNT]);

#endif
