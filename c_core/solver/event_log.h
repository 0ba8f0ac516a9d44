/* Logging of events that a solver has taken. */
#ifndef TDMF_SOLVER_EVENT_LOG_H
#define TDMF_SOLVER_EVENT_LOG_H

#include "tdmf_slip/solver.h"

#include <limits.h>

static inline void tdmf_log_event(const tdmf_solver *solver, const tdmf_event *event) {
    tdmf_event_log *log = solver->log;
    if (log != NULL && log->count < TDMF_EVENT_CAPACITY) {
        log->events[log->count] = *event;
    }
    if (log != NULL) {
        log->count += log->count < INT_MAX;
    }
    if (solver->on_event != NULL) {
        solver->on_event(solver->subject, event);
    }
}

#endif
