/* Derived from c_core/equations/ground_force.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GROUND_FORCE_LAWS_H
#define TDMF_DERIVED_GROUND_FORCE_LAWS_H

#include "quantities.h"

#include <math.h>

/* What would hold the foot still under a torque, whatever the mode (10). */
static inline tdmf_ground_force tdmf_force_under(const tdmf_model *model, const tdmf_ground_line *line,
                                                 const tdmf_leg *leg, double torque) {
    const double across = torque * leg->inverse_length;
    const double along = leg->axial_force * -leg->ground_sine - across * leg->ground_cosine;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
    const tdmf_ground_force result = {
        .tangential = along + weight * line->sine,
        .normal = off + weight * line->cosine,
    };
    return result;
}

/* The force in the mode: (10) in stick, f_t = -mu sgn(v_t) f_n in slip, else none.
 *
 * `friction` is mu below the foot, `falls` whether it falls with speed. */
static inline tdmf_ground_force tdmf_force_in(const tdmf_evaluation *at, double sign, bool falls) {
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (at->mode->contact == TDMF_CONTACT_GRAZE) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (at->mode->contact == TDMF_CONTACT_STICK) {
        const double across = at->torque * at->leg.inverse_length;
        const double along = at->leg.axial_force * -at->leg.ground_sine - across * at->leg.ground_cosine;
        const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
        const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
        const tdmf_ground_force result = {
            .tangential = along + weight * at->mode->ground.sine,
            .normal = off + weight * at->mode->ground.cosine,
        };
        return result;
    }
    if (falls) {
        const double exponent = -sign / at->model->parameters.ground.stribeck_velocity *
                                (at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                                 at->mode->ground.sine * at->state[TDMF_FOOT_VY]);
        const double decay = exp(exponent);
        const double share = 1.0 + (at->model->parameters.ground.static_friction_ratio - 1.0) * decay;
        const double sliding =
            sign *
            (at->mode->zone == TDMF_ZONE_PATCH ? at->model->parameters.ground.patch_friction
                                               : at->inputs->ground.friction) *
            share;
        const double across = at->torque * at->leg.inverse_length;
        const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
        const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
        const double normal = off + weight * at->mode->ground.cosine;
        const tdmf_ground_force result = {
            .tangential = -(sliding * normal),
            .normal = normal,
        };
        return result;
    }
    const double sliding =
        sign * (at->mode->zone == TDMF_ZONE_PATCH ? at->model->parameters.ground.patch_friction
                                                  : at->inputs->ground.friction);
    const double across = at->torque * at->leg.inverse_length;
    const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double normal = off + weight * at->mode->ground.cosine;
    const tdmf_ground_force result = {
        .tangential = -(sliding * normal),
        .normal = normal,
    };
    return result;
}

