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

/* How long a centre of mass rises; where nothing pulls it down the time is infinite or negative. */
static inline double tdmf_rise_time(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_point start) {
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    return start.vy / -(model->body_share * y - model->parameters.gravity);
}

#endif
