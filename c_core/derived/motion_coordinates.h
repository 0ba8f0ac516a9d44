/* Derived from c_core/equations/flight.py and ground.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_MOTION_COORDINATES_H
#define TDMF_DERIVED_MOTION_COORDINATES_H

#include "coordinate_laws.h"
#include "motion_series.h"
#include "series_sums.h"

/* What a motion starts with, of the model's coordinates, and back. */
static inline flight_start flight_start_of(const tdmf_flying *at) {
    const flight_start start = {at->length, at->angle, at->length_rate, at->angle_rate};
    return start;
}

static inline void set_flight(const flight_start *start, tdmf_flying *at) {
    at->length = start->length;
    at->angle = start->angle;
    at->length_rate = start->length_rate;
    at->angle_rate = start->angle_rate;
}

/* Its change, at a time. */
static inline void vary_end_flight(const flight_series *s, const flight_variation *t, int order, double time,
                                   flight_start *d_at) {
    const double d_length = series_at(t->length, order, time);
    const double d_angle = series_at(t->angle, order, time);
    const double d_length_rate = series_at(t->length_rate, order, time);
    const double d_momentum = series_at(t->momentum, order, time);
    const double momentum = series_at(s->momentum, order, time);
    const double length = series_at(s->length, order, time);
    d_at->length = d_length;
    d_at->angle = d_angle;
    d_at->length_rate = d_length_rate;
    d_at->angle_rate =
        (d_momentum - momentum / (length * length) * (2.0 * (length * d_length))) / (length * length);
}

/* What a motion starts with, of the model's coordinates, and back. */
static inline ground_start ground_start_of(const tdmf_standing *at) {
    const ground_start start = {at->x, at->y, at->vx, at->vy, at->foot_vx};
    return start;
}

static inline void set_ground(const ground_start *start, tdmf_standing *at) {
    at->x = start->x;
    at->y = start->y;
    at->vx = start->vx;
    at->vy = start->vy;
    at->foot_vx = start->foot_vx;
}

/* Its change, at a time. */
static inline void vary_end_stick(const ground_series *s, const ground_variation *t, int order, double time,
                                  ground_start *d_at) {
    (void)s;
    const double d_x = series_at(t->x, order, time);
    const double d_y = series_at(t->y, order, time);
    const double d_vx = series_at(t->vx, order, time);
    const double d_vy = series_at(t->vy, order, time);
    d_at->x = d_x;
    d_at->y = d_y;
    d_at->vx = d_vx;
    d_at->vy = d_vy;
    d_at->foot_vx = 0.0;
}

/* Its change, at a time. */
static inline void vary_end_ground(const ground_series *s, const ground_variation *t, int order, double time,
                                   ground_start *d_at) {
    (void)s;
    const double d_x = series_at(t->x, order, time);
    const double d_y = series_at(t->y, order, time);
    const double d_vx = series_at(t->vx, order, time);
    const double d_foot_vx = series_at(t->foot_vx, order, time);
    const double d_vy = series_at(t->vy, order, time);
    d_at->x = d_x;
    d_at->y = d_y;
    d_at->vx = d_vx + d_foot_vx;
    d_at->vy = d_vy;
    d_at->foot_vx = d_foot_vx;
}

#endif
