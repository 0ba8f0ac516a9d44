/* Turns states into the coordinates of a mode and back. */
#include "mode_equations.h"

#include "coordinate_laws.h"
#include "friction.h"
#include "ground_line.h"
#include "leg.h"

#include <math.h>

static void open_flight(tdmf_mode_equations *equations, const double state[TDMF_STATE_COUNT],
                        tdmf_leg_direction direction) {
    equations->start.flying = tdmf_flying_of(state);
    equations->com = tdmf_center_of_mass_along(equations->model, state, direction);
}

static void open_new_ground(tdmf_mode_equations *equations, const tdmf_inputs *inputs,
                            const tdmf_mode *mode) {
    equations->ground_waits = tdmf_ground_is_pending(inputs, mode);
    if (equations->ground_waits) {
        equations->new_ground = tdmf_ground_line_set(inputs);
    }
}

/* The centre of mass in flight, after a time t. */
static tdmf_point com_in_flight(const tdmf_mode_equations *equations, double t) {
    const tdmf_vector acceleration = tdmf_com_acceleration(equations->model, equations->push);
    const double share = equations->model->body_share;
    const tdmf_vector rate = {share * equations->push_rate.x, share * equations->push_rate.y};
    return tdmf_ballistic_after(equations->com, acceleration, rate, t);
}

/* A leg that has wound past a half turn in flight stays wound. */
static double winding_of(const tdmf_mode_equations *equations, double angle) {
    static const double two_pi = 6.283185307179586;
    const bool seen_as_it_is = fabs(angle) < 0.49 * two_pi;
    const tdmf_standing *at = &equations->start.standing;
    const double seen = tdmf_angle_seen(at->x, at->y, equations->ground.slope);
    return seen_as_it_is ? 0.0 : two_pi * round((angle - seen) / two_pi);
}

static void open_ground(tdmf_mode_equations *equations, const double state[TDMF_STATE_COUNT],
                        tdmf_leg_direction direction) {
    equations->start.standing = tdmf_standing_of(&equations->ground, state, direction);
    equations->start.angle = state[TDMF_LEG_ANGLE];
    equations->winding = winding_of(equations, state[TDMF_LEG_ANGLE]);
}

/* What a foot meets at a border: ahead of one that slips, or below one that stands. */
static void open_patch(tdmf_mode_equations *equations, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                       const tdmf_mode *mode, double x) {
    static const tdmf_model constant = {.inverse_body_mass = 0.0};
    const tdmf_model *model = equations->model;
    if (tdmf_slips_to_border(model, mode)) {
        const bool forward = tdmf_sign_of_slip(mode) > 0.0;
        equations->meets_border = true;
        equations->border = tdmf_path_to(&mode->ground, tdmf_border_ahead(model, mode->zone, forward));
    }
    if (mode->contact == TDMF_CONTACT_STICK && tdmf_is_on_border(model, x)) {
        equations->meets_border = true;
        const tdmf_zone zone = tdmf_zone_towards(model, x, -1.0);
        equations->backward_friction = tdmf_static_friction(model, inputs, zone);
        equations->backward_friction_rate = tdmf_vary_static_friction(model, inputs, zone, &constant, rates);
    }
}

static void open_laws(tdmf_mode_equations *equations, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                      const tdmf_mode *mode) {
    const tdmf_model *model = equations->model;
    const bool flies = mode->contact == TDMF_CONTACT_FLIGHT, grazes = mode->contact == TDMF_CONTACT_GRAZE;
    equations->law = flies ? tdmf_flight_law(model, inputs, rates, mode, equations->place_time)
                           : tdmf_ground_law(model, inputs, rates, mode);
    equations->clamped = (flies || grazes) && tdmf_has_clamp(model, mode);
    if (grazes || equations->clamped) {
        equations->servo = tdmf_servo(model, inputs, mode, equations->place_time);
    }
    if (grazes) {
        equations->stance_law = tdmf_stance_law(model, inputs, rates, mode);
    }
    equations->rest_length = tdmf_rest_length(model, inputs, mode);
}

