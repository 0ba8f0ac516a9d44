/* Derived from c_core/equations/leg.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_LEG_LAWS_H
#define TDMF_DERIVED_LEG_LAWS_H

#include "quantities.h"

#include <math.h>

/* l0 + u and, from the greatest compression to the end of the stance, epsilon. */
static inline double tdmf_rest_length(const tdmf_model *model, const tdmf_inputs *inputs,
                                      const tdmf_mode *mode) {
    const double length = model->parameters.leg.free_length + inputs->leg.extension;
    return (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                          ? model->parameters.leg.thrust + inputs->control.thrust
                                          : 0.0)
                          : length);
}

/* What every force and acceleration is made of; `bounded_length` is r where that is a leg's. */
static inline tdmf_leg tdmf_leg_along(const tdmf_model *model, const tdmf_inputs *inputs,
                                      const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                                      tdmf_leg_direction direction) {
    const double length = model->parameters.leg.free_length + inputs->leg.extension;
    const double rest_length =
        (mode->thrusts ? length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                       ? model->parameters.leg.thrust + inputs->control.thrust
                                       : 0.0)
                       : length);
    const tdmf_leg result = {
        .length = state[TDMF_LEG_LENGTH],
        .inverse_length = 1.0 / (state[TDMF_LEG_LENGTH] >= 0.5 * model->parameters.leg.min_length
                                     ? state[TDMF_LEG_LENGTH]
                                     : 0.5 * model->parameters.leg.min_length),
        .length_rate = state[TDMF_LEG_LENGTH_RATE],
        .angle_rate = state[TDMF_LEG_ANGLE_RATE],
        .sine = direction.sine,
        .cosine = direction.cosine,
        .ground_sine = direction.sine * mode->ground.cosine - direction.cosine * mode->ground.sine,
        .ground_cosine = direction.cosine * mode->ground.cosine + direction.sine * mode->ground.sine,
        .rest_length = rest_length,
        .axial_force = model->parameters.leg.stiffness * (rest_length - state[TDMF_LEG_LENGTH]) -
                       model->parameters.leg.damping * state[TDMF_LEG_LENGTH_RATE],
    };
    return result;
}

/* Its change. */
static inline tdmf_leg tdmf_vary_leg_along(const tdmf_model *model, const tdmf_inputs *inputs,
                                           const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                                           tdmf_leg_direction direction, const tdmf_leg *leg,
                                           const tdmf_model *d_model, const tdmf_inputs *d_inputs,
                                           const tdmf_mode *d_mode, const double d_state[TDMF_STATE_COUNT]) {
    (void)direction;
    const double d_length = d_model->parameters.leg.free_length + d_inputs->leg.extension;
    const double d_rest_length =
        (mode->thrusts ? d_length + (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                         ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                         : 0.0)
                       : d_length);
    const tdmf_leg result = {
        .length = d_state[TDMF_LEG_LENGTH],
        .inverse_length = -(leg->inverse_length * leg->inverse_length *
                            (state[TDMF_LEG_LENGTH] >= 0.5 * model->parameters.leg.min_length
                                 ? d_state[TDMF_LEG_LENGTH]
                                 : 0.5 * d_model->parameters.leg.min_length)),
        .length_rate = d_state[TDMF_LEG_LENGTH_RATE],
        .angle_rate = d_state[TDMF_LEG_ANGLE_RATE],
        .sine = leg->cosine * d_state[TDMF_LEG_ANGLE],
        .cosine = -(leg->sine * d_state[TDMF_LEG_ANGLE]),
        .ground_sine = leg->cosine * d_state[TDMF_LEG_ANGLE] * mode->ground.cosine +
                       leg->sine * -(mode->ground.sine * d_mode->ground.slope) -
                       (-(leg->sine * d_state[TDMF_LEG_ANGLE]) * mode->ground.sine +
                        leg->cosine * (mode->ground.cosine * d_mode->ground.slope)),
        .ground_cosine = -(leg->sine * d_state[TDMF_LEG_ANGLE]) * mode->ground.cosine +
                         leg->cosine * -(mode->ground.sine * d_mode->ground.slope) +
                         (leg->cosine * d_state[TDMF_LEG_ANGLE] * mode->ground.sine +
                          leg->sine * (mode->ground.cosine * d_mode->ground.slope)),
        .rest_length = d_rest_length,
        .axial_force = d_model->parameters.leg.stiffness * (leg->rest_length - state[TDMF_LEG_LENGTH]) +
                       model->parameters.leg.stiffness * (d_rest_length - d_state[TDMF_LEG_LENGTH]) -
                       (d_model->parameters.leg.damping * state[TDMF_LEG_LENGTH_RATE] +
                        model->parameters.leg.damping * d_state[TDMF_LEG_LENGTH_RATE]),
    };
    return result;
}

