/* Energies as the world asks for them. */
#include "energy.h"

tdmf_energy tdmf_mechanical_energy(tdmf_system system, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]) {
    return tdmf_mechanical_energy_along(system, mode, state, tdmf_leg_direction_of(state));
}