/* A ramp is a change along time, in which the model is held. */
static void open_friction(tdmf_mode_equations *equations, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                          const tdmf_mode *mode, double x) {
    static const tdmf_model constant = {.inverse_body_mass = 0.0};
    const tdmf_model *model = equations->model;
    const double sign = tdmf_sign_of_slip(mode);
    const tdmf_zone ahead = tdmf_zone_towards(model, x, 1.0);
    equations->friction = tdmf_signed_friction(model, inputs, mode->zone, sign);
    equations->friction_rate = tdmf_vary_signed_friction(model, inputs, mode->zone, sign, &constant, rates);
    if (tdmf_friction_falls(model) && sign != 0.0) {
        equations->falls = true;
        equations->friction_excess = tdmf_friction_excess(model);
        equations->friction_fading = tdmf_friction_fading(model, sign);
    }
    equations->static_friction = tdmf_static_friction(model, inputs, ahead);
    equations->static_friction_rate = tdmf_vary_static_friction(model, inputs, ahead, &constant, rates);
    if (tdmf_has_patch(model)) {
        open_patch(equations, inputs, rates, mode, x);
    }
}

static void open_forcing(tdmf_mode_equations *equations, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                         const double state[TDMF_STATE_COUNT], tdmf_leg_direction direction) {
    equations->is_forced = tdmf_is_pushed(inputs) || tdmf_is_pushed(rates) || rates->leg.extension != 0.0;
    if (equations->is_forced) {
        equations->push = tdmf_push_on_body(equations->model, inputs);
        equations->push_rate = tdmf_push_on_body(equations->model, rates);
        equations->rest_length_rate = rates->leg.extension;
        equations->opened_body = tdmf_body_along(state, direction);
    }
}

static bool drifts(const tdmf_mode_equations *equations) {
    return tdmf_law_drifts(&equations->law) || tdmf_law_drifts(&equations->servo) ||
           tdmf_law_drifts(&equations->stance_law) || equations->friction_rate != 0.0 ||
           equations->static_friction_rate != 0.0 || equations->backward_friction_rate != 0.0 ||
           equations->rest_length_rate != 0.0 || equations->push_rate.x != 0.0 ||
           equations->push_rate.y != 0.0;
}

void tdmf_open_mode(tdmf_mode_equations *equations, tdmf_system system, const tdmf_inputs *rates,
                    const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                    tdmf_leg_direction direction) {
    *equations = (tdmf_mode_equations){
        .model = system.model, .inputs = *system.inputs, .contact = mode->contact, .ground = mode->ground};
    equations->place_time = state[TDMF_HIP_PLACE_TIME];
    equations->place_rate = tdmf_place_time_rate(mode);
    open_laws(equations, system.inputs, rates, mode);
    open_friction(equations, system.inputs, rates, mode, state[TDMF_FOOT_X]);
    equations->positive_work = state[TDMF_HIP_POSITIVE_WORK];
    equations->external_work = state[TDMF_ENERGY_EXTERNAL_WORK];
    equations->start.work = state[TDMF_HIP_WORK];
    equations->start.leg_work = state[TDMF_LEG_WORK];
    equations->start.damper_loss = state[TDMF_ENERGY_DAMPER_LOSS];
    equations->start.friction_loss = state[TDMF_ENERGY_FRICTION_LOSS];
    equations->awaits_thrust =
        tdmf_is_loaded(mode) && !mode->thrusts && tdmf_leg_thrust(system.model, system.inputs) != 0.0;
    open_forcing(equations, system.inputs, rates, state, direction);
    equations->drifts = drifts(equations);
    if (mode->contact == TDMF_CONTACT_FLIGHT) {
        open_flight(equations, state, direction);
        open_new_ground(equations, system.inputs, mode);
    } else {
        open_ground(equations, state, direction);
    }
}

