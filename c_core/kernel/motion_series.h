/* The series of the motions and of their variations. */
#ifndef TDMF_KERNEL_MOTION_SERIES_H
#define TDMF_KERNEL_MOTION_SERIES_H

#include "flight_motion.h"
#include "ground_motion.h"

typedef union {
    flight_variation flight;
    ground_variation ground;
} motion_variation;

#endif
