/* Coulomb friction: everything that is made of its coefficient. It is linear in the inputs, so that the same
 * functions serve values, rates and variations. */
#ifndef TDMF_MODEL_FRICTION_H
#define TDMF_MODEL_FRICTION_H

#include "contact_mode.h"
#include "tdmf_slip/parameters.h"

/* rho mu, of a foot at rest: its cone is |f_x| <= rho mu f_y  (2), and an impact inside the same cone stops
 * it. */
static inline double tdmf_static_friction(const tdmf_model *model, const tdmf_inputs *inputs) {
    return model->parameters.ground.static_friction_ratio * inputs->ground.friction;
}

/* Its change. */
static inline double tdmf_vary_static_friction(const tdmf_model *model, const tdmf_inputs *inputs,
                                               const tdmf_model *d_model, const tdmf_inputs *d_inputs) {
    return tdmf_static_friction(d_model, inputs) + tdmf_static_friction(model, d_inputs);
}

/* mu of a foot that slips. */
static inline double tdmf_sliding_friction(const tdmf_inputs *inputs) {
    return inputs->ground.friction;
}

/* The same with the sign of the foot's velocity: f_x is minus this by f_y. Zero where the foot does not slip.
 */
static inline double tdmf_signed_friction(const tdmf_inputs *inputs, const tdmf_mode *mode) {
    return tdmf_sign_of_slip(mode) * tdmf_sliding_friction(inputs);
}

/* The edges of the friction cone as guards, normal f_y + tangential f_x and normal f_y - tangential f_x: they
 * carry mu times the rounding of f_y, so that under a large friction no fixed margin would hold. Over max(1,
 * mu) they have the forces' own rounding, and nothing overflows. */
typedef struct {
    double normal, tangential;
} tdmf_cone;

static inline tdmf_cone tdmf_cone_of(double friction) {
    const tdmf_cone narrow = {friction, 1.0};
    const tdmf_cone wide = {1.0, 1.0 / friction};
    return friction > 1.0 ? wide : narrow;
}

#endif
