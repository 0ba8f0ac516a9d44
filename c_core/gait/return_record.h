/* What both maps make of a stride: its outcome, its quantities, and how those of the stance vary. */
#ifndef TDMF_GAIT_RETURN_RECORD_H
#define TDMF_GAIT_RETURN_RECORD_H

#include "tdmf_slip/return_map.h"

/* What a solver's call for a stride, or for its stance, has come to. */
tdmf_return_outcome tdmf_return_outcome_of(tdmf_stride_outcome ended);

/* Writes the quantities of the stride that the record closed last, in a run that began with it; `state` has
 * what is lost up to the end of the stance. */
void tdmf_write_return(const tdmf_record *record, const double state[TDMF_STATE_COUNT], tdmf_return *result);

#endif
