/* Energies of two point masses and a spring:
 *
 *     kinetic m |v_m|^2/2 + m_f |v|^2/2,   potential m g y_m + m_f g y,   elastic k (rest length - r)^2/2 */
#include "energy.h"

#include "kinematics.h"

tdmf_energy tdmf_mechanical_energy_along(const tdmf_model *model, const tdmf_inputs *inputs,
                                         const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                                         tdmf_leg_direction direction) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_point body = tdmf_body_along(state, direction);
    const double vx = state[TDMF_FOOT_VX];
    const double vy = state[TDMF_FOOT_VY];
    const double compression = tdmf_rest_length(model, inputs, mode) - state[TDMF_LEG_LENGTH];
    tdmf_energy energy = {
        .kinetic = 0.5 * (p->body.mass * (body.vx * body.vx + body.vy * body.vy) +
                          p->foot.mass * (vx * vx + vy * vy)),
        .potential = p->gravity * (p->body.mass * body.y + p->foot.mass * state[TDMF_FOOT_Y]),
        .elastic = 0.5 * p->leg.stiffness * compression * compression,
    };
    energy.total = energy.kinetic + energy.potential + energy.elastic;
    return energy;
}

tdmf_energy tdmf_mechanical_energy(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]) {
    return tdmf_mechanical_energy_along(model, inputs, mode, state, tdmf_leg_direction_of(state));
}

tdmf_energy tdmf_vary_energy(const tdmf_evaluation *at, const tdmf_direction *d,
                             const tdmf_evaluation *d_at) {
    const tdmf_model *model = at->model;
    const double *state = at->state;
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d_p = &d->model.parameters;
    const tdmf_point body = tdmf_body_along(state, direction);
    const tdmf_point d_body = tdmf_vary_body(state, direction, d->state);
    const double y = state[TDMF_FOOT_Y];
    const double vx = state[TDMF_FOOT_VX];
    const double vy = state[TDMF_FOOT_VY];
    const double compression = at->leg.rest_length - at->leg.length;
    const double d_compression = d_at->leg.rest_length - d_at->leg.length;
    tdmf_energy d_energy = {
        .kinetic = 0.5 * d_p->body.mass * (body.vx * body.vx + body.vy * body.vy) +
                   p->body.mass * (body.vx * d_body.vx + body.vy * d_body.vy) +
                   0.5 * d_p->foot.mass * (vx * vx + vy * vy) +
                   p->foot.mass * (vx * d->state[TDMF_FOOT_VX] + vy * d->state[TDMF_FOOT_VY]),
        .potential = d_p->gravity * (p->body.mass * body.y + p->foot.mass * y) +
                     p->gravity * (d_p->body.mass * body.y + p->body.mass * d_body.y + d_p->foot.mass * y +
                                   p->foot.mass * d->state[TDMF_FOOT_Y]),
        .elastic = 0.5 * d_p->leg.stiffness * compression * compression +
                   p->leg.stiffness * compression * d_compression,
    };
    d_energy.total = d_energy.kinetic + d_energy.potential + d_energy.elastic;
    return d_energy;
}
