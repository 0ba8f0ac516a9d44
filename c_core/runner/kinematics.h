/* Positions and velocities that follow from the mechanical state alone. */
#ifndef TDMF_RUNNER_KINEMATICS_H
#define TDMF_RUNNER_KINEMATICS_H

#include "tdmf_slip/outputs.h"

/* The body: x_m = x - r sin(theta), y_m = y + r cos(theta)  (7), and its rate. */
tdmf_point tdmf_body(const double state[TDMF_STATE_COUNT]);

/* The centre of mass of body and foot. */
tdmf_point tdmf_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT]);

/* The foot in the axes of the ground: x runs along the line from its pivot, y away from it. */
tdmf_point tdmf_foot_over_ground(const tdmf_ground_line *ground, const double state[TDMF_STATE_COUNT]);

#endif
