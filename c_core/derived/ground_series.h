/* Derived from c_core/equations/ground.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GROUND_SERIES_H
#define TDMF_DERIVED_GROUND_SERIES_H

#include "series_products.h"

/* What the motions depend on, and its rates where it changes in time. */
typedef struct {
    real stiffness;
    real damping;
    real inverse_body_mass;
    real inverse_foot_mass;
    real foot_weight_x;
    real foot_weight_y;
    real excess;
    real fading;
    real rest_length;
    real gravity_x;
    real gravity_y;
    real friction;
    real torque;
    real rest_length_rate;
    real gravity_x_rate;
    real gravity_y_rate;
    real friction_rate;
    real torque_rate;
} ground_coefficients;

/* Series of the states and of what is made of them, up to the order or one less. */
typedef struct {
    real length[SERIES_TERMS];
    real length_rate[SERIES_TERMS];
    real normal_force[SERIES_TERMS];
    real tangential_push[SERIES_TERMS];
    real along[SERIES_TERMS];
    real off[SERIES_TERMS];
    real torque[SERIES_TERMS];
    real power[SERIES_TERMS];
    real speed_square[SERIES_TERMS];
    real square[SERIES_TERMS];
    real turning[SERIES_TERMS];
    real vx[SERIES_TERMS];
    real vy[SERIES_TERMS];
    real x[SERIES_TERMS];
    real y[SERIES_TERMS];
    real foot_vx[SERIES_TERMS];
    real moment[SERIES_TERMS];
    real axial[SERIES_TERMS];
    real friction_power[SERIES_TERMS];
    real foot_acceleration[SERIES_TERMS];
    real friction_force[SERIES_TERMS];
    real exponent[SERIES_TERMS];
    real decay[SERIES_TERMS];
    real share[SERIES_TERMS];
    real coefficient[SERIES_TERMS];
    real angle_rate[SERIES_TERMS];
    real axial_y[SERIES_TERMS];
} ground_series;

/* The first variations of some. */
typedef struct {
    real torque[SERIES_TERMS];
    real power[SERIES_TERMS];
    real friction_power[SERIES_TERMS];
    real vx[SERIES_TERMS];
    real vy[SERIES_TERMS];
    real x[SERIES_TERMS];
    real y[SERIES_TERMS];
    real foot_vx[SERIES_TERMS];
    real moment[SERIES_TERMS];
    real length[SERIES_TERMS];
    real axial[SERIES_TERMS];
    real square[SERIES_TERMS];
    real turning[SERIES_TERMS];
    real normal_force[SERIES_TERMS];
    real foot_acceleration[SERIES_TERMS];
    real friction_force[SERIES_TERMS];
    real exponent[SERIES_TERMS];
    real share[SERIES_TERMS];
    real coefficient[SERIES_TERMS];
} ground_variation;

/* What a motion starts with. */
typedef struct {
    real x;
    real y;
    real vx;
    real vy;
    real foot_vx;
} ground_start;

/* The states, where (vx, vy) is the body's velocity, not seen from the foot. */
static inline void tdmf_begin_ground(const ground_start *start, ground_series *written) {
    const real away = start->vx - start->foot_vx;
    written->x[0] = start->x;
    written->y[0] = start->y;
    written->vx[0] = away;
    written->vy[0] = start->vy;
    written->foot_vx[0] = start->foot_vx;
    written->moment[0] = start->x * start->vy - start->y * away;
}

/* Its change. */
static inline void tdmf_vary_begin_ground(const ground_start *start, const ground_start *d_start,
                                          ground_variation *written) {
    const real d_away = d_start->vx - d_start->foot_vx;
    const real away = start->vx - start->foot_vx;
    written->x[0] = d_start->x;
    written->y[0] = d_start->y;
    written->vx[0] = d_away;
    written->vy[0] = d_start->vy;
    written->foot_vx[0] = d_start->foot_vx;
    written->moment[0] =
        d_start->x * start->vy + start->x * d_start->vy - (d_start->y * away + start->y * d_away);
}

/* The highest rate at which the leg springs back or comes to rest. */
static inline real tdmf_fastest_ground(const ground_coefficients *c, bool foot_is_free) {
    if (foot_is_free) {
        const real inverse_mass = c->inverse_body_mass + c->inverse_foot_mass;
        return real_max(real_sqrt(inverse_mass * c->stiffness), inverse_mass * c->damping);
    }
    return real_max(real_sqrt(c->inverse_body_mass * c->stiffness), c->inverse_body_mass * c->damping);
}

#endif
