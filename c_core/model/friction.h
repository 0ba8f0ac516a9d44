/* Friction as modes have it; its law is in equations/friction.py. */
#ifndef TDMF_MODEL_FRICTION_H
#define TDMF_MODEL_FRICTION_H

#include "contact_mode.h"
#include "friction_laws.h"

/* mu with the sign of the foot's velocity: f_x is minus this by f_y. Zero where the foot does not slip. */
static inline double tdmf_signed_friction(const tdmf_inputs *inputs, const tdmf_mode *mode) {
    return tdmf_sliding_friction(inputs, tdmf_sign_of_slip(mode));
}

#endif