/* Its change. */
static inline tdmf_ground_force tdmf_vary_force_in(const tdmf_evaluation *at, double sign, bool falls,
                                                   const tdmf_evaluation *d_at) {
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (at->mode->contact == TDMF_CONTACT_GRAZE) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (at->mode->contact == TDMF_CONTACT_STICK) {
        const double d_across = d_at->torque * at->leg.inverse_length + at->torque * d_at->leg.inverse_length;
        const double across = at->torque * at->leg.inverse_length;
        const double d_along = d_at->leg.axial_force * -at->leg.ground_sine +
                               at->leg.axial_force * -d_at->leg.ground_sine -
                               (d_across * at->leg.ground_cosine + across * d_at->leg.ground_cosine);
        const double d_weight = d_at->model->parameters.foot.mass * at->model->parameters.gravity +
                                at->model->parameters.foot.mass * d_at->model->parameters.gravity;
        const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
        const double d_off = d_at->leg.axial_force * at->leg.ground_cosine +
                             at->leg.axial_force * d_at->leg.ground_cosine +
                             (d_across * -at->leg.ground_sine + across * -d_at->leg.ground_sine);
        const tdmf_ground_force result = {
            .tangential = d_along + (d_weight * at->mode->ground.sine +
                                     weight * (at->mode->ground.cosine * d_at->mode->ground.slope)),
            .normal = d_off + (d_weight * at->mode->ground.cosine +
                               weight * -(at->mode->ground.sine * d_at->mode->ground.slope)),
        };
        return result;
    }
    if (falls) {
        const double exponent = -sign / at->model->parameters.ground.stribeck_velocity *
                                (at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                                 at->mode->ground.sine * at->state[TDMF_FOOT_VY]);
        const double decay = exp(exponent);
        const double share = 1.0 + (at->model->parameters.ground.static_friction_ratio - 1.0) * decay;
        const double d_exponent =
            -(-sign / at->model->parameters.ground.stribeck_velocity *
              d_at->model->parameters.ground.stribeck_velocity) /
                at->model->parameters.ground.stribeck_velocity *
                (at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                 at->mode->ground.sine * at->state[TDMF_FOOT_VY]) +
            -sign / at->model->parameters.ground.stribeck_velocity *
                (-(at->mode->ground.sine * d_at->mode->ground.slope) * at->state[TDMF_FOOT_VX] +
                 at->mode->ground.cosine * d_at->state[TDMF_FOOT_VX] +
                 (at->mode->ground.cosine * d_at->mode->ground.slope * at->state[TDMF_FOOT_VY] +
                  at->mode->ground.sine * d_at->state[TDMF_FOOT_VY]));
        const double d_decay = decay * d_exponent;
        const double d_share = d_at->model->parameters.ground.static_friction_ratio * decay +
                               (at->model->parameters.ground.static_friction_ratio - 1.0) * d_decay;
        const double d_sliding =
            sign *
                (at->mode->zone == TDMF_ZONE_PATCH ? d_at->model->parameters.ground.patch_friction
                                                   : d_at->inputs->ground.friction) *
                share +
            sign *
                (at->mode->zone == TDMF_ZONE_PATCH ? at->model->parameters.ground.patch_friction
                                                   : at->inputs->ground.friction) *
                d_share;
        const double across = at->torque * at->leg.inverse_length;
        const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
        const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
        const double normal = off + weight * at->mode->ground.cosine;
        const double sliding =
            sign *
            (at->mode->zone == TDMF_ZONE_PATCH ? at->model->parameters.ground.patch_friction
                                               : at->inputs->ground.friction) *
            share;
        const double d_across = d_at->torque * at->leg.inverse_length + at->torque * d_at->leg.inverse_length;
        const double d_off = d_at->leg.axial_force * at->leg.ground_cosine +
                             at->leg.axial_force * d_at->leg.ground_cosine +
                             (d_across * -at->leg.ground_sine + across * -d_at->leg.ground_sine);
        const double d_weight = d_at->model->parameters.foot.mass * at->model->parameters.gravity +
                                at->model->parameters.foot.mass * d_at->model->parameters.gravity;
        const double d_normal = d_off + (d_weight * at->mode->ground.cosine +
                                         weight * -(at->mode->ground.sine * d_at->mode->ground.slope));
        const tdmf_ground_force result = {
            .tangential = -(d_sliding * normal + sliding * d_normal),
            .normal = d_normal,
        };
        return result;
    }
    const double d_sliding =
        sign * (at->mode->zone == TDMF_ZONE_PATCH ? d_at->model->parameters.ground.patch_friction
                                                  : d_at->inputs->ground.friction);
    const double across = at->torque * at->leg.inverse_length;
    const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double normal = off + weight * at->mode->ground.cosine;
    const double sliding =
        sign * (at->mode->zone == TDMF_ZONE_PATCH ? at->model->parameters.ground.patch_friction
                                                  : at->inputs->ground.friction);
    const double d_across = d_at->torque * at->leg.inverse_length + at->torque * d_at->leg.inverse_length;
    const double d_off = d_at->leg.axial_force * at->leg.ground_cosine +
                         at->leg.axial_force * d_at->leg.ground_cosine +
                         (d_across * -at->leg.ground_sine + across * -d_at->leg.ground_sine);
    const double d_weight = d_at->model->parameters.foot.mass * at->model->parameters.gravity +
                            at->model->parameters.foot.mass * d_at->model->parameters.gravity;
    const double d_normal = d_off + (d_weight * at->mode->ground.cosine +
                                     weight * -(at->mode->ground.sine * d_at->mode->ground.slope));
    const tdmf_ground_force result = {
        .tangential = -(d_sliding * normal + sliding * d_normal),
        .normal = d_normal,
    };
    return result;
}

#endif
