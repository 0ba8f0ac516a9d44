/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GUARD_PARAMETERS_H
#define TDMF_DERIVED_GUARD_PARAMETERS_H

#include "tdmf_slip/parameters.h"
#include "width.h"

/* Parameters that guards are made of. */
typedef struct {
    real leg_min_length;
} guard_parameters;

static inline guard_parameters guard_parameters_of(const tdmf_model *model) {
    const guard_parameters values = {
        .leg_min_length = broadcast(model->parameters.leg.min_length),
    };
    return values;
}

#endif
