/* Derived from c_core/equations/prescribed_flight.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_PRESCRIBED_FLIGHT_LAWS_H
#define TDMF_DERIVED_PRESCRIBED_FLIGHT_LAWS_H

#include "quantities.h"

#include <math.h>

/* The state some time after an apex, where the centre of mass began: leg, foot and clock of place. */
static inline void tdmf_prescribed_state(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_point start,
                                         double time, double written[TDMF_STATE_COUNT]) {
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double length = model->parameters.leg.free_length + inputs->leg.extension;
    const double target = model->parameters.hip.touchdown_angle + inputs->control.touchdown_angle -
                          model->parameters.hip.retraction_rate * time;
    const double sine = sin(target);
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const double cosine = cos(target);
    const double vx = start.vx + time * (model->body_share * x);
    const double target_rate = -model->parameters.hip.retraction_rate;
    const double across = length * target_rate;
    const double vy = start.vy + time * (model->body_share * y - model->parameters.gravity);
    written[TDMF_FOOT_X] = start.x + time * (start.vx + time * (0.5 * (model->body_share * x))) -
                           model->body_share * (-length * sine);
    written[TDMF_FOOT_Y] =
        start.y + time * (start.vy + time * (0.5 * (model->body_share * y - model->parameters.gravity))) -
        model->body_share * (length * cosine);
    written[TDMF_FOOT_VX] = vx - model->body_share * -(across * cosine);
    written[TDMF_FOOT_VY] = vy - model->body_share * -(across * sine);
    written[TDMF_LEG_LENGTH] = length;
    written[TDMF_LEG_ANGLE] = target;
    written[TDMF_LEG_LENGTH_RATE] = 0.0;
    written[TDMF_LEG_ANGLE_RATE] = target_rate;
    written[TDMF_HIP_PLACE_TIME] = time;
}

/* Its change. */
static inline void tdmf_vary_prescribed_state(const tdmf_model *model, const tdmf_inputs *inputs,
                                              tdmf_point start, double time, const tdmf_model *d_model,
                                              const tdmf_inputs *d_inputs, tdmf_point d_start, double d_time,
                                              double written[TDMF_STATE_COUNT]) {
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double d_x = d_inputs->body.external_fx * model->inverse_body_mass +
                       inputs->body.external_fx * d_model->inverse_body_mass;
    const double length = model->parameters.leg.free_length + inputs->leg.extension;
    const double target = model->parameters.hip.touchdown_angle + inputs->control.touchdown_angle -
                          model->parameters.hip.retraction_rate * time;
    const double sine = sin(target);
    const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
    const double cosine = cos(target);
    const double d_target =
        d_model->parameters.hip.touchdown_angle + d_inputs->control.touchdown_angle -
        (d_model->parameters.hip.retraction_rate * time + model->parameters.hip.retraction_rate * d_time);
    const double d_sine = cosine * d_target;
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const double d_y = d_inputs->body.external_fy * model->inverse_body_mass +
                       inputs->body.external_fy * d_model->inverse_body_mass;
    const double d_cosine = -(sine * d_target);
    const double d_vx = d_start.vx + (d_time * (model->body_share * x) +
                                      time * (d_model->body_share * x + model->body_share * d_x));
    const double target_rate = -model->parameters.hip.retraction_rate;
    const double across = length * target_rate;
    const double d_target_rate = -d_model->parameters.hip.retraction_rate;
    const double d_across = d_length * target_rate + length * d_target_rate;
    const double d_vy =
        d_start.vy +
        (d_time * (model->body_share * y - model->parameters.gravity) +
         time * (d_model->body_share * y + model->body_share * d_y - d_model->parameters.gravity));
    written[TDMF_FOOT_X] =
        d_start.x +
        (d_time * (start.vx + time * (0.5 * (model->body_share * x))) +
         time * (d_start.vx + (d_time * (0.5 * (model->body_share * x)) +
                               time * (0.5 * (d_model->body_share * x + model->body_share * d_x))))) -
        (d_model->body_share * (-length * sine) + model->body_share * (-d_length * sine + -length * d_sine));
    written[TDMF_FOOT_Y] =
        d_start.y +
        (d_time * (start.vy + time * (0.5 * (model->body_share * y - model->parameters.gravity))) +
         time * (d_start.vy + (d_time * (0.5 * (model->body_share * y - model->parameters.gravity)) +
                               time * (0.5 * (d_model->body_share * y + model->body_share * d_y -
                                              d_model->parameters.gravity))))) -
        (d_model->body_share * (length * cosine) +
         model->body_share * (d_length * cosine + length * d_cosine));
    written[TDMF_FOOT_VX] = d_vx - (d_model->body_share * -(across * cosine) +
                                    model->body_share * -(d_across * cosine + across * d_cosine));
    written[TDMF_FOOT_VY] = d_vy - (d_model->body_share * -(across * sine) +
                                    model->body_share * -(d_across * sine + across * d_sine));
    written[TDMF_LEG_LENGTH] = d_length;
    written[TDMF_LEG_ANGLE] = d_target;
    written[TDMF_LEG_LENGTH_RATE] = 0.0;
    written[TDMF_LEG_ANGLE_RATE] = d_target_rate;
    written[TDMF_HIP_PLACE_TIME] = d_time;
}

/* Where the leg has a constant length and rate, the foot swings about the centre of mass. */
static inline void tdmf_prescribed_rates(const tdmf_model *model, const tdmf_inputs *inputs,
                                         const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                                         double written[TDMF_STATE_COUNT]) {
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double towards = model->body_share * state[TDMF_LEG_ANGLE_RATE] * state[TDMF_LEG_ANGLE_RATE];
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    written[TDMF_FOOT_X] = state[TDMF_FOOT_VX];
    written[TDMF_FOOT_Y] = state[TDMF_FOOT_VY];
    written[TDMF_LEG_ANGLE] = state[TDMF_LEG_ANGLE_RATE];
    written[TDMF_FOOT_VX] = model->body_share * x + towards * (-state[TDMF_LEG_LENGTH] * direction.sine);
    written[TDMF_FOOT_VY] = model->body_share * y - model->parameters.gravity +
                            towards * (state[TDMF_LEG_LENGTH] * direction.cosine);
    written[TDMF_HIP_PLACE_TIME] = 1.0;
}

/* How long a centre of mass rises; where nothing pulls it down the time is infinite or negative. */
static inline double tdmf_rise_time(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_point start) {
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    return start.vy / -(model->body_share * y - model->parameters.gravity);
}

/* Its change. */
static inline double tdmf_vary_rise_time(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_point start,
                                         const tdmf_model *d_model, const tdmf_inputs *d_inputs,
                                         tdmf_point d_start) {
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const double d_y = d_inputs->body.external_fy * model->inverse_body_mass +
                       inputs->body.external_fy * d_model->inverse_body_mass;
    return (d_start.vy -
            start.vy / -(model->body_share * y - model->parameters.gravity) *
                -(d_model->body_share * y + model->body_share * d_y - d_model->parameters.gravity)) /
           -(model->body_share * y - model->parameters.gravity);
}

#endif
