/* Guards of the automaton, each a pure number that is positive until its event is due. */
#include "tdmf_slip/automaton.h"

#include "tdmf_slip/contact.h"
#include "tdmf_slip/dynamics.h"
#include "tdmf_slip/graze.h"
#include "tdmf_slip/hip.h"
#include "tdmf_slip/kinematics.h"

/* Half-width of the band around zero in which a quantity that may settle there counts as unchanged. */
static const double dead_band = 1e-10;

static double armed(double value, double scale) {
    return value / scale + TDMF_GUARD_MARGIN;
}

/* For a sign that is remembered: `value` reaches the far edge of the dead band. */
static double armed_against_turning(double value, double scale, bool negative) {
    return (negative ? -value : value) / scale + dead_band;
}

static void guard_fall(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                       double guards[TDMF_GUARD_COUNT]) {
    const double length = model->scales.length;
    guards[TDMF_GUARD_BODY_DOWN] = armed(tdmf_body(state).y, length);
    guards[TDMF_GUARD_LEG_TOO_SHORT] =
        armed(state[TDMF_LEG_LENGTH] - model->parameters.leg.min_length, length);
}

static void guard_apex(const tdmf_model *model, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                       double guards[TDMF_GUARD_COUNT]) {
    if (mode->phase == TDMF_PHASE_RETRACT) {
        guards[TDMF_GUARD_APEX] = armed(tdmf_center_of_mass(model, state).vy, model->scales.speed);
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
                        const double state[TDMF_STATE_COUNT], double guards[TDMF_GUARD_COUNT]) {
    const double force = model->scales.force;
    guards[TDMF_GUARD_GRAZE_TO_CONTACT] = armed(-tdmf_stance_press(model, inputs, mode, state), force);
    guards[TDMF_GUARD_GRAZE_TO_FLIGHT] = armed(tdmf_flight_press(model, inputs, mode, state), force);
}

static void guard_contact(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                          const double state[TDMF_STATE_COUNT], double guards[TDMF_GUARD_COUNT]) {
    const tdmf_scales *scales = &model->scales;
    const tdmf_ground_force force = tdmf_contact_force(model, inputs, mode, state);
    guards[TDMF_GUARD_LIFT_OFF] = armed(force.fy, scales->force);
    guards[TDMF_GUARD_FORCE_PEAK] =
        armed_against_turning(tdmf_ground_force_rate(model, inputs, mode, state),
                              scales->force / scales->time, !mode->ground_force_rising);
    if (mode->phase == TDMF_PHASE_DRIVE) {
        guards[TDMF_GUARD_MID_STANCE] = armed(state[TDMF_LEG_ANGLE], 1.0);
    }
    if (mode->contact == TDMF_CONTACT_STICK) {
        const double limit = inputs->ground.friction * force.fy;
        guards[TDMF_GUARD_SLIP_ONSET_POSITIVE] = armed(limit + force.fx, scales->force);
        guards[TDMF_GUARD_SLIP_ONSET_NEGATIVE] = armed(limit - force.fx, scales->force);
    } else {
        guards[TDMF_GUARD_SLIP_VELOCITY_ZERO] =
            armed(tdmf_slip_sign(mode) * state[TDMF_FOOT_VX], scales->speed);
    }
}

void tdmf_guards(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                 const double state[TDMF_STATE_COUNT], double guards[TDMF_GUARD_COUNT]) {
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        guards[i] = 1.0;
    }
    if (mode->fallen) {
        return;
    }
    guard_fall(model, state, guards);
    if (tdmf_in_contact(mode)) {
        guard_contact(model, inputs, mode, state, guards);
        return;
    }
    guard_apex(model, mode, state, guards);
    if (mode->contact == TDMF_CONTACT_GRAZE) {
        guard_graze(model, inputs, mode, state, guards);
    } else {
        guard_flight(model, mode, state, guards);
    }
}
