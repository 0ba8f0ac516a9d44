/* Guards of the automaton, each a pure number that is positive until its event is due. */
#include "tdmf_slip/automaton.h"

#include "cone.h"
#include "input_rates.h"
#include "leg.h"
#include "margins.h"
#include "tdmf_slip/hip.h"

static double armed(double value, double scale) {
    return value / scale + TDMF_GUARD_MARGIN;
}

/* For a sign that is remembered: `value` reaches the far edge of the dead band. */
static double armed_against_turning(double value, double scale, bool negative) {
    return (negative ? -value : value) / scale + TDMF_DEAD_BAND;
}

/* Height of the body and vertical velocity of the centre of mass, from one sine and cosine. */
static double body_height(const tdmf_leg *leg, const double state[TDMF_STATE_COUNT]) {
    return state[TDMF_FOOT_Y] + leg->length * leg->cosine;
}

static double body_rise(const tdmf_leg *leg, const double state[TDMF_STATE_COUNT]) {
    return state[TDMF_FOOT_VY] + leg->length_rate * leg->cosine - leg->length * leg->angle_rate * leg->sine;
}

static double center_of_mass_rise(const tdmf_model *model, const tdmf_leg *leg,
                                  const double state[TDMF_STATE_COUNT]) {
    const double share = model->parameters.body.mass / model->total_mass;
    return state[TDMF_FOOT_VY] + share * (body_rise(leg, state) - state[TDMF_FOOT_VY]);
}

static double press(const tdmf_model *model, const tdmf_inputs *inputs, double law, const tdmf_leg *leg) {
    return tdmf_leg_sticking_force(model, law + inputs->hip.external_torque, leg).fy;
}

static void guard_fall(const tdmf_model *model, const tdmf_leg *leg, const double state[TDMF_STATE_COUNT],
                       double guards[TDMF_GUARD_COUNT]) {
    const double length = model->scales.length;
    guards[TDMF_GUARD_BODY_DOWN] = armed(body_height(leg, state), length);
    guards[TDMF_GUARD_LEG_TOO_SHORT] = armed(leg->length - model->parameters.leg.min_length, length);
}

static void guard_apex(const tdmf_model *model, const tdmf_mode *mode, const tdmf_leg *leg,
                       const double state[TDMF_STATE_COUNT], double guards[TDMF_GUARD_COUNT]) {
    if (mode->phase == TDMF_PHASE_RETRACT) {
        guards[TDMF_GUARD_APEX] = armed(center_of_mass_rise(model, leg, state), model->scales.speed);
    }
}

static void guard_flight(const tdmf_model *model, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                         double guards[TDMF_GUARD_COUNT]) {
    guards[TDMF_GUARD_TOUCHDOWN] = armed(state[TDMF_FOOT_Y], model->scales.length);
    if (mode->phase == TDMF_PHASE_RETRACT) {
        guards[TDMF_GUARD_CLAMP] = armed_against_turning(tdmf_hip_retract_argument(model, mode, state),
                                                         model->scales.energy, mode->clamp_closed);
    }
}

static void guard_graze(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                        const tdmf_leg *leg, const double state[TDMF_STATE_COUNT],
                        double guards[TDMF_GUARD_COUNT]) {
    const double force = model->scales.force;
    const double stance = press(model, inputs, tdmf_hip_stance_law(model, mode), leg);
    const double flight = press(model, inputs, tdmf_hip_flight_law(model, mode, state), leg);
    guards[TDMF_GUARD_GRAZE_TO_CONTACT] = armed(-stance, force);
    guards[TDMF_GUARD_GRAZE_TO_FLIGHT] = armed(flight, force);
}

