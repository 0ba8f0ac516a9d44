/* What laws take and give, beside the public structs. */
#ifndef TDMF_MODEL_QUANTITIES_H
#define TDMF_MODEL_QUANTITIES_H

#include "tdmf_slip/contact.h"
#include "tdmf_slip/energy.h"
#include "tdmf_slip/kinematics.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

/* A force, N, an acceleration, m/s2, or its rate. */
typedef struct {
    double x, y;
} tdmf_vector;

/* Sine and cosine of the leg's angle, which no event changes. */
typedef struct {
    double sine, cosine;
} tdmf_leg_direction;

/* The leg at one instant: what every force and acceleration is made of, computed once. */
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

/* A runner at one instant: what evaluation.h makes of it, once, in the order of its members. */
typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    const tdmf_mode *mode;
    const double *state;
    tdmf_leg leg;
    double torque;           /* tau, total */
    tdmf_ground_force force; /* of the mode */
} tdmf_evaluation;

/* What an impact leaves, and what it costs. */
typedef struct {
    double foot_x, foot_y, foot_vx, foot_vy, leg_length_rate, leg_angle_rate;
    double loss; /* J */
} tdmf_after_impact;

/* The constants of a model that are made of its masses. */
typedef struct {
    double inverse_body_mass, inverse_foot_mass, inverse_reduced_mass, total_mass, body_share;
} tdmf_mass_constants;

#endif
