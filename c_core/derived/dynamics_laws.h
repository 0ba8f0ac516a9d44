/* Derived from c_core/equations/dynamics.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_DYNAMICS_LAWS_H
#define TDMF_DERIVED_DYNAMICS_LAWS_H

#include "quantities.h"

#include <math.h>

/* f.v_m, the power of the external force on the body. */
static inline double tdmf_external_power(const tdmf_evaluation *at) {
    const double across = at->state[TDMF_LEG_LENGTH] * at->state[TDMF_LEG_ANGLE_RATE];
    const double vx = -at->state[TDMF_LEG_LENGTH_RATE] * at->leg.sine - across * at->leg.cosine;
    const double vy = at->state[TDMF_LEG_LENGTH_RATE] * at->leg.cosine - across * at->leg.sine;
    return at->inputs->body.external_fx * (at->state[TDMF_FOOT_VX] + vx) +
           at->inputs->body.external_fy * (at->state[TDMF_FOOT_VY] + vy);
}

/* Its change. */
static inline double tdmf_vary_external_power(const tdmf_evaluation *at, const tdmf_evaluation *d_at) {
    const double across = at->state[TDMF_LEG_LENGTH] * at->state[TDMF_LEG_ANGLE_RATE];
    const double vx = -at->state[TDMF_LEG_LENGTH_RATE] * at->leg.sine - across * at->leg.cosine;
    const double d_across = d_at->state[TDMF_LEG_LENGTH] * at->state[TDMF_LEG_ANGLE_RATE] +
                            at->state[TDMF_LEG_LENGTH] * d_at->state[TDMF_LEG_ANGLE_RATE];
    const double d_vx = -d_at->state[TDMF_LEG_LENGTH_RATE] * at->leg.sine +
                        -at->state[TDMF_LEG_LENGTH_RATE] * d_at->leg.sine -
                        (d_across * at->leg.cosine + across * d_at->leg.cosine);
    const double vy = at->state[TDMF_LEG_LENGTH_RATE] * at->leg.cosine - across * at->leg.sine;
    const double d_vy = d_at->state[TDMF_LEG_LENGTH_RATE] * at->leg.cosine +
                        at->state[TDMF_LEG_LENGTH_RATE] * d_at->leg.cosine -
                        (d_across * at->leg.sine + across * d_at->leg.sine);
    return d_at->inputs->body.external_fx * (at->state[TDMF_FOOT_VX] + vx) +
           at->inputs->body.external_fx * (d_at->state[TDMF_FOOT_VX] + d_vx) +
           (d_at->inputs->body.external_fy * (at->state[TDMF_FOOT_VY] + vy) +
            at->inputs->body.external_fy * (d_at->state[TDMF_FOOT_VY] + d_vy));
}

/* The right-hand side: velocities, accelerations, powers, and what the hip has of its own.
 *
 * Of powers the state has the integrals. The hip's is tau thetadot, the damper's c rdot^2 and friction's -f_t
 * v_t; with the inputs held the leg does no work. */