static void guard_contact(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                          const tdmf_leg *leg, const double state[TDMF_STATE_COUNT],
                          double guards[TDMF_GUARD_COUNT]) {
    const tdmf_scales *scales = &model->scales;
    const double torque = tdmf_leg_hip_torque(model, inputs, mode, state, leg);
    const tdmf_ground_force force = tdmf_leg_contact_force(model, inputs, mode, torque, leg);
    guards[TDMF_GUARD_LIFT_OFF] = armed(force.fy, scales->force);
    guards[TDMF_GUARD_FORCE_PEAK] =
        armed_against_turning(tdmf_leg_ground_force_rate(model, inputs, mode, state, leg),
                              scales->force / scales->time, !mode->ground_force_rising);
    if (mode->phase == TDMF_PHASE_DRIVE) {
        guards[TDMF_GUARD_MID_STANCE] = armed(state[TDMF_LEG_ANGLE], 1.0);
    }
    if (mode->contact == TDMF_CONTACT_STICK) {
        const tdmf_cone cone = tdmf_cone_of(inputs->ground.friction);
        const double limit = cone.normal * force.fy;
        const double pull = cone.tangential * force.fx;
        guards[TDMF_GUARD_SLIP_ONSET_POSITIVE] = armed(limit + pull, scales->force);
        guards[TDMF_GUARD_SLIP_ONSET_NEGATIVE] = armed(limit - pull, scales->force);
    } else {
        guards[TDMF_GUARD_SLIP_VELOCITY_ZERO] =
            armed(tdmf_slip_sign(mode) * state[TDMF_FOOT_VX], scales->speed);
    }
}

static void guard_all(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                      const tdmf_leg *leg, const double state[TDMF_STATE_COUNT],
                      double guards[TDMF_GUARD_COUNT]) {
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        guards[i] = 1.0;
    }
    guard_fall(model, leg, state, guards);
    if (tdmf_in_contact(mode)) {
        guard_contact(model, inputs, mode, leg, state, guards);
        return;
    }
    guard_apex(model, mode, leg, state, guards);
    if (mode->contact == TDMF_CONTACT_GRAZE) {
        guard_graze(model, inputs, mode, leg, state, guards);
    } else {
        guard_flight(model, mode, state, guards);
    }
}

/* ---- rates -------------------------------------------------------------------------------------------- */

/* Of the clamp's argument and, in place, of the torque itself. */
static double servo_rate(const tdmf_model *model, const double derivatives[TDMF_STATE_COUNT]) {
    return -model->parameters.hip.kp * derivatives[TDMF_LEG_ANGLE] -
           model->parameters.hip.kd * derivatives[TDMF_LEG_ANGLE_RATE];
}

static double flight_law_rate(const tdmf_model *model, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT],
                              const double derivatives[TDMF_STATE_COUNT]) {
    const bool clamped =
        mode->phase == TDMF_PHASE_RETRACT && tdmf_hip_retract_argument(model, mode, state) <= 0.0;
    return clamped ? 0.0 : servo_rate(model, derivatives);
}

static void rate_flight(const tdmf_model *model, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                        const double derivatives[TDMF_STATE_COUNT], double rates[TDMF_GUARD_COUNT]) {
    rates[TDMF_GUARD_TOUCHDOWN] = state[TDMF_FOOT_VY] / model->scales.length;
    if (mode->phase == TDMF_PHASE_RETRACT) {
        const double sign = mode->clamp_closed ? -1.0 : 1.0;
        rates[TDMF_GUARD_CLAMP] = sign * servo_rate(model, derivatives) / model->scales.energy;
    }
}

static void rate_graze(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_inputs *input_rates,
                       const tdmf_mode *mode, const tdmf_leg *leg, const double state[TDMF_STATE_COUNT],
                       const double derivatives[TDMF_STATE_COUNT], double rates[TDMF_GUARD_COUNT]) {
    const double force = model->scales.force;
    const double external = inputs->hip.external_torque;
    const double external_rate = input_rates->hip.external_torque;
    const double acceleration = derivatives[TDMF_LEG_LENGTH_RATE];
    const double stance = tdmf_hip_stance_law(model, mode) + external;
    const double flight = tdmf_hip_flight_law(model, mode, state) + external;
    const double flight_rate = flight_law_rate(model, mode, state, derivatives) + external_rate;
    rates[TDMF_GUARD_GRAZE_TO_CONTACT] =
        -tdmf_leg_sticking_force_rate(model, stance, external_rate, acceleration, leg).fy / force;
    rates[TDMF_GUARD_GRAZE_TO_FLIGHT] =
        tdmf_leg_sticking_force_rate(model, flight, flight_rate, acceleration, leg).fy / force;
}

