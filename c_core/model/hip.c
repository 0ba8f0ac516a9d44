/* The hip torque. What the paper prints, with the corrections that its text and its gaits ask for:
 *
 *     stance (11):  tau = -tau0 from touchdown with theta >= 0 to mid-stance, then 0
 *     retract (12): tau = max{ -kp (theta - eta theta_LO) - kd thetadot, 0 }     while vy_c >= 0
 *     place (12):   tau = -kp (theta - theta_ref) - kd (thetadot + omega)        from the apex on
 *
 * The sign in (11) is turned, because theta falls in forward running and only a negative torque then does
 * positive work; min in (12) is a max, because the text asks for a positive torque that stops the leg's
 * backward rotation. The drive happens once per stance: were it to return with theta, it could switch for
 * ever.
 *
 * In place the leg is retracted before it lands: theta_ref = theta0 - omega s, with s the time since place
 * began. The paper has omega = 0.
 *
 * The clamp's kink is located like an event: in flight the law is smooth while mode->clamp_closed stands. */
#include "tdmf_slip/hip.h"

#include "evaluation.h"
#include "ground_force.h"
#include "hip_law.h"
#include "hip_torque.h"
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

static tdmf_hip_law retract(const tdmf_parameters *p, double liftoff_angle) {
    const tdmf_hip_law law = {
        .gain = p->hip.kp, .rate_gain = p->hip.kd, .target = p->hip.liftoff_angle_factor * liftoff_angle};
    return law;
}

static tdmf_hip_law vary_retract(const tdmf_parameters *p, double liftoff_angle, const tdmf_parameters *d_p,
                                 double d_liftoff_angle) {
    tdmf_hip_law d_law = retract(d_p, liftoff_angle);
    d_law.target += p->hip.liftoff_angle_factor * d_liftoff_angle;
    return d_law;
}

static tdmf_hip_law place(const tdmf_parameters *p, double place_time) {
    const tdmf_hip_law law = {.gain = p->hip.kp,
                              .rate_gain = p->hip.kd,
                              .target = p->hip.touchdown_angle - p->hip.retraction_rate * place_time,
                              .target_rate = -p->hip.retraction_rate,
                              .torque = -p->hip.kd * p->hip.retraction_rate};
    return law;
}

static tdmf_hip_law vary_place(const tdmf_parameters *p, double place_time, const tdmf_parameters *d_p,
                               double d_place_time) {
    tdmf_hip_law d_law = place(d_p, place_time);
    d_law.target -= p->hip.retraction_rate * d_place_time;
    d_law.torque = -d_p->hip.kd * p->hip.retraction_rate - p->hip.kd * d_p->hip.retraction_rate;
    return d_law;
}

tdmf_hip_law tdmf_servo(const tdmf_model *model, const tdmf_mode *mode, double place_time) {
    return mode->phase == TDMF_PHASE_PLACE ? place(&model->parameters, place_time)
                                           : retract(&model->parameters, mode->liftoff_angle);
}

tdmf_hip_law tdmf_vary_servo(const tdmf_model *model, const tdmf_mode *mode, double place_time,
                             const tdmf_direction *d) {
    const tdmf_parameters *p = &model->parameters, *d_p = &d->model.parameters;
    return mode->phase == TDMF_PHASE_PLACE ? vary_place(p, place_time, d_p, d->state[TDMF_HIP_PLACE_TIME])
                                           : vary_retract(p, mode->liftoff_angle, d_p, d->mode.liftoff_angle);
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
                             const tdmf_mode *mode, double place_time) {
    const tdmf_hip_law alone = tdmf_external_law(inputs, rates);
    return is_clamped(mode) ? alone : sum(tdmf_servo(model, mode, place_time), alone);
}

tdmf_hip_law tdmf_vary_flight_law(const tdmf_model *model, const tdmf_mode *mode, double place_time,
                                  const tdmf_direction *d) {
    const tdmf_hip_law alone = tdmf_external_law(&d->inputs, &tdmf_held_inputs);
    return is_clamped(mode) ? alone : sum(tdmf_vary_servo(model, mode, place_time, d), alone);
}

