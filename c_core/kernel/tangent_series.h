/* Series of first variations along a step. */
#ifndef TDMF_KERNEL_TANGENT_SERIES_H
#define TDMF_KERNEL_TANGENT_SERIES_H

#include "step.h"

typedef struct {
    double length[SERIES_TERMS], length_rate[SERIES_TERMS], angle[SERIES_TERMS], momentum[SERIES_TERMS],
        angle_rate[SERIES_TERMS], power[SERIES_TERMS];
} flight_tangent;

typedef struct {
    double x[SERIES_TERMS], y[SERIES_TERMS], vx[SERIES_TERMS], vy[SERIES_TERMS], foot_vx[SERIES_TERMS],
        length[SERIES_TERMS], square[SERIES_TERMS], normal_force[SERIES_TERMS], leg_force_x[SERIES_TERMS],
        axial_y[SERIES_TERMS], angle_rate[SERIES_TERMS], power[SERIES_TERMS];
} ground_tangent;

typedef union {
    flight_tangent flight;
    ground_tangent ground;
} tdmf_tangent_series;

/* `change` is that of the coefficients, `start` that of the coordinates. */
void tdmf_expand_flight_tangent(const tdmf_step *step, const flight_coefficients *change,
                                const tdmf_coordinates *start, flight_tangent *tangent);
void tdmf_expand_ground_tangent(const tdmf_step *step, const ground_coefficients *change,
                                const tdmf_coordinates *start, ground_tangent *tangent);

#endif
