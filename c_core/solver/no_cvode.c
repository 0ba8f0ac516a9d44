/* This file stands in for cvode.c where SUNDIALS is missing. */
#include "tdmf_slip/cvode.h"

bool tdmf_cvode_is_available(void) {
    return false;
}

tdmf_outcome tdmf_cvode_advance(tdmf_solver *options, tdmf_system system, const tdmf_inputs *rates,
                                double until, tdmf_motion *motion) {
    (void)options;
    (void)system.model;
    (void)system.inputs;
    (void)rates;
    (void)until;
    (void)motion;
    return TDMF_REFUSED;
}
