/* The run of an instance, below the calls of FMI: values at an instant, the start, the solvers of
 * Co-Simulation, and jumps of quantities that change other states. */
#ifndef TDMF_FMU_RUN_H
#define TDMF_FMU_RUN_H

#include "instance.h"
#include "page_exchange.h"
#include "unit_tables.h"

static inline const tdmf_mode_kind *mode_of(const instance *fmu) {
    return &unit_model->modes[fmu->run.motion.mode];
}

/* The mode of a run, or the one before if its outputs and coordinates are kept. */
static inline const tdmf_mode_kind *shown_mode_of(const instance *fmu) {
    return &unit_model->modes[fmu->run.motion.shown];
}

/* Limits a value to the largest state. NaN counts as large. */
static inline double within_largest(double value) {
    const double bounded = value < fmu_largest_state ? value : fmu_largest_state;
    return bounded > -fmu_largest_state ? bounded : -fmu_largest_state;
}

/* ---- instant.c: values at an instant ------------------------------------------------------------------- */

/* Gives the instance its working memory, or NULL. */
double *allocate_memory(instance *fmu);

/* The instant of a run, with the series of its mode up to the second coefficient. */
tdmf_page_instant instant_of(const instance *fmu);

/* The name of the first parameter that is out of its range, or state that is larger than in any motion, or
 * NULL. NaN is out of every range. */
const char *number_out_of_range(const double numbers[]);

/* Writes the world's states that follow from those of the mode, or the mode's from the world's. */
void show_to_world(instance *fmu);
void take_from_world(instance *fmu);

/* Computes the values of a storage in the view. */
void evaluate(instance *fmu, fmu_storage storage);

/* ---- run.c: start and events --------------------------------------------------------------------------- */

/* True if all requirements of the page are met: those of parameters alone, or those of a start. */
bool requirements_are_met(instance *fmu, bool of_parameters);

/* Begins the run at its time from the values set so far. */
bool start(instance *fmu);

/* Puts start values in coordinates other than the world's into the states, and sets the clocks. */
void begin_time(instance *fmu);

/* The guard of the pending event, in its scale; infinite if the mode does not watch it. */
double guard_of_pending_event(const instance *fmu, const tdmf_guard_kind **kind);
extern const double rounding_at_event; /* largest such guard where its event was found */

/* Takes events that are due wherever their conditions hold, such as that an input acts: no indicator shows
 * them. */
void take_immediate_events(instance *fmu);

/* ---- drive.c: solvers of Co-Simulation ----------------------------------------------------------------- */

/* Makes a run of the driver from the motion, and copies a run back. Times are the page's. */
tdmf_page_run run_of(instance *fmu);
void keep_run(instance *fmu, const tdmf_page_run *run);

bool has_arrived(tdmf_run_outcome outcome);

/* Reports events at one instant, with the states before the first and after the last. */
void report(const instance *fmu, const tdmf_event_row *first, const double *before,
            const tdmf_event_row *last, const double *after);

/* Takes the events that another solver finds due, until none is. False where they do not come to an end. */
bool settle(instance *fmu, bool reports, tdmf_chain *chain);

/* Runs to `until`. `events` receives the number of events. With `stop`, the run ends just before the first
 * event that counts: TDMF_RUN_STOPPED. `stop` is then that event. */
tdmf_run_outcome drive(instance *fmu, double until, bool reports, tdmf_event_row *stop, long *events);

/* ---- jumps.c: jumps of quantities that change other states --------------------------------------------- */

/* Records that all jumps so far have had their effects. */
void account_for_all(instance *fmu);

/* True if a quantity has jumped since account_for_all or account_for_jumps. */
bool quantity_has_jumped(const instance *fmu);

/* Changes the states that depend on jumps since the last record, and records them. True if there was a jump.
 */
bool account_for_jumps(instance *fmu);

/* Changes the states that depend on inputs that an importer's solver has moved along the last step. */
bool account_for_drifts(instance *fmu);

#endif
