/* What the kernel has to know of a mode: of its laws and guards, from the model, the mode and the inputs. */
#include "step_constants.h"

#include "coefficients.h"
#include "constant_laws.h"
#include "friction.h"
#include "ground_line.h"
#include "motion_coordinates.h"

static mode_constants mode_constants_of(const tdmf_model *model, double margin_factor) {
    const mode_constants constants = {
        .margin_factor = margin_factor,
        .damping = model->parameters.leg.damping,
        .gravity = model->parameters.gravity,
        .length_scale = model->scales.length,
        .time_scale = model->scales.time,
        .speed_scale = model->scales.speed,
        .force_scale = model->scales.force,
        .energy_scale = model->scales.energy,
        .guards = tdmf_guard_parameters_of(model),
    };
    return constants;
}

static height_above height_over(const tdmf_ground_line *line, const tdmf_mode_equations *equations) {
    const tdmf_point com = equations->com;
    const height_above height = {tdmf_height_over(line, com.x, com.y),
                                 tdmf_velocity_off(line, com.vx, com.vy)};
    return height;
}

ballistic tdmf_step_center_of_mass(const tdmf_mode_equations *equations) {
    const double share = equations->model->body_share;
    ballistic com = {.ground = height_over(&equations->ground, equations), .rise_rate = equations->com.vy};
    if (equations->ground_waits) {
        com.new_ground = height_over(&equations->new_ground, equations);
    }
    if (equations->is_forced) {
        com.normal_jerk =
            share * tdmf_velocity_off(&equations->ground, equations->push_rate.x, equations->push_rate.y);
        com.rise_jerk = share * equations->push_rate.y;
        com.new_normal_jerk =
            share * tdmf_velocity_off(&equations->new_ground, equations->push_rate.x, equations->push_rate.y);
    }
    return com;
}

/* The gravity of the centre of mass is its weight less what pushes it up. */
static void set_forcing(const tdmf_mode_equations *equations, flight_constants *constants) {
    const tdmf_vector acceleration = tdmf_com_acceleration(equations->model, equations->push);
    constants->mode.gravity = -acceleration.y;
    constants->normal_gravity = -tdmf_velocity_off(&equations->ground, acceleration.x, acceleration.y);
    constants->new_normal_gravity =
        -tdmf_velocity_off(&equations->new_ground, acceleration.x, acceleration.y);
}

flight_constants tdmf_step_flight_constants(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                            double margin_factor) {
    const double gravity = equations->model->parameters.gravity;
    flight_constants constants = {
        .mode = mode_constants_of(equations->model, margin_factor),
        .law = tdmf_flight_coefficients(equations),
        .body_share = equations->model->body_share,
        .slope = equations->ground.slope,
        .normal_gravity = gravity * equations->ground.cosine,
        .servo = tdmf_signed_law(&equations->servo, mode->clamp_closed ? -1.0 : 1.0),
        .new_slope = equations->new_ground.slope,
        .new_normal_gravity = gravity * equations->new_ground.cosine,
    };
    if (equations->is_forced) {
        set_forcing(equations, &constants);
    }
    return constants;
}

ground_constants tdmf_step_ground_constants(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                            double margin_factor) {
    ground_constants constants = {
        .mode = mode_constants_of(equations->model, margin_factor),
        .law = tdmf_ground_coefficients(equations),
        .cone = tdmf_friction_cone_of(equations->static_friction, 0.0, 0.0),
        .slip_sign = tdmf_slip_sign(mode),
        /* A leg that has wound past a half turn passes upright no more. */
        .drives = mode->mid_stance_pending && equations->winding == 0.0 ? 1.0 : 0.0,
        .awaits_thrust = equations->awaits_thrust ? 1.0 : 0.0,
        .slope_sine = equations->ground.sine,
        .slope_cosine = equations->ground.cosine,
        .servo = tdmf_signed_law(&equations->servo, 1.0),
        .stance = tdmf_signed_law(&equations->stance_law, 1.0),
        .clamped = equations->clamped ? 1.0 : 0.0,
        .retracting_share = mode->phase == TDMF_PHASE_RETRACT ? equations->model->body_share : 0.0,
    };
    if (equations->meets_border) {
        constants.border.ahead = equations->border;
        constants.border.cone = tdmf_friction_cone_of(equations->backward_friction, 0.0, 0.0);
    }
    return constants;
}

friction_layer tdmf_step_friction_layer(const tdmf_mode_equations *equations) {
    const tdmf_model *model = equations->model;
    const friction_layer layer = {model->parameters.ground.stribeck_velocity,
                                  tdmf_friction_growth_rate(model, equations->friction,
                                                            equations->friction_excess,
                                                            equations->friction_fading)};
    return layer;
}

flight_coordinates tdmf_step_flight_coordinates(const tdmf_mode_coordinates *at) {
    const flight_coordinates coordinates = {tdmf_flight_start_of(&at->flying),
                                            {at->work, at->damper_loss, at->friction_loss}};
    return coordinates;
}

ground_coordinates tdmf_step_ground_coordinates(const tdmf_mode_coordinates *at) {
    const ground_coordinates coordinates = {tdmf_ground_start_of(&at->standing),
                                            at->standing.foot_x,
                                            at->angle,
                                            {at->work, at->damper_loss, at->friction_loss}};
    return coordinates;
}

static void set_sums(tdmf_mode_coordinates *at, const energy_sums *done) {
    at->work = done->work;
    at->damper_loss = done->damper_loss;
    at->friction_loss = done->friction_loss;
}

void tdmf_step_set_flight(tdmf_mode_coordinates *at, const flight_coordinates *flight) {
    tdmf_set_flight(&flight->leg, &at->flying);
    set_sums(at, &flight->done);
}

void tdmf_step_set_ground(tdmf_mode_coordinates *at, const ground_coordinates *ground) {
    tdmf_set_ground(&ground->at, &at->standing);
    at->standing.foot_x = ground->foot_x;
    at->angle = ground->angle;
    set_sums(at, &ground->done);
}
