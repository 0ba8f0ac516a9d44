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
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const tdmf_ground_force result = {
        .tangential = leg->axial_force * -leg->ground_sine -
                      inputs->hip.external_torque * leg->inverse_length * leg->ground_cosine +
                      weight * mode->ground.sine,
        .normal = leg->axial_force * leg->ground_cosine +
                  inputs->hip.external_torque * leg->inverse_length * -leg->ground_sine +
                  weight * mode->ground.cosine,
    };
    return result;
}

/* Its change. */
static inline tdmf_ground_force
tdmf_vary_force_in_stance(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                          const double state[TDMF_STATE_COUNT], const tdmf_leg *leg,
                          const tdmf_model *d_model, const tdmf_inputs *d_inputs, const tdmf_mode *d_mode,
                          const double d_state[TDMF_STATE_COUNT], const tdmf_leg *d_leg) {
    (void)state;
    (void)d_state;
    if (mode->mid_stance_pending) {
        const double d_drive = d_model->parameters.hip.stance_torque + d_inputs->control.stance_torque;
        const double d_torque = d_inputs->hip.external_torque - d_drive;
        const double drive = model->parameters.hip.stance_torque + inputs->control.stance_torque;
        const double torque = inputs->hip.external_torque - drive;
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
            .tangential = d_along + (d_weight * mode->ground.sine +
                                     weight * (mode->ground.cosine * d_mode->ground.slope)),
            .normal = d_off +
                      (d_weight * mode->ground.cosine + weight * (-mode->ground.sine * d_mode->ground.slope)),
        };
        return result;
    }
    const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                            model->parameters.foot.mass * d_model->parameters.gravity;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const tdmf_ground_force result = {
        .tangential = d_leg->axial_force * -leg->ground_sine + leg->axial_force * -d_leg->ground_sine -
                      ((d_inputs->hip.external_torque * leg->inverse_length +
                        inputs->hip.external_torque * d_leg->inverse_length) *
                           leg->ground_cosine +
                       inputs->hip.external_torque * leg->inverse_length * d_leg->ground_cosine) +
                      (d_weight * mode->ground.sine + weight * (mode->ground.cosine * d_mode->ground.slope)),
        .normal = d_leg->axial_force * leg->ground_cosine + leg->axial_force * d_leg->ground_cosine +
                  ((d_inputs->hip.external_torque * leg->inverse_length +
                    inputs->hip.external_torque * d_leg->inverse_length) *
                       -leg->ground_sine +
                   inputs->hip.external_torque * leg->inverse_length * -d_leg->ground_sine) +
                  (d_weight * mode->ground.cosine + weight * (-mode->ground.sine * d_mode->ground.slope)),
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
    const double clamped =
        ((model->parameters.hip.kp *
              (model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle - state[TDMF_LEG_ANGLE]) -
          model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE]) >= 0.0
             ? (model->parameters.hip.kp * (model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle -
                                            state[TDMF_LEG_ANGLE]) -
                model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE])
             : 0.0);
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const tdmf_ground_force result = {
        .tangential = leg->axial_force * -leg->ground_sine -
                      (clamped + inputs->hip.external_torque) * leg->inverse_length * leg->ground_cosine +
                      weight * mode->ground.sine,
        .normal = leg->axial_force * leg->ground_cosine +
                  (clamped + inputs->hip.external_torque) * leg->inverse_length * -leg->ground_sine +
                  weight * mode->ground.cosine,
    };
    return result;
}

