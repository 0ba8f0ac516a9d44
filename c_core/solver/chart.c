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
    chart->target = retracts ? p->hip.liftoff_angle_factor * mode->liftoff_angle : p->hip.touchdown_angle;
    chart->gain = servo * p->hip.kp;
    chart->rate_gain = servo * p->hip.kd;
    chart->com_x = com.x;
    chart->com_y = com.y;
    chart->com_vx = com.vx;
    chart->com_vy = com.vy;
}

static double angle_seen(double x, double y) {
    return atan2(-x, y);
}

/* A leg that has wound past a half turn in flight stays wound. */
static double turns_of(double angle, const tdmf_coordinates *at) {
    static const double turn = 6.283185307179586;
    const bool seen_as_it_is = fabs(angle) < 0.49 * turn;
    return seen_as_it_is ? 0.0 : turn * round((angle - angle_seen(at->x, at->y)) / turn);
}

static void open_ground(tdmf_chart *chart, const double state[TDMF_STATE_COUNT]) {
    tdmf_coordinates *at = &chart->start;
    const double sine = sin(state[TDMF_LEG_ANGLE]);
    const double cosine = cos(state[TDMF_LEG_ANGLE]);
    const double along = state[TDMF_LEG_LENGTH_RATE];
    const double across = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    at->x = -state[TDMF_LEG_LENGTH] * sine;
    at->y = state[TDMF_LEG_LENGTH] * cosine;
    at->foot_x = state[TDMF_FOOT_X];
    at->foot_vx = state[TDMF_FOOT_VX];
    at->vx = at->foot_vx - along * sine - across * cosine;
    at->vy = along * cosine - across * sine;
    chart->turn = turns_of(state[TDMF_LEG_ANGLE], at);
}

void tdmf_chart_open(tdmf_chart *chart, const tdmf_model *model, const tdmf_inputs *inputs,
                     const tdmf_inputs *rates, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    const tdmf_chart blank = {.model = model, .contact = mode->contact};
    *chart = blank;
    chart->torque = inputs->hip.external_torque;
    chart->torque_rate = rates->hip.external_torque;
    if (tdmf_in_contact(mode)) {
        chart->torque += tdmf_hip_stance_law(model, mode);
    }
    chart->friction = tdmf_slip_sign(mode) * inputs->ground.friction;
    chart->friction_rate = tdmf_slip_sign(mode) * rates->ground.friction;
    chart->positive_work = state[TDMF_HIP_POSITIVE_WORK];
    chart->start.length = state[TDMF_LEG_LENGTH];
    chart->start.angle = state[TDMF_LEG_ANGLE];
    chart->start.length_rate = state[TDMF_LEG_LENGTH_RATE];
    chart->start.angle_rate = state[TDMF_LEG_ANGLE_RATE];
    chart->start.work = state[TDMF_HIP_WORK];
    chart->start.damper_loss = state[TDMF_ENERGY_DAMPER_LOSS];
    chart->start.friction_loss = state[TDMF_ENERGY_FRICTION_LOSS];
    if (mode->contact == TDMF_CONTACT_FLIGHT) {
        open_flight(chart, mode, state);
    } else {
        open_ground(chart, state);
    }
}

void tdmf_chart_shift(tdmf_chart *chart, double elapsed, const tdmf_coordinates *reached) {
    const double g = chart->model->parameters.gravity;
    chart->start = *reached;
    chart->torque += elapsed * chart->torque_rate;
    chart->friction += elapsed * chart->friction_rate;
    chart->com_x += elapsed * chart->com_vx;
    chart->com_y += elapsed * (chart->com_vy - 0.5 * g * elapsed);
    chart->com_vy -= g * elapsed;
}

/* The foot hangs below the ballistic centre of mass, at the body's share of the leg. */
static void place_flying_foot(const tdmf_chart *chart, double elapsed, const tdmf_coordinates *at,
                              double state[TDMF_STATE_COUNT]) {
    const double g = chart->model->parameters.gravity;
    const double share = chart->model->parameters.body.mass / chart->model->total_mass;
    const double sine = sin(at->angle);
    const double cosine = cos(at->angle);
    const double along = share * at->length_rate;
    const double across = share * at->length * at->angle_rate;
    state[TDMF_FOOT_X] = chart->com_x + elapsed * chart->com_vx + share * at->length * sine;
    state[TDMF_FOOT_Y] =
        chart->com_y + elapsed * (chart->com_vy - 0.5 * g * elapsed) - share * at->length * cosine;
    state[TDMF_FOOT_VX] = chart->com_vx + along * sine + across * cosine;
    state[TDMF_FOOT_VY] = chart->com_vy - g * elapsed - along * cosine + across * sine;
    state[TDMF_LEG_LENGTH] = at->length;
    state[TDMF_LEG_ANGLE] = at->angle;
    state[TDMF_LEG_LENGTH_RATE] = at->length_rate;
    state[TDMF_LEG_ANGLE_RATE] = at->angle_rate;
}

static void place_standing_leg(const tdmf_chart *chart, const tdmf_coordinates *at,
                               double state[TDMF_STATE_COUNT]) {
    const double vx = at->vx - at->foot_vx;
    const double length = sqrt(at->x * at->x + at->y * at->y);
    state[TDMF_FOOT_X] = at->foot_x;
    state[TDMF_FOOT_Y] = 0.0;
    state[TDMF_FOOT_VX] = at->foot_vx;
    state[TDMF_FOOT_VY] = 0.0;
    state[TDMF_LEG_LENGTH] = length;
    state[TDMF_LEG_ANGLE] = angle_seen(at->x, at->y) + chart->turn;
    state[TDMF_LEG_LENGTH_RATE] = (at->x * vx + at->y * at->vy) / length;
    state[TDMF_LEG_ANGLE_RATE] = (at->x * at->vy - at->y * vx) / (length * length);
}

void tdmf_chart_state(const tdmf_chart *chart, double elapsed, const tdmf_coordinates *coordinates,
                      double state[TDMF_STATE_COUNT]) {
    state[TDMF_HIP_WORK] = coordinates->work;
    state[TDMF_ENERGY_DAMPER_LOSS] = coordinates->damper_loss;
    state[TDMF_ENERGY_FRICTION_LOSS] = coordinates->friction_loss;
    state[TDMF_HIP_POSITIVE_WORK] = chart->positive_work;
    if (chart->contact == TDMF_CONTACT_FLIGHT) {
        place_flying_foot(chart, elapsed, coordinates, state);
    } else {
        place_standing_leg(chart, coordinates, state);
    }
}
