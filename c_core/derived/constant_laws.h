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

/* Its change. */
static inline flight_coefficients
tdmf_vary_flight_coefficients_of(const tdmf_model *model, const tdmf_hip_law *law, double rest_length,
                                 tdmf_vector push, const tdmf_model *d_model, const tdmf_hip_law *d_law,
                                 double d_rest_length, tdmf_vector d_push) {
    (void)model;
    (void)rest_length;
    (void)push;
    const flight_coefficients result = {
        .inverse_reduced_mass = d_model->inverse_reduced_mass,
        .stiffness = d_model->parameters.leg.stiffness,
        .damping = d_model->parameters.leg.damping,
        .rest_length = d_rest_length,
        .gain = d_law->gain,
        .rate_gain = d_law->rate_gain,
        .target = d_law->target,
        .torque = d_law->torque,
        .torque_rate = d_law->torque_rate + (d_law->gain * law->target_rate + law->gain * d_law->target_rate),
        .push_x = d_push.x,
        .push_y = d_push.y,
    };
    return result;
}

/* Leg, masses, m_f g, gravity less the push on the body, torque and friction, in the ground's axes.
 *
 * `friction` has the sign of the foot's velocity; `excess` and `fading` tell how it falls with speed. */
static inline ground_coefficients tdmf_ground_coefficients_of(const tdmf_model *model,
                                                              const tdmf_ground_line *line,
                                                              const tdmf_hip_law *law, double rest_length,
                                                              tdmf_vector push, double friction,
                                                              double excess, double fading) {
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
        .friction = friction,
        .excess = excess,
        .fading = fading,
    };
    return result;
}

/* Its change. */
static inline ground_coefficients tdmf_vary_ground_coefficients_of(
    const tdmf_model *model, const tdmf_ground_line *line, const tdmf_hip_law *law, double rest_length,
    tdmf_vector push, double friction, double excess, double fading, const tdmf_model *d_model,
    const tdmf_ground_line *d_line, const tdmf_hip_law *d_law, double d_rest_length, tdmf_vector d_push,
    double d_friction, double d_excess, double d_fading) {
    (void)law;
    (void)rest_length;
    (void)friction;
    (void)excess;
    (void)fading;
    const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                            model->parameters.foot.mass * d_model->parameters.gravity;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double y = push.y - model->parameters.gravity;
    const double d_y = d_push.y - d_model->parameters.gravity;
    const ground_coefficients result = {
        .stiffness = d_model->parameters.leg.stiffness,
        .damping = d_model->parameters.leg.damping,
        .rest_length = d_rest_length,
        .inverse_body_mass = d_model->inverse_body_mass,
        .inverse_foot_mass = d_model->inverse_foot_mass,
        .foot_weight_x = d_weight * line->sine + weight * (line->cosine * d_line->slope),
        .foot_weight_y = d_weight * line->cosine + weight * -(line->sine * d_line->slope),
        .gravity_x = -(-(line->sine * d_line->slope) * push.x + line->cosine * d_push.x +
                       (line->cosine * d_line->slope * y + line->sine * d_y)),
        .gravity_y = -(-(line->sine * d_line->slope) * y + line->cosine * d_y -
                       (line->cosine * d_line->slope * push.x + line->sine * d_push.x)),
        .torque = d_law->torque,
        .torque_rate = d_law->torque_rate,
        .friction = d_friction,
        .excess = d_excess,
        .fading = d_fading,
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
