/* Mechanical energy, varied. */
#ifndef TDMF_MODEL_ENERGY_H
#define TDMF_MODEL_ENERGY_H

#include "leg.h"
#include "tdmf_slip/energy.h"

/* tdmf_mechanical_energy, where the leg's direction is at hand. */
tdmf_energy tdmf_mechanical_energy_along(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                         tdmf_leg_direction direction);

tdmf_energy tdmf_vary_energy(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                             tdmf_leg_direction direction, const tdmf_direction *d);

#endif
