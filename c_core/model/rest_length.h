/* The rest length of the leg that a motion accounts for, as leg.py of the runner's page has it. */
#ifndef TDMF_MODEL_REST_LENGTH_H
#define TDMF_MODEL_REST_LENGTH_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#include <math.h>

/* Free length, extension, and the thrust while it is on. */
static inline double tdmf_rest_length(const tdmf_model *model, const tdmf_inputs *inputs,
                                      const tdmf_mode *mode) {
    const double thrust = model->parameters.leg.thrust + inputs->control.thrust;
    return model->parameters.leg.free_length + inputs->leg.extension +
           (mode->thrusts ? fmax(thrust, 0.0) : 0.0);
}

/* Work that a change of the rest length does on the spring, of a leg of this length on average. */
static inline double tdmf_work_of_change(const tdmf_model *model, double mean_length, double before,
                                         double after) {
    return model->parameters.leg.stiffness * (after - before) * (0.5 * (before + after) - mean_length);
}

#endif
