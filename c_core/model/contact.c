/* Ground forces. With the foot on the ground (y = vy = ay = 0), sticking or slipping:
 *
 *     f_y = F_s cos(theta) - (tau/r) sin(theta) + m_f g                               (10)
 *     stick:  f_x = -F_s sin(theta) - (tau/r) cos(theta)                              (10)
 *     slip:   f_x = -mu sgn(vx) f_y
 *
 * f_y is the same in stick and slip, so friction never feeds back on it: no Painleve paradox. */
#include "tdmf_slip/contact.h"

#include "friction.h"
#include "ground_force.h"

double tdmf_foot_weight(const tdmf_model *model) {
    return model->parameters.foot.mass * model->parameters.gravity;
}

double tdmf_vary_foot_weight(const tdmf_model *model, const tdmf_model *d) {
    return d->parameters.foot.mass * model->parameters.gravity +
           model->parameters.foot.mass * d->parameters.gravity;
}

tdmf_ground_force tdmf_force_under(const tdmf_evaluation *at, double torque) {
    const tdmf_leg *leg = &at->leg;
    const double across = torque * leg->inverse_length;
    const tdmf_ground_force force = {
        .fx = -leg->axial_force * leg->sine - across * leg->cosine,
        .fy = leg->axial_force * leg->cosine - across * leg->sine + tdmf_foot_weight(at->model),
    };
    return force;
}

tdmf_ground_force tdmf_vary_force_under(const tdmf_evaluation *at, const tdmf_evaluation *d, double torque,
                                        double d_torque) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *d_leg = &d->leg;
    const double across = torque * leg->inverse_length;
    const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
    const tdmf_ground_force d_force = {
        .fx = -d_leg->axial_force * leg->sine - leg->axial_force * d_leg->sine - d_across * leg->cosine -
              across * d_leg->cosine,
        .fy = d_leg->axial_force * leg->cosine + leg->axial_force * d_leg->cosine - d_across * leg->sine -
              across * d_leg->sine + tdmf_vary_foot_weight(at->model, d->model),
    };
    return d_force;
}

tdmf_ground_force tdmf_force_in_mode(const tdmf_evaluation *at) {
    tdmf_ground_force force = {0.0, 0.0};
    if (tdmf_in_contact(at->mode)) {
        force = tdmf_force_under(at, at->torque);
        if (at->mode->contact != TDMF_CONTACT_STICK) {
            force.fx = -tdmf_signed_friction(at->inputs, at->mode) * force.fy;
        }
    }
    return force;
}

tdmf_ground_force tdmf_vary_force_in_mode(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    tdmf_ground_force d_force = {0.0, 0.0};
    if (tdmf_in_contact(at->mode)) {
        d_force = tdmf_vary_force_under(at, d, at->torque, d->torque);
        if (at->mode->contact != TDMF_CONTACT_STICK) {
            d_force.fx = -tdmf_signed_friction(d->inputs, at->mode) * at->force.fy -
                         tdmf_signed_friction(at->inputs, at->mode) * d_force.fy;
        }
    }
    return d_force;
}

tdmf_ground_force tdmf_sticking_force(const tdmf_model *model, double torque,
                                      const double state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation at = {.model = model, .leg = tdmf_leg_of(model, state)};
    return tdmf_force_under(&at, torque);
}

tdmf_ground_force tdmf_contact_force(const tdmf_model *model, const tdmf_inputs *inputs,
                                     const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate(model, inputs, mode, state).force;
}

bool tdmf_inside_friction_cone(tdmf_ground_force force, double friction) {
    return fabs(force.fx) <= friction * force.fy;
}
