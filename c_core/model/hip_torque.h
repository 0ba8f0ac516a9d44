/* The hip's torque at an instant. */
#ifndef TDMF_MODEL_HIP_TORQUE_H
#define TDMF_MODEL_HIP_TORQUE_H

#include "evaluation.h"

/* The total torque in the mode, where the leg is evaluated, and its change. */
double tdmf_torque_in_mode(const tdmf_evaluation *at);
double tdmf_vary_torque_in_mode(const tdmf_evaluation *at, const tdmf_leg *d_leg, const tdmf_direction *d);

#endif
