/* Energies as the world asks for them; equations/energy.py has the law. */
#include "tdmf_slip/energy.h"

#include "energy_laws.h"
#include "leg.h"

tdmf_energy tdmf_mechanical_energy(tdmf_system system, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(system, mode, state);
    return tdmf_energy_with(system.model, state, &leg);
}
