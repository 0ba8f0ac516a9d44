/* A minimal importer of FMI 2.0 units, which records their messages. */
#ifndef TDMF_TESTS_FMI2_IMPORTER_H
#define TDMF_TESTS_FMI2_IMPORTER_H

#include "fmi2Functions.h"

#include "fmi_interface.h"
#include "tdmf_slip/state.h"

#include <stdbool.h>

extern const fmi2CallbackFunctions importer_callbacks;

/* Calls of fmi_interface.h for FMI 2.0. `start_running` ends in continuous-time mode. */
#define new_instance()            new_of_kind(&fmi2, EXCHANGE)
#define new_slave()               new_of_kind(&fmi2, STEPS)
#define set_real(instance, ...)   ((fmi2Status)set_value(&fmi2, instance, __VA_ARGS__))
#define get_real(instance, name)  value_of(&fmi2, instance, name)
#define get_whole(instance, name) integer_of(&fmi2, instance, name)
#define initialize(instance)      initialize_unit(&fmi2, instance)
#define start_running(instance)   begin(&fmi2, instance, EXCHANGE)

/* Real start values: parameters and a tolerance, inputs, and states. */
enum { START_VALUES = TDMF_PARAMETER_COUNT + TDMF_INPUT_COUNT + 1 + TDMF_MECHANICAL_COUNT };

#endif
