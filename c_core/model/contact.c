/* Ground forces as the world asks for them; equations/ground_force.py has the law. */
#include "tdmf_slip/contact.h"

#include "evaluation.h"

tdmf_ground_force tdmf_sticking_force(const tdmf_model *model, const tdmf_inputs *inputs,
                                      const tdmf_mode *mode, double torque,
                                      const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, inputs, mode, state);
    return tdmf_force_under(model, &mode->ground, &leg, torque);
}

tdmf_ground_force tdmf_contact_force(const tdmf_model *model, const tdmf_inputs *inputs,
                                     const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate(model, inputs, mode, state).force;
}

bool tdmf_inside_friction_cone(tdmf_ground_force force, double friction) {
    return fabs(force.tangential) <= friction * force.normal;
}
