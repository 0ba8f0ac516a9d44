/* A stride of the reduced map before, within and after its run, between reduced_map.c and the batches of
 * strides. The run has three parts, to touchdown, to lift-off and to the apex. */
#ifndef TDMF_GAIT_REDUCED_STRIDE_H
#define TDMF_GAIT_REDUCED_STRIDE_H

#include "mapped_stride.h"
#include "page_places.h"

typedef struct {
    const tdmf_page_part *page;
    tdmf_solver *solver;
    tdmf_system system;
    tdmf_motion start;
    tdmf_page_run run; /* without memory and log */
    double until;      /* s, that flight and stance may take each */
    double end;        /* when the part under way is given up */
    int part;          /* part of the stride */
    tdmf_return_outcome outcome;
    tdmf_outcome ended;
    /* Numbers of the page that runs: the runner's page has most of them. */
    double p[TDMF_PAGE_PARAMETER_COUNT], x[TDMF_PAGE_STATE_COUNT], lift_off[TDMF_PAGE_STATE_COUNT];
    double dp[TDMF_VARIATION_LIMIT * TDMF_PAGE_PARAMETER_COUNT];
    double dx[TDMF_VARIATION_LIMIT * TDMF_PAGE_STATE_COUNT];
    double shift[TDMF_VARIATION_LIMIT];
} tdmf_reduced_stride;

/* Begins a stride, whose run goes on to `end`. False if there is none: `result` says why. */
bool tdmf_begin_reduced_stride(tdmf_reduced_stride *s, const tdmf_stride_request *request,
                               tdmf_return *result);

/* Takes the end of a part. False where the stride is over. */
bool tdmf_reduced_stride_goes_on(tdmf_reduced_stride *s, tdmf_run_outcome outcome);

/* Writes a stride that is over. */
void tdmf_close_reduced_stride(tdmf_reduced_stride *s, tdmf_return *result);

/* Makes a stride alone. */
void tdmf_run_reduced_stride(const tdmf_stride_request *request, tdmf_return *result);

#endif
