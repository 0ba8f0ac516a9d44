/* Derived from c_core/equations/flight.py and ground.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_MOTION_ENDS_H
#define TDMF_DERIVED_MOTION_ENDS_H

#include "motion_series.h"
#include "step_sums.h"

/* The leg where a motion leads, its turning by the momentum, which is known to one order more. */
static inline void end_flight(const flight_series *s, const elapsed_time *elapsed, int order,
                              flight_start *at) {
    const real length = value_at(s->length, elapsed, order);
    const real angle = value_at(s->angle, elapsed, order);
    const real length_rate = value_at(s->length_rate, elapsed, order);
    const real momentum = value_at(s->momentum, elapsed, order);
    at->length = length;
    at->angle = angle;
    at->length_rate = length_rate;
    at->angle_rate = momentum / (length * length);
}

/* Where a motion leads: the body's place as seen from the foot, its velocity, and the foot's. */
static inline void end_stick(const ground_series *s, const elapsed_time *elapsed, int order,
                             ground_start *at) {
    const real x = value_at(s->x, elapsed, order);
    const real y = value_at(s->y, elapsed, order);
    const real vx = value_at(s->vx, elapsed, order);
    const real vy = value_at(s->vy, elapsed, order);
    at->x = x;
    at->y = y;
    at->vx = vx;
    at->vy = vy;
    at->foot_vx = broadcast(0.0);
}

/* Where a motion leads: the body's place as seen from the foot, its velocity, and the foot's. */
static inline void end_ground(const ground_series *s, const elapsed_time *elapsed, int order,
                              ground_start *at) {
    const real x = value_at(s->x, elapsed, order);
    const real y = value_at(s->y, elapsed, order);
    const real vx = value_at(s->vx, elapsed, order);
    const real foot_vx = value_at(s->foot_vx, elapsed, order);
    const real vy = value_at(s->vy, elapsed, order);
    at->x = x;
    at->y = y;
    at->vx = vx + foot_vx;
    at->vy = vy;
    at->foot_vx = foot_vx;
}

#endif
