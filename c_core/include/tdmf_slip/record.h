/* The memory of a run: its events, the last completed stride, the last apex. */
#ifndef TDMF_SLIP_RECORD_H
#define TDMF_SLIP_RECORD_H

#include "tdmf_slip/internal/progress.h"
#include "tdmf_slip/stride.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The memory of a run. */
typedef struct {
    int event_count;        /* contact and phase changes since the start; changes at one instant count once */
    double last_event_time; /* s; the time of the start if there was no event */
    double impact_loss;     /* J, since the start */
    tdmf_stride stride;     /* the last completed stride */
    tdmf_apex apex;         /* the last apex */
    tdmf_progress progress; /* for the library only: do not read or write it */
} tdmf_record;

#ifdef __cplusplus
}
#endif
#endif
