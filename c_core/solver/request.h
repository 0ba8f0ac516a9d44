/* What a solver is asked for: neither solver starts on what makes no sense, as no step would show it. */
#ifndef TDMF_SOLVER_REQUEST_H
#define TDMF_SOLVER_REQUEST_H

#include "tdmf_slip/solver.h"

#include <math.h>

/* A share that steps may err by. */
static inline bool tdmf_is_tolerance(double relative_tolerance) {
    return relative_tolerance > 0.0 && relative_tolerance < 1.0;
}

static inline bool tdmf_is_sound_request(const tdmf_solver *solver, const tdmf_inputs *inputs,
                                         const tdmf_input_rates *rates, double until,
                                         const tdmf_motion *motion) {
    return tdmf_is_tolerance(solver->relative_tolerance) && until >= motion->time &&
           inputs->ground.friction >= 0.0 && isfinite(inputs->ground.friction) &&
           isfinite(inputs->hip.external_torque) && isfinite(rates->friction) &&
           isfinite(rates->external_torque);
}

#endif
