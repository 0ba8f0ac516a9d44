/* FMI 2.0: an instance with the importer's callbacks. */
#ifndef TDMF_FMI2_INSTANCE_H
#define TDMF_FMI2_INSTANCE_H

#include "fmi2Functions.h"

#ifdef FMI2_FUNCTION_PREFIX /* some copies of the header above ignore it */
#undef fmi2FullName
#define FMI2_JOINED(prefix, name)   prefix##name
#define FMI2_PREFIXED(prefix, name) FMI2_JOINED(prefix, name)
#define fmi2FullName(name)          FMI2_PREFIXED(FMI2_FUNCTION_PREFIX, name)
#endif

#include "instance.h"

typedef struct {
    instance instance;
    fmi2CallbackLogger logger; /* may be NULL */
    fmi2ComponentEnvironment environment;
} fmi2_instance;

#endif
