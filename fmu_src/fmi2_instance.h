/* FMI 2.0: an instance with the importer's callbacks. */
#ifndef TDMF_FMI2_INSTANCE_H
#define TDMF_FMI2_INSTANCE_H

#include "fmi2Functions.h"

#include "instance.h"

typedef struct {
    instance instance;
    fmi2CallbackLogger logger; /* may be NULL */
    fmi2ComponentEnvironment environment;
} fmi2_instance;

#endif
