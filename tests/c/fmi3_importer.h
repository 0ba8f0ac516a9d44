/* The smallest importer that can tell what an FMI 3.0 unit said. */
#ifndef TDMF_TESTS_FMI3_IMPORTER_H
#define TDMF_TESTS_FMI3_IMPORTER_H

#include "fmi3Functions.h"

#include "fmi_interface.h"

void importer_logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                     fmi3String message);

/* A fresh instance until the end of the test, event logging off; asserts that there is one. */
fmi3Instance new_exchange(void);
fmi3Instance new_stepper(bool event_mode, bool early_return);

fmi3Status set_float(fmi3Instance instance, const char *name, double value);
double get_float(fmi3Instance instance, const char *name);
int get_int(fmi3Instance instance, const char *name);
int get_enumeration(fmi3Instance instance, const char *name);

/* Through initialization; asserts fmi3OK. */
void initialize3(fmi3Instance instance);

fmi3Status update(fmi3Instance instance, update_answer *answer);
fmi3Status do_step(fmi3Instance instance, double time, double step, step_answer *answer);

#endif
