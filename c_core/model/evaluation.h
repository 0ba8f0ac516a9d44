/* Evaluation of an instant, once and in the one order in which each quantity follows from those before it. In
 * line: a right-hand side is hardly more than this. */
#ifndef TDMF_MODEL_EVALUATION_H
#define TDMF_MODEL_EVALUATION_H

#include "evaluated.h"
#include "ground_force.h"
#include "hip_torque.h"

/* Where the leg is at hand. The other arguments are not copied. */
static inline tdmf_evaluation tdmf_evaluate_leg(const tdmf_model *model, const tdmf_inputs *inputs,
                                                const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                                                const tdmf_leg *leg) {
    tdmf_evaluation at;
    at.model = model;
    at.inputs = inputs;
    at.mode = mode;
    at.state = state;
    at.leg = *leg;
    at.torque = tdmf_torque_in_mode(&at);
    at.force = tdmf_force_in_mode(&at);
    return at;
}

static inline tdmf_evaluation tdmf_evaluate(const tdmf_model *model, const tdmf_inputs *inputs,
                                            const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, inputs, mode, state);
    return tdmf_evaluate_leg(model, inputs, mode, state, &leg);
}

/* How what is evaluated changes along a direction, in the same shape; the mode is held but for its lift-off
 * angle. */
tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_direction *d);

#endif
