/* The right-hand side, put together of the laws in equations/dynamics.py, and its variation. In a variation
 * d_ stands for the change of what follows. */
#include "dynamics.h"

#include "dynamics_laws.h"
#include "free_fall.h"
#include "ground_line.h"
#include "kinematics.h"
#include "ranges.h"

#include <string.h>

/* ---- accelerations ------------------------------------------------------------------------------------ */

typedef struct {
    tdmf_vector body, foot; /* of the body as if it had no leg, and of the foot */
    tdmf_leg_rates leg;
} accelerations;

static inline accelerations accelerate(const tdmf_evaluation *at) {
    const tdmf_model *model = at->model;
    accelerations a;
    a.body = tdmf_body_acceleration(model, tdmf_push_on_body(model, at->inputs));
    a.foot = tdmf_acceleration_of_foot(model, &at->mode->ground, &at->leg, at->torque, at->force,
                                       at->mode->contact);
    a.leg = tdmf_acceleration_of_leg(model, &at->leg, at->torque, a.body, a.foot);
    return a;
}

static accelerations vary_accelerations(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    const tdmf_model *model = at->model;
    const accelerations a = accelerate(at);
    accelerations d_a;
    d_a.body = tdmf_vary_body_acceleration(model, tdmf_push_on_body(model, at->inputs), d->model,
                                           tdmf_vary_push_on_body(model, at->inputs, d->model, d->inputs));
    d_a.foot = tdmf_vary_acceleration_of_foot(model, &at->mode->ground, &at->leg, at->torque, at->force,
                                              at->mode->contact, d->model, &d->mode->ground, &d->leg,
                                              d->torque, d->force);
    d_a.leg = tdmf_vary_acceleration_of_leg(model, &at->leg, at->torque, a.body, a.foot, d->model, &d->leg,
                                            d->torque, d_a.body, d_a.foot);
    return d_a;
}

tdmf_leg_rates tdmf_accelerate_leg(const tdmf_evaluation *at) {
    return accelerate(at).leg;
}

/* ---- the right-hand side ------------------------------------------------------------------------------ */

static double slip_velocity(const tdmf_evaluation *at) {
    return tdmf_velocity_along(&at->mode->ground, at->state[TDMF_FOOT_VX], at->state[TDMF_FOOT_VY]);
}

static tdmf_point body_of(const tdmf_evaluation *at) {
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    return tdmf_body_along(at->state, direction);
}

static void write_rates(const tdmf_evaluation *at, const accelerations *a, double external_power,
                        double rates[TDMF_STATE_COUNT]) {
    tdmf_rates_with(at->model, at->state, &at->leg, at->torque, at->force, a->foot, a->leg, slip_velocity(at),
                    external_power, rates);
    tdmf_hip_rates(at->model, at->inputs, at->mode, at->state, rates);
}

void tdmf_derivatives(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                      double derivatives[TDMF_STATE_COUNT]) {
    if (mode->fallen) {
        memset(derivatives, 0, TDMF_STATE_COUNT * sizeof *derivatives);
        return;
    }
    double rates[TDMF_STATE_COUNT];
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    const accelerations a = accelerate(&at);
    const double external_power =
        tdmf_is_pushed(system.inputs) ? tdmf_external_power(system.inputs, body_of(&at)) : 0.0;
    write_rates(&at, &a, external_power, rates);
    memcpy(derivatives, rates, sizeof rates);
}

void tdmf_vary_rates_of_state(const tdmf_evaluation *at, const tdmf_evaluation *d,
                              double derivatives[TDMF_STATE_COUNT]) {
    const accelerations a = accelerate(at), d_a = vary_accelerations(at, d);
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    const double d_slip_velocity =
        tdmf_vary_velocity_along(&at->mode->ground, at->state[TDMF_FOOT_VX], at->state[TDMF_FOOT_VY],
                                 &d->mode->ground, d->state[TDMF_FOOT_VX], d->state[TDMF_FOOT_VY]);
    const double d_external_power = tdmf_vary_external_power(
        at->inputs, body_of(at), d->inputs, tdmf_vary_body_along(at->state, direction, d->state));
    tdmf_vary_rates_with(at->model, at->state, &at->leg, at->torque, at->force, a.foot, a.leg,
                         slip_velocity(at), 0.0, d->model, d->state, &d->leg, d->torque, d->force, d_a.foot,
                         d_a.leg, d_slip_velocity, d_external_power, derivatives);
    tdmf_vary_hip_rates(at->model, at->inputs, at->mode, at->state, d->model, d->inputs, d->mode, d->state,
                        derivatives);
}

void tdmf_state_scales(const tdmf_model *model, double scales[TDMF_STATE_COUNT]) {
    const tdmf_scales *units = &model->scales;
    const double of_quantity[TDMF_QUANTITY_COUNT] = {
        [TDMF_QUANTITY_LENGTH] = units->length,  [TDMF_QUANTITY_ANGLE] = 1.0,
        [TDMF_QUANTITY_VELOCITY] = units->speed, [TDMF_QUANTITY_ANGULAR_VELOCITY] = 1.0 / units->time,
        [TDMF_QUANTITY_TIME] = units->time,      [TDMF_QUANTITY_TORQUE] = units->energy,
        [TDMF_QUANTITY_ENERGY] = units->energy,
    };
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        scales[i] = of_quantity[tdmf_state_quantities[i]];
    }
    if (tdmf_friction_falls(model)) {
        const double layer = model->parameters.ground.stribeck_velocity;
        scales[TDMF_FOOT_VX] = layer < units->speed ? layer : units->speed;
    }
}

/* ---- how the ground force changes --------------------------------------------------------------------- */

tdmf_ground_force tdmf_force_rate(const tdmf_evaluation *at) {
    static const tdmf_model unchanged = {0};
    static const tdmf_inputs zero_rates = {0};
    static const tdmf_mode zero = {0};
    const accelerations acceleration = accelerate(at);
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg_direction direction = {leg->sine, leg->cosine};
    double rates[TDMF_STATE_COUNT];
    write_rates(at, &acceleration, 0.0, rates); /* no force depends on the work done */
    const tdmf_leg rate_of_leg =
        tdmf_vary_leg_with(at->model, &at->mode->ground, at->state, direction, leg->rest_length, leg,
                           &unchanged, &zero.ground, rates, 0.0);
    const double rate_of_torque = tdmf_vary_torque_in(
        at->model, at->inputs, at->mode, at->state, leg, tdmf_is_upright(leg), tdmf_sine_away_from_zero(leg),
        at->torque, &unchanged, &zero_rates, &zero, rates, &rate_of_leg);
    return tdmf_vary_force_in(at->model, at->friction, &at->mode->ground, at->state, leg, at->torque,
                              at->mode->contact, tdmf_sign_of_slip(at->mode), tdmf_friction_falls(at->model),
                              &unchanged, 0.0, &zero.ground, rates, &rate_of_leg, rate_of_torque);
}

double tdmf_ground_force_rate(tdmf_system system, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    return tdmf_force_rate(&at).normal;
}
