/* What a solver is asked for: neither solver starts on what makes no sense, as no step would show it. */
#ifndef TDMF_SOLVER_REQUEST_H
#define TDMF_SOLVER_REQUEST_H

#include "input_rates.h"
#include "tdmf_slip/solver.h"

#include <math.h>

/* A share that steps may err by. */
static inline bool tdmf_is_tolerance(double relative_tolerance) {
    return relative_tolerance > 0.0 && relative_tolerance < 1.0;
}

/* Inputs, those at the end included, are within their ranges: beyond, numbers overflow. None ramps that
 * changes at events only: between them no guard looks at it. */
static inline bool tdmf_are_sound_inputs(const tdmf_inputs *inputs, const tdmf_inputs *rates,
                                         double duration) {
    if (tdmf_check_inputs(inputs).variable != NULL || !tdmf_are_rates(rates)) {
        return false;
    }
    const tdmf_inputs last = tdmf_are_held(rates) ? *inputs : tdmf_inputs_after(inputs, rates, duration);
    return tdmf_check_inputs(&last).variable == NULL;
}

static inline bool tdmf_is_sound_request(const tdmf_solver *solver, const tdmf_inputs *inputs,
                                         const tdmf_inputs *rates, double until, const tdmf_motion *motion) {
    return tdmf_is_tolerance(solver->relative_tolerance) && until >= motion->time &&
           tdmf_are_sound_inputs(inputs, rates, until - motion->time);
}

#endif
