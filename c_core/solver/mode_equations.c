/* From state to coordinates and back. */
#include "mode_equations.h"

#include "friction.h"
#include "ground_line.h"
#include "kinematics.h"

#include <math.h>

static void open_flight(tdmf_mode_equations *equations, const double state[TDMF_STATE_COUNT],
                        tdmf_leg_direction direction) {
    const tdmf_point com = tdmf_center_of_mass_along(equations->model, state, direction);
    equations->com_x = com.x;
    equations->com_y = com.y;
    equations->com_vx = com.vx;
    equations->com_vy = com.vy;
}

static void open_new_ground(tdmf_mode_equations *equations, const tdmf_inputs *inputs,
                            const tdmf_mode *mode) {
    equations->ground_waits = tdmf_ground_is_pending(inputs, mode);
    if (equations->ground_waits) {
        equations->new_ground = tdmf_ground_line_set(inputs);
    }
}

/* theta of a body that stands over the foot at (x, y) in the ground's axes. */
static double angle_seen(const tdmf_mode_equations *equations, double x, double y) {
    return atan2(-x, y) + equations->ground.slope;
}

/* A leg that has wound past a half turn in flight stays wound. */
static double turns_of(const tdmf_mode_equations *equations, double angle) {
    static const double turn = 6.283185307179586;
    const bool seen_as_it_is = fabs(angle) < 0.49 * turn;
    const tdmf_mode_coordinates *at = &equations->start;
    return seen_as_it_is ? 0.0 : turn * round((angle - angle_seen(equations, at->x, at->y)) / turn);
}

