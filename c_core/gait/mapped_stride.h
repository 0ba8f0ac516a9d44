/* A stride of the return map before and after its run, between return_map.c and the batches of strides. */
#ifndef TDMF_GAIT_MAPPED_STRIDE_H
#define TDMF_GAIT_MAPPED_STRIDE_H

#include "page_solver.h"
#include "tdmf_slip/return_map.h"

typedef struct {
    const tdmf_stride_request *request;
    tdmf_motion start;
    double
        d_clearance[TDMF_VARIATION_LIMIT]; /* variation of the foot's height above the ground at the start */
    tdmf_page_solver solver;
} tdmf_mapped_stride;

/* Gives the state of tdmf_section_state with the foot at x = foot_x, as high above the ground there. */
void tdmf_section_state_at(tdmf_system system, double foot_x, const double section[TDMF_SECTION_COUNT],
                           double state[TDMF_STATE_COUNT]);

/* Begins a stride, whose run goes on to the event `apex`. False if there is none: `result` says why. */
bool tdmf_begin_mapped_stride(tdmf_mapped_stride *s, const tdmf_stride_request *request, tdmf_return *result);

/* Writes a stride whose run has come to its apex. */
void tdmf_close_mapped_stride(tdmf_mapped_stride *s, tdmf_return *result);

/* Checks a request for a stride of any map. */
bool tdmf_is_sound_stride(tdmf_refusal *why, const tdmf_stride_request *request);

/* The time that a stride may take, s. */
double tdmf_longest_of(const tdmf_stride_request *request);

/* Writes the quantities of the stride that has closed last, in a run that began with it. */
void tdmf_write_return(const runner_states *x, tdmf_return *result);

#endif
