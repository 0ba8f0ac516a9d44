/* A runner at one instant: the leg, the hip's torque and the ground force, computed once and in this order,
 * for all that reads them. */
#ifndef TDMF_MODEL_EVALUATION_H
#define TDMF_MODEL_EVALUATION_H

#include "direction.h"
#include "leg.h"
#include "tdmf_slip/contact.h"

typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    const tdmf_mode *mode;
    const double *state;
    tdmf_leg leg;
    double torque;           /* tau, total */
    tdmf_ground_force force; /* of the mode */
} tdmf_evaluation;

/* The arguments are not copied. */
tdmf_evaluation tdmf_evaluate(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT]);

/* The same, where the leg is at hand. */
tdmf_evaluation tdmf_evaluate_leg(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                  const double state[TDMF_STATE_COUNT], const tdmf_leg *leg);

/* How what is evaluated changes along a direction, in the same shape; the mode is held but for its lift-off
 * angle. */
tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_direction *d);

#endif
