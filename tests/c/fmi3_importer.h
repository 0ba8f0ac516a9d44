/* The smallest importer that can tell what an FMI 3.0 unit said. */
#ifndef TDMF_TESTS_FMI3_IMPORTER_H
#define TDMF_TESTS_FMI3_IMPORTER_H

#include "fmi3Functions.h"

#include "messages.h"

void importer_logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                     fmi3String message);

/* A fresh instance, event logging off; asserts that there is one. */
fmi3Instance new_exchange(void);
fmi3Instance new_stepper(bool event_mode, bool early_return);

fmi3Status set_float(fmi3Instance instance, const char *name, double value);
double get_float(fmi3Instance instance, const char *name);
int get_int(fmi3Instance instance, const char *name);
int get_enumeration(fmi3Instance instance, const char *name);

/* Through initialization; asserts fmi3OK. */
void initialize3(fmi3Instance instance);

/* What fmi3UpdateDiscreteStates answers. */
typedef struct {
    fmi3Boolean needs_update, terminate, nominals_changed, states_changed, next_time_defined;
    fmi3Float64 next_time;
} update_answer;
fmi3Status update(fmi3Instance instance, update_answer *answer);

/* What fmi3DoStep answers. */
typedef struct {
    fmi3Boolean event, terminate, early;
    fmi3Float64 time;
} step_answer;
fmi3Status do_step(fmi3Instance instance, double time, double step, step_answer *answer);

/* Writes all that an instance is, its saved state, and returns how many bytes that are; asserts that there is
 * room. */
size_t serialize3(fmi3Instance instance, fmi3Byte bytes[SERIALIZED_BYTES]);

#endif
