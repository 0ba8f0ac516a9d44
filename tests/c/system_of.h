/* The system of a structure that has a model and inputs, by a pointer to it. */
#ifndef TDMF_TESTS_SYSTEM_OF_H
#define TDMF_TESTS_SYSTEM_OF_H

#include "tdmf_slip/parameters.h"

#define SYSTEM_OF(structure) ((tdmf_system){&(structure)->model, &(structure)->inputs})

#endif
