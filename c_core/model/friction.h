/* Friction as modes have it; its law is in equations/friction.py. */
#ifndef TDMF_MODEL_FRICTION_H
#define TDMF_MODEL_FRICTION_H

#include "friction_laws.h"
#include "patch.h"

/* Friction falls with the foot's speed. */
static inline bool tdmf_friction_falls(const tdmf_model *model) {
    return model->parameters.ground.stribeck_velocity > 0.0;
}

#endif
