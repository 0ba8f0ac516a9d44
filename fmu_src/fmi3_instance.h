/* FMI 3.0: an instance with the importer's callback and what it asked for. */
#ifndef TDMF_FMI3_INSTANCE_H
#define TDMF_FMI3_INSTANCE_H

#include "fmi3Functions.h"

#include "instance.h"

typedef struct {
    instance instance;
    bool early_return_allowed;
    fmi3LogMessageCallback logger; /* may be NULL */
    fmi3InstanceEnvironment environment;
} fmi3_instance;

#endif
