/* Ground forces as the world asks for them; equations/ground_force.py has the law. */
#include "tdmf_slip/contact.h"

#include "evaluation.h"

tdmf_ground_force tdmf_sticking_force(tdmf_system system, const tdmf_mode *mode, double torque,
                                      const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(system, mode, state);
    return tdmf_force_under(system.model, &mode->ground, &leg, torque);
}

tdmf_ground_force tdmf_contact_force(tdmf_system system, const tdmf_mode *mode,
                                     const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate(system, mode, state).force;
}

bool tdmf_inside_friction_cone(tdmf_ground_force force, double friction) {
    return tdmf_room_in_cone(friction, 1.0, force) >= 0.0 && tdmf_room_in_cone(friction, -1.0, force) >= 0.0;
}
