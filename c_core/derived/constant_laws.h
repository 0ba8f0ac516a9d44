/* Derived from c_core/equations/constants.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_CONSTANT_LAWS_H
#define TDMF_DERIVED_CONSTANT_LAWS_H

#include "coefficients.h"

#include <math.h>

/* Leg, hip and the push on the body, of flight as seen from the centre of mass. */
static inline flight_coefficients tdmf_flight_coefficients_of(const tdmf_model *model,
                                                              const tdmf_hip_law *law, double rest_length,
                                                              tdmf_vector push) {
    const flight_coefficients result = {
        .inverse_reduced_mass = model->inverse_reduced_mass,
        .stiffness = model->parameters.leg.stiffness,
        .damping = model->parameters.leg.damping,
        .rest_length = rest_length,
        .gain = law->gain,
        .rate_gain = law->rate_gain,
        .target = law->target,
        .torque = law->torque,
        .torque_rate = law->torque_rate + law->gain * law->target_rate,
        .push_x = push.x,
        .push_y = push.y,
    };
    return result;
}

/* Of flight in a mode. */
static inline flight_coefficients tdmf_flight_coefficients_in(const tdmf_model *model,
                                                              const tdmf_inputs *inputs,
                                                              const tdmf_mode *mode, double place_time) {
    if (mode->phase == TDMF_PHASE_PLACE) {
        const double length = model->parameters.leg.free_length + inputs->leg.extension;
        const double torque = -model->parameters.hip.kd * model->parameters.hip.retraction_rate;
        const double target_rate = -model->parameters.hip.retraction_rate;
        const flight_coefficients result = {
            .inverse_reduced_mass = model->inverse_reduced_mass,
            .stiffness = model->parameters.leg.stiffness,
            .damping = model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                               ? model->parameters.leg.thrust + inputs->control.thrust
                                               : 0.0)
                               : length),
            .gain = model->parameters.hip.kp,
            .rate_gain = model->parameters.hip.kd,
            .target = model->parameters.hip.touchdown_angle + inputs->control.touchdown_angle -
                      model->parameters.hip.retraction_rate * place_time,
            .torque = torque + inputs->hip.external_torque,
            .torque_rate = model->parameters.hip.kp * target_rate,
            .push_x = inputs->body.external_fx * model->inverse_body_mass,
            .push_y = inputs->body.external_fy * model->inverse_body_mass,
        };
        return result;
    }
    if (mode->clamp_closed) {
        const double length = model->parameters.leg.free_length + inputs->leg.extension;
        const flight_coefficients result = {
            .inverse_reduced_mass = model->inverse_reduced_mass,
            .stiffness = model->parameters.leg.stiffness,
            .damping = model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                               ? model->parameters.leg.thrust + inputs->control.thrust
                                               : 0.0)
                               : length),
            .torque = inputs->hip.external_torque,
            .push_x = inputs->body.external_fx * model->inverse_body_mass,
            .push_y = inputs->body.external_fy * model->inverse_body_mass,
        };
        return result;
    }
    const double length = model->parameters.leg.free_length + inputs->leg.extension;
    const flight_coefficients result = {
        .inverse_reduced_mass = model->inverse_reduced_mass,
        .stiffness = model->parameters.leg.stiffness,
        .damping = model->parameters.leg.damping,
        .rest_length = (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                                      ? model->parameters.leg.thrust + inputs->control.thrust
                                                      : 0.0)
                                      : length),
        .gain = model->parameters.hip.kp,
        .rate_gain = model->parameters.hip.kd,
        .target = model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle,
        .torque = inputs->hip.external_torque,
        .push_x = inputs->body.external_fx * model->inverse_body_mass,
        .push_y = inputs->body.external_fy * model->inverse_body_mass,
    };
    return result;
}

