/* What the leg's thrust, which begins here, makes of a run. */
#ifndef TDMF_MODEL_GREATEST_COMPRESSION_H
#define TDMF_MODEL_GREATEST_COMPRESSION_H

#include "events.h"

/* The thrust of a leg in contact that does not shorten, if it is not on yet. It is on even if it is 0, so
 * that it acts at once where it is set later. */
void tdmf_thrust_if_due(tdmf_run *run);

/* Flight has begun. */
void tdmf_end_thrust(tdmf_run *run);

/* Brings leg.work up to the rest length in force: thrust, input or setting have changed it. */
void tdmf_account_for_rest_length(tdmf_run *run);

#endif
