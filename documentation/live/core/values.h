/* Messages of refusals, and outputs in the order of the page's table. */
#ifndef LIVE_VALUES_H
#define LIVE_VALUES_H

#include "live.h"

/* Returns whether a value was refused. The message then names it; otherwise it is empty. */
bool live_refused(const tdmf_refusal *refusal);

/* Fills the array of outputs. */
void live_write_outputs(const tdmf_outputs *outputs, const double state[TDMF_STATE_COUNT]);

#endif
