/* An evaluation varied, in the order in which it was made. */
#include "evaluation.h"

tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_local_seed *d) {
    const tdmf_model *model = at->model;
    const tdmf_inputs *inputs = at->inputs;
    const tdmf_mode *mode = at->mode;
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg_direction direction = {leg->sine, leg->cosine};
    tdmf_evaluation d_at = {.model = &d->model, .inputs = &d->inputs, .mode = &d->mode, .state = d->state};
    const double d_rest_length = tdmf_vary_rest_length(model, inputs, mode, &d->model, &d->inputs, &d->mode);
    d_at.leg = tdmf_vary_leg_with(model, &mode->ground, at->state, direction, leg->rest_length, leg,
                                  &d->model, &d->mode.ground, d->state, d_rest_length);
    d_at.torque = tdmf_vary_torque_in(model, inputs, mode, at->state, leg, tdmf_is_upright(leg),
                                      tdmf_sine_away_from_zero(leg), at->torque, &d->model, &d->inputs,
                                      &d->mode, d->state, &d_at.leg);
    d_at.friction = tdmf_vary_friction_below(model, inputs, mode->zone, &d->model, &d->inputs);
    d_at.force =
        tdmf_vary_force_in(model, at->friction, &mode->ground, at->state, leg, at->torque, mode->contact,
                           tdmf_sign_of_slip(mode), tdmf_friction_falls(model), &d->model, d_at.friction,
                           &d->mode.ground, d->state, &d_at.leg, d_at.torque);
    return d_at;
}
