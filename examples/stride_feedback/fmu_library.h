/* The unit's shared library, and what its description says: as much of an importer as the example needs. */
#ifndef FMU_LIBRARY_H
#define FMU_LIBRARY_H

#include "fmi2FunctionTypes.h"

/* The unit's functions, by their types in the standard. */
typedef struct {
    fmi2InstantiateTYPE *instantiate;
    fmi2FreeInstanceTYPE *free_instance;
    fmi2SetupExperimentTYPE *setup_experiment;
    fmi2EnterInitializationModeTYPE *enter_initialization_mode;
    fmi2ExitInitializationModeTYPE *exit_initialization_mode;
    fmi2GetRealTYPE *get_real;
    fmi2SetRealTYPE *set_real;
    fmi2GetIntegerTYPE *get_integer;
    fmi2EnterEventModeTYPE *enter_event_mode;
    fmi2NewDiscreteStatesTYPE *new_discrete_states;
    fmi2EnterContinuousTimeModeTYPE *enter_continuous_time_mode;
    fmi2CompletedIntegratorStepTYPE *completed_integrator_step;
    fmi2SetTimeTYPE *set_time;
    fmi2GetContinuousStatesTYPE *get_states;
    fmi2SetContinuousStatesTYPE *set_states;
    fmi2GetDerivativesTYPE *get_derivatives;
    fmi2GetEventIndicatorsTYPE *get_indicators;
} fmu_functions;

/* The functions of a shared library. Ends the program with a message where there are none. */
fmu_functions load_fmu(const char *path);

/* The text of modelDescription.xml. This program searches the text; a real importer parses it. */
typedef struct {
    char *text;
} fmu_description;

/* Reads the file; ends the program with a message where it cannot. */
fmu_description read_description(const char *path);
void free_description(fmu_description *description);

/* A variable's value reference, an attribute that the file has once, and how many continuous states there
 * are. They end the program with a message where the file does not say. */
fmi2ValueReference reference_of(const fmu_description *description, const char *variable);
void attribute_of(const fmu_description *description, const char *name, char *value, size_t size);
size_t count_states(const fmu_description *description);

/* Ends the program with a message. */
void fail(const char *what, const char *which);

#endif
