/* The ground: a line with tangent t = (cos(sigma), sin(sigma)) and normal n = (-sin(sigma), cos(sigma)). */
#ifndef TDMF_MODEL_GROUND_LINE_H
#define TDMF_MODEL_GROUND_LINE_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

/* The line that the inputs have set last. */
static inline tdmf_ground_line tdmf_ground_line_set(const tdmf_inputs *inputs) {
    return tdmf_ground_line_of(inputs->ground.height, inputs->ground.slope);
}

/* The line set last waits to be in force. */
static inline bool tdmf_ground_is_pending(const tdmf_inputs *inputs, const tdmf_mode *mode) {
    return mode->ground.height != inputs->ground.height || mode->ground.slope != inputs->ground.slope;
}

#endif
