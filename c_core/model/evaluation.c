/* Evaluation in the one order in which each quantity follows from those before it. */
#include "evaluation.h"

#include "ground_force.h"
#include "hip_law.h"
#include "input_rates.h"

static double torque_at(const tdmf_evaluation *at) {
    tdmf_hip_law law;
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return tdmf_graze_torque(at);
    case TDMF_CONTACT_FLIGHT:
        law = tdmf_flight_law(at->model, at->inputs, &tdmf_held_inputs, at->mode,
                              at->state[TDMF_HIP_PLACE_TIME]);
        return tdmf_law_torque(&law, at->state);
    default:
        law = tdmf_stance_law(at->model, at->inputs, &tdmf_held_inputs, at->mode);
        return tdmf_law_torque(&law, at->state);
    }
}

static double vary_torque_at(const tdmf_evaluation *at, const tdmf_leg *d_leg, const tdmf_direction *d) {
    tdmf_hip_law law, d_law;
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return tdmf_vary_graze_torque(at, d_leg, d);
    case TDMF_CONTACT_FLIGHT:
        law = tdmf_flight_law(at->model, at->inputs, &tdmf_held_inputs, at->mode,
                              at->state[TDMF_HIP_PLACE_TIME]);
        d_law = tdmf_vary_flight_law(at->model, at->mode, at->state[TDMF_HIP_PLACE_TIME], d);
        return tdmf_vary_law_torque(&law, &d_law, at->state, d->state);
    default:
        law = tdmf_stance_law(at->model, at->inputs, &tdmf_held_inputs, at->mode);
        d_law = tdmf_vary_stance_law(at->mode, d);
        return tdmf_vary_law_torque(&law, &d_law, at->state, d->state);
    }
}

tdmf_evaluation tdmf_evaluate_leg(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                  const double state[TDMF_STATE_COUNT], const tdmf_leg *leg) {
    tdmf_evaluation at = {.model = model, .inputs = inputs, .mode = mode, .state = state, .leg = *leg};
    at.torque = torque_at(&at);
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
    d_at.leg = tdmf_vary_leg(at->model, &at->leg, d);
    d_at.torque = vary_torque_at(at, &d_at.leg, d);
    d_at.force = tdmf_vary_force_in_mode(at, &d_at);
    return d_at;
}
