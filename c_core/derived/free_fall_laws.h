/* Derived from c_core/equations/free_fall.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_FREE_FALL_LAWS_H
#define TDMF_DERIVED_FREE_FALL_LAWS_H

#include "quantities.h"

#include <math.h>

/* The external force by the body's mass; of inputs' rates, its rate. */
static inline tdmf_vector tdmf_push_on_body(const tdmf_model *model, const tdmf_inputs *inputs) {
    const tdmf_vector result = {
        .x = inputs->body.external_fx * model->inverse_body_mass,
        .y = inputs->body.external_fy * model->inverse_body_mass,
    };
    return result;
}

/* (0, -g) + (external force)/(m + m_f), of the centre of mass. */
static inline tdmf_vector tdmf_com_acceleration(const tdmf_model *model, tdmf_vector push) {
    const tdmf_vector result = {
        .x = model->body_share * push.x,
        .y = model->body_share * push.y - model->parameters.gravity,
    };
    return result;
}

/* (0, -g) + (external force)/(m + m_f), under the inputs. */
static inline tdmf_vector tdmf_falling_acceleration(const tdmf_model *model, const tdmf_inputs *inputs) {
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const tdmf_vector result = {
        .x = model->body_share * x,
        .y = model->body_share * y - model->parameters.gravity,
    };
    return result;
}

/* The centre of mass in flight, some time after the start: x + v t + a t^2/2 + (jerk) t^3/6. */
static inline tdmf_point tdmf_ballistic_after(tdmf_point start, tdmf_vector acceleration, tdmf_vector jerk,
                                              double time) {
    const tdmf_point result = {
        .x = start.x + time * (start.vx + time * (0.5 * acceleration.x + 1.0 / 6.0 * (time * jerk.x))),
        .y = start.y + time * (start.vy + time * (0.5 * acceleration.y + 1.0 / 6.0 * (time * jerk.y))),
        .vx = start.vx + time * (acceleration.x + 0.5 * (time * jerk.x)),
        .vy = start.vy + time * (acceleration.y + 0.5 * (time * jerk.y)),
    };
    return result;
}

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

/* Its change. */
static inline tdmf_point tdmf_vary_ballistic_under(const tdmf_model *model, const tdmf_inputs *inputs,
                                                   tdmf_point start, double time, const tdmf_model *d_model,
                                                   const tdmf_inputs *d_inputs, tdmf_point d_start,
                                                   double d_time) {
    const double x = inputs->body.external_fx * model->inverse_body_mass;
    const double d_x = d_inputs->body.external_fx * model->inverse_body_mass +
                       inputs->body.external_fx * d_model->inverse_body_mass;
    const double y = inputs->body.external_fy * model->inverse_body_mass;
    const double d_y = d_inputs->body.external_fy * model->inverse_body_mass +
                       inputs->body.external_fy * d_model->inverse_body_mass;
    const tdmf_point result = {
        .x = d_start.x +
             (d_time * (start.vx + time * (0.5 * (model->body_share * x))) +
              time * (d_start.vx + (d_time * (0.5 * (model->body_share * x)) +
                                    time * (0.5 * (d_model->body_share * x + model->body_share * d_x))))),
        .y = d_start.y +
             (d_time * (start.vy + time * (0.5 * (model->body_share * y - model->parameters.gravity))) +
              time * (d_start.vy + (d_time * (0.5 * (model->body_share * y - model->parameters.gravity)) +
                                    time * (0.5 * (d_model->body_share * y + model->body_share * d_y -
                                                   d_model->parameters.gravity))))),
        .vx = d_start.vx +
              (d_time * (model->body_share * x) + time * (d_model->body_share * x + model->body_share * d_x)),
        .vy = d_start.vy +
              (d_time * (model->body_share * y - model->parameters.gravity) +
               time * (d_model->body_share * y + model->body_share * d_y - d_model->parameters.gravity)),
    };
    return result;
}

#endif
