/* Graze, or lift-off done exactly.
 *
 * When the contact force vanishes, the stance law would let the foot rise, while the flight law that takes
 * over often holds it down: stance says leave, flight says stay. Filippov's solution has no
 * penetration and no chatter: while the laws disagree the foot stays on the ground without force, and
 * the torque has the value in between that keeps it there,
 *
 *     tau_eq = r (F_s cos(theta') + m_f g cos(sigma)) / sin(theta').
 *
 * Let N(tau) be f_n of (10). A resting foot is held on the ground by a law if N > 0, and rises under it with
 * the acceleration -N/m_f if N < 0; tau_eq is the zero of N. So with s: "N(stance law) > 0" and a: "N(flight
 * law) < 0",
 *
 *     s: contact;     a and not s: flight;     neither: graze.
 *
 * The exits of graze are watched by N of either law, never by tau_eq, which is 0/0 at theta' = 0. There the
 * hip has no lever on the foot, and no torque that could hold it: contact if N > 0, or if N = 0 and does not
 * fall; else flight. */
#include "graze.h"

#include "dynamics.h"
#include "margins.h"

/* ---- the ground force under either law ---------------------------------------------------------------- */

/* Nobody locates the clamp of a foot on the ground: it is where the servo has it now. */
static tdmf_mode mode_by_servo(const tdmf_evaluation *at) {
    tdmf_mode mode = *at->mode;
    mode.clamp_closed = tdmf_servo_torque(at->model, at->inputs, at->mode, at->state) < 0.0;
    return mode;
}

tdmf_ground_force tdmf_force_in_stance(const tdmf_evaluation *at) {
    return tdmf_force_under(at, tdmf_stance_torque(at));
}

tdmf_ground_force tdmf_force_in_flight(const tdmf_evaluation *at) {
    const tdmf_mode mode = mode_by_servo(at);
    return tdmf_force_under(at, tdmf_flight_torque(at, &mode));
}

tdmf_ground_force tdmf_vary_force_in_stance(const tdmf_evaluation *at, const tdmf_direction *d,
                                            const tdmf_evaluation *d_at) {
    return tdmf_vary_force_under(at, d_at, tdmf_stance_torque(at), tdmf_vary_stance_torque(at, d));
}

/* The clamp, max{servo, 0}, has no derivative where the servo is 0 and does not stay so. */
static bool is_at_kink(const tdmf_evaluation *at, const tdmf_direction *d) {
    return at->mode->phase != TDMF_PHASE_PLACE &&
           tdmf_servo_torque(at->model, at->inputs, at->mode, at->state) == 0.0 &&
           tdmf_vary_servo_torque(at->model, at->inputs, at->mode, at->state, d) != 0.0;
}

tdmf_ground_force tdmf_vary_force_in_flight(const tdmf_evaluation *at, const tdmf_direction *d,
                                            const tdmf_evaluation *d_at) {
    const tdmf_mode mode = mode_by_servo(at);
    const double d_torque = is_at_kink(at, d) ? NAN : tdmf_vary_flight_torque(at, &mode, d);
    return tdmf_vary_force_under(at, d_at, tdmf_flight_torque(at, &mode), d_torque);
}

/* ---- what becomes of the foot ------------------------------------------------------------------------- */

/* Of an upright leg, on whose foot no torque has a lever: where it carries nothing, what it is about to carry
 * decides. */
static tdmf_contact_mode contact_under_upright_leg(const tdmf_evaluation *off_ground, double normal_force) {
    if (fabs(normal_force) <= TDMF_GUARD_MARGIN * off_ground->model->scales.force) {
        tdmf_mode stands = *off_ground->mode;
        stands.contact = TDMF_CONTACT_STICK;
        const tdmf_evaluation at = tdmf_evaluate_leg(off_ground->model, off_ground->inputs, &stands,
                                                     off_ground->state, &off_ground->leg);
        normal_force = tdmf_normal_force_rate(&at);
    }
    return normal_force < 0.0 ? TDMF_CONTACT_FLIGHT : TDMF_CONTACT_STICK;
}

tdmf_contact_mode tdmf_contact_of_resting_foot(const tdmf_evaluation *off_ground) {
    const double normal_force = tdmf_force_in_stance(off_ground).normal;
    if (fabs(off_ground->leg.ground_sine) <= TDMF_SMALLEST_SINE) {
        return contact_under_upright_leg(off_ground, normal_force);
    }
    if (normal_force > 0.0) {
        return TDMF_CONTACT_STICK;
    }
    return tdmf_force_in_flight(off_ground).normal < 0.0 ? TDMF_CONTACT_FLIGHT : TDMF_CONTACT_GRAZE;
}

tdmf_contact_mode tdmf_contact_after_lift_off(const tdmf_evaluation *off_ground) {
    const double least = TDMF_NARROWEST_GRAZE * off_ground->model->scales.force;
    return tdmf_force_in_flight(off_ground).normal > least ? TDMF_CONTACT_GRAZE : TDMF_CONTACT_FLIGHT;
}
