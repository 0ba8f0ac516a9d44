/* The calls of a unit that the importer needs, whatever FMI version it has; all end the program on failure.
 */
#ifndef TDMF_TESTS_FMU_CALLS_H
#define TDMF_TESTS_FMU_CALLS_H

#include "tdmf_slip/variables.h"

#include <stdbool.h>
#include <stddef.h>

enum { STATES = 15, INDICATORS = TDMF_GUARD_COUNT };

typedef struct {
    void *(*make)(bool model_exchange, const char *guid); /* through initialization */
    void (*free)(void *instance);
    double (*real)(void *instance, unsigned reference);
    int (*integer)(void *instance, unsigned reference);
    const char *(*text)(void *instance, unsigned reference);
    void (*step)(void *instance, double time, double step);
    void (*set_time)(void *instance, double time);
    void (*get_states)(void *instance, double states[STATES]);
    void (*set_states)(void *instance, const double states[STATES]);
    void (*get_derivatives)(void *instance, double derivatives[STATES]);
    void (*get_indicators)(void *instance, double indicators[INDICATORS]);
    void (*take_events)(void *instance); /* from continuous-time mode and back into it */
} fmu_calls;

/* ---- library.c ---------------------------------------------------------------------------------------- */

typedef void (*any_function)(void);

void load_library(const char *path);
any_function find_function(const char *name);

/* Ends the program with a message unless the call went well. */
void check(bool went_well, const char *call);

/* ---- fmi2.c, fmi3.c ----------------------------------------------------------------------------------- */

fmu_calls calls_of_fmi2(void);
fmu_calls calls_of_fmi3(void);

#endif
