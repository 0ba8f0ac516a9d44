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

/* rho mu f_n + s f_t, up to the edge of the cone beyond which a foot at rest slips to the side s.
 *
 * Of a wide cone, rho mu > 1, by rho mu: so it has the forces' own rounding, and nothing overflows. */
static inline double tdmf_room_in_cone(double friction, bool wide, double sign,
                                       const tdmf_ground_force *force) {
    if (wide) {
        return force->normal + sign * force->tangential / friction;
    }
    return friction * force->normal + sign * force->tangential;
}

/* Its change. */
static inline double tdmf_vary_room_in_cone(double friction, bool wide, double sign,
                                            const tdmf_ground_force *force, double d_friction,
                                            const tdmf_ground_force *d_force) {
    if (wide) {
        return d_force->normal +
               (sign * d_force->tangential - sign * force->tangential / friction * d_friction) / friction;
    }
    return d_friction * force->normal + friction * d_force->normal + sign * d_force->tangential;
}

#endif