bool tdmf_clamp_has_no_derivative(const tdmf_model *model, const tdmf_mode *mode, const tdmf_direction *d) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d_p = &d->model.parameters;
    return mode->phase == TDMF_PHASE_RETRACT && p->hip.kp == 0.0 && p->hip.kd == 0.0 &&
           (d_p->hip.kp != 0.0 || d_p->hip.kd != 0.0);
}

/* ---- time -----------------------------------------------------------------------------------------------
 */

double tdmf_vary_law_drift(const tdmf_hip_law *law, const tdmf_hip_law *d_law) {
    return d_law->torque_rate + d_law->gain * law->target_rate + law->gain * d_law->target_rate;
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

double tdmf_servo_torque(const tdmf_model *model, const tdmf_mode *mode,
                         const double state[TDMF_STATE_COUNT]) {
    const tdmf_hip_law servo = tdmf_servo(model, mode, state[TDMF_HIP_PLACE_TIME]);
    return tdmf_law_torque(&servo, state);
}

double tdmf_vary_servo_torque(const tdmf_model *model, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT], const tdmf_direction *d) {
    const tdmf_hip_law servo = tdmf_servo(model, mode, state[TDMF_HIP_PLACE_TIME]);
    const tdmf_hip_law d_servo = tdmf_vary_servo(model, mode, state[TDMF_HIP_PLACE_TIME], d);
    return tdmf_vary_law_torque(&servo, &d_servo, state, d->state);
}

double tdmf_stance_torque(const tdmf_evaluation *at) {
    const tdmf_hip_law law = tdmf_stance_law(at->model, at->inputs, &tdmf_held_inputs, at->mode);
    return tdmf_law_torque(&law, at->state);
}

double tdmf_vary_stance_torque(const tdmf_evaluation *at, const tdmf_direction *d) {
    const tdmf_hip_law law = tdmf_stance_law(at->model, at->inputs, &tdmf_held_inputs, at->mode);
    const tdmf_hip_law d_law = tdmf_vary_stance_law(at->mode, d);
    return tdmf_vary_law_torque(&law, &d_law, at->state, d->state);
}

double tdmf_flight_torque(const tdmf_evaluation *at, const tdmf_mode *mode) {
    const tdmf_hip_law law =
        tdmf_flight_law(at->model, at->inputs, &tdmf_held_inputs, mode, at->state[TDMF_HIP_PLACE_TIME]);
    return tdmf_law_torque(&law, at->state);
}

double tdmf_vary_flight_torque(const tdmf_evaluation *at, const tdmf_mode *mode, const tdmf_direction *d) {
    const tdmf_hip_law law =
        tdmf_flight_law(at->model, at->inputs, &tdmf_held_inputs, mode, at->state[TDMF_HIP_PLACE_TIME]);
    const tdmf_hip_law d_law = tdmf_vary_flight_law(at->model, mode, at->state[TDMF_HIP_PLACE_TIME], d);
    return tdmf_vary_law_torque(&law, &d_law, at->state, d->state);
}

double tdmf_torque_in_mode(const tdmf_evaluation *at) {
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return tdmf_graze_torque(at);
    case TDMF_CONTACT_FLIGHT:
        return tdmf_flight_torque(at, at->mode);
    default:
        return tdmf_stance_torque(at);
    }
}

double tdmf_vary_torque_in_mode(const tdmf_evaluation *at, const tdmf_leg *d_leg, const tdmf_direction *d) {
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return tdmf_vary_graze_torque(at, d_leg, d);
    case TDMF_CONTACT_FLIGHT:
        return tdmf_vary_flight_torque(at, at->mode, d);
    default:
        return tdmf_vary_stance_torque(at, d);
    }
}

double tdmf_hip_torque(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                       const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate(model, inputs, mode, state).torque;
}
