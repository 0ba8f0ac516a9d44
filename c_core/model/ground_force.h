/* Ground force and graze torque at an instant that has been evaluated, and their variations. */
#ifndef TDMF_MODEL_GROUND_FORCE_H
#define TDMF_MODEL_GROUND_FORCE_H

#include "evaluation.h"

/* The force that would hold the foot still under a torque (10), whatever the mode, and its change. */
tdmf_ground_force tdmf_force_under(const tdmf_evaluation *at, double torque);
tdmf_ground_force tdmf_vary_force_under(const tdmf_evaluation *at, const tdmf_evaluation *d, double torque,
                                        double d_torque);

/* The force in the mode, where leg and torque are evaluated. */
tdmf_ground_force tdmf_force_in_mode(const tdmf_evaluation *at);
tdmf_ground_force tdmf_vary_force_in_mode(const tdmf_evaluation *at, const tdmf_evaluation *d);

/* m_f g, and its change. */
double tdmf_foot_weight(const tdmf_model *model);
double tdmf_vary_foot_weight(const tdmf_model *model, const tdmf_model *d);

/* The total torque that keeps an unloaded foot at the ground, where the leg is evaluated. */
double tdmf_graze_torque(const tdmf_evaluation *at);
double tdmf_vary_graze_torque(const tdmf_evaluation *at, const tdmf_leg *d_leg, const tdmf_direction *d);

#endif