/* Its change. */
static inline flight_coefficients
tdmf_vary_flight_coefficients_in(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                 double place_time, const tdmf_model *d_model, const tdmf_inputs *d_inputs,
                                 const tdmf_mode *d_mode, double d_place_time) {
    if (mode->phase == TDMF_PHASE_PLACE) {
        const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
        const double d_torque = -d_model->parameters.hip.kd * model->parameters.hip.retraction_rate +
                                -model->parameters.hip.kd * d_model->parameters.hip.retraction_rate;
        const double target_rate = -model->parameters.hip.retraction_rate;
        const double d_target_rate = -d_model->parameters.hip.retraction_rate;
        const flight_coefficients result = {
            .inverse_reduced_mass = d_model->inverse_reduced_mass,
            .stiffness = d_model->parameters.leg.stiffness,
            .damping = d_model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                                 ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                                 : 0.0)
                               : d_length),
            .gain = d_model->parameters.hip.kp,
            .rate_gain = d_model->parameters.hip.kd,
            .target = d_model->parameters.hip.touchdown_angle + d_inputs->control.touchdown_angle -
                      (d_model->parameters.hip.retraction_rate * place_time +
                       model->parameters.hip.retraction_rate * d_place_time),
            .torque = d_torque + d_inputs->hip.external_torque,
            .torque_rate =
                d_model->parameters.hip.kp * target_rate + model->parameters.hip.kp * d_target_rate,
            .push_x = d_inputs->body.external_fx * model->inverse_body_mass +
                      inputs->body.external_fx * d_model->inverse_body_mass,
            .push_y = d_inputs->body.external_fy * model->inverse_body_mass +
                      inputs->body.external_fy * d_model->inverse_body_mass,
        };
        return result;
    }
    if (mode->clamp_closed) {
        const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
        const flight_coefficients result = {
            .inverse_reduced_mass = d_model->inverse_reduced_mass,
            .stiffness = d_model->parameters.leg.stiffness,
            .damping = d_model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                                 ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                                 : 0.0)
                               : d_length),
            .torque = d_inputs->hip.external_torque,
            .push_x = d_inputs->body.external_fx * model->inverse_body_mass +
                      inputs->body.external_fx * d_model->inverse_body_mass,
            .push_y = d_inputs->body.external_fy * model->inverse_body_mass +
                      inputs->body.external_fy * d_model->inverse_body_mass,
        };
        return result;
    }
    const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
    const flight_coefficients result = {
        .inverse_reduced_mass = d_model->inverse_reduced_mass,
        .stiffness = d_model->parameters.leg.stiffness,
        .damping = d_model->parameters.leg.damping,
        .rest_length =
            (mode->thrusts ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                             ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                             : 0.0)
                           : d_length),
        .gain = d_model->parameters.hip.kp,
        .rate_gain = d_model->parameters.hip.kd,
        .target = d_model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle +
                  model->parameters.hip.liftoff_angle_factor * d_mode->liftoff_angle,
        .torque = d_inputs->hip.external_torque,
        .push_x = d_inputs->body.external_fx * model->inverse_body_mass +
                  inputs->body.external_fx * d_model->inverse_body_mass,
        .push_y = d_inputs->body.external_fy * model->inverse_body_mass +
                  inputs->body.external_fy * d_model->inverse_body_mass,
    };
    return result;
}

/* Leg, masses, m_f g, gravity less the push on the body, torque and friction, in the ground's axes.
 *
 * `sliding` is mu, signed as the foot's velocity; `excess` and `fading` tell how it falls with speed. */
static inline ground_coefficients tdmf_ground_coefficients_of(const tdmf_model *model,
                                                              const tdmf_ground_line *line,
                                                              const tdmf_hip_law *law, double rest_length,
                                                              tdmf_vector push, double sliding, double excess,
                                                              double fading) {
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double y = push.y - model->parameters.gravity;
    const ground_coefficients result = {
        .stiffness = model->parameters.leg.stiffness,
        .damping = model->parameters.leg.damping,
        .rest_length = rest_length,
        .inverse_body_mass = model->inverse_body_mass,
        .inverse_foot_mass = model->inverse_foot_mass,
        .foot_weight_x = weight * line->sine,
        .foot_weight_y = weight * line->cosine,
        .gravity_x = -(line->cosine * push.x + line->sine * y),
        .gravity_y = -(line->cosine * y - line->sine * push.x),
        .torque = law->torque,
        .torque_rate = law->torque_rate,
        .friction = sliding,
        .excess = excess,
        .fading = fading,
    };
    return result;
}

