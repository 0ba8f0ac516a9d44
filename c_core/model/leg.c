/* How the leg changes along a direction. */
#include "leg.h"

tdmf_leg tdmf_vary_leg(const tdmf_model *model, const tdmf_leg *leg, const tdmf_model *d,
                       const double d_state[TDMF_STATE_COUNT]) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d_p = &d->parameters;
    const double d_length = d_state[TDMF_LEG_LENGTH];
    const double d_length_rate = d_state[TDMF_LEG_LENGTH_RATE];
    const double d_angle = d_state[TDMF_LEG_ANGLE];
    const bool floored = leg->length < 0.5 * p->leg.min_length;
    const double d_bounded = floored ? 0.5 * d_p->leg.min_length : d_length;
    const tdmf_leg d_leg = {
        .length = d_length,
        .inverse_length = -leg->inverse_length * leg->inverse_length * d_bounded,
        .length_rate = d_length_rate,
        .angle_rate = d_state[TDMF_LEG_ANGLE_RATE],
        .sine = leg->cosine * d_angle,
        .cosine = -leg->sine * d_angle,
        .axial_force = d_p->leg.stiffness * (p->leg.free_length - leg->length) +
                       p->leg.stiffness * (d_p->leg.free_length - d_length) -
                       d_p->leg.damping * leg->length_rate - p->leg.damping * d_length_rate,
    };
    return d_leg;
}
