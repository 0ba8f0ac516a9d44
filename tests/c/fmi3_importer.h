/* A minimal importer of FMI 3.0 units, which records their messages. */
#ifndef TDMF_TESTS_FMI3_IMPORTER_H
#define TDMF_TESTS_FMI3_IMPORTER_H

#include "fmi3Functions.h"

#include "fmi_interface.h"

void importer_logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                     fmi3String message);

/* A fresh instance until the end of the test, event logging off; asserts that there is one. */
fmi3Instance new_stepper(bool event_mode, bool early_return);

/* Calls of fmi_interface.h for FMI 3.0. */
#define new_exchange()            new_of_kind(&fmi3, EXCHANGE)
#define set_float(instance, ...)  ((fmi3Status)set_value(&fmi3, instance, __VA_ARGS__))
#define get_float(instance, name) value_of(&fmi3, instance, name)
#define get_int(instance, name)   integer_of(&fmi3, instance, name)
#define initialize3(instance)     initialize_unit(&fmi3, instance)

fmi3Status update(fmi3Instance instance, update_answer *answer);
fmi3Status do_step(fmi3Instance instance, double time, double step, step_answer *answer);

#endif
