/* Mechanical energy where the leg's direction is at hand; its law is in equations/energy.py. */
#ifndef TDMF_MODEL_ENERGY_H
#define TDMF_MODEL_ENERGY_H

#include "energy_laws.h"
#include "leg.h"

static inline tdmf_energy tdmf_mechanical_energy_along(tdmf_system system, const tdmf_mode *mode,
                                                       const double state[TDMF_STATE_COUNT],
                                                       tdmf_leg_direction direction) {
    return tdmf_energy_with(system.model, state, direction,
                            tdmf_rest_length(system.model, system.inputs, mode));
}

#endif
