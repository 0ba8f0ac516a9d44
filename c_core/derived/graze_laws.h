/* Derived from c_core/equations/graze.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GRAZE_LAWS_H
#define TDMF_DERIVED_GRAZE_LAWS_H

#include "quantities.h"

#include <math.h>

/* N of the stance law, of a foot at rest on the ground that would stay there; with f_t of (10). */
static inline tdmf_ground_force tdmf_force_in_stance(const tdmf_model *model, const tdmf_inputs *inputs,
                                                     const tdmf_mode *mode,
                                                     const double state[TDMF_STATE_COUNT],
                                                     const tdmf_leg *leg) {
    (void)state;
    if (mode->mid_stance_pending) {
        const double drive = model->parameters.hip.stance_torque + inputs->control.stance_torque;
        const double torque = inputs->hip.external_torque - drive;
        const double across = torque * leg->inverse_length;
        const double along = leg->axial_force * -leg->ground_sine - across * leg->ground_cosine;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
        const tdmf_ground_force result = {
            .tangential = along + weight * mode->ground.sine,
            .normal = off + weight * mode->ground.cosine,
        };
        return result;
    }
    const double across = inputs->hip.external_torque * leg->inverse_length;
    const double along = leg->axial_force * -leg->ground_sine - across * leg->ground_cosine;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
    const tdmf_ground_force result = {
        .tangential = along + weight * mode->ground.sine,
        .normal = off + weight * mode->ground.cosine,
    };
    return result;
}

/* N of the flight law, of a foot at rest on the ground that would stay there; with f_t of (10).
 *
 * Nobody locates the clamp of (12) for a foot on the ground: it is where the servo has it now. */
static inline tdmf_ground_force tdmf_force_in_flight(const tdmf_model *model, const tdmf_inputs *inputs,
                                                     const tdmf_mode *mode,
                                                     const double state[TDMF_STATE_COUNT],
                                                     const tdmf_leg *leg) {
    if (mode->phase == TDMF_PHASE_PLACE) {
        const double target = model->parameters.hip.touchdown_angle + inputs->control.touchdown_angle -
                              model->parameters.hip.retraction_rate * state[TDMF_HIP_PLACE_TIME];
        const double torque = -model->parameters.hip.kd * model->parameters.hip.retraction_rate;
        const double servo = model->parameters.hip.kp * (target - state[TDMF_LEG_ANGLE]) -
                             model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE] + torque;
        const double across = (servo + inputs->hip.external_torque) * leg->inverse_length;
        const double along = leg->axial_force * -leg->ground_sine - across * leg->ground_cosine;
        const double weight = model->parameters.foot.mass * model->parameters.gravity;
        const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
        const tdmf_ground_force result = {
            .tangential = along + weight * mode->ground.sine,
            .normal = off + weight * mode->ground.cosine,
        };
        return result;
    }
    const double target = model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle;
    const double servo = model->parameters.hip.kp * (target - state[TDMF_LEG_ANGLE]) -
                         model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE];
    const double clamped = (servo >= 0.0 ? servo : 0.0);
    const double across = (clamped + inputs->hip.external_torque) * leg->inverse_length;
    const double along = leg->axial_force * -leg->ground_sine - across * leg->ground_cosine;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const double off = leg->axial_force * leg->ground_cosine + across * -leg->ground_sine;
    const tdmf_ground_force result = {
        .tangential = along + weight * mode->ground.sine,
        .normal = off + weight * mode->ground.cosine,
    };
    return result;
}

#endif
