/* Everything that changes along a run. */
#ifndef TDMF_SLIP_MOTION_H
#define TDMF_SLIP_MOTION_H

#include "tdmf_slip/record.h"
#include "tdmf_slip/state.h"

/* A run: where it stands and what it remembers. Set `time` and `state`, then begin it with tdmf_start. It
 * holds no pointer, so a copy is a checkpoint: copy it back to restore the run. */
typedef struct {
    double time;                    /* s */
    double state[TDMF_STATE_COUNT]; /* see state.h for the order */
    tdmf_mode mode;                 /* contact, phase of the hip, and other discrete values */
    tdmf_record record;             /* events, the last stride, the last apex */
} tdmf_motion;

#endif
