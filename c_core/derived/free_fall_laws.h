/* Derived from c_core/equations/free_fall.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_FREE_FALL_LAWS_H
#define TDMF_DERIVED_FREE_FALL_LAWS_H

#include "quantities.h"

#include <math.h>

/* The same, where the inputs are held. */
static inline tdmf_point tdmf_ballistic_under(const tdmf_model *model, const tdmf_inputs *inputs,
                                              tdmf_point start, double time) {
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const tdmf_point result = {
        .x = start.x + time * (start.vx + time * (0.5 * (model->body_share * x))),
        .y = start.y + time * (start.vy + time * (0.5 * (model->body_share * y - model->parameters.gravity))),
        .vx = start.vx + time * (model->body_share * x),
        .vy = start.vy + time * (model->body_share * y - model->parameters.gravity),
    };
    return result;
}

#endif
