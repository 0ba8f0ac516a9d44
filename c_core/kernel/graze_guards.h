/* The events of a foot that grazes: see model/graze.c. */
#ifndef TDMF_KERNEL_GRAZE_GUARDS_H
#define TDMF_KERNEL_GRAZE_GUARDS_H

#include "event_search.h"
#include "ground_step.h"

/* X/r^2: what a torque loads the foot with. */
static inline void expand_lever(const ground_series *g, int order, real lever[SERIES_TERMS]) {
    const real inverse_square = 1.0 / g->square[0];
    lever[0] = g->x[0] * inverse_square;
    for (int k = 1; k <= order; ++k) {
        real rest = g->x[k];
        for (int i = 0; i < k; ++i) {
            rest -= lever[i] * g->square[k - i];
        }
        lever[k] = rest * inverse_square;
    }
}

static inline void expand_servo(const hip_law *servo, const ground_series *g, real angle, int order,
                                real torque[SERIES_TERMS]) {
    torque[0] = servo->gain * (servo->target - angle) - servo->rate_gain * g->angle_rate[0] + servo->torque;
    for (int k = 1; k <= order; ++k) {
        torque[k] = (k == 1 ? servo->torque_rate : real_of(0.0)) - servo->rate_gain * g->angle_rate[k] -
                    servo->gain * g->angle_rate[k - 1] * series_reciprocal[k];
    }
}

/* Has steps end where the clamp opens or closes, and closes it where it is closed now. */
static inline void clamp_servo(event_search *search, const ground_constants *c, choice retracts, int order,
                               real torque[SERIES_TERMS]) {
    const real zero = TDMF_ZERO_CLAMP_ARGUMENT * c->mode.energy_scale;
    const real leading = pick(real_abs(torque[0]) > zero, torque[0], torque[1]);
    const real sign = pick(leading < 0.0, real_of(-1.0), real_of(1.0));
    const guard_series argument = {torque, sign, sign * torque[0], order};
    watch(search, KINK, retracts, &argument, -2.0 * zero);
    const choice closed = retracts & not(leading > 0.0);
    for (int k = 0; k <= order; ++k) {
        torque[k] = pick(closed, real_of(0.0), torque[k]);
    }
}

/* Ground force, times `sign`, under the torque of a law that graze excludes. */
static inline void watch_normal_force(event_search *search, const ground_constants *c, const ground_series *g,
                                      double sign, const real *torque, const real *lever) {
    const int order = search->order - 1;
    const real start = sign * (g->axial_y[0] + torque[0] * lever[0] + c->law.foot_weight_y);
    real force[SERIES_TERMS];
    for (int k = 1; k <= order; ++k) {
        real sum = g->axial_y[k];
        for (int i = 0; i <= k; ++i) {
            sum += torque[i] * lever[k - i];
        }
        force[k] = sign * sum;
    }
    const guard_series guard = {force, real_of(1.0), start, order};
    watch(search, sign > 0.0 ? TDMF_GUARD_GRAZE_TO_FLIGHT : TDMF_GUARD_GRAZE_TO_CONTACT, search->live, &guard,
          search->beyond_margin * c->mode.force_scale);
}

/* The vertical velocity of the centre of mass. */
static inline void watch_apex_in_graze(event_search *search, const ground_constants *c,
                                       const ground_series *g, choice retracts) {
    const real share = c->retracting_share, sine = c->slope_sine;
    const real along = share * sine, off = share * c->slope_cosine;
    const int order = search->order;
    real rise[SERIES_TERMS];
    guard_series velocity = {g->vy, share, share * g->vy[0], order};
    if (any(not(sine == 0.0))) {
        for (int k = 1; k <= order; ++k) {
            rise[k] = off * g->vy[k] + along * g->vx[k] + sine * g->foot_vx[k];
        }
        const real start = off * g->vy[0] + along * g->vx[0] + sine * g->foot_vx[0];
        const guard_series on_slope = {rise, real_of(1.0), start, order};
        velocity = on_slope;
    }
    watch(search, TDMF_GUARD_APEX, retracts, &velocity, search->beyond_margin * c->mode.speed_scale);
}

static inline void watch_graze(event_search *search, const ground_constants *c, const ground_series *g,
                               real angle) {
    const int order = search->order - 1;
    const choice retracts = c->retracting_share > 0.0;
    real lever[SERIES_TERMS], flight[SERIES_TERMS], stance[SERIES_TERMS];
    watch_apex_in_graze(search, c, g, retracts);
    expand_servo(&c->servo, g, angle, order, flight);
    clamp_servo(search, c, retracts, order, flight);
    flight[0] += c->law.torque;
    flight[1] += c->law.torque_rate;
    for (int k = 0; k <= order; ++k) {
        stance[k] = real_of(0.0);
    }
    stance[0] = c->stance.torque;
    stance[1] = c->stance.torque_rate;
    expand_lever(g, order, lever);
    watch_normal_force(search, c, g, -1.0, stance, lever);
    watch_normal_force(search, c, g, 1.0, flight, lever);
}

#endif