/* k (l - r) ldot, what the spring is given along a ramp of its rest length. */
static inline double tdmf_leg_power(const tdmf_model *model, double rest_length, double length,
                                    double rest_length_rate) {
    return model->parameters.leg.stiffness * (rest_length - length) * rest_length_rate;
}

/* k/2 ((l+ - r)^2 - (l- - r)^2), what the spring is given where its rest length jumps. */
static inline double tdmf_leg_work_of_jump(const tdmf_model *model, double length, double before,
                                           double after) {
    return 0.5 * (model->parameters.leg.stiffness * (after - before) * (after + before - 2.0 * length));
}

/* The same, from mode to mode. */
static inline double tdmf_leg_work_between(const tdmf_model *model, const tdmf_inputs *inputs, double length,
                                           const tdmf_mode *before_mode, const tdmf_mode *after_mode) {
    const double after =
        (after_mode->thrusts ? model->parameters.leg.free_length + inputs->leg.extension +
                                   (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                        ? model->parameters.leg.thrust + inputs->control.thrust
                                        : 0.0)
                             : model->parameters.leg.free_length + inputs->leg.extension);
    const double before =
        (before_mode->thrusts ? model->parameters.leg.free_length + inputs->leg.extension +
                                    (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                         ? model->parameters.leg.thrust + inputs->control.thrust
                                         : 0.0)
                              : model->parameters.leg.free_length + inputs->leg.extension);
    return 0.5 * (model->parameters.leg.stiffness * (after - before) * (after + before - 2.0 * length));
}

/* Its change. */
static inline double tdmf_vary_leg_work_between(const tdmf_model *model, const tdmf_inputs *inputs,
                                                double length, const tdmf_mode *before_mode,
                                                const tdmf_mode *after_mode, const tdmf_model *d_model,
                                                const tdmf_inputs *d_inputs, double d_length,
                                                const tdmf_mode *d_before_mode,
                                                const tdmf_mode *d_after_mode) {
    (void)d_before_mode;
    (void)d_after_mode;
    const double after =
        (after_mode->thrusts ? model->parameters.leg.free_length + inputs->leg.extension +
                                   (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                        ? model->parameters.leg.thrust + inputs->control.thrust
                                        : 0.0)
                             : model->parameters.leg.free_length + inputs->leg.extension);
    const double before =
        (before_mode->thrusts ? model->parameters.leg.free_length + inputs->leg.extension +
                                    (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                         ? model->parameters.leg.thrust + inputs->control.thrust
                                         : 0.0)
                              : model->parameters.leg.free_length + inputs->leg.extension);
    const double d_after =
        (after_mode->thrusts ? d_model->parameters.leg.free_length + d_inputs->leg.extension +
                                   (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                        ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                        : 0.0)
                             : d_model->parameters.leg.free_length + d_inputs->leg.extension);
    const double d_before =
        (before_mode->thrusts ? d_model->parameters.leg.free_length + d_inputs->leg.extension +
                                    (model->parameters.leg.thrust + inputs->control.thrust >= 0.0
                                         ? d_model->parameters.leg.thrust + d_inputs->control.thrust
                                         : 0.0)
                              : d_model->parameters.leg.free_length + d_inputs->leg.extension);
    return 0.5 * ((d_model->parameters.leg.stiffness * (after - before) +
                   model->parameters.leg.stiffness * (d_after - d_before)) *
                      (after + before - 2.0 * length) +
                  model->parameters.leg.stiffness * (after - before) * (d_after + d_before - 2.0 * d_length));
}

#endif
