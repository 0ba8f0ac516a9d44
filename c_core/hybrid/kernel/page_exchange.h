/* Events of a run that another solver than the driver integrates. It finds an event a little late: whatever
 * is below zero is due, but for a guard that rises since its event was taken. */
#ifndef TDMF_KERNEL_PAGE_EXCHANGE_H
#define TDMF_KERNEL_PAGE_EXCHANGE_H

#include "page_instant.h"

#include <math.h>

/* Last view of an event's guard: not above zero, above it, or still below zero since its event was taken. */
typedef enum { WATCH_BELOW, WATCH_ABOVE, WATCH_RISING } watch_state;

/* A guard of the mode, in its scale, shifted so that it is zero where the driver takes the event. */
typedef struct {
    double value;
    bool is_watched;
    bool rises; /* it has risen to zero since its event was taken */
    bool is_due;
} guard_state;

/* The guards of the mode, in their order. `watch` has a watch_state for each event of the page. */
void tdmf_view_guards(const tdmf_page_instant *at, const unsigned char *watch,
                      guard_state guards[TDMF_GUARD_LIMIT]);

/* The longest step for a solver of low order, which follows a law less far than series do; infinite mostly.
 */
static inline double tdmf_longest_step_of_solver(const tdmf_mode_kind *mode, const double *p,
                                                 const double *x) {
    return mode->time_scale != NULL ? mode->time_scale(p, x) : INFINITY;
}

/* Notes the guards of the mode in `watch`. */
void tdmf_note_guards(const tdmf_page_instant *at, const guard_state *guards, unsigned char *watch);

/* Raises the largest values that the mode observes. */
void tdmf_note_largest(const tdmf_page_instant *at, double *x);

/* Notes in `watch` that an event was taken. */
void tdmf_note_taken(const tdmf_model_kind *model, int event, unsigned char *watch);

/* Takes an event that the mode of the run watches. The run's log is lost. */
tdmf_event_row tdmf_take_event_now(const tdmf_model_kind *model, const tdmf_guard_kind *kind,
                                   tdmf_page_run *run, unsigned char *watch);

/* The first and the last event of a chain in zero time, and their number. */
typedef struct {
    tdmf_event_row first, last;
    long count;
} tdmf_chain;

/* Takes the events that are due, in the page's order, until none is. False where they do not come to an end.
 * `memory` is that of an instant; the run has memory of its own. */
bool tdmf_take_due_events(const tdmf_model_kind *model, tdmf_page_run *run, unsigned char *watch,
                          double *memory, tdmf_chain *chain);

#endif
