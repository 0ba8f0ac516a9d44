/* The hip torque. What the paper prints, with the corrections that its text and its gaits ask for:
 *
 *     stance (11):  tau = -tau0 from touchdown with theta >= 0 to mid-stance, then 0
 *     retract (12): tau = max{ -kp (theta - eta theta_LO) - kd thetadot, 0 }     while vy_c >= 0
 *     place (12):   tau = -kp (theta - theta0) - kd thetadot                     from the apex on
 *
 * The sign in (11) is turned, because theta falls in forward running and only a negative torque then does
 * positive work; min in (12) is a max, because the text asks for a positive torque that stops the leg's
 * backward rotation. The drive happens once per stance: were it to return with theta, it could switch for
 * ever.
 *
 * The clamp's kink is located like an event: in flight the law is smooth while mode->clamp_closed stands. */
#include "tdmf_slip/hip.h"

#include "leg.h"

#include <math.h>

double tdmf_hip_stance_law(const tdmf_model *model, const tdmf_mode *mode) {
    return mode->mid_stance_pending ? -model->parameters.hip.stance_torque : 0.0;
}

static double towards(const tdmf_model *model, double target, const double state[TDMF_STATE_COUNT]) {
    return -model->parameters.hip.kp * (state[TDMF_LEG_ANGLE] - target) -
           model->parameters.hip.kd * state[TDMF_LEG_ANGLE_RATE];
}

double tdmf_hip_retract_argument(const tdmf_model *model, const tdmf_mode *mode,
                                 const double state[TDMF_STATE_COUNT]) {
    return towards(model, model->parameters.hip.liftoff_angle_factor * mode->liftoff_angle, state);
}

double tdmf_hip_flight_law(const tdmf_model *model, const tdmf_mode *mode,
                           const double state[TDMF_STATE_COUNT]) {
    if (mode->phase == TDMF_PHASE_PLACE) {
        return towards(model, model->parameters.hip.touchdown_angle, state);
    }
    return fmax(tdmf_hip_retract_argument(model, mode, state), 0.0);
}

/* The flight law with the clamp as last located. */
static double hip_in_flight(const tdmf_model *model, const tdmf_mode *mode,
                            const double state[TDMF_STATE_COUNT]) {
    if (mode->phase == TDMF_PHASE_PLACE) {
        return towards(model, model->parameters.hip.touchdown_angle, state);
    }
    return mode->clamp_closed ? 0.0 : tdmf_hip_retract_argument(model, mode, state);
}

double tdmf_leg_hip_torque(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                           const double state[TDMF_STATE_COUNT], const tdmf_leg *leg) {
    switch (mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        return hip_in_flight(model, mode, state) + inputs->hip.external_torque;
    case TDMF_CONTACT_GRAZE:
        return tdmf_leg_graze_torque(model, leg);
    default:
        return tdmf_hip_stance_law(model, mode) + inputs->hip.external_torque;
    }
}

double tdmf_hip_torque(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                       const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, state);
    return tdmf_leg_hip_torque(model, inputs, mode, state, &leg);
}
