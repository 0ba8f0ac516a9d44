/* Derived from c_core/equations/dynamics.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_DYNAMICS_LAWS_H
#define TDMF_DERIVED_DYNAMICS_LAWS_H

#include "quantities.h"

#include <math.h>

/* m_f a = f - f_stick, along the ground, and in flight by the leg and gravity (8). */
static inline tdmf_vector tdmf_acceleration_of_foot(const tdmf_model *model, const tdmf_ground_line *line,
                                                    const tdmf_leg *leg, double torque,
                                                    tdmf_ground_force force, tdmf_contact_mode contact) {
    if (contact == TDMF_CONTACT_FLIGHT) {
        const double across = torque * leg->inverse_length;
        const double push_x = leg->axial_force * leg->sine + across * leg->cosine;
        const double push_y = across * leg->sine - leg->axial_force * leg->cosine;
        const tdmf_vector result = {
            .x = push_x * model->inverse_foot_mass,
            .y = push_y * model->inverse_foot_mass - model->parameters.gravity,
        };
        return result;
    }
    if (contact == TDMF_CONTACT_STICK) {
        const tdmf_vector result = {
            .x = 0.0,
            .y = 0.0,
        };
        return result;
    }
    const double across = torque * leg->inverse_length;
    const double along = leg->axial_force * -leg->ground_sine - across * leg->ground_cosine;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double tangential = along + weight * line->sine;
    const tdmf_vector result = {
        .x = (force.tangential - tangential) * model->inverse_foot_mass * line->cosine,
        .y = (force.tangential - tangential) * model->inverse_foot_mass * line->sine,
    };
    return result;
}

/* Its change. */
static inline tdmf_vector
tdmf_vary_acceleration_of_foot(const tdmf_model *model, const tdmf_ground_line *line, const tdmf_leg *leg,
                               double torque, tdmf_ground_force force, tdmf_contact_mode contact,
                               const tdmf_model *d_model, const tdmf_ground_line *d_line,
                               const tdmf_leg *d_leg, double d_torque, tdmf_ground_force d_force) {
    if (contact == TDMF_CONTACT_FLIGHT) {
        const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
        const double across = torque * leg->inverse_length;
        const double d_push_x = d_leg->axial_force * leg->sine + leg->axial_force * d_leg->sine +
                                (d_across * leg->cosine + across * d_leg->cosine);
        const double push_x = leg->axial_force * leg->sine + across * leg->cosine;
        const double d_push_y = d_across * leg->sine + across * d_leg->sine -
                                (d_leg->axial_force * leg->cosine + leg->axial_force * d_leg->cosine);
        const double push_y = across * leg->sine - leg->axial_force * leg->cosine;
        const tdmf_vector result = {
            .x = d_push_x * model->inverse_foot_mass + push_x * d_model->inverse_foot_mass,
            .y = d_push_y * model->inverse_foot_mass + push_y * d_model->inverse_foot_mass -
                 d_model->parameters.gravity,
        };
        return result;
    }
    if (contact == TDMF_CONTACT_STICK) {
        const tdmf_vector result = {
            .x = 0.0,
            .y = 0.0,
        };
        return result;
    }
    const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
    const double across = torque * leg->inverse_length;
    const double d_along = d_leg->axial_force * -leg->ground_sine + leg->axial_force * -d_leg->ground_sine -
                           (d_across * leg->ground_cosine + across * d_leg->ground_cosine);
    const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                            model->parameters.foot.mass * d_model->parameters.gravity;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double d_tangential = d_along + (d_weight * line->sine + weight * (line->cosine * d_line->slope));
    const double along = leg->axial_force * -leg->ground_sine - across * leg->ground_cosine;
    const double tangential = along + weight * line->sine;
    const tdmf_vector result = {
        .x = ((d_force.tangential - d_tangential) * model->inverse_foot_mass +
              (force.tangential - tangential) * d_model->inverse_foot_mass) *
                 line->cosine +
             (force.tangential - tangential) * model->inverse_foot_mass * -(line->sine * d_line->slope),
        .y = ((d_force.tangential - d_tangential) * model->inverse_foot_mass +
              (force.tangential - tangential) * d_model->inverse_foot_mass) *
                 line->sine +
             (force.tangential - tangential) * model->inverse_foot_mass * (line->cosine * d_line->slope),
    };
    return result;
}

