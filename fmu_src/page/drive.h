/* Solvers of Co-Simulation on a page: its driver, and CVODE. Times are the page's. */
#ifndef TDMF_PAGE_DRIVE_H
#define TDMF_PAGE_DRIVE_H

#include "unit_instant.h"

/* A run of the driver from where the unit stands, and the unit where it has got to. */
tdmf_page_run run_of(fmu *fmu);
void keep_run(fmu *fmu, const tdmf_page_run *run);

/* Sets the page's clock to the time of the motion, from which its own steps are rounded away; and what it has
 * written down at this instant. */
void set_clock(fmu *fmu);

bool has_arrived(tdmf_run_outcome outcome);

/* Whether an event counts, or ends the run. */
bool is_counted(const tdmf_event_row *row);

/* Reports events at one instant, with the states before the first and after the last of them. */
void report(const fmu *fmu, const fmu_observer *observer, const tdmf_event_row *first, const double *before,
            const tdmf_event_row *last, const double *after);

/* Takes the events that another solver finds due, until none is. False where they do not come to an end. */
bool settle(fmu *fmu, const fmu_observer *observer, bool *changed);

/* Goes on, and reports every event if there is an observer. `events` receives the number of events. */
tdmf_run_outcome drive(fmu *fmu, double until, const fmu_observer *observer, long *events);

/* Goes on up to the first event that counts, and stands before it then. */
tdmf_run_outcome drive_to_event(fmu *fmu, double until, tdmf_event_row *row);

/* Writes in a sentence why a run has ended. */
const char *message(fmu *fmu, tdmf_run_outcome outcome, char text[FMU_TEXT]);

#endif
