/* The unit's table of variables. Its rows are generated; a row's position is the variable's value reference.
 */
#ifndef TDMF_FMU_VARIABLES_H
#define TDMF_FMU_VARIABLES_H

#include "fmu.h"

#include <stdbool.h>
#include <stddef.h>

/* Types of variables. A set of them says which types a call takes. */
typedef enum {
    VARIABLE_REAL = 1 << 0,
    VARIABLE_INTEGER = 1 << 1,
    VARIABLE_ENUMERATION = 1 << 2,
    VARIABLE_BOOLEAN = 1 << 3,
    VARIABLE_STRING = 1 << 4
} fmu_variable_type;

/* The storage of a variable: up to STORED_START in the run, else in the view. */
typedef enum {
    STORED_TIME,
    STORED_PARAMETER,
    STORED_SETTING, /* a setting of the unit, not of its model */
    STORED_INPUT,
    STORED_STATE,      /* number of a continuous state */
    STORED_START,      /* start value of a state that the unit does not show */
    STORED_DERIVATIVE, /* number of the state */
    STORED_OUTPUT,
    STORED_HELD, /* a state of the model that changes at events only */
    STORED_GUARD,
    STORED_WORK /* counter of the solver in Co-Simulation */
} fmu_storage;

typedef enum {
    VARIABILITY_FIXED,
    VARIABILITY_TUNABLE,
    VARIABILITY_DISCRETE,
    VARIABILITY_CONTINUOUS
} fmu_variability;

typedef struct {
    const char *name;
    const char *unit;
    fmu_variable_type type;
    fmu_storage storage;
    size_t offset; /* index in the array that the storage names */
    fmu_variability variability;
    bool settable_before_start;
    bool changes_at_events; /* FMI's reinit: a state that an event may make jump */
    double minimum, maximum, start;
} fmu_variable;

extern const fmu_variable fmu_variables[];
extern const size_t fmu_variable_count;

/* True for a tunable parameter or a discrete input: an importer may change it in a run, but at events only.
 */
static inline bool fmu_is_set_at_events(const fmu_variable *variable) {
    return variable->variability == VARIABILITY_TUNABLE ||
           (variable->storage == STORED_INPUT && variable->variability == VARIABILITY_DISCRETE);
}

/* The reason why a variable may not have this value, written into `text`; NULL if it may. */
const char *fmu_refuse_value(const fmu_variable *variable, double value, char text[FMU_TEXT]);

/* A numeric variable's value; outputs and derivatives are read from `view`. */
double fmu_get_number(const fmu *fmu, const fmu_view *view, const fmu_variable *variable);

/* Stores a value that was checked. */
void fmu_set_number(fmu *fmu, const fmu_variable *variable, double value);

/* The rate of an input, per second, in the run; NULL: it has none. */
double *fmu_rate_of(fmu *fmu, const fmu_variable *input);

/* A number with its unit; returns `text`. */
enum { VALUE_CAPACITY = 64 };
char *value_text(const fmu_variable *variable, double value, char text[VALUE_CAPACITY]);

#endif
