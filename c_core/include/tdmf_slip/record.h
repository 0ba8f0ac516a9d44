/* What is remembered of a run: its events, the last completed stride, the last apex. */
#ifndef TDMF_SLIP_RECORD_H
#define TDMF_SLIP_RECORD_H

#include "tdmf_slip/internal/progress.h"
#include "tdmf_slip/stride.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is remembered of a run. */
typedef struct {
    int event_count;        /* contact and phase changes since the start; those of one chain are one */
    double last_event_time; /* s; the start time while there was none */
    double impact_loss;     /* J, since the start */
    tdmf_stride stride;     /* the last that closed */
    tdmf_apex apex;         /* the last */
    tdmf_progress progress; /* of use to the library only, and not to be read or written */
} tdmf_record;

#ifdef __cplusplus
}
#endif
#endif
