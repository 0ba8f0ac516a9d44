/* Limits at which a search for gaits or an ensemble gives up: the time of a stride, and the steps of strides
 * in a row. */
#ifndef TDMF_SOLVER_STRIDE_LIMITS_H
#define TDMF_SOLVER_STRIDE_LIMITS_H

#include "tdmf_slip/solver.h"

#include <limits.h>

/* Time limit of a stride, in sqrt(m/k). */
#define TDMF_LONGEST_STRIDE 1e4

/* Step limit of the next of several strides, from the steps left so far: see TDMF_STEP_LIMIT. */
static inline double tdmf_steps_of_next_stride(double steps_left, double step_limit) {
    const double steps = steps_left + step_limit / TDMF_STEP_SHARE;
    return steps < step_limit ? steps : step_limit;
}

/* A step limit as an integer, to which the steps made before can be added without overflow. */
static inline long tdmf_step_limit_of(double steps) {
    const long most = LONG_MAX / 2;
    return steps < (double)most ? (long)steps : most;
}

#endif
