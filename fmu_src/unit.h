/* The seam between the physics and FMI: a runner with its settings, whatever FMI version drives it. Plain
 * data without a pointer, so that copying a unit saves the whole run. */
#ifndef TDMF_UNIT_H
#define TDMF_UNIT_H

#include "tdmf_slip/tdmf_slip.h"

/* Parameters of the unit rather than of the runner. Member paths are variable names, as in the core. */
typedef struct {
    struct {
        int terminate_on_fall;
    } status;
} unit_settings;

typedef struct {
    unit_settings settings;
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    tdmf_model model;
    double time;
    double state[TDMF_STATE_COUNT];
    tdmf_mode mode;
    tdmf_record record;
} unit;

/* What follows from a unit and is computed when somebody looks. */
typedef struct {
    tdmf_outputs outputs;
    double derivatives[TDMF_STATE_COUNT];
} unit_view;

/* Back to the start values of modelDescription.xml, at time 0. */
void unit_reset(unit *unit);

/* Begins the run at unit->time from the values set so far; on refusal the unit is left as it was. */
tdmf_refusal unit_start(unit *unit);

void unit_look(const unit *unit, unit_view *view);

/* Takes a solver's trial state. Values beyond any motion are cut, so that all that follows stays finite;
 * false, and nothing taken, if one is not a number. */
bool unit_try_state(unit *unit, const double state[TDMF_STATE_COUNT]);

void unit_event_indicators(const unit *unit, double indicators[TDMF_GUARD_COUNT]);

/* Typical magnitudes of the states, from the parameters; importers make absolute tolerances of them. */
void unit_nominals(const unit *unit, double nominals[TDMF_STATE_COUNT]);

/* To be called before an input may jump. */
void unit_observe(unit *unit);

/* Resolves whatever is due at unit->time. */
tdmf_resolution unit_update(unit *unit);

#endif
