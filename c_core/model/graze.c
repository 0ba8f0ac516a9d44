/* What becomes of a foot at rest on the ground; equations/graze.py tells what graze is. With s: "N(stance
 * law) > 0" and a: "N(flight law) < 0",
 *
 *     s: contact;     a and not s: flight;     neither: graze.
 *
 * Where theta' = 0 the hip has no lever on the foot, and no torque that could hold it: contact if N > 0, or
 * if N = 0 and does not fall; else flight. */
#include "graze.h"

#include "dynamics.h"
#include "event_declarations.h"
#include "graze_laws.h"
#include "guard_laws.h"
#include "margins.h"

/* ---- what becomes of the foot ------------------------------------------------------------------------- */

/* No torque has a lever on the foot of an upright leg: where it carries nothing, what it is about to carry
 * decides. */
static tdmf_contact_mode contact_under_upright_leg(const tdmf_evaluation *off_ground, double normal_force) {
    if (fabs(normal_force) <= TDMF_GUARD_MARGIN * off_ground->model->scales.force) {
        tdmf_mode stands = *off_ground->mode;
        stands.contact = TDMF_CONTACT_STICK;
        const tdmf_leg_direction direction = {off_ground->leg.sine, off_ground->leg.cosine};
        const tdmf_evaluation at = tdmf_evaluate_along((tdmf_system){off_ground->model, off_ground->inputs},
                                                       &stands, off_ground->state, direction);
        normal_force = tdmf_force_rate(&at).normal;
    }
    return normal_force < 0.0 ? TDMF_CONTACT_FLIGHT : TDMF_CONTACT_STICK;
}

tdmf_contact_mode tdmf_contact_of_resting_foot(const tdmf_evaluation *off_ground) {
    const double normal_force = tdmf_force_in_stance(off_ground).normal;
    if (tdmf_is_upright(&off_ground->leg)) {
        return contact_under_upright_leg(off_ground, normal_force);
    }
    if (normal_force > 0.0) {
        return TDMF_CONTACT_STICK;
    }
    return tdmf_force_in_flight(off_ground).normal < 0.0 ? TDMF_CONTACT_FLIGHT : TDMF_CONTACT_GRAZE;
}

tdmf_contact_mode tdmf_contact_after_lift_off(const tdmf_evaluation *off_ground) {
    const double minimum = TDMF_NARROWEST_GRAZE * off_ground->model->scales.force;
    return tdmf_force_in_flight(off_ground).normal > minimum ? TDMF_CONTACT_GRAZE : TDMF_CONTACT_FLIGHT;
}