static inline void tdmf_rates_at(const tdmf_evaluation *at, double external_power,
                                 double written[TDMF_STATE_COUNT]) {
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        const double across = at->torque * at->leg.inverse_length;
        const double push_x = at->leg.axial_force * at->leg.sine + across * at->leg.cosine;
        const double foot_vx = push_x * at->model->inverse_foot_mass;
        const double push_y = across * at->leg.sine - at->leg.axial_force * at->leg.cosine;
        const double foot_vy = push_y * at->model->inverse_foot_mass - at->model->parameters.gravity;
        const double y = at->inputs->body.external_fy * at->model->inverse_body_mass;
        const double x = at->inputs->body.external_fx * at->model->inverse_body_mass;
        const double turning = across * at->model->inverse_body_mass -
                               (x * at->leg.cosine + (y - at->model->parameters.gravity) * at->leg.sine) +
                               foot_vx * at->leg.cosine + foot_vy * at->leg.sine -
                               2.0 * at->leg.length_rate * at->leg.angle_rate;
        const double power = at->torque * at->leg.angle_rate;
        const double slip_velocity = at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                                     at->mode->ground.sine * at->state[TDMF_FOOT_VY];
        written[TDMF_FOOT_X] = at->state[TDMF_FOOT_VX];
        written[TDMF_FOOT_Y] = at->state[TDMF_FOOT_VY];
        written[TDMF_LEG_LENGTH] = at->leg.length_rate;
        written[TDMF_LEG_ANGLE] = at->leg.angle_rate;
        written[TDMF_FOOT_VX] = foot_vx;
        written[TDMF_FOOT_VY] = foot_vy;
        written[TDMF_LEG_LENGTH_RATE] =
            at->leg.length * at->leg.angle_rate * at->leg.angle_rate +
            at->leg.axial_force * at->model->inverse_body_mass +
            ((y - at->model->parameters.gravity) * at->leg.cosine - x * at->leg.sine) +
            foot_vx * at->leg.sine - foot_vy * at->leg.cosine;
        written[TDMF_LEG_ANGLE_RATE] = turning * at->leg.inverse_length;
        written[TDMF_HIP_WORK] = power;
        written[TDMF_LEG_WORK] = 0.0;
        written[TDMF_ENERGY_DAMPER_LOSS] =
            at->model->parameters.leg.damping * at->leg.length_rate * at->leg.length_rate;
        written[TDMF_ENERGY_FRICTION_LOSS] = -at->force.tangential * slip_velocity;
        written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : power);
        written[TDMF_ENERGY_EXTERNAL_WORK] = external_power;
        written[TDMF_HIP_PLACE_TIME] = (at->mode->phase == TDMF_PHASE_PLACE ? 1.0 : 0.0);
        return;
    }
    if (at->mode->contact == TDMF_CONTACT_STICK) {
        const double y = at->inputs->body.external_fy * at->model->inverse_body_mass;
        const double x = at->inputs->body.external_fx * at->model->inverse_body_mass;
        const double across = at->torque * at->leg.inverse_length;
        const double turning = across * at->model->inverse_body_mass -
                               (x * at->leg.cosine + (y - at->model->parameters.gravity) * at->leg.sine) -
                               2.0 * at->leg.length_rate * at->leg.angle_rate;
        const double power = at->torque * at->leg.angle_rate;
        const double slip_velocity = at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                                     at->mode->ground.sine * at->state[TDMF_FOOT_VY];
        written[TDMF_FOOT_X] = at->state[TDMF_FOOT_VX];
        written[TDMF_FOOT_Y] = at->state[TDMF_FOOT_VY];
        written[TDMF_LEG_LENGTH] = at->leg.length_rate;
        written[TDMF_LEG_ANGLE] = at->leg.angle_rate;
        written[TDMF_FOOT_VX] = 0.0;
        written[TDMF_FOOT_VY] = 0.0;
        written[TDMF_LEG_LENGTH_RATE] =
            at->leg.length * at->leg.angle_rate * at->leg.angle_rate +
            at->leg.axial_force * at->model->inverse_body_mass +
            ((y - at->model->parameters.gravity) * at->leg.cosine - x * at->leg.sine);
        written[TDMF_LEG_ANGLE_RATE] = turning * at->leg.inverse_length;
        written[TDMF_HIP_WORK] = power;
        written[TDMF_LEG_WORK] = 0.0;
        written[TDMF_ENERGY_DAMPER_LOSS] =
            at->model->parameters.leg.damping * at->leg.length_rate * at->leg.length_rate;
        written[TDMF_ENERGY_FRICTION_LOSS] = -at->force.tangential * slip_velocity;
        written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : power);
        written[TDMF_ENERGY_EXTERNAL_WORK] = external_power;
        written[TDMF_HIP_PLACE_TIME] = (at->mode->phase == TDMF_PHASE_PLACE ? 1.0 : 0.0);
        return;
    }
    const double across = at->torque * at->leg.inverse_length;
    const double along = at->leg.axial_force * -at->leg.ground_sine - across * at->leg.ground_cosine;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double tangential = along + weight * at->mode->ground.sine;
    const double foot_vx =
        (at->force.tangential - tangential) * at->model->inverse_foot_mass * at->mode->ground.cosine;
    const double foot_vy =
        (at->force.tangential - tangential) * at->model->inverse_foot_mass * at->mode->ground.sine;
    const double y = at->inputs->body.external_fy * at->model->inverse_body_mass;
    const double x = at->inputs->body.external_fx * at->model->inverse_body_mass;
    const double turning = across * at->model->inverse_body_mass -
                           (x * at->leg.cosine + (y - at->model->parameters.gravity) * at->leg.sine) +
                           foot_vx * at->leg.cosine + foot_vy * at->leg.sine -
                           2.0 * at->leg.length_rate * at->leg.angle_rate;
    const double power = at->torque * at->leg.angle_rate;
    const double slip_velocity =
        at->mode->ground.cosine * at->state[TDMF_FOOT_VX] + at->mode->ground.sine * at->state[TDMF_FOOT_VY];
    written[TDMF_FOOT_X] = at->state[TDMF_FOOT_VX];
    written[TDMF_FOOT_Y] = at->state[TDMF_FOOT_VY];
    written[TDMF_LEG_LENGTH] = at->leg.length_rate;
    written[TDMF_LEG_ANGLE] = at->leg.angle_rate;
    written[TDMF_FOOT_VX] = foot_vx;
    written[TDMF_FOOT_VY] = foot_vy;
    written[TDMF_LEG_LENGTH_RATE] =
        at->leg.length * at->leg.angle_rate * at->leg.angle_rate +
        at->leg.axial_force * at->model->inverse_body_mass +
        ((y - at->model->parameters.gravity) * at->leg.cosine - x * at->leg.sine) + foot_vx * at->leg.sine -
        foot_vy * at->leg.cosine;
    written[TDMF_LEG_ANGLE_RATE] = turning * at->leg.inverse_length;
    written[TDMF_HIP_WORK] = power;
    written[TDMF_LEG_WORK] = 0.0;
    written[TDMF_ENERGY_DAMPER_LOSS] =
        at->model->parameters.leg.damping * at->leg.length_rate * at->leg.length_rate;
    written[TDMF_ENERGY_FRICTION_LOSS] = -at->force.tangential * slip_velocity;
    written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : power);
    written[TDMF_ENERGY_EXTERNAL_WORK] = external_power;
    written[TDMF_HIP_PLACE_TIME] = (at->mode->phase == TDMF_PHASE_PLACE ? 1.0 : 0.0);
}

