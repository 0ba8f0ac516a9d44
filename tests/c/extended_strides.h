/* Single strides from stated apices, integrated with 30 digits by a program that shares nothing with the
 * library, tests/extended_precision. Body mass and free length are 1, what is not stated is Table
 * 1's. Each start is integrated with the clamp of the swing and without it. */
#ifndef TDMF_TESTS_EXTENDED_STRIDES_H
#define TDMF_TESTS_EXTENDED_STRIDES_H

#include "proved_gaits.h"

enum { EXTENDED_STRIDES = 18 };

typedef struct {
    double gravity, friction, stiffness, damping, stance_torque, kp, kd;
    bool swing_clamp;
    double start[TDMF_SECTION_COUNT];
    int apex_count; /* coordinates of the apex that are known: all, or those of the centre of mass */
    double apex[TDMF_SECTION_COUNT];
    int event_count;
    proved_event events[PROVED_EVENTS]; /* the last is the apex */
} extended_stride;

extern const extended_stride extended_strides[EXTENDED_STRIDES];

static inline tdmf_parameters parameters_of_stride(const extended_stride *stride) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.gravity = stride->gravity;
    parameters.leg.stiffness = stride->stiffness;
    parameters.leg.damping = stride->damping;
    parameters.hip.stance_torque = stride->stance_torque;
    parameters.hip.kp = stride->kp;
    parameters.hip.kd = stride->kd;
    parameters.hip.swing_clamp = stride->swing_clamp;
    return parameters;
}

#endif
