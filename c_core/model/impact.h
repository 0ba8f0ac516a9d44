/* The impact where the leg's direction is at hand, and varied; its law is in equations/impact.py. */
#ifndef TDMF_MODEL_IMPACT_H
#define TDMF_MODEL_IMPACT_H

#include "leg.h"
#include "seed.h"
#include "tdmf_slip/impact.h"

/* tdmf_impact, where the leg's direction is at hand. */
double tdmf_impact_along(tdmf_system system, const tdmf_ground_line *ground, tdmf_leg_direction direction,
                         double state[TDMF_STATE_COUNT]);

/* What the impact map makes of a change. `d_state` is that of the state before on call, of the state after on
 * return. Returns the change of the energy lost. */
double tdmf_vary_impact(tdmf_system system, const tdmf_ground_line *ground,
                        const double before[TDMF_STATE_COUNT], const tdmf_local_seed *d,
                        double d_state[TDMF_STATE_COUNT]);

#endif
