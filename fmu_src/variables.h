/* The variables of a page's unit. The generator writes their table beside the tables of the page. */
#ifndef TDMF_FMU_VARIABLES_H
#define TDMF_FMU_VARIABLES_H

#include "unit_page.h" /* generated: sizes of the tables */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Numbers of a run: the page's parameters, then its states. */
enum { UNIT_NUMBER_COUNT = UNIT_PARAMETER_COUNT + UNIT_STATE_COUNT };

/* Largest state and largest sum along a run. The first is far beyond any motion, and no product in the
 * equations overflows with it. The second is beyond every sum of such states, and no product with it
 * overflows either. */
#define fmu_largest_state 1e60
#define fmu_largest_sum   1e200

/* Settings of the unit rather than of the page. */
typedef enum { SETTING_TOLERANCE, SETTING_TERMINATES, SETTING_METHOD, SETTING_COUNT } fmu_setting;

typedef enum { SOLVER_NATIVE = 1, SOLVER_CVODE } solver_method;

/* Work of the solver in Co-Simulation. */
typedef enum { WORK_STEPS, WORK_EVALUATIONS, WORK_LAYER_STEPS, WORK_COUNT } fmu_work;

/* Types of variables. A set of them says which types a call takes. */
typedef enum {
    VARIABLE_REAL = 1 << 0,
    VARIABLE_INTEGER = 1 << 1,
    VARIABLE_ENUMERATION = 1 << 2,
    VARIABLE_BOOLEAN = 1 << 3,
    VARIABLE_STRING = 1 << 4
} fmu_variable_type;

/* The array of an instance that holds a variable's value. Up to STORED_START it belongs to the run. */
typedef enum {
    STORED_TIME,
    STORED_PARAMETER,
    STORED_SETTING, /* a setting of the unit, not of its model */
    STORED_INPUT,
    STORED_STATE, /* a continuous state */
    STORED_START, /* start value of a state that the unit does not show */
    STORED_DERIVATIVE,
    STORED_OUTPUT,
    STORED_HELD, /* a state of the model that changes at events only */
    STORED_GUARD,
    STORED_WORK, /* counter of the solver in Co-Simulation */
    STORAGE_COUNT
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
    size_t offset; /* index in the array that the storage names; of a word, its number */
    fmu_variability variability;
    bool settable_before_start;
    bool changes_at_events; /* FMI's reinit: a state that an event may make jump */
    double minimum, maximum, start;
    const char *allowed; /* the range in words, or NULL */
} fmu_variable;

/* A row's position is the variable's value reference. */
extern const fmu_variable fmu_variables[];
extern const size_t fmu_variable_count;

/* True for a tunable parameter or a discrete input: an importer may change it in a run, but at events only.
 */
static inline bool fmu_is_set_at_events(const fmu_variable *variable) {
    return variable->variability == VARIABILITY_TUNABLE ||
           (variable->storage == STORED_INPUT && variable->variability == VARIABILITY_DISCRETE);
}

#endif
