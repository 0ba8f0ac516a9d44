/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GUARD_LAWS_H
#define TDMF_DERIVED_GUARD_LAWS_H

#include "evaluation.h"
#include "friction_laws.h"

#include <math.h>

/* -d, the depth of the foot below a line that waits to be in force. */
static inline double tdmf_new_ground_guard(const tdmf_evaluation *at, const tdmf_ground_line *line) {
    return -(line->cosine * (at->state[TDMF_FOOT_Y] - line->height) - line->sine * at->state[TDMF_FOOT_X]);
}

/* d + r cos theta', the height of the body over the ground: a fall. */
static inline double tdmf_body_down_guard(const tdmf_evaluation *at) {
    const double foot = at->mode->ground.cosine * (at->state[TDMF_FOOT_Y] - at->mode->ground.height) -
                        at->mode->ground.sine * at->state[TDMF_FOOT_X];
    return (foot + at->leg.length * at->leg.ground_cosine) / at->model->scales.length + TDMF_GUARD_MARGIN;
}

/* r less the least length: a fall. */
static inline double tdmf_leg_too_short_guard(const tdmf_evaluation *at) {
    return (at->leg.length - at->model->parameters.leg.min_length) / at->model->scales.length +
           TDMF_GUARD_MARGIN;
}

/* vy_c, at which the centre of mass rises; where it does not rise yet, -vy_c. */
static inline double tdmf_apex_guard(const tdmf_evaluation *at) {
    if (at->mode->rises) {
        const double across = at->state[TDMF_LEG_LENGTH] * at->state[TDMF_LEG_ANGLE_RATE];
        const double vy = at->state[TDMF_LEG_LENGTH_RATE] * at->leg.cosine - across * at->leg.sine;
        const double rate = at->state[TDMF_FOOT_VY] + at->model->body_share * vy;
        return rate / at->model->scales.speed + TDMF_APEX_MARGIN;
    }
    const double across = at->state[TDMF_LEG_LENGTH] * at->state[TDMF_LEG_ANGLE_RATE];
    const double vy = at->state[TDMF_LEG_LENGTH_RATE] * at->leg.cosine - across * at->leg.sine;
    const double rate = at->state[TDMF_FOOT_VY] + at->model->body_share * vy;
    return -rate / at->model->scales.speed + TDMF_DEAD_BAND;
}

/* d, the height of the foot over the ground. */
static inline double tdmf_touchdown_guard(const tdmf_evaluation *at) {
    return (at->mode->ground.cosine * (at->state[TDMF_FOOT_Y] - at->mode->ground.height) -
            at->mode->ground.sine * at->state[TDMF_FOOT_X] + tdmf_rounding_at_foot(at)) /
               at->model->scales.length +
           TDMF_GUARD_MARGIN;
}

/* The servo's torque, which closes the clamp of (12) by falling through 0, and opens it by rising. */
static inline double tdmf_clamp_guard(const tdmf_evaluation *at) {
    if (at->model->parameters.hip.swing_clamp) {
        if (at->mode->clamp_closed) {
            const double target = at->model->parameters.hip.liftoff_angle_factor * at->mode->liftoff_angle;
            const double servo = at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
                                 at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE];
            return -servo / at->model->scales.energy + TDMF_DEAD_BAND;
        }
        const double target = at->model->parameters.hip.liftoff_angle_factor * at->mode->liftoff_angle;
        const double servo = at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
                             at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE];
        return servo / at->model->scales.energy + TDMF_DEAD_BAND;
    }
    return 1.0;
}

/* -rdot, of a leg that has not been compressed most in this stance. */
static inline double tdmf_greatest_compression_guard(const tdmf_evaluation *at) {
    if (at->mode->thrusts) {
        return 1.0;
    }
    return -at->leg.length_rate / at->model->scales.speed + TDMF_GUARD_MARGIN;
}

/* theta: the leg falls through the vertical. */
static inline double tdmf_mid_stance_guard(const tdmf_evaluation *at) {
    if (at->mode->mid_stance_pending) {
        return at->state[TDMF_LEG_ANGLE] + TDMF_GUARD_MARGIN;
    }
    return 1.0;
}

/* f_n, the ground's normal force (10). */
static inline double tdmf_lift_off_guard(const tdmf_evaluation *at) {
    return at->force.normal / at->model->scales.force + TDMF_GUARD_MARGIN;
}

