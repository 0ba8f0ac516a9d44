/* Derived from c_core/equations/friction.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_FRICTION_LAWS_H
#define TDMF_DERIVED_FRICTION_LAWS_H

#include "quantities.h"

#include <math.h>

/* rho mu, of a foot at rest and an impact that sticks: the cone is |f_t| <= rho mu f_n (2). */
static inline double tdmf_static_friction(const tdmf_model *model, const tdmf_inputs *inputs) {
    return model->parameters.ground.static_friction_ratio * inputs->ground.friction;
}

/* Its change. */
static inline double tdmf_vary_static_friction(const tdmf_model *model, const tdmf_inputs *inputs,
                                               const tdmf_model *d_model, const tdmf_inputs *d_inputs) {
    return d_model->parameters.ground.static_friction_ratio * inputs->ground.friction +
           model->parameters.ground.static_friction_ratio * d_inputs->ground.friction;
}

/* mu of a foot that slips, with the sign of its velocity. */
static inline double tdmf_sliding_friction(const tdmf_inputs *inputs, double sign) {
    return sign * inputs->ground.friction;
}

/* Its change. */
static inline double tdmf_vary_sliding_friction(const tdmf_inputs *inputs, double sign,
                                                const tdmf_inputs *d_inputs) {
    (void)inputs;
    return sign * d_inputs->ground.friction;
}

/* rho - 1, by what share more a foot at rest is held than one that slips fast. */
static inline double tdmf_friction_excess(const tdmf_model *model) {
    return model->parameters.ground.static_friction_ratio - 1.0;
}

/* Its change. */
static inline double tdmf_vary_friction_excess(const tdmf_model *model, const tdmf_model *d_model) {
    (void)model;
    return d_model->parameters.ground.static_friction_ratio;
}

/* -s/v_s, at what rate the excess fades with the foot's velocity. */
static inline double tdmf_friction_fading(const tdmf_model *model, double sign) {
    return -sign / model->parameters.ground.stribeck_velocity;
}

/* Its change. */
static inline double tdmf_vary_friction_fading(const tdmf_model *model, double sign,
                                               const tdmf_model *d_model) {
    return -(-sign / model->parameters.ground.stribeck_velocity *
             d_model->parameters.ground.stribeck_velocity) /
           model->parameters.ground.stribeck_velocity;
}

/* kappa/f_n = |mu| (rho - 1)/(m_f v_s): at up to kappa a falling friction lets a slip grow by itself.
 *
 * `friction` and `fading` have the signs of mu and -s. */
static inline double tdmf_friction_growth_rate(const tdmf_model *model, double friction, double excess,
                                               double fading) {
    return -friction * excess * fading * model->inverse_foot_mass;
}

/* |v_t-| up to which an impact comes to rest: rho b, or b + v_s ln(1 + q) where friction falls. */
static inline double tdmf_stopped_speed(const tdmf_model *model, const tdmf_inputs *inputs,
                                        double compression, bool falls) {
    if (falls) {
        const double taken = inputs->ground.friction * compression;
        return taken + model->parameters.ground.stribeck_velocity *
                           log1p(-(model->parameters.ground.static_friction_ratio - 1.0) *
                                 expm1(-taken / model->parameters.ground.stribeck_velocity));
    }
    return model->parameters.ground.static_friction_ratio * inputs->ground.friction * compression;
}

/* max(1, rho mu), by which the room in a cone is measured: so a wide one has the forces' own rounding. */
static inline double tdmf_cone_width(const tdmf_model *model, const tdmf_inputs *inputs) {
    return (1.0 >= model->parameters.ground.static_friction_ratio * inputs->ground.friction
                ? 1.0
                : model->parameters.ground.static_friction_ratio * inputs->ground.friction);
}

/* The weights of f_n and |f_t| in the room that a cone leaves, measured by its width. */
static inline tdmf_cone tdmf_cone_of(double friction) {
    const double widest = (1.0 >= friction ? 1.0 : friction);
    const tdmf_cone result = {
        .normal = friction / widest,
        .tangential = 1.0 / widest,
    };
    return result;
}

#endif
