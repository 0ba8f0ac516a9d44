/* Mechanical energy. With the integrals of a run it closes: change = hip + leg + external -
 * damper - friction - impact. */
#ifndef TDMF_SLIP_ENERGY_H
#define TDMF_SLIP_ENERGY_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Energies of the runner at an instant. */
typedef struct {
    double kinetic;   /* J, body and foot */
    double potential; /* J, zero at the ground */
    double elastic;   /* J, in the leg's spring */
    double total;     /* J */
} tdmf_energy;

/* Sums the energies of body, foot and spring; inputs and mode determine the spring's rest length. */
TDMF_API tdmf_energy tdmf_mechanical_energy(tdmf_system system, const tdmf_mode *mode,
                                            const double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
