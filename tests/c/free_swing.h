/* The runner without the clamp of (12): borders between words, and single strides of random runners. Two
 * independent programs agree on them, to 1e-9 at the least; the digits are those of one in extended
 * precision. */
#ifndef TDMF_TESTS_FREE_SWING_H
#define TDMF_TESTS_FREE_SWING_H

#include "reference_gaits.h"

/* A border between gait words: `above` at larger friction, `below` at smaller. */
typedef struct {
    double friction;
    const char *above, *below;
} free_border;

/* A stride of a runner from an apex. All other parameters have the values of Table 1. */
typedef struct {
    double friction, body_mass, foot_mass, stiffness, damping, free_length, gravity;
    double stance_torque, touchdown_angle, kp, kd, liftoff_angle_factor;
    double start[TDMF_SECTION_COUNT], end[TDMF_SECTION_COUNT];
    const char *word;
    double period, length, work;
    int touchdowns;
} free_stride;

enum { FREE_BORDERS = 5, FREE_STRIDES = 40 };

extern const free_border free_borders[FREE_BORDERS];
extern const free_stride free_strides[FREE_STRIDES];

/* The runner of a stride, with the clamp or without. */
tdmf_model model_of_free_stride(const free_stride *stride, bool swing_clamp);

#endif
