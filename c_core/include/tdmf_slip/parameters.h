/* A runner is given by its parameters and inputs; the model is made of the parameters. */
#ifndef TDMF_SLIP_PARAMETERS_H
#define TDMF_SLIP_PARAMETERS_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/refusal.h"
#include "tdmf_slip/variables.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The units of a scaled runner; every tolerance of the model is a pure number times one of these. */
typedef struct {
    double length; /* l0 */
    double time;   /* sqrt(m/k) */
    double speed;  /* l0 sqrt(k/m) */
    double force;  /* k l0 */
    double energy; /* k l0^2, also of torque */
} tdmf_scales;

/* Accepted parameters with what is derived from them once. Treat as read-only; made by tdmf_model_create. */
typedef struct {
    tdmf_parameters parameters;  /* accepted parameters */
    tdmf_scales scales;          /* scales of lengths, times, speeds, forces and energies */
    double inverse_body_mass;    /* 1/m */
    double inverse_foot_mass;    /* 1/m_f */
    double inverse_reduced_mass; /* 1/m + 1/m_f */
    double total_mass;           /* m + m_f */
    double body_share;           /* m/(m + m_f) */
} tdmf_model;

/* A runner and its inputs. The library keeps neither: both must live as long as the calls that use them. */
typedef struct {
    const tdmf_model *model;   /* the runner */
    const tdmf_inputs *inputs; /* their values at the time of the motion */
} tdmf_system;

/* A direction in the space of parameters and inputs, along which strides are differentiated. */
typedef struct {
    tdmf_parameters parameters; /* change of each parameter, per unit of the direction */
    tdmf_inputs inputs;         /* and of each input */
} tdmf_seed;

/* Return the default values: Table 1 and friction 0.6. From tdmf_default_state they make a periodic gait. */
TDMF_API tdmf_parameters tdmf_default_parameters(void);
TDMF_API tdmf_inputs tdmf_default_inputs(void);

/* Checks every parameter (NaN and infinity included) and derives the constants. On refusal `model` is left
 * as it was and the first offending parameter is returned. */
TDMF_API tdmf_refusal tdmf_model_create(tdmf_model *model, const tdmf_parameters *parameters);

/* Checks every input against its range, NaN and infinity included. */
TDMF_API tdmf_refusal tdmf_check_inputs(const tdmf_inputs *inputs);

/* Returns the inputs after some time, s, at these rates; friction stops at 0. `rates` may be NULL: the inputs
 * are held. */
TDMF_API tdmf_inputs tdmf_inputs_after(const tdmf_inputs *inputs, const tdmf_inputs *rates, double elapsed);

#ifdef __cplusplus
}
#endif
#endif
