/* Derived from c_core/equations/friction.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_FRICTION_LAWS_H
#define TDMF_DERIVED_FRICTION_LAWS_H

#include "quantities.h"

#include <math.h>

/* rho mu, of a foot at rest and an impact that sticks: the cone is |f_t| <= rho mu f_n (2). */
static inline double tdmf_static_friction(const tdmf_model *model, const tdmf_inputs *inputs,
                                          tdmf_zone zone) {
    return model->parameters.ground.static_friction_ratio *
           (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction);
}

/* mu of a foot that slips, with the sign of its velocity. */
static inline double tdmf_signed_friction(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_zone zone,
                                          double sign) {
    return sign *
           (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction);
}

/* rho - 1, by what share more a foot at rest is held than one that slips fast. */
static inline double tdmf_friction_excess(const tdmf_model *model) {
    return model->parameters.ground.static_friction_ratio - 1.0;
}

/* -s/v_s, at what rate the excess fades with the foot's velocity. */
static inline double tdmf_friction_fading(const tdmf_model *model, double sign) {
    return -sign / model->parameters.ground.stribeck_velocity;
}

/* kappa/f_n = |mu| (rho - 1)/(m_f v_s): at up to kappa a falling friction lets a slip grow by itself.
 *
 * `friction` and `fading` have the signs of mu and -s. */
static inline double tdmf_friction_growth_rate(const tdmf_model *model, double friction, double excess,
                                               double fading) {
    return -friction * excess * fading * model->inverse_foot_mass;
}

/* |v_t-| up to which an impact comes to rest: rho b, or b + v_s ln(1 + q) where friction falls. */
static inline double tdmf_stopped_speed(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_zone zone,
                                        double compression, bool falls) {
    if (falls) {
        const double taken =
            (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction) *
            compression;
        return taken + model->parameters.ground.stribeck_velocity *
                           log1p(-(model->parameters.ground.static_friction_ratio - 1.0) *
                                 expm1(-taken / model->parameters.ground.stribeck_velocity));
    }
    return model->parameters.ground.static_friction_ratio *
           (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction) *
           compression;
}

/* rho mu f_n + s f_t, up to the edge of the cone beyond which a foot at rest slips to the side s (2). */
static inline double tdmf_room_in_cone(double friction, double sign, tdmf_ground_force force) {
    return friction * force.normal + sign * force.tangential;
}

#endif
