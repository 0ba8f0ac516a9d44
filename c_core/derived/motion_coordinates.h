/* Derived from c_core/equations/flight.py and ground.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_MOTION_COORDINATES_H
#define TDMF_DERIVED_MOTION_COORDINATES_H

#include "coordinate_laws.h"
#include "motion_series.h"

/* What a motion starts with, of the model's coordinates, or back. */
static inline flight_start tdmf_flight_start_of(const tdmf_flying *at) {
    const flight_start result = {
        .length = at->length,
        .angle = at->angle,
        .length_rate = at->length_rate,
        .angle_rate = at->angle_rate,
    };
    return result;
}

/* What a motion starts with, of the model's coordinates, or back. */
static inline void tdmf_set_flight(const flight_start *at, tdmf_flying *written) {
    written->length = at->length;
    written->angle = at->angle;
    written->length_rate = at->length_rate;
    written->angle_rate = at->angle_rate;
}

/* What a motion starts with, of the model's coordinates, or back. */
static inline ground_start tdmf_ground_start_of(const tdmf_standing *at) {
    const ground_start result = {
        .x = at->x,
        .y = at->y,
        .vx = at->vx,
        .vy = at->vy,
        .foot_vx = at->foot_vx,
    };
    return result;
}

/* What a motion starts with, of the model's coordinates, or back. */
static inline void tdmf_set_ground(const ground_start *at, tdmf_standing *written) {
    written->x = at->x;
    written->y = at->y;
    written->vx = at->vx;
    written->vy = at->vy;
    written->foot_vx = at->foot_vx;
}

#endif
