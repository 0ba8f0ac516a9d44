/* Derived from c_core/equations/energy.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_ENERGY_LAWS_H
#define TDMF_DERIVED_ENERGY_LAWS_H

#include "quantities.h"

#include <math.h>

/* m |v_m|^2/2 + m_f |v|^2/2, m g y_m + m_f g y, k (l - r)^2/2, and their sum. */
static inline tdmf_energy tdmf_energy_with(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                           const tdmf_leg *leg) {
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double vx = -state[TDMF_LEG_LENGTH_RATE] * leg->sine - across * leg->cosine;
    const double vy = state[TDMF_LEG_LENGTH_RATE] * leg->cosine - across * leg->sine;
    const double body_square = (state[TDMF_FOOT_VX] + vx) * (state[TDMF_FOOT_VX] + vx) +
                               (state[TDMF_FOOT_VY] + vy) * (state[TDMF_FOOT_VY] + vy);
    const double foot_square =
        state[TDMF_FOOT_VX] * state[TDMF_FOOT_VX] + state[TDMF_FOOT_VY] * state[TDMF_FOOT_VY];
    const double kinetic =
        0.5 * (model->parameters.body.mass * body_square + model->parameters.foot.mass * foot_square);
    const double y = state[TDMF_LEG_LENGTH] * leg->cosine;
    const double potential =
        model->parameters.gravity * (model->parameters.body.mass * (state[TDMF_FOOT_Y] + y) +
                                     model->parameters.foot.mass * state[TDMF_FOOT_Y]);
    const double compression = leg->rest_length - state[TDMF_LEG_LENGTH];
    const double elastic = 0.5 * (model->parameters.leg.stiffness * compression * compression);
    const tdmf_energy result = {
        .kinetic = kinetic,
        .potential = potential,
        .elastic = elastic,
        .total = kinetic + potential + elastic,
    };
    return result;
}

/* Its change. */
static inline tdmf_energy tdmf_vary_energy_with(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                                const tdmf_leg *leg, const tdmf_model *d_model,
                                                const double d_state[TDMF_STATE_COUNT],
                                                const tdmf_leg *d_leg) {
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double vx = -state[TDMF_LEG_LENGTH_RATE] * leg->sine - across * leg->cosine;
    const double vy = state[TDMF_LEG_LENGTH_RATE] * leg->cosine - across * leg->sine;
    const double body_square = (state[TDMF_FOOT_VX] + vx) * (state[TDMF_FOOT_VX] + vx) +
                               (state[TDMF_FOOT_VY] + vy) * (state[TDMF_FOOT_VY] + vy);
    const double d_across = d_state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE] +
                            state[TDMF_LEG_LENGTH] * d_state[TDMF_LEG_ANGLE_RATE];
    const double d_vx = -d_state[TDMF_LEG_LENGTH_RATE] * leg->sine +
                        -state[TDMF_LEG_LENGTH_RATE] * d_leg->sine -
                        (d_across * leg->cosine + across * d_leg->cosine);
    const double d_vy = d_state[TDMF_LEG_LENGTH_RATE] * leg->cosine +
                        state[TDMF_LEG_LENGTH_RATE] * d_leg->cosine -
                        (d_across * leg->sine + across * d_leg->sine);
    const double d_body_square = 2.0 * ((state[TDMF_FOOT_VX] + vx) * (d_state[TDMF_FOOT_VX] + d_vx)) +
                                 2.0 * ((state[TDMF_FOOT_VY] + vy) * (d_state[TDMF_FOOT_VY] + d_vy));
    const double foot_square =
        state[TDMF_FOOT_VX] * state[TDMF_FOOT_VX] + state[TDMF_FOOT_VY] * state[TDMF_FOOT_VY];
    const double d_foot_square = 2.0 * (state[TDMF_FOOT_VX] * d_state[TDMF_FOOT_VX]) +
                                 2.0 * (state[TDMF_FOOT_VY] * d_state[TDMF_FOOT_VY]);
    const double d_kinetic =
        0.5 * (d_model->parameters.body.mass * body_square + model->parameters.body.mass * d_body_square +
               (d_model->parameters.foot.mass * foot_square + model->parameters.foot.mass * d_foot_square));
    const double y = state[TDMF_LEG_LENGTH] * leg->cosine;
    const double d_y = d_state[TDMF_LEG_LENGTH] * leg->cosine + state[TDMF_LEG_LENGTH] * d_leg->cosine;
    const double d_potential =
        d_model->parameters.gravity * (model->parameters.body.mass * (state[TDMF_FOOT_Y] + y) +
                                       model->parameters.foot.mass * state[TDMF_FOOT_Y]) +
        model->parameters.gravity * (d_model->parameters.body.mass * (state[TDMF_FOOT_Y] + y) +
                                     model->parameters.body.mass * (d_state[TDMF_FOOT_Y] + d_y) +
                                     (d_model->parameters.foot.mass * state[TDMF_FOOT_Y] +
                                      model->parameters.foot.mass * d_state[TDMF_FOOT_Y]));
    const double compression = leg->rest_length - state[TDMF_LEG_LENGTH];
    const double d_compression = d_leg->rest_length - d_state[TDMF_LEG_LENGTH];
    const double d_elastic =
        0.5 *
        ((d_model->parameters.leg.stiffness * compression + model->parameters.leg.stiffness * d_compression) *
             compression +
         model->parameters.leg.stiffness * compression * d_compression);
    const tdmf_energy result = {
        .kinetic = d_kinetic,
        .potential = d_potential,
        .elastic = d_elastic,
        .total = d_kinetic + d_potential + d_elastic,
    };
    return result;
}

#endif
