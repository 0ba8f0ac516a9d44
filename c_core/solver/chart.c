/* From state to coordinates and back. */
#include "chart.h"

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/hip.h"
#include "tdmf_slip/kinematics.h"

#include <math.h>

static void open_flight(tdmf_chart *chart, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    const tdmf_parameters *p = &chart->model->parameters;
    const tdmf_point com = tdmf_center_of_mass(chart->model, state);
    const bool retracts = mode->phase == TDMF_PHASE_RETRACT;
    const double servo = retracts && mode->clamp_closed ? 0.0 : 1.0;
    chart->angle_target =
        retracts ? p->hip.liftoff_angle_factor * mode->liftoff_angle : p->hip.touchdown_angle;
    chart->angle_gain = servo * p->hip.kp;
    chart->rate_gain = servo * p->hip.kd;
    chart->com_x = com.x;
    chart->com_y = com.y;
    chart->com_vx = com.vx;
    chart->com_vy = com.vy;
}

void tdmf_chart_open(tdmf_chart *chart, const tdmf_model *model, const tdmf_inputs *inputs,
                     const tdmf_input_rates *rates, const tdmf_mode *mode,
                     const double state[TDMF_STATE_COUNT], double z[CHART_COUNT]) {
    const tdmf_chart blank = {.model = model};
    const bool loaded = tdmf_in_contact(mode);
    *chart = blank;
    chart->in_flight = mode->contact == TDMF_CONTACT_FLIGHT;
    chart->grazes = mode->contact == TDMF_CONTACT_GRAZE;
    chart->torque = inputs->hip.external_torque + (loaded ? tdmf_hip_stance_law(model, mode) : 0.0);
    chart->torque_rate = rates->external_torque;
    chart->signed_friction = tdmf_slip_sign(mode) * inputs->ground.friction;
    chart->signed_friction_rate = tdmf_slip_sign(mode) * rates->friction;
    chart->foot_is_free = mode->contact == TDMF_CONTACT_STICK ? 0.0 : 1.0;
    chart->foot_weight = model->parameters.foot.mass * model->parameters.gravity;
    chart->leg_floor = 0.5 * model->parameters.leg.min_length;
    chart->positive_work = state[TDMF_HIP_POSITIVE_WORK];
    if (chart->in_flight) {
        open_flight(chart, mode, state);
    }
    z[CHART_LEG_LENGTH] = state[TDMF_LEG_LENGTH];
    z[CHART_LEG_ANGLE] = state[TDMF_LEG_ANGLE];
    z[CHART_LEG_LENGTH_RATE] = state[TDMF_LEG_LENGTH_RATE];
    z[CHART_LEG_ANGLE_RATE] = state[TDMF_LEG_ANGLE_RATE];
    z[CHART_HIP_WORK] = state[TDMF_HIP_WORK];
    z[CHART_DAMPER_LOSS] = state[TDMF_ENERGY_DAMPER_LOSS];
    z[CHART_FOOT_X] = state[TDMF_FOOT_X];
    z[CHART_FOOT_VX] = state[TDMF_FOOT_VX];
    z[CHART_FRICTION_LOSS] = state[TDMF_ENERGY_FRICTION_LOSS];
    z[CHART_UNUSED] = 0.0;
}

void tdmf_chart_shift(tdmf_chart *chart, double elapsed) {
    const double g = chart->model->parameters.gravity;
    chart->torque += elapsed * chart->torque_rate;
    chart->signed_friction += elapsed * chart->signed_friction_rate;
    chart->com_x += elapsed * chart->com_vx;
    chart->com_y += elapsed * (chart->com_vy - 0.5 * g * elapsed);
    chart->com_vy -= g * elapsed;
}

/* The foot hangs below the ballistic centre of mass, at the body's share of the leg. */
static void place_flying_foot(const tdmf_chart *chart, double elapsed, const double z[CHART_COUNT],
                              double state[TDMF_STATE_COUNT]) {
    const double g = chart->model->parameters.gravity;
    const double share = chart->model->parameters.body.mass / chart->model->total_mass;
    const double sine = sin(z[CHART_LEG_ANGLE]);
    const double cosine = cos(z[CHART_LEG_ANGLE]);
    const double along = share * z[CHART_LEG_LENGTH_RATE];
    const double across = share * z[CHART_LEG_LENGTH] * z[CHART_LEG_ANGLE_RATE];
    state[TDMF_FOOT_X] = chart->com_x + elapsed * chart->com_vx + share * z[CHART_LEG_LENGTH] * sine;
    state[TDMF_FOOT_Y] =
        chart->com_y + elapsed * (chart->com_vy - 0.5 * g * elapsed) - share * z[CHART_LEG_LENGTH] * cosine;
    state[TDMF_FOOT_VX] = chart->com_vx + along * sine + across * cosine;
    state[TDMF_FOOT_VY] = chart->com_vy - g * elapsed - along * cosine + across * sine;
}

void tdmf_chart_state(const tdmf_chart *chart, double elapsed, const double z[CHART_COUNT],
                      double state[TDMF_STATE_COUNT]) {
    state[TDMF_LEG_LENGTH] = z[CHART_LEG_LENGTH];
    state[TDMF_LEG_ANGLE] = z[CHART_LEG_ANGLE];
    state[TDMF_LEG_LENGTH_RATE] = z[CHART_LEG_LENGTH_RATE];
    state[TDMF_LEG_ANGLE_RATE] = z[CHART_LEG_ANGLE_RATE];
    state[TDMF_HIP_WORK] = z[CHART_HIP_WORK];
    state[TDMF_ENERGY_DAMPER_LOSS] = z[CHART_DAMPER_LOSS];
    state[TDMF_ENERGY_FRICTION_LOSS] = z[CHART_FRICTION_LOSS];
    state[TDMF_HIP_POSITIVE_WORK] = chart->positive_work;
    if (chart->in_flight) {
        place_flying_foot(chart, elapsed, z, state);
    } else {
        state[TDMF_FOOT_X] = z[CHART_FOOT_X];
        state[TDMF_FOOT_Y] = 0.0;
        state[TDMF_FOOT_VX] = z[CHART_FOOT_VX];
        state[TDMF_FOOT_VY] = 0.0;
    }
}
