/* Many runs of a page, side by side in the lanes of SIMD registers and in several threads.
 *
 * Each run ends as tdmf_page_run_to would end it, bit for bit. So neither the number of runs, nor that of
 * lanes or threads, nor the order of the runs decides a result.
 */
#ifndef TDMF_KERNEL_BATCH_H
#define TDMF_KERNEL_BATCH_H

#include "driver.h"

#include <stdint.h>

/* Runs that a thread has under way at once for each lane: enough that a full batch waits, few enough for the
 * cache. */
enum { TDMF_RUNS_OF_A_LANE = 20 };

/* Continuation of a run. TDMF_GOES_ON_UNCHANGED: the caller has changed only its stop event, its limits and
 * its time in `until`. */
typedef enum { TDMF_IS_OVER, TDMF_GOES_ON_CHANGED, TDMF_GOES_ON_UNCHANGED } tdmf_continuation;

/* Called where a run has ended, unless the batch is cancelled, in the thread that runs it. It may change the
 * run, also by tdmf_page_set, and its time in `until`, or put another run in its place. The counters of steps
 * and events never fall. */
typedef tdmf_continuation tdmf_at_end(void *context, int64_t number, tdmf_page_run *run,
                                      tdmf_run_outcome outcome);

/* The runs have equal orders, tolerances and numbers of seeds, and either all or none observe. */
typedef struct {
    tdmf_page_run *runs;
    int64_t count;
    const double *until;        /* one time for each run */
    tdmf_run_outcome *outcomes; /* written, one for each run */
    tdmf_at_end *at_end;        /* may be NULL */
    void *context;
    const int *cancel; /* once this is not 0, all runs end where they are; NULL */
    int width;         /* lanes: 1, 2, 4 or 8; 0: as many as pay for so many runs, build and processor */
    int threads;
} tdmf_batch;

/* Steps of runs, lanes of the steps made side by side, and steps made one by one. */
typedef struct {
    int64_t steps, lane_steps, single_steps;
} tdmf_batch_work;

tdmf_batch tdmf_batch_default(void);

/* True if this build has batches of this width. */
bool tdmf_batch_has_width(const tdmf_model_kind *model, int width);

/* False for runs that do not match, or a width that there is not. `work` may be NULL. */
bool tdmf_run_batch(const tdmf_model_kind *model, const tdmf_batch *batch, tdmf_batch_work *work);

/* ---- between batch.c and batch_lanes.c ----------------------------------------------------------------- */

/* Data that threads share. */
typedef struct {
    const tdmf_model_kind *model;
    const tdmf_batch *batch;
    int64_t next;
    int threads;
} tdmf_batch_share;

/* The number of the next run; -1: there is none, or the batch is cancelled. */
int64_t tdmf_next_run(tdmf_batch_share *share);

/* Writes the outcome of a run, and returns how the run goes on. A callback may use the memory. */
tdmf_continuation tdmf_go_on_from(const tdmf_batch *batch, int64_t number, tdmf_run_outcome outcome,
                                  double *memory);

/* Makes runs until there are no more. False without memory: nothing has been done. */
typedef bool tdmf_run_lanes(tdmf_batch_share *share, tdmf_batch_work *work);
tdmf_run_lanes tdmf_run_lanes_2, tdmf_run_lanes_4, tdmf_run_lanes_8;

#endif