void tdmf_shift_mode(tdmf_mode_equations *equations, double elapsed, const tdmf_mode_coordinates *reached) {
    const tdmf_point com = com_in_flight(equations, elapsed);
    equations->start = *reached;
    equations->law = tdmf_law_after(&equations->law, elapsed);
    equations->stance_law = tdmf_law_after(&equations->stance_law, elapsed);
    equations->servo = tdmf_law_after(&equations->servo, elapsed);
    equations->place_time += elapsed * equations->place_rate;
    equations->friction += elapsed * equations->friction_rate;
    equations->static_friction += elapsed * equations->static_friction_rate;
    equations->backward_friction += elapsed * equations->backward_friction_rate;
    equations->com = com;
    equations->rest_length += elapsed * equations->rest_length_rate;
    equations->push.x += elapsed * equations->push_rate.x;
    equations->push.y += elapsed * equations->push_rate.y;
}

/* That of a patch does not ramp. */
static void end_ramp(double *friction, double *rate) {
    if (*rate != 0.0) {
        *friction = *rate = 0.0;
    }
}

void tdmf_end_friction(tdmf_mode_equations *equations) {
    end_ramp(&equations->friction, &equations->friction_rate);
    end_ramp(&equations->static_friction, &equations->static_friction_rate);
    end_ramp(&equations->backward_friction, &equations->backward_friction_rate);
}

/* The foot hangs below the ballistic centre of mass, at the body's share of the leg. */
static tdmf_leg_direction write_flight(const tdmf_mode_equations *equations, double elapsed,
                                       const tdmf_mode_coordinates *at, double state[TDMF_STATE_COUNT]) {
    const tdmf_point com = com_in_flight(equations, elapsed);
    tdmf_state_of_flying(&at->flying, state);
    const tdmf_leg_direction direction = tdmf_leg_direction_of(state);
    tdmf_hang_foot(equations->model, com, state, direction, state);
    return direction;
}

static tdmf_leg_direction write_standing_leg(const tdmf_mode_equations *equations,
                                             const tdmf_mode_coordinates *at,
                                             double state[TDMF_STATE_COUNT]) {
    tdmf_state_of_standing(&equations->ground, &at->standing, equations->winding, state);
    /* As whoever begins from the state has it, so that a run may stop at an event and go on alike. */
    return tdmf_leg_direction_of(state);
}

/* The work is integrated by parts: it is the force by the body's way, less what the force has gained along
 * it. */
static double external_work(const tdmf_mode_equations *equations, double elapsed,
                            const tdmf_mode_coordinates *at, const double state[TDMF_STATE_COUNT],
                            tdmf_leg_direction direction) {
    const tdmf_vector push = equations->push, rate = equations->push_rate;
    if (!equations->is_forced) {
        return equations->external_work;
    }
    const tdmf_point body = tdmf_body_along(state, direction), from = equations->opened_body;
    const double work_of_mass =
        (push.x + elapsed * rate.x) * (body.x - from.x) + (push.y + elapsed * rate.y) * (body.y - from.y);
    return equations->external_work + equations->model->parameters.body.mass * work_of_mass - at->shortfall;
}

tdmf_leg_direction tdmf_state_in_mode(const tdmf_mode_equations *equations, double elapsed,
                                      const tdmf_mode_coordinates *coordinates,
                                      double state[TDMF_STATE_COUNT]) {
    state[TDMF_HIP_WORK] = coordinates->work;
    state[TDMF_HIP_PLACE_TIME] = equations->place_time + elapsed * equations->place_rate;
    state[TDMF_ENERGY_DAMPER_LOSS] = coordinates->damper_loss;
    state[TDMF_ENERGY_FRICTION_LOSS] = coordinates->friction_loss;
    state[TDMF_HIP_POSITIVE_WORK] = equations->positive_work;
    state[TDMF_LEG_WORK] = coordinates->leg_work;
    const tdmf_leg_direction direction = equations->contact == TDMF_CONTACT_FLIGHT
                                             ? write_flight(equations, elapsed, coordinates, state)
                                             : write_standing_leg(equations, coordinates, state);
    state[TDMF_ENERGY_EXTERNAL_WORK] = external_work(equations, elapsed, coordinates, state, direction);
    return direction;
}
