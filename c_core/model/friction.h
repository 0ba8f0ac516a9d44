/* Friction as modes have it; its law is in equations/friction.py. */
#ifndef TDMF_MODEL_FRICTION_H
#define TDMF_MODEL_FRICTION_H

#include "contact_mode.h"
#include "friction_laws.h"
#include "patch.h"
#include "seed.h"

/* Friction falls with the foot's speed. */
static inline bool tdmf_friction_falls(const tdmf_model *model) {
    return model->parameters.ground.stribeck_velocity > 0.0;
}

/* Towards v_s = 0 motions go as v_s ln(1/v_s): no derivative by v_s tells what begins there. */
static inline bool tdmf_friction_has_no_derivative(const tdmf_model *model, const tdmf_local_seed *d) {
    return !tdmf_friction_falls(model) && d->model.parameters.ground.stribeck_velocity != 0.0 &&
           model->parameters.ground.static_friction_ratio != 1.0;
}

#endif
