/* The leg at one instant: what every force and acceleration is made of, computed once. */
#ifndef TDMF_MODEL_LEG_H
#define TDMF_MODEL_LEG_H

#include "direction.h"

#include <math.h>

typedef struct {
    double length;         /* r */
    double inverse_length; /* 1/r */
    double length_rate;
    double angle_rate;
    double sine, cosine;               /* of theta */
    double ground_sine, ground_cosine; /* of theta' = theta - sigma, from the ground's normal */
    double rest_length;                /* of the spring */
    double axial_force;                /* F_s = k (rest length - r) - c rdot, pushing body and foot apart */
} tdmf_leg;

/* Sine and cosine of the leg's angle, which no event changes. */
typedef struct {
    double sine, cosine;
} tdmf_leg_direction;

static inline tdmf_leg_direction tdmf_leg_direction_of(const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg_direction direction = {sin(state[TDMF_LEG_ANGLE]), cos(state[TDMF_LEG_ANGLE])};
    return direction;
}

/* What the rest length grows by at the greatest compression: no less than 0, whatever the control asks for. A
 * leg that grew shorter would leave a ground that it comes down to at once, for ever. */
static inline double tdmf_leg_thrust(const tdmf_model *model, const tdmf_inputs *inputs) {
    const double thrust = model->parameters.leg.thrust + inputs->control.thrust;
    return thrust > 0.0 ? thrust : 0.0;
}

/* Of the spring: l0, the extension and, from the greatest compression to the end of the stance, the thrust.
 */
static inline double tdmf_rest_length(const tdmf_model *model, const tdmf_inputs *inputs,
                                      const tdmf_mode *mode) {
    const double thrust = mode->thrusts ? tdmf_leg_thrust(model, inputs) : 0.0;
    return model->parameters.leg.free_length + inputs->leg.extension + thrust;
}

/* Whether a thrust that grows changes the rest length: it is on and not held at 0. */
static inline bool tdmf_thrust_acts(const tdmf_model *model, const tdmf_inputs *inputs,
                                    const tdmf_mode *mode) {
    return mode->thrusts && model->parameters.leg.thrust + inputs->control.thrust >= 0.0;
}

/* The change of the rest length. */
static inline double tdmf_vary_rest_length(bool thrust_acts, const tdmf_model *d,
                                           const tdmf_inputs *d_inputs) {
    return d->parameters.leg.free_length + d_inputs->leg.extension +
           (thrust_acts ? d->parameters.leg.thrust + d_inputs->control.thrust : 0.0);
}

/* From the normal of the ground. */
static inline tdmf_leg_direction tdmf_direction_over(const tdmf_ground_line *line,
                                                     tdmf_leg_direction direction) {
    const tdmf_leg_direction over = {direction.sine * line->cosine - direction.cosine * line->sine,
                                     direction.cosine * line->cosine + direction.sine * line->sine};
    return over;
}

/* The leg, where its direction is at hand. A solver may try lengths at or below zero on its
 * way past a fall; 1/r stays finite there. A running leg is never shorter than its minimum, so the floor is
 * out of reach of any accepted state. */
static inline tdmf_leg tdmf_leg_along(const tdmf_model *model, const tdmf_inputs *inputs,
                                      const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                                      tdmf_leg_direction direction) {
    const tdmf_parameters *p = &model->parameters;
    const double length = state[TDMF_LEG_LENGTH];
    const double length_rate = state[TDMF_LEG_LENGTH_RATE];
    const double shortest = 0.5 * p->leg.min_length;
    const double rest_length = tdmf_rest_length(model, inputs, mode);
    const tdmf_leg_direction over_ground = tdmf_direction_over(&mode->ground, direction);
    const tdmf_leg leg = {
        .length = length,
        .inverse_length = 1.0 / (length > shortest ? length : shortest),
        .length_rate = length_rate,
        .angle_rate = state[TDMF_LEG_ANGLE_RATE],
        .sine = direction.sine,
        .cosine = direction.cosine,
        .ground_sine = over_ground.sine,
        .ground_cosine = over_ground.cosine,
        .rest_length = rest_length,
        .axial_force = p->leg.stiffness * (rest_length - length) - p->leg.damping * length_rate,
    };
    return leg;
}

static inline tdmf_leg tdmf_leg_of(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]) {
    return tdmf_leg_along(model, inputs, mode, state, tdmf_leg_direction_of(state));
}

/* How the leg changes along a direction, along which its rest length changes by `d_rest_length` and the
 * ground by `d_ground`. */
static inline tdmf_leg tdmf_vary_leg(const tdmf_model *model, const tdmf_leg *leg, const tdmf_model *d,
                                     double d_rest_length, const tdmf_ground_line *d_ground,
                                     const double d_state[TDMF_STATE_COUNT]) {
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d_p = &d->parameters;
    const double d_length = d_state[TDMF_LEG_LENGTH];
    const double d_length_rate = d_state[TDMF_LEG_LENGTH_RATE];
    const double d_angle = d_state[TDMF_LEG_ANGLE];
    const bool floored = leg->length < 0.5 * p->leg.min_length;
    const double d_bounded = floored ? 0.5 * d_p->leg.min_length : d_length;
    const tdmf_leg d_leg = {
        .length = d_length,
        .inverse_length = -leg->inverse_length * leg->inverse_length * d_bounded,
        .length_rate = d_length_rate,
        .angle_rate = d_state[TDMF_LEG_ANGLE_RATE],
        .sine = leg->cosine * d_angle,
        .cosine = -leg->sine * d_angle,
        .ground_sine = leg->ground_cosine * (d_angle - d_ground->slope),
        .ground_cosine = -leg->ground_sine * (d_angle - d_ground->slope),
        .rest_length = d_rest_length,
        .axial_force = d_p->leg.stiffness * (leg->rest_length - leg->length) +
                       p->leg.stiffness * (d_rest_length - d_length) - d_p->leg.damping * leg->length_rate -
                       p->leg.damping * d_length_rate,
    };
    return d_leg;
}

#endif
