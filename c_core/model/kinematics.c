/* Positions and velocities as the world asks for them. */
#include "kinematics.h"

#include "free_fall_laws.h"

tdmf_point tdmf_body(const double state[TDMF_STATE_COUNT]) {
    return tdmf_body_along(state, tdmf_leg_direction_of(state));
}

tdmf_point tdmf_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    return tdmf_center_of_mass_along(model, state, tdmf_leg_direction_of(state));
}

tdmf_point tdmf_center_of_mass_after(tdmf_system system, tdmf_point from, double time) {
    return tdmf_ballistic_under(system.model, system.inputs, from, time);
}

void tdmf_set_foot_velocity_along(double vx, double vy, tdmf_leg_direction direction,
                                  double state[TDMF_STATE_COUNT]) {
    const tdmf_leg_rates rates = tdmf_leg_rates_with_foot(state, direction, vx, vy);
    state[TDMF_LEG_LENGTH_RATE] = rates.length;
    state[TDMF_LEG_ANGLE_RATE] = rates.angle;
    state[TDMF_FOOT_VX] = vx;
    state[TDMF_FOOT_VY] = vy;
}

void tdmf_set_foot_velocity(double vx, double vy, double state[TDMF_STATE_COUNT]) {
    tdmf_set_foot_velocity_along(vx, vy, tdmf_leg_direction_of(state), state);
}

tdmf_point tdmf_foot_over_ground(const tdmf_ground_line *ground, const double state[TDMF_STATE_COUNT]) {
    return tdmf_foot_over(ground, state);
}
