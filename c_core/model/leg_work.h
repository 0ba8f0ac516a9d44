/* The work of the leg: what the spring is given where its rest length changes, by thrust, by its input or by
 * a setting. With the rest length l it is the integral of k (l - r) dl, in a jump
 *
 *     k/2 ((l+ - r)^2 - (l- - r)^2). */
#ifndef TDMF_MODEL_LEG_WORK_H
#define TDMF_MODEL_LEG_WORK_H

#include "leg.h"

/* In a jump of the rest length, at a length of the leg. */
static inline double tdmf_leg_work_of_jump(const tdmf_model *model, double length, double from, double to) {
    return 0.5 * model->parameters.leg.stiffness * (to - from) * (to + from - 2.0 * length);
}

/* Its change. */
static inline double tdmf_vary_leg_work_of_jump(const tdmf_model *model, double length, double from,
                                                double to, const tdmf_model *d, double d_length,
                                                double d_from, double d_to) {
    return tdmf_leg_work_of_jump(d, length, from, to) +
           model->parameters.leg.stiffness *
               ((to - length) * (d_to - d_length) - (from - length) * (d_from - d_length));
}

/* Along a ramp of the rest length, W. */
static inline double tdmf_leg_power(const tdmf_model *model, const tdmf_inputs *inputs,
                                    const tdmf_inputs *rates, const tdmf_mode *mode,
                                    const double state[TDMF_STATE_COUNT]) {
    return model->parameters.leg.stiffness *
           (tdmf_rest_length(model, inputs, mode) - state[TDMF_LEG_LENGTH]) * rates->leg.extension;
}

#endif
