/* The hip's law. What the paper prints, with the corrections that its text and its gaits ask for:
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
 * began. The paper has omega = 0. The control inputs add to theta0 and tau0.
 *
 * The clamp's kink is located like an event: in flight the law is smooth while mode->clamp_closed stands.
 *
 * So in every phase the law is affine in the leg's angle, its rate and time, and is data:
 *
 *     tau = gain (target + target_rate t - theta) - rate_gain thetadot + torque + torque_rate t,
 *
 * with t counted from now. */
#ifndef TDMF_MODEL_HIP_LAW_H
#define TDMF_MODEL_HIP_LAW_H

#include "direction.h"
#include "input_rates.h"

typedef struct {
    double gain, rate_gain; /* N.m/rad, N.m.s/rad */
    double target;          /* rad */
    double target_rate;     /* rad/s */
    double torque;          /* N.m */
    double torque_rate;     /* N.m/s */
} tdmf_hip_law;

/* The torque from outside alone. `rates` are those of the inputs. */
static inline tdmf_hip_law tdmf_external_law(const tdmf_inputs *inputs, const tdmf_inputs *rates) {
    const tdmf_hip_law law = {.torque = inputs->hip.external_torque,
                              .torque_rate = rates->hip.external_torque};
    return law;
}

/* ---- stance (11) -------------------------------------------------------------------------------------- */

/* On a loaded foot, with the external torque. */
static inline tdmf_hip_law tdmf_stance_law(const tdmf_model *model, const tdmf_inputs *inputs,
                                           const tdmf_inputs *rates, const tdmf_mode *mode) {
    tdmf_hip_law law = tdmf_external_law(inputs, rates);
    law.torque -=
        mode->mid_stance_pending ? model->parameters.hip.stance_torque + inputs->control.stance_torque : 0.0;
    return law;
}

/* The law is linear in what it is made of. */
static inline tdmf_hip_law tdmf_vary_stance_law(const tdmf_mode *mode, const tdmf_direction *d) {
    return tdmf_stance_law(&d->model, &d->inputs, &tdmf_held_inputs, mode);
}

/* ---- flight (12) -------------------------------------------------------------------------------------- */

static inline tdmf_hip_law tdmf_retract_law(const tdmf_parameters *p, double liftoff_angle) {
    const tdmf_hip_law law = {
        .gain = p->hip.kp, .rate_gain = p->hip.kd, .target = p->hip.liftoff_angle_factor * liftoff_angle};
    return law;
}

static inline tdmf_hip_law tdmf_vary_retract_law(const tdmf_parameters *p, double liftoff_angle,
                                                 const tdmf_parameters *d_p, double d_liftoff_angle) {
    tdmf_hip_law d_law = tdmf_retract_law(d_p, liftoff_angle);
    d_law.target += p->hip.liftoff_angle_factor * d_liftoff_angle;
    return d_law;
}

static inline tdmf_hip_law tdmf_place_law(const tdmf_parameters *p, const tdmf_inputs *inputs,
                                          double place_time) {
    const double touchdown_angle = p->hip.touchdown_angle + inputs->control.touchdown_angle;
    const tdmf_hip_law law = {.gain = p->hip.kp,
                              .rate_gain = p->hip.kd,
                              .target = touchdown_angle - p->hip.retraction_rate * place_time,
                              .target_rate = -p->hip.retraction_rate,
                              .torque = -p->hip.kd * p->hip.retraction_rate};
    return law;
}

static inline tdmf_hip_law tdmf_vary_place_law(const tdmf_parameters *p, double place_time,
                                               const tdmf_parameters *d_p, const tdmf_inputs *d_inputs,
                                               double d_place_time) {
    tdmf_hip_law d_law = tdmf_place_law(d_p, d_inputs, place_time);
    d_law.target -= p->hip.retraction_rate * d_place_time;
    d_law.torque = -d_p->hip.kd * p->hip.retraction_rate - p->hip.kd * d_p->hip.retraction_rate;
    return d_law;
}

/* How fast the time since place began runs: 1 in place, else 0. */
static inline double tdmf_place_time_rate(const tdmf_mode *mode) {
    return mode->phase == TDMF_PHASE_PLACE ? 1.0 : 0.0;
}

/* The servo alone: its torque is what the clamp is decided by. `place_time` is the time since place began, if
 * it has. */