/* On the ground in a mode; `sign` is that of the foot's velocity, 0 where it does not slip. */
static inline ground_coefficients tdmf_ground_coefficients_in(const tdmf_model *model,
                                                              const tdmf_inputs *inputs,
                                                              const tdmf_mode *mode, double sign,
                                                              bool falls) {
    if (mode->contact == TDMF_CONTACT_GRAZE) {
        if (falls) {
            const double length = model->parameters.leg.free_length + inputs->leg.extension;
            const double weight = model->parameters.foot.mass * model->parameters.gravity;
            const double x = inputs->body.external_fx * model->inverse_body_mass;
            const double y = inputs->body.external_fy * model->inverse_body_mass;
            const ground_coefficients result = {
                .stiffness = model->parameters.leg.stiffness,
                .damping = model->parameters.leg.damping,
                .rest_length =
                    (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                                   ? model->parameters.leg.thrust + inputs->control.thrust
                                                   : 0.0)
                                   : length),
                .inverse_body_mass = model->inverse_body_mass,
                .inverse_foot_mass = model->inverse_foot_mass,
                .foot_weight_x = weight * mode->ground.sine,
                .foot_weight_y = weight * mode->ground.cosine,
                .gravity_x = -(mode->ground.cosine * x + mode->ground.sine * (y - model->parameters.gravity)),
                .gravity_y = -(mode->ground.cosine * (y - model->parameters.gravity) - mode->ground.sine * x),
                .torque = inputs->hip.external_torque,
                .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction
                                                                  : inputs->ground.friction),
                .excess = model->parameters.ground.static_friction_ratio - 1.0,
                .fading = -sign / model->parameters.ground.stribeck_velocity,
            };
            return result;
        }
        const double length = model->parameters.leg.free_length + inputs->leg.extension;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double x = inputs->body.external_fx * model->inverse_body_mass;
        const double y = inputs->body.external_fy * model->inverse_body_mass;
        const ground_coefficients result = {
            .stiffness = model->parameters.leg.stiffness,
            .damping = model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                               ? model->parameters.leg.thrust + inputs->control.thrust
                                               : 0.0)
                               : length),
            .inverse_body_mass = model->inverse_body_mass,
            .inverse_foot_mass = model->inverse_foot_mass,
            .foot_weight_x = weight * mode->ground.sine,
            .foot_weight_y = weight * mode->ground.cosine,
            .gravity_x = -(mode->ground.cosine * x + mode->ground.sine * (y - model->parameters.gravity)),
            .gravity_y = -(mode->ground.cosine * (y - model->parameters.gravity) - mode->ground.sine * x),
            .torque = inputs->hip.external_torque,
            .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction
                                                              : inputs->ground.friction),
        };
        return result;
    }
    if (falls) {
        const double length = model->parameters.leg.free_length + inputs->leg.extension;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double x = inputs->body.external_fx * model->inverse_body_mass;
        const double y = inputs->body.external_fy * model->inverse_body_mass;
        const double drive =
            (mode->mid_stance_pending ? model->parameters.hip.stance_torque + inputs->control.stance_torque
                                      : 0.0);
        const ground_coefficients result = {
            .stiffness = model->parameters.leg.stiffness,
            .damping = model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                               ? model->parameters.leg.thrust + inputs->control.thrust
                                               : 0.0)
                               : length),
            .inverse_body_mass = model->inverse_body_mass,
            .inverse_foot_mass = model->inverse_foot_mass,
            .foot_weight_x = weight * mode->ground.sine,
            .foot_weight_y = weight * mode->ground.cosine,
            .gravity_x = -(mode->ground.cosine * x + mode->ground.sine * (y - model->parameters.gravity)),
            .gravity_y = -(mode->ground.cosine * (y - model->parameters.gravity) - mode->ground.sine * x),
            .torque = inputs->hip.external_torque - drive,
            .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction
                                                              : inputs->ground.friction),
            .excess = model->parameters.ground.static_friction_ratio - 1.0,
            .fading = -sign / model->parameters.ground.stribeck_velocity,
        };
        return result;
    }
    const double length = model->parameters.leg.free_length + inputs->leg.extension;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const double drive =
        (mode->mid_stance_pending ? model->parameters.hip.stance_torque + inputs->control.stance_torque
                                  : 0.0);
    const ground_coefficients result = {
        .stiffness = model->parameters.leg.stiffness,
        .damping = model->parameters.leg.damping,
        .rest_length = (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                                      ? model->parameters.leg.thrust + inputs->control.thrust
                                                      : 0.0)
                                      : length),
        .inverse_body_mass = model->inverse_body_mass,
        .inverse_foot_mass = model->inverse_foot_mass,
        .foot_weight_x = weight * mode->ground.sine,
        .foot_weight_y = weight * mode->ground.cosine,
        .gravity_x = -(mode->ground.cosine * x + mode->ground.sine * (y - model->parameters.gravity)),
        .gravity_y = -(mode->ground.cosine * (y - model->parameters.gravity) - mode->ground.sine * x),
        .torque = inputs->hip.external_torque - drive,
        .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction
                                                          : inputs->ground.friction),
    };
    return result;
}

