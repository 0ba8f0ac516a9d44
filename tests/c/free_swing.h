/* The runner without the clamp of (12), hip.swing_clamp false: gaits, borders between words, and single
 * strides of random runners. Two independent programs agree on them, apices to 2e-11, Jacobians and strides
 * to 1e-9; the digits are those of one in extended precision. */
#ifndef TDMF_TESTS_FREE_SWING_H
#define TDMF_TESTS_FREE_SWING_H

#include "reference_gaits.h"
#include "tdmf_slip/return_map.h"

typedef struct {
    reference_gait gait;
    double positive_work, slip_distance, stance_time; /* of its stride */
    double jacobian[TDMF_SECTION_COUNT][TDMF_SECTION_COUNT];
} free_gait;

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

enum { FREE_GAITS = 7, FREE_BORDERS = 5, FREE_STRIDES = 40 };

extern const free_gait free_gaits[FREE_GAITS];
extern const free_border free_borders[FREE_BORDERS];
extern const free_stride free_strides[FREE_STRIDES];

/* Table 1, with the clamp or without. */
tdmf_model table_1(bool swing_clamp);

/* The runner of a stride, with the clamp or without. */
tdmf_model model_of_free_stride(const free_stride *stride, bool swing_clamp);

tdmf_inputs inputs_at_friction(double friction);

#endif
