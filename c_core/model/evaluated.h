/* A runner at one instant: the leg, the hip's torque and the ground force, for all that reads them.
 * evaluation.h fills it. */
#ifndef TDMF_MODEL_EVALUATED_H
#define TDMF_MODEL_EVALUATED_H

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

#endif