static inline tdmf_hip_law tdmf_servo(const tdmf_model *model, const tdmf_inputs *inputs,
                                      const tdmf_mode *mode, double place_time) {
    return mode->phase == TDMF_PHASE_PLACE ? tdmf_place_law(&model->parameters, inputs, place_time)
                                           : tdmf_retract_law(&model->parameters, mode->liftoff_angle);
}

static inline tdmf_hip_law tdmf_vary_servo(const tdmf_model *model, const tdmf_mode *mode, double place_time,
                                           const tdmf_direction *d) {
    const tdmf_parameters *p = &model->parameters, *d_p = &d->model.parameters;
    return mode->phase == TDMF_PHASE_PLACE
               ? tdmf_vary_place_law(p, place_time, d_p, &d->inputs, d->state[TDMF_HIP_PLACE_TIME])
               : tdmf_vary_retract_law(p, mode->liftoff_angle, d_p, d->mode.liftoff_angle);
}

static inline bool tdmf_is_clamped(const tdmf_mode *mode) {
    return mode->phase != TDMF_PHASE_PLACE && mode->clamp_closed;
}

static inline tdmf_hip_law tdmf_sum_of_laws(tdmf_hip_law a, tdmf_hip_law b) {
    a.torque += b.torque;
    a.torque_rate += b.torque_rate;
    return a;
}

/* Off the ground, with the external torque and the clamp as the mode has it. */
static inline tdmf_hip_law tdmf_flight_law(const tdmf_model *model, const tdmf_inputs *inputs,
                                           const tdmf_inputs *rates, const tdmf_mode *mode,
                                           double place_time) {
    const tdmf_hip_law alone = tdmf_external_law(inputs, rates);
    return tdmf_is_clamped(mode) ? alone
                                 : tdmf_sum_of_laws(tdmf_servo(model, inputs, mode, place_time), alone);
}

/* The clamp is held. */
static inline tdmf_hip_law tdmf_vary_flight_law(const tdmf_model *model, const tdmf_mode *mode,
                                                double place_time, const tdmf_direction *d) {
    const tdmf_hip_law alone = tdmf_external_law(&d->inputs, &tdmf_held_inputs);
    return tdmf_is_clamped(mode) ? alone
                                 : tdmf_sum_of_laws(tdmf_vary_servo(model, mode, place_time, d), alone);
}

/* The servo is zero whatever the leg does, but not along the direction: no derivative tells what the clamp
 * makes of it. */
bool tdmf_clamp_has_no_derivative(const tdmf_model *model, const tdmf_mode *mode, const tdmf_direction *d);

/* ---- time --------------------------------------------------------------------------------------------- */

/* Makes it the law some time later. */
static inline void tdmf_shift_law(tdmf_hip_law *law, double elapsed) {
    law->target += elapsed * law->target_rate;
    law->torque += elapsed * law->torque_rate;
}

static inline bool tdmf_law_drifts(const tdmf_hip_law *law) {
    return law->target_rate != 0.0 || law->torque_rate != 0.0;
}

/* How fast the torque of a law changes while the leg stands still, N.m/s, and its change. */
static inline double tdmf_law_drift(const tdmf_hip_law *law) {
    return law->torque_rate + law->gain * law->target_rate;
}

static inline double tdmf_vary_law_drift(const tdmf_hip_law *law, const tdmf_hip_law *d_law) {
    return d_law->torque_rate + d_law->gain * law->target_rate + law->gain * d_law->target_rate;
}

/* ---- torque ------------------------------------------------------------------------------------------- */

/* The torque that a law applies now, N.m, and its change. */
static inline double tdmf_law_torque(const tdmf_hip_law *law, const double state[TDMF_STATE_COUNT]) {
    return law->gain * (law->target - state[TDMF_LEG_ANGLE]) - law->rate_gain * state[TDMF_LEG_ANGLE_RATE] +
           law->torque;
}

static inline double tdmf_vary_law_torque(const tdmf_hip_law *law, const tdmf_hip_law *d_law,
                                          const double state[TDMF_STATE_COUNT],
                                          const double d_state[TDMF_STATE_COUNT]) {
    return d_law->gain * (law->target - state[TDMF_LEG_ANGLE]) +
           law->gain * (d_law->target - d_state[TDMF_LEG_ANGLE]) -
           d_law->rate_gain * state[TDMF_LEG_ANGLE_RATE] - law->rate_gain * d_state[TDMF_LEG_ANGLE_RATE] +
           d_law->torque;
}

#endif
