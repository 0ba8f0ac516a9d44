/* Runners anywhere in the ranges that the unit declares. */
#ifndef TDMF_TESTS_DECLARED_H
#define TDMF_TESTS_DECLARED_H

#include "random.h"

#include "tdmf_slip/tdmf_slip.h"

/* Parameters, inputs and a start, before anything has judged them together. */
typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double state[TDMF_STATE_COUNT];
} declared_runner;

/* Mass, stiffness and length log-uniform over their ranges; all else, in the units that these make, so many
 * decades around Table 1 and its gait, or log-uniform over its own range where `decades` is infinite. Zeros
 * and the ends of the ranges come by chance. */
declared_runner declared_random(random_source *source, double decades);

/* Friction and torque; all else is as by default. */
tdmf_inputs declared_inputs(random_source *source, const tdmf_parameters *parameters, double decades);

/* And, each by chance, anything of what is beyond the paper: ground, extension, pushes, control. */
void declared_further_inputs(random_source *source, const tdmf_parameters *parameters, double decades,
                             tdmf_inputs *inputs);

/* Sets those parameters anew, each by chance, that may change in a run. */
void declared_settings(random_source *source, double decades, tdmf_parameters *parameters);

#endif
