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

/* mu below a foot at x that moves or is pushed to the side of a sign, and its change. */
static inline double tdmf_friction_towards(tdmf_system system, double x, double direction) {
    return tdmf_friction_below(system.model, system.inputs, tdmf_zone_towards(system.model, x, direction));
}

static inline double tdmf_vary_friction_towards(tdmf_system system, double x, double direction,
                                                const tdmf_local_seed *d) {
    return tdmf_vary_friction_below(system.model, system.inputs,
                                    tdmf_zone_towards(system.model, x, direction), &d->model, &d->inputs);
}

/* mu with the sign of the foot's velocity: f_x is minus this by f_y. Zero where the foot does not slip. */
static inline double tdmf_signed_friction(tdmf_system system, const tdmf_mode *mode) {
    return tdmf_sliding_friction(tdmf_friction_below(system.model, system.inputs, mode->zone),
                                 tdmf_sign_of_slip(mode));
}

static inline double tdmf_vary_signed_friction(tdmf_system system, const tdmf_mode *mode,
                                               tdmf_system d_system) {
    const double friction = tdmf_friction_below(system.model, system.inputs, mode->zone);
    return tdmf_vary_sliding_friction(
        friction, tdmf_sign_of_slip(mode),
        tdmf_vary_friction_below(system.model, system.inputs, mode->zone, d_system.model, d_system.inputs));
}

/* rho mu of a foot at rest at x that is pushed to the side of a sign, and its change. */
static inline double tdmf_static_friction_towards(tdmf_system system, double x, double direction) {
    return tdmf_static_friction(system.model, tdmf_friction_towards(system, x, direction));
}

static inline double tdmf_vary_static_friction_towards(tdmf_system system, double x, double direction,
                                                       tdmf_system d_system) {
    const tdmf_zone zone = tdmf_zone_towards(system.model, x, direction);
    return tdmf_vary_static_friction(
        system.model, tdmf_friction_below(system.model, system.inputs, zone), d_system.model,
        tdmf_vary_friction_below(system.model, system.inputs, zone, d_system.model, d_system.inputs));
}

#endif
