/* Ground forces. With the foot on the ground (y = vy = ay = 0), sticking or slipping:
 *
 *     f_y = F_s cos(theta) - (tau/r) sin(theta) + m_f g                               (10)
 *     stick:  f_x = -F_s sin(theta) - (tau/r) cos(theta)                              (10)
 *     slip:   f_x = -mu sgn(vx) f_y
 *
 * f_y is the same in stick and slip, so friction never feeds back on it: no Painleve paradox. */
#include "tdmf_slip/contact.h"

#include "leg.h"

tdmf_ground_force tdmf_leg_sticking_force(const tdmf_model *model, double torque, const tdmf_leg *leg) {
    const double across = torque * leg->inverse_length;
    const double weight = model->parameters.foot.mass * model->parameters.gravity;
    const tdmf_ground_force force = {
        .fx = -leg->axial_force * leg->sine - across * leg->cosine,
        .fy = leg->axial_force * leg->cosine - across * leg->sine + weight,
    };
    return force;
}

tdmf_ground_force tdmf_leg_sticking_force_rate(const tdmf_model *model, double torque, double torque_rate,
                                               double length_acceleration, const tdmf_leg *leg) {
    const double axial = leg->axial_force;
    const double axial_rate = -model->parameters.leg.stiffness * leg->length_rate -
                              model->parameters.leg.damping * length_acceleration;
    const double across = torque * leg->inverse_length;
    const double across_rate = (torque_rate - across * leg->length_rate) * leg->inverse_length;
    const tdmf_ground_force rate = {
        .fx = -axial_rate * leg->sine - across_rate * leg->cosine -
              (axial * leg->cosine - across * leg->sine) * leg->angle_rate,
        .fy = axial_rate * leg->cosine - across_rate * leg->sine -
              (axial * leg->sine + across * leg->cosine) * leg->angle_rate,
    };
    return rate;
}

tdmf_ground_force tdmf_leg_contact_force(const tdmf_model *model, const tdmf_inputs *inputs,
                                         const tdmf_mode *mode, double torque, const tdmf_leg *leg) {
    tdmf_ground_force force = {0.0, 0.0};
    if (tdmf_in_contact(mode)) {
        force = tdmf_leg_sticking_force(model, torque, leg);
        if (mode->contact != TDMF_CONTACT_STICK) {
            force.fx = -tdmf_slip_sign(mode) * inputs->ground.friction * force.fy;
        }
    }
    return force;
}

tdmf_ground_force tdmf_sticking_force(const tdmf_model *model, double torque,
                                      const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, state);
    return tdmf_leg_sticking_force(model, torque, &leg);
}

tdmf_ground_force tdmf_contact_force(const tdmf_model *model, const tdmf_inputs *inputs,
                                     const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, state);
    const double torque = tdmf_leg_hip_torque(model, inputs, mode, state, &leg);
    return tdmf_leg_contact_force(model, inputs, mode, torque, &leg);
}

bool tdmf_inside_friction_cone(tdmf_ground_force force, double friction) {
    return fabs(force.fx) <= friction * force.fy;
}