/* rho mu f_n + f_t: a foot at rest that reaches the edge of the cone (2) here slips forward. */
static inline double tdmf_slip_onset_positive_guard(const tdmf_evaluation *at) {
    const double largest = at->model->parameters.ground.static_friction_ratio *
                           (tdmf_zone_towards(at->model, at->state[TDMF_FOOT_X], 1.0) == TDMF_ZONE_PATCH
                                ? at->model->parameters.ground.patch_friction
                                : at->inputs->ground.friction);
    return (largest * at->force.normal + at->force.tangential) /
               (at->model->scales.force * (1.0 >= largest ? 1.0 : largest)) +
           TDMF_GUARD_MARGIN;
}

/* rho mu f_n - f_t: the same, and the foot slips backward. */
static inline double tdmf_slip_onset_negative_guard(const tdmf_evaluation *at) {
    const double largest = at->model->parameters.ground.static_friction_ratio *
                           (tdmf_zone_towards(at->model, at->state[TDMF_FOOT_X], -1.0) == TDMF_ZONE_PATCH
                                ? at->model->parameters.ground.patch_friction
                                : at->inputs->ground.friction);
    return (largest * at->force.normal - at->force.tangential) /
               (at->model->scales.force * (1.0 >= largest ? 1.0 : largest)) +
           TDMF_GUARD_MARGIN;
}

/* sgn(v_t) v_t, the speed of a foot that slips. */
static inline double tdmf_slip_velocity_zero_guard(const tdmf_evaluation *at) {
    return tdmf_sign_of_slip(at->mode) *
               (at->mode->ground.cosine * at->state[TDMF_FOOT_VX] +
                at->mode->ground.sine * at->state[TDMF_FOOT_VY]) /
               at->model->scales.speed +
           TDMF_GUARD_MARGIN;
}

/* How far the foot is from the border of the patch that it slips to, in x. */
static inline double tdmf_patch_border_guard(const tdmf_evaluation *at, bool forward) {
    if (forward) {
        if (at->mode->zone == TDMF_ZONE_BEFORE) {
            return at->model->parameters.ground.patch_begin - at->state[TDMF_FOOT_X];
        }
        return at->model->parameters.ground.patch_end - at->state[TDMF_FOOT_X];
    }
    if (at->mode->zone == TDMF_ZONE_PATCH) {
        return at->state[TDMF_FOOT_X] - at->model->parameters.ground.patch_begin;
    }
    return at->state[TDMF_FOOT_X] - at->model->parameters.ground.patch_end;
}

/* -N of the stance law: it loads the foot again. */
static inline double tdmf_graze_to_contact_guard(const tdmf_evaluation *at) {
    const double drive = (at->mode->mid_stance_pending
                              ? at->model->parameters.hip.stance_torque + at->inputs->control.stance_torque
                              : 0.0);
    const double torque = at->inputs->hip.external_torque - drive;
    const double across = torque * at->leg.inverse_length;
    const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double normal = off + weight * at->mode->ground.cosine;
    return -normal / at->model->scales.force + TDMF_GUARD_MARGIN;
}

/* N of the flight law: it lifts the foot. */
static inline double tdmf_graze_to_flight_guard(const tdmf_evaluation *at) {
    if (at->mode->phase == TDMF_PHASE_PLACE) {
        const double target = at->model->parameters.hip.touchdown_angle +
                              at->inputs->control.touchdown_angle -
                              at->model->parameters.hip.retraction_rate * at->state[TDMF_HIP_PLACE_TIME];
        const double torque = -at->model->parameters.hip.kd * at->model->parameters.hip.retraction_rate;
        const double servo = at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
                             at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE] + torque;
        const double across = (servo + at->inputs->hip.external_torque) * at->leg.inverse_length;
        const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
        const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
        const double normal = off + weight * at->mode->ground.cosine;
        return normal / at->model->scales.force + TDMF_GUARD_MARGIN;
    }
    const double target = at->model->parameters.hip.liftoff_angle_factor * at->mode->liftoff_angle;
    const double servo = at->model->parameters.hip.kp * (target - at->state[TDMF_LEG_ANGLE]) -
                         at->model->parameters.hip.kd * at->state[TDMF_LEG_ANGLE_RATE];
    const double swing = (at->model->parameters.hip.swing_clamp ? (servo >= 0.0 ? servo : 0.0) : servo);
    const double across = (swing + at->inputs->hip.external_torque) * at->leg.inverse_length;
    const double off = at->leg.axial_force * at->leg.ground_cosine + across * -at->leg.ground_sine;
    const double weight = at->model->parameters.foot.mass * at->model->parameters.gravity;
    const double normal = off + weight * at->mode->ground.cosine;
    return normal / at->model->scales.force + TDMF_GUARD_MARGIN;
}

#endif
