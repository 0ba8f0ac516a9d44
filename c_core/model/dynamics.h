/* How the ground force changes at an instant that has been evaluated. */
#ifndef TDMF_MODEL_DYNAMICS_H
#define TDMF_MODEL_DYNAMICS_H

#include "evaluation.h"
#include "tdmf_slip/dynamics.h"

/* Rate of the force on a loaded foot under the stance law, N/s: inputs held, leg moving as in the mode. */
tdmf_ground_force tdmf_force_rate(const tdmf_evaluation *at);

#endif