/* Its change. */
static inline tdmf_ground_force
tdmf_vary_force_in_flight(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                          const double state[TDMF_STATE_COUNT], const tdmf_leg *leg,
                          const tdmf_model *d_model, const tdmf_inputs *d_inputs, const tdmf_mode *d_mode,
                          const double d_state[TDMF_STATE_COUNT], const tdmf_leg *d_leg) {
    if (mode->phase == TDMF_PHASE_PLACE) {
        const double target = model->parameters.hip.touchdown_angle + inputs->control.touchdown_angle -
                              model->parameters.hip.retraction_rate * state[TDMF_HIP_PLACE_TIME];
        const double d_target = d_model->parameters.hip.touchdown_angle + d_inputs->control.touchdown_angle -
                                (d_model->parameters.hip.retraction_rate * state[TDMF_HIP_PLACE_TIME] +
                                 model->parameters.hip.retraction_rate * d_state[TDMF_HIP_PLACE_TIME]);
        const double d_torque = -d_model->parameters.hip.kd * model->parameters.hip.retraction_rate +
                                -model->parameters.hip.kd * d_model->parameters.hip.retraction_rate;
        const double d_servo = d_model->parameters.hip.kp * (target - state[TDMF_LEG_ANGLE]) +
                               model->parameters.hip.kp * (d_target - d_state[TDMF_LEG_ANGLE]) -
                               (d_model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE] +
                                model->parameters.hip.kd * d_state[TDMF_LEG_ANGLE_RATE]) +
                               d_torque;
        const double torque = -model->parameters.hip.kd * model->parameters.hip.retraction_rate;
        const double servo = model->parameters.hip.kp * (target - state[TDMF_LEG_ANGLE]) -
                             model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE] + torque;
        const double d_across = (d_servo + d_inputs->hip.external_torque) * leg->inverse_length +
                                (servo + inputs->hip.external_torque) * d_leg->inverse_length;
        const double across = (servo + inputs->hip.external_torque) * leg->inverse_length;
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
            .tangential = d_along + (d_weight * mode->ground.sine +
                                     weight * (mode->ground.cosine * d_mode->ground.slope)),
            .normal = d_off +
                      (d_weight * mode->ground.cosine + weight * (-mode->ground.sine * d_mode->ground.slope)),
        };
        return result;
    }
    const double d_clamped =
        ((model->parameters.hip.kp *
              (model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle - state[TDMF_LEG_ANGLE]) -
          model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE]) >= 0.0
             ? (d_model->parameters.hip.kp *
                    (model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle -
                     state[TDMF_LEG_ANGLE]) +
                model->parameters.hip.kp *
                    (d_model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle +
                     model->parameters.hip.liftoff_angle_factor * d_mode->liftoff_angle -
                     d_state[TDMF_LEG_ANGLE]) -
                (d_model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE] +
                 model->parameters.hip.kd * d_state[TDMF_LEG_ANGLE_RATE]))
             : 0.0);
    const double clamped =
        ((model->parameters.hip.kp *
              (model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle - state[TDMF_LEG_ANGLE]) -
          model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE]) >= 0.0
             ? (model->parameters.hip.kp * (model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle -
                                            state[TDMF_LEG_ANGLE]) -
                model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE])
             : 0.0);
    const double d_weight = d_model->parameters.foot.mass * model->parameters.gravity +
                            model->parameters.foot.mass * d_model->parameters.gravity;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const tdmf_ground_force result = {
        .tangential = d_leg->axial_force * -leg->ground_sine + leg->axial_force * -d_leg->ground_sine -
                      (((d_clamped + d_inputs->hip.external_torque) * leg->inverse_length +
                        (clamped + inputs->hip.external_torque) * d_leg->inverse_length) *
                           leg->ground_cosine +
                       (clamped + inputs->hip.external_torque) * leg->inverse_length * d_leg->ground_cosine) +
                      (d_weight * mode->ground.sine + weight * (mode->ground.cosine * d_mode->ground.slope)),
        .normal = d_leg->axial_force * leg->ground_cosine + leg->axial_force * d_leg->ground_cosine +
                  (((d_clamped + d_inputs->hip.external_torque) * leg->inverse_length +
                    (clamped + inputs->hip.external_torque) * d_leg->inverse_length) *
                       -leg->ground_sine +
                   (clamped + inputs->hip.external_torque) * leg->inverse_length * -d_leg->ground_sine) +
                  (d_weight * mode->ground.cosine + weight * (-mode->ground.sine * d_mode->ground.slope)),
    };
    return result;
}

#endif