/* rddot = r thetadot^2 + u.(a_body - a_foot), r thetaddot = t.(a_body - a_foot) - 2 rdot thetadot (9).
 *
 * `across` is tau/r. By the body's mass `free_body` is what it would have without the leg and `foot` what the
 * foot has. In flight they may be taken together: by the reduced mass `free_body` is the push alone, and a
 * foot has no acceleration. */
static inline tdmf_leg_rates tdmf_acceleration_of_leg(const tdmf_model *model, const tdmf_leg *leg,
                                                      double torque, tdmf_vector free_body,
                                                      tdmf_vector foot) {
    const double turning = torque * leg->inverse_length * model->inverse_body_mass -
                           (free_body.x * leg->cosine + free_body.y * leg->sine) + foot.x * leg->cosine +
                           foot.y * leg->sine - 2.0 * leg->length_rate * leg->angle_rate;
    const tdmf_leg_rates result = {
        .length =
            leg->length * leg->angle_rate * leg->angle_rate + leg->axial_force * model->inverse_body_mass +
            (free_body.y * leg->cosine - free_body.x * leg->sine) + foot.x * leg->sine - foot.y * leg->cosine,
        .angle = turning * leg->inverse_length,
    };
    return result;
}

/* Its change. */
static inline tdmf_leg_rates tdmf_vary_acceleration_of_leg(const tdmf_model *model, const tdmf_leg *leg,
                                                           double torque, tdmf_vector free_body,
                                                           tdmf_vector foot, const tdmf_model *d_model,
                                                           const tdmf_leg *d_leg, double d_torque,
                                                           tdmf_vector d_free_body, tdmf_vector d_foot) {
    const double d_turning =
        (d_torque * leg->inverse_length + torque * d_leg->inverse_length) * model->inverse_body_mass +
        torque * leg->inverse_length * d_model->inverse_body_mass -
        (d_free_body.x * leg->cosine + free_body.x * d_leg->cosine +
         (d_free_body.y * leg->sine + free_body.y * d_leg->sine)) +
        (d_foot.x * leg->cosine + foot.x * d_leg->cosine) + (d_foot.y * leg->sine + foot.y * d_leg->sine) -
        (2.0 * d_leg->length_rate * leg->angle_rate + 2.0 * leg->length_rate * d_leg->angle_rate);
    const double turning = torque * leg->inverse_length * model->inverse_body_mass -
                           (free_body.x * leg->cosine + free_body.y * leg->sine) + foot.x * leg->cosine +
                           foot.y * leg->sine - 2.0 * leg->length_rate * leg->angle_rate;
    const tdmf_leg_rates result = {
        .length =
            (d_leg->length * leg->angle_rate + leg->length * d_leg->angle_rate) * leg->angle_rate +
            leg->length * leg->angle_rate * d_leg->angle_rate +
            (d_leg->axial_force * model->inverse_body_mass + leg->axial_force * d_model->inverse_body_mass) +
            (d_free_body.y * leg->cosine + free_body.y * d_leg->cosine -
             (d_free_body.x * leg->sine + free_body.x * d_leg->sine)) +
            (d_foot.x * leg->sine + foot.x * d_leg->sine) - (d_foot.y * leg->cosine + foot.y * d_leg->cosine),
        .angle = d_turning * leg->inverse_length + turning * d_leg->inverse_length,
    };
    return result;
}

/* f.v_m, the power of the external force on the body. */
static inline double tdmf_external_power(const tdmf_inputs *inputs, tdmf_point body) {
    return inputs->body.external_fx * body.vx + inputs->body.external_fy * body.vy;
}

