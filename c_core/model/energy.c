/* Energies as the world asks for them. */
#include "energy.h"

tdmf_energy tdmf_mechanical_energy(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]) {
    return tdmf_mechanical_energy_along(model, inputs, mode, state, tdmf_leg_direction_of(state));
}
