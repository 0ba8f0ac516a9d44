/* Free fall as inputs have it; its laws are in equations/free_fall.py. */
#ifndef TDMF_MODEL_FREE_FALL_H
#define TDMF_MODEL_FREE_FALL_H

#include "free_fall_laws.h"
#include "ground_line.h"

static inline bool tdmf_is_pushed(const tdmf_inputs *inputs) {
    return inputs->body.external_fx != 0.0 || inputs->body.external_fy != 0.0;
}

/* What of it is along a line and away from it. */
static inline double tdmf_along_line(const tdmf_ground_line *line, tdmf_vector acceleration) {
    return tdmf_velocity_along(line, acceleration.x, acceleration.y);
}

static inline double tdmf_off_line(const tdmf_ground_line *line, tdmf_vector acceleration) {
    return tdmf_velocity_off(line, acceleration.x, acceleration.y);
}

#endif
