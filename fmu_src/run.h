/* A run of a page, below the calls of FMI: coordinates and instants, the solvers of Co-Simulation, and jumps
 * of quantities that change other states. */
#ifndef TDMF_FMU_RUN_H
#define TDMF_FMU_RUN_H

#include "fmu.h"
#include "page_exchange.h"
#include "unit_tables.h"

/* ---- instant.c ----------------------------------------------------------------------------------------- */

/* Gives the unit its working memory, or NULL. */
double *allocate_memory(fmu *fmu);

/* The instant of a run, with the series of its mode up to the second coefficient. */
tdmf_page_instant instant_of(const fmu *fmu);

const tdmf_mode_kind *mode_of(const fmu *fmu);

/* The mode of a run, or the one before if its outputs and coordinates are kept. */
const tdmf_mode_kind *shown_mode_of(const fmu *fmu);
double *parameters_of(const fmu *fmu);
double *states_of(const fmu *fmu);

/* The name of the first parameter that is out of its range, or state that is larger than in any motion, or
 * NULL. */
const char *number_out_of_range(const double numbers[]);

/* Writes the world's states that follow from those of the mode, or the mode's from the world's. */
void show_to_world(fmu *fmu);
void take_from_world(fmu *fmu);

/* The variation of a view, along variations of parameters and of the states of the mode. */
void vary_at(const fmu *fmu, const double *dp, const double *dx, fmu_view *variation);

/* ---- drive.c ------------------------------------------------------------------------------------------- */

/* Makes a run of the driver from the state of the unit, and copies a run back. Times are the page's. */
tdmf_page_run run_of(fmu *fmu);
void keep_run(fmu *fmu, const tdmf_page_run *run);

bool has_arrived(tdmf_run_outcome outcome);

/* Reports events at one instant to an observer, with the states before the first and after the last. */
void report(const fmu *fmu, const struct instance *observer, const tdmf_event_row *first,
            const double *before, const tdmf_event_row *last, const double *after);

/* Takes the events that another solver finds due, until none is. False where they do not come to an end. */
bool settle(fmu *fmu, const struct instance *observer, tdmf_chain *chain);

/* Runs to `until` and reports every event. `events` receives the number of events. */
tdmf_run_outcome drive(fmu *fmu, double until, const struct instance *observer, long *events);

/* Runs up to the first event that counts, and stops just before it. */
tdmf_run_outcome drive_to_event(fmu *fmu, double until, tdmf_event_row *row);

/* ---- jumps.c ------------------------------------------------------------------------------------------- */

/* The guard of the event at which the run stands, in its scale; infinite if the mode does not watch it. */
double guard_of_pending_event(const fmu *fmu, const tdmf_guard_kind **kind);
extern const double rounding_at_event; /* largest such guard where its event was found */

/* Records that all jumps so far have had their effects. */
void account_for_all(fmu *fmu);

/* True if a quantity has jumped since account_for_all or account_for_jumps. */
bool quantity_has_jumped(const fmu *fmu);

/* Changes the states that depend on jumps since the last record, and records them. True if there was a jump.
 */
bool account_for_jumps(fmu *fmu);

/* Changes the states that depend on inputs that an importer's solver has moved along the last step. */
bool account_for_drifts(fmu *fmu);

/* Takes events that are due wherever their conditions hold, such as that an input acts: no indicator shows
 * them. */
void take_immediate_events(fmu *fmu);

#endif
