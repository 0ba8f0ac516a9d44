/* The engine of one thread is compiled once for each instruction set. */
#ifndef TDMF_ENSEMBLE_BATCHES_H
#define TDMF_ENSEMBLE_BATCHES_H

#include "runner.h"

/* Starts that are still to be run, shared by threads. */
typedef struct tdmf_starts tdmf_starts;

/* Gives the next of them, or -1 where none is left. */
int64_t tdmf_next_start(tdmf_starts *starts);

/* Runs starts until there are none. False, having taken none, if there is no memory. */
typedef bool tdmf_run_batches(const tdmf_ensemble *ensemble, tdmf_starts *starts, series_orders orders,
                              tdmf_ensemble_end *ends, tdmf_ensemble_work *work);

tdmf_run_batches tdmf_run_two_lanes, tdmf_run_avx2, tdmf_run_avx512;

#endif
