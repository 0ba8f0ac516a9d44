/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GUARD_PARAMETERS_H
#define TDMF_DERIVED_GUARD_PARAMETERS_H

#include "tdmf_slip/parameters.h"
#include "width.h"

/* What guards are made of, in any width. */
typedef struct {
    real leg_min_length;
} guard_parameters;

/* Parameters that guards are made of. */
static inline guard_parameters tdmf_guard_parameters_of(const tdmf_model *model) {
    const guard_parameters result = {
        .leg_min_length = broadcast(model->parameters.leg.min_length),
    };
    return result;
}

#endif
