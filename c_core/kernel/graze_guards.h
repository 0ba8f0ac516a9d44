/* The events of a foot that grazes: see model/graze.c. */
#ifndef TDMF_KERNEL_GRAZE_GUARDS_H
#define TDMF_KERNEL_GRAZE_GUARDS_H

#include "event_search.h"
#include "ground_step.h"
#include "guard_series.h"

/* Integrates the rate of theta. */
static inline void integrate_angle(const ground_series *g, real angle, int order, real series[SERIES_TERMS]) {
    series[0] = angle;
    for (int k = 1; k <= order; ++k) {
        series[k] = g->angle_rate[k - 1] * series_reciprocal[k];
    }
}

/* Ends the step where the clamp switches, and zeroes the torque in lanes that are already clamped. */
static inline void clamp_servo(event_search *search, const ground_constants *c, mask clamped, int order,
                               real torque[SERIES_TERMS]) {
    const real zero = TDMF_ZERO_CLAMP_ARGUMENT * c->mode.energy_scale;
    const real leading = select(real_abs(torque[0]) > zero, torque[0], torque[1]);
    const real sign = select(leading < 0.0, broadcast(-1.0), broadcast(1.0));
    const guard_series argument = {torque, sign, sign * torque[0], order};
    watch(search, KINK, clamped, &argument, -2.0 * zero);
    const mask closed = clamped & mask_not(leading > 0.0);
    for (int k = 0; k <= order; ++k) {
        torque[k] = select(closed, broadcast(0.0), torque[k]);
    }
}

/* Ground force, times `sign`, under the torque of a law that graze excludes. */
static inline void watch_normal_force(event_search *search, const ground_constants *c, const ground_series *g,
                                      double sign, const real *torque, const real *lever) {
    const int order = search->order - 1;
    real load[SERIES_TERMS];
    expand_load(g->axial_y, torque, lever, c->law.foot_weight_y, order, load);
    const guard_series guard = {load, broadcast(sign), sign * load[0], order};
    watch(search, sign > 0.0 ? TDMF_GUARD_GRAZE_TO_FLIGHT : TDMF_GUARD_GRAZE_TO_CONTACT, search->live, &guard,
          search->beyond_margin * c->mode.force_scale);
}

/* The vertical velocity of the centre of mass. */
static inline void watch_apex_in_graze(event_search *search, const ground_constants *c,
                                       const ground_series *g, mask retracts) {
    const real share = c->retracting_share;
    const int order = search->order;
    real rise[SERIES_TERMS];
    guard_series velocity = {g->vy, share, share * g->vy[0], order};
    if (any(mask_not(c->slope_sine == 0.0))) {
        expand_rise(g->vx, g->vy, g->foot_vx, c->slope_sine, c->slope_cosine, share, order, rise);
        const guard_series on_slope = {rise, broadcast(1.0), rise[0], order};
        velocity = on_slope;
    }
    watch(search, TDMF_GUARD_APEX, retracts, &velocity, search->beyond_margin * c->mode.speed_scale);
}

static inline void watch_graze(event_search *search, const ground_constants *c, const ground_series *g,
                               real angle) {
    const int order = search->order - 1;
    const mask retracts = c->retracting_share > 0.0;
    const mask clamped = c->clamped > 0.0;
    real angles[SERIES_TERMS], lever[SERIES_TERMS], flight[SERIES_TERMS], stance[SERIES_TERMS];
    watch_apex_in_graze(search, c, g, retracts);
    integrate_angle(g, angle, order, angles);
    expand_torque(&c->servo, angles, g->angle_rate, order, flight);
    if (any(clamped)) {
        clamp_servo(search, c, clamped, order, flight);
    }
    flight[0] += c->law.torque;
    flight[1] += c->law.torque_rate;
    for (int k = 0; k <= order; ++k) {
        stance[k] = broadcast(0.0);
    }
    stance[0] = c->stance.torque;
    stance[1] = c->stance.torque_rate;
    expand_lever(g->x, g->square, order, lever);
    watch_normal_force(search, c, g, -1.0, stance, lever);
    watch_normal_force(search, c, g, 1.0, flight, lever);
}

#endif
