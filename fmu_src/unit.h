/* The seam between a model and FMI: a run with its settings, whatever FMI version drives it. The structs are
 * in page/fmu.h.
 *
 * A refusal is written into a text of FMU_TEXT characters, and returned; NULL stands for success. */
#ifndef TDMF_FMU_UNIT_H
#define TDMF_FMU_UNIT_H

#include "fmu.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { FMU_TEXT = 256 };

/* Receives a sentence about every event that the unit takes. */
typedef struct {
    void (*on_event)(void *subject, const char *text); /* or NULL */
    void *subject;
} fmu_observer;

/* Result of an update at an instant. */
typedef struct {
    bool state_changed;
    bool unresolved; /* events go on without end */
} fmu_resolution;

/* Makes an fmu of zeros usable, for Model Exchange or for Co-Simulation. False: there is no memory. */
bool fmu_create(fmu *fmu, bool is_exchange);
void fmu_free(fmu *fmu);

/* Back to the start values of modelDescription.xml, at time 0. */
void fmu_reset(fmu *fmu);

/* Puts parameters that were set into force; on refusal the unit is left as it was. */
const char *fmu_prepare(fmu *fmu, char text[FMU_TEXT]);

/* Begins the run at its time from the values set so far; on refusal the unit is left as it was. */
const char *fmu_start(fmu *fmu, char text[FMU_TEXT]);
bool fmu_has_begun(const fmu *fmu);

double fmu_time(const fmu *fmu);
void fmu_set_time(fmu *fmu, double time);

/* Whether a clock may show this time: differences, sums and ratios of such times are numbers. */
static inline bool fmu_is_time(double time) {
    return fabs(time) <= 1e100;
}

void fmu_evaluate(const fmu *fmu, fmu_view *view);

/* The change along a direction of all that follows from states, inputs and settings. The direction is a unit
 * whose states, inputs and parameters are the seed. */
void fmu_differentiate(const fmu *fmu, const struct fmu *seed, fmu_view *variation);

/* The change at the start of a run, along a direction of all that a start follows from: the seed is in the
 * direction's parameters, inputs, states and time. `given` is the unit before fmu_start, `started` the one
 * after. States that the start calculates are written into the seed. */
void fmu_differentiate_start(const fmu *given, const struct fmu *started, struct fmu *seed,
                             fmu_view *variation);

/* The direction in which the unit itself moves: derivatives of its states, rates of its inputs. */
void fmu_flow(const fmu *fmu, struct fmu *seed);

/* The continuous states as an importer sees them; `view` is that of a run that has not begun, else NULL. */
void fmu_states(const fmu *fmu, const fmu_view *view, double states[]);

/* This is far beyond any motion, and far enough from overflow for every product of the equations. */
static const double fmu_largest_state = 1e60;

/* A value that is cut where it is beyond any motion. NaN counts as large. */
static inline double fmu_within_largest(double value) {
    const double bounded = value < fmu_largest_state ? value : fmu_largest_state;
    return bounded > -fmu_largest_state ? bounded : -fmu_largest_state;
}

/* Takes a solver's trial states, which are no NaN, and cuts them: so values that follow stay finite. */
void fmu_try_states(fmu *fmu, const double states[]);

/* Derivatives are cut as trial states are: an importer's solver then sees that its step was too long. */
void fmu_derivatives(const fmu *fmu, double derivatives[]);
void fmu_event_indicators(const fmu *fmu, double indicators[]);

/* Typical magnitudes of the states, from the parameters; importers make absolute tolerances of them. */
void fmu_nominals(const fmu *fmu, double nominals[]);

/* Model Exchange: notes what a completed step shows. True where event mode is needed, because an input whose
 * jumps change other states has changed. */
bool fmu_complete_step(fmu *fmu);

/* Event mode begins: before inputs may jump. */
void fmu_enter_event_mode(fmu *fmu);

/* Takes a pending event and resolves whatever else is due now. */
fmu_resolution fmu_update(fmu *fmu, const fmu_observer *observer);

/* Whether the run has ended, and its settings say that a simulation is to end there. */
bool fmu_asks_to_terminate(const fmu *fmu);

/* The longest step that an importer's solver may make from here; infinite mostly. */
double fmu_longest_step(const fmu *fmu);

/* Co-Simulation: moves the run on to `until`. A run that has ended stays readable, frozen. Returns why it got
 * no farther than fmu_time. */
const char *fmu_advance(fmu *fmu, double until, const fmu_observer *observer, char text[FMU_TEXT]);

/* Moves the run on as fmu_advance does, but stops at the first event on the way that counts: at its exact
 * time, before it is taken, with fmu->event_is_pending. */
const char *fmu_advance_to_event(fmu *fmu, double until, const fmu_observer *observer, char text[FMU_TEXT]);

/* Whether this build has the solver that the settings choose. */
bool fmu_has_solver(const fmu *fmu);

/* A time for a message, with a decimal point whatever the locale; returns `text`. */
enum { TIME_CAPACITY = 32 };
char *time_text(double time, char text[TIME_CAPACITY]);

#endif