/* Its change. */
static inline double tdmf_vary_external_power(const tdmf_inputs *inputs, tdmf_point body,
                                              const tdmf_inputs *d_inputs, tdmf_point d_body) {
    return d_inputs->body.external_fx * body.vx + inputs->body.external_fx * d_body.vx +
           (d_inputs->body.external_fy * body.vy + inputs->body.external_fy * d_body.vy);
}

/* The right-hand side but for the hip's own states: velocities, accelerations, and powers.
 *
 * Of these the state has the integrals. The hip's is tau thetadot, the damper's c rdot^2 and friction's -f_t
 * v_t; with the inputs held the leg does no work. */
static inline void tdmf_rates_with(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                   const tdmf_leg *leg, double torque, tdmf_ground_force force,
                                   tdmf_vector foot, tdmf_leg_rates leg_acceleration, double slip_velocity,
                                   double external_power, double written[TDMF_STATE_COUNT]) {
    const double power = torque * leg->angle_rate;
    written[TDMF_FOOT_X] = state[TDMF_FOOT_VX];
    written[TDMF_FOOT_Y] = state[TDMF_FOOT_VY];
    written[TDMF_LEG_LENGTH] = leg->length_rate;
    written[TDMF_LEG_ANGLE] = leg->angle_rate;
    written[TDMF_FOOT_VX] = foot.x;
    written[TDMF_FOOT_VY] = foot.y;
    written[TDMF_LEG_LENGTH_RATE] = leg_acceleration.length;
    written[TDMF_LEG_ANGLE_RATE] = leg_acceleration.angle;
    written[TDMF_HIP_WORK] = power;
    written[TDMF_LEG_WORK] = 0.0;
    written[TDMF_ENERGY_DAMPER_LOSS] = model->parameters.leg.damping * leg->length_rate * leg->length_rate;
    written[TDMF_ENERGY_FRICTION_LOSS] = -force.tangential * slip_velocity;
    written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : power);
    written[TDMF_ENERGY_EXTERNAL_WORK] = external_power;
}

/* Its change. */
static inline void tdmf_vary_rates_with(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                        const tdmf_leg *leg, double torque, tdmf_ground_force force,
                                        tdmf_vector foot, tdmf_leg_rates leg_acceleration,
                                        double slip_velocity, double external_power,
                                        const tdmf_model *d_model, const double d_state[TDMF_STATE_COUNT],
                                        const tdmf_leg *d_leg, double d_torque, tdmf_ground_force d_force,
                                        tdmf_vector d_foot, tdmf_leg_rates d_leg_acceleration,
                                        double d_slip_velocity, double d_external_power,
                                        double written[TDMF_STATE_COUNT]) {
    (void)state;
    (void)foot;
    (void)leg_acceleration;
    (void)external_power;
    const double d_power = d_torque * leg->angle_rate + torque * d_leg->angle_rate;
    const double power = torque * leg->angle_rate;
    written[TDMF_FOOT_X] = d_state[TDMF_FOOT_VX];
    written[TDMF_FOOT_Y] = d_state[TDMF_FOOT_VY];
    written[TDMF_LEG_LENGTH] = d_leg->length_rate;
    written[TDMF_LEG_ANGLE] = d_leg->angle_rate;
    written[TDMF_FOOT_VX] = d_foot.x;
    written[TDMF_FOOT_VY] = d_foot.y;
    written[TDMF_LEG_LENGTH_RATE] = d_leg_acceleration.length;
    written[TDMF_LEG_ANGLE_RATE] = d_leg_acceleration.angle;
    written[TDMF_HIP_WORK] = d_power;
    written[TDMF_LEG_WORK] = 0.0;
    written[TDMF_ENERGY_DAMPER_LOSS] = (d_model->parameters.leg.damping * leg->length_rate +
                                        model->parameters.leg.damping * d_leg->length_rate) *
                                           leg->length_rate +
                                       model->parameters.leg.damping * leg->length_rate * d_leg->length_rate;
    written[TDMF_ENERGY_FRICTION_LOSS] =
        -d_force.tangential * slip_velocity + -force.tangential * d_slip_velocity;
    written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : d_power);
    written[TDMF_ENERGY_EXTERNAL_WORK] = d_external_power;
}

#endif
