/* The leg as mode and inputs have it; its laws are in equations/leg.py. */
#ifndef TDMF_MODEL_LEG_H
#define TDMF_MODEL_LEG_H

#include "leg_laws.h"

#include <math.h>

static inline tdmf_leg_direction tdmf_leg_direction_of(const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg_direction direction = {sin(state[TDMF_LEG_ANGLE]), cos(state[TDMF_LEG_ANGLE])};
    return direction;
}

static inline tdmf_leg tdmf_leg_of(tdmf_system system, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]) {
    return tdmf_leg_along(system.model, system.inputs, mode, state, tdmf_leg_direction_of(state));
}

#endif
