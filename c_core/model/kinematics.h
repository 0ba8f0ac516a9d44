/* The body as seen from the foot, and variations of positions and velocities. */
#ifndef TDMF_MODEL_KINEMATICS_H
#define TDMF_MODEL_KINEMATICS_H

#include "leg.h"
#include "tdmf_slip/kinematics.h"

/* Position and velocity of the body less those of the foot, and their change. */
tdmf_point tdmf_body_from_foot(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction);
tdmf_point tdmf_vary_body_from_foot(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                                    const double d_state[TDMF_STATE_COUNT]);

tdmf_point tdmf_vary_body(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                          const double d_state[TDMF_STATE_COUNT]);

/* The public functions, where the leg's direction is at hand. */
tdmf_point tdmf_body_along(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction);
tdmf_point tdmf_center_of_mass_along(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                     tdmf_leg_direction direction);
void tdmf_set_foot_velocity_along(double vx, double vy, tdmf_leg_direction direction,
                                  double state[TDMF_STATE_COUNT]);

/* `d` has the changes of the model's constants. */
tdmf_point tdmf_vary_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                    tdmf_leg_direction direction, const tdmf_model *d,
                                    const double d_state[TDMF_STATE_COUNT]);

/* Moves the foot so that the centre of mass is there and moves so, and the change of the foot that makes this
 * change of the centre of mass; the leg is that of the state, and its change that of `d_state`. */
void tdmf_set_center_of_mass(const tdmf_model *model, tdmf_point center, double state[TDMF_STATE_COUNT]);
void tdmf_vary_foot_to(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                       tdmf_leg_direction direction, const tdmf_model *d, tdmf_point d_center,
                       double d_state[TDMF_STATE_COUNT]);

/* The inverse of tdmf_vary_body_from_foot: the changes of the leg that make this change of the body's place
 * and velocity. */
void tdmf_vary_leg_to(const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                      tdmf_point d_from_foot, double d_state[TDMF_STATE_COUNT]);

#endif
