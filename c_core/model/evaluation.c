/* Evaluation in the one order in which each quantity follows from those before it. */
#include "evaluation.h"

#include "ground_force.h"
#include "hip_torque.h"

tdmf_evaluation tdmf_evaluate_leg(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                  const double state[TDMF_STATE_COUNT], const tdmf_leg *leg) {
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

tdmf_evaluation tdmf_evaluate(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, state);
    return tdmf_evaluate_leg(model, inputs, mode, state, &leg);
}

tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_direction *d) {
    tdmf_evaluation d_at = {.model = &d->model, .inputs = &d->inputs, .mode = &d->mode, .state = d->state};
    d_at.leg = tdmf_vary_leg(at->model, &at->leg, &d->model, d->state);
    d_at.torque = tdmf_vary_torque_in_mode(at, &d_at.leg, d);
    d_at.force = tdmf_vary_force_in_mode(at, &d_at);
    return d_at;
}
