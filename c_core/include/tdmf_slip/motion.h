/* Everything that changes along a run. */
#ifndef TDMF_SLIP_MOTION_H
#define TDMF_SLIP_MOTION_H

#include "tdmf_slip/state.h"

/* A run: where it stands and what it remembers. Set `time` and the mechanical states, then begin it with
 * tdmf_start. It holds no pointer, so a copy is a checkpoint: copy it back to restore the run. */
typedef struct {
    double time;                    /* s */
    double state[TDMF_STATE_COUNT]; /* states of the runner's page, see variables.h */
    tdmf_mode mode;                 /* contact, phase of the hip, and other discrete values */
    double begun;                   /* s, the time of the start, from which times among the states count */
    double clock_rest;              /* s, what rounding has left out of TDMF_STRIDE_TIME */
} tdmf_motion;

#endif
