/* Graze, or lift-off done exactly.
 *
 * When the contact force vanishes, the stance law would let the foot rise, while the flight law that takes
 * over often presses it down again: stance says leave, flight says stay. Filippov's solution has no
 * penetration and no chatter: while the laws disagree the foot stays at y = vy = 0 without ground force, and
 * the torque has the value in between that keeps it there,
 *
 *     tau_eq = r (F_s cos(theta) + m_f g) / sin(theta).
 *
 * Let P(tau) be f_y of (10). A resting foot is pressed on the ground by a law if P > 0, and rises under it
 * with ay = -P/m_f if P < 0; tau_eq is the zero of P. So with s: "P(stance law) > 0" and a: "P(flight law) <
 * 0",
 *
 *     s: contact;     a and not s: flight;     neither: graze.
 *
 * The exits of graze are watched by P of either law, never by tau_eq, which is 0/0 at theta = 0. There the
 * hip has no lever on the foot, and no torque that could hold it: contact if P > 0, or if P = 0 and does not
 * fall; else flight. */
#include "tdmf_slip/graze.h"

#include "leg.h"
#include "margins.h"
#include "tdmf_slip/contact.h"
#include "tdmf_slip/dynamics.h"
#include "tdmf_slip/hip.h"

double tdmf_leg_graze_sine(const tdmf_leg *leg) {
    return copysign(fmax(fabs(leg->sine), TDMF_SMALLEST_SINE), leg->sine);
}

double tdmf_leg_graze_torque(const tdmf_model *model, const tdmf_leg *leg) {
    const double press =
        leg->axial_force * leg->cosine + model->parameters.foot.mass * model->parameters.gravity;
    return press / (tdmf_leg_graze_sine(leg) * leg->inverse_length);
}

double tdmf_graze_torque(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, state);
    return tdmf_leg_graze_torque(model, &leg);
}

static double press_of(const tdmf_model *model, const tdmf_inputs *inputs, double law,
                       const double state[TDMF_STATE_COUNT]) {
    return tdmf_sticking_force(model, law + inputs->hip.external_torque, state).fy;
}

double tdmf_stance_press(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                         const double state[TDMF_STATE_COUNT]) {
    return press_of(model, inputs, tdmf_hip_stance_law(model, mode), state);
}

double tdmf_flight_press(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                         const double state[TDMF_STATE_COUNT]) {
    return press_of(model, inputs, tdmf_hip_flight_law(model, mode, state), state);
}

/* Of an upright leg, on whose foot no torque has a lever: where it presses with nothing, what it is about to
 * press with decides. */
static tdmf_foot_fate fate_under_upright_leg(const tdmf_model *model, const tdmf_inputs *inputs,
                                             const tdmf_mode *off_ground, double press,
                                             const double state[TDMF_STATE_COUNT]) {
    if (fabs(press) <= TDMF_GUARD_MARGIN * model->scales.force) {
        tdmf_mode stands = *off_ground;
        stands.contact = TDMF_CONTACT_STICK;
        press = tdmf_ground_force_rate(model, inputs, &stands, state);
    }
    return press < 0.0 ? TDMF_FOOT_LEAVES : TDMF_FOOT_LOADED;
}

tdmf_foot_fate tdmf_fate_at_rest(const tdmf_model *model, const tdmf_inputs *inputs,
                                 const tdmf_mode *off_ground, const double state[TDMF_STATE_COUNT]) {
    const double press = tdmf_stance_press(model, inputs, off_ground, state);
    if (fabs(sin(state[TDMF_LEG_ANGLE])) <= TDMF_SMALLEST_SINE) {
        return fate_under_upright_leg(model, inputs, off_ground, press, state);
    }
    if (press > 0.0) {
        return TDMF_FOOT_LOADED;
    }
    return tdmf_flight_press(model, inputs, off_ground, state) < 0.0 ? TDMF_FOOT_LEAVES : TDMF_FOOT_GRAZES;
}

tdmf_foot_fate tdmf_fate_at_lift_off(const tdmf_model *model, const tdmf_inputs *inputs,
                                     const tdmf_mode *off_ground, const double state[TDMF_STATE_COUNT]) {
    const double press = tdmf_flight_press(model, inputs, off_ground, state);
    return press > TDMF_NARROWEST_GRAZE * model->scales.force ? TDMF_FOOT_GRAZES : TDMF_FOOT_LEAVES;
}
