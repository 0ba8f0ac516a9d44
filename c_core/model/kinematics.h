/* Positions and velocities where the leg's direction is at hand; the laws are in equations/coordinates.py. */
#ifndef TDMF_MODEL_KINEMATICS_H
#define TDMF_MODEL_KINEMATICS_H

#include "coordinate_laws.h"
#include "leg.h"

/* tdmf_set_foot_velocity, where the leg's direction is at hand. */
void tdmf_set_foot_velocity_along(double vx, double vy, tdmf_leg_direction direction,
                                  double state[TDMF_STATE_COUNT]);

#endif
