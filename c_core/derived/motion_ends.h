/* Derived from c_core/equations/flight.py and ground.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_MOTION_ENDS_H
#define TDMF_DERIVED_MOTION_ENDS_H

#include "motion_series.h"
#include "series_products.h"
#include "step_sums.h"

/* The leg where a motion leads, its turning by the momentum, which is known to one order more. */
static inline flight_start tdmf_end_flight(const flight_series *s, const elapsed_time *elapsed, int order) {
    const real length = value_at(s->length, elapsed, order);
    const real momentum = value_at(s->momentum, elapsed, order);
    const flight_start result = {
        .length = length,
        .angle = value_at(s->angle, elapsed, order),
        .length_rate = value_at(s->length_rate, elapsed, order),
        .angle_rate = momentum / (length * length),
    };
    return result;
}

/* Its change. */
static inline flight_start tdmf_vary_end_flight(const flight_series *s, const elapsed_time *elapsed,
                                                int order, const flight_variation *d_s) {
    const real d_length = value_at(d_s->length, elapsed, order);
    const real d_momentum = value_at(d_s->momentum, elapsed, order);
    const real momentum = value_at(s->momentum, elapsed, order);
    const real length = value_at(s->length, elapsed, order);
    const real angle_rate = momentum / (length * length);
    const flight_start result = {
        .length = d_length,
        .angle = value_at(d_s->angle, elapsed, order),
        .length_rate = value_at(d_s->length_rate, elapsed, order),
        .angle_rate = (d_momentum - angle_rate * (2.0 * (length * d_length))) / (length * length),
    };
    return result;
}

/* Where a motion leads: the body's place as seen from the foot, its velocity, and the foot's. */
static inline ground_start tdmf_end_ground(const ground_series *s, const elapsed_time *elapsed, int order,
                                           bool sticks) {
    if (sticks) {
        const ground_start result = {
            .x = value_at(s->x, elapsed, order),
            .y = value_at(s->y, elapsed, order),
            .vx = value_at(s->vx, elapsed, order),
            .vy = value_at(s->vy, elapsed, order),
        };
        return result;
    }
    const real vx = value_at(s->vx, elapsed, order);
    const real foot_vx = value_at(s->foot_vx, elapsed, order);
    const ground_start result = {
        .x = value_at(s->x, elapsed, order),
        .y = value_at(s->y, elapsed, order),
        .vx = vx + foot_vx,
        .vy = value_at(s->vy, elapsed, order),
        .foot_vx = foot_vx,
    };
    return result;
}

/* Its change. */
static inline ground_start tdmf_vary_end_ground(const ground_series *s, const elapsed_time *elapsed,
                                                int order, bool sticks, const ground_variation *d_s) {
    (void)s;
    if (sticks) {
        const ground_start result = {
            .x = value_at(d_s->x, elapsed, order),
            .y = value_at(d_s->y, elapsed, order),
            .vx = value_at(d_s->vx, elapsed, order),
            .vy = value_at(d_s->vy, elapsed, order),
        };
        return result;
    }
    const real d_vx = value_at(d_s->vx, elapsed, order);
    const real d_foot_vx = value_at(d_s->foot_vx, elapsed, order);
    const ground_start result = {
        .x = value_at(d_s->x, elapsed, order),
        .y = value_at(d_s->y, elapsed, order),
        .vx = d_vx + d_foot_vx,
        .vy = value_at(d_s->vy, elapsed, order),
        .foot_vx = d_foot_vx,
    };
    return result;
}

/* The hip's torque along a motion. */
static inline void expand_hip_torque(const flight_coefficients *c, const real *angle, const real *angle_rate,
                                     int order, real hip_torque[SERIES_TERMS]) {
    int k = 0;
    do {
        hip_torque[k] = with_drift(k, -(c->gain * angle[k]) - c->rate_gain * angle_rate[k],
                                   c->gain * c->target + c->torque, c->torque_rate);
    } while (++k <= order);
}

/* The hip's work while the leg turns, of a torque that is affine in angle, rate and time.
 *
 * The integral of t w is taken by parts. */
static inline real tdmf_flight_work(const flight_coefficients *c, const flight_series *s,
                                    const elapsed_time *elapsed, int order, real turned) {
    const real by_angle = turned * (c->gain * (c->target - s->angle[0] - 0.5 * turned) + c->torque);
    const real damped = (any(mask_not(-c->rate_gain == 0.0))
                             ? by_angle + -c->rate_gain * (integral_to(s->rate_square, elapsed, order - 1))
                             : by_angle);
    return (any(mask_not(c->torque_rate == 0.0))
                ? damped + c->torque_rate * (elapsed->power[1] * (s->angle[0] + turned) -
                                             integral_to(s->angle, elapsed, order))
                : damped);
}

#endif
