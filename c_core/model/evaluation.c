/* An evaluation varied, in the order in which it was made. */
#include "evaluation.h"

tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_local_seed *d,
                                     const double d_state[TDMF_STATE_COUNT]) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg_direction direction = {leg->sine, leg->cosine};
    tdmf_evaluation d_at = {.model = &d->model, .inputs = &d->inputs, .mode = &d->mode, .state = d_state};
    d_at.leg = tdmf_vary_leg_along(at->model, at->inputs, at->mode, at->state, direction, leg, d_at.model,
                                   d_at.inputs, d_at.mode, d_at.state);
    d_at.torque =
        tdmf_vary_torque_in(at, tdmf_is_upright(leg), tdmf_sine_away_from_zero(leg), at->torque, &d_at);
    d_at.force = tdmf_vary_force_in(at, tdmf_sign_of_slip(at->mode), tdmf_friction_falls(at->model), &d_at);
    return d_at;
}
