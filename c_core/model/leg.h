/* The leg at one instant: what every force and acceleration is made of, computed once. */
#ifndef TDMF_MODEL_LEG_H
#define TDMF_MODEL_LEG_H

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/contact.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#include <math.h>

typedef struct {
    double length;         /* r */
    double inverse_length; /* 1/r */
    double length_rate;
    double angle_rate;
    double sine, cosine; /* of theta */
    double axial_force;  /* F_s = k (l0 - r) - c rdot, pushing body and foot apart */
} tdmf_leg;

/* A solver may try lengths at or below zero on its way past a fall; 1/r stays finite there. A running leg is
 * never shorter than its minimum, so the floor is out of reach of any accepted state. */
static inline double tdmf_inverse_leg_length(const tdmf_model *model, double length) {
    return 1.0 / fmax(length, 0.5 * model->parameters.leg.min_length);
}

/* The leg, where sine and cosine of its angle are at hand. */
static inline tdmf_leg tdmf_leg_at(const tdmf_model *model, const double state[TDMF_STATE_COUNT], double sine,
                                   double cosine) {
    const tdmf_parameters *p = &model->parameters;
    const double length = state[TDMF_LEG_LENGTH];
    const double length_rate = state[TDMF_LEG_LENGTH_RATE];
    const tdmf_leg leg = {
        .length = length,
        .inverse_length = tdmf_inverse_leg_length(model, length),
        .length_rate = length_rate,
        .angle_rate = state[TDMF_LEG_ANGLE_RATE],
        .sine = sine,
        .cosine = cosine,
        .axial_force = p->leg.stiffness * (p->leg.free_length - length) - p->leg.damping * length_rate,
    };
    return leg;
}

static inline tdmf_leg tdmf_leg_of(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    return tdmf_leg_at(model, state, sin(state[TDMF_LEG_ANGLE]), cos(state[TDMF_LEG_ANGLE]));
}

/* The public functions of automaton.h, contact.h, hip.h and graze.h for a leg that is already at hand: one
 * sine and cosine then serve a whole evaluation. */
tdmf_ground_force tdmf_leg_sticking_force(const tdmf_model *model, double torque, const tdmf_leg *leg);

/* Rate of tdmf_leg_sticking_force while the leg's length accelerates by `length_acceleration`. */
tdmf_ground_force tdmf_leg_sticking_force_rate(const tdmf_model *model, double torque, double torque_rate,
                                               double length_acceleration, const tdmf_leg *leg);

tdmf_ground_force tdmf_leg_contact_force(const tdmf_model *model, const tdmf_inputs *inputs,
                                         const tdmf_mode *mode, double torque, const tdmf_leg *leg);

/* sin(theta) as graze divides by it: kept off zero. */
double tdmf_leg_graze_sine(const tdmf_leg *leg);

double tdmf_leg_graze_torque(const tdmf_model *model, const tdmf_leg *leg);

double tdmf_leg_hip_torque(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                           const double state[TDMF_STATE_COUNT], const tdmf_leg *leg);

void tdmf_leg_guards(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                     const double state[TDMF_STATE_COUNT], const tdmf_leg *leg,
                     double guards[TDMF_GUARD_COUNT]);

double tdmf_leg_ground_force_rate(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                  const double state[TDMF_STATE_COUNT], const tdmf_leg *leg);

#endif