/* Its change. */
static inline ground_coefficients
tdmf_vary_ground_coefficients_in(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                 double sign, bool falls, const tdmf_model *d_model,
                                 const tdmf_inputs *d_inputs, const tdmf_mode *d_mode) {
    if (mode->contact == TDMF_CONTACT_GRAZE) {
        if (falls) {
            const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
            const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                                    model->parameters.foot.mass * d_model->parameters.gravity;
            const double weight = model->parameters.foot.mass * model->parameters.gravity;
            const double x = inputs->body.external_fx * model->inverse_body_mass;
            const double d_x = d_inputs->body.external_fx * model->inverse_body_mass +
                               inputs->body.external_fx * d_model->inverse_body_mass;
            const double y = inputs->body.external_fy * model->inverse_body_mass;
            const double d_y = d_inputs->body.external_fy * model->inverse_body_mass +
                               inputs->body.external_fy * d_model->inverse_body_mass;
            const double fading = -sign / model->parameters.ground.stribeck_velocity;
            const ground_coefficients result = {
                .stiffness = d_model->parameters.leg.stiffness,
                .damping = d_model->parameters.leg.damping,
                .rest_length =
                    (mode->thrusts
                         ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                           ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                           : 0.0)
                         : d_length),
                .inverse_body_mass = d_model->inverse_body_mass,
                .inverse_foot_mass = d_model->inverse_foot_mass,
                .foot_weight_x =
                    d_weight * mode->ground.sine + weight * (mode->ground.cosine * d_mode->ground.slope),
                .foot_weight_y =
                    d_weight * mode->ground.cosine + weight * -(mode->ground.sine * d_mode->ground.slope),
                .gravity_x = -(-(mode->ground.sine * d_mode->ground.slope) * x + mode->ground.cosine * d_x +
                               (mode->ground.cosine * d_mode->ground.slope * (y - model->parameters.gravity) +
                                mode->ground.sine * (d_y - d_model->parameters.gravity))),
                .gravity_y = -(-(mode->ground.sine * d_mode->ground.slope) * (y - model->parameters.gravity) +
                               mode->ground.cosine * (d_y - d_model->parameters.gravity) -
                               (mode->ground.cosine * d_mode->ground.slope * x + mode->ground.sine * d_x)),
                .torque = d_inputs->hip.external_torque,
                .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? d_model->parameters.ground.patch_friction
                                                                  : d_inputs->ground.friction),
                .excess = d_model->parameters.ground.static_friction_ratio,
                .fading = -(fading * d_model->parameters.ground.stribeck_velocity) /
                          model->parameters.ground.stribeck_velocity,
            };
            return result;
        }
        const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
        const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                                model->parameters.foot.mass * d_model->parameters.gravity;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double x = inputs->body.external_fx * model->inverse_body_mass;
        const double d_x = d_inputs->body.external_fx * model->inverse_body_mass +
                           inputs->body.external_fx * d_model->inverse_body_mass;
        const double y = inputs->body.external_fy * model->inverse_body_mass;
        const double d_y = d_inputs->body.external_fy * model->inverse_body_mass +
                           inputs->body.external_fy * d_model->inverse_body_mass;
        const ground_coefficients result = {
            .stiffness = d_model->parameters.leg.stiffness,
            .damping = d_model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                                 ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                                 : 0.0)
                               : d_length),
            .inverse_body_mass = d_model->inverse_body_mass,
            .inverse_foot_mass = d_model->inverse_foot_mass,
            .foot_weight_x =
                d_weight * mode->ground.sine + weight * (mode->ground.cosine * d_mode->ground.slope),
            .foot_weight_y =
                d_weight * mode->ground.cosine + weight * -(mode->ground.sine * d_mode->ground.slope),
            .gravity_x = -(-(mode->ground.sine * d_mode->ground.slope) * x + mode->ground.cosine * d_x +
                           (mode->ground.cosine * d_mode->ground.slope * (y - model->parameters.gravity) +
                            mode->ground.sine * (d_y - d_model->parameters.gravity))),
            .gravity_y = -(-(mode->ground.sine * d_mode->ground.slope) * (y - model->parameters.gravity) +
                           mode->ground.cosine * (d_y - d_model->parameters.gravity) -
                           (mode->ground.cosine * d_mode->ground.slope * x + mode->ground.sine * d_x)),
            .torque = d_inputs->hip.external_torque,
            .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? d_model->parameters.ground.patch_friction
                                                              : d_inputs->ground.friction),
        };
        return result;
    }
    if (falls) {
        const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
        const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                                model->parameters.foot.mass * d_model->parameters.gravity;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double x = inputs->body.external_fx * model->inverse_body_mass;
        const double d_x = d_inputs->body.external_fx * model->inverse_body_mass +
                           inputs->body.external_fx * d_model->inverse_body_mass;
        const double y = inputs->body.external_fy * model->inverse_body_mass;
        const double d_y = d_inputs->body.external_fy * model->inverse_body_mass +
                           inputs->body.external_fy * d_model->inverse_body_mass;
        const double d_drive = (mode->mid_stance_pending
                                    ? d_model->parameters.hip.stance_torque + d_inputs->control.stance_torque
                                    : 0.0);
        const double fading = -sign / model->parameters.ground.stribeck_velocity;
        const ground_coefficients result = {
            .stiffness = d_model->parameters.leg.stiffness,
            .damping = d_model->parameters.leg.damping,
            .rest_length =
                (mode->thrusts ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                                 ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                                 : 0.0)
                               : d_length),
            .inverse_body_mass = d_model->inverse_body_mass,
            .inverse_foot_mass = d_model->inverse_foot_mass,
            .foot_weight_x =
                d_weight * mode->ground.sine + weight * (mode->ground.cosine * d_mode->ground.slope),
            .foot_weight_y =
                d_weight * mode->ground.cosine + weight * -(mode->ground.sine * d_mode->ground.slope),
            .gravity_x = -(-(mode->ground.sine * d_mode->ground.slope) * x + mode->ground.cosine * d_x +
                           (mode->ground.cosine * d_mode->ground.slope * (y - model->parameters.gravity) +
                            mode->ground.sine * (d_y - d_model->parameters.gravity))),
            .gravity_y = -(-(mode->ground.sine * d_mode->ground.slope) * (y - model->parameters.gravity) +
                           mode->ground.cosine * (d_y - d_model->parameters.gravity) -
                           (mode->ground.cosine * d_mode->ground.slope * x + mode->ground.sine * d_x)),
            .torque = d_inputs->hip.external_torque - d_drive,
            .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? d_model->parameters.ground.patch_friction
                                                              : d_inputs->ground.friction),
            .excess = d_model->parameters.ground.static_friction_ratio,
            .fading = -(fading * d_model->parameters.ground.stribeck_velocity) /
                      model->parameters.ground.stribeck_velocity,
        };
        return result;
    }
    const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
    const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                            model->parameters.foot.mass * d_model->parameters.gravity;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double d_x = d_inputs->body.external_fx * model->inverse_body_mass +
                       inputs->body.external_fx * d_model->inverse_body_mass;
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const double d_y = d_inputs->body.external_fy * model->inverse_body_mass +
                       inputs->body.external_fy * d_model->inverse_body_mass;
    const double d_drive =
        (mode->mid_stance_pending ? d_model->parameters.hip.stance_torque + d_inputs->control.stance_torque
                                  : 0.0);
    const ground_coefficients result = {
        .stiffness = d_model->parameters.leg.stiffness,
        .damping = d_model->parameters.leg.damping,
        .rest_length =
            (mode->thrusts ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                             ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                             : 0.0)
                           : d_length),
        .inverse_body_mass = d_model->inverse_body_mass,
        .inverse_foot_mass = d_model->inverse_foot_mass,
        .foot_weight_x = d_weight * mode->ground.sine + weight * (mode->ground.cosine * d_mode->ground.slope),
        .foot_weight_y =
            d_weight * mode->ground.cosine + weight * -(mode->ground.sine * d_mode->ground.slope),
        .gravity_x = -(-(mode->ground.sine * d_mode->ground.slope) * x + mode->ground.cosine * d_x +
                       (mode->ground.cosine * d_mode->ground.slope * (y - model->parameters.gravity) +
                        mode->ground.sine * (d_y - d_model->parameters.gravity))),
        .gravity_y = -(-(mode->ground.sine * d_mode->ground.slope) * (y - model->parameters.gravity) +
                       mode->ground.cosine * (d_y - d_model->parameters.gravity) -
                       (mode->ground.cosine * d_mode->ground.slope * x + mode->ground.sine * d_x)),
        .torque = d_inputs->hip.external_torque - d_drive,
        .friction = sign * (mode->zone == TDMF_ZONE_PATCH ? d_model->parameters.ground.patch_friction
                                                          : d_inputs->ground.friction),
    };
    return result;
}

/* The law times a sign, as guards have it while it drifts: its target stays, its torque moves. */
static inline signed_law tdmf_signed_law(const tdmf_hip_law *law, double sign) {
    const signed_law result = {
        .gain = sign * law->gain,
        .rate_gain = sign * law->rate_gain,
        .target = law->target,
        .torque = sign * law->torque,
        .torque_rate = sign * (law->torque_rate + law->gain * law->target_rate),
    };
    return result;
}

/* The weights of f_n, of what drifts with it and of |f_t| in the room of a cone, by its largest width.
 *
 * Its friction, rho mu, drifts at a rate for a time. */
static inline friction_cone tdmf_friction_cone_of(double friction, double rate, double time) {
    const double last = friction + rate * time;
    const double largest = (friction >= last ? friction : last);
    const double widest = (1.0 >= largest ? 1.0 : largest);
    const friction_cone result = {
        .normal = friction / widest,
        .normal_rate = rate / widest,
        .tangential = 1.0 / widest,
    };
    return result;
}

#endif
