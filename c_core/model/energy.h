/* Mechanical energy, varied. */
#ifndef TDMF_MODEL_ENERGY_H
#define TDMF_MODEL_ENERGY_H

#include "evaluated.h"
#include "tdmf_slip/energy.h"

/* tdmf_mechanical_energy, where the leg's direction is at hand. */
tdmf_energy tdmf_mechanical_energy_along(const tdmf_model *model, const tdmf_inputs *inputs,
                                         const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                                         tdmf_leg_direction direction);

tdmf_energy tdmf_vary_energy(const tdmf_evaluation *at, const tdmf_direction *d, const tdmf_evaluation *d_at);

#endif
