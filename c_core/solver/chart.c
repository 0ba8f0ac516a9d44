/* From state to coordinates and back. */
#include "chart.h"

#include "friction.h"
#include "kinematics.h"

#include <math.h>

static void open_flight(tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                        tdmf_leg_direction direction) {
    const tdmf_point com = tdmf_center_of_mass_along(chart->model, state, direction);
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

static void open_ground(tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                        tdmf_leg_direction direction) {
    tdmf_coordinates *at = &chart->start;
    const tdmf_point body = tdmf_body_from_foot(state, direction);
    at->x = body.x;
    at->y = body.y;
    at->foot_x = state[TDMF_FOOT_X];
    at->foot_vx = state[TDMF_FOOT_VX];
    at->vx = at->foot_vx + body.vx;
    at->vy = body.vy;
    chart->turn = turns_of(state[TDMF_LEG_ANGLE], at);
}

static void open_laws(tdmf_chart *chart, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                      const tdmf_mode *mode) {
    const tdmf_model *model = chart->model;
    switch (mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        chart->law = tdmf_flight_law(model, inputs, rates, mode, chart->place_time);
        break;
    case TDMF_CONTACT_GRAZE:
        chart->law = tdmf_external_law(inputs, rates);
        chart->stance_law = tdmf_stance_law(model, inputs, rates, mode);
        break;
    default:
        chart->law = tdmf_stance_law(model, inputs, rates, mode);
    }
    chart->servo = tdmf_servo(model, mode, chart->place_time);
    chart->friction = tdmf_signed_friction(inputs, mode);
    chart->friction_rate = tdmf_signed_friction(rates, mode);
    chart->static_friction = tdmf_static_friction(model, inputs);
    chart->static_friction_rate = tdmf_static_friction(model, rates);
}

void tdmf_chart_open(tdmf_chart *chart, const tdmf_model *model, const tdmf_inputs *inputs,
                     const tdmf_inputs *rates, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                     tdmf_leg_direction direction) {
    const tdmf_chart blank = {.model = model, .contact = mode->contact};
    *chart = blank;
    chart->place_time = state[TDMF_HIP_PLACE_TIME];
    chart->place_rate = mode->phase == TDMF_PHASE_PLACE ? 1.0 : 0.0;
    open_laws(chart, inputs, rates, mode);
    chart->positive_work = state[TDMF_HIP_POSITIVE_WORK];
    chart->start.length = state[TDMF_LEG_LENGTH];
    chart->start.angle = state[TDMF_LEG_ANGLE];
    chart->start.length_rate = state[TDMF_LEG_LENGTH_RATE];
    chart->start.angle_rate = state[TDMF_LEG_ANGLE_RATE];
    chart->start.work = state[TDMF_HIP_WORK];
    chart->start.damper_loss = state[TDMF_ENERGY_DAMPER_LOSS];
    chart->start.friction_loss = state[TDMF_ENERGY_FRICTION_LOSS];
    if (mode->contact == TDMF_CONTACT_FLIGHT) {
        open_flight(chart, state, direction);
    } else {
        open_ground(chart, state, direction);
    }
}

void tdmf_chart_shift(tdmf_chart *chart, double elapsed, const tdmf_coordinates *reached) {
    const double g = chart->model->parameters.gravity;
    chart->start = *reached;
    tdmf_shift_law(&chart->law, elapsed);
    tdmf_shift_law(&chart->stance_law, elapsed);
    tdmf_shift_law(&chart->servo, elapsed);
    chart->place_time += elapsed * chart->place_rate;
    chart->friction += elapsed * chart->friction_rate;
    chart->static_friction += elapsed * chart->static_friction_rate;
    chart->com_x += elapsed * chart->com_vx;
    chart->com_y += elapsed * (chart->com_vy - 0.5 * g * elapsed);
    chart->com_vy -= g * elapsed;
}

void tdmf_chart_end_friction(tdmf_chart *chart) {
    chart->friction = chart->friction_rate = 0.0;
    chart->static_friction = chart->static_friction_rate = 0.0;
}

/* The foot hangs below the ballistic centre of mass, at the body's share of the leg. */
static tdmf_leg_direction write_flight(const tdmf_chart *chart, double elapsed, const tdmf_coordinates *at,
                                       double state[TDMF_STATE_COUNT]) {
    const double g = chart->model->parameters.gravity;
    const double share = chart->model->body_share;
    state[TDMF_LEG_LENGTH] = at->length;
    state[TDMF_LEG_ANGLE] = at->angle;
    state[TDMF_LEG_LENGTH_RATE] = at->length_rate;
    state[TDMF_LEG_ANGLE_RATE] = at->angle_rate;
    const tdmf_leg_direction direction = tdmf_leg_direction_of(state);
    const tdmf_point body = tdmf_body_from_foot(state, direction);
    state[TDMF_FOOT_X] = chart->com_x + elapsed * chart->com_vx - share * body.x;
    state[TDMF_FOOT_Y] = chart->com_y + elapsed * (chart->com_vy - 0.5 * g * elapsed) - share * body.y;
    state[TDMF_FOOT_VX] = chart->com_vx - share * body.vx;
    state[TDMF_FOOT_VY] = chart->com_vy - g * elapsed - share * body.vy;
    return direction;
}

static tdmf_leg_direction write_standing_leg(const tdmf_chart *chart, const tdmf_coordinates *at,
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
    /* As whoever begins from the state has it, so that a run may stop at an event and go on alike. */
    return tdmf_leg_direction_of(state);
}

tdmf_leg_direction tdmf_chart_state(const tdmf_chart *chart, double elapsed,
                                    const tdmf_coordinates *coordinates, double state[TDMF_STATE_COUNT]) {
    state[TDMF_HIP_WORK] = coordinates->work;
    state[TDMF_HIP_PLACE_TIME] = chart->place_time + elapsed * chart->place_rate;
    state[TDMF_ENERGY_DAMPER_LOSS] = coordinates->damper_loss;
    state[TDMF_ENERGY_FRICTION_LOSS] = coordinates->friction_loss;
    state[TDMF_HIP_POSITIVE_WORK] = chart->positive_work;
    return chart->contact == TDMF_CONTACT_FLIGHT ? write_flight(chart, elapsed, coordinates, state)
                                                 : write_standing_leg(chart, coordinates, state);
}
