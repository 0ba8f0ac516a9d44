/* Derived from c_core/equations/runner.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_RUNNER_LAWS_H
#define TDMF_DERIVED_RUNNER_LAWS_H

#include "quantities.h"

#include <math.h>

/* 1/m, 1/m_f, 1/m + 1/m_f, m + m_f and m/(m + m_f). */
static inline tdmf_mass_constants tdmf_mass_constants_of(const tdmf_model *model) {
    const double inverse_body_mass = 1.0 / model->parameters.body.mass;
    const double inverse_foot_mass = 1.0 / model->parameters.foot.mass;
    const double total_mass = model->parameters.body.mass + model->parameters.foot.mass;
    const tdmf_mass_constants result = {
        .inverse_body_mass = inverse_body_mass,
        .inverse_foot_mass = inverse_foot_mass,
        .inverse_reduced_mass = inverse_body_mass + inverse_foot_mass,
        .total_mass = total_mass,
        .body_share = model->parameters.body.mass / total_mass,
    };
    return result;
}

/* Its change. */
static inline tdmf_mass_constants tdmf_vary_mass_constants_of(const tdmf_model *model,
                                                              const tdmf_mass_constants *constants,
                                                              const tdmf_model *d_model) {
    (void)model;
    const double d_inverse_body_mass =
        -(constants->inverse_body_mass * constants->inverse_body_mass * d_model->parameters.body.mass);
    const double d_total_mass = d_model->parameters.body.mass + d_model->parameters.foot.mass;
    const tdmf_mass_constants result = {
        .inverse_body_mass = d_inverse_body_mass,
        .inverse_foot_mass =
            -(constants->inverse_foot_mass * constants->inverse_foot_mass * d_model->parameters.foot.mass),
        .inverse_reduced_mass = d_inverse_body_mass - constants->inverse_foot_mass *
                                                          constants->inverse_foot_mass *
                                                          d_model->parameters.foot.mass,
        .total_mass = d_total_mass,
        .body_share =
            (d_model->parameters.body.mass - constants->body_share * d_total_mass) / constants->total_mass,
    };
    return result;
}

#endif