/* Its change. */
static inline void tdmf_vary_rates_at(const tdmf_evaluation *at, double external_power,
                                      const tdmf_evaluation *d_at, double d_external_power,
                                      double written[TDMF_STATE_COUNT]) {
    (void)external_power;
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        const double d_across = d_at->torque * at->leg.inverse_length + at->torque * d_at->leg.inverse_length;
        const double across = at->torque * at->leg.inverse_length;
        const double d_push_x = d_at->leg.axial_force * at->leg.sine + at->leg.axial_force * d_at->leg.sine +
                                (d_across * at->leg.cosine + across * d_at->leg.cosine);
        const double push_x = at->leg.axial_force * at->leg.sine + across * at->leg.cosine;
        const double d_foot_vx =
            d_push_x * at->model->inverse_foot_mass + push_x * d_at->model->inverse_foot_mass;
        const double d_push_y =
            d_across * at->leg.sine + across * d_at->leg.sine -
            (d_at->leg.axial_force * at->leg.cosine + at->leg.axial_force * d_at->leg.cosine);
        const double push_y = across * at->leg.sine - at->leg.axial_force * at->leg.cosine;
        const double d_foot_vy = d_push_y * at->model->inverse_foot_mass +
                                 push_y * d_at->model->inverse_foot_mass - d_at->model->parameters.gravity;
        const double d_y = d_at->inputs->body.external_fy * at->model->inverse_body_mass +
                           at->inputs->body.external_fy * d_at->model->inverse_body_mass;
        const double y = at->inputs->body.external_fy * at->model->inverse_body_mass;
        const double d_x = d_at->inputs->body.external_fx * at->model->inverse_body_mass +
                           at->inputs->body.external_fx * d_at->model->inverse_body_mass;
        const double x = at->inputs->body.external_fx * at->model->inverse_body_mass;
        const double foot_vx = push_x * at->model->inverse_foot_mass;
        const double foot_vy = push_y * at->model->inverse_foot_mass - at->model->parameters.gravity;
        const double d_turning = d_across * at->model->inverse_body_mass +
                                 across * d_at->model->inverse_body_mass -
                                 (d_x * at->leg.cosine + x * d_at->leg.cosine +
                                  ((d_y - d_at->model->parameters.gravity) * at->leg.sine +
                                   (y - at->model->parameters.gravity) * d_at->leg.sine)) +
                                 (d_foot_vx * at->leg.cosine + foot_vx * d_at->leg.cosine) +
                                 (d_foot_vy * at->leg.sine + foot_vy * d_at->leg.sine) -
                                 (2.0 * d_at->leg.length_rate * at->leg.angle_rate +
                                  2.0 * at->leg.length_rate * d_at->leg.angle_rate);
        const double turning = across * at->model->inverse_body_mass -
                               (x * at->leg.cosine + (y - at->model->parameters.gravity) * at->leg.sine) +
                               foot_vx * at->leg.cosine + foot_vy * at->leg.sine -
                               2.0 * at->leg.length_rate * at->leg.angle_rate;
        const double d_power = d_at->torque * at->leg.angle_rate + at->torque * d_at->leg.angle_rate;
        const double slip_velocity = at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                                     at->mode->ground.sine * at->state[TDMF_FOOT_VY];
        const double d_slip_velocity =
            -(at->mode->ground.sine * d_at->mode->ground.slope) * at->state[TDMF_FOOT_VX] +
            at->mode->ground.cosine * d_at->state[TDMF_FOOT_VX] +
            (at->mode->ground.cosine * d_at->mode->ground.slope * at->state[TDMF_FOOT_VY] +
             at->mode->ground.sine * d_at->state[TDMF_FOOT_VY]);
        const double power = at->torque * at->leg.angle_rate;
        written[TDMF_FOOT_X] = d_at->state[TDMF_FOOT_VX];
        written[TDMF_FOOT_Y] = d_at->state[TDMF_FOOT_VY];
        written[TDMF_LEG_LENGTH] = d_at->leg.length_rate;
        written[TDMF_LEG_ANGLE] = d_at->leg.angle_rate;
        written[TDMF_FOOT_VX] = d_foot_vx;
        written[TDMF_FOOT_VY] = d_foot_vy;
        written[TDMF_LEG_LENGTH_RATE] =
            (d_at->leg.length * at->leg.angle_rate + at->leg.length * d_at->leg.angle_rate) *
                at->leg.angle_rate +
            at->leg.length * at->leg.angle_rate * d_at->leg.angle_rate +
            (d_at->leg.axial_force * at->model->inverse_body_mass +
             at->leg.axial_force * d_at->model->inverse_body_mass) +
            ((d_y - d_at->model->parameters.gravity) * at->leg.cosine +
             (y - at->model->parameters.gravity) * d_at->leg.cosine -
             (d_x * at->leg.sine + x * d_at->leg.sine)) +
            (d_foot_vx * at->leg.sine + foot_vx * d_at->leg.sine) -
            (d_foot_vy * at->leg.cosine + foot_vy * d_at->leg.cosine);
        written[TDMF_LEG_ANGLE_RATE] =
            d_turning * at->leg.inverse_length + turning * d_at->leg.inverse_length;
        written[TDMF_HIP_WORK] = d_power;
        written[TDMF_LEG_WORK] = 0.0;
        written[TDMF_ENERGY_DAMPER_LOSS] =
            (d_at->model->parameters.leg.damping * at->leg.length_rate +
             at->model->parameters.leg.damping * d_at->leg.length_rate) *
                at->leg.length_rate +
            at->model->parameters.leg.damping * at->leg.length_rate * d_at->leg.length_rate;
        written[TDMF_ENERGY_FRICTION_LOSS] =
            -d_at->force.tangential * slip_velocity + -at->force.tangential * d_slip_velocity;
        written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : d_power);
        written[TDMF_ENERGY_EXTERNAL_WORK] = d_external_power;
        written[TDMF_HIP_PLACE_TIME] = 0.0;
        return;
    }
    if (at->mode->contact == TDMF_CONTACT_STICK) {
        const double d_y = d_at->inputs->body.external_fy * at->model->inverse_body_mass +
                           at->inputs->body.external_fy * d_at->model->inverse_body_mass;
        const double y = at->inputs->body.external_fy * at->model->inverse_body_mass;
        const double d_x = d_at->inputs->body.external_fx * at->model->inverse_body_mass +
                           at->inputs->body.external_fx * d_at->model->inverse_body_mass;
        const double x = at->inputs->body.external_fx * at->model->inverse_body_mass;
        const double d_across = d_at->torque * at->leg.inverse_length + at->torque * d_at->leg.inverse_length;
        const double across = at->torque * at->leg.inverse_length;
        const double d_turning = d_across * at->model->inverse_body_mass +
                                 across * d_at->model->inverse_body_mass -
                                 (d_x * at->leg.cosine + x * d_at->leg.cosine +
                                  ((d_y - d_at->model->parameters.gravity) * at->leg.sine +
                                   (y - at->model->parameters.gravity) * d_at->leg.sine)) -
                                 (2.0 * d_at->leg.length_rate * at->leg.angle_rate +
                                  2.0 * at->leg.length_rate * d_at->leg.angle_rate);
        const double turning = across * at->model->inverse_body_mass -
                               (x * at->leg.cosine + (y - at->model->parameters.gravity) * at->leg.sine) -
                               2.0 * at->leg.length_rate * at->leg.angle_rate;
        const double d_power = d_at->torque * at->leg.angle_rate + at->torque * d_at->leg.angle_rate;
        const double slip_velocity = at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                                     at->mode->ground.sine * at->state[TDMF_FOOT_VY];
        const double d_slip_velocity =
            -(at->mode->ground.sine * d_at->mode->ground.slope) * at->state[TDMF_FOOT_VX] +
            at->mode->ground.cosine * d_at->state[TDMF_FOOT_VX] +
            (at->mode->ground.cosine * d_at->mode->ground.slope * at->state[TDMF_FOOT_VY] +
             at->mode->ground.sine * d_at->state[TDMF_FOOT_VY]);
        const double power = at->torque * at->leg.angle_rate;
        written[TDMF_FOOT_X] = d_at->state[TDMF_FOOT_VX];
        written[TDMF_FOOT_Y] = d_at->state[TDMF_FOOT_VY];
        written[TDMF_LEG_LENGTH] = d_at->leg.length_rate;
        written[TDMF_LEG_ANGLE] = d_at->leg.angle_rate;
        written[TDMF_FOOT_VX] = 0.0;
        written[TDMF_FOOT_VY] = 0.0;
        written[TDMF_LEG_LENGTH_RATE] =
            (d_at->leg.length * at->leg.angle_rate + at->leg.length * d_at->leg.angle_rate) *
                at->leg.angle_rate +
            at->leg.length * at->leg.angle_rate * d_at->leg.angle_rate +
            (d_at->leg.axial_force * at->model->inverse_body_mass +
             at->leg.axial_force * d_at->model->inverse_body_mass) +
            ((d_y - d_at->model->parameters.gravity) * at->leg.cosine +
             (y - at->model->parameters.gravity) * d_at->leg.cosine -
             (d_x * at->leg.sine + x * d_at->leg.sine));
        written[TDMF_LEG_ANGLE_RATE] =
            d_turning * at->leg.inverse_length + turning * d_at->leg.inverse_length;
        written[TDMF_HIP_WORK] = d_power;
        written[TDMF_LEG_WORK] = 0.0;
        written[TDMF_ENERGY_DAMPER_LOSS] =
            (d_at->model->parameters.leg.damping * at->leg.length_rate +
             at->model->parameters.leg.damping * d_at->leg.length_rate) *
                at->leg.length_rate +
            at->model->parameters.leg.damping * at->leg.length_rate * d_at->leg.length_rate;
        written[TDMF_ENERGY_FRICTION_LOSS] =
            -d_at->force.tangential * slip_velocity + -at->force.tangential * d_slip_velocity;
        written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : d_power);
        written[TDMF_ENERGY_EXTERNAL_WORK] = d_external_power;
        written[TDMF_HIP_PLACE_TIME] = 0.0;
        return;
    }
    const double d_across = d_at->torque * at->leg.inverse_length + at->torque * d_at->leg.inverse_length;
    const double across = at->torque * at->leg.inverse_length;
    const double d_along = d_at->leg.axial_force * -at->leg.ground_sine +
                           at->leg.axial_force * -d_at->leg.ground_sine -
                           (d_across * at->leg.ground_cosine + across * d_at->leg.ground_cosine);
    const double d_weight = d_at->model->parameters.foot.mass * at->model->parameters.gravity +
                            at->model->parameters.foot.mass * d_at->model->parameters.gravity;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double d_tangential = d_along + (d_weight * at->mode->ground.sine +
                                           weight * (at->mode->ground.cosine * d_at->mode->ground.slope));
    const double along = at->leg.axial_force * -at->leg.ground_sine - across * at->leg.ground_cosine;
    const double tangential = along + weight * at->mode->ground.sine;
    const double d_foot_vx = ((d_at->force.tangential - d_tangential) * at->model->inverse_foot_mass +
                              (at->force.tangential - tangential) * d_at->model->inverse_foot_mass) *
                                 at->mode->ground.cosine +
                             (at->force.tangential - tangential) * at->model->inverse_foot_mass *
                                 -(at->mode->ground.sine * d_at->mode->ground.slope);
    const double d_foot_vy = ((d_at->force.tangential - d_tangential) * at->model->inverse_foot_mass +
                              (at->force.tangential - tangential) * d_at->model->inverse_foot_mass) *
                                 at->mode->ground.sine +
                             (at->force.tangential - tangential) * at->model->inverse_foot_mass *
                                 (at->mode->ground.cosine * d_at->mode->ground.slope);
    const double d_y = d_at->inputs->body.external_fy * at->model->inverse_body_mass +
                       at->inputs->body.external_fy * d_at->model->inverse_body_mass;
    const double y = at->inputs->body.external_fy * at->model->inverse_body_mass;
    const double d_x = d_at->inputs->body.external_fx * at->model->inverse_body_mass +
                       at->inputs->body.external_fx * d_at->model->inverse_body_mass;
    const double x = at->inputs->body.external_fx * at->model->inverse_body_mass;
    const double foot_vx =
        (at->force.tangential - tangential) * at->model->inverse_foot_mass * at->mode->ground.cosine;
    const double foot_vy =
        (at->force.tangential - tangential) * at->model->inverse_foot_mass * at->mode->ground.sine;
    const double d_turning =
        d_across * at->model->inverse_body_mass + across * d_at->model->inverse_body_mass -
        (d_x * at->leg.cosine + x * d_at->leg.cosine +
         ((d_y - d_at->model->parameters.gravity) * at->leg.sine +
          (y - at->model->parameters.gravity) * d_at->leg.sine)) +
        (d_foot_vx * at->leg.cosine + foot_vx * d_at->leg.cosine) +
        (d_foot_vy * at->leg.sine + foot_vy * d_at->leg.sine) -
        (2.0 * d_at->leg.length_rate * at->leg.angle_rate + 2.0 * at->leg.length_rate * d_at->leg.angle_rate);
    const double turning = across * at->model->inverse_body_mass -
                           (x * at->leg.cosine + (y - at->model->parameters.gravity) * at->leg.sine) +
                           foot_vx * at->leg.cosine + foot_vy * at->leg.sine -
                           2.0 * at->leg.length_rate * at->leg.angle_rate;
    const double d_power = d_at->torque * at->leg.angle_rate + at->torque * d_at->leg.angle_rate;
    const double slip_velocity =
        at->mode->ground.cosine * at->state[TDMF_FOOT_VX] + at->mode->ground.sine * at->state[TDMF_FOOT_VY];
    const double d_slip_velocity =
        -(at->mode->ground.sine * d_at->mode->ground.slope) * at->state[TDMF_FOOT_VX] +
        at->mode->ground.cosine * d_at->state[TDMF_FOOT_VX] +
        (at->mode->ground.cosine * d_at->mode->ground.slope * at->state[TDMF_FOOT_VY] +
         at->mode->ground.sine * d_at->state[TDMF_FOOT_VY]);
    const double power = at->torque * at->leg.angle_rate;
    written[TDMF_FOOT_X] = d_at->state[TDMF_FOOT_VX];
    written[TDMF_FOOT_Y] = d_at->state[TDMF_FOOT_VY];
    written[TDMF_LEG_LENGTH] = d_at->leg.length_rate;
    written[TDMF_LEG_ANGLE] = d_at->leg.angle_rate;
    written[TDMF_FOOT_VX] = d_foot_vx;
    written[TDMF_FOOT_VY] = d_foot_vy;
    written[TDMF_LEG_LENGTH_RATE] =
        (d_at->leg.length * at->leg.angle_rate + at->leg.length * d_at->leg.angle_rate) * at->leg.angle_rate +
        at->leg.length * at->leg.angle_rate * d_at->leg.angle_rate +
        (d_at->leg.axial_force * at->model->inverse_body_mass +
         at->leg.axial_force * d_at->model->inverse_body_mass) +
        ((d_y - d_at->model->parameters.gravity) * at->leg.cosine +
         (y - at->model->parameters.gravity) * d_at->leg.cosine - (d_x * at->leg.sine + x * d_at->leg.sine)) +
        (d_foot_vx * at->leg.sine + foot_vx * d_at->leg.sine) -
        (d_foot_vy * at->leg.cosine + foot_vy * d_at->leg.cosine);
    written[TDMF_LEG_ANGLE_RATE] = d_turning * at->leg.inverse_length + turning * d_at->leg.inverse_length;
    written[TDMF_HIP_WORK] = d_power;
    written[TDMF_LEG_WORK] = 0.0;
    written[TDMF_ENERGY_DAMPER_LOSS] =
        (d_at->model->parameters.leg.damping * at->leg.length_rate +
         at->model->parameters.leg.damping * d_at->leg.length_rate) *
            at->leg.length_rate +
        at->model->parameters.leg.damping * at->leg.length_rate * d_at->leg.length_rate;
    written[TDMF_ENERGY_FRICTION_LOSS] =
        -d_at->force.tangential * slip_velocity + -at->force.tangential * d_slip_velocity;
    written[TDMF_HIP_POSITIVE_WORK] = (0.0 >= power ? 0.0 : d_power);
    written[TDMF_ENERGY_EXTERNAL_WORK] = d_external_power;
    written[TDMF_HIP_PLACE_TIME] = 0.0;
}

#endif
