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
static inline tdmf_ground_force tdmf_force_in(const tdmf_model *model, double friction,
                                              const tdmf_ground_line *line,
                                              const double state[TDMF_STATE_COUNT], const tdmf_leg *leg,
                                              double torque, tdmf_contact_mode contact, double sign,
                                              bool falls) {
    if (contact == TDMF_CONTACT_FLIGHT) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (contact == TDMF_CONTACT_GRAZE) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (contact == TDMF_CONTACT_STICK) {
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
    if (falls) {
        const double exponent = -sign / model->parameters.ground.stribeck_velocity *
                                (line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY]);
        const double decay = exp(exponent);
        const double share = 1.0 + (model->parameters.ground.static_friction_ratio - 1.0) * decay;
        const double sliding = sign * friction * share;
        const double across = torque * leg->inverse_length;
        const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double normal = off + weight * line->cosine;
        const tdmf_ground_force result = {
            .tangential = -(sliding * normal),
            .normal = normal,
        };
        return result;
    }
    const double sliding = sign * friction;
    const double across = torque * leg->inverse_length;
    const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double normal = off + weight * line->cosine;
    const tdmf_ground_force result = {
        .tangential = -(sliding * normal),
        .normal = normal,
    };
    return result;
}

/* Its change. */
static inline tdmf_ground_force
tdmf_vary_force_in(const tdmf_model *model, double friction, const tdmf_ground_line *line,
                   const double state[TDMF_STATE_COUNT], const tdmf_leg *leg, double torque,
                   tdmf_contact_mode contact, double sign, bool falls, const tdmf_model *d_model,
                   double d_friction, const tdmf_ground_line *d_line, const double d_state[TDMF_STATE_COUNT],
                   const tdmf_leg *d_leg, double d_torque) {
    if (contact == TDMF_CONTACT_FLIGHT) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (contact == TDMF_CONTACT_GRAZE) {
        const tdmf_ground_force result = {
            .tangential = 0.0,
            .normal = 0.0,
        };
        return result;
    }
    if (contact == TDMF_CONTACT_STICK) {
        const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
        const double across = torque * leg->inverse_length;
        const double d_along = d_leg->axial_force * -leg->ground_sine +
                               leg->axial_force * -d_leg->ground_sine -
                               (d_across * leg->ground_cosine + across * d_leg->ground_cosine);
        const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                                model->parameters.foot.mass * d_model->parameters.gravity;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double d_off = d_leg->axial_force * leg->ground_cosine +
                             leg->axial_force * d_leg->ground_cosine +
                             (d_across * -leg->ground_sine + across * -d_leg->ground_sine);
        const tdmf_ground_force result = {
            .tangential = d_along + (d_weight * line->sine + weight * (line->cosine * d_line->slope)),
            .normal = d_off + (d_weight * line->cosine + weight * -(line->sine * d_line->slope)),
        };
        return result;
    }
    if (falls) {
        const double exponent = -sign / model->parameters.ground.stribeck_velocity *
                                (line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY]);
        const double decay = exp(exponent);
        const double share = 1.0 + (model->parameters.ground.static_friction_ratio - 1.0) * decay;
        const double d_exponent =
            -(-sign / model->parameters.ground.stribeck_velocity *
              d_model->parameters.ground.stribeck_velocity) /
                model->parameters.ground.stribeck_velocity *
                (line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY]) +
            -sign / model->parameters.ground.stribeck_velocity *
                (-(line->sine * d_line->slope) * state[TDMF_FOOT_VX] + line->cosine * d_state[TDMF_FOOT_VX] +
                 (line->cosine * d_line->slope * state[TDMF_FOOT_VY] + line->sine * d_state[TDMF_FOOT_VY]));
        const double d_decay = decay * d_exponent;
        const double d_share = d_model->parameters.ground.static_friction_ratio * decay +
                               (model->parameters.ground.static_friction_ratio - 1.0) * d_decay;
        const double d_sliding = sign * d_friction * share + sign * friction * d_share;
        const double across = torque * leg->inverse_length;
        const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double normal = off + weight * line->cosine;
        const double sliding = sign * friction * share;
        const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
        const double d_off = d_leg->axial_force * leg->ground_cosine +
                             leg->axial_force * d_leg->ground_cosine +
                             (d_across * -leg->ground_sine + across * -d_leg->ground_sine);
        const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                                model->parameters.foot.mass * d_model->parameters.gravity;
        const double d_normal = d_off + (d_weight * line->cosine + weight * -(line->sine * d_line->slope));
        const tdmf_ground_force result = {
            .tangential = -(d_sliding * normal + sliding * d_normal),
            .normal = d_normal,
        };
        return result;
    }
    const double d_sliding = sign * d_friction;
    const double across = torque * leg->inverse_length;
    const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double normal = off + weight * line->cosine;
    const double sliding = sign * friction;
    const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
    const double d_off = d_leg->axial_force * leg->ground_cosine + leg->axial_force * d_leg->ground_cosine +
                         (d_across * -leg->ground_sine + across * -d_leg->ground_sine);
    const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                            model->parameters.foot.mass * d_model->parameters.gravity;
    const double d_normal = d_off + (d_weight * line->cosine + weight * -(line->sine * d_line->slope));
    const tdmf_ground_force result = {
        .tangential = -(d_sliding * normal + sliding * d_normal),
        .normal = d_normal,
    };
    return result;
}

#endif
