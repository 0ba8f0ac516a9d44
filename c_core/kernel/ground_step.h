/* A step on the ground: its size, and where it leads. */
#ifndef TDMF_KERNEL_GROUND_STEP_H
#define TDMF_KERNEL_GROUND_STEP_H

#include "friction_layer.h"
#include "guard_series.h"
#include "mode_constants.h"
#include "motion_ends.h"
#include "step_size.h"
#include "step_sums.h"

typedef struct {
    ground_start at;
    real foot_x; /* along the line */
    real angle;  /* graze: theta */
    energy_sums done;
} ground_coordinates;

/* What a foot meets at the border of a patch. */
typedef struct {
    real ahead;         /* slip: where it is along the line */
    friction_cone cone; /* at rest on it: of the edge to slip backward */
} patch_border;

typedef struct {
    mode_constants mode;
    friction_cone cone;
    real slip_sign;                /* of u */
    real drives;                   /* above 0 until mid-stance */
    real awaits_thrust;            /* above 0 until the leg's greatest compression */
    real slope_sine, slope_cosine; /* of the line */
    ground_coefficients law;       /* its rates come last */
    /* Graze: the laws that the torque lies between, of which `law` has the torque from outside, and the share
     * of the body in the mass while retracting, else 0. */
    signed_law servo, stance;
    real clamped; /* above 0 where the servo's torque is clamped */
    real retracting_share;
    patch_border border;
} ground_constants;

static inline bool foot_is_free(ground_case is) {
    return is.slips || is.grazes;
}

/* Expands the motion and returns how far it may be trusted; `longest` is what its law allows. The layer is
 * that of a friction that falls with speed, if it does, and `in_layer` tells whether that is what allows no
 * more. */
static inline real expand_ground_step(const ground_constants *c, const friction_layer *layer,
                                      const ground_coordinates *at, ground_case is, int order,
                                      double tolerance, ground_series *g, real *longest, mask *in_layer) {
    series_remainder remainder = {broadcast(0.0), broadcast(0.0)};
    expand_ground(&c->law, &at->at, order, is, g);
    add_to_remainder(&remainder, g->normal_force, order - 1, c->mode.force_scale);
    add_to_remainder(&remainder, g->tangential_push, order - 1, c->mode.force_scale);
    add_to_remainder(&remainder, g->foot_vx, order - 1,
                     is.falls ? real_min(c->mode.speed_scale, layer->velocity) : c->mode.speed_scale);
    *longest = longest_ground_step(&c->law, foot_is_free(is), order);
    const real size = size_for_loss(
        g->speed_square, c->mode.energy_scale / (c->mode.damping * c->mode.time_scale),
        trusted_size(&remainder, *longest, order - 1, broadcast(tolerance)), order - 1, tolerance);
    const real allowed = is.falls ? size_by_layer(layer, c->slip_sign, g, size, order) : size;
    *in_layer = allowed < size;
    return allowed;
}

/* The hip's work since the start of the step. */
static inline real ground_work(const ground_series *g, ground_case is, int order,
                               const elapsed_time *elapsed) {
    return is.has_torque ? integral_to(g->power, elapsed, order - 1) : broadcast(0.0);
}

/* Goes on to a time within the step. */
static inline void stand_on(const ground_constants *c, const ground_series *g, ground_case is, int order,
                            const elapsed_time *elapsed, ground_coordinates *at) {
    at->done.work += ground_work(g, is, order, elapsed);
    at->done.damper_loss += c->mode.damping * integral_to(g->speed_square, elapsed, order - 1);
    if (is.slips) {
        at->done.friction_loss += integral_to(g->friction_power, elapsed, order - 1);
    }
    if (is.grazes) {
        at->angle += integral_to(g->angle_rate, elapsed, order - 1);
    }
    if (foot_is_free(is)) {
        at->foot_x += integral_to(g->foot_vx, elapsed, order);
    }
    at->at = tdmf_end_ground(g, elapsed, order, !foot_is_free(is));
}

#endif
