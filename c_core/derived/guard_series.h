/* Derived from c_core/equations/ground.py, flight.py, friction.py and hip.py by equations/derive: edit that,
 * not this. */
#ifndef TDMF_DERIVED_GUARD_SERIES_H
#define TDMF_DERIVED_GUARD_SERIES_H

#include "series_products.h"

/* The law times a sign, as guards have it while it drifts: its target stays, its torque moves. */
typedef struct {
    real gain;
    real rate_gain;
    real target;
    real torque;
    real torque_rate;
} signed_law;

/* The weights of f_n, of what drifts with it and of |f_t| in the room of a cone, by its largest width.
 *
 * Its friction, rho mu, drifts at a rate for a time. */
typedef struct {
    real normal;
    real normal_rate;
    real tangential;
} friction_cone;

/* r sin theta, how far the foot is ahead of the body: it falls through 0 with theta. */
static inline void expand_ahead(const real *x, const real *y, real slope_sine, real slope_cosine, int order,
                                real ahead[SERIES_TERMS]) {
    int k = 0;
    do {
        ahead[k] = slope_sine * y[k] - slope_cosine * x[k];
    } while (++k <= order);
}

/* rho mu f_n + s f_t, by the cone's width: what is left up to its edge on the side s (2). */
static inline void expand_room(const real *normal_force, const real *tangential_push,
                               const friction_cone *cone, real sign, int order, real room[SERIES_TERMS]) {
    int k = 0;
    do {
        room[k] = drift_times(k, cone->normal, cone->normal_rate, normal_force) -
                  sign * cone->tangential * tangential_push[k];
    } while (++k <= order);
}

/* The rate at which the centre of mass rises, with the body's share of the mass. */
static inline void expand_rise(const real *vx, const real *vy, const real *foot_vx, real slope_sine,
                               real slope_cosine, real share, int order, real rise[SERIES_TERMS]) {
    int k = 0;
    do {
        rise[k] = share * slope_cosine * vy[k] + share * slope_sine * vx[k] + slope_sine * foot_vx[k];
    } while (++k <= order);
}

/* X/r^2: what a torque loads the foot with. */
static inline void expand_lever(const real *x, const real *square, int order, real lever[SERIES_TERMS]) {
    int k = 0;
    do {
        lever[k] = (x[k] - product_so_far(lever, square, k)) / square[0];
    } while (++k <= order);
}

/* f_n under a torque (10), on whose foot none acts. */
static inline void expand_load(const real *axial_y, const real *torque, const real *lever, real weight_y,
                               int order, real load[SERIES_TERMS]) {
    int k = 0;
    do {
        load[k] = with_constant(k, axial_y[k] + product(torque, lever, k), weight_y);
    } while (++k <= order);
}

/* gain (target - theta) - rate_gain thetadot + torque, now. */
static inline void expand_torque(const signed_law *law, const real *angle, const real *angle_rate, int order,
                                 real torque[SERIES_TERMS]) {
    int k = 0;
    do {
        torque[k] = with_drift(k, -(law->gain * angle[k]) - law->rate_gain * angle_rate[k],
                               law->gain * law->target + law->torque, law->torque_rate);
    } while (++k <= order);
}

/* r cos(theta - sigma), which the body is above the foot over a ground of that slope. */
static inline void expand_drop(const real *length, const real *angle, real slope, const real *angle_rate,
                               int order, real drop[SERIES_TERMS]) {
    real seen[SERIES_TERMS];
    real cos_of_seen[SERIES_TERMS];
    real sin_of_seen[SERIES_TERMS];
    int k = 0;
    do {
        seen[k] = with_constant(k, angle[k], -slope);
        sine_and_cosine_term(k, seen, angle_rate, sin_of_seen, cos_of_seen);
    } while (++k <= order);
    all_products(length, cos_of_seen, order, drop);
}

/* rho mu f_n - |f_t|, by the cone's width: what is left up to its nearer edge; `drifted` is t f_n. */
static inline real tdmf_smallest_room(const friction_cone *cone, real normal, real drifted, real tangential) {
    return cone->normal * normal + cone->normal_rate * drifted - cone->tangential * real_abs(tangential);
}

#endif
