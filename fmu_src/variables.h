/* The unit's table of variables. Its rows are generated from modelDescription.xml; a row's position is the
 * variable's value reference. */
#ifndef TDMF_UNIT_VARIABLES_H
#define TDMF_UNIT_VARIABLES_H

#include "unit.h"

#include <stdbool.h>
#include <stddef.h>

/* A set of them says what a call takes. */
typedef enum {
    VARIABLE_REAL = 1 << 0,
    VARIABLE_INTEGER = 1 << 1,
    VARIABLE_ENUMERATION = 1 << 2,
    VARIABLE_BOOLEAN = 1 << 3,
    VARIABLE_STRING = 1 << 4
} unit_variable_type;

typedef enum {
    STORED_TIME,
    STORED_PARAMETER,  /* offset in tdmf_parameters */
    STORED_SETTING,    /* offset in unit_settings */
    STORED_INPUT,      /* offset in tdmf_inputs */
    STORED_STATE,      /* index in the state vector */
    STORED_DERIVATIVE, /* index in the state vector */
    STORED_OUTPUT,     /* offset in tdmf_outputs */
    STORED_GUARD,      /* tdmf_guard */
    STORED_WORK        /* offset in unit_work */
} unit_storage;

typedef enum {
    VARIABILITY_FIXED,
    VARIABILITY_TUNABLE,
    VARIABILITY_DISCRETE,
    VARIABILITY_CONTINUOUS
} unit_variability;

typedef struct {
    const char *name;
    const char *unit;
    unit_variable_type type;
    unit_storage storage;
    size_t place;
    unit_variability variability;
    bool settable_before_start;
    bool changes_at_events; /* FMI's reinit: a state that an event may make jump */
    double minimum, maximum, start;
} unit_variable;

extern const unit_variable unit_variables[];
extern const size_t unit_variable_count;

/* Whether the importer may change it in a run, but at events only: a tunable parameter or a discrete input.
 */
bool unit_is_set_at_events(const unit_variable *variable);

/* Names of the enumerations' items, from value 1 on. */
extern const char *const unit_contact_mode_names[];
extern const char *const unit_hip_phase_names[];

/* Why the variable may not have this value; `.variable` is NULL where it may. */
tdmf_refusal unit_refuse_value(const unit_variable *variable, double value);

/* A numeric variable's value; outputs and derivatives are read from `view`. */
double unit_get_number(const unit *unit, const unit_view *view, const unit_variable *variable);

/* The text of a String variable, owned by `view`. */
const char *unit_get_text(const unit_view *view, const unit_variable *variable);

/* Stores a value that was checked. */
void unit_set_number(unit *unit, const unit_variable *variable, double value);

/* How fast an input changes, per second. */
double unit_get_number_rate(const unit *unit, const unit_variable *input);
void unit_set_number_rate(unit *unit, const unit_variable *input, double rate);

#endif
