/* Touchdown: a perfectly inelastic impact of the foot under Coulomb friction. */
#ifndef TDMF_SLIP_IMPACT_H
#define TDMF_SLIP_IMPACT_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Applies the impact map (4)-(6) to a state whose foot moves into the ground: the foot is put onto the line
 * and stops across it; along it, it sticks inside the friction cone and is slowed outside; the body's
 * velocity is unchanged. Returns the energy lost, J, never negative. */
TDMF_API double tdmf_impact(tdmf_system system, const tdmf_ground_line *ground,
                            double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
