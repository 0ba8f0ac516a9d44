/* The first variation of one runner's motion along a step. */
#ifndef TDMF_KERNEL_TANGENT_SERIES_H
#define TDMF_KERNEL_TANGENT_SERIES_H

#include "scalar_series.h"

typedef union {
    flight_variation flight;
    ground_variation ground;
} tdmf_tangent_series;

#endif
