/* Derived from c_core/equations/hip.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_HIP_LAWS_H
#define TDMF_DERIVED_HIP_LAWS_H

#include "quantities.h"

#include <math.h>

/* The torque of the servo alone; with swing_clamp its sign decides the clamp of (12). */
static inline double tdmf_servo_torque(const tdmf_model *model, const tdmf_inputs *inputs,
                                       const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    if (mode->phase == TDMF_PHASE_PLACE) {
        const double target = model->parameters.hip.touchdown_angle + inputs->control.touchdown_angle -
                              model->parameters.hip.retraction_rate * state[TDMF_HIP_PLACE_TIME];
        const double torque = -model->parameters.hip.kd * model->parameters.hip.retraction_rate;
        return model->parameters.hip.kp * (target - state[TDMF_LEG_ANGLE]) -
               model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE] + torque;
    }
    const double target = model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle;
    return model->parameters.hip.kp * (target - state[TDMF_LEG_ANGLE]) -
           model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE];
}

/* The total torque: of flight or stance, and in graze what keeps the foot at the ground. */
static inline double tdmf_torque_in(const tdmf_evaluation *at, bool upright, double sine) {
    if (at->mode->contact == TDMF_CONTACT_GRAZE) {
        if (upright) {
            const double load =
                at->leg.axial_force * at->leg.ground_cosine +
                at->model->parameters.foot.mass * at->model->parameters.gravity * at->mode->ground.cosine;
            return load / (sine * at->leg.inverse_length);
        }
        const double load = at->leg.axial_force * at->leg.ground_cosine + at->model->parameters.foot.mass *
                                                                              at->model->parameters.gravity *
                                                                              at->mode->ground.cosine;
        return load / (at->leg.ground_sine * at->leg.inverse_length);
    }
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        if (at->mode->phase == TDMF_PHASE_PLACE) {
            const double target = at->model->parameters.hip.touchdown_angle +
                                  at->inputs->control.touchdown_angle -
                                  at->model->parameters.hip.retraction_rate * at->state[TDMF_HIP_PLACE_TIME];
            const double torque = -at->model->parameters.hip.kd * at->model->parameters.hip.retraction_rate;
            return at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
                   at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE] +
                   (torque + at->inputs->hip.external_torque);
        }
        if (at->mode->clamp_closed) {
            return at->inputs->hip.external_torque;
        }
        const double target = at->model->parameters.hip.liftoff_angle_factor * at->mode->liftoff_angle;
        return at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
               at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE] +
               at->inputs->hip.external_torque;
    }
    const double drive = (at->mode->mid_stance_pending
                              ? at->model->parameters.hip.stance_torque + at->inputs->control.stance_torque
                              : 0.0);
    return at->inputs->hip.external_torque - drive;
}

/* Its change. */
static inline double tdmf_vary_torque_in(const tdmf_evaluation *at, bool upright, double sine, double torque,
                                         const tdmf_evaluation *d_at) {
    if (at->mode->contact == TDMF_CONTACT_GRAZE) {
        if (upright) {
            const double d_load = d_at->leg.axial_force * at->leg.ground_cosine +
                                  at->leg.axial_force * d_at->leg.ground_cosine +
                                  ((d_at->model->parameters.foot.mass * at->model->parameters.gravity +
                                    at->model->parameters.foot.mass * d_at->model->parameters.gravity) *
                                       at->mode->ground.cosine +
                                   at->model->parameters.foot.mass * at->model->parameters.gravity *
                                       -(at->mode->ground.sine * d_at->mode->ground.slope));
            return (d_load - torque * (sine * d_at->leg.inverse_length)) / (sine * at->leg.inverse_length);
        }
        const double d_load = d_at->leg.axial_force * at->leg.ground_cosine +
                              at->leg.axial_force * d_at->leg.ground_cosine +
                              ((d_at->model->parameters.foot.mass * at->model->parameters.gravity +
                                at->model->parameters.foot.mass * d_at->model->parameters.gravity) *
                                   at->mode->ground.cosine +
                               at->model->parameters.foot.mass * at->model->parameters.gravity *
                                   -(at->mode->ground.sine * d_at->mode->ground.slope));
        return (d_load - torque * (d_at->leg.ground_sine * at->leg.inverse_length +
                                   at->leg.ground_sine * d_at->leg.inverse_length)) /
               (at->leg.ground_sine * at->leg.inverse_length);
    }
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        if (at->mode->phase == TDMF_PHASE_PLACE) {
            const double target = at->model->parameters.hip.touchdown_angle +
                                  at->inputs->control.touchdown_angle -
                                  at->model->parameters.hip.retraction_rate * at->state[TDMF_HIP_PLACE_TIME];
            const double d_target =
                d_at->model->parameters.hip.touchdown_angle + d_at->inputs->control.touchdown_angle -
                (d_at->model->parameters.hip.retraction_rate * at->state[TDMF_HIP_PLACE_TIME] +
                 at->model->parameters.hip.retraction_rate * d_at->state[TDMF_HIP_PLACE_TIME]);
            const double d_torque =
                -d_at->model->parameters.hip.kd * at->model->parameters.hip.retraction_rate +
                -at->model->parameters.hip.kd * d_at->model->parameters.hip.retraction_rate;
            return d_at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) +
                   at->model->parameters.hip.kp * (d_target - d_at->state[TDMF_LEG_ANGLE]) -
                   (d_at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE] +
                    at->model->parameters.hip.kd * d_at->state[TDMF_LEG_ANGLE_RATE]) +
                   (d_torque + d_at->inputs->hip.external_torque);
        }
        if (at->mode->clamp_closed) {
            return d_at->inputs->hip.external_torque;
        }
        const double target = at->model->parameters.hip.liftoff_angle_factor * at->mode->liftoff_angle;
        const double d_target = d_at->model->parameters.hip.liftoff_angle_factor * at->mode->liftoff_angle +
                                at->model->parameters.hip.liftoff_angle_factor * d_at->mode->liftoff_angle;
        return d_at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) +
               at->model->parameters.hip.kp * (d_target - d_at->state[TDMF_LEG_ANGLE]) -
               (d_at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE] +
                at->model->parameters.hip.kd * d_at->state[TDMF_LEG_ANGLE_RATE]) +
               d_at->inputs->hip.external_torque;
    }
    const double d_drive = (at->mode->mid_stance_pending ? d_at->model->parameters.hip.stance_torque +
                                                               d_at->inputs->control.stance_torque
                                                         : 0.0);
    return d_at->inputs->hip.external_torque - d_drive;
}

/* The clock of place runs while that lasts. */
static inline double tdmf_place_time_rate(const tdmf_mode *mode) {
    return (mode->phase == TDMF_PHASE_PLACE ? 1.0 : 0.0);
}

/* The clock of place stands at 0. */
static inline void tdmf_begin_place(double written[TDMF_STATE_COUNT]) {
    written[TDMF_HIP_PLACE_TIME] = 0.0;
}

/* In any other phase, too. */
static inline void tdmf_end_place(double written[TDMF_STATE_COUNT]) {
    written[TDMF_HIP_PLACE_TIME] = 0.0;
}

#endif
