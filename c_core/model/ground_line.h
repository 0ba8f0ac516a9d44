/* The ground as it is set and met; equations/ground_line.py has its axes. */
#ifndef TDMF_MODEL_GROUND_LINE_H
#define TDMF_MODEL_GROUND_LINE_H

#include "ground_line_laws.h"

#include <float.h>
#include <math.h>

/* The line that the inputs have set last. */
static inline tdmf_ground_line tdmf_ground_line_set(const tdmf_inputs *inputs) {
    return tdmf_ground_line_of(inputs->ground.height, inputs->ground.slope);
}

/* The line set last waits to be in force. */
static inline bool tdmf_ground_is_pending(const tdmf_inputs *inputs, const tdmf_mode *mode) {
    return mode->ground.height != inputs->ground.height || mode->ground.slope != inputs->ground.slope;
}

/* What a distance from a line may be wrong by that is high up or deep down at x, where places are rounded. */
static inline double tdmf_rounding_of_height(const tdmf_ground_line *line, double x) {
    return 4.0 * DBL_EPSILON * (fabs(line->height) + fabs(line->sine * x));
}

/* Puts the foot onto the line, from a place beside it. */
static inline void tdmf_lift_to_ground(const tdmf_ground_line *line, double state[TDMF_STATE_COUNT]) {
    const tdmf_point foot =
        tdmf_point_on(line, tdmf_offset_along(line, state[TDMF_FOOT_X], state[TDMF_FOOT_Y]), 0.0);
    state[TDMF_FOOT_X] = foot.x;
    state[TDMF_FOOT_Y] = foot.y;
}

#endif
