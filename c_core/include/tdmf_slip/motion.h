/* All that changes along a run. */
#ifndef TDMF_SLIP_MOTION_H
#define TDMF_SLIP_MOTION_H

#include "tdmf_slip/record.h"
#include "tdmf_slip/state.h"

/* Set time and state, and begin it with tdmf_start. */
typedef struct {
    double time;                    /* s */
    double state[TDMF_STATE_COUNT]; /* see state.h for the order */
    tdmf_mode mode;                 /* the discrete part of it */
    tdmf_record record;             /* what is remembered */
} tdmf_motion;

#endif
