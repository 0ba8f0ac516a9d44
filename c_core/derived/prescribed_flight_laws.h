/* Derived from c_core/equations/prescribed_flight.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_PRESCRIBED_FLIGHT_LAWS_H
#define TDMF_DERIVED_PRESCRIBED_FLIGHT_LAWS_H

#include "quantities.h"

#include <math.h>

/* The leg some time after the apex. */
static inline void tdmf_placed_leg(const tdmf_model *model, const tdmf_inputs *inputs, double time,
                                   double written[TDMF_STATE_COUNT]) {
    written[TDMF_LEG_LENGTH] = model->parameters.leg.free_length + inputs->leg.extension;
    written[TDMF_LEG_ANGLE] = model->parameters.hip.touchdown_angle + inputs->control.touchdown_angle -
                              model->parameters.hip.retraction_rate * time;
    written[TDMF_LEG_LENGTH_RATE] = 0.0;
    written[TDMF_LEG_ANGLE_RATE] = -model->parameters.hip.retraction_rate;
    written[TDMF_HIP_PLACE_TIME] = time;
}

/* Its change. */
static inline void tdmf_vary_placed_leg(const tdmf_model *model, const tdmf_inputs *inputs, double time,
                                        const tdmf_model *d_model, const tdmf_inputs *d_inputs, double d_time,
                                        double written[TDMF_STATE_COUNT]) {
    (void)inputs;
    written[TDMF_LEG_LENGTH] = d_model->parameters.leg.free_length + d_inputs->leg.extension;
    written[TDMF_LEG_ANGLE] =
        d_model->parameters.hip.touchdown_angle + d_inputs->control.touchdown_angle -
        (d_model->parameters.hip.retraction_rate * time + model->parameters.hip.retraction_rate * d_time);
    written[TDMF_LEG_LENGTH_RATE] = 0.0;
    written[TDMF_LEG_ANGLE_RATE] = -d_model->parameters.hip.retraction_rate;
    written[TDMF_HIP_PLACE_TIME] = d_time;
}

/* Where the leg has a constant length and rate, the foot swings about the centre of mass. */
static inline void tdmf_prescribed_rates(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                         tdmf_leg_direction direction, tdmf_vector acceleration,
                                         double written[TDMF_STATE_COUNT]) {
    const double towards = model->body_share * state[TDMF_LEG_ANGLE_RATE] * state[TDMF_LEG_ANGLE_RATE];
    const double x = -state[TDMF_LEG_LENGTH] * direction.sine;
    const double y = state[TDMF_LEG_LENGTH] * direction.cosine;
    written[TDMF_FOOT_X] = state[TDMF_FOOT_VX];
    written[TDMF_FOOT_Y] = state[TDMF_FOOT_VY];
    written[TDMF_LEG_ANGLE] = state[TDMF_LEG_ANGLE_RATE];
    written[TDMF_FOOT_VX] = acceleration.x + towards * x;
    written[TDMF_FOOT_VY] = acceleration.y + towards * y;
    written[TDMF_HIP_PLACE_TIME] = 1.0;
}

/* How long a centre of mass rises that falls so fast. */
static inline double tdmf_rise_time(tdmf_point start, tdmf_vector acceleration) {
    return start.vy / -acceleration.y;
}

/* Its change. */
static inline double tdmf_vary_rise_time(tdmf_point start, tdmf_vector acceleration, tdmf_point d_start,
                                         tdmf_vector d_acceleration) {
    return (d_start.vy - start.vy / -acceleration.y * -d_acceleration.y) / -acceleration.y;
}

#endif
