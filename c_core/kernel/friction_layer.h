/* How long a step may be where friction falls with speed.
 *
 * Within some v_s of rest the foot is in a layer in which slip grows by itself, at up to
 * kappa = mu (rho - 1) f_n/(m_f v_s). Far above it the friction's excess is below rounding, and no
 * coefficient tells of the layer ahead: a step that was as long as they allow would jump over it, and find
 * the motion of v_s = 0. So a step ends before the layer, or changes the speed by a few v_s only, and lasts
 * but a few 1/kappa; there the coefficients tell the rest. */
#ifndef TDMF_KERNEL_FRICTION_LAYER_H
#define TDMF_KERNEL_FRICTION_LAYER_H

#include "margins.h"
#include "motion_series.h"
#include "powers.h"
#include "step_size.h"

typedef struct {
    real velocity;    /* v_s */
    real growth_rate; /* kappa/f_n */
} friction_layer;

/* The size of a step that its series may be trusted for, or less. */
static inline real size_by_layer(const friction_layer *layer, real slip_sign, const ground_series *g,
                                 real size, int order) {
    const real few = TDMF_CHANGE_IN_LAYER * layer->velocity;
    const real beyond = slip_sign * g->foot_vx[0] - TDMF_LAYER_WIDTH * layer->velocity;
    const real maximum = real_max(beyond, few);
    real power[SERIES_TERMS];
    set_powers(power, size, order);
    const real change = largest_change(g->foot_vx, power, order);
    size = select(change > maximum, size * maximum / change, size);
    set_powers(power, size, order);
    const real force = real_abs(g->normal_force[0]) + largest_change(g->normal_force, power, order - 1);
    const real growth = size * layer->growth_rate * force;
    const mask too_long = (beyond < few) & (growth > TDMF_GROWTH_IN_LAYER);
    return select(too_long, size * TDMF_GROWTH_IN_LAYER / growth, size);
}

#endif
