/* Energies of two point masses and a spring:
 *
 *     kinetic m |v_m|^2/2 + m_f |v|^2/2,   potential m g y_m + m_f g y,   elastic k (l0 - r)^2/2 */
#include "tdmf_slip/energy.h"

#include "tdmf_slip/kinematics.h"

tdmf_energy tdmf_mechanical_energy(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_point body = tdmf_body(state);
    const double vx = state[TDMF_FOOT_VX];
    const double vy = state[TDMF_FOOT_VY];
    const double compression = p->leg.free_length - state[TDMF_LEG_LENGTH];
    tdmf_energy energy = {
        .kinetic = 0.5 * (p->body.mass * (body.vx * body.vx + body.vy * body.vy) +
                          p->foot.mass * (vx * vx + vy * vy)),
        .potential = p->gravity * (p->body.mass * body.y + p->foot.mass * state[TDMF_FOOT_Y]),
        .elastic = 0.5 * p->leg.stiffness * compression * compression,
    };
    energy.total = energy.kinetic + energy.potential + energy.elastic;
    return energy;
}