static void rate_contact(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_inputs *input_rates,
                         const tdmf_mode *mode, const tdmf_leg *leg, const double state[TDMF_STATE_COUNT],
                         const double derivatives[TDMF_STATE_COUNT], double rates[TDMF_GUARD_COUNT]) {
    const tdmf_scales *scales = &model->scales;
    const double torque = tdmf_leg_hip_torque(model, inputs, mode, state, leg);
    const tdmf_ground_force rate = tdmf_leg_sticking_force_rate(
        model, torque, input_rates->hip.external_torque, derivatives[TDMF_LEG_LENGTH_RATE], leg);
    rates[TDMF_GUARD_LIFT_OFF] = rate.fy / scales->force;
    if (mode->phase == TDMF_PHASE_DRIVE) {
        rates[TDMF_GUARD_MID_STANCE] = state[TDMF_LEG_ANGLE_RATE];
    }
    if (mode->contact == TDMF_CONTACT_STICK) {
        const tdmf_ground_force force = tdmf_leg_sticking_force(model, torque, leg);
        const tdmf_cone cone = tdmf_cone_of(inputs->ground.friction);
        const tdmf_cone cone_rate = tdmf_cone_rate(inputs->ground.friction, input_rates->ground.friction);
        const double limit_rate = cone.normal * rate.fy + cone_rate.normal * force.fy;
        const double pull_rate = cone.tangential * rate.fx + cone_rate.tangential * force.fx;
        rates[TDMF_GUARD_SLIP_ONSET_POSITIVE] = (limit_rate + pull_rate) / scales->force;
        rates[TDMF_GUARD_SLIP_ONSET_NEGATIVE] = (limit_rate - pull_rate) / scales->force;
    } else {
        rates[TDMF_GUARD_SLIP_VELOCITY_ZERO] =
            tdmf_slip_sign(mode) * derivatives[TDMF_FOOT_VX] / scales->speed;
    }
}

static void rate_all(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_inputs *input_rates,
                     const tdmf_mode *mode, const tdmf_leg *leg, const double state[TDMF_STATE_COUNT],
                     const double derivatives[TDMF_STATE_COUNT], double rates[TDMF_GUARD_COUNT]) {
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        rates[i] = 0.0;
    }
    rates[TDMF_GUARD_BODY_DOWN] = body_rise(leg, state) / model->scales.length;
    rates[TDMF_GUARD_LEG_TOO_SHORT] = leg->length_rate / model->scales.length;
    if (tdmf_in_contact(mode)) {
        rate_contact(model, inputs, input_rates, mode, leg, state, derivatives, rates);
        return;
    }
    if (mode->phase == TDMF_PHASE_RETRACT) {
        rates[TDMF_GUARD_APEX] = -model->parameters.gravity / model->scales.speed;
    }
    if (mode->contact == TDMF_CONTACT_GRAZE) {
        rate_graze(model, inputs, input_rates, mode, leg, state, derivatives, rates);
    } else {
        rate_flight(model, mode, state, derivatives, rates);
    }
}

void tdmf_leg_guards(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                     const double state[TDMF_STATE_COUNT], const tdmf_leg *leg,
                     double guards[TDMF_GUARD_COUNT]) {
    if (mode->fallen) {
        for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
            guards[i] = 1.0;
        }
        return;
    }
    guard_all(model, inputs, mode, leg, state, guards);
}

void tdmf_guards(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                 const double state[TDMF_STATE_COUNT], double guards[TDMF_GUARD_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, state);
    tdmf_leg_guards(model, inputs, mode, state, &leg, guards);
}

tdmf_watch tdmf_watch_guards(const tdmf_model *model, const tdmf_inputs *inputs,
                             const tdmf_inputs *input_rates, const tdmf_mode *mode,
                             const double state[TDMF_STATE_COUNT],
                             const double derivatives[TDMF_STATE_COUNT]) {
    tdmf_watch watch;
    const tdmf_leg leg = tdmf_leg_of(model, state);
    guard_all(model, inputs, mode, &leg, state, watch.value);
    rate_all(model, inputs, tdmf_rates_or_held(input_rates), mode, &leg, state, derivatives, watch.rate);
    return watch;
}
