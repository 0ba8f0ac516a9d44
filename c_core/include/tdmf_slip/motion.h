/* All that changes along a run. */
#ifndef TDMF_SLIP_MOTION_H
#define TDMF_SLIP_MOTION_H

#include "tdmf_slip/state.h"
#include "tdmf_slip/stride.h"

/* Begin it with tdmf_start on its members. */
typedef struct {
    double time; /* s */
    double state[TDMF_STATE_COUNT];
    tdmf_mode mode;
    tdmf_record record;
} tdmf_motion;

#endif
