/* The engine for one thread, once for each instruction set. */
#ifndef TDMF_ENSEMBLE_LANE_MARCH_H
#define TDMF_ENSEMBLE_LANE_MARCH_H

#include "runner.h"

/* Starts that are still to be run, shared by threads. */
typedef struct tdmf_starts tdmf_starts;

/* The next of them, or -1. */
int64_t tdmf_next_start(tdmf_starts *starts);

/* Runs starts until there are none. False, having taken none, if there is no memory. */
typedef bool tdmf_lane_march(const tdmf_ensemble *ensemble, tdmf_starts *starts, int order,
                             tdmf_ensemble_end *ends, tdmf_ensemble_work *work);

tdmf_lane_march tdmf_march_two_lanes, tdmf_march_avx2, tdmf_march_avx512;

#endif
