/* Positions and velocities as the world asks for them. */
#include "tdmf_slip/kinematics.h"

#include "coordinate_laws.h"
#include "free_fall_laws.h"
#include "leg.h"

tdmf_point tdmf_body(const double state[TDMF_STATE_COUNT]) {
    return tdmf_body_along(state, tdmf_leg_direction_of(state));
}

tdmf_point tdmf_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    return tdmf_center_of_mass_along(model, state, tdmf_leg_direction_of(state));
}

tdmf_point tdmf_center_of_mass_after(tdmf_system system, tdmf_point from, double time) {
    return tdmf_ballistic_under(system.model, system.inputs, from, time);
}

void tdmf_set_foot_velocity(double vx, double vy, double state[TDMF_STATE_COUNT]) {
    tdmf_set_foot_velocity_along(state, tdmf_leg_direction_of(state), vx, vy, state);
}

tdmf_point tdmf_foot_over_ground(const tdmf_ground_line *ground, const double state[TDMF_STATE_COUNT]) {
    return tdmf_foot_over(ground, state);
}
