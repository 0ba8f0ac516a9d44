/* An evaluation varied, in the order in which it was made. */
#include "evaluation.h"

tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_direction *d) {
    tdmf_evaluation d_at = {.model = &d->model, .inputs = &d->inputs, .mode = &d->mode, .state = d->state};
    d_at.leg = tdmf_vary_leg(
        at->model, &at->leg, &d->model,
        tdmf_vary_rest_length(tdmf_thrust_acts(at->model, at->inputs, at->mode), &d->model, &d->inputs),
        &d->mode.ground, d->state);
    d_at.torque = tdmf_vary_torque_in_mode(at, &d_at.leg, d);
    d_at.force = tdmf_vary_force_in_mode(at, &d_at);
    return d_at;
}
