/* Places beside a line of ground, in the world's axes. */
#ifndef TDMF_MODEL_GROUND_LINE_H
#define TDMF_MODEL_GROUND_LINE_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

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

/* The distance of a point from the line, negative below. */
static inline double tdmf_height_over(const tdmf_ground_line *line, double x, double y) {
    return line->cosine * (y - line->height) - line->sine * x;
}

/* The height of the line, h + x tan sigma. */
static inline double tdmf_ground_height_at(const tdmf_ground_line *line, double x) {
    return line->height + x * (line->sine / line->cosine);
}

/* The rounding error of a distance from a line that is high up or deep down at x. */
static inline double tdmf_rounding_of_height(const tdmf_ground_line *line, double x) {
    return 4.0 * DBL_EPSILON * (fabs(line->height) + fabs(line->sine * x));
}

#endif
