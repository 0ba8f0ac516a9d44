/* Accelerations at an instant that has been evaluated, and their variations. */
#ifndef TDMF_MODEL_DYNAMICS_H
#define TDMF_MODEL_DYNAMICS_H

#include "evaluation.h"
#include "tdmf_slip/dynamics.h"

/* Gives rddot and thetaddot. */
tdmf_leg_rates tdmf_accelerate_leg(const tdmf_evaluation *at);

/* The change of tdmf_derivatives, of a run that has not fallen. */
void tdmf_vary_rates_of_state(const tdmf_evaluation *at, const tdmf_evaluation *d,
                              double derivatives[TDMF_STATE_COUNT]);

/* Rate of the force on a loaded foot under the stance law, N/s: inputs held, leg moving as in the mode. */
tdmf_ground_force tdmf_force_rate(const tdmf_evaluation *at);

#endif
