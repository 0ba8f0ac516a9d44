/* Events of a run that another solver than the driver integrates. It finds an event a little late: whatever
 * is below zero is due, but for a guard that rises since its event was taken. */
#ifndef TDMF_KERNEL_PAGE_EXCHANGE_H
#define TDMF_KERNEL_PAGE_EXCHANGE_H

#include "page_instant.h"

/* Last view of an event's guard: not above zero, above it, or still below zero since its event was taken. */
typedef enum { WATCH_BELOW, WATCH_ABOVE, WATCH_RISING } watch_state;

/* A guard of the mode, in its scale, shifted so that it is zero where the driver takes the event. */
typedef struct {
    double value;
    bool is_watched;
    bool rises; /* to zero, since its event was taken */
    bool is_due;
} guard_state;

/* The guards of the mode, in their order. `watch` has a watch_state for each event of the page. */
void tdmf_view_guards(const tdmf_page_instant *at, const unsigned char *watch,
                      guard_state guards[TDMF_GUARD_LIMIT]);

/* Notes the guards of the mode in `watch`. */
void tdmf_note_guards(const tdmf_page_instant *at, const guard_state *guards, unsigned char *watch);

/* Raises the largest values that the mode observes. */
void tdmf_note_largest(const tdmf_page_instant *at, double *x);

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
