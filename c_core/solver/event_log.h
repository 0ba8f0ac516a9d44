/* How a solver notes an event that it has taken. */
#ifndef TDMF_SOLVER_EVENT_LOG_H
#define TDMF_SOLVER_EVENT_LOG_H

#include "tdmf_slip/solver.h"

#include <limits.h>

static inline void tdmf_log_event(tdmf_event_log *log, const tdmf_event *event) {
    if (log != NULL && log->count < TDMF_EVENT_CAPACITY) {
        log->events[log->count] = *event;
    }
    if (log != NULL) {
        log->count += log->count < INT_MAX;
    }
}

#endif
