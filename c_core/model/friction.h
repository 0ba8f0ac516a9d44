/* Friction as modes have it; its law is in equations/friction.py. */
#ifndef TDMF_MODEL_FRICTION_H
#define TDMF_MODEL_FRICTION_H

#include "contact_mode.h"
#include "friction_laws.h"

/* mu with the sign of the foot's velocity: f_x is minus this by f_y. Zero where the foot does not slip. */
static inline double tdmf_signed_friction(const tdmf_inputs *inputs, const tdmf_mode *mode) {
    return tdmf_sliding_friction(inputs, tdmf_sign_of_slip(mode));
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
