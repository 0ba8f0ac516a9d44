/* The smallest importer that can tell what an FMI 2.0 unit said. */
#ifndef TDMF_TESTS_FMI2_IMPORTER_H
#define TDMF_TESTS_FMI2_IMPORTER_H

#include "fmi2Functions.h"

#include "fmi_interface.h"
#include "tdmf_slip/state.h"

#include <stdbool.h>

extern const fmi2CallbackFunctions importer_callbacks;

/* A fresh instance for Model Exchange or Co-Simulation until the end of the test, event logging off; asserts
 * that there is one. */
fmi2Component new_instance(void);
fmi2Component new_slave(void);

fmi2Status set_real(fmi2Component component, const char *name, double value);
double get_real(fmi2Component component, const char *name);
int get_integer(fmi2Component component, const char *name);

/* Through initialization into event mode, and on into continuous-time mode; asserts fmi2OK. */
void initialize(fmi2Component component);
void start_running(fmi2Component component);

/* Real start values: parameters and a tolerance, inputs, and states. */
enum { START_VALUES = TDMF_PARAMETER_COUNT + TDMF_INPUT_COUNT + 1 + TDMF_MECHANICAL_COUNT };

#endif
