/* The hip's torques at an instant, with the inputs held, and their changes. */
#ifndef TDMF_MODEL_HIP_TORQUE_H
#define TDMF_MODEL_HIP_TORQUE_H

#include "evaluation.h"

/* Of the servo of the flight law alone. */
double tdmf_servo_torque(const tdmf_model *model, const tdmf_mode *mode,
                         const double state[TDMF_STATE_COUNT]);
double tdmf_vary_servo_torque(const tdmf_model *model, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT], const tdmf_direction *d);

/* Under the stance law, and under the flight law in a mode, where the leg is evaluated. */
double tdmf_stance_torque(const tdmf_evaluation *at);
double tdmf_vary_stance_torque(const tdmf_evaluation *at, const tdmf_direction *d);
double tdmf_flight_torque(const tdmf_evaluation *at, const tdmf_mode *mode);
double tdmf_vary_flight_torque(const tdmf_evaluation *at, const tdmf_mode *mode, const tdmf_direction *d);

/* The total torque in the mode, where the leg is evaluated, and its change. */
double tdmf_torque_in_mode(const tdmf_evaluation *at);
double tdmf_vary_torque_in_mode(const tdmf_evaluation *at, const tdmf_leg *d_leg, const tdmf_direction *d);

#endif
