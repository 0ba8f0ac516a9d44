/* Derived from c_core/equations/graze.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GRAZE_LAWS_H
#define TDMF_DERIVED_GRAZE_LAWS_H

#include "quantities.h"

#include <math.h>

/* N of the stance law, of a foot at rest on the ground that would stay there; with f_t of (10). */
static inline tdmf_ground_force tdmf_force_in_stance(const tdmf_evaluation *at) {
    const double drive = (at->mode->mid_stance_pending
                              ? at->model->parameters.hip.stance_torque + at->inputs->control.stance_torque
                              : 0.0);
    const double torque = at->inputs->hip.external_torque - drive;
    const double across = torque * at->leg.inverse_length;
    const double along = at->leg.axial_force * -at->leg.ground_sine - across * at->leg.ground_cosine;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
    const tdmf_ground_force result = {
        .tangential = along + weight * at->mode->ground.sine,
        .normal = off + weight * at->mode->ground.cosine,
    };
    return result;
}

/* N of the flight law, of a foot at rest on the ground that would stay there; with f_t of (10).
 *
 * No event locates the clamp of (12) for a foot on the ground: the servo's present sign decides it. */
static inline tdmf_ground_force tdmf_force_in_flight(const tdmf_evaluation *at) {
    if (at->mode->phase == TDMF_PHASE_PLACE) {
        const double target = at->model->parameters.hip.touchdown_angle +
                              at->inputs->control.touchdown_angle -
                              at->model->parameters.hip.retraction_rate * at->state[TDMF_HIP_PLACE_TIME];
        const double torque = -at->model->parameters.hip.kd * at->model->parameters.hip.retraction_rate;
        const double servo = at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
                             at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE] + torque;
        const double across = (servo + at->inputs->hip.external_torque) * at->leg.inverse_length;
        const double along = at->leg.axial_force * -at->leg.ground_sine - across * at->leg.ground_cosine;
        const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
        const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
        const tdmf_ground_force result = {
            .tangential = along + weight * at->mode->ground.sine,
            .normal = off + weight * at->mode->ground.cosine,
        };
        return result;
    }
    const double target = at->model->parameters.hip.liftoff_angle_factor * at->mode->liftoff_angle;
    const double servo = at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
                         at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE];
    const double swing = (at->model->parameters.hip.swing_clamp ? (servo >= 0.0 ? servo : 0.0) : servo);
    const double across = (swing + at->inputs->hip.external_torque) * at->leg.inverse_length;
    const double along = at->leg.axial_force * -at->leg.ground_sine - across * at->leg.ground_cosine;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
    const tdmf_ground_force result = {
        .tangential = along + weight * at->mode->ground.sine,
        .normal = off + weight * at->mode->ground.cosine,
    };
    return result;
}

#endif
