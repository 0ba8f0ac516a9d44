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

#include "evaluation.h"
#include "hip_law.h"
#include "input_rates.h"

tdmf_hip_law tdmf_external_law(const tdmf_inputs *inputs, const tdmf_inputs *rates) {
    const tdmf_hip_law law = {.torque = inputs->hip.external_torque,
                              .torque_rate = rates->hip.external_torque};
    return law;
}

/* ---- stance (11) -------------------------------------------------------------------------------------- */

tdmf_hip_law tdmf_stance_law(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                             const tdmf_mode *mode) {
    tdmf_hip_law law = tdmf_external_law(inputs, rates);
    law.torque -= mode->mid_stance_pending ? model->parameters.hip.stance_torque : 0.0;
    return law;
}

/* The law is linear in what it is made of. */
tdmf_hip_law tdmf_vary_stance_law(const tdmf_mode *mode, const tdmf_direction *d) {
    return tdmf_stance_law(&d->model, &d->inputs, &tdmf_held_inputs, mode);
}

/* ---- flight (12) -------------------------------------------------------------------------------------- */

tdmf_hip_law tdmf_servo(const tdmf_model *model, const tdmf_mode *mode) {
    const tdmf_parameters *p = &model->parameters;
    const bool places = mode->phase == TDMF_PHASE_PLACE;
    const tdmf_hip_law law = {
        .gain = p->hip.kp,
        .rate_gain = p->hip.kd,
        .target = places ? p->hip.touchdown_angle : p->hip.liftoff_angle_factor * mode->liftoff_angle,
    };
    return law;
}

tdmf_hip_law tdmf_vary_servo(const tdmf_model *model, const tdmf_mode *mode, const tdmf_direction *d) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d_p = &d->model.parameters;
    const bool places = mode->phase == TDMF_PHASE_PLACE;
    const tdmf_hip_law d_law = {
        .gain = d_p->hip.kp,
        .rate_gain = d_p->hip.kd,
        .target = places ? d_p->hip.touchdown_angle
                         : d_p->hip.liftoff_angle_factor * mode->liftoff_angle +
                               p->hip.liftoff_angle_factor * d->mode.liftoff_angle,
    };
    return d_law;
}

static bool is_clamped(const tdmf_mode *mode) {
    return mode->phase != TDMF_PHASE_PLACE && mode->clamp_closed;
}

static tdmf_hip_law sum(tdmf_hip_law a, tdmf_hip_law b) {
    a.torque += b.torque;
    a.torque_rate += b.torque_rate;
    return a;
}

tdmf_hip_law tdmf_flight_law(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                             const tdmf_mode *mode) {
    const tdmf_hip_law alone = tdmf_external_law(inputs, rates);
    return is_clamped(mode) ? alone : sum(tdmf_servo(model, mode), alone);
}

tdmf_hip_law tdmf_vary_flight_law(const tdmf_model *model, const tdmf_mode *mode, const tdmf_direction *d) {
    const tdmf_hip_law alone = tdmf_external_law(&d->inputs, &tdmf_held_inputs);
    return is_clamped(mode) ? alone : sum(tdmf_vary_servo(model, mode, d), alone);
}

bool tdmf_clamp_has_no_derivative(const tdmf_model *model, const tdmf_mode *mode, const tdmf_direction *d) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d_p = &d->model.parameters;
    return mode->phase == TDMF_PHASE_RETRACT && p->hip.kp == 0.0 && p->hip.kd == 0.0 &&
           (d_p->hip.kp != 0.0 || d_p->hip.kd != 0.0);
}

/* ---- torque ------------------------------------------------------------------------------------------- */

double tdmf_law_torque(const tdmf_hip_law *law, const double state[TDMF_STATE_COUNT]) {
    return law->gain * (law->target - state[TDMF_LEG_ANGLE]) - law->rate_gain * state[TDMF_LEG_ANGLE_RATE] +
           law->torque;
}

double tdmf_vary_law_torque(const tdmf_hip_law *law, const tdmf_hip_law *d_law,
                            const double state[TDMF_STATE_COUNT], const double d_state[TDMF_STATE_COUNT]) {
    return d_law->gain * (law->target - state[TDMF_LEG_ANGLE]) +
           law->gain * (d_law->target - d_state[TDMF_LEG_ANGLE]) -
           d_law->rate_gain * state[TDMF_LEG_ANGLE_RATE] - law->rate_gain * d_state[TDMF_LEG_ANGLE_RATE] +
           d_law->torque;
}

double tdmf_hip_torque(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                       const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate(model, inputs, mode, state).torque;
}
