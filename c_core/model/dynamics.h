/* The right-hand side at an instant that has been evaluated, and its variation. */
#ifndef TDMF_MODEL_DYNAMICS_H
#define TDMF_MODEL_DYNAMICS_H

#include "evaluation.h"
#include "tdmf_slip/dynamics.h"

/* The right-hand side of a run that has not fallen, with the power of the external force. */
void tdmf_rates_of_state(const tdmf_evaluation *at, double external_power, double rates[TDMF_STATE_COUNT]);

/* Its change. */
void tdmf_vary_rates_of_state(const tdmf_evaluation *at, const tdmf_evaluation *d,
                              double derivatives[TDMF_STATE_COUNT]);

/* Rate of the force on a loaded foot under the stance law, N/s: inputs held, leg moving as in the mode. */
tdmf_ground_force tdmf_force_rate(const tdmf_evaluation *at);

#endif