static void open_ground(tdmf_mode_equations *equations, const double state[TDMF_STATE_COUNT],
                        tdmf_leg_direction direction) {
    tdmf_mode_coordinates *at = &equations->start;
    const tdmf_ground_line *ground = &equations->ground;
    const tdmf_point body = tdmf_body_from_foot(state, tdmf_direction_over(ground, direction));
    at->x = body.x;
    at->y = body.y;
    at->foot_x = tdmf_place_along(ground, state[TDMF_FOOT_X], state[TDMF_FOOT_Y]);
    at->foot_vx = tdmf_velocity_along(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    at->vx = at->foot_vx + body.vx;
    at->vy = body.vy;
    equations->turn = turns_of(equations, state[TDMF_LEG_ANGLE]);
}

static void open_laws(tdmf_mode_equations *equations, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                      const tdmf_mode *mode) {
    const tdmf_model *model = equations->model;
    switch (mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        equations->law = tdmf_flight_law(model, inputs, rates, mode, equations->place_time);
        equations->servo = tdmf_servo(model, inputs, mode, equations->place_time);
        break;
    case TDMF_CONTACT_GRAZE:
        equations->law = tdmf_external_law(inputs, rates);
        equations->stance_law = tdmf_stance_law(model, inputs, rates, mode);
        equations->servo = tdmf_servo(model, inputs, mode, equations->place_time);
        break;
    default:
        equations->law = tdmf_stance_law(model, inputs, rates, mode);
    }
    equations->rest_length = tdmf_rest_length(model, inputs, mode);
    equations->friction = tdmf_signed_friction(inputs, mode);
    equations->friction_rate = tdmf_signed_friction(rates, mode);
    equations->static_friction = tdmf_static_friction(model, inputs);
    equations->static_friction_rate = tdmf_static_friction(model, rates);
}

void tdmf_open_mode(tdmf_mode_equations *equations, const tdmf_model *model, const tdmf_inputs *inputs,
                    const tdmf_inputs *rates, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                    tdmf_leg_direction direction) {
    *equations = (tdmf_mode_equations){.model = model, .contact = mode->contact, .ground = mode->ground};
    equations->place_time = state[TDMF_HIP_PLACE_TIME];
    equations->place_rate = tdmf_place_time_rate(mode);
    open_laws(equations, inputs, rates, mode);
    equations->positive_work = state[TDMF_HIP_POSITIVE_WORK];
    equations->leg_work = state[TDMF_LEG_WORK];
    equations->external_work = state[TDMF_ENERGY_EXTERNAL_WORK];
    equations->start.length = state[TDMF_LEG_LENGTH];
    equations->start.angle = state[TDMF_LEG_ANGLE];
    equations->start.length_rate = state[TDMF_LEG_LENGTH_RATE];
    equations->start.angle_rate = state[TDMF_LEG_ANGLE_RATE];
    equations->start.work = state[TDMF_HIP_WORK];
    equations->start.damper_loss = state[TDMF_ENERGY_DAMPER_LOSS];
    equations->start.friction_loss = state[TDMF_ENERGY_FRICTION_LOSS];
    equations->awaits_thrust =
        tdmf_is_loaded(mode) && !mode->thrusts && tdmf_leg_thrust(model, inputs) != 0.0;
    if (mode->contact == TDMF_CONTACT_FLIGHT) {
        open_flight(equations, state, direction);
        open_new_ground(equations, inputs, mode);
    } else {
        open_ground(equations, state, direction);
    }
}

void tdmf_shift_mode(tdmf_mode_equations *equations, double elapsed, const tdmf_mode_coordinates *reached) {
    const double g = equations->model->parameters.gravity;
    equations->start = *reached;
    tdmf_shift_law(&equations->law, elapsed);
    tdmf_shift_law(&equations->stance_law, elapsed);
    tdmf_shift_law(&equations->servo, elapsed);
    equations->place_time += elapsed * equations->place_rate;
    equations->friction += elapsed * equations->friction_rate;
    equations->static_friction += elapsed * equations->static_friction_rate;
    equations->com_x += elapsed * equations->com_vx;
    equations->com_y += elapsed * (equations->com_vy - 0.5 * g * elapsed);
    equations->com_vy -= g * elapsed;
}

void tdmf_end_friction(tdmf_mode_equations *equations) {
    equations->friction = equations->friction_rate = 0.0;
    equations->static_friction = equations->static_friction_rate = 0.0;
}

/* The foot hangs below the ballistic centre of mass, at the body's share of the leg. */
static tdmf_leg_direction write_flight(const tdmf_mode_equations *equations, double elapsed,
                                       const tdmf_mode_coordinates *at, double state[TDMF_STATE_COUNT]) {
    const double g = equations->model->parameters.gravity;
    const double share = equations->model->body_share;
    state[TDMF_LEG_LENGTH] = at->length;
    state[TDMF_LEG_ANGLE] = at->angle;
    state[TDMF_LEG_LENGTH_RATE] = at->length_rate;
    state[TDMF_LEG_ANGLE_RATE] = at->angle_rate;
    const tdmf_leg_direction direction = tdmf_leg_direction_of(state);
    const tdmf_point body = tdmf_body_from_foot(state, direction);
    state[TDMF_FOOT_X] = equations->com_x + elapsed * equations->com_vx - share * body.x;
    state[TDMF_FOOT_Y] =
        equations->com_y + elapsed * (equations->com_vy - 0.5 * g * elapsed) - share * body.y;
    state[TDMF_FOOT_VX] = equations->com_vx - share * body.vx;
    state[TDMF_FOOT_VY] = equations->com_vy - g * elapsed - share * body.vy;
    return direction;
}

static tdmf_leg_direction write_standing_leg(const tdmf_mode_equations *equations,
                                             const tdmf_mode_coordinates *at,
                                             double state[TDMF_STATE_COUNT]) {
    const double vx = at->vx - at->foot_vx;
    const double length = sqrt(at->x * at->x + at->y * at->y);
    const tdmf_point foot = tdmf_point_on(&equations->ground, at->foot_x, at->foot_vx);
    state[TDMF_FOOT_X] = foot.x;
    state[TDMF_FOOT_Y] = foot.y;
    state[TDMF_FOOT_VX] = foot.vx;
    state[TDMF_FOOT_VY] = foot.vy;
    state[TDMF_LEG_LENGTH] = length;
    state[TDMF_LEG_ANGLE] = angle_seen(equations, at->x, at->y) + equations->turn;
    state[TDMF_LEG_LENGTH_RATE] = (at->x * vx + at->y * at->vy) / length;
    state[TDMF_LEG_ANGLE_RATE] = (at->x * at->vy - at->y * vx) / (length * length);
    /* As whoever begins from the state has it, so that a run may stop at an event and go on alike. */
    return tdmf_leg_direction_of(state);
}

tdmf_leg_direction tdmf_state_in_mode(const tdmf_mode_equations *equations, double elapsed,
                                      const tdmf_mode_coordinates *coordinates,
                                      double state[TDMF_STATE_COUNT]) {
    state[TDMF_HIP_WORK] = coordinates->work;
    state[TDMF_HIP_PLACE_TIME] = equations->place_time + elapsed * equations->place_rate;
    state[TDMF_ENERGY_DAMPER_LOSS] = coordinates->damper_loss;
    state[TDMF_ENERGY_FRICTION_LOSS] = coordinates->friction_loss;
    state[TDMF_HIP_POSITIVE_WORK] = equations->positive_work;
    state[TDMF_LEG_WORK] = equations->leg_work;
    state[TDMF_ENERGY_EXTERNAL_WORK] = equations->external_work;
    return equations->contact == TDMF_CONTACT_FLIGHT ? write_flight(equations, elapsed, coordinates, state)
                                                     : write_standing_leg(equations, coordinates, state);
}
